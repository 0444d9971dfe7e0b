// A builder and what it is made of.
#pragma once

#include "sinew/extend/builder.h"
#include "skinning.h"

namespace sinew::testing_types {

struct Built {
    explicit Built(Document drawn)
        : document(std::move(drawn)), graph(condition(document)), builder(document, graph, warnings) {}

    Document document;
    Warnings warnings;
    CleanGraph graph;
    PlainBuilder builder;
};

inline double distance(const Vec3& a, const Vec3& b) { return (a - b).norm(); }

}  // namespace sinew::testing_types
