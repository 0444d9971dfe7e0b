#include "sinew/skeleton/validate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace sinew {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

/// Ids 10, 11, 12, 13: a trunk of two with two leaves at its end.
Document fork() {
    Document document;
    document.nodes.resize(4);
    for (int i = 0; i < 4; ++i) {
        document.nodes[i].id = 10 + i;
        document.nodes[i].parent = std::min(i - 1, 1);
        document.nodes[i].position = {i == 2 ? 1. : 0., 0, 1. * i};
    }
    return document;
}

/// What is said of the fork once `spoil` has changed it: "path, node: message".
std::vector<std::string> said(const std::function<void(Document&)>& spoil) {
    Document document = fork();
    spoil(document);
    std::vector<std::string> texts;
    for (const Error& error : problems(document)) {
        EXPECT_FALSE(error.cure.empty()) << error.message;
        texts.push_back(error.text());
    }
    EXPECT_EQ(validate(document).has_value(), texts.empty());
    return texts;
}

TEST(Validate, ASoundDocumentHasNoProblems) {
    EXPECT_THAT(said([](Document&) {}), SizeIs(0));
    EXPECT_THAT(said([](Document& d) { d = {}; }), SizeIs(0));
    EXPECT_THAT(said([](Document& d) { d.links = {{2, 3}}; }), SizeIs(0));
    EXPECT_THAT(said([](Document& d) { d.nodes[0].type = d.nodes[3].type = NodeType::cone; }), SizeIs(0));
    EXPECT_THAT(said([](Document& d) { d.nodes[3].size = Vec3(0, 0, 0); }), SizeIs(0));
    EXPECT_THAT(said([](Document& d) { d.nodes[3].joint = infinitely_sharp; }), SizeIs(0));
}

struct Case {
    const char* name;
    std::function<void(Document&)> spoil;
    const char* expected;  ///< part of the only problem's text
};

class OneProblem : public testing::TestWithParam<Case> {};

TEST_P(OneProblem, IsNamedWithItsPlace) {
    const std::vector<std::string> texts = said(GetParam().spoil);
    ASSERT_THAT(texts, SizeIs(1));
    EXPECT_THAT(texts[0], HasSubstr(GetParam().expected));
}

const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();

INSTANTIATE_TEST_SUITE_P(
    Validate, OneProblem,
    testing::Values(
        Case{"ZeroRadius", [](Document& d) { d.nodes[2].radius = 0; },
             "/nodes/2/radius: node 12: the radius must be above 0"},
        Case{"NanRadius", [](Document& d) { d.nodes[2].radius = nan; }, "/nodes/2/radius: node 12"},
        Case{"FarPosition", [](Document& d) { d.nodes[1].position.y() = 1e31; },
             "/nodes/1/position: node 11"},
        Case{"NanPosition", [](Document& d) { d.nodes[1].position.y() = nan; }, "/nodes/1/position: node 11"},
        Case{"NegativeId", [](Document& d) { d.nodes[1].id = -1; },
             "/nodes/1/id: node -1: the id -1 is negative"},
        Case{"RepeatedId", [](Document& d) { d.nodes[3].id = 10; },
             "/nodes/3/id: node 10: the id 10 is used twice"},
        Case{"NoSuchParent", [](Document& d) { d.nodes[3].parent = 9; },
             "/nodes/3/parent: node 13: there is no parent 9 for the node at index 3: a parent is an index "
             "into "
             "the nodes, and there are 4; name an existing node, or -1 for a root"},
        Case{"IdForAParent", [](Document& d) { d.nodes[3].parent = 12; },
             "there is no parent 12 for the node at index 3: a parent is an index into the nodes, and there "
             "are "
             "4; the node with the id 12 is at index 2"},
        Case{"OwnParent", [](Document& d) { d.nodes[3].parent = 3; },
             "/nodes/3/parent: node 13: the node is its own parent"},
        Case{"ParentCycle", [](Document& d) { d.nodes[0].parent = 3; },
             "node 10: the node is its own ancestor, by way of its parent 13"},
        Case{"ConeAtABranch", [](Document& d) { d.nodes[1].type = NodeType::cone; },
             "/nodes/1/type: node 11: a cone must be a leaf, and this node has 3 bones"},
        Case{"NegativeClosedByALink",
             [](Document& d) {
                 d.nodes[2].type = NodeType::negative;
                 d.links = {{2, 3}};
             },
             "/nodes/2/type: node 12: a negative must be a leaf"},
        Case{"ZeroScale", [](Document& d) { d.nodes[2].scale[1] = 0; }, "/nodes/2/scale: node 12"},
        Case{"NegativeSize", [](Document& d) { d.nodes[2].size = Vec3(1, -1, 1); }, "/nodes/2/size: node 12"},
        Case{"InfiniteRoll", [](Document& d) { d.nodes[2].roll = infinite; }, "/nodes/2/roll: node 12"},
        Case{"NoRotation", [](Document& d) { d.nodes[2].rotation = Quat(0, 0, 0, 0); },
             "/nodes/2/rotation: node 12"},
        Case{"NegativeSharpness", [](Document& d) { d.nodes[2].joint = -1; }, "/nodes/2/joint: node 12"},
        Case{"LinkToNothing",
             [](Document& d) {
                 d.links = {{0, 4}};
             },
             "/links/0: the link of 0 and 4 names a node that does not exist: its ends are indices into the "
             "nodes, and there are 4"},
        Case{"LinkToItself",
             [](Document& d) {
                 d.links = {{2, 3}, {2, 2}};
             },
             "/links/1: node 12: the link joins the node to itself"},
        Case{"LinkOverABone",
             [](Document& d) {
                 d.links = {{3, 1}};
             },
             "the link repeats the bone between 13 and 11"},
        Case{"LinkTwice",
             [](Document& d) {
                 d.links = {{2, 3}, {3, 2}};
             },
             "/links/1: node 12: the link between 12 and 13 is given twice"},
        Case{"OneImage",
             [](Document& d) {
                 d.symmetry = {Symmetry::Kind::radial, 2, 1};
             },
             "/symmetry/radial/count"}),
    [](const auto& each) { return each.param.name; });

TEST(Validate, TwoNegativesHaveNothingToPressInto) {
    EXPECT_THAT(said([](Document& d) {
                    d.nodes.resize(2);
                    d.nodes[0].type = d.nodes[1].type = NodeType::negative;
                }),
                SizeIs(2));
}

TEST(Validate, EveryProblemIsListedAndTheLimitHolds) {
    Document document = fork();
    for (Node& node : document.nodes) node.radius = -1;
    EXPECT_THAT(problems(document), SizeIs(4));
    EXPECT_THAT(problems(document, 2), SizeIs(2));
    EXPECT_EQ(validate(document).error().node, 10);
}

}  // namespace
}  // namespace sinew
