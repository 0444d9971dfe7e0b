#include "window/view_bar.h"

#include <QSlider>
#include <QToolBar>
#include <cmath>

#include "window/action_set.h"

namespace sinew::modeler {
namespace {

constexpr int least_opacity = 5;  ///< per cent

QString submenu_of(const Action& action) {
    const QString name = action.name;
    return name.contains(" > ") ? name.section(" > ", 0, 0) : QString();
}

}  // namespace

ViewBar::ViewBar(QToolBar& bar, ActionSet& actions, ViewSettings& view, std::function<void()> changed)
    : view_(view), opacity_(new QSlider(Qt::Horizontal)) {
    auto* room = new QWidget;
    room->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar.addWidget(room);
    QString submenu;
    for (const Action& action : sinew::modeler::actions()) {
        if (action.menu != Menu::view || !action.in_toolbar) continue;
        if (submenu_of(action) != submenu) bar.addSeparator();
        submenu = submenu_of(action);
        bar.addAction(actions.find(action.id));
        // Six digits in a row are one control.
        bar.widgetForAction(actions.find(action.id))->setProperty("narrow", submenu == "Level");
    }
    opacity_->setObjectName("opacity");
    opacity_->setRange(least_opacity, 100);
    opacity_->setFixedWidth(96);
    opacity_->setFocusPolicy(Qt::NoFocus);
    opacity_->setToolTip("Opacity of the mesh: lower, and the bones are seen inside");
    bar.addWidget(opacity_);
    QObject::connect(opacity_, &QSlider::valueChanged, opacity_,
                     [this, changed = std::move(changed)](int percent) {
                         if (percent == std::lround(100 * view_.opacity)) return;
                         view_.opacity = percent / 100.0;
                         changed();
                     });
    refresh();
}

void ViewBar::refresh() { opacity_->setValue(static_cast<int>(std::lround(100 * view_.opacity))); }

}  // namespace sinew::modeler
