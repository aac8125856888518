// SPDX-License-Identifier: Apache-2.0
// What a journal's states file says: which document it is of, its history of undo and where in it
// the document stands, and what is selected. A state is a text: the names of its meshes and voxels
// with their keys (bulk_store.h), a line each, and scene.json.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/disk/zip_archive.h"
#include "model/scene/scene.h"
#include "model/scene_file/bulk_store.h"
#include "model/scene_json/json_value.h"

namespace sline::model {

/// Says which document a journal belongs to.
struct JournalSource {
  std::string title;
  /// Its file, by an absolute path, as the journal is read from elsewhere; empty if it was never
  /// saved. Older programs kept names without their folders.
  std::filesystem::path file;
  /// What the file held when the document was read from it or saved to it last; absent where there
  /// was no such file, and in journals of older programs.
  std::optional<Fingerprint> saved;
  bool operator==(const JournalSource&) const = default;
};

/// A state of the document's history.
struct JournalState {
  std::string name;  ///< of the step that led to it
  std::shared_ptr<const std::string> text;
};

struct JournalContent {
  JournalSource source;
  std::vector<ZipMember> members;  ///< of the scene file, without a meaning here
  /// The states that are next to each other in the history; the first one's place in it.
  std::deque<JournalState> states;
  std::uint32_t first = 0;
  std::uint32_t current = 0;  ///< the place at which the document stands
  std::vector<NodeId> selection;

  /// Returns the state at which the document stands; there must be one.
  const JournalState& now() const { return states[current - first]; }
};

/// Writes records one by one; each state is said by what differs from the one written before it.
class JournalWriter {
 public:
  std::string source(const JournalSource& source) const;
  std::string member(const ZipMember& member) const;
  std::string selection(const std::vector<NodeId>& ids) const;
  /// Returns the record of the state at a place of a history with `count` steps; those after them
  /// are gone. The writer goes on from it once `wrote` was called, after its record was kept.
  std::string state(std::uint32_t place, std::uint32_t count, const JournalState& state) const;
  void wrote(const JournalState& state) { m_last = state.text; }

 private:
  std::shared_ptr<const std::string> m_last = std::make_shared<const std::string>();
};

/// Returns what is whole of the file, as far as it goes: nothing in it is trusted.
JournalContent journalContent(std::string_view bytes);
/// Returns the bytes of a file that says the same, and tells the writer that it wrote them.
std::string journalBytes(const JournalContent& content, JournalWriter& writer);

/// Leaves out the states that are farthest back, then farthest ahead, until those that stay have at
/// most so many bytes, or only the current one is left. Returns how many they have.
std::size_t dropFarStates(JournalContent& content, std::size_t bytes);

/// Returns the text of a scene's state.
std::string stateText(const Scene& scene, BulkKeys& keys);
/// Returns the scene of a state. What of it is at fault or not in the bulk is left out and told, as
/// `sceneFromJson` does; an error where it is no scene at all.
Result<Scene> sceneOfState(std::string_view text, const Bulk& bulk,
                           std::vector<JsonRefusal>& leftOut);
/// Returns the keys that a state's text names.
std::vector<std::string> keysCalledFor(std::string_view text);

}  // namespace sline::model
