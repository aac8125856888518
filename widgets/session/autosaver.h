// SPDX-License-Identifier: Apache-2.0
// Copies of what is not saved, for a crash.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>

#include "model/scene_file/autosave.h"
#include "widgets/session/background_queue.h"
#include "widgets/session/session.h"

namespace sline::widgets {

/// Keeps a copy of the document in the folder a while after it has changed, and at once when much
/// has; lets go of it when the document is as its file is. Of a document that was recovered the
/// copy that a crash has left is removed then too, and as soon as it has one of its own.
class Autosaver : public QObject {
  Q_OBJECT
 public:
  Autosaver(Session& session, std::filesystem::path folder, QObject* parent = nullptr);
  /// A copy that is there stays, unless `discard` came before.
  ~Autosaver() override;

  const std::filesystem::path& folder() const { return m_folder; }
  /// How long after a change; 0: no copies.
  void setInterval(std::chrono::milliseconds interval);
  /// The document is let go of: nothing is to be recovered.
  void discard();

 signals:
  /// The copy has all that was changed when it was asked for.
  void kept();
  /// Once for each time that it begins to fail.
  void failed(const sline::Error& error);

 private:
  struct Copy;
  void documentChange(const Document& before, const Document& now);
  void fileChange();
  void look();
  void keep();
  void finish(const Status& status);

  Session& m_session;
  std::filesystem::path m_folder;
  std::shared_ptr<Copy> m_copy;  ///< of the queue's thread
  std::chrono::milliseconds m_interval = std::chrono::minutes(1);
  model::AutosaveClock m_clock{m_interval};
  QTimer m_timer;
  bool m_failing = false;
  BackgroundQueue m_queue;
};

}  // namespace sline::widgets
