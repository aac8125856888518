// SPDX-License-Identifier: Apache-2.0
// How the selected structures are drawn.
#pragma once

#include <QWidget>

#include "widgets/gamma/gamma_drag.h"

class QAbstractButton;
class QButtonGroup;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace sline::widgets {

class GammaSlider;

class GammaPanel : public QWidget {
  Q_OBJECT
 public:
  explicit GammaPanel(Session& session, QWidget* parent = nullptr);

 signals:
  void focusWanted();
  void contextWanted();

 private:
  QWidget* makeFill();
  QWidget* makeEmphasis();
  void connectControls();
  void refresh();
  void showGamma();
  void showFill();
  void step(Gamma gamma);

  Session& m_session;
  GammaDrag m_drag;
  QLabel* m_title = nullptr;
  QLabel* m_hint = nullptr;
  GammaSlider* m_slider = nullptr;
  QDoubleSpinBox* m_number = nullptr;
  QPushButton* m_inherit = nullptr;
  QButtonGroup* m_fill = nullptr;
  QWidget* m_fillRow = nullptr;
  QWidget* m_emphasisRow = nullptr;
};

}  // namespace sline::widgets
