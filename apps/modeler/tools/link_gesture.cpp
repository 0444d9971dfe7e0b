#include "tools/link_gesture.h"

#include <fmt/format.h>

#include "document/edits.h"
#include "document/pick.h"

namespace sinew::modeler {

void LinkGesture::update(const Pointer& pointer, const Screen& screen) {
    const Document& document = model_.document();
    const Vec3 from = document.nodes[from_].position;
    end_ = meet_plane(screen.ray(pointer.pixel), from, screen.forward(from)).value_or(from);
    to_ = -1;
    // Links join nodes that are drawn; an image has no index of its own.
    for (const Hit& hit : hits_at(document, glyphs_of(document, 1), screen, pointer.pixel)) {
        if (hit.kind != Hit::Kind::node || hit.image != 0 || hit.index == from_) continue;
        to_ = hit.index;
        end_ = document.nodes[to_].position;
        break;
    }
}

void LinkGesture::finish() {
    if (to_ < 0) return;
    const bool were_joined = are_joined(model_.document(), from_, to_);
    model_.apply(were_joined ? "Unlink" : "Link", toggle_link(model_.document(), from_, to_),
                 selection_of(to_));
}

std::string LinkGesture::hint() const {
    if (to_ < 0) return "Link: click the node to join";
    return are_joined(model_.document(), from_, to_) ? "Click to take the link away" : "Click to link";
}

Guides LinkGesture::guides() const {
    Guides guides;
    guides.lines.push_back({model_.document().nodes[from_].position, end_, -1});
    if (to_ >= 0) guides.snapped = end_;
    return guides;
}

}  // namespace sinew::modeler
