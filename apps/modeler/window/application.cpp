#include "window/application.h"

#include <QApplication>
#include <QSurfaceFormat>
#include <QTimer>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "actions/action.h"
#include "actions/mouse.h"
#include "look/theme.h"
#include "window/main_window.h"

namespace sinew::modeler {
namespace {

const char* const help = R"(sinew-modeler - draw a skeleton, see its mesh, export clean quads

Usage: sinew-modeler [FILE]

FILE is a skeleton in any format that is read: .sinew, .graph, .swc, or the joints of .gltf and .glb.
Without it a new one starts: a red root, mirrored at the green plane. Drag from the root to draw.

  -h, --help      this text
  -V, --version   the version
  --keys          all keys and what the mouse does, as Markdown
  F1 in the window shows all keys, Ctrl+K finds any command.

Exit status: 0 done, 1 no display, 2 the call is wrong.
)";

bool names_display() {
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        if (const char* value = std::getenv(name); value && *value) return true;
    return false;
}

int without_display(const char* why) {
    std::fprintf(stderr, "sinew-modeler: %s; it needs a desktop, or xvfb-run\n", why);
    return 1;
}

/// While Qt looks for a display it speaks in many lines and then aborts: one line is enough.
void quiet_start(QtMsgType type, const QMessageLogContext&, const QString& text) {
    if (type == QtFatalMsg) std::_Exit(without_display("the display cannot be opened"));
    if (!text.contains("display") && !text.contains("platform plugin"))
        std::fprintf(stderr, "%s\n", qUtf8Printable(text));
}

int print_keys() {
    std::string text = mouse_as_markdown();
    text += '\n';
    text += keys_as_markdown();
    return std::fputs(text.c_str(), stdout) < 0;
}

}  // namespace

void ask_for_opengl() {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setSamples(4);
    QSurfaceFormat::setDefaultFormat(format);
}

int run(int argc, char** argv) {
    const std::string_view first = argc > 1 ? argv[1] : "";
    if (first == "-h" || first == "--help") return std::fputs(help, stdout) < 0;
    if (first == "-V" || first == "--version") return std::puts("sinew-modeler " SINEW_VERSION) < 0;
    if (first == "--keys") return print_keys();
    if (argc > 2 || (first.starts_with('-') && first != "-")) {
        std::fprintf(stderr, "sinew-modeler: %s; see sinew-modeler --help\n",
                     argc > 2 ? "at most one file can be opened" : "there is no such option");
        return 2;
    }
    if (!names_display()) return without_display("there is no display");
    ask_for_opengl();
    const QtMessageHandler usual = qInstallMessageHandler(quiet_start);
    QApplication application(argc, argv);
    qInstallMessageHandler(usual);
    QApplication::setOrganizationName("Sinew");
    QApplication::setApplicationName("Modeler");
    QApplication::setApplicationVersion(SINEW_VERSION);
    QApplication::setDesktopFileName("sinew-modeler");
    theme::apply(application);
    MainWindow window;
    window.show();
    const QString path = QString::fromLocal8Bit(first.data(), static_cast<qsizetype>(first.size()));
    QTimer::singleShot(0, &window, [&] { window.start(path); });
    return QApplication::exec();
}

}  // namespace sinew::modeler
