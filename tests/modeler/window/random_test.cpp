// A hand gone wild at the real window: pointer, keys, every action of the table, and whatever dialogs, menus
// and panels come up, at random but always the same.

#include <gmock/gmock.h>

#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QMenu>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>
#include <random>

#include "modeler/whole_history.h"
#include "robot.h"
#include "sinew/skeleton/validate.h"
#include "viewport/viewport.h"
#include "window/action_set.h"
#include "window/grow_panel.h"

namespace sinew::modeler {
namespace {

class Wild {
  public:
    explicit Wild(unsigned seed) : random_(seed) {
        // Dialogs wait inside the call that opened them: they are sent away from here.
        QObject::connect(&dismiss_, &QTimer::timeout, [] {
            if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) dialog->reject();
            if (QWidget* popup = QApplication::activePopupWidget()) popup->close();
        });
        dismiss_.start(1);
        beginning_ = bytes_of(robot_.document());
    }

    void run(int events) {
        for (int i = 0; i < events && !testing::Test::HasFailure(); ++i) {
            one_event();
            if (i % 4 == 0) QApplication::processEvents();  // a picture takes its time
            check();
        }
        for (auto pressed : {Qt::LeftButton, Qt::MiddleButton, Qt::RightButton})
            QTest::mouseRelease(&viewport(), pressed, {}, QPoint(5, 5));
        if (auto* panel = growing()) panel->finish(true);
        robot_.window().tools().cancel();
        EXPECT_GT(expect_whole_history(robot_.window().model(), beginning_), 3);
        robot_.window().view().live = true;
        robot_.window().view().level = 1;
        robot_.window().meshes().refresh();
        ASSERT_TRUE(robot_.wait_for_mesh());
    }

  private:
    int below(int n) { return std::uniform_int_distribution(0, n - 1)(random_); }
    Viewport& viewport() { return robot_.window().viewport(); }
    GrowPanel* growing() {
        return static_cast<GrowPanel*>(robot_.window().findChild<QDockWidget*>("grow_panel"));
    }

    QPoint somewhere() {
        const auto& nodes = robot_.document().nodes;
        if (below(3) == 0 || nodes.empty()) return {below(viewport().width()), below(viewport().height())};
        return robot_.pixel(nodes[below(static_cast<int>(nodes.size()))].position);
    }
    Qt::KeyboardModifiers held() {
        Qt::KeyboardModifiers held;
        for (auto key : {Qt::ShiftModifier, Qt::ControlModifier, Qt::AltModifier})
            held.setFlag(key, below(5) == 0);
        return held;
    }
    Qt::MouseButton button() {
        return below(5) > 0 ? Qt::LeftButton : below(2) > 0 ? Qt::MiddleButton : Qt::RightButton;
    }
    /// Whatever has the focus gets the key, as at a desk.
    void key() {
        constexpr Qt::Key others[] = {Qt::Key_Escape, Qt::Key_Return, Qt::Key_Backspace, Qt::Key_Tab,
                                      Qt::Key_Up,     Qt::Key_Down,   Qt::Key_Minus,     Qt::Key_Period};
        const int n = below(44);
        const int code = n < 26 ? Qt::Key_A + n : n < 36 ? Qt::Key_0 + n - 26 : others[n - 36];
        Qt::KeyboardModifiers modifiers = held();
        if (code == Qt::Key_Q && modifiers.testFlag(Qt::ControlModifier)) return;  // closes the window
        QWidget* focus = QApplication::focusWidget();
        QTest::keyClick(focus ? focus : &viewport(), static_cast<Qt::Key>(code), modifiers);
    }
    void action() {
        const Action& chosen = actions()[below(static_cast<int>(actions().size()))];
        if (std::string_view(chosen.id) == "file.quit") return;
        if (robot_.document().nodes.size() > 60 && std::string_view(chosen.id).starts_with("copy.")) return;
        robot_.window().actions().run(chosen);
    }
    void wheel() {
        const QPoint at = somewhere();
        QWheelEvent event(at, viewport().mapToGlobal(at), {}, {0, 120 * (below(5) - 2)}, Qt::NoButton, held(),
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&viewport(), &event);
    }
    void grow() {
        if (auto* panel = growing()) return panel->finish(below(2) == 0);
        if (below(4) == 0) robot_.drop(QString(SINEW_LSYSTEMS) + "/creature.lsys");
    }

    void one_event() {
        switch (below(12)) {
            case 0:
            case 1:
                return QTest::mousePress(&viewport(), button(), held(), somewhere());
            case 2:
            case 3:
            case 4:
                return QTest::mouseMove(&viewport(), somewhere());
            case 5:
            case 6:
                return QTest::mouseRelease(&viewport(), button(), held(), somewhere());
            case 7:
                return wheel();
            case 8:
            case 9:
                return key();
            case 10:
                return below(12) == 0 ? grow() : viewport().setFocus();
            default:
                return action();
        }
    }

    void check() {
        const Document& document = robot_.document();
        const Result<void> sound = validate(document);
        EXPECT_TRUE(sound) << sound.error().text();
        for (std::int32_t node : robot_.window().model().selection().nodes)
            EXPECT_LT(node, std::ssize(document.nodes));
        EXPECT_TRUE(robot_.window().tools().active() || growing() || !robot_.window().model().previewing());
        EXPECT_TRUE(robot_.window().isVisible());
    }

    Robot robot_;
    QTimer dismiss_;
    std::mt19937 random_;
    std::string beginning_;
};

TEST(Wild, leaves_a_sound_document_and_a_whole_history) {
    for (unsigned seed : {1u, 2u}) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Wild(seed).run(120);
        if (HasFailure()) return;
    }
}

}  // namespace
}  // namespace sinew::modeler
