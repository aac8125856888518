// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "render/drawn/picture_settings.h"
#include "widgets/viewport/cube_mark.h"
#include "widgets/viewport/scale_bar.h"

class QLabel;

namespace sline::widgets {

/// Holds which marks the user wants to see.
struct MarkChoice {
  bool cube = true;
  bool scaleBar = true;
  bool frameTime = false;
  bool operator==(const MarkChoice&) const = default;
};

/// What marks need to know of a scene.
struct MarkedScene {
  bool any = false;  ///< it holds something
  model::KnownSides sides{.any = false, .evidence = {}};
  model::DrawnUnit unit = model::DrawnUnit::millimetre;
  render::ScalePlaces scale;  ///< where the scale bar is true
  bool operator==(const MarkedScene&) const = default;
};
MarkedScene markedScene(const model::Scene& scene);

/// Shows the marks over the picture: letters at its edges, orientation cube, scale bar, the time a
/// picture takes and the name under the mouse.
class PictureMarks : public QObject {
  Q_OBJECT
 public:
  explicit PictureMarks(QWidget& picture);

  CubeMark& cube() { return *m_cube; }
  void choose(const MarkChoice& choice);
  const MarkChoice& choice() const { return m_choice; }
  void setBackground(render::Background background);
  /// Places the marks for the camera; without a scene there is nothing to mark. Where nobody knows
  /// the scene's sides there are no letters; those in doubt have a question mark.
  void place(const model::Camera& camera, const MarkedScene& scene);
  /// Makes the letters grow with the picture's height, and keeps labels off the covered rectangle.
  void setPresented(bool presented, const QRect& covered);
  /// Returns the places, in pixels and with some space around them, where marks stand or may stand,
  /// whatever they say now.
  std::vector<QRectF> places() const;
  void showTime(double milliseconds, float scale);
  /// Shows the name near the mouse; plain text.
  void showName(const QString& name, const QPoint& mouse);
  void hideName();

 private:
  void dress();
  void placeLetters(const model::Camera& camera, const model::KnownSides& sides);
  QRect cornerBox(const QSize& size, Qt::Corner corner) const;
  static QString timeText(double milliseconds, float scale);
  /// Moves a box, centred in the picture, to its left, right, upper or lower edge.
  void placeAtEdge(QRect& box, std::size_t edge) const;
  void placeCorner(QWidget& mark, Qt::Corner corner);

  QWidget& m_picture;
  MarkChoice m_choice;
  bool m_scene = false;
  bool m_dark = false;
  bool m_presented = false;
  QRect m_covered;
  int m_letterPixels = 0;  ///< 0: as the window's
  std::array<QLabel*, 4> m_letters{};
  CubeMark* m_cube;
  ScaleBarMark* m_scaleBar;
  QLabel* m_time;
  QLabel* m_name;
};

}  // namespace sline::widgets
