// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "widgets/brush/brush_bar.h"
#include "widgets/shell/window_actions.h"

namespace sline::widgets {

/// Runs the actions of the brush with which one paints on structures, and shows its bar.
class BrushActions : public QObject {
  Q_OBJECT
 public:
  BrushActions(Session& session, BrushTool& tool, QWidget& picture, const WindowActions& actions,
               QObject* parent);
  ~BrushActions() override;

 protected:
  /// Escape puts the brush away, unless it takes a stroke back.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void resize(float factor);
  void showState();

  BrushTool& m_tool;
  const WindowActions& m_actions;
  QPointer<BrushBar> m_bar;
};

}  // namespace sline::widgets
