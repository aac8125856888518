// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointer>
#include <memory>
#include <optional>

#include "widgets/export/export_dialog.h"
#include "widgets/session/session.h"

class QAction;
class QLabel;
class QMainWindow;
class QProgressBar;
class QSettings;
class QToolButton;

namespace sline::widgets {

class ExportJob;
class MessageBar;
class PictureCopier;
class Viewport;
class WindowActions;

/// Runs the actions of exporting: copies a picture to the clipboard, opens the dialog, writes in
/// the background with progress in the status bar, and reports the result. It outlives the window's
/// controls.
class ExportActions : public QObject {
  Q_OBJECT
 public:
  struct Context {
    Session& session;
    QSettings& settings;
    const WindowActions& actions;
    MessageBar& message;
    Viewport& viewport;
  };
  /// Connects the parts, all of which must outlive it.
  ExportActions(const Context& context, QMainWindow& window);
  ~ExportActions() override;

  /// Connects to the window's new actions and bars after they have been replaced.
  void controlsRemade();
  bool busy() const { return m_job != nullptr; }
  /// Tells whether the window may close. While something is being written it returns false, asks
  /// the user, and closes the window later if the answer is to stop writing.
  bool mayClose();

 private:
  void connectActions();
  void showState();
  void showDialog();
  /// Prepares the draft as last chosen, or as the window shows it; for another document it gets a
  /// name of its own.
  void prepareDraft();
  ExportSource source() const;
  /// Returns what the window shows beside the scene.
  render::ExportOrder seen() const;
  void copyPicture();
  void showProof();
  void begin(const QString& kind, const std::vector<render::ExportPiece>& files);
  void showProgress();
  void end();
  void closeNow();
  void tellDone(const std::vector<render::ExportPiece>& files, const render::ExportNotes& notes);

  Session& m_session;
  QSettings& m_settings;
  const WindowActions& m_actions;
  MessageBar& m_message;
  Viewport& m_viewport;
  QMainWindow& m_window;
  ExportDraft m_draft;
  render::ExportOrder m_seen;     ///< what the window showed when the draft was prepared
  std::optional<int> m_prepared;  ///< the opening that the draft belongs to
  QPointer<ExportDialog> m_dialog;
  PictureCopier* m_copier;
  std::unique_ptr<ExportJob> m_job;
  bool m_closing = false;  ///< the window closes once the job has ended
  // These are in the status bar while something is written.
  QPointer<QLabel> m_what;
  QPointer<QProgressBar> m_progress;
  QPointer<QToolButton> m_cancel;
  std::unique_ptr<QObject> m_offers;  ///< handles the message's buttons
};

}  // namespace sline::widgets
