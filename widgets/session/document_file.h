// SPDX-License-Identifier: Apache-2.0
// Connects a document with its file on disk.
#pragma once

#include <QString>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/disk/file_state.h"
#include "model/scene_file/journal.h"
#include "model/scene_file/scene_file.h"

namespace sline::widgets {

/// Returns what the file holds, which tells whether it is still the one that was read or written:
/// times do not, as copies and archives bring their own. None where there is no file; of one that
/// cannot be read, a fingerprint that no file has.
std::optional<model::Fingerprint> stampOf(const std::filesystem::path& file);

enum class Writable {
  yes,
  lockedElsewhere,  ///< another window or program has it open for writing
  newerProgram,     ///< it contains more than this program would write
  notPermitted,     ///< its permissions or those of its folder
  changedOnDisk,    ///< by another program, while it was not locked here
};

/// The scene file of a document. It belongs to an opening, not to a `Document`: undo restores a
/// scene, but not the name under which it was saved meanwhile.
struct DocumentFile {
  std::filesystem::path path;  ///< absolute; empty: never saved
  Writable writable = Writable::yes;
  QString reason;  ///< why it is not writable, as a sentence without its full stop
  /// Members of the file that have no meaning here, kept for saving; null for none.
  std::shared_ptr<const std::vector<model::ZipMember>> others;
  std::shared_ptr<const std::string> thumbnail;  ///< PNG; null for none
  /// The scene as it came in or was saved last; absent if no file has it (it was recovered).
  std::optional<model::Scene> saved;
  std::optional<model::Fingerprint> stamp;  ///< of the file as it was read or written last
  std::optional<model::FileState> state;    ///< of the file before its stamp was taken
  /// Of the file, if all that it holds is in the document, as in model::SceneDocument.
  std::optional<model::Fingerprint> whole;
  std::optional<model::Recoverable> left;       ///< the journal from which it was recovered
  std::shared_ptr<const model::FileLock> lock;  ///< held while the document is open
};

struct ReadDocument {
  model::Scene scene;
  DocumentFile file;
  /// What a journal has brought back; `scene` is its first state.
  std::optional<model::Recovered> recovered;
};

/// Reads a scene file and locks it, or says why it cannot be saved again. `held` is a lock that the
/// caller has already, perhaps of this file; null for none.
Result<ReadDocument> readDocument(const std::filesystem::path& path,
                                  std::shared_ptr<const model::FileLock> held);

/// Reads a journal of unsaved work; its file is the one that was being edited, which is locked as
/// in `readDocument`. It is not writable where it is not known to be as it was then.
Result<ReadDocument> readRecovered(const model::Recoverable& found,
                                   std::shared_ptr<const model::FileLock> held);

/// Takes the file's stamp, and the state by which one sees without reading it that it holds.
void takeStamp(DocumentFile& file);

/// Locks the file again after its lock was released, unless it has changed since. Reads the file
/// only where the system says that something has changed about it.
void relock(DocumentFile& file);

/// Tells whether the lock is of this file, under whatever name.
bool isLockOf(const model::FileLock& lock, const std::filesystem::path& file);

}  // namespace sline::widgets
