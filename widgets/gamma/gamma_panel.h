// SPDX-License-Identifier: Apache-2.0
// Edits how the selected structures are drawn.
#pragma once

#include <QWidget>

#include "widgets/gamma/look_drag.h"

class QButtonGroup;
class QImage;
class QLabel;
class QPushButton;
class QSettings;

namespace sline::widgets {

class DrawingPanel;
class GammaSlider;
class MorePanel;
class PresetPanel;
class RangeBox;
class StageStrip;

class GammaPanel : public QWidget {
  Q_OBJECT
 public:
  /// Makes the panel. The settings hold the user's presets and what is folded away; they must
  /// outlive the panel.
  GammaPanel(Session& session, QSettings& settings, QWidget* parent = nullptr);

  /// Returns the strip for which the small pictures of the stages are drawn.
  StageStrip& stages() { return *m_stages; }
  /// Returns the panel of drawing styles, for which small pictures are drawn, too.
  DrawingPanel& drawings() { return *m_drawings; }
  QSize sizeHint() const override { return {270, 660}; }

 signals:
  void focusWanted();
  void brushWanted();

 private:
  QLayout* makeGamma();
  QWidget* makeFill();
  void layOut();
  void connectControls();
  void refresh();
  void showGamma();
  void showFill();
  model::Edited movedBy(float from, float to) const;
  void step(model::Edited edited);

  Session& m_session;
  LookDrag m_drag;
  QLabel* m_title = nullptr;
  QLabel* m_hint = nullptr;
  GammaSlider* m_slider = nullptr;
  StageStrip* m_stages = nullptr;
  RangeBox* m_number = nullptr;
  QPushButton* m_inherit = nullptr;
  QButtonGroup* m_fill = nullptr;
  QWidget* m_fillRow = nullptr;
  DrawingPanel* m_drawings = nullptr;
  PresetPanel* m_presets = nullptr;
  MorePanel* m_more = nullptr;
};

}  // namespace sline::widgets
