// SPDX-License-Identifier: Apache-2.0
// Lets Γ of the selection vary over its surfaces: by what, from where, and along which curve.
#pragma once

#include <QComboBox>

#include "widgets/gamma/style_editors.h"

class QPushButton;

namespace sline::widgets {

class GammaCurve;

/// A list of structures and groups that is made when it is opened.
class TargetBox : public QComboBox {
  Q_OBJECT
 public:
  using QComboBox::QComboBox;
  void showPopup() override;

 signals:
  void aboutToOpen();
};

class GammaMapEditor : public StyleEditor {
  Q_OBJECT
 public:
  explicit GammaMapEditor(Session& session, QWidget* parent = nullptr);
  void showSelection() override;

 signals:
  /// Asks for the brush, to paint by what Γ varies.
  void brushWanted();

 private:
  void layOut();
  void connectValues();
  void chooseScalar(model::GammaScalar scalar);
  void listTargets();
  void showTargets();
  /// Returns a look with the map that is shown and the curve as drawn.
  model::Style drawn() const;

  model::GammaMap m_map;  ///< that of the first selected structure
  QComboBox* m_scalar;
  QWidget* m_from;  ///< the row of the target
  TargetBox* m_target;
  QPushButton* m_paint;
  GammaCurve* m_curve;
};

}  // namespace sline::widgets
