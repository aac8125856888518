// SPDX-License-Identifier: Apache-2.0
// Keeps copies of unsaved work for the case of a crash.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>

#include "model/scene_file/autosave.h"
#include "widgets/session/background_queue.h"
#include "widgets/session/session.h"

namespace sline::widgets {

/// Keeps a copy of the document in the folder a while after it has changed, and at once when much
/// has; drops the copy when the document is as its file is. For a recovered document, the copy that
/// a crash left is removed then too, and as soon as the document has a copy of its own.
class Autosaver : public QObject {
  Q_OBJECT
 public:
  Autosaver(Session& session, std::filesystem::path folder, QObject* parent = nullptr);
  /// Leaves an existing copy in place, unless `discard` was called before.
  ~Autosaver() override;

  const std::filesystem::path& folder() const { return m_folder; }
  /// Sets the time between a change and its copy; 0 means no copies.
  void setInterval(std::chrono::milliseconds interval);
  /// Discards the copy, because the document is given up and nothing is to be recovered.
  void discard();

 signals:
  /// Tells that the copy has all changes up to when it was asked for.
  void kept();
  /// Tells of a failure, once each time that copies begin to fail.
  void failed(const sline::Error& error);

 private:
  struct Copy;
  void documentChange(const Document& before, const Document& now);
  void fileChange();
  void keepIfDue();
  void keep();
  void finish(const Status& status);

  Session& m_session;
  std::filesystem::path m_folder;
  std::shared_ptr<Copy> m_copy;  ///< belongs to the queue's thread
  std::chrono::milliseconds m_interval = std::chrono::minutes(1);
  model::AutosaveClock m_clock{m_interval};
  QTimer m_timer;
  bool m_failing = false;
  BackgroundQueue m_queue;
};

}  // namespace sline::widgets
