// SPDX-License-Identifier: Apache-2.0
// Makes and compares what a scene keeps of where it came from.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "model/import/plan/patient_marks.h"
#include "model/scene/source_trace.h"

namespace sline::model {

/// Makes the checksums of traces: SHA-256 of salt and identifier, again and again, so that trying
/// identifiers out takes long. Remembers what it has made.
class TraceMaker {
 public:
  /// Returns the trace of what the marks say of study and frame of reference, if anything.
  std::optional<SourceTrace> traceOf(const PatientMarks& marks, const std::string& salt);

 private:
  std::string checksum(std::string_view of, std::uint64_t mark, const std::string& salt);

  std::map<std::string, std::string> m_made;
};

/// Returns a salt by chance.
std::string freshSalt();

/// Returns traces of the marks that are not among those of the scene that they come into, under
/// its salt or, where it has none, a fresh one.
std::vector<SourceTrace> newTraces(std::span<const PatientMarks> marks,
                                   const std::vector<SourceTrace>& there);

}  // namespace sline::model
