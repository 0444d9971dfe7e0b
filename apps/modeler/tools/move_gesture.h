/// @file move_gesture.h
/// Nodes follow the pointer: what drawing a child, inserting on a bone, moving and duplicating all come to.
#pragma once

#include "document/edits.h"
#include "document/model.h"
#include "document/snap.h"
#include "tools/gesture.h"

namespace sinew::modeler {

/// How a move begins. The edit it starts from may already hold new nodes; its selection is what moves.
struct MoveStart {
    Edited edit;
    std::string label = "Move";
    std::int32_t anchor = -1;       ///< the node under the pointer, by which snaps are measured
    Mat3 image = Mat3::Identity();  ///< the image of the symmetry where it was taken hold of
    AxisLock lock;                  ///< as when a gizmo's arrow was taken
    SnapTo snap_to = SnapTo::grid;
};

class MoveGesture : public Gesture {
  public:
    MoveGesture(Model& model, MoveStart start, const Pointer& pointer);

    void update(const Pointer& pointer, const Screen& screen) override;
    void finish() override;
    void cancel() override { model_.cancel(); }
    bool lock(const AxisLock& lock) override;
    bool set_amount(std::optional<double> amount) override;
    std::string hint() const override;
    std::string keys() const override {
        return "X, Y, Z hold an axis, with Shift the plane across it; Ctrl snaps; figures are exact; Esc "
               "takes it back";
    }
    Guides guides() const override;

  private:
    Vec3 lock_direction() const;
    Vec3 free_delta(const Screen& screen, const Vec2& pixel) const;
    Snapped snap(const Screen& screen, const Pointer& pointer, const Vec3& target) const;
    Vec3 locked(const Vec3& target) const;
    Vec3 exact_delta(const Vec3& delta) const;

    Model& model_;
    MoveStart start_;
    Vec3 anchor_position_;  ///< at first
    Vec3 target_;           ///< now
    std::optional<Vec3> parent_position_;
    Vec2 pressed_at_;
    std::optional<double> amount_;
    bool caught_ = false;
};

}  // namespace sinew::modeler
