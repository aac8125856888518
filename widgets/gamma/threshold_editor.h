// SPDX-License-Identifier: Apache-2.0
// Sets the thresholds with which the selection's technique finds its lines.
#pragma once

#include <QDoubleSpinBox>
#include <vector>

#include "widgets/gamma/style_editors.h"

namespace sline::widgets {

class ThresholdEditor : public StyleEditor {
  Q_OBJECT
 public:
  explicit ThresholdEditor(Session& session, QWidget* parent = nullptr);
  void showSelection() override;

 private:
  QWidget* makePage(model::Technique technique);
  void choose(const std::string& name, double value);

  model::ThresholdValues m_values;  ///< those of the first selected structure
  /// Holds a page with a box for each threshold, of each technique in its order.
  struct Page {
    QWidget* widget = nullptr;
    std::vector<QDoubleSpinBox*> boxes;
  };
  std::vector<Page> m_pages;
};

}  // namespace sline::widgets
