// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <optional>

#include "render/lettering/scale_length.h"

namespace sline::widgets {

/// What a scale bar says beside its length.
struct ScaleWords {
  model::DrawnUnit unit = model::DrawnUnit::millimetre;
  bool atMidDepth = false;  ///< the length is true only there
  bool atCutFace = false;   ///< likewise
};

/// Shows the bar with its length, in the picture's lower left corner.
class ScaleBarMark : public QWidget {
  Q_OBJECT
 public:
  explicit ScaleBarMark(QWidget* parent);
  /// Shows a bar of that many of the unit; none where there is no scale.
  void show(const std::optional<render::ScaleLength>& bar, const ScaleWords& words);
  void setInk(const QColor& ink);
  QSize sizeHint() const override;
  const std::optional<render::ScaleLength>& bar() const { return m_bar; }
  static constexpr int most = 140;  ///< the maximum length of the bar in pixels

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::optional<render::ScaleLength> m_bar;
  QString m_text;
  QColor m_ink;
};

}  // namespace sline::widgets
