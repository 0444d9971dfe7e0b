#include "sinew/sqm/counts/regions.h"

#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

struct Divided {
    Network network;
    Regions regions;

    explicit Divided(const Document& document)
        : network(find_network(plain_of(document))), regions(find_regions(network)) {}
    std::ptrdiff_t core_paths() const {
        return std::count(regions.core.begin(), regions.core.end(), std::uint8_t{1});
    }
};

TEST(Regions, OfATreeHaveNoCore) {
    property::Random random(21);
    const Divided tree(random_tree(random, 4));
    EXPECT_EQ(tree.regions.components, 1);
    EXPECT_EQ(tree.core_paths(), 0);
}

TEST(Regions, HaveCyclesAndWhatLiesBetweenThemInTheCore) {
    // Two cubes of struts (12 paths each), a strut between them, and a fork that hangs off the second.
    Document d = cube_of_struts();
    const Document other = cube_of_struts();
    for (std::int32_t i = 0; i < 8; ++i) {
        const Node& node = other.nodes[i];
        add(d, i == 0 ? 7 : node.parent + 8, node.position + Vec3(9, 9, 9), 0.3);
    }
    for (const auto& link : other.links) d.links.push_back({link[0] + 8, link[1] + 8});
    EXPECT_EQ(Divided(d).core_paths(), 25);
    const std::int32_t fork = add(d, 15, {17, 17, 17}, 0.3);
    add(d, fork, {21, 17, 17}, 0.3);
    add(d, fork, {17, 21, 17}, 0.3);
    const Divided divided(d);
    EXPECT_EQ(divided.regions.components, 1);
    EXPECT_EQ(divided.network.path_count(), 28);
    EXPECT_EQ(divided.core_paths(), 25);
}

TEST(Regions, AreOneAComponentOfJoints) {
    Document d = star(fan(3));
    for (const Node& node : star(fan(4)).nodes)
        add(d, node.parent < 0 ? -1 : node.parent + 4, node.position + Vec3(0, 0, 9), 0.25);
    add(d, add(d, -1, {0, 0, 20}, 0.5), {3, 0, 20}, 0.5);  // a stick, of no component
    const Divided divided(d);
    ASSERT_EQ(divided.regions.components, 2);
    std::array<int, 3> paths{};
    for (std::int32_t p = 0; p < divided.network.path_count(); ++p)
        ++paths[divided.regions.component_of(divided.network, p) + 1];
    EXPECT_EQ(paths, (std::array<int, 3>{1, 3, 4}));
}

}  // namespace
}  // namespace sinew::sqm
