#include "viewport/reference_pictures.h"

#include <QImageReader>
#include <QPainter>

#include "viewport/view_grid.h"

namespace sinew::modeler {

bool ReferencePicture::load(const QString& path) {
    QImageReader reader(path);
    reader.setAutoTransform(true);
    const QImage read = reader.read();
    if (read.isNull()) return false;
    image = read;
    file = path;
    return true;
}

void paint_reference(QPainter& painter, const ReferencePictures& pictures, const Camera& camera,
                     const Screen& screen) {
    const int axis = axis_seen_along(camera);
    if (axis < 0) return;
    const Mat3 axes = axes_of(camera);
    const ReferencePicture& picture = pictures[axis];
    if (picture.image.isNull()) return;
    const std::optional<Vec2> middle = screen.project(Vec3::Zero());
    if (!middle) return;
    const double height = picture.height / screen.pixel_length(Vec3::Zero());
    const double width = height * picture.image.width() / picture.image.height();
    const QRectF place(middle->x() - width / 2, middle->y() - height / 2, width, height);
    painter.save();
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setOpacity(picture.opacity);
    // From behind one sees the picture through its back.
    const bool from_behind = axis == 1 ? axes(1, 2) > 0 : axes(axis, 2) < 0;
    painter.drawImage(place, from_behind ? picture.image.mirrored(true, false) : picture.image);
    painter.restore();
}

}  // namespace sinew::modeler
