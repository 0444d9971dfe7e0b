#include "document/pick.h"

#include <gmock/gmock.h>

#include "document/images.h"
#include "stage.h"

namespace sinew::modeler {
namespace {

using testing::ElementsAre;

NodeGlyph turned_unit(GlyphShape shape) {
    const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    return {shape, turn * Vec3(0.5, 1, 2).asDiagonal(), Vec3(0.3, -0.2, 0.1)};
}

/// True if a point of the unit shape's space is inside.
bool inside(GlyphShape shape, const Vec3& p) {
    switch (shape) {
        case GlyphShape::sphere:
            return p.norm() <= 1;
        case GlyphShape::half_sphere:
            return p.norm() <= 1 && p.z() <= 0;
        case GlyphShape::cone:
            return p.z() >= -2 && p.z() <= 0 && p.head<2>().norm() <= -p.z() / 2;
        default:
            return p.cwiseAbs().maxCoeff() <= 1;
    }
}

TEST(Glyph, a_ray_meets_a_shape_where_it_first_gets_inside) {
    for (GlyphShape shape :
         {GlyphShape::sphere, GlyphShape::half_sphere, GlyphShape::cone, GlyphShape::box}) {
        const NodeGlyph glyph = turned_unit(shape);
        int met = 0;
        for (int i = 0; i < 400; ++i) {
            const double a = i * 2.399963, h = 1 - (2 * i + 1) / 400.0, s = std::sqrt(1 - h * h);
            const Vec3 from = 9 * Vec3(s * std::cos(a), s * std::sin(a), h);
            const Vec3 towards = 0.6 * Vec3(std::sin(3.1 * i), std::cos(5.3 * i), std::sin(1.7 * i));
            const Ray ray{from, (towards - from).normalized()};
            std::optional<double> first;  // by small steps
            for (double t = 0; t < 18 && !first; t += 0.002)
                if (inside(shape, glyph.axes.inverse() * (ray.at(t) - glyph.centre))) first = t;
            const auto distance = meet(ray, glyph);
            if (!first) continue;
            ++met;
            ASSERT_TRUE(distance);
            EXPECT_NEAR(*distance, *first, 0.0021) << static_cast<int>(shape) << " ray " << i;
        }
        EXPECT_GT(met, 30);
        EXPECT_FALSE(meet({Vec3(9, 9, 9), Vec3(1, 0, 0)}, glyph));
    }
}

Document row_behind_each_other() {
    Document document = plain_document();
    for (int i = 0; i < 2; ++i)
        append_node(document, {.id = -1, .parent = i, .position = Vec3(0, 2.0 * i + 2, 0), .radius = 0.5});
    return document;
}

TEST(Pick, cycles_through_what_lies_under_the_pointer) {
    const Document document = row_behind_each_other();
    const auto hits = hits_at(document, glyphs_of(document, 1), front_screen(), pixel_of(0.1, 0.1));
    std::vector<std::int32_t> nodes;
    Hit hit;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        hit = behind(hits, hit);
        if (hit.kind == Hit::Kind::node) nodes.push_back(hit.index);
    }
    EXPECT_THAT(nodes, ElementsAre(0, 1, 2));
    EXPECT_TRUE(behind(hits, hit).same_thing(hits.front()));
}

TEST(Pick, the_whole_glyph_counts_and_nothing_beyond_it) {
    const Document document = plain_document();
    const Glyphing glyphs = glyphs_of(document, 1);
    EXPECT_TRUE(hit_at(document, glyphs, front_screen(), pixel_of(0.49, 0)));
    EXPECT_FALSE(hit_at(document, glyphs, front_screen(), pixel_of(0.52, 0)));
    EXPECT_FALSE(hit_at(document, glyphs_of(document, 0.5), front_screen(), pixel_of(0.3, 0)));
}

TEST(Pick, tiny_nodes_can_be_hit) {
    Document document = plain_document();
    document.nodes[0].radius = 1e-4;
    EXPECT_TRUE(hit_at(document, glyphs_of(document, 1), front_screen(), pixel_of(0.05, 0)));
    EXPECT_FALSE(hit_at(document, glyphs_of(document, 1), front_screen(), pixel_of(0.2, 0)));
}

TEST(Pick, bones_tell_where_they_were_hit) {
    Document document = plain_document();
    append_node(document, {.id = -1, .parent = 0, .position = Vec3(4, 0, 0), .radius = 0.5});
    const Hit hit = hit_at(document, glyphs_of(document, 1), front_screen(), pixel_of(1, 0));
    EXPECT_EQ(hit.kind, Hit::Kind::bone);
    EXPECT_EQ(hit.index, 0);
    EXPECT_NEAR(hit.along, 0.25, 1e-6);
}

TEST(Pick, images_are_hit_too_and_a_node_on_the_plane_once) {
    Document document = starting_document();
    append_node(document, {.id = -1, .parent = 0, .position = Vec3(2, 0, 0), .radius = 0.5});
    const Glyphing glyphs = glyphs_of(document, 1);
    const Hit hit = hit_at(document, glyphs, front_screen(), pixel_of(-2, 0));
    EXPECT_EQ(hit.index, 1);
    EXPECT_EQ(hit.image, 1);
    int times = 0;
    for (const Hit& other : hits_at(document, glyphs, front_screen(), pixel_of(0, 0.2)))
        times += other.kind == Hit::Kind::node;
    EXPECT_EQ(times, 1);
}

TEST(Pick, a_box_takes_centres_of_images_as_well) {
    Document document = starting_document();
    append_node(document, {.id = -1, .parent = 0, .position = Vec3(2, 0, 0), .radius = 0.5});
    EXPECT_THAT(nodes_in_box(document, front_screen(), pixel_of(1, 1), pixel_of(3, -1)).nodes,
                ElementsAre(1));
    EXPECT_THAT(nodes_in_box(document, front_screen(), pixel_of(-3, -1), pixel_of(-1, 1)).nodes,
                ElementsAre(1));
    EXPECT_THAT(nodes_in_box(document, front_screen(), pixel_of(-1, -1), pixel_of(3, 1)).nodes,
                ElementsAre(0, 1));
}

TEST(Images, are_as_many_as_the_symmetry_has_and_keep_what_lies_on_it) {
    const Symmetry radial{Symmetry::Kind::radial, 2, 8};
    const auto images = images_of(radial);
    ASSERT_EQ(images.size(), 8u);
    Vec3 sum = Vec3::Zero();
    for (const Mat3& image : images) {
        EXPECT_TRUE((image * Vec3(0, 0, 3)).isApprox(Vec3(0, 0, 3)));
        EXPECT_NEAR(image.determinant(), 1, 1e-12);
        sum += image * Vec3(1, 0, 0);
    }
    EXPECT_LT(sum.norm(), 1e-12);
    EXPECT_EQ(onto_symmetry(radial, Vec3(1, 2, 3)), Vec3(0, 0, 3));
    EXPECT_EQ(onto_symmetry({Symmetry::Kind::mirror, 1, 1}, Vec3(1, 2, 3)), Vec3(1, 0, 3));
    EXPECT_NEAR(images_of({Symmetry::Kind::mirror, 1, 1})[1].determinant(), -1, 1e-12);
}

}  // namespace
}  // namespace sinew::modeler
