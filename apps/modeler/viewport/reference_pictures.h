/// @file reference_pictures.h
/// Pictures to draw after, behind the views along the axes.
#pragma once

#include <QImage>
#include <QString>
#include <array>

#include "document/screen.h"
#include "sinew/render/camera.h"

class QPainter;

namespace sinew::modeler {

/// A picture that stands in the plane across one axis, its middle at the origin.
struct ReferencePicture {
    QString file;
    QImage image;
    double height = 4;  ///< in the document's units
    double opacity = 0.5;

    bool load(const QString& path);  ///< false where it is no picture that can be read
};

/// By the axis one looks along: x (side), y (front), z (above).
using ReferencePictures = std::array<ReferencePicture, 3>;

/// Paints the picture of the axis that the camera looks along; nothing from any other direction.
void paint_reference(QPainter& painter, const ReferencePictures& pictures, const Camera& camera,
                     const Screen& screen);

}  // namespace sinew::modeler
