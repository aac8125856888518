// SPDX-License-Identifier: Apache-2.0
// Saving in the background: of a snapshot, so that edits go on meanwhile.
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
  /// What goes along in the file. What is absent stays as it was there.
  struct Companions {
    QImage picture;  ///< made small
    std::optional<model::ZipMember> member;
  };
  enum class As {
    document,  ///< the document goes by this file from then on
    copy       ///< it goes by the file that it had
  };

  explicit SceneSaver(Session& session, QObject* parent = nullptr);

  /// Writes the document as it is now, without a drag that is under way. One that comes while
  /// another is written waits.
  void save(const std::filesystem::path& file, As as, const Companions& companions = {});
  bool busy() const { return m_queue.busy(); }

 signals:
  void started(const QString& name);
  void saved(const std::filesystem::path& file, sline::widgets::SceneSaver::As as);
  /// The file is as it was before; the document is not saved.
  void failed(const sline::Error& error);
  /// After the last of `saved` and `failed`.
  void ended();

 private:
  struct Order;
  struct Outcome;
  Outcome carryOut(const Order& order);
  void finish(const Order& order, const Outcome& outcome);

  Session& m_session;
  /// What this object has written, and the locks it took for that while anybody holds them: a save
  /// may have been asked for before the one of the same file before it was done.
  struct Written {
    std::optional<FileStamp> stamp;
    std::weak_ptr<const model::FileLock> lock;
  };
  std::map<std::filesystem::path, Written> m_written;  ///< of the queue's thread
  BackgroundQueue m_queue;
};

}  // namespace sline::widgets
