// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "widgets/session/session.h"

class QLineEdit;

namespace sline::widgets {

class StructureTreeView;

/// The tree under its filter box.
class StructureTree : public QWidget {
  Q_OBJECT
 public:
  explicit StructureTree(Session& session, QWidget* parent = nullptr);
  StructureTreeView& view() { return *m_view; }
  /// Puts the cursor into the filter box.
  void find();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void chooseColour(const NodeIds& ids);

  Session& m_session;
  QLineEdit* m_filter;
  StructureTreeView* m_view;
};

}  // namespace sline::widgets
