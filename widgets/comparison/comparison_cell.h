// SPDX-License-Identifier: Apache-2.0
// Shows a model by one technique, with its thresholds below. The picture turns under the mouse and
// the arrow keys; who owns it turns all.
#pragma once

#include <QDoubleSpinBox>
#include <QImage>
#include <QWidget>
#include <optional>
#include <vector>

#include "model/scene/style.h"
#include "widgets/viewport/tools/navigation.h"

namespace sline::widgets {

class ComparisonPicture : public QWidget {
  Q_OBJECT
 public:
  explicit ComparisonPicture(QWidget* parent = nullptr);

  void setCamera(const model::Camera& camera, const glm::vec3& pivot);
  void setImage(const QImage& image);
  const QImage& image() const { return m_image; }
  /// Returns the side of the largest square that has room here, in pixels of the window.
  int room() const;
  /// Sets the side of the square that the picture fills, so that it is as large as others.
  void setSide(int side);
  QSize sizeHint() const override { return {220, 200}; }

 signals:
  void turned(const sline::model::Camera& camera);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QRect square() const;
  /// Returns the place within the square.
  glm::vec2 within(const QPointF& at) const;

  QImage m_image;
  int m_side = 16;
  model::Camera m_camera;
  glm::vec3 m_pivot{0.0f};
  std::optional<CameraDrag> m_drag;
};

class ComparisonCell : public QWidget {
  Q_OBJECT
 public:
  explicit ComparisonCell(model::Technique technique, QWidget* parent = nullptr);

  ComparisonPicture& picture() { return *m_picture; }
  model::Technique technique() const { return m_technique; }
  void showThresholds(const model::ThresholdValues& values);

 signals:
  void thresholdChanged(const QString& name, double value);

 private:
  model::Technique m_technique;
  ComparisonPicture* m_picture;
  std::vector<QDoubleSpinBox*> m_boxes;  ///< by the technique's thresholds
};

}  // namespace sline::widgets
