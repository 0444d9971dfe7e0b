/// @file type_menu.h
/// The types of nodes in a ring round the pointer: one short stroke, or a digit, chooses.
#pragma once

#include <QWidget>
#include <functional>

#include "sinew/skeleton/document.h"

namespace sinew::modeler {

class TypeMenu : public QWidget {
  public:
    TypeMenu(QWidget* parent, std::function<void(NodeType)> chosen);
    void open(const QPoint& at);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

  private:
    int sector_at(const QPointF& at) const;
    void choose(int sector);

    std::function<void(NodeType)> chosen_;
    int hovered_ = -1;
};

}  // namespace sinew::modeler
