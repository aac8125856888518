// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "widgets/focus/focus_context.h"
#include "widgets/focus/near_tool.h"

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace sline::widgets {

class AmountSlider;

/// Shows what is in focus, the amount of context, and which role every structure has and why.
class FocusPanel : public QWidget {
  Q_OBJECT
 public:
  FocusPanel(Session& session, FocusContext& focus, NearTool& nearness, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {250, 340}; }

 signals:
  /// Asks for the selection to be put in focus.
  void focusWanted();

 private:
  QWidget* makeAmount();
  QWidget* makeSides();
  QWidget* makeRoles();
  void connectControls();
  void refresh();
  void showTitle();
  void showRoles();
  void showHidden();
  /// Marks what was set by hand since.
  void showHand();
  void showChosenRole();
  NodeIds chosen() const;

  Session& m_session;
  FocusContext& m_focus;
  QLabel* m_title = nullptr;
  QLabel* m_hint = nullptr;
  QPushButton* m_button = nullptr;
  AmountSlider* m_amount = nullptr;
  QButtonGroup* m_sides = nullptr;
  QTreeWidget* m_roles = nullptr;
  QComboBox* m_role = nullptr;
  QCheckBox* m_hidden = nullptr;
  QPushButton* m_giveBack = nullptr;
  NodeIds m_byHand;
  std::vector<QWidget*> m_needFocus;  ///< controls that mean nothing without something in focus
};

}  // namespace sline::widgets
