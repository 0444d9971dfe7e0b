#include "actions/choices.h"
#include "actions/enabled.h"

namespace sinew::modeler {
namespace {

template <int level>
void set_level(Context& c) {
    c.view.level = level;
    c.view.live = true;
}
void flip_xray(Context& c) { c.view.opacity = c.view.opacity < 1 ? 1 : see_through; }

template <StandardView view>
void look(Context& c) {
    c.host.look_from(view);
}

const Action view_table[] = {
    {"view.live", "Live mesh", "Space",
     "Skins the skeleton, and again after every edit; off: the bones alone", Menu::view,
     flip<&ViewSettings::live>, nullptr, is_on<&ViewSettings::live>, false, true, true},
    {"view.level0", "Level > Control mesh", "0", "Shows the mesh without subdivision", Menu::view,
     set_level<0>, nullptr, is_chosen<&ViewSettings::level, 0>, false, true},
    {"view.level1", "Level > 1", "1", "Subdivides once", Menu::view, set_level<1>, nullptr,
     is_chosen<&ViewSettings::level, 1>, false, true},
    {"view.level2", "Level > 2", "2", "Subdivides twice", Menu::view, set_level<2>, nullptr,
     is_chosen<&ViewSettings::level, 2>, false, true},
    {"view.level3", "Level > 3", "3", "Subdivides three times", Menu::view, set_level<3>, nullptr,
     is_chosen<&ViewSettings::level, 3>, false, true},
    {"view.level4", "Level > 4", "4", "Subdivides four times", Menu::view, set_level<4>, nullptr,
     is_chosen<&ViewSettings::level, 4>, false, true},
    {"view.level5", "Level > 5", "5", "Subdivides five times", Menu::view, set_level<5>, nullptr,
     is_chosen<&ViewSettings::level, 5>, false, true},
    {"view.lit", "Shading > Lit", "Alt+1", "Soft light", Menu::view,
     choose<&ViewSettings::shading, Shading::lit>, nullptr, is_chosen<&ViewSettings::shading, Shading::lit>,
     false, true},
    {"view.matcap", "Shading > Matcap", "Alt+2", "Shows form and nothing else", Menu::view,
     choose<&ViewSettings::shading, Shading::matcap>, nullptr,
     is_chosen<&ViewSettings::shading, Shading::matcap>, false, true},
    {"view.flat", "Shading > Flat", "Alt+3", "Every face on its own", Menu::view,
     choose<&ViewSettings::shading, Shading::flat>, nullptr, is_chosen<&ViewSettings::shading, Shading::flat>,
     false, true},
    {"view.wire", "Wireframe", "W", "Draws the edges of the faces", Menu::view, flip<&ViewSettings::wire>,
     nullptr, is_on<&ViewSettings::wire>, true, true},
    {"view.irregular", "Irregular vertices", "Alt+I", "Marks vertices where not four edges meet, and poles",
     Menu::view, flip<&ViewSettings::irregular>, nullptr, is_on<&ViewSettings::irregular>, false, true},
    {"view.creases", "Creases", "Alt+C", "Marks edges that stay sharp", Menu::view,
     flip<&ViewSettings::creases>, nullptr, is_on<&ViewSettings::creases>, false, true},
    {"view.bones", "Bones", "Alt+B", "Shows nodes and bones", Menu::view, flip<&ViewSettings::bones>, nullptr,
     is_on<&ViewSettings::bones>, false, true},
    {"view.names", "Names", "Alt+N", "Writes the names of nodes beside them", Menu::view,
     flip<&ViewSettings::names>, nullptr, is_on<&ViewSettings::names>},
    {"view.grid", "Grid", "Alt+G", "Draws the ground, and what Ctrl snaps to in views along an axis",
     Menu::view, flip<&ViewSettings::grid>, nullptr, is_on<&ViewSettings::grid>, false, true},
    {"view.xray", "See through", "Alt+X", "Lets the bones be seen inside the mesh", Menu::view, flip_xray,
     nullptr, [](const Context& c) { return c.view.opacity < 1; }, false, true},
    {"view.frame", "Frame selection", "F", "Brings the selection into the middle of the view", Menu::view,
     [](Context& c) { c.host.frame(false); }, any_node, nullptr, true, false, true},
    {"view.frame_all", "Frame all", "Home", "Brings everything into the view", Menu::view,
     [](Context& c) { c.host.frame(true); }},
    {"view.front", "From > Front", "Num+1", "Looks along +y", Menu::view, look<StandardView::front>},
    {"view.right", "From > Right", "Num+3", "Looks along -x", Menu::view, look<StandardView::right>},
    {"view.top", "From > Top", "Num+7", "Looks down", Menu::view, look<StandardView::top>},
    {"view.back", "From > Back", "Ctrl+Num+1", "Looks along -y", Menu::view, look<StandardView::back>},
    {"view.left", "From > Left", "Ctrl+Num+3", "Looks along +x", Menu::view, look<StandardView::left>},
    {"view.bottom", "From > Bottom", "Ctrl+Num+7", "Looks up", Menu::view, look<StandardView::bottom>},
    {"view.perspective", "Perspective", "Num+5 | P", "Perspective or parallel lines that stay parallel",
     Menu::view, [](Context& c) { c.host.toggle_perspective(); }},
};

}  // namespace

std::span<const Action> view_actions() { return view_table; }

}  // namespace sinew::modeler
