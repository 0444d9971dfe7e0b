/// @file viewport.h
/// The window into the scene: passes the mouse and keys on to camera and tools, and draws.
#pragma once

#include <QOpenGLWidget>
#include <functional>
#include <memory>
#include <optional>

#include "actions/action.h"
#include "live/pipeline.h"
#include "sinew/render/camera.h"
#include "viewport/navigation.h"
#include "viewport/reference_pictures.h"

namespace sinew::modeler {

class SceneView;

class Viewport : public QOpenGLWidget {
  public:
    Viewport(Model& model, Interaction& tools, const ViewSettings& view, QWidget* parent = nullptr);
    ~Viewport() override;

    void show_mesh(std::shared_ptr<const LiveMesh> mesh);
    const Camera& camera() const { return camera_; }
    void set_camera(const Camera& camera);
    Screen screen() const;
    Pointer pointer() const;  ///< where it is now, with the modifiers that are held
    const ReferencePictures& references() const { return references_; }

    void start(Modal modal);

    /// @name What the window wants to know.
    /// @{
    std::function<void(const QPoint&)> context_menu_wanted;
    std::function<void()> changed;  ///< hovered, gesture or camera: the status line may say something else
    std::function<void(const QString&)> failed;  ///< OpenGL is not to be had
                                                 /// @}

  protected:
    void initializeGL() override;
    void paintGL() override;
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    bool gesture_key(const QKeyEvent& event);
    void paint_overlay(QPainter& painter);
    void release();  ///< what is on the graphics card
    void update_cursor();
    void refresh();

    Model& model_;
    Interaction& tools_;
    const ViewSettings& view_;
    ReferencePictures references_;
    Camera camera_;
    std::unique_ptr<SceneView> scene_;
    std::shared_ptr<const LiveMesh> mesh_;
    bool mesh_changed_ = false;
    Drag drag_ = Drag::none;
    bool right_moved_ = false;
    Vec2 pressed_at_{0, 0}, last_{0, 0};
    std::optional<StandardView> hovered_ball_, pressed_ball_;
};

}  // namespace sinew::modeler
