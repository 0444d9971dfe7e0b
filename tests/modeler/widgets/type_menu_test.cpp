#include "window/type_menu.h"

#include <gmock/gmock.h>

#include <QTest>
#include <cmath>
#include <numbers>

namespace sinew::modeler {
namespace {

using testing::ElementsAre;

struct Ring {
    QWidget parent;
    std::vector<NodeType> chosen;
    TypeMenu menu{&parent, [this](NodeType type) { chosen.push_back(type); }};
    Ring() {
        parent.resize(800, 600);
        parent.show();
        menu.open(QPoint(400, 300));
    }
    QPoint middle() const { return menu.rect().center(); }
    /// A point of the ring: 0 is at the top, the others follow clockwise.
    QPoint sector(int i) const {
        const double angle = (i * 60 - 90) * std::numbers::pi / 180, reach = menu.width() * 0.35;
        return middle() +
               QPoint(static_cast<int>(reach * std::cos(angle)), static_cast<int>(reach * std::sin(angle)));
    }
    void click(const QPoint& at) {
        QTest::mouseMove(&menu, at);
        QTest::mouseClick(&menu, Qt::LeftButton, {}, at);
    }
};

TEST(TypeMenu, opens_round_the_pointer_and_stays_inside) {
    Ring ring;
    EXPECT_TRUE(ring.menu.isVisible());
    EXPECT_TRUE(ring.menu.geometry().contains(QPoint(400, 300)));
    EXPECT_LT((ring.menu.geometry().center() - QPoint(400, 300)).manhattanLength(), 4);
    for (const QPoint& corner : {QPoint(0, 0), QPoint(799, 599), QPoint(-50, 900)}) {
        ring.menu.open(corner);
        EXPECT_TRUE(ring.parent.rect().contains(ring.menu.geometry()));
    }
}

TEST(TypeMenu, each_sector_is_a_type) {
    for (int i = 0; i < 6; ++i) {
        Ring ring;
        ring.click(ring.sector(i));
        EXPECT_THAT(ring.chosen, ElementsAre(static_cast<NodeType>(i)));
        EXPECT_FALSE(ring.menu.isVisible());
    }
}

TEST(TypeMenu, digits_choose_as_well) {
    for (int i = 0; i < 6; ++i) {
        Ring ring;
        QTest::keyClick(&ring.menu, static_cast<Qt::Key>(Qt::Key_1 + i));
        EXPECT_THAT(ring.chosen, ElementsAre(static_cast<NodeType>(i)));
    }
}

TEST(TypeMenu, the_middle_and_other_keys_choose_nothing) {
    Ring ring;
    ring.click(ring.middle());
    EXPECT_FALSE(ring.menu.isVisible());
    for (const Qt::Key key : {Qt::Key_Escape, Qt::Key_7, Qt::Key_0, Qt::Key_A}) {
        ring.menu.open(QPoint(400, 300));
        QTest::keyClick(&ring.menu, key);
        EXPECT_FALSE(ring.menu.isVisible());
    }
    EXPECT_TRUE(ring.chosen.empty());
}

}  // namespace
}  // namespace sinew::modeler
