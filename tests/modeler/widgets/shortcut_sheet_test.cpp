#include "window/shortcut_sheet.h"

#include <gtest/gtest.h>

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <set>

#include "actions/mouse.h"
#include "desk_window.h"

namespace sinew::modeler {
namespace {

std::multiset<QString> texts_on(const QWidget& sheet) {
    std::multiset<QString> texts;
    for (const QLabel* label : sheet.findChildren<QLabel*>()) texts.insert(label->text());
    return texts;
}

TEST(ShortcutSheet, has_every_key_and_every_use_of_the_mouse) {
    DeskWindow desk;
    ShortcutSheet sheet(&desk.window);
    const std::multiset<QString> texts = texts_on(sheet);
    for (const Action& action : actions()) {
        const QString keys = ActionSet::shortcut_text(action);
        if (keys.isEmpty()) continue;
        EXPECT_TRUE(texts.contains(keys)) << action.id;
        EXPECT_TRUE(texts.contains(QString(action.name).replace(" > ", ": "))) << action.id;
    }
    for (const MouseUse& use : mouse_uses()) {
        EXPECT_TRUE(texts.contains(use.what)) << use.what;
        EXPECT_TRUE(texts.contains(use.how)) << use.how;
    }
}

TEST(ShortcutSheet, fits_into_its_window_and_closes) {
    DeskWindow desk;
    ShortcutSheet sheet(&desk.window);
    EXPECT_LE(sheet.width(), desk.window.width());
    EXPECT_LE(sheet.height(), desk.window.height());
    sheet.show();
    QTest::keyClick(&sheet, Qt::Key_Escape);
    EXPECT_FALSE(sheet.isVisible());
}

}  // namespace
}  // namespace sinew::modeler
