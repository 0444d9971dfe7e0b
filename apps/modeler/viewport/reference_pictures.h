/// @file reference_pictures.h
/// Pictures to draw after, behind the views along the axes.
#pragma once

#include <QImage>
#include <array>

#include "document/references.h"
#include "document/screen.h"
#include "sinew/render/camera.h"

class QPainter;

namespace sinew::modeler {

/// What the document remembers, and the picture itself; none where the file cannot be read.
struct ReferencePicture {
    Reference what;
    QImage image;
};

class ReferencePictures {
  public:
    /// Reads the files that are not read yet.
    void follow(const Document& document);
    const ReferencePicture& operator[](int axis) const { return pictures_[axis]; }

  private:
    std::array<ReferencePicture, 3> pictures_;
    std::string seen_;  ///< what the document said last
};

/// Nothing where the file is no picture that can be read.
QImage read_picture(const std::string& file);

/// Paints the picture of the axis that the camera looks along; nothing from any other direction.
void paint_reference(QPainter& painter, const ReferencePictures& pictures, const Camera& camera,
                     const Screen& screen);

}  // namespace sinew::modeler
