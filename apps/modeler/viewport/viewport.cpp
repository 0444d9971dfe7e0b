#include "viewport/viewport.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QPainter>
#include <cmath>

#include "look/theme.h"
#include "viewport/overlay.h"
#include "viewport/scene_view.h"
#include "viewport/view_grid.h"

namespace sinew::modeler {
namespace {

const double click_reach = 4;  ///< pixels that the right button may move and still open the menu

Vec2 to_vec(const QPointF& p) { return {p.x(), p.y()}; }

Pointer pointer_of(const QSinglePointEvent& event) {
    return {to_vec(event.position()), event.modifiers().testFlag(Qt::ShiftModifier),
            event.modifiers().testFlag(Qt::ControlModifier)};
}

}  // namespace

Viewport::Viewport(Model& model, Interaction& tools, const ViewSettings& view, QWidget* parent)
    : QOpenGLWidget(parent), model_(model), tools_(tools), view_(view), camera_(home_camera()) {
    setObjectName("viewport");
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(320, 240);
    model_.observe([this](const Changes& changes) {
        if (changes.document) references_.follow(model_.document());
        update();
    });
}

Viewport::~Viewport() { release(); }

void Viewport::release() {
    if (!scene_) return;
    makeCurrent();
    scene_.reset();
    doneCurrent();
}

void Viewport::show_mesh(std::shared_ptr<const LiveMesh> mesh) {
    mesh_ = std::move(mesh);
    mesh_changed_ = true;
    update();
}

void Viewport::set_camera(const Camera& camera) {
    camera_ = camera;
    refresh();
}

Screen Viewport::screen() const { return screen_of(camera_, Vec2(width(), height())); }

Pointer Viewport::pointer() const {
    const Qt::KeyboardModifiers held = QGuiApplication::queryKeyboardModifiers();
    return {to_vec(mapFromGlobal(QCursor::pos())), held.testFlag(Qt::ShiftModifier),
            held.testFlag(Qt::ControlModifier)};
}

void Viewport::refresh() {
    update();
    update_cursor();
    if (changed) changed();
}

void Viewport::start(Modal modal) {
    // The key may come while the pointer is elsewhere: then the gesture starts in the middle.
    Pointer from{last_};
    if (!rect().contains(QPointF(last_.x(), last_.y()).toPoint())) from.pixel = Vec2(width(), height()) / 2;
    setFocus();
    tools_.start(modal, from, screen());
    refresh();
}

void Viewport::initializeGL() {
    // Qt may give the widget another context, as when the window goes to another screen.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { release(); });
    auto scene = SceneView::create();
    if (!scene) {
        if (failed) failed(QString::fromStdString(scene.error().text()));
        return;
    }
    scene_ = std::make_unique<SceneView>(std::move(*scene));
    mesh_changed_ = mesh_ != nullptr;
}

void Viewport::paintGL() {
    // The cursor and the status line follow when the picture is there.
    if (tools_.look_again(screen()))
        QMetaObject::invokeMethod(
            this, [this] { refresh(); }, Qt::QueuedConnection);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QLinearGradient sky(0, 0, 0, height());
    sky.setColorAt(0, theme::viewport_top);
    sky.setColorAt(1, theme::viewport_bottom);
    painter.fillRect(rect(), sky);
    paint_reference(painter, references_, camera_, screen());
    if (view_.grid) paint_view_grid(painter, camera_, screen());
    if (scene_) {
        painter.beginNativePainting();
        if (mesh_changed_) scene_->set_mesh(mesh_);
        mesh_changed_ = false;
        const double ratio = devicePixelRatioF();
        scene_->draw(model_, tools_, view_, camera_, static_cast<int>(std::lround(width() * ratio)),
                     static_cast<int>(std::lround(height() * ratio)), ratio);
        painter.endNativePainting();
    }
    paint_overlay(painter);
}

void Viewport::paint_overlay(QPainter& painter) {
    const Screen here = screen();
    const Overlay overlay{painter, here};
    painter.setRenderHint(QPainter::Antialiasing);
    if (view_.bones) overlay.outlines(model_, tools_.glyphs(), tools_.hovered());
    if (view_.names) overlay.names(model_);
    if (const auto gizmo = tools_.gizmo_place()) overlay.gizmo(*gizmo, tools_.hovered_handle());
    overlay.guides(tools_.guides());
    paint_axis_balls(painter, camera_, here.size(), hovered_ball_);
    overlay.hint(QString::fromStdString(tools_.hint()));
    if (model_.document().nodes.empty()) overlay.message("Click to place a root");
}

void Viewport::mousePressEvent(QMouseEvent* event) {
    pressed_at_ = last_ = to_vec(event->position());
    right_moved_ = false;
    if (drag_ != Drag::none) return;
    if (event->button() == Qt::RightButton && tools_.active()) {
        tools_.cancel();
        right_moved_ = true;  // so that no menu opens
        return refresh();
    }
    drag_ = drag_of(event->button(), event->modifiers());
    pressed_ball_ = axis_ball_at(camera_, screen().size(), pressed_at_);
    if (drag_ == Drag::tool && !pressed_ball_) tools_.press(pointer_of(*event), screen());
    refresh();
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
    const Vec2 now = to_vec(event->position());
    if ((now - pressed_at_).norm() > click_reach) right_moved_ = true;
    if (drag_ == Drag::none || drag_ == Drag::tool) {
        if (!pressed_ball_) tools_.move(pointer_of(*event), screen());
        hovered_ball_ = tools_.active() ? std::nullopt : axis_ball_at(camera_, screen().size(), now);
    } else {
        camera_ = dragged(camera_, drag_, now - last_, pressed_at_, Vec2(width(), height()));
    }
    last_ = now;
    refresh();
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
    const Vec2 now = to_vec(event->position());
    const Drag ended = drag_;
    if (event->buttons() == Qt::NoButton) drag_ = Drag::none;
    if (pressed_ball_) {
        if (axis_ball_at(camera_, screen().size(), now) == pressed_ball_)
            camera_ = looking(camera_, *pressed_ball_);
        pressed_ball_.reset();
    } else if (ended == Drag::tool && event->button() == Qt::LeftButton) {
        tools_.release(pointer_of(*event), screen());
    } else if (event->button() == Qt::RightButton && !right_moved_ && context_menu_wanted) {
        tools_.move(pointer_of(*event), screen());
        context_menu_wanted(event->globalPosition().toPoint());
    }
    refresh();
}

void Viewport::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / 120.0;
    const Pointer at = pointer_of(*event);
    event->accept();
    if (notches == 0) return;
    if (at.ctrl || !tools_.wheel(at, screen(), notches))
        camera_ = zoomed(camera_, notches, at.pixel, Vec2(width(), height()));
    refresh();
}

