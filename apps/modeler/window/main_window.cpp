#include "window/main_window.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QFileInfo>
#include <QImageReader>
#include <QMenuBar>
#include <QMimeData>
#include <QSettings>
#include <QStandardPaths>
#include <QStatusBar>
#include <QToolBar>
#include <QUndoView>

#include "document/edits.h"
#include "look/icons.h"
#include "panels/outliner.h"
#include "panels/problems.h"
#include "panels/properties.h"
#include "panels/statistics.h"
#include "viewport/viewport.h"
#include "window/action_set.h"
#include "window/command_palette.h"
#include "window/settings.h"
#include "window/status_line.h"
#include "window/view_bar.h"
#include "window/window_host.h"

namespace sinew::modeler {
namespace {

constexpr int copy_after = 1500;  ///< milliseconds without a change

}  // namespace

std::filesystem::path recovery_folder() {
    return (QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/recovery")
        .toStdString();
}

MainWindow::MainWindow()
    : viewport_(new Viewport(model_, tools_, view_)),
      files_(model_, *this),
      recovery_(recovery_folder()),
      host_(std::make_unique<WindowHost>(*this)),
      context_(std::make_unique<Context>(Context{model_, tools_, view_, *host_})) {
    setWindowIcon(icon("sinew-modeler"));
    setAcceptDrops(true);
    setDockNestingEnabled(true);
    setCentralWidget(viewport_);
    load_view_settings(view_);
    action_set_ = std::make_unique<ActionSet>(*context_, *this, [this] { refresh(); });
    meshes_ = std::make_unique<MeshKeeper>(model_, view_, [this](const auto& mesh) { show_mesh(mesh); });
    make_panels();
    make_bars();
    status_ = std::make_unique<StatusLine>(*statusBar(), *action_set_);
    palette_ = new CommandPalette(*action_set_, *this);
    connect_parts();
    load_settings();
}

MainWindow::~MainWindow() {
    meshes_.reset();
    // Panels listen to the model and must not hear of its end.
    delete viewport_;
    qDeleteAll(findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly));
}

QDockWidget* MainWindow::add_panel(const QString& title, QWidget* widget, Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName("panel_" + title.toLower());
    dock->setWidget(widget);
    addDockWidget(area, dock);
    panels_.append(dock);
    return dock;
}

void MainWindow::make_panels() {
    outliner_ = new Outliner(model_);
    statistics_ = new Statistics(model_);
    problems_ = new Problems(model_);
    auto* steps = new QUndoView(&model_.history());
    steps->setObjectName("history");
    steps->setEmptyLabel("As opened");
    add_panel("Outliner", outliner_, Qt::LeftDockWidgetArea);
    QDockWidget* history = add_panel("History", steps, Qt::LeftDockWidgetArea);
    add_panel("Properties", new Properties(model_), Qt::RightDockWidgetArea);
    QDockWidget* figures = add_panel("Statistics", statistics_, Qt::RightDockWidgetArea);
    problems_dock_ = add_panel("Problems", problems_, Qt::RightDockWidgetArea);
    tabifyDockWidget(figures, problems_dock_);
    figures->raise();
    resizeDocks({findChild<QDockWidget*>("panel_outliner"), history}, {560, 240}, Qt::Vertical);
    resizeDocks({findChild<QDockWidget*>("panel_properties"), figures}, {560, 280}, Qt::Vertical);
    resizeDocks({history, figures}, {220, 290}, Qt::Horizontal);
    problems_->counted = [this](int count) {
        problems_dock_->setWindowTitle(count > 0 ? QString("Problems (%1)").arg(count) : "Problems");
    };
}

void MainWindow::make_bars() {
    action_set_->fill(*menuBar());
    QToolBar* bar = addToolBar("Tools");
    bar->setObjectName("toolbar");
    bar->setMovable(false);
    bar->setIconSize(QSize(22, 22));
    action_set_->fill(*bar);
    view_bar_ = std::make_unique<ViewBar>(*bar, *action_set_, view_, [this] { refresh(); });
    recent_ = new QMenu("Open recent", this);
    QMenu* file = action_set_->menu(Menu::file);
    file->insertMenu(action_set_->find("file.save"), recent_);
    connect(recent_, &QMenu::aboutToShow, this, [this] { refresh_recent(); });
    QMenu* panels = action_set_->menu(Menu::view)->addMenu("Panels");
    for (QDockWidget* dock : panels_) panels->addAction(dock->toggleViewAction());
}

void MainWindow::connect_parts() {
    host_->palette_wanted = [this] { palette_->open(); };
    host_->rename_wanted = [this] { outliner_->rename_active(); };
    files_.changed = [this] {
        meshes_->set_repair(files_.measured());
        problems_->show_reading(files_.warnings());
        if (!model_.modified()) recovery_.drop();
        refresh();
    };
    files_.message = [this](const QString& text) { statusBar()->showMessage(text, 6000); };
    viewport_->changed = [this] { refresh(); };
    viewport_->context_menu_wanted = [this](const QPoint& at) {
        const Hit& hit = tools_.hovered();
        if (hit.kind == Hit::Kind::node && !model_.selection().contains(hit.index))
            model_.select(selection_of(hit.index));
        QMenu menu(this);
        menu.setObjectName("context_menu");
        action_set_->fill_context_menu(menu);
        menu.exec(at);
    };
    viewport_->failed = [this](const QString& text) {
        statusBar()->showMessage("Nothing can be drawn: " + text);
    };
    copy_timer_.setSingleShot(true);
    copy_timer_.setInterval(copy_after);
    connect(&copy_timer_, &QTimer::timeout, this, [this] { keep_copy(); });
    model_.observe([this](const Changes& changes) {
        if (changes.document && !copy_timer_.isActive()) copy_timer_.start();
        refresh();
    });
    connect(&model_.history(), &QUndoStack::cleanChanged, this, [this] { refresh(); });
}

void MainWindow::start(const QString& path) {
    model_.replace(starting_document(), true);
    model_.select(selection_of(0));
    const bool recovered = files_.offer_recovery(recovery_);
    if (!recovered && !path.isEmpty()) open_dropped(path);
    host_->frame(true);
    refresh();
}

void MainWindow::show_mesh(const std::shared_ptr<const LiveMesh>& mesh) {
    viewport_->show_mesh(mesh);
    statistics_->show_mesh(mesh);
    problems_->show_mesh(mesh);
    refresh();
}

void MainWindow::refresh() {
    if (!meshes_ || !status_) return;
    meshes_->refresh();
    action_set_->refresh();
    view_bar_->refresh();
    viewport_->update();
    status_->show(model_, tools_, view_, *meshes_);
    refresh_title();
}

void MainWindow::refresh_title() {
    setWindowTitle(QString("%1[*] - Skeleton Modeler").arg(files_.name()));
    setWindowModified(model_.modified());
    setWindowFilePath(files_.path());
}

void MainWindow::refresh_recent() {
    recent_->clear();
    for (const QString& path : FileKeeper::recent())
        recent_->addAction(QFileInfo(path).fileName() + "    " + QFileInfo(path).path(), this, [this, path] {
            if (files_.open(path)) host_->frame(true);
        });
    if (recent_->isEmpty()) recent_->addAction("None yet")->setEnabled(false);
}

void MainWindow::keep_copy() {
    if (!model_.modified() && !model_.previewing()) return recovery_.drop();
    if (auto kept = recovery_.keep(model_.before_drag(), files_.path().toStdString()); !kept)
        statusBar()->showMessage("No copy for a crash: " + QString::fromStdString(kept.error().text()), 6000);
    if (model_.previewing()) copy_timer_.start();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    host_->stop_growing();
    if (!files_.may_close()) return event->ignore();
    copy_timer_.stop();
    recovery_.drop();
    save_settings();
    event->accept();
}

void MainWindow::put_over_properties(QDockWidget& panel) {
    auto* properties = findChild<QDockWidget*>("panel_properties");
    addDockWidget(Qt::RightDockWidgetArea, &panel);
    if (properties->isVisible() && !properties->isFloating()) tabifyDockWidget(properties, &panel);
    panel.show();
    panel.raise();
}

void MainWindow::lock(bool locked) {
    tools_.locked = locked;
    action_set_->lock(locked);
    setAcceptDrops(!locked);
    for (QDockWidget* dock : panels_)
        if (dock->widget() != statistics_) dock->widget()->setEnabled(!locked);
    recent_->setEnabled(!locked);
    refresh();
}

void MainWindow::open_dropped(const QString& path) {
    const QString ending = QFileInfo(path).suffix().toLower();
    if (ending == "lsys") return host_->grow_file(path);
    if (QImageReader::supportedImageFormats().contains(ending.toLatin1())) return host_->draw_after(path);
    if (files_.open(path)) host_->frame(true);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QString path = event->mimeData()->urls().value(0).toLocalFile();
    if (path.isEmpty()) return;
    event->acceptProposedAction();
    // A question may come up: not while the program that one dragged from waits.
    QMetaObject::invokeMethod(
        this, [this, path] { open_dropped(path); }, Qt::QueuedConnection);
}

void MainWindow::load_settings() {
    resize(1440, 900);
    const QSettings settings;
    restoreGeometry(settings.value("window/geometry").toByteArray());
    restoreState(settings.value("window/state").toByteArray());
}

void MainWindow::save_settings() {
    QSettings settings;
    settings.setValue("window/geometry", saveGeometry());
    settings.setValue("window/state", saveState());
    save_view_settings(view_);
}

}  // namespace sinew::modeler
