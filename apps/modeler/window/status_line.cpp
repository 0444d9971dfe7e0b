#include "window/status_line.h"

#include <QAction>
#include <QLabel>
#include <QMenu>
#include <QStatusBar>
#include <QToolButton>

#include "document/images.h"
#include "look/theme.h"
#include "window/action_set.h"
#include "window/mesh_keeper.h"

namespace sinew::modeler {
namespace {

QLabel* add_label(QStatusBar& bar, const char* name) {
    auto* label = new QLabel;
    label->setObjectName(name);
    bar.addPermanentWidget(label);
    return label;
}

QString describe_mesh(const ViewSettings& view, const MeshKeeper& meshes) {
    const auto& mesh = meshes.mesh();
    if (!view.live) return "mesh off";
    if (mesh && mesh->error && mesh->error->kind != ErrorKind::cancelled)
        return QString("<span style='color:%1'>no mesh: see Problems</span>").arg(theme::error.name());
    return meshes.up_to_date() ? QString("level %1").arg(view.level) : "skinning...";
}

}  // namespace

StatusLine::StatusLine(QStatusBar& bar, const ActionSet& actions)
    : hint_(new QLabel), symmetry_(new QToolButton) {
    bar.setSizeGripEnabled(false);
    hint_->setObjectName("hint");
    // What is said must not make the window wider.
    hint_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    bar.addWidget(hint_, 1);
    selected_ = add_label(bar, "selected");
    symmetry_->setObjectName("symmetry");
    symmetry_->setToolTip("Symmetry: click for others");
    symmetry_->setPopupMode(QToolButton::InstantPopup);
    symmetry_->setFocusPolicy(Qt::NoFocus);
    auto* choices = new QMenu(symmetry_);
    for (const Action& action : sinew::modeler::actions())
        if (std::string_view(action.id).starts_with("symmetry.")) choices->addAction(actions.find(action.id));
    symmetry_->setMenu(choices);
    bar.addPermanentWidget(symmetry_);
    mesh_ = add_label(bar, "mesh_state");
}

void StatusLine::show(const Model& model, const Interaction& tools, const ViewSettings& view,
                      const MeshKeeper& meshes) {
    hint_->setText(QString::fromStdString(describe_pointer(tools)));
    const std::size_t count = model.selection().nodes.size();
    selected_->setText(
        count == 0 ? QString() : QString("%1 of %2 selected").arg(count).arg(model.document().nodes.size()));
    symmetry_->setText(QString::fromStdString(describe(model.document().symmetry)));
    const bool on = model.document().symmetry.kind != Symmetry::Kind::none;
    const QString style = on ? "color: " + theme::fine.name() : QString();
    if (symmetry_->styleSheet() != style) symmetry_->setStyleSheet(style);
    symmetry_->setEnabled(!tools.locked);
    mesh_->setText(describe_mesh(view, meshes));
}

std::string describe_pointer(const Interaction& tools) {
    if (tools.locked)
        return "Turn the figures at the right: Grow keeps what you see, Esc leaves all as it was";
    if (tools.active()) return tools.keys();
    const Hit::Kind over = tools.hovered().kind;
    if (tools.hovered_handle())
        return tools.hovered_handle()->plane ? "Drag to move across the axis"
                                             : "Drag to move along the arrow";
    if (over == Hit::Kind::nothing)
        return "Drag for a box; middle button or Alt orbits, Shift pans, wheel zooms";
    const bool node = over == Hit::Kind::node;
    switch (tools.tool) {
        case Tool::draw:
            return node ? "Drag for a child; Shift-drag: move; Ctrl-drag or wheel: radius; right click: more"
                        : "Drag to insert a node; Shift-drag: move the bone; click: select its ends";
        case Tool::move:
            return node ? "Drag to move; Ctrl-drag or wheel: radius; Shift-click adds to the selection"
                        : "Drag to move the bone; click: select its ends";
        default:
            return node ? "Drag to change the radius, of all that is selected" : "Drag to move the bone";
    }
}

}  // namespace sinew::modeler
