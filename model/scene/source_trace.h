// SPDX-License-Identifier: Apache-2.0
// Keeps with a scene what tells whether further files are of the same patient, and nobody whose it
// is.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sline::model {

/// Holds one-way checksums of the DICOM identifiers of a study and its frame of reference
/// (model/import/plan/source_traces.h makes and compares them). Names and numbers of patients leave
/// no trace, because they are few enough to be tried out one by one, whatever the checksum.
struct SourceTrace {
  std::string salt;    ///< drawn by chance for each scene, so that scenes cannot be matched by it
  std::string study;   ///< empty: the file does not say
  std::string frame;   ///< likewise
  std::string unread;  ///< like Node::unread
  bool operator==(const SourceTrace&) const = default;
};

inline constexpr std::size_t mostSourceTraces = 64;
/// Salt and checksums have so many hexadecimal digits, lower case.
inline constexpr std::size_t traceDigits = 32;

/// Returns what is wrong with the trace; nothing where it can be compared.
std::optional<std::string_view> traceFault(const SourceTrace& trace);

/// Adds the traces that are not among the first, as many as may be.
void addTraces(std::vector<SourceTrace>& to, const std::vector<SourceTrace>& more);

}  // namespace sline::model
