#include "sinew/sqm/cells/images.h"

#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

/// A body on the plane x = 0 with a limb on the right, which the mirror repeats, and one in the plane.
Document creature() {
    Document d;
    add(d, -1, {0, 0, 0}, 0.4);
    add(d, 0, {0, 3, 0.5}, 0.4);
    const std::int32_t elbow = add(d, 0, {2, 1, 0}, 0.3);
    add(d, elbow, {4, 0, 1}, 0.2);
    add(d, elbow, {4, 2, -1}, 0.2);
    return d;
}

/// Images are where the generator says, and applying it `order` times comes back.
void expect_images(const Plain& skeleton, std::int32_t order) {
    const Network n = find_network(skeleton);
    const Polyhedra p = make_polyhedra(skeleton, n).value();
    const Images images = find_images(skeleton, n, p);
    ASSERT_EQ(images.order, order);
    ASSERT_TRUE(images.any());
    const auto comes_back = [&](const std::vector<std::int32_t>& image) {
        for (std::size_t i = 0; i < image.size(); ++i) {
            std::int32_t at = static_cast<std::int32_t>(i);
            for (std::int32_t k = 0; k < order; ++k) at = image[at];
            EXPECT_EQ(at, std::int32_t(i));
        }
    };
    for (const auto* image : {&images.joint, &images.cell, &images.vertex, &images.arc, &images.path})
        comes_back(*image);
    for (std::int32_t c = 0; c < p.cell_count(); ++c)
        EXPECT_LT((images.generator * p.sites[c] - p.sites[images.cell[c]]).norm(), 1e-6);
    for (std::size_t v = 0; v < p.vertices.size(); ++v)
        EXPECT_LT((images.generator * p.vertices[v] - p.vertices[images.vertex[v]]).norm(), 1e-6);
    for (std::size_t a = 0; a < p.arcs.size(); ++a) {
        const CellArc &arc = p.arcs[a], &image = p.arcs[images.arc[a]];
        EXPECT_EQ(images.arc_reversed[a] ? image.to : image.from, images.vertex[arc.from]);
        const bool crossed = images.reverses != bool(images.arc_reversed[a]);
        EXPECT_EQ(crossed ? image.right : image.left, images.cell[arc.left]);
    }
    for (std::int32_t path = 0; path < n.path_count(); ++path) {
        const auto from = n.nodes(path), to = n.nodes(images.path[path]);
        EXPECT_EQ(images.path_reversed[path] ? to.back() : to.front(), skeleton.symmetry.image[from.front()]);
    }
}

TEST(Symmetry, OfAMirrorIsAReflection) { expect_images(expanded(mirrored(creature())), 2); }

TEST(Symmetry, OfAWheelTurnsRound) {
    for (const int count : {2, 3, 7}) expect_images(expanded(wheel(count)), count);
}

TEST(Symmetry, IsFoundInAGraphThatNobodySaidItOf) {
    const Plain skeleton = plain_of(cube_of_struts());
    EXPECT_EQ(skeleton.symmetry.order, 1);  // its corner is at the origin
    Document d = cube_of_struts();
    for (Node& node : d.nodes) node.position -= Vec3(2, 2, 2);
    expect_images(plain_of(d), 2);
}

TEST(Symmetry, IsNotSeenWhereThereIsNone) {
    Document d = creature();
    add(d, 0, {-2, 1, 0.001}, 0.3);
    const Plain skeleton = plain_of(d);
    const Network n = find_network(skeleton);
    EXPECT_FALSE(find_images(skeleton, n, make_polyhedra(skeleton, n).value()).any());
}

}  // namespace
}  // namespace sinew::sqm
