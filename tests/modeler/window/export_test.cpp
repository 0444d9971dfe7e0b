// The export dialog: every format that meshes can be written in.

#include <gmock/gmock.h>

#include <QComboBox>
#include <QDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QSpinBox>
#include <QTest>

#include "robot.h"
#include "sinew/io/mesh_formats.h"

namespace sinew::modeler {
namespace {

QString exported(Robot& robot, const TemporaryFolder& folder, int format, int level) {
    QString path;
    robot.when_dialog("export_dialog", [&](QDialog& dialog) {
        dialog.findChild<QLineEdit*>("export_path")->setText(QString::fromStdString(folder.file("part")));
        dialog.findChild<QComboBox*>("export_format")->setCurrentIndex(format);
        // Another format changes the ending of the name; choosing the one that is chosen does not.
        dialog.findChild<QSpinBox*>("export_level")->setValue(level + 1);
        dialog.findChild<QSpinBox*>("export_level")->setValue(level);
        path = dialog.findChild<QLineEdit*>("export_path")->text();
        QTest::keyClick(&dialog, Qt::Key_Return);
    });
    robot.key(Qt::Key_E, Qt::ControlModifier);
    return path;
}

TEST(Exporting, every_format_takes_the_mesh) {
    const TemporaryFolder folder;
    Robot robot;
    robot.look_from_front();
    robot.drag({0, 0, 0}, {0, 0, 3}, Qt::ControlModifier);
    int choice = 0;
    for (const Format& format : formats()) {
        if (!format.writes_mesh) continue;
        const QString path = exported(robot, folder, choice++, 1);
        EXPECT_TRUE(path.endsWith(QString::fromStdString(std::string(format.extension))));
        EXPECT_GT(QFileInfo(path).size(), 0) << path.toStdString();
        if (!format.reads_mesh) continue;
        const auto mesh = read_mesh(path.toStdString());
        ASSERT_TRUE(mesh) << mesh.error().text();
        EXPECT_GT(mesh->face_count(), 0u) << format.name;
    }
    EXPECT_GE(choice, 6);
}

}  // namespace
}  // namespace sinew::modeler
