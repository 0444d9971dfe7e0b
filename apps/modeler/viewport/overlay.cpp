#include "viewport/overlay.h"

#include <QPainter>
#include <algorithm>

#include "document/images.h"
#include "look/theme.h"

namespace sinew::modeler {
namespace {

const std::size_t most_rings = 3000;  ///< more take too long to paint
const double longest_name = 180;      ///< pixels

QPointF to_qt(const Vec2& v) { return {v.x(), v.y()}; }

void paint_arrow(QPainter& painter, const Vec2& from, const Vec2& to, const QColor& colour, double width) {
    painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(to_qt(from), to_qt(to));
    const Vec2 way = (to - from).normalized(), side(-way.y(), way.x());
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawPolygon(
        QPolygonF{to_qt(to + 9 * way), to_qt(to + 5 * side - 2 * way), to_qt(to - 5 * side - 2 * way)});
}

/// A pill of dark glass behind text.
void paint_label(QPainter& painter, const QRectF& box, const QString& text, const QColor& ink) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme::glass);
    painter.drawRoundedRect(box, 5, 5);
    painter.setPen(ink);
    painter.drawText(box, Qt::AlignCenter, text);
}

}  // namespace

void Overlay::outlines(const Model& model, const Glyphing& glyphs, const Hit& hovered) const {
    const Document& document = model.document();
    const std::vector<Mat3> images = images_of(document.symmetry);
    painter.setBrush(Qt::NoBrush);
    auto circle = [&](const Vec3& centre, double radius, double wider, const QPen& pen) {
        const std::optional<Vec2> middle = screen.project(centre);
        if (!middle) return;
        const double pixels = radius / screen.pixel_length(centre) + wider;
        painter.setPen(pen);
        painter.drawEllipse(to_qt(*middle), pixels, pixels);
    };
    auto extent = [&](std::int32_t node, std::int32_t image, const QColor& colour) {
        circle(images[image] * document.nodes[node].position, document.nodes[node].radius, 0,
               QPen(colour, 1));
    };
    const Selection& selection = model.selection();
    if (selection.nodes.size() <= most_rings)
        for (std::int32_t node : selection.nodes) {
            const GlyphBall ball = ball_round(glyphs.nodes[node]);
            const bool active = node == selection.active;
            circle(ball.centre, ball.radius, 3,
                   QPen(active ? theme::active : theme::selected, active ? 2.2 : 1.6));
        }
    if (hovered.kind == Hit::Kind::node) extent(hovered.index, hovered.image, QColor(255, 255, 255, 150));
    if (selection.active >= 0) extent(selection.active, 0, QColor(255, 240, 176, 110));
}

void Overlay::names(const Model& model) const {
    const Document& document = model.document();
    const QFontMetricsF metrics(painter.font());
    for (std::size_t i = 0; i < document.names.size(); ++i) {
        if (document.names[i].empty()) continue;
        const std::optional<Vec2> at = screen.project(document.nodes[i].position);
        if (!at) continue;
        const QString text =
            metrics.elidedText(QString::fromStdString(document.names[i]), Qt::ElideRight, longest_name);
        paint_label(
            painter,
            QRectF(at->x() + 10, at->y() - 24, metrics.horizontalAdvance(text) + 12, metrics.height() + 3),
            text, theme::text);
    }
}

void Overlay::gizmo(const Vec3& at, const std::optional<AxisLock>& hovered) const {
    for (const GizmoHandle& handle : gizmo_handles(screen, at)) {
        if (handle.shown <= 0) continue;
        const bool lit = hovered && *hovered == handle.lock;
        QColor colour = lit ? theme::active : theme::axis[handle.lock.axis];
        colour.setAlphaF(static_cast<float>(handle.shown));
        if (!handle.lock.plane) {
            paint_arrow(painter, handle.from, handle.to, colour, lit ? 3.5 : 2.5);
            continue;
        }
        painter.setPen(QPen(colour, 1.2));
        colour.setAlphaF(static_cast<float>(0.45 * handle.shown));
        painter.setBrush(colour);
        painter.drawRect(QRectF(to_qt(handle.from) - QPointF(5, 5), QSizeF(10, 10)));
    }
}

