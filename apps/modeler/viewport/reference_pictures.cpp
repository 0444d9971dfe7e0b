#include "viewport/reference_pictures.h"

#include <QImageReader>
#include <QPainter>

#include "viewport/view_grid.h"

namespace sinew::modeler {
namespace {

/// The directions of a picture, right and up, in the view that it is made for.
constexpr int right_of[] = {1, 0, 0}, up_of[] = {2, 2, 1};

}  // namespace

QImage read_picture(const std::string& file) {
    QImageReader reader(QString::fromStdString(file));
    reader.setAutoTransform(true);
    return reader.read();
}

void ReferencePictures::follow(const Document& document) {
    if (document.extra == seen_) return;
    seen_ = document.extra;
    const References references = references_of(document);
    for (std::size_t axis = 0; axis < pictures_.size(); ++axis) {
        ReferencePicture& picture = pictures_[axis];
        const bool other = picture.what.file != references[axis].file;
        picture.what = references[axis];
        if (other) picture.image = picture.what.file.empty() ? QImage() : read_picture(picture.what.file);
    }
}

void paint_reference(QPainter& painter, const ReferencePictures& pictures, const Camera& camera,
                     const Screen& screen) {
    const int axis = axis_seen_along(camera);
    if (axis < 0) return;
    const auto& [what, image] = pictures[axis];
    if (image.isNull()) return;
    const Vec3 centre =
        what.offset[0] * Vec3::Unit(right_of[axis]) + what.offset[1] * Vec3::Unit(up_of[axis]);
    const std::optional<Vec2> middle = screen.project(centre);
    if (!middle) return;
    const double height = what.height / screen.pixel_length(centre);
    const double width = height * image.width() / image.height();
    const QRectF place(middle->x() - width / 2, middle->y() - height / 2, width, height);
    painter.save();
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setOpacity(what.opacity);
    // From behind one sees the picture through its back.
    const bool from_behind = axes_of(camera).col(0)[right_of[axis]] < 0;
    painter.drawImage(place, from_behind ? image.mirrored(true, false) : image);
    painter.restore();
}

}  // namespace sinew::modeler
