// What asks before something is lost, and what does not; recent files.

#include <gmock/gmock.h>

#include <QAbstractButton>
#include <QFile>
#include <QMenu>
#include <QMessageBox>
#include <QTest>

#include "document/delta.h"
#include "document/edits.h"
#include "robot.h"
#include "sinew/io/skeleton_formats.h"
#include "window/action_set.h"

namespace sinew::modeler {
namespace {

using testing::ElementsAre;

QString in(const TemporaryFolder& folder, const char* name) {
    return QString::fromStdString(folder.file(name));
}

void draw_a_tube(Robot& robot) {
    robot.look_from_front();
    robot.drag({0, 0, 0}, {0, 0, 3}, Qt::ControlModifier);
    ASSERT_EQ(robot.document().nodes.size(), 2u);
}

/// Answers the question, and counts it.
void when_asked(Robot& robot, QMessageBox::StandardButton answer, int& asked) {
    robot.when_dialog("ask_to_save", [&asked, answer](QDialog& dialog) {
        ++asked;
        Robot::screenshot(dialog, "10-ask-to-save");
        QWidget* button = static_cast<QMessageBox&>(dialog).button(answer);
        QTest::mouseClick(button, Qt::LeftButton);
    });
}

/// Closes the window, answers the question, and holds it to be asked once.
void quit(Robot& robot, QMessageBox::StandardButton answer) {
    int asked = 0;
    when_asked(robot, answer, asked);
    robot.key(Qt::Key_Q, Qt::ControlModifier);
    EXPECT_EQ(asked, 1);
}

TEST(Closing, nothing_is_asked_where_nothing_would_be_lost) {
    Robot robot;
    robot.key(Qt::Key_Q, Qt::ControlModifier);
    EXPECT_FALSE(robot.window().isVisible());
}

TEST(Closing, cancel_keeps_the_window) {
    Robot robot;
    draw_a_tube(robot);
    quit(robot, QMessageBox::Cancel);
    EXPECT_TRUE(robot.window().isVisible());
    EXPECT_TRUE(robot.window().isWindowModified());
}

TEST(Closing, discard_closes_it) {
    Robot robot;
    draw_a_tube(robot);
    quit(robot, QMessageBox::Discard);
    EXPECT_FALSE(robot.window().isVisible());
}

TEST(Closing, save_asks_for_a_name_and_writes_the_file) {
    const TemporaryFolder folder;
    Robot robot;
    draw_a_tube(robot);
    const Document drawn = robot.document();
    robot.when_asked_for_file("save_dialog", in(folder, "tube.sinew"));
    quit(robot, QMessageBox::Save);
    EXPECT_FALSE(robot.window().isVisible());
    const auto read = read_skeleton(folder.file("tube.sinew"));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_TRUE(same(read->document, drawn));
}

TEST(Closing, another_document_asks_too) {
    Robot robot;
    draw_a_tube(robot);
    int asked = 0;
    when_asked(robot, QMessageBox::Cancel, asked);
    robot.key(Qt::Key_N, Qt::ControlModifier);
    EXPECT_EQ(robot.document().nodes.size(), 2u);
    when_asked(robot, QMessageBox::Discard, asked);
    robot.key(Qt::Key_N, Qt::ControlModifier);
    EXPECT_EQ(asked, 2);
    EXPECT_TRUE(same(robot.document(), starting_document()));
    EXPECT_FALSE(robot.window().isWindowModified());
}

TEST(Closing, a_file_that_cannot_be_opened_costs_nothing) {
    const TemporaryFolder folder;
    QFile file(in(folder, "broken.sinew"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("{");
    file.close();
    Robot robot;
    draw_a_tube(robot);
    robot.when_dialog("error", [&](QDialog& dialog) { QTest::keyClick(&dialog, Qt::Key_Return); });
    robot.open(file.fileName());
    EXPECT_EQ(robot.document().nodes.size(), 2u);
    EXPECT_TRUE(robot.window().isWindowModified());
}

/// What File > Open recent offers, and the menu itself.
QMenu& recent_menu(Robot& robot) {
    for (QAction* action : robot.window().actions().menu(Menu::file)->actions())
        if (action->text() == "Open recent") {
            emit action->menu()->aboutToShow();
            return *action->menu();
        }
    throw std::runtime_error("there is no such menu");
}
std::vector<std::string> recent_names(Robot& robot) {
    std::vector<std::string> names;
    for (const QAction* action : recent_menu(robot).actions())
        names.push_back(action->text().section("    ", 0, 0).toStdString());
    return names;
}

TEST(RecentFiles, the_last_comes_first_and_opens_again) {
    const TemporaryFolder folder;
    Robot robot;
    EXPECT_THAT(recent_names(robot), ElementsAre("None yet"));
    draw_a_tube(robot);
    robot.save_as(in(folder, "one.sinew"));
    const Document one = robot.document();
    robot.key(Qt::Key_X);
    robot.save_as(in(folder, "two.sinew"));
    EXPECT_THAT(recent_names(robot), ElementsAre("two.sinew", "one.sinew"));
    recent_menu(robot).actions().at(1)->trigger();
    EXPECT_TRUE(same(robot.document(), one));
    EXPECT_EQ(robot.window().files().name(), "one.sinew");
    EXPECT_THAT(recent_names(robot), ElementsAre("one.sinew", "two.sinew"));
}

TEST(RecentFiles, what_is_gone_is_not_offered_again) {
    const TemporaryFolder folder;
    Robot robot;
    draw_a_tube(robot);
    robot.save_as(in(folder, "one.sinew"));
    robot.save_as(in(folder, "two.sinew"));
    ASSERT_TRUE(QFile::remove(in(folder, "one.sinew")));
    bool told = false;
    robot.when_dialog("error", [&](QDialog& dialog) {
        told = true;
        QTest::keyClick(&dialog, Qt::Key_Return);
    });
    recent_menu(robot).actions().at(1)->trigger();
    EXPECT_TRUE(told);
    EXPECT_THAT(recent_names(robot), ElementsAre("two.sinew"));
    EXPECT_EQ(robot.window().files().name(), "two.sinew");
}

}  // namespace
}  // namespace sinew::modeler
