#include "live/grower.h"

#include <gtest/gtest.h>

#include <future>

namespace sinew::modeler {
namespace {

/// A line of 2ⁿ segments.
std::shared_ptr<const Grammar> doubling() {
    auto grammar = parse_grammar("%steps 3\n%axiom F(1)\nF(l) -> F(l) F(l)\n", "doubling.lsys");
    EXPECT_TRUE(grammar) << grammar.error().text();
    return std::make_shared<const Grammar>(std::move(*grammar));
}

using Arrival = std::promise<std::shared_ptr<const Grown>>;

TEST(Grower, grows_on_another_thread) {
    Arrival arrival;
    Grower grower([&](auto grown) { arrival.set_value(grown); });
    const std::uint64_t number = grower.order(doubling(), {.steps = 5});
    const auto grown = arrival.get_future().get();
    EXPECT_EQ(grown->order, number);
    ASSERT_TRUE(grown->document);
    EXPECT_EQ(grown->document->nodes.size(), 33u);
}

TEST(Grower, refuses_more_nodes_than_the_limit_and_says_how_many) {
    Arrival arrival;
    Grower grower([&](auto grown) { arrival.set_value(grown); });
    grower.order(doubling(), {.steps = 20, .limit = 1000});
    const auto grown = arrival.get_future().get();
    ASSERT_FALSE(grown->document);
    EXPECT_NE(grown->document.error().text().find("1048577"), std::string::npos)
        << grown->document.error().text();
}

TEST(Grower, the_last_order_arrives_whatever_came_before) {
    Arrival arrival;
    Grower grower([&](auto grown) {
        if (grown->document && grown->document->nodes.size() == 3) arrival.set_value(grown);
    });
    const auto grammar = doubling();
    for (int i = 0; i < 20; ++i) grower.order(grammar, {.steps = 18});
    const std::uint64_t last = grower.order(grammar, {.steps = 1});
    EXPECT_EQ(arrival.get_future().get()->order, last);
}

TEST(Grower, ends_while_something_grows) {
    Grower grower([](auto) {});
    grower.order(doubling(), {.steps = 22});
}

}  // namespace
}  // namespace sinew::modeler
