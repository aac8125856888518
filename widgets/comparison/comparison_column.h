// SPDX-License-Identifier: Apache-2.0
// Shows models by one technique, one below the other, with its thresholds below. Pictures turn
// under the mouse and the arrow keys; who owns them turns all.
#pragma once

#include <QDoubleSpinBox>
#include <QImage>
#include <QStringList>
#include <QWidget>
#include <optional>
#include <vector>

#include "model/camera/camera_moves.h"
#include "model/scene/style.h"

namespace sline::widgets {

class ComparisonPicture : public QWidget {
  Q_OBJECT
 public:
  /// The caption is the model's name, where there are several.
  explicit ComparisonPicture(QString caption, QWidget* parent = nullptr);

  void setCamera(const model::Camera& camera, const glm::vec3& pivot, const model::ZoomEnds& ends);
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
  void zoom(float factor);
  QRect square() const;
  /// Returns the place within the square.
  glm::vec2 within(const QPointF& at) const;

  QString m_caption;
  QImage m_image;
  int m_side = 16;
  model::Camera m_camera;
  glm::vec3 m_pivot{0.0f};
  model::ZoomEnds m_ends;
  std::optional<model::CameraDrag> m_drag;
};

class ComparisonColumn : public QWidget {
  Q_OBJECT
 public:
  /// Makes a picture for each model; a single one needs no name.
  ComparisonColumn(model::Technique technique, const QStringList& models,
                   QWidget* parent = nullptr);

  /// Returns the pictures, of each model one.
  const std::vector<ComparisonPicture*>& pictures() const { return m_pictures; }
  model::Technique technique() const { return m_technique; }
  void showThresholds(const model::ThresholdValues& values);
  /// Returns what lies below the pictures, so that all columns leave as much room for it.
  QWidget& below() const { return *m_below; }

 signals:
  void thresholdChanged(const QString& name, double value);

 private:
  void addThresholds();

  model::Technique m_technique;
  std::vector<ComparisonPicture*> m_pictures;
  QWidget* m_below;
  std::vector<QDoubleSpinBox*> m_boxes;  ///< by the technique's thresholds
};

}  // namespace sline::widgets
