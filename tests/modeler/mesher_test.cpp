#include "live/mesher.h"

#include <gmock/gmock.h>

#include "document/edits.h"

namespace sinew::modeler {
namespace {

using testing::ElementsAre;

/// What a mesher delivers, from whichever thread; may hold it up at the first delivery.
class Deliveries {
  public:
    void take(const std::shared_ptr<const LiveMesh>& mesh) {
        std::unique_lock lock(mutex_);
        meshes_.push_back(mesh);
        changed_.notify_all();
        changed_.wait(lock, [this] { return !held_; });
    }
    void hold() {
        const std::lock_guard lock(mutex_);
        held_ = true;
    }
    void let_go() {
        const std::lock_guard lock(mutex_);
        held_ = false;
        changed_.notify_all();
    }
    /// Waits for the mesh of a revision, measured or not; the limit is for what never comes.
    bool wait(std::uint64_t revision, bool measured) {
        std::unique_lock lock(mutex_);
        return changed_.wait_for(lock, std::chrono::seconds(120), [&] {
            return !meshes_.empty() && meshes_.back()->revision == revision &&
                   (!measured || meshes_.back()->measures || meshes_.back()->error);
        });
    }
    /// Of all deliveries that are no second ones, with measures.
    std::vector<std::uint64_t> revisions() {
        const std::lock_guard lock(mutex_);
        std::vector<std::uint64_t> all;
        for (const auto& mesh : meshes_)
            if (!mesh->measures) all.push_back(mesh->revision);
        return all;
    }
    std::shared_ptr<const LiveMesh> last() {
        const std::lock_guard lock(mutex_);
        return meshes_.back();
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<std::shared_ptr<const LiveMesh>> meshes_;
    bool held_ = false;
};

Document tube(double length) {
    Document document;
    document.nodes = {{.id = 0, .radius = 0.5},
                      {.id = 1, .parent = 0, .position = Vec3(0, 0, length), .radius = 0.5}};
    return document;
}

/// A long way round: enough for a mesher to be in the midst of it.
Document long_limb(int nodes) {
    Document document;
    for (int i = 0; i < nodes; ++i)
        document.nodes.push_back({.id = i,
                                  .parent = i - 1,
                                  .position = Vec3(std::cos(0.3 * i), std::sin(0.3 * i), 0.2 * i) * 3,
                                  .radius = 0.2});
    return document;
}

TEST(Mesher, delivers_to_draw_and_then_measured) {
    Deliveries deliveries;
    Mesher mesher([&](auto mesh) { deliveries.take(mesh); });
    mesher.order(tube(3), {.level = 1}, 5);
    ASSERT_TRUE(deliveries.wait(5, true));
    EXPECT_THAT(deliveries.revisions(), ElementsAre(5));
    EXPECT_TRUE(deliveries.last()->buffers);
    EXPECT_TRUE(deliveries.last()->validation->solid());
}

TEST(Mesher, only_the_newest_is_made) {
    Deliveries deliveries;
    Mesher mesher([&](auto mesh) { deliveries.take(mesh); });
    deliveries.hold();
    mesher.order(tube(2), {.level = 0}, 1);
    ASSERT_TRUE(deliveries.wait(1, false));
    // The mesher is held at its first delivery: what is ordered meanwhile waits, and only the last counts.
    for (std::uint64_t revision = 2; revision <= 50; ++revision)
        mesher.order(tube(static_cast<double>(revision)), {.level = 0}, revision);
    deliveries.let_go();
    ASSERT_TRUE(deliveries.wait(50, true));
    EXPECT_THAT(deliveries.revisions(), ElementsAre(1, 50));
    float top = 0;
    for (const Vec3f& position : deliveries.last()->mesh->positions) top = std::max(top, position.z());
    EXPECT_NEAR(top, 50.5f, 1e-4f);
}

TEST(Mesher, an_order_is_no_wait) {
    // The mesher does not come back from its delivery before it is let go, yet orders return.
    Deliveries deliveries;
    Mesher mesher([&](auto mesh) { deliveries.take(mesh); });
    deliveries.hold();
    mesher.order(tube(2), {}, 1);
    ASSERT_TRUE(deliveries.wait(1, false));
    for (std::uint64_t revision = 2; revision <= 1000; ++revision) mesher.order(tube(2), {}, revision);
    EXPECT_EQ(deliveries.revisions().size(), 1u);
    deliveries.let_go();
    EXPECT_TRUE(deliveries.wait(1000, false));
}

TEST(Mesher, an_older_one_is_stopped_but_never_twice_in_a_row) {
    // However fast orders come, at least every other one that is begun is delivered: a drag sees its mesh.
    Deliveries deliveries;
    Mesher mesher([&](auto mesh) { deliveries.take(mesh); });
    const Document document = long_limb(3000);
    std::uint64_t revision = 0;
    for (int delivered = 0; delivered < 3; ++delivered) {
        const std::size_t before = deliveries.revisions().size();
        while (deliveries.revisions().size() == before) {
            mesher.order(document, {.level = 0}, ++revision);
            std::this_thread::yield();
        }
    }
    mesher.order(document, {.level = 0}, ++revision);
    ASSERT_TRUE(deliveries.wait(revision, false));
    const std::vector<std::uint64_t> seen = deliveries.revisions();
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
}

TEST(Mesher, what_fails_is_delivered_as_an_error) {
    Deliveries deliveries;
    Mesher mesher([&](auto mesh) { deliveries.take(mesh); });
    Document document = tube(3);
    document.nodes[1].radius = -1;
    mesher.order(document, {}, 3);
    ASSERT_TRUE(deliveries.wait(3, false));
    EXPECT_TRUE(deliveries.last()->error);
    mesher.order(tube(3), {}, 4);
    ASSERT_TRUE(deliveries.wait(4, false));
    EXPECT_FALSE(deliveries.last()->error);
}

TEST(Mesher, the_end_does_not_wait_for_what_is_in_the_making) {
    // Each mesher goes while it works: nothing is delivered after its end, which the callback would find out.
    for (int round = 0; round < 20; ++round) {
        bool gone = false;
        {
            Mesher mesher([&](const auto&) { EXPECT_FALSE(gone); });
            mesher.order(long_limb(500), {.level = 1}, 1);
            if (round % 2) mesher.stop();
        }
        gone = true;
    }
}

}  // namespace
}  // namespace sinew::modeler
