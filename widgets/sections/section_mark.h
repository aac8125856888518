// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "widgets/sections/section_handles.h"

namespace sline::widgets {

/// Shows the active section's outline and handles over the picture; mouse events pass through.
class SectionMark : public QWidget {
  Q_OBJECT
 public:
  explicit SectionMark(QWidget* parent);
  struct State {
    std::optional<SectionHandles> handles;
    SectionGrip grip = SectionGrip::none;  ///< held, or under the mouse
    bool dragging = false;
    QString readout;
  };
  void show(State state);
  void setDark(bool dark);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintOutline(QPainter& painter) const;
  void paintArrow(QPainter& painter) const;
  void paintRing(QPainter& painter, const glm::vec2& at, SectionGrip grip) const;
  void paintReadout(QPainter& painter) const;
  QColor ink(bool held) const;
  QColor halo() const;

  State m_state;
  bool m_dark = false;
};

}  // namespace sline::widgets
