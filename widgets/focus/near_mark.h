// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <glm/vec2.hpp>
#include <optional>

namespace sline::widgets {

/// Shows the place to which everything is near, as a ring to take hold of, and how far nearness
/// reaches around it; mouse events pass through.
class NearMark : public QWidget {
  Q_OBJECT
 public:
  explicit NearMark(QWidget* parent);
  struct State {
    std::optional<glm::vec2> place;  ///< pixels; absent: there is none
    float reach = 0.0f;              ///< pixels
    bool held = false;               ///< or under the mouse
    bool operator==(const State&) const = default;
  };
  void show(const State& state);
  const State& state() const { return m_state; }
  void setDark(bool dark);
  static constexpr float grip = 12.0f;  ///< pixels around the place

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  State m_state;
  bool m_dark = false;
};

}  // namespace sline::widgets
