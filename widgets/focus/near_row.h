// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "widgets/focus/near_tool.h"

class QLabel;
class QPushButton;
class QSlider;

namespace sline::widgets {

/// Offers to focus by nearness, and shows how far nearness reaches.
class NearRow : public QWidget {
  Q_OBJECT
 public:
  NearRow(Session& session, NearTool& tool, QWidget* parent = nullptr);

 private:
  void refresh();

  Session& m_session;
  NearTool& m_tool;
  QPushButton* m_selection;
  QPushButton* m_place;
  QWidget* m_reach;
  QSlider* m_falloff;
  QLabel* m_millimetres;
};

}  // namespace sline::widgets
