#include "viewport/navigation.h"

#include <gtest/gtest.h>

#include "document/edits.h"

namespace sinew::modeler {
namespace {

const Vec2 size(800, 600);

Camera parallel() { return looking(home_camera(), StandardView::front); }

/// The point at the target's depth under a pixel.
Vec3 under(const Camera& camera, const Vec2& pixel) {
    return *meet_plane(screen_of(camera, size).ray(pixel), camera.target, axes_of(camera).col(2));
}

TEST(ScreenOf, is_where_the_renderer_draws) {
    const Bounds box(Vec3f(-3, -3, -3), Vec3f(3, 3, 3));
    for (const Camera& camera : {home_camera(), parallel(), looking(home_camera(), StandardView::top)}) {
        const Eigen::Matrix4f drawn =
            projection_matrix(camera, size.x() / size.y(), box) * view_matrix(camera);
        for (const Vec3& point : {Vec3(0, 0, 0), Vec3(1, 2, -1), Vec3(-2, 0.5, 1.5)}) {
            const Eigen::Vector4f clip = drawn * point.cast<float>().homogeneous();
            const Vec2 pixel((1 + clip.x() / clip.w()) * size.x() / 2,
                             (1 - clip.y() / clip.w()) * size.y() / 2);
            EXPECT_LT((*screen_of(camera, size).project(point) - pixel).norm(), 1e-2) << point.transpose();
        }
    }
}

TEST(DragOf, middle_and_right_and_alt_with_left_move_the_camera) {
    const Qt::KeyboardModifiers none, alt = Qt::AltModifier;
    EXPECT_EQ(drag_of(Qt::LeftButton, none), Drag::tool);
    EXPECT_EQ(drag_of(Qt::LeftButton, Qt::ShiftModifier), Drag::tool);
    EXPECT_EQ(drag_of(Qt::BackButton, none), Drag::none);
    for (const auto& [button, held] :
         {std::pair{Qt::MiddleButton, none}, {Qt::RightButton, none}, {Qt::LeftButton, alt}}) {
        EXPECT_EQ(drag_of(button, held), Drag::orbit);
        EXPECT_EQ(drag_of(button, held | Qt::ShiftModifier), Drag::pan);
        EXPECT_EQ(drag_of(button, held | Qt::ControlModifier), Drag::zoom);
    }
}

TEST(Dragged, to_the_right_brings_the_left_side_to_the_front) {
    const Camera turned = dragged(parallel(), Drag::orbit, {50, 0}, {0, 0}, size);
    const Vec3 left(-1, 0, 0);
    EXPECT_GT(axes_of(turned).col(2).dot(left), 0);  // the eye has moved to that side
    EXPECT_EQ(turned.target, parallel().target);
    EXPECT_EQ(turned.distance, parallel().distance);
    const Camera back = dragged(turned, Drag::orbit, {-50, 0}, {0, 0}, size);
    EXPECT_NEAR(back.azimuth, parallel().azimuth, 1e-9);
    const Camera down = dragged(parallel(), Drag::orbit, {0, 5000}, {0, 0}, size);
    EXPECT_EQ(down.elevation, 90);  // not over the top
}

TEST(Dragged, pan_keeps_what_is_under_the_pointer) {
    for (const Camera& camera : {home_camera(), parallel()}) {
        const Vec2 from(200, 450), by(73, -41);
        const Camera moved = dragged(camera, Drag::pan, by, from, size);
        EXPECT_LT((under(moved, from + by) - under(camera, from)).norm(), 1e-9);
        EXPECT_EQ(moved.azimuth, camera.azimuth);
        EXPECT_EQ(moved.distance, camera.distance);
    }
}

TEST(Dragged, zoom_keeps_what_it_was_begun_at) {
    for (const Camera& camera : {home_camera(), parallel()}) {
        const Vec2 at(610, 120);
        const Camera nearer = dragged(camera, Drag::zoom, {0, -80}, at, size);
        EXPECT_LT(nearer.distance, camera.distance);
        EXPECT_LT((under(nearer, at) - under(camera, at)).norm(), 1e-9);
        EXPECT_NEAR(dragged(nearer, Drag::zoom, {0, 80}, at, size).distance, camera.distance, 1e-9);
        EXPECT_EQ(dragged(camera, Drag::tool, {9, 9}, at, size).distance, camera.distance);
    }
}

TEST(Zoomed, a_notch_forth_and_back_is_nothing) {
    const Camera there = zoomed(home_camera(), 3, {100, 100}, size),
                 back = zoomed(there, -3, {100, 100}, size);
    EXPECT_NEAR(back.distance, home_camera().distance, 1e-9);
    EXPECT_LT((back.target - home_camera().target).norm(), 1e-9);
}

TEST(Looking, is_along_the_axis_and_upright) {
    struct Expected {
        StandardView view;
        Vec3 ahead, right;
    };
    const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
    for (const Expected& expected : {Expected{StandardView::front, y, x},
                                     {StandardView::back, -y, -x},
                                     {StandardView::right, -x, y},
                                     {StandardView::left, x, -y},
                                     {StandardView::top, -z, x},
                                     {StandardView::bottom, z, x}}) {
        const Camera camera = looking(home_camera(), expected.view);
        EXPECT_LT((axes_of(camera).col(2) + expected.ahead).norm(), 1e-9);
        EXPECT_LT((axes_of(camera).col(0) - expected.right).norm(), 1e-9);
        EXPECT_EQ(camera.projection, Projection::orthographic);
        EXPECT_EQ(camera.target, home_camera().target);
    }
}

TEST(Framed, all_of_it_is_in_the_picture_and_fills_it) {
    Document document = starting_document();  // mirrored
    append_node(document, {.id = -1, .parent = 0, .position = Vec3(7, 1, 3), .radius = 0.8});
    const Bounds box = bounds_of(document, std::vector<std::int32_t>{0, 1});
    EXPECT_NEAR(box.min().x(), -7.8, 1e-5);  // the image of it counts
    EXPECT_NEAR(box.max().z(), 3.8, 1e-5);
    for (const Camera& camera : {home_camera(), parallel()}) {
        const Screen screen = screen_of(framed(camera, box, size), size);
        Vec2 low = size, high(0, 0);
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 at = box.corner(static_cast<Bounds::CornerType>(corner)).cast<double>();
            low = low.cwiseMin(*screen.project(at));
            high = high.cwiseMax(*screen.project(at));
        }
        EXPECT_GE(low.minCoeff(), 0);
        EXPECT_TRUE((high.array() <= size.array()).all());
        EXPECT_GT(((high - low).array() / size.array()).maxCoeff(), 0.6);
    }
    EXPECT_EQ(framed(home_camera(), Bounds(), size).distance, home_camera().distance);
}

}  // namespace
}  // namespace sinew::modeler
