#include "actions/choices.h"
#include "actions/enabled.h"
#include "document/operation.h"

namespace sinew::modeler {
namespace {

void set_symmetry(Context& c, const Symmetry& symmetry) {
    Document next = c.model.document();
    next.symmetry = symmetry;
    c.model.apply("Symmetry", std::move(next));
}
template <int axis>
void mirror_at(Context& c) {
    set_symmetry(c, {Symmetry::Kind::mirror, axis, 1});
}
template <int axis>
bool mirrored_at(const Context& c) {
    const Symmetry& symmetry = c.model.document().symmetry;
    return symmetry.kind == Symmetry::Kind::mirror && symmetry.axis == axis;
}

const Action symmetry_table[] = {
    {"symmetry.none", "Symmetry > None", "", "What is drawn is all there is", Menu::skeleton,
     [](Context& c) { set_symmetry(c, {}); }, nullptr, [](const Context& c) { return !symmetric(c); }, true},
    {"symmetry.x", "Symmetry > Mirror X", "", "The left side is the mirror image of the right",
     Menu::skeleton, mirror_at<0>, nullptr, mirrored_at<0>},
    {"symmetry.y", "Symmetry > Mirror Y", "", "The front is the mirror image of the back", Menu::skeleton,
     mirror_at<1>, nullptr, mirrored_at<1>},
    {"symmetry.z", "Symmetry > Mirror Z", "", "Above is the mirror image of below", Menu::skeleton,
     mirror_at<2>, nullptr, mirrored_at<2>},
    {"symmetry.radial", "Symmetry > Radial...", "", "Images all round an axis", Menu::skeleton,
     [](Context& c) { c.host.edit_radial_symmetry(); }, nullptr,
     [](const Context& c) { return c.model.document().symmetry.kind == Symmetry::Kind::radial; }},
    {"symmetry.real", "Symmetry > Make real", "", "Images become nodes that can be changed one by one",
     Menu::skeleton, [](Context& c) { c.host.perform(making_symmetry_real(c.model.document())); }, symmetric},
    {"copy.mirror", "Copy > Mirror", "Ctrl+M", "Adds the mirror image, as nodes of its own", Menu::skeleton,
     [](Context& c) { c.host.perform(mirroring(c.model.document())); }, any_node},
    {"copy.radial", "Copy > Radial", "Ctrl+Shift+M", "Adds images all round an axis, as nodes of their own",
     Menu::skeleton, [](Context& c) { c.host.perform(copying_round(c.model.document())); }, any_node},
    {"snap.grid", "Ctrl snaps to > Grid", "", "Ctrl snaps to the grid while one drags", Menu::skeleton,
     choose<&Interaction::snap_to, SnapTo::grid>, nullptr, is_chosen<&Interaction::snap_to, SnapTo::grid>},
    {"snap.angle", "Ctrl snaps to > 15 degrees", "",
     "Ctrl snaps to angles while one drags (Ctrl+Shift always does)", Menu::skeleton,
     choose<&Interaction::snap_to, SnapTo::angle>, nullptr, is_chosen<&Interaction::snap_to, SnapTo::angle>},
};

}  // namespace

std::span<const Action> symmetry_actions() { return symmetry_table; }

}  // namespace sinew::modeler
