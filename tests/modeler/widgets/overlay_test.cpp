#include "viewport/overlay.h"

#include <gtest/gtest.h>

#include <QPainter>
#include <cmath>

#include "document/edits.h"
#include "look/theme.h"
#include "viewport/navigation.h"

namespace sinew::modeler {
namespace {

const Vec2 size(400, 300);
const Camera front = looking(home_camera(), StandardView::front);

/// A black picture with something painted on it.
struct Sheet {
    QImage image{400, 300, QImage::Format_RGB32};
    Screen screen = screen_of(front, size);

    template <class Paint>
    explicit Sheet(Paint paint) {
        image.fill(Qt::black);
        QPainter painter(&image);
        paint(Overlay{painter, screen}, painter);
    }
    /// How much of a colour there is round a pixel.
    bool has(const Vec2& pixel, const QColor& colour, int round = 2) const {
        for (int y = -round; y <= round; ++y)
            for (int x = -round; x <= round; ++x) {
                const QPoint at(static_cast<int>(pixel.x()) + x, static_cast<int>(pixel.y()) + y);
                if (!image.rect().contains(at)) continue;
                const QColor seen = image.pixelColor(at);
                const int apart = std::abs(seen.red() - colour.red()) +
                                  std::abs(seen.green() - colour.green()) +
                                  std::abs(seen.blue() - colour.blue());
                if (apart < 60) return true;
            }
        return false;
    }
    bool empty() const {
        QImage black = image;
        black.fill(Qt::black);
        return image == black;
    }
};

/// A root at the origin and a child named "hand".
struct Limb {
    Model model;
    Limb() {
        Document document = starting_document();
        append_node(document, {.id = -1, .parent = 0, .position = Vec3(1.5, 0, 0), .radius = 0.3});
        model.replace(rename(document, 1, "hand"), true);
    }
    Glyphing glyphs() const { return glyphs_of(model.document(), 1); }
};

TEST(Overlay, rings_are_round_what_is_selected) {
    Limb limb;
    const Sheet none(
        [&](const Overlay& overlay, QPainter&) { overlay.outlines(limb.model, limb.glyphs(), {}); });
    EXPECT_TRUE(none.empty());
    limb.model.select(selection_of(1));
    const Sheet one(
        [&](const Overlay& overlay, QPainter&) { overlay.outlines(limb.model, limb.glyphs(), {}); });
    const Vec2 middle = *one.screen.project(Vec3(1.5, 0, 0));
    const double radius = 0.3 / one.screen.pixel_length(Vec3::Zero()) + 3;
    for (int turn = 0; turn < 8; ++turn) {
        const Vec2 way(std::cos(turn * 0.785), std::sin(turn * 0.785));
        EXPECT_TRUE(one.has(middle + radius * way, theme::active)) << turn;
    }
    EXPECT_FALSE(one.has(*one.screen.project(Vec3(0, 0, 0.5)), theme::active, 6));
}

TEST(Overlay, names_stand_beside_their_nodes) {
    const Limb limb;
    const Sheet sheet([&](const Overlay& overlay, QPainter&) { overlay.names(limb.model); });
    const Vec2 at = *sheet.screen.project(Vec3(1.5, 0, 0));
    EXPECT_TRUE(sheet.has(at + Vec2(26, -15), theme::text, 14));
    EXPECT_FALSE(sheet.has(*sheet.screen.project(Vec3::Zero()) + Vec2(26, -15), theme::text, 14));
}

TEST(Overlay, arrows_of_the_gizmo_are_where_they_are_taken) {
    const Sheet sheet([](const Overlay& overlay, QPainter&) { overlay.gizmo(Vec3::Zero(), {}); });
    for (const GizmoHandle& handle : gizmo_handles(sheet.screen, Vec3::Zero())) {
        const Vec2 middle = (handle.from + handle.to) / 2;
        const bool painted = sheet.has(middle, theme::axis[handle.lock.axis], 2) || handle.lock.plane;
        EXPECT_EQ(painted, handle.shown > 0 || handle.lock.plane) << handle.lock.axis;
    }
    const AxisLock up{2, false};
    const Sheet lit([&](const Overlay& overlay, QPainter&) { overlay.gizmo(Vec3::Zero(), up); });
    const GizmoHandle arrow = gizmo_handles(lit.screen, Vec3::Zero())[2];
    EXPECT_TRUE(lit.has((arrow.from + arrow.to) / 2, theme::active));
}

TEST(Overlay, guides_mark_the_snap_the_axis_and_the_box) {
    Guides guides;
    guides.snapped = Vec3(1, 0, 0);
    guides.lines = {{Vec3(-1e3, 0, 1), Vec3(1e3, 0, 1), 0}};
    guides.rectangle = {Vec2(20, 20), Vec2(60, 50)};
    const Sheet sheet([&](const Overlay& overlay, QPainter&) { overlay.guides(guides); });
    EXPECT_TRUE(sheet.has(*sheet.screen.project(Vec3(1, 0, 0)) + Vec2(9, 0), theme::snap));
    EXPECT_TRUE(sheet.has(*sheet.screen.project(Vec3(-1, 0, 1)), theme::axis[0]));
    EXPECT_TRUE(sheet.has({40, 20}, theme::active, 6));
    EXPECT_FALSE(sheet.has({40, 70}, theme::active, 6));
}

TEST(Overlay, an_empty_hint_leaves_no_mark) {
    EXPECT_TRUE(Sheet([](const Overlay& overlay, QPainter&) { overlay.hint(""); }).empty());
    const Sheet sheet([](const Overlay& overlay, QPainter&) { overlay.hint("Move: 2 m"); });
    EXPECT_TRUE(sheet.has({200, 300 - 25}, theme::text, 12));
}

TEST(AxisBalls, lead_to_the_view_from_there) {
    const struct {
        StandardView from;
        Vec2 way;  ///< from the middle of the cross, as seen from the front
    } expected[] = {{StandardView::right, {1, 0}},
                    {StandardView::left, {-1, 0}},
                    {StandardView::top, {0, -1}},
                    {StandardView::bottom, {0, 1}}};
    Vec2 middle(0, 0);
    for (const AxisBall& ball : axis_balls(front, size)) middle += ball.centre / 6;
    for (const auto& [view, way] : expected) {
        EXPECT_EQ(axis_ball_at(front, size, middle + 32 * way), view);
        EXPECT_EQ(axis_ball_at(front, size, middle + 32 * way + Vec2(7, 7)), std::nullopt);
    }
    EXPECT_EQ(axis_ball_at(front, size, middle), StandardView::front);  // the nearer of two
    EXPECT_EQ(axis_ball_at(front, size, {20, 250}), std::nullopt);
}

TEST(AxisBalls, are_painted_where_they_are_clicked) {
    const Sheet sheet(
        [](const Overlay&, QPainter& painter) { paint_axis_balls(painter, home_camera(), size, {}); });
    for (const AxisBall& ball : axis_balls(home_camera(), size))
        EXPECT_TRUE(sheet.has(ball.centre, theme::axis[ball.axis], 9)) << ball.axis;
}

}  // namespace
}  // namespace sinew::modeler
