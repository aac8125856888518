// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <optional>

#include "widgets/brush/brush_stroke.h"

namespace sline::widgets {

/// Shows the brush's rim around the mouse, and within it the part where it works alike; mouse
/// events pass through.
class BrushMark : public QWidget {
  Q_OBJECT
 public:
  explicit BrushMark(QWidget* parent);
  struct State {
    std::optional<glm::vec2> at;  ///< pixels; absent: there is no brush
    Brush brush;
    bool onTarget = false;  ///< there is something to paint on
    bool operator==(const State&) const = default;
  };
  void show(const State& state);
  const State& state() const { return m_state; }
  void setDark(bool dark);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  State m_state;
  bool m_dark = false;
};

}  // namespace sline::widgets
