// Panels and dialogs one by one, drawn into memory: no display, no OpenGL.

#include <gtest/gtest.h>

#include <QApplication>
#include <QStandardPaths>

#include "look/theme.h"

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QStandardPaths::setTestModeEnabled(true);

    QApplication application(argc, argv);
    QApplication::setOrganizationName("Sinew");
    QApplication::setApplicationName("ModelerTest");
    sinew::modeler::theme::apply(application);
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
