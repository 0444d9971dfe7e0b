#include "sinew/mesh/intersect.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <mutex>

#include "sinew/mesh/box_tree.h"
#include "sinew/mesh/predicates.h"
#include "sinew/mesh/triangle_pair.h"
#include "sinew/mesh/triangulate.h"

namespace sinew {
namespace {

using Index = std::uint32_t;

/// The faces as sound triangles: those of no area are gone.
Triangles sound_triangles(const QuadMesh& mesh) {
    Triangles all = triangulate(mesh);
    std::vector<char> sound(all.triangles.size());
    const std::vector<Vec3f>& p = mesh.positions;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, sound.size(), 8192), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const auto& [a, b, c] = all.triangles[i];
            sound[i] = p[a].allFinite() && p[b].allFinite() && p[c].allFinite() &&
                       projection_axis(p[a], p[b], p[c]) >= 0;
        }
    });
    if (std::find(sound.begin(), sound.end(), 0) == sound.end()) return all;
    Triangles kept;
    kept.first.push_back(0);
    for (std::size_t f = 0; f + 1 < all.first.size(); ++f) {
        for (Index t = all.first[f]; t < all.first[f + 1]; ++t)
            if (sound[t]) kept.triangles.push_back(all.triangles[t]);
        kept.first.push_back(static_cast<Index>(kept.triangles.size()));
    }
    return kept;
}

std::vector<Box> boxes_of(const QuadMesh& mesh, const Triangles& triangles) {
    std::vector<Box> boxes(mesh.face_count());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, boxes.size(), 4096), [&](const auto& range) {
        for (std::size_t f = range.begin(); f < range.end(); ++f)
            for (const Triangle& t : triangles.of(f))
                for (const Index v : t) boxes[f].extend(mesh.positions[v]);
    });
    return boxes;
}

bool holds(const Triangle& t, Index v) { return t[0] == v || t[1] == v || t[2] == v; }

/// Is a triangle parted from some vertices, but those it shares with them, by its own plane?
bool parted_by_plane(const std::vector<Vec3f>& positions, const Triangle& t,
                     std::span<const Index> vertices) {
    int all = 0, shared = 0;
    for (const Index v : vertices) {
        if (holds(t, v)) {
            if (++shared > 2) return false;
            continue;
        }
        const int side = orient3d(positions[t[0]], positions[t[1]], positions[t[2]], positions[v]);
        if (side == 0 || side * all < 0) return false;
        all = side;
    }
    return true;
}

bool faces_intersect(const QuadMesh& mesh, const Triangles& triangles, Index a, Index b) {
    for (const Triangle& s : triangles.of(a)) {
        if (parted_by_plane(mesh.positions, s, mesh.face(b))) continue;
        for (const Triangle& t : triangles.of(b))
            if (!parted_by_plane(mesh.positions, t, s) && triangles_intersect(mesh.positions, s, t))
                return true;
    }
    return false;
}

class Finder {
  public:
    Finder(const QuadMesh& mesh, const Progress& progress)
        : mesh_(mesh),
          progress_(progress),
          triangles_(sound_triangles(mesh)),
          tree_(build_box_tree(boxes_of(mesh, triangles_))) {}

    /// @param bounded  give up where most_pairs_tested says so
    Result<SelfIntersections> find(bool bounded) {
        const std::vector<BoxTreePair> work = split_overlaps(tree_, 4096);
        // Each part has its share, so that what is found does not depend on who comes first.
        const std::uint64_t all = most_pairs_tested + most_pairs_tested_a_face * mesh_.face_count();
        const std::uint64_t share = bounded ? all / std::max<std::size_t>(work.size(), 1) + 1 : UINT64_MAX;
        const std::size_t block = 16;
        tbb::parallel_for(std::size_t{0}, (work.size() + block - 1) / block, [&](std::size_t b) {
            find_in(std::span(work).subspan(b * block, std::min(block, work.size() - b * block)), work.size(),
                    share);
        });
        if (progress_.cancelled()) return Progress::stopped();
        tbb::parallel_sort(found_.pairs.begin(), found_.pairs.end());
        return std::move(found_);
    }

  private:
    void find_in(std::span<const BoxTreePair> work, std::size_t all_work, std::uint64_t share) {
        std::vector<FacePair> found;
        bool complete = true;
        for (const BoxTreePair& part : work) {
            if (progress_.cancelled()) return;
            std::uint64_t left = share;
            find_below(part, left, found);
            complete = complete && left > 0;
        }
        const std::lock_guard lock(mutex_);
        found_.pairs.insert(found_.pairs.end(), found.begin(), found.end());
        found_.complete = found_.complete && complete;
        done_ += work.size();
        progress_(double(done_) / double(all_work), "self-intersections");
    }

    /// @param left  pairs that may still be looked at; 0 in the end: not all were
    void find_below(const BoxTreePair& pair, std::uint64_t& left, std::vector<FacePair>& found) {
        if (left == 0 || --left == 0) return;
        if (left % 4096 == 0 && progress_.cancelled()) return void(left = 0);
        if (pair.level > 0)
            return for_each_child_pair(tree_, pair,
                                       [&](const BoxTreePair& child) { find_below(child, left, found); });
        if (pair.low == pair.high) return;
        const Index f = tree_.items[pair.low], g = tree_.items[pair.high];
        if (faces_intersect(mesh_, triangles_, f, g)) found.push_back({std::min(f, g), std::max(f, g)});
    }

    const QuadMesh& mesh_;
    const Progress& progress_;
    Triangles triangles_;
    BoxTree tree_;
    std::mutex mutex_;
    SelfIntersections found_;
    std::size_t done_ = 0;
};

}  // namespace

Result<std::vector<FacePair>> find_self_intersections(const QuadMesh& mesh, const Progress& progress) {
    Result<SelfIntersections> found = Finder(mesh, progress).find(false);
    if (!found) return tl::unexpected(found.error());
    return std::move(found->pairs);
}

Result<SelfIntersections> find_self_intersections_within_bounds(const QuadMesh& mesh,
                                                                const Progress& progress) {
    return Finder(mesh, progress).find(true);
}

}  // namespace sinew
