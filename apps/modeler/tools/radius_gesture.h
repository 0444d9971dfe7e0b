/// @file radius_gesture.h
/// The outline of a node follows the pointer: its radius grows and shrinks, and that of all that is selected.
#pragma once

#include "document/model.h"
#include "tools/gesture.h"

namespace sinew::modeler {

class RadiusGesture : public Gesture {
  public:
    /// @param screen as shown at the image where the node was taken hold of
    RadiusGesture(Model& model, Selection nodes, const Mat3& image, const Pointer& pointer,
                  const Screen& screen);

    void update(const Pointer& pointer, const Screen& screen) override;
    void finish() override { model_.commit("Radius"); }
    void cancel() override { model_.cancel(); }
    bool set_amount(std::optional<double> amount) override;
    std::string hint() const override;
    std::string keys() const override {
        return "Figures are a factor; Ctrl+Shift goes in steps; Esc takes it back";
    }

  private:
    double distance_to_centre(const Pointer& pointer, const Screen& screen) const;

    Model& model_;
    Document start_;
    Selection nodes_;
    Mat3 image_;
    Vec3 centre_;
    double first_distance_ = 0;  ///< pixels from the centre to where the pointer was at first
    double first_radius_ = 1;    ///< of the node on the screen, in pixels
    std::optional<double> amount_;
    double factor_ = 1;
};

}  // namespace sinew::modeler
