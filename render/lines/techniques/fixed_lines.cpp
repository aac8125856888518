// SPDX-License-Identifier: Apache-2.0
#include "render/lines/techniques/fixed_lines.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "render/lines/ground/view_fields.h"

namespace sline::render {

void FixedLines::find(const LineSearch& search, const LineClip& clip, float leastSharpness,
                      std::vector<Segment>& segments) const {
  const model::EyePoint eye = eyeOf(search.camera);
  for (const FixedLine& line : m_lines) {
    if (line.sharpness < leastSharpness)
      continue;
    std::array<LineEnd, 2> ends = line.ends;
    for (LineEnd& end : ends) {
      const float length = glm::length(end.normal);
      end.nv = glm::dot(end.normal, directionTo(eye, end.position)) / std::max(length, 1e-12f);
    }
    appendClipped(ends, clip, line.triangle, segments);
  }
}

}  // namespace sline::render
