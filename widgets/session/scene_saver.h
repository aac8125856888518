// SPDX-License-Identifier: Apache-2.0
// Saves a snapshot in the background, so that editing goes on meanwhile.
#pragma once

#include <QImage>
#include <QObject>
#include <map>

#include "widgets/session/background_queue.h"
#include "widgets/session/session.h"

namespace sline::widgets {

class SceneSaver : public QObject {
  Q_OBJECT
 public:
  /// Parts that are saved along with the scene. Absent ones stay as they were in the file.
  struct Companions {
    QImage picture;  ///< scaled down
    std::optional<model::ZipMember> member;
  };
  enum class As {
    document,  ///< the document takes this file from then on
    copy       ///< the document keeps its file
  };

  explicit SceneSaver(Session& session, QObject* parent = nullptr);

  /// Writes the document as it is now, without a drag that is under way. A save that is requested
  /// during another one waits.
  void save(const std::filesystem::path& file, As as, const Companions& companions = {});
  bool busy() const { return m_queue.busy(); }

 signals:
  void started(const QString& name);
  void saved(const std::filesystem::path& file, sline::widgets::SceneSaver::As as);
  /// Tells that saving failed: the file is as it was before, and the document is not saved.
  void failed(const sline::Error& error);
  /// Tells that the last of `saved` and `failed` has been emitted.
  void ended();

 private:
  struct SaveTask;
  struct Outcome;
  Outcome carryOut(const SaveTask& task);
  void finish(const SaveTask& task, const Outcome& outcome);

  Session& m_session;
  /// Holds the last stamp of a file that this object has written, and the lock that it took for
  /// that while any owner holds it: a save may be requested before the previous one of the same
  /// file is done.
  struct Written {
    std::optional<model::Fingerprint> stamp;
    std::weak_ptr<const model::FileLock> lock;
  };
  std::map<std::filesystem::path, Written> m_written;  ///< belongs to the queue's thread
  BackgroundQueue m_queue;
};

}  // namespace sline::widgets
