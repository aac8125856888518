// SPDX-License-Identifier: Apache-2.0
// What a document has to do with the disk.
#pragma once

#include <QString>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/scene_file/autosave.h"
#include "model/scene_file/scene_file.h"

namespace sline::widgets {

/// Tells whether a file is still the one that was read or written.
struct FileStamp {
  std::uintmax_t bytes = 0;
  std::filesystem::file_time_type when;
  bool operator==(const FileStamp&) const = default;
};
/// Nothing where there is no file.
std::optional<FileStamp> stampOf(const std::filesystem::path& file);

enum class Writable {
  yes,
  lockedElsewhere,  ///< another window or program has it open for writing
  newerProgram,     ///< it says more than this program would write
  notPermitted,     ///< its rights or those of its folder
  changedOnDisk,    ///< by somebody else, while it was not locked here
};

/// The scene file of a document. It belongs to an opening, not to a `Document`: undo takes a scene
/// back, but not the name that it was saved under meanwhile.
struct DocumentFile {
  std::filesystem::path path;  ///< empty: never saved
  Writable writable = Writable::yes;
  QString reason;  ///< why it is not writable, as a sentence without its full stop
  /// What the file's reader found there without a meaning here, for saving; null: none.
  std::shared_ptr<const std::vector<model::ZipMember>> others;
  std::shared_ptr<const std::string> thumbnail;  ///< PNG; null: none
  /// The scene as it came in or was saved last; absent: no file has it (it was recovered).
  std::optional<model::Scene> saved;
  std::optional<FileStamp> stamp;               ///< of the file as it was read or written last
  std::optional<model::Recoverable> copy;       ///< of unsaved work, which the document was made of
  std::shared_ptr<const model::FileLock> lock;  ///< held while the document is open
};

struct ReadDocument {
  model::Scene scene;
  DocumentFile file;
};

/// Reads a scene file and locks it, or says why it cannot be saved again. `held` is a lock that the
/// caller has already, perhaps of this file; null: none.
Result<ReadDocument> readDocument(const std::filesystem::path& path,
                                  std::shared_ptr<const model::FileLock> held);

/// The same for a copy of unsaved work. Its file is the one that it is a copy of.
Result<ReadDocument> readRecovered(const model::Recoverable& found,
                                   std::shared_ptr<const model::FileLock> held);

/// Locks the file again, which was let go, unless it has changed since.
void relock(DocumentFile& file);

/// Who a lock is of: the same file under whatever name.
bool isLockOf(const model::FileLock& lock, const std::filesystem::path& file);

}  // namespace sline::widgets
