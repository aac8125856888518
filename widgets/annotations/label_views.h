// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "widgets/session/session.h"

class QComboBox;
class QToolButton;

namespace sline::widgets {

/// Sets in which of the saved views labels are shown: in all, in one or none from a list, or by a
/// tick for each view in a menu. Several labels are changed in one undo step.
class LabelViews : public QWidget {
  Q_OBJECT
 public:
  explicit LabelViews(Session& session, QWidget* parent = nullptr);
  /// Sets the labels that the control shows and changes.
  void setLabels(std::vector<model::AnnotationId> labels);

 private:
  void choose(int row);
  void fillTicks();
  void tick(const std::vector<std::size_t>& views, bool shown);

  Session& m_session;
  std::vector<model::AnnotationId> m_labels;
  QComboBox* m_list;
  QToolButton* m_ticks;
};

}  // namespace sline::widgets
