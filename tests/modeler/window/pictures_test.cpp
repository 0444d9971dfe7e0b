// Reference pictures, from the dialog and by a drop, and whether they are there the next day.

#include <gmock/gmock.h>

#include <QDialog>
#include <QDoubleSpinBox>
#include <QPainter>
#include <QPushButton>
#include <QTest>

#include "document/delta.h"
#include "document/edits.h"
#include "document/references.h"
#include "robot.h"
#include "sinew/io/files.h"
#include "viewport/viewport.h"

namespace sinew::modeler {
namespace {

QString drawing_in(const TemporaryFolder& folder, const char* name = "front.png") {
    QImage image(300, 400, QImage::Format_RGB32);
    image.fill(QColor(225, 220, 205));
    QPainter painter(&image);
    painter.setPen(QPen(QColor(60, 60, 70), 4));
    painter.drawEllipse(QPoint(150, 90), 60, 60);
    painter.drawLine(150, 150, 150, 300);
    painter.drawLine(150, 200, 60, 150);
    painter.drawLine(150, 200, 240, 150);
    const QString file = QString::fromStdString(folder.file(name));
    image.save(file);
    return file;
}

void set(QDialog& dialog, const char* name, const char* value) {
    auto* box = dialog.findChild<QDoubleSpinBox*>(name);
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, value);
    QTest::keyClick(box, Qt::Key_Return);
}

TEST(Pictures, are_chosen_placed_and_there_the_next_day) {
    const TemporaryFolder folder;
    const QString file = drawing_in(folder), path = QString::fromStdString(folder.file("figure.sinew"));
    {
        Robot robot;
        robot.look_from_front();
        robot.when_dialog("reference_pictures", [&](QDialog& dialog) {
            EXPECT_FALSE(dialog.findChild<QDoubleSpinBox*>("height_1")->isEnabled());
            robot.when_asked_for_file("picture_dialog", file);
            QTest::mouseClick(dialog.findChild<QPushButton*>("choose_1"), Qt::LeftButton);
            set(dialog, "height_1", "6");
            set(dialog, "up_1", "2");
            robot.screenshot("16-reference-picture");
            Robot::screenshot(dialog, "17-reference-dialog");
            QTest::keyClick(&dialog, Qt::Key_Escape);
        });
        robot.command("reference");
        const Reference chosen = references_of(robot.document())[1];
        EXPECT_EQ(QString::fromStdString(chosen.file), file);
        EXPECT_EQ(chosen.height, 6);
        EXPECT_EQ(chosen.offset[1], 2);
        EXPECT_FALSE(robot.window().viewport().references()[1].image.isNull());
        EXPECT_TRUE(robot.window().isWindowModified());
        robot.save_as(path);
    }
    // Both have moved elsewhere.
    const TemporaryFolder other;
    for (const char* name : {"front.png", "figure.sinew"})
        std::filesystem::copy(folder.file(name), other.file(name));
    std::filesystem::remove(folder.file("front.png"));
    Robot next_day(QString::fromStdString(other.file("figure.sinew")));
    EXPECT_EQ(references_of(next_day.document())[1].file, other.file("front.png"));
    EXPECT_FALSE(next_day.window().viewport().references()[1].image.isNull());
    EXPECT_FALSE(next_day.window().isWindowModified());
}

TEST(Pictures, each_choice_is_a_step_that_goes_again) {
    const TemporaryFolder folder;
    const QString file = drawing_in(folder);
    Robot robot;
    robot.look_from_front();
    robot.drop(file);
    ASSERT_TRUE(Robot::wait([&] { return !references_of(robot.document())[1].file.empty(); }));
    EXPECT_EQ(robot.window().model().history().undoText(), "Reference picture");
    robot.key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(same(robot.document(), starting_document()));
    EXPECT_TRUE(robot.window().viewport().references()[1].image.isNull());
}

TEST(Pictures, a_dropped_one_stands_behind_the_view_one_has) {
    const TemporaryFolder folder;
    Robot robot;
    robot.key(Qt::Key_7, Qt::KeypadModifier);
    robot.drop(drawing_in(folder, "above.png"));
    ASSERT_TRUE(Robot::wait([&] { return !references_of(robot.document())[2].file.empty(); }));
    EXPECT_TRUE(references_of(robot.document())[1].file.empty());
}

TEST(Pictures, what_is_none_is_refused) {
    const TemporaryFolder folder;
    ASSERT_TRUE(write_file(folder.file("text.png"), "no picture"));
    Robot robot;
    bool told = false;
    robot.when_dialog("reference_pictures", [&](QDialog& dialog) {
        robot.when_asked_for_file("picture_dialog", QString::fromStdString(folder.file("text.png")));
        robot.when_dialog("error", [&](QDialog& error) {
            told = true;
            QTest::keyClick(&error, Qt::Key_Return);
        });
        QTest::mouseClick(dialog.findChild<QPushButton*>("choose_0"), Qt::LeftButton);
        QTest::keyClick(&dialog, Qt::Key_Escape);
    });
    robot.command("reference");
    EXPECT_TRUE(told);
    EXPECT_TRUE(same(robot.document(), starting_document()));
}

}  // namespace
}  // namespace sinew::modeler
