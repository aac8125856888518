// SPDX-License-Identifier: Apache-2.0
#include "model/disk/temporary_folder.h"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

namespace sline::model {

namespace fs = std::filesystem;

Result<TemporaryFolder> TemporaryFolder::create() {
  std::error_code fault;
  const fs::path where = fs::temp_directory_path(fault);
  std::string name = (where / "sline-XXXXXX").string();
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
}

}  // namespace sline::model
