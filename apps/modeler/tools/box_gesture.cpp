#include "tools/box_gesture.h"

#include <fmt/format.h>

#include "document/pick.h"

namespace sinew::modeler {

void BoxGesture::update(const Pointer& pointer, const Screen& screen) {
    to_ = pointer.pixel;
    const Selection inside = nodes_in_box(model_.document(), screen, from_, to_);
    model_.select(pointer.shift ? united(before_, inside) : inside);
}

std::string BoxGesture::hint() const {
    const std::size_t count = model_.selection().nodes.size();
    return fmt::format("{} node{} selected", count, count == 1 ? "" : "s");
}

}  // namespace sinew::modeler
