/// @file interaction.h
/// From pointer events to gestures: which one a press, a drag or a key begins, and when it ends.
///
/// @verbatim
/// idle --press--> pressed --drag far enough--> dragging --release--> idle
///                 pressed --release: a click-----------------------> idle
/// idle --key----> following (no button held) --click---------------> idle
/// @endverbatim
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "tools/begin_gesture.h"

namespace sinew::modeler {

/// Lives as long as the model, which it observes: what changes the document while a gesture runs (a menu, a
/// panel, the history) ends the gesture, and what was under the pointer is found again.
class Interaction {
  public:
    explicit Interaction(Model& model);
    Interaction(const Interaction&) = delete;

    Tool tool = Tool::draw;
    SnapTo snap_to = SnapTo::grid;
    double glyph_scale = 1;  ///< as drawn (see glyph.h)
    bool locked = false;     ///< nothing can be taken hold of

    void press(const Pointer& pointer, const Screen& screen);
    void move(const Pointer& pointer, const Screen& screen);
    void release(const Pointer& pointer, const Screen& screen);
    /// A notch of the wheel changes the radius of the node under the pointer.
    /// @return false where there is none
    bool wheel(const Pointer& pointer, const Screen& screen, double notches);
    /// The pointer left the window.
    void leave();
    /// Finds again what is under the pointer, where the document has changed since it moved.
    /// @return true if it looked
    bool look_again(const Screen& screen);

    /// @return false where it makes no sense now, such as linking with nothing selected
    bool start(Modal modal, const Pointer& pointer, const Screen& screen);

    /// @name While a gesture runs: keys first go here. False: not for us.
    /// @{
    bool type(char key, const Screen& screen);  ///< x, y, z (upper case: across), digits, '.', '-', '\b'
    void finish();
    void cancel();
    bool active() const { return gesture_ != nullptr; }
    /// @}

    const Hit& hovered() const { return hovered_; }
    const std::optional<AxisLock>& hovered_handle() const { return hovered_handle_; }
    /// Where the gizmo is; nothing where there is none.
    std::optional<Vec3> gizmo_place() const;
    const Glyphing& glyphs();
    std::string hint() const;  ///< of the gesture, in figures
    std::string keys() const;  ///< what keys and buttons do while it runs
    Guides guides() const { return gesture_ ? gesture_->guides() : Guides{}; }

  private:
    void changed_elsewhere();
    std::vector<Hit> hits(const Pointer& pointer, const Screen& screen);
    void hover(const Pointer& pointer, const Screen& screen);
    void click(const Pointer& pointer, const Screen& screen);
    void select_hit(const Hit& hit, bool add);
    void apply_amount(const Screen& screen);

    Model& model_;
    std::unique_ptr<Gesture> gesture_;
    bool modal_ = false;
    bool inside_ = false;  ///< the pointer is in the window
    bool stale_ = false;   ///< hovered_ was of a document that is gone
    std::optional<Press> pressed_;
    Pointer last_pointer_;
    Hit hovered_, last_click_;
    Vec2 last_click_at_{-1e9, -1e9};
    std::optional<AxisLock> hovered_handle_;
    std::string typed_;
    Glyphing glyphs_;
    std::uint64_t glyphs_revision_ = ~0ull;
    double glyphs_scale_ = 0;
};

}  // namespace sinew::modeler
