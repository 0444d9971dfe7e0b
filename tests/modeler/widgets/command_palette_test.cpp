#include "window/command_palette.h"

#include <gmock/gmock.h>

#include <QAction>
#include <QLineEdit>
#include <QListWidget>
#include <QTest>

#include "desk_window.h"

namespace sinew::modeler {
namespace {

using testing::ElementsAre;

struct Open : DeskWindow {
    CommandPalette palette{actions, window};
    QLineEdit& text = *palette.findChild<QLineEdit*>("command_palette_text");
    QListWidget& list = *palette.findChild<QListWidget*>("command_palette_list");
    Open() { palette.open(); }
    void type(const QString& letters) { QTest::keyClicks(&text, letters); }
    void key(Qt::Key key) { QTest::keyClick(&text, key); }
};

TEST(CommandPalette, lists_everything_but_itself) {
    Open open;
    EXPECT_EQ(open.list.count() + 1, std::ssize(sinew::modeler::actions()));
    EXPECT_TRUE(open.palette.isVisible());
}

TEST(CommandPalette, runs_the_best_match) {
    Open open;
    open.type("wire");
    const bool before = open.desk.view.wire;
    open.key(Qt::Key_Return);
    EXPECT_NE(open.desk.view.wire, before);
    EXPECT_FALSE(open.palette.isVisible());
    EXPECT_EQ(open.ran, 1);
}

TEST(CommandPalette, arrows_go_round_the_list) {
    Open open;
    open.type("from");
    ASSERT_GT(open.list.count(), 2);
    open.key(Qt::Key_Up);
    EXPECT_EQ(open.list.currentRow(), open.list.count() - 1);
    open.key(Qt::Key_Down);
    EXPECT_EQ(open.list.currentRow(), 0);
    open.key(Qt::Key_Down);
    EXPECT_EQ(open.list.currentRow(), 1);
}

TEST(CommandPalette, what_is_not_enabled_does_not_run) {
    Open open;
    open.type("delete branch");
    const Document before = open.desk.model.document();
    open.key(Qt::Key_Return);
    EXPECT_TRUE(open.palette.isVisible());
    EXPECT_EQ(open.desk.model.document().nodes.size(), before.nodes.size());
}

TEST(CommandPalette, escape_does_nothing_but_close) {
    Open open;
    open.type("new");
    open.key(Qt::Key_Escape);
    EXPECT_FALSE(open.palette.isVisible());
    EXPECT_THAT(open.desk.host.asked, ElementsAre());
    open.palette.open();  // as fresh as the first time
    EXPECT_EQ(open.text.text(), "");
}

TEST(CommandPalette, a_click_runs_too) {
    Open open;
    open.type("about");
    QTest::mouseClick(open.list.viewport(), Qt::LeftButton, {},
                      open.list.visualItemRect(open.list.item(0)).center());
    EXPECT_THAT(open.desk.host.asked, ElementsAre("about"));
}

TEST(CommandPalette, nonsense_finds_nothing_and_runs_nothing) {
    Open open;
    open.type("qqqq");
    EXPECT_EQ(open.list.count(), 0);
    open.key(Qt::Key_Down);
    open.key(Qt::Key_Return);
    EXPECT_TRUE(open.palette.isVisible());
    EXPECT_EQ(open.ran, 0);
}

}  // namespace
}  // namespace sinew::modeler
