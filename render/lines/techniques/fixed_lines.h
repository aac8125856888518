// SPDX-License-Identifier: Apache-2.0
// Keeps lines that lie on a surface whatever the view, and picks those that one sees.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "model/base/parallel.h"
#include "render/lines/ground/line_clip.h"
#include "render/lines/techniques/line_technique.h"

namespace sline::render {

struct FixedLine {
  std::array<LineEnd, 2> ends;  ///< nv is found anew for each view
  std::uint32_t triangle = 0;
  float sharpness = 0.0f;  ///< has its own threshold
};

class FixedLines : public PreparedLines {
 public:
  explicit FixedLines(std::vector<FixedLine> lines) : m_lines(std::move(lines)) {}
  std::size_t count() const override { return m_lines.size(); }
  std::size_t bytes() const override { return m_lines.capacity() * sizeof(FixedLine); }

  /// Appends what the view shows of the lines that are at least that sharp.
  void find(const LineSearch& search, const LineClip& clip, float leastSharpness,
            std::vector<Segment>& segments) const;

 private:
  std::vector<FixedLine> m_lines;
};

/// Calls `add(triangle, lines)` for each triangle, in parallel; lines are kept in the order of
/// their triangles.
template <class Add>
std::vector<FixedLine> fixedLines(std::size_t triangles, const Add& add) {
  constexpr std::size_t perChunk = 4096;
  std::vector<std::vector<FixedLine>> chunks((triangles + perChunk - 1) / perChunk);
  parallelFor(chunks.size(), 1, [&](std::size_t chunk) {
    const std::size_t end = std::min(triangles, (chunk + 1) * perChunk);
    for (std::size_t i = chunk * perChunk; i < end; ++i)
      add(std::uint32_t(i), chunks[chunk]);
  });
  std::vector<FixedLine> all;
  for (const std::vector<FixedLine>& chunk : chunks)
    all.insert(all.end(), chunk.begin(), chunk.end());
  all.shrink_to_fit();
  return all;
}

}  // namespace sline::render
