// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

#include "widgets/brush/brush_tool.h"

class QLabel;
class QSlider;
class QToolButton;

namespace sline::widgets {

/// Shows what the brush is like, over the picture's lower edge, while the brush is active.
class BrushBar : public QFrame {
  Q_OBJECT
 public:
  BrushBar(Session& session, BrushTool& tool, QWidget& picture);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QSlider* addSlider(const char* name, const QString& text, const QString& tip);
  QToolButton* addButton(const char* name, const QString& text, const QString& tip);
  void connectControls();
  void refresh();
  void place();
  /// Takes everything painted off the targets, as one step.
  void clear();

  Session& m_session;
  BrushTool& m_tool;
  QWidget& m_picture;
  QLabel* m_target;
  QSlider* m_size;
  QSlider* m_softness;
  QSlider* m_strength;
  QLabel* m_millimetres;
  QToolButton* m_erase;
  QToolButton* m_clear;
  QToolButton* m_done;
};

}  // namespace sline::widgets
