// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/input_folder.h"

#include <cstdio>
#include <cstdlib>
#include <string>
#include <system_error>

namespace sline::fuzz {

namespace fs = std::filesystem;

namespace {
[[noreturn]] void giveUp(const std::string& what) {
  std::fprintf(stderr, "%s\n", what.c_str());
  std::abort();
}
}  // namespace

InputFolder::InputFolder() {
  std::string name = (fs::temp_directory_path() / "sline-XXXXXX").string();
  if (!mkdtemp(name.data()))
    giveUp("no folder can be made at " + name);
  m_folder = name;
}

InputFolder::~InputFolder() {
  std::error_code fault;
  fs::remove_all(m_folder, fault);
}

fs::path InputFolder::put(std::string_view extension, std::string_view bytes) const {
  fs::path file = m_folder / ("input" + std::string(extension));
  std::FILE* handle = std::fopen(file.c_str(), "wb");
  if (!handle || std::fwrite(bytes.data(), 1, bytes.size(), handle) != bytes.size() ||
      std::fclose(handle) != 0)
    giveUp("cannot write " + file.string());
  return file;
}

}  // namespace sline::fuzz
