// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "widgets/pockets/pocket_search.h"
#include "widgets/session/session.h"

class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QTreeWidget;

namespace sline::widgets {

class Viewport;

/// Lists the pockets of the document's proteins. A click puts one in focus, with what lies in it,
/// and looks into it.
class PocketsPanel : public QWidget {
  Q_OBJECT
 public:
  PocketsPanel(Session& session, Viewport& viewport, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {250, 340}; }
  /// Tells whether the document has proteins whose pockets can be found.
  bool hasMolecules() const { return m_search.hasMolecules(); }

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* makeOptions();
  QDoubleSpinBox* spin(const char* name, const Limits<float>& limits, float value);
  void readOptions();
  void showState();
  void focusOn(const std::shared_ptr<const model::ScenePockets>& found, std::size_t pocket,
               const model::MeshPtr& room);

  Session& m_session;
  Viewport& m_viewport;
  PocketSearch m_search;
  QLabel* m_hint = nullptr;
  QPushButton* m_cancel = nullptr;
  QTreeWidget* m_list = nullptr;
  QDoubleSpinBox* m_probe = nullptr;
  QDoubleSpinBox* m_largeProbe = nullptr;
  QDoubleSpinBox* m_leastVolume = nullptr;
  std::shared_ptr<const model::ScenePockets> m_shown;
};

}  // namespace sline::widgets
