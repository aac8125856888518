// SPDX-License-Identifier: Apache-2.0
#include "app/cli/jobs/job_ledger.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "model/disk/paths_below.h"
#include "model/disk/whole_file.h"
#include "model/scene_file/fingerprint.h"

namespace sline::cli {

namespace {

constexpr std::size_t longestRecord = std::size_t(1) << 24;

std::string text(const model::Fingerprint& print) {
  return std::to_string(print.bytes) + ' ' + std::to_string(print.crc) + '\n';
}

/// Returns the fingerprint of a file; "absent" where there is none, as for what a demo is called.
std::string textOfFile(const std::filesystem::path& file) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(file, unknown))
    return "absent\n";
  const Result<model::Fingerprint> print = model::fingerprintOfFile(file);
  return print.ok() ? text(*print) : "unreadable\n";
}

/// Returns those of a file, or of each file in a folder with its place there, but for those that
/// are not wanted.
template <class Wanted>
std::string textOfInput(const std::filesystem::path& input, const Wanted& wanted) {
  std::error_code failed;
  if (!std::filesystem::is_directory(input, failed))
    return textOfFile(input);
  std::vector<std::filesystem::path> files;
  std::filesystem::recursive_directory_iterator found(
      input, std::filesystem::directory_options::skip_permission_denied, failed);
  for (const std::filesystem::recursive_directory_iterator end; !failed && found != end;
       found.increment(failed))
    if (std::error_code unknown; found->is_regular_file(unknown) && wanted(found->path()))
      files.push_back(found->path());
  std::sort(files.begin(), files.end());
  std::string all;
  for (const std::filesystem::path& file : files)
    all += text(model::fingerprintOf(file.lexically_relative(input).string())) + textOfFile(file);
  return "folder\n" + text(model::fingerprintOf(all));
}

/// Returns what a job is known by later.
std::string recordText(const JobWork& work, const std::string& read) {
  std::string record = read;
  for (const std::filesystem::path& target : work.targets)
    record += textOfFile(target);
  return record;
}

}  // namespace

JobLedger::JobLedger(std::filesystem::path folder, std::set<std::filesystem::path> written)
    : m_folder(std::move(folder)),
      m_records(m_folder / ".sline-jobs"),
      m_written(std::move(written)) {}

std::string JobLedger::readBy(const JobWork& work) const {
  const std::filesystem::path records = model::realPath(m_records);
  const auto wanted = [&](const std::filesystem::path& file) {
    const std::filesystem::path real = model::realPath(file);
    return real.parent_path() != records && !m_written.contains(real);
  };
  std::string flags;
  std::string read;
  for (const std::string& flag : work.flags) {
    flags += flag + '\0';
    // A camera, a text, a profile: what a flag names may be a file that has changed.
    const std::filesystem::path value = flag.substr(std::min(flag.find('='), flag.size() - 1) + 1);
    if (!value.empty() && wanted(value))
      read += textOfFile(value);
  }
  for (const std::filesystem::path& input : work.inputs) {
    flags += input.string() + '\0';
    read += textOfInput(input, wanted);
  }
  return "Sline " SLINE_VERSION "\n" + text(model::fingerprintOf(flags)) + read;
}

std::filesystem::path JobLedger::recordOf(const JobWork& work) const {
  const model::Fingerprint print =
      model::fingerprintOf(work.targets.front().lexically_relative(m_folder).generic_string());
  return m_records / (std::to_string(print.bytes) + '-' + std::to_string(print.crc));
}

bool JobLedger::done(const JobWork& work) const {
  for (const std::filesystem::path& target : work.targets)
    if (std::error_code unknown; !std::filesystem::exists(target, unknown))
      return false;
  const Result<std::string> record = model::readText(recordOf(work), longestRecord);
  return record.ok() && *record == recordText(work, readBy(work));
}

Status JobLedger::remember(const JobWork& work, const std::string& read) const {
  std::error_code failed;
  std::filesystem::create_directories(m_records, failed);
  if (failed)
    return Error{.file = m_records.string(),
                 .reason = "the folder cannot be made: " + failed.message(),
                 .remedy = "Without it, --resume does finished jobs again"};
  return model::writeBeside(recordOf(work), [&](const std::filesystem::path& temporary) {
    return model::writeText(temporary, recordText(work, read));
  });
}

}  // namespace sline::cli
