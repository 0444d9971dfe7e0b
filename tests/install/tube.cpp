#include <cstdio>

#include "sinew/io/mesh_formats.h"
#include "sinew/sqm/skin.h"

int main() {
    sinew::Document bone;
    bone.nodes = {{.id = 0, .position = {0, 0, 0}, .radius = 0.5},
                  {.id = 1, .parent = 0, .position = {0, 0, 2}, .radius = 0.3}};
    const auto made = sinew::skin(bone);
    if (made && sinew::write_mesh(made->mesh, "bone.obj"))
        std::printf("%zu vertices, %zu faces\n", made->mesh.vertex_count(), made->mesh.face_count());
}
