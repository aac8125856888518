// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "widgets/session/session.h"
#include "widgets/shell/window_actions.h"

class QMenu;
class QSettings;

namespace sline::widgets {

class Viewport;

/// Runs the actions of saved views and the key light, which both belong to the scene. The last key
/// light is remembered for scenes that do not set it.
class ViewActions : public QObject {
  Q_OBJECT
 public:
  ViewActions(Session& session, Viewport& viewport, QSettings& settings,
              const WindowActions& actions, QMenu& savedViews);

 signals:
  void viewChosen(int index);

 private:
  void lightKey(bool on);
  void listViews();
  void documentChange(const Document& before, const Document& now);

  Session& m_session;
  Viewport& m_viewport;
  QSettings& m_settings;
  QAction& m_keyLight;
  QMenu& m_savedViews;  ///< one entry for each of the scene's views
};

}  // namespace sline::widgets
