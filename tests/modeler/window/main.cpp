// The window's tests: a real window on a display that nobody looks at, in a home of its own.

#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>

#include "look/theme.h"
#include "robot.h"
#include "window/application.h"

#ifdef SINEW_SANITIZED
/// Drivers stay loaded, so that what they leak can be told by their names (tests/leaks.supp) from what we
/// leak.
extern "C" int dlclose(void*) { return 0; }
#endif

namespace sinew::modeler {
int draw_and_crash();  // files_test.cpp
}

namespace {

/// No test sees what one before it has chosen.
class FreshSettings : public testing::EmptyTestEventListener {
    void OnTestStart(const testing::TestInfo&) override { QSettings().clear(); }
};

}  // namespace

int main(int argc, char** argv) {
    using namespace sinew::modeler;
    // A child that crashes lives in its parent's home.
    const bool crashing = argc > 1 && std::string_view(argv[1]) == "--draw-and-crash";
    const TemporaryFolder home;
    if (!crashing)
        for (const char* name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_RUNTIME_DIR"})
            qputenv(name, QByteArray::fromStdString(home.file(name)));
    ask_for_opengl();
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    QApplication application(argc, argv);
    QApplication::setOrganizationName("Sinew");
    QApplication::setApplicationName("ModelerTest");
    theme::apply(application);
    if (crashing) return draw_and_crash();
    testing::InitGoogleTest(&argc, argv);
    testing::UnitTest::GetInstance()->listeners().Append(new FreshSettings);
    return RUN_ALL_TESTS();
}
