#include "robot.h"

#include <QApplication>
#include <QClipboard>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDir>
#include <QDropEvent>
#include <QFileDialog>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QScreen>
#include <QTest>
#include <QTimer>
#include <cstdlib>
#include <filesystem>

#include "few_colours.h"
#include "viewport/navigation.h"
#include "viewport/viewport.h"

namespace sinew::modeler {
namespace {

QString path_of(const std::string& name) {
    return QString(SCREENSHOT_FOLDER) + "/" + QString::fromStdString(name) + ".png";
}

}  // namespace

Robot::Robot(const QString& path) : window_(std::make_unique<MainWindow>()) {
    window_->resize(1440, 900);
    window_->show();
    window_->activateWindow();
    if (!QTest::qWaitForWindowActive(window_.get(), patience)) qWarning("the window does not become active");
    window_->start(path);
    window_->viewport().setFocus();
}

Robot::~Robot() { close_unsaved(); }

void Robot::close_unsaved() {
    if (!window_) return;
    window_->model().cancel();
    window_->model().mark_saved();
    window_->close();
    window_.reset();
}

void Robot::look_from_front() {
    key(Qt::Key_1, Qt::KeypadModifier);
    Camera camera = window_->viewport().camera();
    camera.target = Vec3::Zero();
    camera.distance *= 11 / visible_height(camera);
    window_->viewport().set_camera(camera);
}

QPoint Robot::pixel(const Vec3& at) {
    const std::optional<Vec2> p = window_->viewport().screen().project(at);
    return p ? QPoint(static_cast<int>(std::lround(p->x())), static_cast<int>(std::lround(p->y())))
             : QPoint(-1, -1);
}

void Robot::click(const Vec3& at, Qt::KeyboardModifiers held) {
    QTest::mouseMove(&window_->viewport(), pixel(at));
    QTest::mouseClick(&window_->viewport(), Qt::LeftButton, held, pixel(at));
}

void Robot::move(const Vec3& to, Qt::KeyboardModifiers) { QTest::mouseMove(&window_->viewport(), pixel(to)); }

void Robot::drag(const Vec3& from, const Vec3& to, Qt::KeyboardModifiers held) {
    Viewport& viewport = window_->viewport();
    const QPoint start = pixel(from), end = pixel(to);
    // Ctrl at the press would mean the radius: it is pressed on the way.
    QTest::mouseMove(&viewport, start);
    QTest::mousePress(&viewport, Qt::LeftButton, held & ~Qt::ControlModifier, start);
    for (int i = 1; i <= 4; ++i) QTest::mouseMove(&viewport, start + (end - start) * i / 4);
    QTest::mouseRelease(&viewport, Qt::LeftButton, held, end);
}

/// Shortcuts are those of the active window, and it takes a moment to become active again after a dialog.
void Robot::look_at_window() {
    if (QApplication::activeModalWidget() || QApplication::activePopupWidget() || !window_->isVisible())
        return;
    if (!window_->isActiveWindow()) window_->activateWindow();
    if (!wait([this] { return window_->isActiveWindow(); })) qWarning("the window is not active again");
}

void Robot::key(Qt::Key key, Qt::KeyboardModifiers held) {
    look_at_window();
    QWidget* target = QApplication::focusWidget();
    QTest::keyClick(target ? target : &window_->viewport(), key, held);
}

void Robot::type(const QString& text) {
    QWidget* target = QApplication::focusWidget();
    QTest::keyClicks(target ? target : &window_->viewport(), text);
}

bool Robot::wait(const std::function<bool()>& condition) { return QTest::qWaitFor(condition, patience); }

bool Robot::wait_for_mesh() {
    return wait([this] {
        const auto& mesh = window_->meshes().mesh();
        return window_->meshes().up_to_date() && (mesh->error || mesh->measures);
    });
}

void Robot::when_dialog(const QString& name, std::function<void(QDialog&)> then) {
    auto* timer = new QTimer(window_.get());
    QObject::connect(timer, &QTimer::timeout, window_.get(), [name, then, timer] {
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (!dialog || dialog->objectName() != name || !dialog->isActiveWindow()) return;
        timer->stop();
        timer->deleteLater();
        then(*dialog);
    });
    timer->start(20);
}

namespace {

void paste_path(QDialog& dialog, const QString& path) {
    auto* edit = dialog.findChild<QLineEdit*>("fileNameEdit");
    edit->setFocus();
    QApplication::clipboard()->setText(path);
    const auto* files = qobject_cast<QFileDialog*>(&dialog);
    // Pasted: the dialog selects each folder that one types on the way. Again, where the dialog has put the
    // name of the file it starts with in its place, once it has read the folder.
    const bool taken = Robot::wait([&] {
        if (edit->text() == path) return files->selectedFiles() == QStringList{path};
        edit->selectAll();
        QTest::keyClick(edit, Qt::Key_V, Qt::ControlModifier);
        return false;
    });
    if (!taken) qWarning("the dialog does not take the path");
    const auto role =
        files->acceptMode() == QFileDialog::AcceptSave ? QDialogButtonBox::Save : QDialogButtonBox::Open;
    QTest::mouseClick(dialog.findChild<QDialogButtonBox*>()->button(role), Qt::LeftButton);
}

}  // namespace

void Robot::when_asked_for_file(const QString& dialog, const QString& path) {
    when_dialog(dialog, [path](QDialog& asked) { paste_path(asked, path); });
}

void Robot::drop(const QString& path) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &enter);
    if (!enter.isAccepted()) return qWarning("the window does not take what is dragged");
    QDropEvent drop(QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &drop);
}

void Robot::command(const QString& name) {
    key(Qt::Key_K, Qt::ControlModifier);
    type(name);
    key(Qt::Key_Return);
}

void Robot::save_as(const QString& path) {
    when_asked_for_file("save_dialog", path);
    key(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
}

void Robot::open(const QString& path) {
    when_asked_for_file("open_dialog", path);
    key(Qt::Key_O, Qt::ControlModifier);
}

void Robot::screenshot(const std::string& name) {
    // What the screen shows: a grab of Qt's leaves out what is painted over the scene.
    bool drawn = false;
    const auto connection =
        QObject::connect(&window_->viewport(), &QOpenGLWidget::frameSwapped, [&drawn] { drawn = true; });
    window_->viewport().update();
    wait([&drawn] { return drawn; });
    QObject::disconnect(connection);
    QApplication::processEvents();
    QDir().mkpath(SCREENSHOT_FOLDER);
    const QImage image = window_->screen()->grabWindow(window_->winId()).toImage();
    // For the handbook as small as it can be.
    name.starts_with("guide-") ? in_few_colours(image).save(path_of(name), "PNG", 0)
                               : image.save(path_of(name));
}

void Robot::screenshot(QWidget& widget, const std::string& name) {
    QDir().mkpath(SCREENSHOT_FOLDER);
    widget.grab().save(path_of(name));
}

}  // namespace sinew::modeler
