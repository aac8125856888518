// SPDX-License-Identifier: Apache-2.0
// Reads and writes the scene file: one ZIP with scene.json, the meshes and a small picture.
// resources/help/scene_file.md describes it for authors of other readers.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"
#include "model/disk/file_lock.h"
#include "model/disk/zip_archive.h"
#include "model/scene/scene.h"

namespace sline::model {

inline constexpr std::string_view sceneExtension = ".sline";
/// Tells whether the file's extension is that of a scene file; case is ignored.
bool isSceneFile(const std::filesystem::path& file);

struct SceneDocument {
  Scene scene;
  std::string thumbnail;          ///< PNG; may be empty
  std::vector<ZipMember> others;  ///< members without a meaning here, by name; kept for saving
  int schema = 0;                 ///< of the file it came from; 0 if it came from none
  /// What of the file is at fault and therefore not in the scene, a line each with its place.
  std::vector<std::string> leftOut;
  /// What the file held, if all that it held was read or this program wrote it: as long as it holds
  /// the same it may be written over. Absent if that is not known.
  std::optional<Fingerprint> whole;

  /// Tells whether the file was written by a newer program.
  bool isNewer() const;
  /// Tells whether the file has more than what was read of it: it can be looked at and saved under
  /// another name.
  bool isForReading() const { return isNewer() || !leftOut.empty(); }
  /// Returns the warning to the user about a file for reading; empty for others.
  std::string warning() const;
};

/// Returns the bytes of the scene file: the same document always gives the same bytes, and they
/// read back to the same document. A document that could not be read back is refused, with the
/// place that is at fault.
Result<std::string> sceneFileBytes(const SceneDocument& document);

/// Returns the document. The bytes are not trusted: what of the scene is at fault is left out, and
/// so is what is damaged beside it. An error's `where` is the member and the place in it:
/// "scene.json: byte 84".
Result<SceneDocument> documentFromBytes(std::string_view bytes);

Result<SceneDocument> readSceneFile(const std::filesystem::path& file);

/// Writes the lock's file whole or not at all, through to the disk. A file of which this program
/// reads a part alone, because a newer one has written it or something in it is at fault, is not
/// overwritten.
Status writeSceneFile(const FileLock& lock, const SceneDocument& document);
/// Does the same as `writeSceneFile` above, holding a lock during the call.
Status writeSceneFile(const std::filesystem::path& file, const SceneDocument& document);

}  // namespace sline::model
