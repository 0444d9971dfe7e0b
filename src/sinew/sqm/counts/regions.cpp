#include "sinew/sqm/counts/regions.h"

namespace sinew::sqm {
namespace {

void find_components(const Network& n, Regions& r) {
    r.component.assign(n.joint_count(), -1);
    std::vector<std::int32_t> stack;
    for (std::int32_t seed = 0; seed < n.joint_count(); ++seed) {
        if (r.component[seed] >= 0) continue;
        r.component[seed] = r.components;
        stack.assign(1, seed);
        while (!stack.empty()) {
            const std::int32_t joint = stack.back();
            stack.pop_back();
            n.for_slots(joint, [&](std::int32_t, std::int32_t path) {
                const std::int32_t next = n.joint_beyond(path, joint);
                if (next < 0 || r.component[next] >= 0) return;
                r.component[next] = r.components;
                stack.push_back(next);
            });
        }
        ++r.components;
    }
}

/// Peels joints that hang on by one path; what cannot be peeled is the core.
void find_core(const Network& n, Regions& r) {
    std::vector<std::int32_t> hold(n.joint_count(), 0), stack;
    r.core.assign(n.path_count(), 0);
    for (std::int32_t p = 0; p < n.path_count(); ++p)
        if (n.between_joints(p)) {
            r.core[p] = 1;
            for (const PathEnd& end : n.path_end[p]) ++hold[end.joint];
        }
    for (std::int32_t j = 0; j < n.joint_count(); ++j)
        if (hold[j] == 1) stack.push_back(j);
    while (!stack.empty()) {
        const std::int32_t joint = stack.back();
        stack.pop_back();
        n.for_slots(joint, [&](std::int32_t, std::int32_t path) {
            if (!r.core[path]) return;
            r.core[path] = 0;
            for (const PathEnd& end : n.path_end[path])
                if (--hold[end.joint] == 1) stack.push_back(end.joint);
        });
    }
}

}  // namespace

Regions find_regions(const Network& network) {
    Regions regions;
    find_components(network, regions);
    find_core(network, regions);
    return regions;
}

}  // namespace sinew::sqm
