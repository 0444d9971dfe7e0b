#include "panels/number_box.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QLineEdit>
#include <QTest>
#include <QWheelEvent>

namespace sinew::modeler {
namespace {

struct Shown : NumberBox {
    std::vector<double> heard;
    Shown() {
        setRange(-1e6, 1e6);
        connect(this, &QDoubleSpinBox::valueChanged, this, [this](double value) { heard.push_back(value); });
        show();
    }
    QString written() const { return lineEdit()->text(); }
    void type(const QString& text) {
        setFocus();
        selectAll();
        QTest::keyClicks(this, text);
        QTest::keyClick(this, Qt::Key_Return);
    }
};

TEST(NumberBox, shows_as_many_digits_as_it_needs) {
    Shown box;
    for (const auto& [value, text] : {std::pair{0.0, "0"},
                                      {2.5, "2.5"},
                                      {1 / 3.0, "0.333333"},
                                      {-0.001, "-0.001"},
                                      {123456.7, "123457"}}) {
        box.setValue(value);
        EXPECT_EQ(box.written(), text);
    }
}

TEST(NumberBox, keeps_what_it_does_not_show) {
    Shown box;
    box.setValue(1 / 3.0);
    EXPECT_NEAR(box.value(), 1 / 3.0, 1e-9);
}

TEST(NumberBox, takes_figures_with_and_without_the_unit) {
    Shown box;
    box.setSuffix(" m");
    box.type("2.5");
    EXPECT_EQ(box.value(), 2.5);
    box.type("1e-3 m");
    EXPECT_EQ(box.value(), 0.001);
    box.type("-4");
    EXPECT_EQ(box.value(), -4);
    EXPECT_EQ(box.written(), "-4 m");
}

TEST(NumberBox, tells_once_one_has_finished_typing) {
    Shown box;
    box.type("12.5");
    EXPECT_EQ(box.heard, std::vector{12.5});
}

TEST(NumberBox, what_differs_is_empty) {
    Shown box;
    box.show_value(std::nullopt, 3);
    EXPECT_EQ(box.written(), "");
    EXPECT_EQ(box.findChild<QLineEdit*>()->placeholderText(), "differ");
    box.show_value(4, 4);
    EXPECT_EQ(box.written(), "4");
}

TEST(NumberBox, what_is_typed_over_what_differs_counts_even_where_one_had_it) {
    Shown box;
    box.show_value(std::nullopt, 3);
    box.heard.clear();
    box.type("3");
    ASSERT_FALSE(box.heard.empty());
    EXPECT_EQ(box.heard.back(), 3);
}

TEST(NumberBox, nonsense_is_not_taken) {
    Shown box;
    box.setValue(5);
    box.type("five");
    EXPECT_EQ(box.value(), 5);
    int place = 0;
    QString half = "1e";
    EXPECT_EQ(box.validate(half, place), QValidator::Intermediate);
}

TEST(NumberBox, a_wheel_that_passes_by_changes_nothing) {
    Shown box;
    box.setValue(5);
    box.clearFocus();
    QWheelEvent wheel({5, 5}, {5, 5}, {}, {0, 120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&box, &wheel);
    EXPECT_EQ(box.value(), 5);
    EXPECT_FALSE(wheel.isAccepted());
}

TEST(ChoiceBox, a_wheel_that_passes_by_changes_nothing) {
    ChoiceBox box;
    box.addItems({"one", "two"});
    box.show();
    box.setFocus();
    QWheelEvent wheel({5, 5}, {5, 5}, {}, {0, -120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&box, &wheel);
    EXPECT_EQ(box.currentIndex(), 0);
}

}  // namespace
}  // namespace sinew::modeler
