#include "tools/begin_gesture.h"

#include "document/edits.h"
#include "document/images.h"
#include "sinew/skeleton/graph.h"
#include "tools/box_gesture.h"
#include "tools/link_gesture.h"
#include "tools/move_gesture.h"
#include "tools/radius_gesture.h"

namespace sinew::modeler {
namespace {

Mat3 image_of(const Document& document, std::int32_t image) { return images_of(document.symmetry)[image]; }

std::unique_ptr<Gesture> draw_from(Model& model, SnapTo snap_to, const Press& press) {
    const Document& document = model.document();
    const Hit& hit = press.hit;
    const bool child = hit.kind == Hit::Kind::node;
    MoveStart start;
    start.edit = child ? add_children(document, std::span(&hit.index, 1))
                       : modeler::insert_on_bone(document, hit.index, hit.along);
    start.label = child ? "Extrude" : "Insert";
    start.anchor = start.edit.selection.active;
    start.image = image_of(document, hit.image);
    start.snap_to = snap_to;
    return std::make_unique<MoveGesture>(model, std::move(start), press.pointer);
}

std::unique_ptr<Gesture> move_of(Model& model, SnapTo snap_to, const Selection& nodes, std::int32_t image,
                                 const Pointer& pointer, AxisLock lock = {}) {
    MoveStart start{{model.document(), nodes},         "Move", nodes.active,
                    image_of(model.document(), image), lock,   snap_to};
    return std::make_unique<MoveGesture>(model, std::move(start), pointer);
}

/// New nodes that follow the pointer from where their originals are.
std::unique_ptr<Gesture> move_new(Model& model, SnapTo snap_to, Edited edit, const char* label,
                                  const Pointer& pointer) {
    const std::int32_t anchor = edit.selection.active;
    MoveStart start{std::move(edit), label, anchor, Mat3::Identity(), {}, snap_to};
    return std::make_unique<MoveGesture>(model, std::move(start), pointer);
}

}  // namespace

Selection grabbed(const Model& model, const Hit& hit) {
    if (hit.kind == Hit::Kind::bone) return selection_of(bones_of(model.document())[hit.index]);
    Selection nodes = model.selection().contains(hit.index) ? model.selection() : selection_of(hit.index);
    nodes.active = hit.index;
    return nodes;
}

std::unique_ptr<Gesture> begin_drag(Model& model, Tool tool, SnapTo snap_to, const Press& press,
                                    const Screen& screen) {
    const Hit& hit = press.hit;
    const Pointer& pointer = press.pointer;
    if (press.handle) return move_of(model, snap_to, model.selection(), 0, pointer, *press.handle);
    if (!hit) return std::make_unique<BoxGesture>(model, pointer);
    if (hit.kind == Hit::Kind::node && (pointer.ctrl || tool == Tool::radius))
        return std::make_unique<RadiusGesture>(model, grabbed(model, hit),
                                               image_of(model.document(), hit.image), pointer, screen);
    if (tool == Tool::draw && !pointer.shift) return draw_from(model, snap_to, press);
    return move_of(model, snap_to, grabbed(model, hit), hit.image, pointer);
}

std::unique_ptr<Gesture> begin_modal(Model& model, Modal modal, SnapTo snap_to, const Pointer& pointer,
                                     const Screen& screen) {
    const Selection& selection = model.selection();
    switch (modal) {
        case Modal::move:
            return move_of(model, snap_to, selection, 0, pointer);
        case Modal::radius:
            return std::make_unique<RadiusGesture>(model, selection, Mat3::Identity(), pointer, screen);
        case Modal::link:
            return std::make_unique<LinkGesture>(model, selection.active);
        case Modal::extrude:
            return move_new(model, snap_to, add_children(model.document(), selection.nodes), "Extrude",
                            pointer);
        default:
            return move_new(model, snap_to, duplicate(model.document(), selection), "Duplicate", pointer);
    }
}

}  // namespace sinew::modeler
