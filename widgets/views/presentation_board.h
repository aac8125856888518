// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPolygonF>
#include <QWidget>
#include <optional>
#include <vector>

namespace sline::widgets {

/// Lies over a presented picture: blank, with a red dot where the mouse points, or with what a pen
/// draws. The mouse goes through it but for the pen's and while it is blank.
class PresentationBoard : public QWidget {
  Q_OBJECT
 public:
  explicit PresentationBoard(QWidget& picture);

  enum class Blank { none, black, white };
  void setBlank(Blank blank);
  Blank blank() const { return m_blank; }

  enum class Pointing { mouse, laser, pen };
  void setPointing(Pointing pointing);
  Pointing pointing() const { return m_pointing; }
  /// Notes where the mouse is in the picture; empty where it is elsewhere.
  void point(const std::optional<QPointF>& at);
  /// Returns where the laser's dot is; empty where none is shown.
  std::optional<QPointF> dot() const;

  /// Takes away what the pen has drawn.
  void wipe();
  const std::vector<QPolygonF>& drawn() const { return m_drawn; }
  /// Takes away all that is on the board.
  void clear();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void showState();

  Blank m_blank = Blank::none;
  Pointing m_pointing = Pointing::mouse;
  std::optional<QPointF> m_mouse;
  std::vector<QPolygonF> m_drawn;
  bool m_drawing = false;
};

}  // namespace sline::widgets
