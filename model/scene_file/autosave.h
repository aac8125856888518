// SPDX-License-Identifier: Apache-2.0
// Keeps copies of unsaved work and finds them again after a crash. Each open document has its own
// scene file in a folder of the user's, locked while its program runs: an unlocked copy was left by
// a program that did not end as it should.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/scene_file/scene_file.h"

namespace sline::model {

/// Returns the folder of the copies: $XDG_STATE_HOME/sline/autosave, else
/// ~/.local/state/sline/autosave; empty where neither is known. The folder need not exist.
std::filesystem::path userAutosaveFolder();

/// Says which document a copy belongs to.
struct AutosaveSource {
  std::string title;
  std::filesystem::path file;  ///< empty if it was never saved
  bool operator==(const AutosaveSource&) const = default;
};

/// Keeps the copy of one open document.
class Autosave {
 public:
  /// Makes the folder where it is missing and reserves a name in it, without writing a file yet.
  static Result<Autosave> begin(const std::filesystem::path& folder);

  /// Replaces the copy, whole or not at all. May run on any thread, one call at a time.
  Status keep(const SceneDocument& document, const AutosaveSource& source) const;
  /// Removes the copy, once the document was saved or let go and there is nothing to recover.
  void discard() const;
  const std::filesystem::path& file() const { return m_lock.file(); }

 private:
  explicit Autosave(FileLock lock) : m_lock(std::move(lock)) {}
  FileLock m_lock;
};

/// A copy whose program is no longer running.
struct Recoverable {
  std::filesystem::path copy;
  AutosaveSource source;
  std::filesystem::file_time_type when;
};

/// Returns the copies that can be recovered, the newest first.
std::vector<Recoverable> recoverableIn(const std::filesystem::path& folder);
/// Returns the document as it was kept.
Result<SceneDocument> recovered(const Recoverable& found);
/// Removes the copy, unless a program has taken it meanwhile.
void forget(const Recoverable& found);

/// Tells when the next copy is due: a while after the first change that the last copy lacks, and at
/// once after a large change.
class AutosaveClock {
 public:
  using Time = std::chrono::steady_clock::time_point;
  explicit AutosaveClock(std::chrono::milliseconds every = std::chrono::minutes(1))
      : m_every(every) {}

  void changed(Time now, bool large = false) {
    if (!m_unkept)
      m_since = now;
    m_unkept = true;
    m_large = m_large || large;
  }
  bool due(Time now) const { return m_unkept && (m_large || now - m_since >= m_every); }
  /// Notes that all changes so far are kept, or saved.
  void kept() { m_unkept = m_large = false; }

 private:
  std::chrono::milliseconds m_every;
  Time m_since;
  bool m_unkept = false;
  bool m_large = false;
};

}  // namespace sline::model
