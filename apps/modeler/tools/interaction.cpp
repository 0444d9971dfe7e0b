#include "tools/interaction.h"

#include <charconv>
#include <cmath>

#include "document/edits.h"
#include "document/images.h"
#include "sinew/skeleton/graph.h"
#include "tools/gizmo.h"

namespace sinew::modeler {
namespace {

const double drag_begins = 4;      ///< pixels
const double wheel_factor = 1.08;  ///< of the radius, a notch
const Model::MergeKey wheel_key = 1;

}  // namespace

Interaction::Interaction(Model& model) : model_(model) {
    model_.observe([this](const Changes& changes) {
        // What a gesture does itself is a preview; it is out of the way before it is kept (see finish).
        if (changes.document && !model_.previewing()) changed_elsewhere();
    });
}

/// Nodes have other indices now, or are gone.
void Interaction::changed_elsewhere() {
    gesture_.reset();
    typed_.clear();
    pressed_.reset();
    hovered_ = last_click_ = {};
    hovered_handle_.reset();
    stale_ = true;
}

const Glyphing& Interaction::glyphs() {
    if (glyphs_revision_ != model_.revision() || glyphs_scale_ != glyph_scale) {
        glyphs_ = glyphs_of(model_.document(), glyph_scale);
        glyphs_revision_ = model_.revision();
        glyphs_scale_ = glyph_scale;
    }
    return glyphs_;
}

std::vector<Hit> Interaction::hits(const Pointer& pointer, const Screen& screen) {
    if (locked) return {};
    return hits_at(model_.document(), glyphs(), screen, pointer.pixel);
}

std::optional<Vec3> Interaction::gizmo_place() const {
    if (tool != Tool::move || gesture_ || locked || model_.selection().active < 0) return std::nullopt;
    return model_.document().nodes[model_.selection().active].position;
}

void Interaction::press(const Pointer& pointer, const Screen& screen) {
    last_pointer_ = pointer;
    if (locked) return;
    if (gesture_ && modal_) {
        gesture_->update(pointer, screen);
        return finish();
    }
    if (gesture_) return;
    const std::optional<Vec3> gizmo = gizmo_place();
    const std::vector<Hit> under = hits(pointer, screen);
    Hit hit = under.empty() ? Hit{} : under.front();
    // What is selected and lies further back is what one means, after a click has reached it.
    for (const Hit& other : under)
        if (other.same_thing(last_click_) && (pointer.pixel - last_click_at_).norm() < drag_begins)
            hit = other;
    pressed_ = Press{pointer, hit, gizmo ? gizmo_at(screen, *gizmo, pointer.pixel) : std::nullopt};
}

void Interaction::move(const Pointer& pointer, const Screen& screen) {
    last_pointer_ = pointer;
    inside_ = true;
    if (pressed_ && !gesture_) {
        if ((pointer.pixel - pressed_->pointer.pixel).norm() < drag_begins) return;
        gesture_ = begin_drag(model_, tool, snap_to, *pressed_, screen);
        modal_ = false;
        hovered_ = {};
    }
    gesture_ ? gesture_->update(pointer, screen) : hover(pointer, screen);
}

void Interaction::release(const Pointer& pointer, const Screen& screen) {
    last_pointer_ = pointer;
    if (!pressed_) return;
    if (gesture_ && !modal_) {
        gesture_->update(pointer, screen);
        finish();
    } else if (!gesture_) {
        click(pointer, screen);
    }
    pressed_.reset();
    if (!gesture_) move(pointer, screen);
}

void Interaction::leave() {
    inside_ = false;
    if (!gesture_) hovered_ = {};
    hovered_handle_.reset();
}

void Interaction::hover(const Pointer& pointer, const Screen& screen) {
    stale_ = false;
    const std::vector<Hit> under = hits(pointer, screen);
    hovered_ = under.empty() ? Hit{} : under.front();
    const std::optional<Vec3> gizmo = gizmo_place();
    hovered_handle_ = gizmo ? gizmo_at(screen, *gizmo, pointer.pixel) : std::nullopt;
}

bool Interaction::look_again(const Screen& screen) {
    if (!stale_ || !inside_ || gesture_) return false;
    hover(last_pointer_, screen);
    return true;
}

bool Interaction::start(Modal modal, const Pointer& pointer, const Screen& screen) {
    if (gesture_ || locked || model_.selection().active < 0) return false;
    gesture_ = begin_modal(model_, modal, snap_to, Pointer{pointer.pixel}, screen);
    modal_ = true;
    pressed_.reset();
    last_pointer_ = pointer;
    hovered_ = {};
    return true;
}

void Interaction::finish() {
    if (!gesture_) return;
    // Out of sight first: what observers see of the last change is no longer in the making.
    const std::unique_ptr<Gesture> done = std::move(gesture_);
    typed_.clear();
    pressed_.reset();
    done->finish();
}

void Interaction::cancel() {
    pressed_.reset();
    if (!gesture_) return;
    const std::unique_ptr<Gesture> done = std::move(gesture_);
    typed_.clear();
    done->cancel();
}

void Interaction::click(const Pointer& pointer, const Screen& screen) {
    const std::vector<Hit> under = hits(pointer, screen);
    const bool again = (pointer.pixel - last_click_at_).norm() < drag_begins && last_click_;
    Hit hit = under.empty() ? Hit{} : under.front();
    if (again && !pointer.shift) hit = behind(under, last_click_);
    last_click_ = hit;
    last_click_at_ = pointer.pixel;
    if (hit) return select_hit(hit, pointer.shift);
    if (model_.document().nodes.empty() && tool == Tool::draw) {
        const Vec3 normal = screen.forward(Vec3::Zero());
        const Vec3 place = meet_plane(screen.ray(pointer.pixel), Vec3::Zero(), normal).value_or(Vec3::Zero());
        Edited edit = add_root(model_.document(), onto_symmetry(model_.document().symmetry, place),
                               40 * screen.pixel_length(place));
        return model_.apply("Add root", std::move(edit.document), std::move(edit.selection));
    }
    if (!pointer.shift) model_.select({});
}

void Interaction::select_hit(const Hit& hit, bool add) {
    if (hit.kind == Hit::Kind::node)
        return model_.select(add ? toggled(model_.selection(), hit.index) : selection_of(hit.index));
    const Selection ends = selection_of(bones_of(model_.document())[hit.index]);
    model_.select(add ? united(model_.selection(), ends) : ends);
}

bool Interaction::wheel(const Pointer& pointer, const Screen& screen, double notches) {
    if (gesture_ || locked) return false;
    const Hit hit = hit_at(model_.document(), glyphs(), screen, pointer.pixel);
    if (hit.kind != Hit::Kind::node) return false;
    const Selection nodes = grabbed(model_, hit);
    model_.apply("Radius", scale_radii(model_.document(), nodes.nodes, std::pow(wheel_factor, notches)),
                 nodes, wheel_key);
    return true;
}

bool Interaction::type(char key, const Screen& screen) {
    if (!gesture_) return false;
    const std::size_t axis = std::string_view("xyzXYZ").find(key);
    if (axis != std::string_view::npos) {
        if (!gesture_->lock({static_cast<int>(axis % 3), axis >= 3})) return false;
        gesture_->update(last_pointer_, screen);
        return true;
    }
    if (key == '\b' && typed_.empty()) return false;
    if (key == '\b')
        typed_.pop_back();
    else if (key == '-')
        typed_.starts_with('-') ? typed_.erase(0, 1) : typed_.insert(0, 1, '-');
    else if (std::string_view("0123456789.").find(key) != std::string_view::npos)
        typed_ += key;
    else
        return false;
    apply_amount(screen);
    return true;
}

void Interaction::apply_amount(const Screen& screen) {
    double amount = 0;
    const auto [end, error] = std::from_chars(typed_.data(), typed_.data() + typed_.size(), amount);
    const bool understood = error == std::errc() && end == typed_.data() + typed_.size();
    if (gesture_->set_amount(understood ? std::optional(amount) : std::nullopt))
        gesture_->update(last_pointer_, screen);
}

std::string Interaction::keys() const {
    if (!gesture_) return "";
    return (modal_ ? "Click or Enter keeps it; " : "") + gesture_->keys();
}

std::string Interaction::hint() const {
    if (!gesture_) return "";
    return gesture_->hint() + (typed_.empty() ? "" : "  = " + typed_);
}

}  // namespace sinew::modeler
