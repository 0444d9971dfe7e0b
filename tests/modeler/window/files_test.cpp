// Files: saving and opening, dropping, exporting, and what is left after a crash.

#include <gmock/gmock.h>
#include <signal.h>

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QFile>
#include <QLineEdit>
#include <QProcess>
#include <QSpinBox>
#include <QTest>

#include "document/delta.h"
#include "document/edits.h"
#include "robot.h"
#include "sinew/io/mesh_formats.h"
#include "sinew/io/skeleton_formats.h"

namespace sinew::modeler {

/// What the child of the crash test does: draws, waits for the copy, and is gone.
int draw_and_crash() {
    Robot robot;
    robot.look_from_front();
    robot.drag({0, 0, 0}, {2, 0, 1}, Qt::ControlModifier);
    robot.drag({2, 0, 1}, {2, 0, 3}, Qt::ControlModifier);
    const bool kept = Robot::wait([] {
        for (const auto& entry : std::filesystem::directory_iterator(recovery_folder()))
            if (entry.path().extension() == ".sinew") return true;
        return false;
    });
    if (kept) raise(SIGKILL);
    return 3;
}

namespace {

QString path_in(const TemporaryFolder& folder, const char* name) {
    return QString::fromStdString(folder.file(name));
}

TEST(Files, what_is_saved_is_what_was_drawn) {
    const TemporaryFolder folder;
    const QString path = path_in(folder, "limb.sinew");
    Document drawn;
    {
        Robot robot;
        robot.look_from_front();
        robot.drag({0, 0, 0}, {2, 0, 1}, Qt::ControlModifier);
        EXPECT_TRUE(robot.window().isWindowModified());
        robot.save_as(path);
        EXPECT_FALSE(robot.window().isWindowModified());
        EXPECT_EQ(robot.window().windowTitle(), "limb.sinew[*] - Skeleton Modeler");
        drawn = robot.document();
    }
    const auto read = read_skeleton(path.toStdString());
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_TRUE(same(read->document, drawn));
    Robot again(path);
    EXPECT_TRUE(same(again.document(), drawn));
}

TEST(Files, a_dropped_file_is_opened) {
    const TemporaryFolder folder;
    const QString path = path_in(folder, "neuron.swc");
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("1 1 0 0 0 1 -1\n2 3 0 0 4 0.5 1\n3 3 2 0 8 0.3 2\n4 3 -2 0 8 0.3 2\n");
    file.close();
    Robot robot;
    robot.drop(path);
    ASSERT_TRUE(Robot::wait([&] { return robot.document().nodes.size() == 4; }));
    ASSERT_TRUE(robot.wait_for_mesh());
    EXPECT_TRUE(robot.window().meshes().mesh()->validation->solid());
    robot.screenshot("11-dropped-neuron");
}

TEST(Files, a_broken_file_is_refused_with_a_reason) {
    const TemporaryFolder folder;
    const QString path = path_in(folder, "broken.sinew");
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(R"({"format": "sinew", "version": 1, "nodes": [{"id": 1, "position": [0, 0], "radius": 1}]})");
    file.close();
    Robot robot;
    const Document before = robot.document();
    QString text;
    robot.when_dialog("error", [&](QDialog& dialog) {
        Robot::screenshot(dialog, "12-error");
        QTest::keyClick(&dialog, Qt::Key_Return);
    });
    EXPECT_FALSE(robot.window().files().open(path));
    EXPECT_TRUE(same(robot.document(), before));
}

TEST(Files, the_mesh_is_exported_at_the_level_asked_for) {
    const TemporaryFolder folder;
    const QString path = path_in(folder, "tube.obj");
    Robot robot;
    robot.look_from_front();
    robot.drag({0, 0, 0}, {0, 0, 3}, Qt::ControlModifier);
    robot.when_dialog("export_dialog", [&](QDialog& dialog) {
        auto* format = dialog.findChild<QComboBox*>("export_format");
        format->setFocus();
        for (int i = 0; i < format->count() && !format->currentText().contains(".obj"); ++i)
            QTest::keyClick(format, i == 0 ? Qt::Key_Home : Qt::Key_Down);
        auto* level = dialog.findChild<QSpinBox*>("export_level");
        level->setFocus();
        level->selectAll();
        QTest::keyClicks(level, "0");
        auto* edit = dialog.findChild<QLineEdit*>("export_path");
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, path);
        Robot::screenshot(dialog, "13-export");
        QTest::keyClick(&dialog, Qt::Key_Return);
    });
    robot.key(Qt::Key_E, Qt::ControlModifier);
    const auto mesh = read_mesh(path.toStdString());
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_TRUE(validate(*mesh).solid());
    robot.key(Qt::Key_0);
    const auto same_is_shown = [&] {
        const auto& shown = robot.window().meshes().mesh();
        return shown && shown->mesh && shown->mesh->vertex_count() == mesh->vertex_count();
    };
    EXPECT_TRUE(Robot::wait(same_is_shown));  // the mesh of the level before may still be there
}

TEST(Files, what_a_crash_left_is_recovered) {
    QProcess child;
    child.setProcessChannelMode(QProcess::ForwardedChannels);
    child.start(QCoreApplication::applicationFilePath(), {"--draw-and-crash"});
    ASSERT_TRUE(child.waitForFinished(Robot::patience));
    ASSERT_EQ(child.exitStatus(), QProcess::CrashExit) << child.exitCode();

    Robot* robot = nullptr;
    // The dialog comes up while the window starts.
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&] {
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (!dialog || dialog->objectName() != "recover" || !dialog->isVisible()) return;
        timer.stop();
        Robot::screenshot(*dialog, "14-recover");
        QTest::keyClick(dialog, Qt::Key_Return);
    });
    timer.start(20);
    Robot after;
    robot = &after;
    EXPECT_FALSE(timer.isActive());
    ASSERT_EQ(robot->document().nodes.size(), 3u);
    EXPECT_LT((robot->document().nodes[2].position - Vec3(2, 0, 3)).norm(), 1e-9);
    EXPECT_TRUE(robot->window().isWindowModified());
}

}  // namespace
}  // namespace sinew::modeler
