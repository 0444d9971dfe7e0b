/// @file desk_window.h
/// Actions in a window without a viewport.
#pragma once

#include <QMainWindow>

#include "modeler/fake_host.h"
#include "tree.h"
#include "window/action_set.h"

namespace sinew::modeler {

struct DeskWindow {
    Desk desk;
    int ran = 0;
    QMainWindow window;
    ActionSet actions{desk.context, window, [this] { ++ran; }};

    DeskWindow() {
        desk.model.replace(small_tree(), true);
        window.resize(1200, 800);
        window.show();
    }
};

}  // namespace sinew::modeler
