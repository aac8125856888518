// SPDX-License-Identifier: Apache-2.0
// Applies whole looks at one click: the program's own and those that the user has named.
#pragma once

#include <QWidget>

#include "widgets/gamma/preset_store.h"
#include "widgets/session/session.h"

class QMenu;
class QSettings;

namespace sline::widgets {

class PresetPanel : public QWidget {
  Q_OBJECT
 public:
  PresetPanel(Session& session, QSettings& settings, QWidget* parent = nullptr);

 signals:
  void focusWanted();

 private:
  void fillMenu();
  void put(const model::StylePreset& preset);
  void askForName();

  Session& m_session;
  PresetStore m_store;
  QMenu* m_menu;
};

}  // namespace sline::widgets
