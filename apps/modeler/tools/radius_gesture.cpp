#include "tools/radius_gesture.h"

#include <fmt/format.h>

#include <algorithm>

#include "document/edits.h"

namespace sinew::modeler {
namespace {

const double least_handle =
    12;  ///< pixels: a node that is smaller than this on the screen grows as if it were not
const double smallest_factor =
    0.02;                      ///< in one go; the pointer does not reach further inwards than the centre
const double round_to = 0.05;  ///< of the factor, with Ctrl

}  // namespace

RadiusGesture::RadiusGesture(Model& model, Selection nodes, const Mat3& image, const Pointer& pointer,
                             const Screen& screen)
    : model_(model), start_(model.document()), nodes_(std::move(nodes)), image_(image) {
    const Node& node = start_.nodes[nodes_.active];
    centre_ = node.position;
    first_distance_ = distance_to_centre(pointer, screen);
    first_radius_ = std::max(node.radius / screen.in_image(image_).pixel_length(centre_), least_handle);
    model_.preview(start_, nodes_);
}

double RadiusGesture::distance_to_centre(const Pointer& pointer, const Screen& screen) const {
    const std::optional<Vec2> centre = screen.in_image(image_).project(centre_);
    return centre ? (*centre - pointer.pixel).norm() : first_distance_;
}

void RadiusGesture::update(const Pointer& pointer, const Screen& screen) {
    factor_ = (first_radius_ + distance_to_centre(pointer, screen) - first_distance_) / first_radius_;
    if (pointer.ctrl && pointer.shift) factor_ = std::round(factor_ / round_to) * round_to;
    factor_ = std::max(amount_ ? *amount_ : factor_, smallest_factor);
    model_.preview(scale_radii(start_, nodes_.nodes, factor_), nodes_);
}

bool RadiusGesture::set_amount(std::optional<double> amount) {
    amount_ = amount;
    return true;
}

std::string RadiusGesture::hint() const {
    const std::string unit = start_.unit.empty() ? "" : " " + start_.unit;
    const double radius = model_.document().nodes[nodes_.active].radius;
    return fmt::format("Radius: {:.4g}{}  (times {:.3f})", radius, unit, factor_);
}

}  // namespace sinew::modeler
