// SPDX-License-Identifier: Apache-2.0
// The picture of the document. It shows the newest picture that the render thread has finished and
// never waits for one; while the camera moves pictures may be coarser.
#pragma once

#include <QOpenGLWidget>
#include <QThreadPool>
#include <QTimer>
#include <memory>
#include <optional>

#include "widgets/session/session.h"
#include "widgets/viewport/motion_quality.h"
#include "widgets/viewport/navigation.h"
#include "widgets/viewport/pick_index.h"
#include "widgets/viewport/render_thread.h"

class QLabel;

namespace sline::widgets {

class Viewport : public QOpenGLWidget {
  Q_OBJECT
 public:
  explicit Viewport(Session& session, QWidget* parent = nullptr);
  ~Viewport() override;

  /// For tests: who draws, from the next OpenGL context on.
  void setPainter(PainterFactory factory) { m_factory = std::move(factory); }

  const model::Camera& camera() const { return m_camera; }
  void setCamera(const model::Camera& camera);
  void showFrom(model::AnatomicalView view);
  /// Fits all that is visible without turning the camera; it becomes what the camera turns around.
  void fitAll();
  render::Background background() const { return m_background; }
  void setBackground(render::Background background);
  /// Whether what is shaded has the key light besides the headlight: as the scene says, else as it
  /// was set here.
  bool keyLight() const;
  void setKeyLight(bool on);

  /// True where the picture on screen is of the document and the camera as they are, in full size.
  bool upToDate() const;
  /// OpenGL's, as it calls itself; empty until the window was first shown.
  const QString& driver() const { return m_driver; }
  /// The time the last picture took to draw.
  double lastMilliseconds() const { return m_lastMilliseconds; }
  /// How many of its layers had to be drawn; the others were kept.
  int lastLayersDrawn() const { return m_lastLayersDrawn; }
  /// Small pictures by the same renderer, whenever the picture itself is done; `previewed` follows
  /// for each. They replace those asked for before.
  void askPreviews(PreviewRequest request);

 signals:
  void cameraChanged();
  void backgroundChanged();
  /// The picture on screen is another one.
  void pictureShown();
  /// The camera turns around this point of a structure from now on.
  void pivotChosen(const QString& structure);
  void previewed(int id, const QImage& image);
  void failed(const sline::Error& error);

 protected:
  void initializeGL() override;
  void paintGL() override;
  void resizeGL(int width, int height) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  enum class PickFor { selection, addition, pivot };
  void refresh();
  void move(const model::Camera& camera);
  void rest();
  void took(const PictureReport& report);
  void closeGraphics();
  void documentChange(const Document& before, const Document& now);
  void pick(const QPointF& at, PickFor purpose);
  void picked(const std::optional<Pick>& pick, PickFor purpose);
  void styleLetters();
  void placeLetters();
  model::Camera cameraFrom(model::AnatomicalView view) const;
  /// As a scene is first seen: its view of that name, else the body from the front.
  model::Camera overview() const;
  /// The camera turns around the middle of what is shown.
  void pivotToMiddle();
  render::gpu::TextureSize pixels() const;
  glm::vec2 size2() const { return {float(width()), float(height())}; }
  std::vector<glm::vec3> visibleCorners() const;

  Session& m_session;
  QString m_driver;
  PainterFactory m_factory = makePicturePainter;
  std::unique_ptr<render::gpu::Handoff> m_handoff;
  std::unique_ptr<RenderThread> m_thread;

  model::Camera m_camera;
  glm::vec3 m_pivot{0.0f};
  render::Background m_background = render::Background::paper;
  bool m_keyLight = false;
  std::optional<CameraDrag> m_drag;
  QPointF m_pressed;
  bool m_dragged = false;  ///< the mouse went far enough that the release is no click

  MotionQuality m_quality;
  QTimer m_rest;
  bool m_moving = false;
  std::uint64_t m_asked = 0;  ///< the newest request
  float m_askedScale = 1.0f;
  std::uint64_t m_shown = 0;  ///< on screen
  double m_lastMilliseconds = 0.0;
  int m_lastLayersDrawn = 0;

  std::shared_ptr<PickIndex> m_picks = std::make_shared<PickIndex>();
  QThreadPool m_pickers;
  std::array<QLabel*, 4> m_letters{};
};

}  // namespace sline::widgets