bool Viewport::gesture_key(const QKeyEvent& event) {
    if (!tools_.active()) return false;
    switch (event.key()) {
        case Qt::Key_Escape:
            tools_.cancel();
            return true;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            tools_.finish();
            return true;
        case Qt::Key_Backspace:
            tools_.type('\b', screen());
            return true;
        case Qt::Key_Shift:
        case Qt::Key_Control:
            tools_.move({last_, event.modifiers().testFlag(Qt::ShiftModifier),
                         event.modifiers().testFlag(Qt::ControlModifier)},
                        screen());
            return true;
        default:
            break;
    }
    if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier) || event.text().isEmpty()) return false;
    return tools_.type(event.text().front().toLatin1(), screen());
}

bool Viewport::event(QEvent* event) {
    // While a gesture runs its keys come before all shortcuts.
    if (event->type() == QEvent::ShortcutOverride && tools_.active()) {
        event->accept();
        return true;
    }
    return QOpenGLWidget::event(event);
}

void Viewport::keyPressEvent(QKeyEvent* event) {
    if (gesture_key(*event)) return refresh();
    QOpenGLWidget::keyPressEvent(event);
}

void Viewport::keyReleaseEvent(QKeyEvent* event) {
    const bool modifier = event->key() == Qt::Key_Shift || event->key() == Qt::Key_Control;
    if (modifier && gesture_key(*event)) return refresh();
    QOpenGLWidget::keyReleaseEvent(event);
}

void Viewport::leaveEvent(QEvent* event) {
    tools_.leave();
    hovered_ball_.reset();
    refresh();
    QOpenGLWidget::leaveEvent(event);
}

void Viewport::focusOutEvent(QFocusEvent* event) {
    if (event->reason() == Qt::ActiveWindowFocusReason && tools_.active()) tools_.cancel();
    QOpenGLWidget::focusOutEvent(event);
}

void Viewport::update_cursor() {
    Qt::CursorShape shape = Qt::ArrowCursor;
    if (drag_ == Drag::pan || tools_.active())
        shape = Qt::SizeAllCursor;
    else if (hovered_ball_ || tools_.hovered_handle())
        shape = Qt::PointingHandCursor;
    else if (tools_.hovered())
        shape = tools_.tool == Tool::draw ? Qt::CrossCursor : Qt::PointingHandCursor;
    if (cursor().shape() != shape) setCursor(shape);
}

}  // namespace sinew::modeler
