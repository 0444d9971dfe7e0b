// What assimp, which nobody here wrote, reads back from the files is what was written.
#include <assimp/mesh.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <assimp/Importer.hpp>

#include "io/mesh_testing.h"
#include "sinew/io/mesh_formats.h"
#include "sinew/mesh/normals.h"
#include "sinew/mesh/triangulate.h"

namespace sinew {
namespace {

struct Case {
    const char* extension;
    FormatName format;
    bool ascii;
    bool polygons;
};

class ReadBack : public testing::TestWithParam<Case> {
  protected:
    static QuadMesh mesh() {
        QuadMesh mesh = shapes::together(shapes::tube(6, 7, 0.37, 2.1),
                                         shapes::moved(shapes::torus(5, 6), {9, 0.1f, -3}));
        mesh.positions[0] = {1e-7f, -1234.5677f, 3e8f};  // a small, a long and a large number
        return mesh;
    }
    /// Corner positions, face after face.
    static std::vector<Vec3f> soup(const QuadMesh& mesh) {
        std::vector<Vec3f> corners;
        for (const std::uint32_t v : mesh.corners) corners.push_back(mesh.positions[v]);
        return corners;
    }
    static QuadMesh triangles(const QuadMesh& mesh) {
        QuadMesh result;
        result.positions = mesh.positions;
        for (const Triangle& triangle : triangulate(mesh).triangles) result.add_face(triangle);
        return result;
    }
};

Vec3f vector_of(const aiVector3D& v) { return {v.x, v.y, v.z}; }

void expect_near(const Vec3f& read, const Vec3f& written) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(read[k], written[k], 1e-6 * std::abs(written[k]));
}

TEST_P(ReadBack, PositionsAndFaces) {
    const Case& c = GetParam();
    const QuadMesh written = c.polygons ? mesh() : triangles(mesh());
    const std::string bytes = *mesh_bytes(mesh(), c.format, {.ascii = c.ascii});
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, c.extension);
    ASSERT_TRUE(scene) << importer.GetErrorString();
    ASSERT_EQ(scene->mNumMeshes, 1u);
    const aiMesh& read = *scene->mMeshes[0];
    ASSERT_EQ(read.mNumFaces, written.face_count());
    for (std::size_t f = 0; f < written.face_count(); ++f) {
        const aiFace& face = read.mFaces[f];
        ASSERT_EQ(face.mNumIndices, written.face(f).size());
        std::vector<Vec3f> corners;
        for (const std::uint32_t v : written.face(f)) corners.push_back(written.positions[v]);
        // glTF's triangles may start with another corner.
        const Vec3f first = vector_of(read.mVertices[face.mIndices[0]]);
        const auto start =
            std::min_element(corners.begin(), corners.end(), [&](const Vec3f& a, const Vec3f& b) {
                return (a - first).squaredNorm() < (b - first).squaredNorm();
            });
        if (c.format == FormatName::glb || c.format == FormatName::gltf)
            std::rotate(corners.begin(), start, corners.end());
        for (unsigned i = 0; i < face.mNumIndices; ++i)
            expect_near(vector_of(read.mVertices[face.mIndices[i]]), corners[i]);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Formats, ReadBack,
    testing::Values(Case{"obj", FormatName::obj, false, true}, Case{"ply", FormatName::ply, true, true},
                    Case{"ply", FormatName::ply, false, true}, Case{"stl", FormatName::stl, false, false},
                    Case{"glb", FormatName::glb, false, false}, Case{"gltf", FormatName::gltf, false, false}),
    [](const auto& name) { return std::string(name.param.extension) + (name.param.ascii ? "_text" : ""); });

TEST(ReadBackGltf, NormalsPointOutwardsAndZIsUp) {
    const QuadMesh sphere = shapes::sphere(8);
    const std::string bytes = *mesh_bytes(sphere, FormatName::glb, {.metres_a_unit = 0.5});
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, "glb");
    ASSERT_TRUE(scene) << importer.GetErrorString();
    const aiMesh& read = *scene->mMeshes[0];
    ASSERT_EQ(read.mNumVertices, sphere.vertex_count());
    for (unsigned v = 0; v < read.mNumVertices; ++v)  // the neighbours lie on the sphere: normals are its own
        EXPECT_LT((vector_of(read.mNormals[v]) - sphere.positions[v]).norm(), 1e-6f);
    const aiNode* node = scene->mRootNode->mNumMeshes ? scene->mRootNode : scene->mRootNode->mChildren[0];
    const Vec3f up = vector_of(node->mTransformation * aiVector3D(0, 0, 1));
    EXPECT_LT((up - Vec3f(0, 0.5f, 0)).norm(), 1e-6f) << "glTF's y is up, and its unit the metre";
}

}  // namespace
}  // namespace sinew
