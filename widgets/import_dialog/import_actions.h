// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointer>
#include <cstddef>
#include <functional>
#include <utility>

#include "widgets/import_dialog/import_dialog.h"
#include "widgets/session/session.h"

class QSettings;

namespace sline::widgets {

class MessageBar;
class Preferences;
class WindowActions;

/// Runs the actions of import: shows the dialog before an import on request, and offers it after an
/// import that left something out or had to guess.
class ImportActions : public QObject {
  Q_OBJECT
 public:
  struct Context {
    Session& session;
    QSettings& settings;
    Preferences& preferences;
    const WindowActions& actions;
    MessageBar& message;
  };
  /// Calls the function that it is given at once, later, or never.
  using Guard = std::function<void(const std::function<void()>&)>;

  /// Connects the parts, all of which must outlive it. It must be made after the message bar
  /// listens to the session, so that its offer is added to what the bar says.
  ImportActions(const Context& context, QWidget& window);

  /// Sets the guard that asks about unsaved changes before another document takes their place.
  void setGuard(Guard guard) { m_guard = std::move(guard); }
  /// Shows the dialog where Shift is held or the preferences always want it; a lone scene file
  /// never brings it up. Returns false if the paths are to be opened at once.
  bool asksFor(const QStringList& paths, Qt::KeyboardModifiers keys);
  /// Shows the dialog, which begins with the plan; inputs are enough.
  void show(model::ImportPlan plan);

 private:
  void connectActions();
  void importAgain();
  void choose(bool folder);
  void carryOut(const model::ImportPlan& plan, bool intoScene);
  void updateActions();
  /// Offers what can be done about the opening's remarks.
  void offer();
  void takeUnit();

  Session& m_session;
  QSettings& m_settings;
  Preferences& m_preferences;
  const WindowActions& m_actions;
  MessageBar& m_message;
  QWidget& m_window;
  Guard m_guard = [](const std::function<void()>& then) { then(); };
  QPointer<ImportDialog> m_dialog;
  QAction* m_takeUnit;
  QAction* m_keepSize;
  int m_doubted = 0;                      ///< the opening whose unit is asked about; 0: none
  std::pair<int, std::size_t> m_offered;  ///< the opening that was offered another import, and the
                                          ///< number of its sources then
};

}  // namespace sline::widgets
