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

/// What the actions of exporting do: a picture on the clipboard; the dialog, the writing in the
/// background with its progress in the status bar, and what is said when it is over. Outlives the
/// window's controls.
class ExportActions : public QObject {
  Q_OBJECT
 public:
  struct Parts {
    Session& session;
    QSettings& settings;
    const WindowActions& actions;
    MessageBar& message;
    Viewport& viewport;
  };
  /// All parts must outlive it.
  ExportActions(const Parts& parts, QMainWindow& window);
  ~ExportActions() override;

  /// The window's actions and bars are others now.
  void controlsRemade();
  bool busy() const { return m_job != nullptr; }
  /// False where something is being written: a person is asked, and the window closed afterwards
  /// if the answer is to stop it.
  bool mayClose();

 private:
  void connectActions();
  void showState();
  void showDialog();
  /// As chosen last; for another document with a name of its own.
  void prepareDraft();
  ExportSource source() const;
  void copyPicture();
  void showProof();
  void begin(const QString& kind, const std::vector<ExportFile>& files);
  void showProgress();
  void end();
  void closeNow();
  void tellDone(const std::vector<ExportFile>& files, const render::ExportNotes& notes);

  Session& m_session;
  QSettings& m_settings;
  const WindowActions& m_actions;
  MessageBar& m_message;
  Viewport& m_viewport;
  QMainWindow& m_window;
  ExportDraft m_draft;
  std::optional<int> m_prepared;  ///< the opening whose draft it is
  QPointer<ExportDialog> m_dialog;
  PictureCopier* m_copier;
  std::unique_ptr<ExportJob> m_job;
  bool m_closing = false;  ///< when the job has ended
  // In the status bar, while something is written.
  QPointer<QLabel> m_what;
  QPointer<QProgressBar> m_progress;
  QPointer<QToolButton> m_cancel;
  std::unique_ptr<QObject> m_offers;  ///< what the message's buttons do
};

}  // namespace sline::widgets
