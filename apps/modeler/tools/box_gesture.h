/// @file box_gesture.h
/// A rectangle on the screen selects the nodes in it.
#pragma once

#include "document/model.h"
#include "tools/gesture.h"

namespace sinew::modeler {

class BoxGesture : public Gesture {
  public:
    BoxGesture(Model& model, const Pointer& pointer)
        : model_(model), before_(model.selection()), from_(pointer.pixel), to_(pointer.pixel) {}

    /// Shift adds to what was selected before.
    void update(const Pointer& pointer, const Screen& screen) override;
    void finish() override {}
    void cancel() override { model_.select(before_); }
    std::string hint() const override;
    std::string keys() const override { return "Shift adds to what was selected; Esc leaves it as it was"; }
    Guides guides() const override { return {.rectangle = std::array{from_, to_}}; }

  private:
    Model& model_;
    Selection before_;
    Vec2 from_, to_;
};

}  // namespace sinew::modeler
