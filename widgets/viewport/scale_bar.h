// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLocale>
#include <QWidget>
#include <optional>

#include "model/scene/camera.h"

namespace sline::widgets {

/// The largest of … 1, 2, 5, 10, 20 … that is no larger than `most`, which is positive.
double roundStep(double most);

/// A length that is drawn to scale.
struct ScaleBar {
  double millimetres = 0.0;
  double pixels = 0.0;
};
/// The longest of round length within that many pixels, true at the depth of `at`. Absent where
/// there is no scale: for a point behind the eye.
std::optional<ScaleBar> scaleBar(const model::Camera& camera, const glm::vec3& at,
                                 double heightPixels, double mostPixels);
/// "5 mm", from 10 mm on "1 cm", from 1000 mm on "1 m", the number as the locale writes it.
QString lengthText(double millimetres, const QLocale& locale);

/// The bar with its length, in the picture's lower left corner.
class ScaleBarMark : public QWidget {
  Q_OBJECT
 public:
  explicit ScaleBarMark(QWidget* parent);
  void show(const std::optional<ScaleBar>& bar);
  void setInk(const QColor& ink);
  QSize sizeHint() const override;
  const std::optional<ScaleBar>& bar() const { return m_bar; }
  static constexpr int most = 140;  ///< pixels that the bar takes

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::optional<ScaleBar> m_bar;
  QColor m_ink;
};

}  // namespace sline::widgets
