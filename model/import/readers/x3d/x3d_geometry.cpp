// SPDX-License-Identifier: Apache-2.0
#include "model/import/readers/x3d/x3d_geometry.h"

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

#include "model/import/readers/x3d/x3d_fields.h"

namespace sline::model {

namespace {

/// Returns corners in runs that −1 ends.
std::vector<std::uint32_t> cornersOf(const X3dNode& node, const X3dGeometry& kind,
                                     std::size_t points) {
  std::vector<std::uint32_t> corners;
  if (!kind.corners.empty()) {
    // A value that is no index becomes one beyond all points, which is reported when faces are
    // judged.
    for (const double value : numbersIn(node.field(kind.corners)))
      corners.push_back(value == -1.0                           ? noVertex
                        : value >= 0.0 && value < noVertex - 1u ? std::uint32_t(value)
                                                                : noVertex - 1u);
    return corners;
  }
  std::vector<double> counts = kind.counts.empty() ? std::vector<double>{double(points)}
                                                   : numbersIn(node.field(kind.counts));
  std::size_t at = 0;
  for (const double count : counts) {
    for (double i = 0.0; i < count && at < points; ++i)
      corners.push_back(std::uint32_t(at++));
    corners.push_back(noVertex);
  }
  return corners;
}

void addRun(std::span<const std::uint32_t> run, CornerRuns runs, FaceList& faces,
            const char* place) {
  const auto face = [&](std::initializer_list<std::uint32_t> corners) {
    for (const std::uint32_t corner : corners)
      faces.add(corner, place);
    faces.close();
  };
  if (runs == CornerRuns::strips) {
    addStrip(run, faces, place);
  } else if (runs == CornerRuns::fans) {
    for (std::size_t i = 2; i < run.size(); ++i)
      face({run[0], run[i - 1], run[i]});
  } else {
    const std::size_t step = runs == CornerRuns::triangles ? 3
                             : runs == CornerRuns::quads   ? 4
                                                           : std::max<std::size_t>(1, run.size());
    for (std::size_t i = 0; i + step <= run.size() && !run.empty(); i += step) {
      for (const std::uint32_t corner : run.subspan(i, step))
        faces.add(corner, place);
      faces.close();
    }
  }
}

}  // namespace

FaceList facesIn(const X3dNode& node, const X3dGeometry& kind, std::size_t points) {
  const std::vector<std::uint32_t> corners = cornersOf(node, kind, points);
  FaceList faces;
  for (std::size_t begin = 0; begin < corners.size();) {
    const auto end =
        std::size_t(std::find(corners.begin() + std::ptrdiff_t(begin), corners.end(), noVertex) -
                    corners.begin());
    addRun(std::span(corners).subspan(begin, end - begin), kind.runs, faces, node.place);
    begin = end + 1;
  }
  return faces;
}

}  // namespace sline::model
