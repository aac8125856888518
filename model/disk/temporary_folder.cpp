// SPDX-License-Identifier: Apache-2.0
#include "model/disk/temporary_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "model/disk/process.h"

namespace sline::model {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view folderBeginning = "sline-";

/// Returns a descriptor that holds the folder's lock, or a negative number where another process
/// does.
int lockedFolder(const fs::path& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0 || flock(descriptor, LOCK_EX | LOCK_NB) == 0)
    return descriptor;
  close(descriptor);
  return -1;
}

/// Tells whether the name is that of a folder whose process no longer runs here.
bool isAbandoned(std::string_view name) {
  if (!name.starts_with(folderBeginning))
    return false;
  name.remove_prefix(folderBeginning.size());
  int process = 0;
  const char* end = name.data() + name.size();
  const auto [rest, fault] = std::from_chars(name.data(), end, process);
  return fault == std::errc() && rest != end && *rest == '-' && !isRunning(process);
}

/// Removes folders that killed processes have left. A process that is not seen from here, as from
/// within a container, still holds its lock.
void removeAbandoned(const fs::path& where) {
  std::vector<fs::path> abandoned;
  std::error_code fault;
  for (fs::directory_iterator entry(where, fault), end; !fault && entry != end;
       entry.increment(fault))
    if (isAbandoned(entry->path().filename().string()))
      abandoned.push_back(entry->path());
  for (const fs::path& folder : abandoned) {
    struct stat owned {};
    const int lock = lockedFolder(folder);
    if (lock < 0)
      continue;
    if (fstat(lock, &owned) == 0 && owned.st_uid == geteuid())
      fs::remove_all(folder, fault);
    close(lock);
  }
}

}  // namespace

TemporaryFolder::TemporaryFolder(fs::path path)
    : m_path(std::move(path)), m_descriptor(lockedFolder(m_path)) {}

Result<TemporaryFolder> TemporaryFolder::create() {
  std::error_code fault;
  const fs::path where = fs::temp_directory_path(fault);
  if (!fault)
    removeAbandoned(where);
  std::string name =
      (where / (std::string(folderBeginning) + std::to_string(processNumber()) + "-XXXXXX"))
          .string();
  // mkdtemp gives rights to the user alone.
  if (fault || !mkdtemp(name.data()))
    return Error{.file = where.string(),
                 .reason = "no temporary folder can be made here: " +
                           (fault ? fault.message() : std::generic_category().message(errno)),
                 .remedy = "Make room there, or name another folder in TMPDIR"};
  return TemporaryFolder(fs::path(name));
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!m_path.empty())
    fs::remove_all(m_path, ignored);
  if (m_descriptor >= 0)
    close(m_descriptor);
}

}  // namespace sline::model
