/// @file reference_dialog.h
/// Which pictures stand behind the views along the axes, how large, where and how strong.
#pragma once

#include <QDialog>
#include <array>
#include <functional>

#include "document/model.h"
#include "document/references.h"

class QGridLayout;
class QPushButton;
class QSlider;

namespace sinew::modeler {

class NumberBox;

/// Changes the document as one turns its figures, each in one undo step.
class ReferenceDialog : public QDialog {
  public:
    ReferenceDialog(Model& model, QWidget* parent);

  private:
    struct Row {
        QPushButton *choose = nullptr, *clear = nullptr;
        NumberBox *height = nullptr, *right = nullptr, *up = nullptr;
        QSlider* opacity = nullptr;
    };
    void add_row(QGridLayout& grid, int axis, const char* title);
    NumberBox* add_number(QGridLayout& grid, int axis, int column, const char* name, double least);
    NumberBox* add_offset(QGridLayout& grid, int axis, int column, const char* name, int part);
    void choose(int axis);
    void change(int axis, int key, const std::function<void(Reference&)>& what);
    void refresh();

    Model& model_;
    std::array<Row, 3> rows_;
};

/// Puts a picture behind the view along an axis, as high as the one that was there; false where the file is
/// no picture.
bool set_reference(Model& model, int axis, const QString& file);

}  // namespace sinew::modeler
