/// @file link_gesture.h
/// A line from the active node to another one, which becomes a bone between them (or takes a link away
/// again).
#pragma once

#include "document/glyph.h"
#include "document/model.h"
#include "tools/gesture.h"

namespace sinew::modeler {

class LinkGesture : public Gesture {
  public:
    LinkGesture(Model& model, std::int32_t from) : model_(model), from_(from) {}

    void update(const Pointer& pointer, const Screen& screen) override;
    void finish() override;
    void cancel() override {}
    std::string hint() const override;
    std::string keys() const override {
        return "Click a node: joined by a bone, or parted where a link joins them; Esc stops";
    }
    Guides guides() const override;

  private:
    Model& model_;
    std::int32_t from_;
    std::int32_t to_ = -1;  ///< the node under the pointer
    Vec3 end_ = Vec3::Zero();
};

}  // namespace sinew::modeler
