#include "viewport/reference_pictures.h"

#include <gtest/gtest.h>

#include <QPainter>

#include "viewport/navigation.h"

namespace sinew::modeler {
namespace {

/// Left half red, right half blue, behind the view from the front.
ReferencePictures red_and_blue() {
    ReferencePictures pictures;
    pictures[1].image = QImage(20, 20, QImage::Format_RGB32);
    pictures[1].image.fill(Qt::blue);
    QPainter(&pictures[1].image).fillRect(0, 0, 10, 20, Qt::red);
    pictures[1].opacity = 1;
    return pictures;
}

/// What is seen a little to the left of the middle.
QColor left_of_middle(const ReferencePictures& pictures, const Camera& camera) {
    QImage seen(200, 200, QImage::Format_RGB32);
    seen.fill(Qt::black);
    QPainter painter(&seen);
    paint_reference(painter, pictures, camera, screen_of(camera, {200, 200}));
    return seen.pixelColor(90, 100);
}

TEST(ReferencePictures, one_is_seen_from_its_own_direction_only) {
    const Camera front = looking(home_camera(), StandardView::front);
    EXPECT_EQ(left_of_middle(red_and_blue(), front), QColor(Qt::red));
    EXPECT_EQ(left_of_middle(red_and_blue(), looking(front, StandardView::right)), QColor(Qt::black));
    EXPECT_EQ(left_of_middle(red_and_blue(), home_camera()), QColor(Qt::black));
}

TEST(ReferencePictures, from_behind_one_is_mirrored) {
    const Camera back = looking(home_camera(), StandardView::back);
    EXPECT_EQ(left_of_middle(red_and_blue(), back), QColor(Qt::blue));
}

TEST(ReferencePictures, opacity_lets_the_background_through) {
    ReferencePictures pictures = red_and_blue();
    pictures[1].opacity = 0.5;
    const QColor seen = left_of_middle(pictures, looking(home_camera(), StandardView::front));
    EXPECT_NEAR(seen.red(), 128, 3);
    EXPECT_EQ(seen.blue(), 0);
}

TEST(ReferencePictures, what_is_no_picture_is_refused_and_the_old_one_stays) {
    ReferencePicture picture = red_and_blue()[1];
    EXPECT_FALSE(picture.load("/nowhere/at/all.png"));
    EXPECT_FALSE(picture.image.isNull());
}

}  // namespace
}  // namespace sinew::modeler
