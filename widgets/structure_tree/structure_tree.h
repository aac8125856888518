// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <functional>

#include "widgets/session/session.h"

class QLabel;
class QLineEdit;

namespace sline::widgets {

class StructureTreeView;

/// Shows the tree under its filter box.
class StructureTree : public QWidget {
  Q_OBJECT
 public:
  explicit StructureTree(Session& session, QWidget* parent = nullptr);
  StructureTreeView& view() { return *m_view; }
  /// Puts the cursor into the filter box.
  void find();
  /// Opens a dialog for the colour of the nodes.
  void chooseColour(const NodeIds& ids);
  void showProperties(const NodeIds& ids);
  /// Has properties say why a structure is drawn as it is, where `explain` knows that.
  void setExplanation(std::function<QString(model::NodeId)> explain) {
    m_explain = std::move(explain);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool filterKey(int key);
  void showCount();

  Session& m_session;
  std::function<QString(model::NodeId)> m_explain;
  QLineEdit* m_filter;
  QLabel* m_count;
  StructureTreeView* m_view;
};

}  // namespace sline::widgets
