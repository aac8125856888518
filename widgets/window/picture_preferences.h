// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "widgets/preferences/preferences.h"
#include "widgets/shell/window_actions.h"

class QMenu;

namespace sline::widgets {

class Viewport;

/// Keeps the picture as the preferences want it: background, marks over it, mouse buttons, flights
/// between views. The marks' actions and the entries of the backgrounds' menu set the same
/// preferences.
class PicturePreferences : public QObject {
  Q_OBJECT
 public:
  PicturePreferences(Viewport& viewport, Preferences& preferences, const WindowActions& actions,
                     QMenu& backgrounds, QObject* parent);

 private:
  void follow();

  Viewport& m_viewport;
  Preferences& m_preferences;
  const WindowActions& m_actions;
};

}  // namespace sline::widgets
