#include "window/window_host.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>
#include <QStatusBar>

#include "document/edits.h"
#include "document/model.h"
#include "document/view_settings.h"
#include "sinew/skeleton/graph.h"
#include "tools/interaction.h"
#include "viewport/navigation.h"
#include "viewport/view_grid.h"
#include "viewport/viewport.h"
#include "window/adjust_panel.h"
#include "window/dialogs.h"
#include "window/export_dialog.h"
#include "window/file_keeper.h"
#include "window/grow_panel.h"
#include "window/mesh_keeper.h"
#include "window/reference_dialog.h"
#include "window/shortcut_sheet.h"
#include "window/type_menu.h"
#include "window/window_parts.h"

namespace sinew::modeler {
namespace {

/// The bones that a new node goes on: between selected nodes; that to the parent, for one node alone.
std::vector<std::int32_t> bones_of_selection(const Document& document, const Selection& selection) {
    std::vector<std::int32_t> found;
    const std::vector<Bone> bones = bones_of(document);
    for (std::int32_t b = 0; b < std::ssize(bones); ++b) {
        const bool between = selection.contains(bones[b][0]) && selection.contains(bones[b][1]);
        const bool to_parent = selection.nodes.size() == 1 && bones[b][1] == selection.active &&
                               document.nodes[selection.active].parent == bones[b][0];
        if (between || to_parent) found.push_back(b);
    }
    return found;
}

}  // namespace

WindowHost::WindowHost(WindowParts& window) : window_(window) {}

void WindowHost::new_document() {
    if (window_.files().new_document()) frame(true);
}

void WindowHost::open() {
    if (window_.files().open()) frame(true);
}

bool WindowHost::save() { return window_.files().save(); }

bool WindowHost::save_as() { return window_.files().save_as(); }

void WindowHost::import() {
    if (window_.files().import()) frame(true);
}

void WindowHost::export_mesh() {
    const QString written = sinew::modeler::export_mesh(&window_, window_.model().document(),
                                                        window_.meshes().options(), window_.files().path());
    if (!written.isEmpty()) message("Exported " + QFileInfo(written).fileName().toStdString());
}

QString WindowHost::ask_grammar() {
    QFileDialog dialog(&window_, "Choose an L-system", QSettings().value("grow/folder").toString(),
                       "L-systems (*.lsys);;All files (*)");
    dialog.setObjectName("grow_file");
    dialog.setFileMode(QFileDialog::ExistingFile);
    if (dialog.exec() != QDialog::Accepted) return {};
    const QString path = dialog.selectedFiles().value(0);
    QSettings().setValue("grow/folder", QFileInfo(path).absolutePath());
    return path;
}

void WindowHost::grow() {
    const QString path = ask_grammar();
    if (!path.isEmpty()) grow_file(path);
}

void WindowHost::grow_file(const QString& path) {
    if (growing_) return;
    window_.tools().cancel();
    auto* panel = new GrowPanel(window_.model(), &window_);
    if (!panel->read(path)) {
        delete panel;
        return;
    }
    growing_ = panel;
    panel->first_grown = [this] { frame(true); };
    panel->choose = [this, panel] {
        const QString other = ask_grammar();
        if (!other.isEmpty()) panel->read(other);
    };
    panel->finished = [this] {
        growing_.clear();
        window_.lock(false);
        window_.viewport().setFocus();
        frame(true);
    };
    window_.lock(true);
    window_.put_over_properties(*panel);
}

void WindowHost::stop_growing() {
    if (growing_) growing_->finish(false);
}

void WindowHost::reference_pictures() {
    ReferenceDialog dialog(window_.model(), &window_);
    // Below the middle, so that what one places is seen.
    const QPoint corner = window_.viewport().mapToGlobal(QPoint(0, window_.viewport().height()));
    dialog.adjustSize();
    dialog.move(corner.x() + (window_.viewport().width() - dialog.width()) / 2,
                corner.y() - dialog.height() - 24);
    dialog.exec();
}

void WindowHost::draw_after(const QString& picture) {
    const int seen = axis_seen_along(window_.viewport().camera());
    if (seen < 0) look_from(StandardView::front);
    const bool read = set_reference(window_.model(), seen < 0 ? 1 : seen, picture);
    message(QFileInfo(picture).fileName().toStdString() +
            (read ? " is a reference picture now; File has its height and place" : " cannot be read"));
}

void WindowHost::quit() { window_.close(); }

void WindowHost::start(Modal modal) { window_.viewport().start(modal); }

void WindowHost::insert_node() {
    Model& model = window_.model();
    const Hit& hit = window_.tools().hovered();
    if (hit.kind == Hit::Kind::bone) {
        Edited edit = insert_on_bone(model.document(), hit.index, hit.along);
        return model.apply("Insert", std::move(edit.document), std::move(edit.selection));
    }
    const std::vector<std::int32_t> bones = bones_of_selection(model.document(), model.selection());
    if (bones.empty()) return message("Point at a bone, or select a node below one");
    Edited edit = insert_on_bones(model.document(), bones);
    model.apply("Insert", std::move(edit.document), std::move(edit.selection));
}

void WindowHost::rename_active() {
    if (rename_wanted) rename_wanted();
}

void WindowHost::perform(Operation operation) {
    if (!adjust_panel_)
        adjust_panel_ = new AdjustPanel(window_.model(), window_.viewport(),
                                        [this](const std::string& text) { message(text); });
    adjust_panel_->perform(std::move(operation));
}

void WindowHost::edit_radial_symmetry() {
    const auto wanted = ask_radial_symmetry(&window_, window_.model().document().symmetry);
    if (!wanted) return;
    Document next = window_.model().document();
    next.symmetry = *wanted;
    window_.model().apply("Symmetry", std::move(next));
}

void WindowHost::type_menu() {
    if (!type_menu_)
        type_menu_ = new TypeMenu(&window_.viewport(), [this](NodeType type) {
            constexpr const char* ids[] = {"type.sphere", "type.cone",     "type.hemisphere",
                                           "type.cube",   "type.negative", "type.ball"};
            Context context{window_.model(), window_.tools(), window_.view(), *this};
            find_action(ids[static_cast<int>(type)])->run(context);
        });
    const Vec2 at = window_.viewport().pointer().pixel;
    type_menu_->open(QPoint(static_cast<int>(at.x()), static_cast<int>(at.y())));
}

void WindowHost::look_from(StandardView view) {
    window_.viewport().set_camera(looking(window_.viewport().camera(), view));
}

void WindowHost::toggle_perspective() {
    Camera camera = window_.viewport().camera();
    const bool perspective = camera.projection == Projection::perspective;
    camera.projection = perspective ? Projection::orthographic : Projection::perspective;
    window_.viewport().set_camera(camera);
}

void WindowHost::frame(bool all) {
    const Model& model = window_.model();
    const Selection nodes =
        all || model.selection().empty() ? all_nodes(model.document()) : model.selection();
    Bounds box = bounds_of(model.document(), nodes.nodes);
    const Vec2 size(window_.viewport().width(), window_.viewport().height());
    // A single node fills the view poorly: leave room to draw in.
    if (!box.isEmpty() && nodes.nodes.size() == 1) {
        const Vec3f middle = box.center(), half = 3 * (box.max() - middle);
        box = Bounds(Vec3f(middle - half), Vec3f(middle + half));
    }
    window_.viewport().set_camera(framed(window_.viewport().camera(), box, size));
}

void WindowHost::command_palette() {
    if (palette_wanted) palette_wanted();
}

void WindowHost::shortcut_sheet() { ShortcutSheet(&window_).exec(); }

void WindowHost::about() { show_about(&window_); }

void WindowHost::message(const std::string& text) {
    window_.statusBar()->showMessage(QString::fromStdString(text), 6000);
}

}  // namespace sinew::modeler
