// SPDX-License-Identifier: Apache-2.0
// Represents the outlines of one slice as a signed distance on a grid.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "model/import/contours/contour_stack.h"

namespace sline::model {

/// Describes samples of a plane, x fastest.
struct PlaneGrid {
  glm::dvec2 origin{0.0};
  double cell = 1.0;  ///< mm
  int columns = 0;
  int rows = 0;

  std::size_t size() const { return std::size_t(columns) * std::size_t(rows); }
};

/// Computes distances, which are negative inside and in mm. They are exact near the outlines
/// (measured to their segments, not to samples); farther away the nearest segment is found by
/// passing it on from sample to sample (Danielsson, "Euclidean distance mapping", 1980), which errs
/// by a fraction of a sample.
class SliceShape {
 public:
  SliceShape(const SliceOutline& outline, const PlaneGrid& grid);

  double offset() const { return m_outline->offset; }
  const std::vector<float>& distances() const { return m_distances; }
  /// Returns the number of the connected piece at each sample, counted from 1; 0 is outside.
  const std::vector<std::uint32_t>& pieces() const { return m_pieces; }
  std::uint32_t pieceCount() const { return m_pieceCount; }
  bool empty() const { return m_pieceCount == 0; }
  /// Returns the distances to the chosen pieces alone (chosen by number; [0] is not looked at).
  /// `nearest`, where given, receives the piece to which each sample's nearest segment belongs.
  std::vector<float> distancesTo(const std::vector<char>& chosen,
                                 std::vector<std::uint32_t>* nearest = nullptr) const;

 private:
  void fill();
  void numberPieces();

  const SliceOutline* m_outline;
  PlaneGrid m_grid;
  std::vector<char> m_inside;
  std::vector<std::uint32_t> m_pieces;
  std::uint32_t m_pieceCount = 0;
  std::vector<std::uint32_t> m_pieceOfSegment;
  std::vector<float> m_distances;
};

}  // namespace sline::model
