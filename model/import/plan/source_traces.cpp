// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/source_traces.h"

#include <algorithm>
#include <random>

#include "model/base/sha256.h"

namespace sline::model {

namespace {

std::string digestText(const Sha256& digest) {
  return {digest.begin(), digest.end()};
}

}  // namespace

std::string TraceMaker::checksum(std::string_view of, std::uint64_t mark, const std::string& salt) {
  constexpr int turns = 10'000;
  std::string known = salt + std::string(of) + std::to_string(mark);
  std::string& made = m_made[known];
  if (!made.empty())
    return made;
  Sha256 digest = sha256(known);
  for (int i = 1; i < turns; ++i)
    digest = sha256(digestText(digest) + salt);
  return made = hexDigits(digest, traceDigits / 2);
}

std::optional<SourceTrace> TraceMaker::traceOf(const PatientMarks& marks, const std::string& salt) {
  if (!marks.study && !marks.frame)
    return std::nullopt;
  SourceTrace trace{.salt = salt};
  if (marks.study)
    trace.study = checksum(" study ", *marks.study, salt);
  if (marks.frame)
    trace.frame = checksum(" frame ", *marks.frame, salt);
  return trace;
}

std::string freshSalt() {
  std::random_device chance;
  std::string digits;
  while (digits.size() < traceDigits)
    digits += "0123456789abcdef"[chance() & 15];
  return digits;
}

std::vector<SourceTrace> newTraces(std::span<const PatientMarks> marks,
                                   const std::vector<SourceTrace>& there) {
  const std::string salt = there.empty() ? freshSalt() : there.front().salt;
  TraceMaker maker;
  std::vector<SourceTrace> traces;
  for (const PatientMarks& each : marks) {
    std::optional<SourceTrace> trace = maker.traceOf(each, salt);
    const auto isThere = [&trace](const SourceTrace& other) {
      return other.salt == trace->salt && other.study == trace->study &&
             other.frame == trace->frame;
    };
    if (trace && std::none_of(there.begin(), there.end(), isThere))
      addTraces(traces, {*trace});
  }
  return traces;
}

}  // namespace sline::model
