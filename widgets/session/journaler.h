// SPDX-License-Identifier: Apache-2.0
// Keeps unsaved work for the case of a crash.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <string>

#include "model/scene_file/journal.h"
#include "widgets/session/background_queue.h"
#include "widgets/session/session.h"

namespace sline::widgets {

/// Notes each step of the history in a journal as soon as it is made, while the document differs
/// from its file; removes the journal when it does not any more. For a recovered document, the
/// journal that a crash left is removed then too, and as soon as the document's own has all of it.
/// The window's thread only copies the scene; writing is a thread's of its own.
class Journaler : public QObject {
  Q_OBJECT
 public:
  Journaler(Session& session, std::filesystem::path folder, QObject* parent = nullptr);
  /// Leaves an existing journal in place, unless `discard` was called before.
  ~Journaler() override;

  const std::filesystem::path& folder() const { return m_folder; }
  /// Without it nothing is kept.
  void setEnabled(bool enabled);
  /// Discards the journal, because the document is given up and nothing is to be recovered.
  void discard();

 signals:
  /// Tells that the journal has all that was done so far, meshes too.
  void kept();
  /// Tells of a failure, once each time that keeping begins to fail.
  void failed(const sline::Error& error);

 private:
  struct Shared;
  /// Where in the history the document stands.
  struct Place {
    int opening = 0;
    model::JournalStep step;

    bool isThatOf(const Place& other) const {
      return opening == other.opening && step.place == other.step.place &&
             step.count == other.step.count && *step.scene == *other.step.scene;
    }
  };
  using Task = std::function<Status(Shared&)>;
  Place place() const;
  void follow();
  void documentChange(const Document& before, const Document& now);
  void fileChange();
  void begin(const Place& from);
  void noteSelection();
  void remove(bool meshesToo);
  void add(Task task);
  struct Outcome;
  void finish(const Outcome& outcome);

  Session& m_session;
  std::filesystem::path m_folder;
  std::shared_ptr<Shared> m_shared;  ///< belongs to the queue's thread
  std::optional<Place> m_last;       ///< the place that was seen last
  std::optional<Place> m_discarded;  ///< that at which the journal was discarded, until another
  model::JournalSource m_source;     ///< as it was noted last
  QTimer m_retry;
  int m_opening = 0;  ///< the opening of which meshes are kept
  bool m_enabled = true;
  bool m_running = false;  ///< a journal has been begun and not removed
  bool m_failing = false;
  BackgroundQueue m_queue;
};

}  // namespace sline::widgets