void Overlay::guides(const Guides& guides) const {
    for (const Guides::Line& line : guides.lines) {
        QColor colour = line.axis >= 0 ? theme::axis[line.axis] : theme::active;
        painter.setPen(QPen(colour, 1.5, line.axis >= 0 ? Qt::SolidLine : Qt::DashLine));
        // Long guides may pass behind the eye: shorten them until both ends are seen.
        Vec3 from = line.from, to = line.to;
        const Vec3 middle = (from + to) / 2;
        for (int i = 0; i < 24 && !(screen.project(from) && screen.project(to)); ++i) {
            from = (from + middle) / 2;
            to = (to + middle) / 2;
        }
        const auto a = screen.project(from), b = screen.project(to);
        if (a && b) painter.drawLine(to_qt(*a), to_qt(*b));
    }
    if (guides.snapped) {
        if (const auto at = screen.project(*guides.snapped)) {
            painter.setBrush(Qt::NoBrush);
            painter.setPen(QPen(theme::snap, 2));
            painter.drawEllipse(to_qt(*at), 9, 9);
        }
    }
    if (guides.rectangle) {
        painter.setPen(QPen(theme::active, 1, Qt::DashLine));
        painter.setBrush(QColor(255, 240, 176, 24));
        painter.drawRect(QRectF(to_qt((*guides.rectangle)[0]), to_qt((*guides.rectangle)[1])).normalized());
    }
}

void Overlay::hint(const QString& text) const {
    if (text.isEmpty()) return;
    const QFontMetricsF metrics(painter.font());
    const double width = metrics.horizontalAdvance(text) + 24, height = metrics.height() + 12;
    paint_label(painter,
                QRectF((screen.size().x() - width) / 2, screen.size().y() - height - 14, width, height), text,
                theme::text);
}

void Overlay::message(const QString& text) const {
    painter.setPen(theme::dim_text);
    painter.drawText(QRectF(0, 0, screen.size().x(), screen.size().y()), Qt::AlignCenter, text);
}

namespace {

const double cross_margin = 52, cross_arm = 32, ball_radius = 9;

constexpr StandardView view_of[3][2] = {{StandardView::left, StandardView::right},
                                        {StandardView::front, StandardView::back},
                                        {StandardView::bottom, StandardView::top}};

}  // namespace

std::vector<AxisBall> axis_balls(const Camera& camera, const Vec2& size) {
    const Mat3 axes = axes_of(camera);
    std::vector<AxisBall> balls;
    for (int axis = 0; axis < 3; ++axis)
        for (int sign : {-1, 1}) {
            const Vec3 seen = sign * axes.transpose().col(axis);
            const Vec2 middle(size.x() - cross_margin, cross_margin);
            balls.push_back({middle + cross_arm * Vec2(seen.x(), -seen.y()), seen.z(), axis, sign > 0});
        }
    std::sort(balls.begin(), balls.end(),
              [](const AxisBall& a, const AxisBall& b) { return a.depth < b.depth; });
    return balls;
}

std::optional<StandardView> axis_ball_at(const Camera& camera, const Vec2& size, const Vec2& pixel) {
    std::optional<StandardView> found;
    for (const AxisBall& ball : axis_balls(camera, size))
        if ((ball.centre - pixel).norm() <= ball_radius) found = view_of[ball.axis][ball.positive];
    return found;
}

void paint_axis_balls(QPainter& painter, const Camera& camera, const Vec2& size,
                      const std::optional<StandardView>& hovered) {
    const Vec2 middle(size.x() - cross_margin, cross_margin);
    QFont font = painter.font();
    font.setPixelSize(11);
    font.setBold(true);
    painter.save();
    painter.setFont(font);
    for (const AxisBall& ball : axis_balls(camera, size)) {
        const bool lit = hovered && *hovered == view_of[ball.axis][ball.positive];
        QColor colour = theme::axis[ball.axis];
        if (ball.positive) {
            painter.setPen(QPen(colour, 2));
            painter.drawLine(to_qt(middle), to_qt(ball.centre));
        }
        painter.setPen(QPen(lit ? QColor(Qt::white) : colour, 1.5));
        if (!ball.positive) colour = colour.darker(220);
        painter.setBrush(lit ? colour.lighter(125) : colour);
        painter.drawEllipse(to_qt(ball.centre), ball_radius, ball_radius);
        if (!ball.positive) continue;
        painter.setPen(QColor(20, 22, 26));
        painter.drawText(QRectF(ball.centre.x() - 10, ball.centre.y() - 10, 20, 20), Qt::AlignCenter,
                         QString(QChar('X' + ball.axis)));
    }
    painter.restore();
}

}  // namespace sinew::modeler
