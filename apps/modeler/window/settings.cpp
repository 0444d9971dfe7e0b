#include "window/settings.h"

#include <QSettings>
#include <algorithm>

namespace sinew::modeler {

void load_view_settings(ViewSettings& view) {
    const QSettings settings;
    const ViewSettings start = view;
    auto flag = [&](const char* name, bool otherwise) { return settings.value(name, otherwise).toBool(); };
    view.level = std::clamp(settings.value("view/level", start.level).toInt(), 0, most_levels);
    view.shading = static_cast<Shading>(
        std::clamp(settings.value("view/shading", static_cast<int>(start.shading)).toInt(), 0, 2));
    view.opacity = std::clamp(settings.value("view/opacity", start.opacity).toDouble(), 0.1, 1.0);
    view.wire = flag("view/wire", start.wire);
    view.irregular = flag("view/irregular", start.irregular);
    view.creases = flag("view/creases", start.creases);
    view.grid = flag("view/grid", start.grid);
    view.names = flag("view/names", start.names);
}

void save_view_settings(const ViewSettings& view) {
    QSettings settings;
    settings.setValue("view/level", view.level);
    settings.setValue("view/shading", static_cast<int>(view.shading));
    settings.setValue("view/opacity", view.opacity);
    settings.setValue("view/wire", view.wire);
    settings.setValue("view/irregular", view.irregular);
    settings.setValue("view/creases", view.creases);
    settings.setValue("view/grid", view.grid);
    settings.setValue("view/names", view.names);
}

}  // namespace sinew::modeler
