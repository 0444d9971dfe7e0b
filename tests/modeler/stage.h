/// @file stage.h
/// A model, a camera and a hand, for tests of tools: what one does with a mouse, without a window.
#pragma once

#include <cmath>

#include "document/edits.h"
#include "document/model.h"
#include "tools/interaction.h"

namespace sinew::modeler {

/// Looks along +y from afar with x to the right and z up; a unit is 100 pixels, the origin is at (400, 300).
inline Screen front_screen() {
    Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
    m(0, 0) = 100 / 400.0;
    m(1, 2) = 100 / 300.0;
    m(2, 1) = 1 / 1000.0;
    m(3, 3) = 1;
    return {m, {800, 600}};
}

/// The same place seen by a perspective camera at y = -10.
inline Screen perspective_screen() {
    const double near = 1, far = 100, eye = 10, height = 3;
    Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
    m(0, 0) = eye / (height * 800 / 600);
    m(1, 2) = eye / height;
    m(2, 1) = (far + near) / (far - near);
    m(2, 3) = eye * (far + near) / (far - near) - 2 * far * near / (far - near);
    m(3, 1) = 1;
    m(3, 3) = eye;
    return {m, {800, 600}};
}

inline Vec2 pixel_of(double x, double z) { return {400 + 100 * x, 300 - 100 * z}; }

inline Document plain_document() {
    Document document;
    document.nodes.push_back({.radius = 0.5});
    return document;
}

struct Hand {
    Model model;
    Interaction tools{model};
    Screen screen = front_screen();

    explicit Hand(Document document) { model.replace(std::move(document), true); }

    static Pointer at(double x, double z, bool ctrl = false, bool shift = false) {
        return {pixel_of(x, z), shift, ctrl};
    }
    void click(double x, double z, bool shift = false) {
        tools.press(at(x, z, false, shift), screen);
        tools.release(at(x, z, false, shift), screen);
    }
    void drag(Vec2 from, Vec2 to, bool ctrl = false, bool shift = false) {
        tools.press(at(from.x(), from.y(), false, shift), screen);
        const Vec2 middle = (from + to) / 2;
        tools.move(at(middle.x(), middle.y(), ctrl, shift), screen);
        tools.move(at(to.x(), to.y(), ctrl, shift), screen);
        tools.release(at(to.x(), to.y(), ctrl, shift), screen);
    }
    const Node& node(int i) const { return model.document().nodes[i]; }
};

}  // namespace sinew::modeler
