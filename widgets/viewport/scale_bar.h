// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <optional>

#include "render/lettering/scale_length.h"

namespace sline::widgets {

/// Shows the bar with its length, in the picture's lower left corner.
class ScaleBarMark : public QWidget {
  Q_OBJECT
 public:
  explicit ScaleBarMark(QWidget* parent);
  void show(const std::optional<render::ScaleLength>& bar);
  void setInk(const QColor& ink);
  QSize sizeHint() const override;
  const std::optional<render::ScaleLength>& bar() const { return m_bar; }
  static constexpr int most = 140;  ///< the maximum length of the bar in pixels

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::optional<render::ScaleLength> m_bar;
  QColor m_ink;
};

}  // namespace sline::widgets
