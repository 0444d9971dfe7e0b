#include "window/type_menu.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <cmath>
#include <numbers>

#include "look/icons.h"
#include "look/theme.h"

namespace sinew::modeler {
namespace {

constexpr int side = 250, types = 6;
constexpr double inner = 34, ring = 84;
const char* const names[] = {"Sphere", "Cone", "Flat end", "Cube", "Negative", "Ball"};
const char* const icons[] = {"type.sphere", "type.cone",     "type.hemisphere",
                             "type.cube",   "type.negative", "type.ball"};

/// Angle of a sector's middle; the first is at the top, the others follow clockwise.
double angle_of(int sector) { return (sector * 360.0 / types - 90) * std::numbers::pi / 180; }

}  // namespace

TypeMenu::TypeMenu(QWidget* parent, std::function<void(NodeType)> chosen)
    : QWidget(parent), chosen_(std::move(chosen)) {
    setObjectName("type_menu");
    setFixedSize(side, side);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    hide();
}

void TypeMenu::open(const QPoint& at) {
    hovered_ = -1;
    const QRect room = parentWidget()->rect();
    move(std::clamp(at.x() - side / 2, 0, std::max(0, room.width() - side)),
         std::clamp(at.y() - side / 2, 0, std::max(0, room.height() - side)));
    show();
    raise();
    setFocus();
}

int TypeMenu::sector_at(const QPointF& at) const {
    const QPointF way = at - QPointF(side / 2.0, side / 2.0);
    if (std::hypot(way.x(), way.y()) < inner) return -1;
    const double turns = (std::atan2(way.y(), way.x()) * 180 / std::numbers::pi + 90) / (360.0 / types);
    return (static_cast<int>(std::lround(turns)) + types) % types;
}

void TypeMenu::choose(int sector) {
    hide();
    parentWidget()->setFocus();
    if (sector >= 0) chosen_(static_cast<NodeType>(sector));
}

void TypeMenu::mouseMoveEvent(QMouseEvent* event) {
    hovered_ = sector_at(event->position());
    update();
}

void TypeMenu::mousePressEvent(QMouseEvent* event) { event->accept(); }

void TypeMenu::mouseReleaseEvent(QMouseEvent* event) { choose(sector_at(event->position())); }

bool TypeMenu::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::FocusOut) hide();
    return QWidget::event(event);
}

void TypeMenu::keyPressEvent(QKeyEvent* event) {
    const int digit = event->key() - Qt::Key_1;
    choose(digit >= 0 && digit < types ? digit : -1);
}

void TypeMenu::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF middle(side / 2.0, side / 2.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(24, 26, 31, 225));
    painter.drawEllipse(middle, side / 2.0 - 1, side / 2.0 - 1);
    if (hovered_ >= 0) {
        painter.setBrush(QColor(0x34, 0x55, 0x7f));
        const double start = -angle_of(hovered_) * 180 / std::numbers::pi - 180.0 / types;
        painter.drawPie(QRectF(3, 3, side - 6, side - 6), static_cast<int>(16 * start),
                        static_cast<int>(16 * 360 / types));
    }
    painter.setBrush(QColor(36, 39, 45));
    painter.drawEllipse(middle, inner, inner);
    for (int i = 0; i < types; ++i) {
        const QPointF at = middle + ring * QPointF(std::cos(angle_of(i)), std::sin(angle_of(i)));
        icon(icons[i]).paint(&painter, QRect((at - QPointF(14, 22)).toPoint(), QSize(28, 28)));
        painter.setPen(theme::text);
        painter.drawText(QRectF(at.x() - 45, at.y() + 6, 90, 18), Qt::AlignCenter,
                         QString("%1  %2").arg(i + 1).arg(names[i]));
    }
    painter.setPen(theme::dim_text);
    painter.drawText(QRectF(middle - QPointF(40, 10), QSizeF(80, 20)), Qt::AlignCenter, "Type");
}

}  // namespace sinew::modeler
