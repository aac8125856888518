// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "model/scene/known_frame.h"
#include "widgets/viewport/orientation_cube.h"

namespace sline::widgets {

/// Shows the orientation cube in the picture's corner: a click looks from there, a drag turns the
/// scene. Mouse events beside the cube are left to the picture.
class CubeMark : public QWidget {
  Q_OBJECT
 public:
  explicit CubeMark(QWidget* parent);
  /// Without sides of a body, faces have the names of the file's axes; sides in doubt have a
  /// question mark.
  void setCamera(const model::Camera& camera, const model::KnownSides& sides);
  /// Returns what stands on the face.
  QString letterOf(const CubeFace& face) const;
  void setDark(bool dark);
  QSize sizeHint() const override;
  /// Returns the pixel in the middle of a part that is seen; for tests.
  std::optional<QPointF> placeOf(const CubeDirection& part) const;
  /// Cancels a drag that is under way; returns false where there is none.
  bool cancel();

 signals:
  void viewRequested(const sline::widgets::CubeDirection& from);
  /// Tells the pixels since the drag's beginning; the first is (0, 0).
  void turned(const glm::vec2& way);
  /// Tells that the drag ends; `kept` is false if its effect is to be undone.
  void turnEnded(bool kept);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  float half() const;
  void name();
  std::optional<CubeDirection> directionAt(const QPointF& at) const;
  void mark(std::optional<CubeDirection> part);
  void paintFace(QPainter& painter, const CubeFace& face) const;

  model::Camera m_camera;
  model::KnownSides m_sides;
  std::vector<CubeFace> m_faces;
  bool m_dark = false;
  std::optional<CubeDirection> m_marked;
  std::optional<CubeDirection> m_pressed;
  QPointF m_from;
  bool m_turning = false;
};

}  // namespace sline::widgets
