// SPDX-License-Identifier: Apache-2.0
#include "model/disk/memory_budget.h"

#include <algorithm>
#include <fstream>
#include <optional>

namespace sline::model {

namespace {

std::optional<std::uint64_t> numberIn(const char* file) {
  std::ifstream in(file);
  std::uint64_t number = 0;
  return in >> number ? std::optional(number) : std::nullopt;
}

std::optional<std::uint64_t> unusedBytes() {
  std::ifstream in("/proc/meminfo");
  std::string name;
  std::uint64_t kibibytes = 0;
  for (std::string unit; in >> name >> kibibytes && std::getline(in, unit);)
    if (name == "MemAvailable:")
      return 1024 * kibibytes;
  return std::nullopt;
}

/// Returns what the container that the process runs in, if any, leaves.
std::optional<std::uint64_t> bytesLeftByContainer() {
  const auto most = numberIn("/sys/fs/cgroup/memory.max");
  const auto used = numberIn("/sys/fs/cgroup/memory.current");
  if (!most || !used)
    return std::nullopt;
  return *most - std::min(*most, *used);
}

}  // namespace

std::uint64_t availableMemory() {
  const auto unused = unusedBytes();
  const auto left = bytesLeftByContainer();
  if (unused && left)
    return std::min(*unused, *left);
  return unused.value_or(left.value_or(0));
}

std::string gigabytes(std::uint64_t bytes) {
  const std::uint64_t tenths = bytes / 100'000'000;
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " GB";
}

Status MemoryBudget::claim(std::uint64_t triangles) {
  const std::uint64_t wanted = bytesPerTriangle * triangles;
  const std::uint64_t before = m_taken.fetch_add(wanted);
  if (m_bytes == 0 || before + wanted <= m_bytes)
    return Unit{};
  m_taken -= wanted;
  return Error{.reason = std::to_string(triangles / 100'000 / 10) + "." +
                         std::to_string(triangles / 100'000 % 10) +
                         " million triangles need at least " + gigabytes(wanted) +
                         " of memory, and " + gigabytes(m_bytes - std::min(m_bytes, before)) +
                         " are left",
               .remedy = "Close other programs, open fewer files, or simplify the mesh first"};
}

}  // namespace sline::model
