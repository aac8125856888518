// SPDX-License-Identifier: Apache-2.0
// Keeps each edit of unsaved work on the disk as it is made, and finds it again after a crash. Each
// open document has two files in a folder of the user's: NAME.journal, to which each state of the
// history is appended by what differs from the one before it (journal_content.h), and NAME.meshes
// with the meshes and voxels, each once (bulk_store.h). They are locked while their program runs:
// an unlocked journal was left by a program that did not end as it should.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/disk/appended_file.h"
#include "model/disk/file_lock.h"
#include "model/scene_file/bulk_store.h"
#include "model/scene_file/journal_content.h"
#include "model/scene_file/scene_file.h"

namespace sline::model {

/// Returns the folder of the journals: $XDG_STATE_HOME/sline/journals, else
/// ~/.local/state/sline/journals; empty where neither is known. The folder need not exist.
std::filesystem::path userJournalFolder();

/// A state of the history as it is handed to the journal: the scene after `place` of `count` steps,
/// of which the one before it has the name.
struct JournalStep {
  std::uint32_t place = 0;
  std::uint32_t count = 0;
  std::string name;
  std::shared_ptr<const Scene> scene;
};

/// Writes the journal of one open document. All calls come from one thread at a time.
class Journal {
 public:
  /// Makes the folder where it is missing and reserves names in it, without writing a file yet.
  static Result<std::unique_ptr<Journal>> reserve(const std::filesystem::path& folder);
  /// Leaves the files where they are, unless there is nothing to recover.
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Begins the journal anew with a state of a document, and what else its scene file holds.
  Status start(const JournalSource& source, const SceneDocument& rest, const JournalStep& state);
  bool started() const { return m_states != nullptr; }
  /// Appends what leads from the state before to this one. After an error the next call appends
  /// what leads there from the last one that was kept.
  Status note(const JournalStep& state);
  Status note(const JournalSource& source);
  Status note(const std::vector<NodeId>& selection);
  /// Tells whether all meshes of the noted states are written.
  bool complete() const { return !m_bulk || m_bulk->complete(); }
  /// Writes missing meshes, stopping at the first after that time.
  Status writeMeshes(std::chrono::milliseconds atMost);
  /// Waits until all is on the disk.
  Status sync();

  /// Removes the journal, once the document was saved and there is nothing to recover. The meshes
  /// stay for what is edited next.
  void discard();
  /// Removes the meshes too, once the document is let go.
  void discardAll();
  const std::filesystem::path& file() const { return m_lock.file(); }

 private:
  explicit Journal(FileLock lock) : m_lock(std::move(lock)) {}
  void shorten();

  FileLock m_lock;
  BulkKeys m_keys;
  std::optional<BulkStore> m_bulk;
  std::unique_ptr<AppendedFile> m_states;
  JournalWriter m_writer;
  std::uint64_t m_text = 0;   ///< bytes of the states since the file was last written anew
  std::uint64_t m_begun = 0;  ///< the file's size then
};

/// A journal whose program is no longer running.
struct Recoverable {
  std::filesystem::path journal;
  JournalSource source;
  std::filesystem::file_time_type when;
};

/// What a journal brings back: the states of the history that could be read, and where it stood.
struct Recovered {
  struct State {
    std::string name;  ///< of the step that led to it
    Scene scene;
  };
  std::vector<State> states;  ///< one or more
  std::size_t current = 0;
  SceneDocument rest;  ///< all but the scene
  std::vector<NodeId> selection;
  /// What of the states is at fault and therefore not in them, a line each with its place.
  std::vector<std::string> leftOut;
};

/// Returns the journals that can be recovered, the newest first.
std::vector<Recoverable> recoverableIn(const std::filesystem::path& folder);
/// Returns what the journal has, to its last whole record. Meshes that it had no time to write are
/// taken from the document's scene file; where some are in neither, the newest state that has all
/// of its own is the current one. If none has, what is there of the newest comes back.
Result<Recovered> recovered(const Recoverable& found);
/// Removes the journal, unless a program has taken it meanwhile, and with it those of programs that
/// were killed before they had taken it over.
void forget(const Recoverable& found);

}  // namespace sline::model
