#include "sinew/render/render.h"
#include "sinew/sqm/skin.h"

/// The renderer links too; whether it can draw here is another question.
int main() {
    sinew::Document ball;
    ball.nodes.resize(1);
    const auto made = sinew::skin(ball);
    if (!made) return 1;
    const auto picture =
        sinew::render({.mesh = sinew::mesh_buffers(made->mesh)}, {.width = 32, .height = 32});
    return picture ? picture->width - 32 : picture.error().kind == sinew::ErrorKind::program ? 0 : 1;
}
