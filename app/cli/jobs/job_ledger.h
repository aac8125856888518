// SPDX-License-Identifier: Apache-2.0
// Remembers which jobs are done, by what they read and what they wrote.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "model/base/result.h"

namespace sline::cli {

/// What one job does.
struct JobWork {
  std::vector<std::string> flags;              ///< "--view=left"
  std::vector<std::filesystem::path> inputs;   ///< files and folders
  std::vector<std::filesystem::path> targets;  ///< at least one
};

/// Keeps a record for each job in a folder `.sline-jobs` of the folder that is written to. It holds
/// lengths and checksums (model/scene_file/fingerprint.h) and the program's version, no names, so
/// that it tells nothing of whose data they are. Several programs may use one folder at a time, as
/// each writes the records of its own jobs, whole or not at all.
class JobLedger {
 public:
  /// Keeps records in that folder. What the list's jobs write is no input of theirs, though it may
  /// lie in a folder that is.
  JobLedger(std::filesystem::path folder, std::set<std::filesystem::path> written);

  /// Returns what the job would read, as it is now.
  std::string readBy(const JobWork& work) const;

  /// Tells whether a job that was remembered would do the same once more: its flags, all files
  /// that it reads and all that it wrote are as they were. A file that is there and was not written
  /// by such a job, was cut short or was changed since, is not done.
  bool done(const JobWork& work) const;
  /// Remembers that the job has been done, of what was there when it began.
  Status remember(const JobWork& work, const std::string& read) const;

 private:
  std::filesystem::path recordOf(const JobWork& work) const;
  std::filesystem::path m_folder;
  std::filesystem::path m_records;
  std::set<std::filesystem::path> m_written;
};

}  // namespace sline::cli
