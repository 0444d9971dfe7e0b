#include "viewport/reference_pictures.h"

#include <gtest/gtest.h>

#include <QPainter>

#include "document/edits.h"
#include "modeler/temporary_folder.h"
#include "viewport/navigation.h"

namespace sinew::modeler {
namespace {

/// A picture four units high behind the view from the front; its left half is red, its right half blue.
struct RedAndBlue {
    TemporaryFolder folder;
    References references;
    RedAndBlue() {
        QImage image(20, 20, QImage::Format_RGB32);
        image.fill(Qt::blue);
        QPainter(&image).fillRect(0, 0, 10, 20, Qt::red);
        references[1] = {folder.file("front.png"), 4, 1, {0, 0}};
        image.save(QString::fromStdString(references[1].file));
    }
    ReferencePictures pictures() const {
        ReferencePictures pictures;
        pictures.follow(with_references(starting_document(), references));
        return pictures;
    }
};

/// What is seen at a place of the plane through the origin, as the view from the front has it.
QColor seen_at(const ReferencePictures& pictures, const Camera& camera, double right, double up) {
    QImage seen(200, 200, QImage::Format_RGB32);
    seen.fill(Qt::black);
    QPainter painter(&seen);
    const Screen screen = screen_of(camera, {200, 200});
    paint_reference(painter, pictures, camera, screen);
    const Vec3 place = axes_of(camera).col(0) * right + axes_of(camera).col(1) * up;
    const Vec2 pixel = *screen.project(place);
    return seen.pixelColor(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
}

const Camera front = looking(home_camera(), StandardView::front);

TEST(ReferencePictures, one_is_seen_from_its_own_direction_only) {
    const RedAndBlue files;
    const ReferencePictures pictures = files.pictures();
    EXPECT_EQ(seen_at(pictures, front, -0.5, 0), QColor(Qt::red));
    EXPECT_EQ(seen_at(pictures, front, 0.5, 0), QColor(Qt::blue));
    EXPECT_EQ(seen_at(pictures, looking(front, StandardView::right), -0.5, 0), QColor(Qt::black));
    EXPECT_EQ(seen_at(pictures, home_camera(), -0.5, 0), QColor(Qt::black));
}

TEST(ReferencePictures, from_behind_one_is_mirrored) {
    const RedAndBlue files;
    EXPECT_EQ(seen_at(files.pictures(), looking(front, StandardView::back), -0.5, 0), QColor(Qt::blue));
}

TEST(ReferencePictures, is_as_high_as_it_says_and_where_it_says) {
    RedAndBlue files;
    EXPECT_EQ(seen_at(files.pictures(), front, -0.5, 1.9), QColor(Qt::red));
    EXPECT_EQ(seen_at(files.pictures(), front, -0.5, 2.1), QColor(Qt::black));
    files.references[1].height = 2;
    EXPECT_EQ(seen_at(files.pictures(), front, -0.5, 1.1), QColor(Qt::black));
    files.references[1].offset = {2, 1};
    EXPECT_EQ(seen_at(files.pictures(), front, 1.5, 1.9), QColor(Qt::red));
    EXPECT_EQ(seen_at(files.pictures(), front, 2.5, 0.1), QColor(Qt::blue));
    EXPECT_EQ(seen_at(files.pictures(), front, 1.5, -0.1), QColor(Qt::black));
}

TEST(ReferencePictures, opacity_lets_the_background_through) {
    RedAndBlue files;
    files.references[1].opacity = 0.5;
    const QColor seen = seen_at(files.pictures(), front, -0.5, 0);
    EXPECT_NEAR(seen.red(), 128, 3);
    EXPECT_EQ(seen.blue(), 0);
}

TEST(ReferencePictures, follow_the_document) {
    const RedAndBlue files;
    ReferencePictures pictures = files.pictures();
    pictures.follow(starting_document());
    EXPECT_EQ(seen_at(pictures, front, -0.5, 0), QColor(Qt::black));
    pictures.follow(with_references(starting_document(), files.references));
    EXPECT_EQ(seen_at(pictures, front, -0.5, 0), QColor(Qt::red));
}

TEST(ReferencePictures, a_file_that_is_gone_or_no_picture_is_not_seen) {
    RedAndBlue files;
    files.references[1].file = files.folder.file("gone.png");
    EXPECT_EQ(seen_at(files.pictures(), front, -0.5, 0), QColor(Qt::black));
    EXPECT_TRUE(read_picture(files.folder.file("gone.png")).isNull());
}

}  // namespace
}  // namespace sinew::modeler
