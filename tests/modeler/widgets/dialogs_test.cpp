#include "window/dialogs.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QSpinBox>
#include <QTest>
#include <QTimer>

namespace sinew::modeler {
namespace {

/// Does something as soon as a dialog waits.
template <class Then>
void when_asked(Then then) {
    auto* timer = new QTimer(qApp);
    QObject::connect(timer, &QTimer::timeout, qApp, [timer, then] {
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (!dialog) return;
        timer->deleteLater();
        then(*dialog);
    });
    timer->start(5);
}

TEST(RadialSymmetry, is_what_was_chosen) {
    when_asked([](QDialog& dialog) {
        dialog.findChild<QComboBox*>()->setCurrentIndex(1);
        dialog.findChild<QSpinBox*>()->setValue(7);
        dialog.accept();
    });
    const auto chosen = ask_radial_symmetry(nullptr, {});
    ASSERT_TRUE(chosen);
    EXPECT_EQ(*chosen, (Symmetry{Symmetry::Kind::radial, 1, 7}));
}

TEST(RadialSymmetry, starts_with_what_there_is) {
    const Symmetry now{Symmetry::Kind::radial, 0, 12};
    when_asked([](QDialog& dialog) { QTest::keyClick(&dialog, Qt::Key_Return); });
    EXPECT_EQ(ask_radial_symmetry(nullptr, now), now);
}

TEST(RadialSymmetry, is_never_of_one_image) {
    when_asked([](QDialog& dialog) {
        dialog.findChild<QSpinBox*>()->setValue(1);
        dialog.accept();
    });
    EXPECT_GE(ask_radial_symmetry(nullptr, {})->count, 2);
}

TEST(RadialSymmetry, nothing_where_one_thinks_better_of_it) {
    when_asked([](QDialog& dialog) { QTest::keyClick(&dialog, Qt::Key_Escape); });
    EXPECT_EQ(ask_radial_symmetry(nullptr, {}), std::nullopt);
}

}  // namespace
}  // namespace sinew::modeler
