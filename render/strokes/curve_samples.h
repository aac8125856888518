// SPDX-License-Identifier: Apache-2.0
// Holds one line of a picture at even distances, in rows of numbers, so that loops work on several
// points at once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "render/drawn/picture_view.h"
#include "render/lines/techniques/lines.h"

namespace sline::render {

/// Says what a point's place in the scene does to the pen (METHOD §11.4).
struct PressureRule {
  bool outline = false;    ///< see CurveSettings
  float variation = 1.0f;  ///< likewise
  glm::vec2 light{0.0f};   ///< towards the light in the picture, of any length up to 1
  glm::vec3 back{0.0f};    ///< towards the eye, unit, in the patient
  float low = 0.0f;        ///< the least distance along −back of what the scene shows, mm
  float high = 0.0f;       ///< the largest

  PressureRule(const PictureView& view, const glm::vec3& light, bool outline, float variation);
};

/// How far a curve may lie from its line, px.
struct MoveBounds {
  float most = 0.0f;
  float outwards = 0.0f;  ///< of an outline, along its normals
  float inwards = 0.0f;
};

struct CurveSamples {
  using Row = std::vector<float>;

  std::array<Row, 3> place;
  std::array<Row, 3> normal;
  Row opacity;
  Row entry;
  Row gamma;
  std::array<Row, 2> pixel;
  std::array<Row, 2> outward;  ///< of an outline: where its ink lies; zeros elsewhere
  std::array<Row, 2> move;     ///< to the curve, px
  Row pressure;
  std::vector<std::uint32_t> segments;  ///< of each piece between two samples
  std::vector<std::uint8_t> concave;    ///< whether these are
  float step = 1.0f;                    ///< px
  bool closed = false;

  std::size_t size() const { return opacity.size(); }
  /// Makes room for so many samples without moves and with full pressure.
  void start(std::size_t count);
  /// Sets what a segment says at `t` of its way, from b to a where it is reversed; its ends are
  /// exact, as neighbours share them.
  void set(std::size_t sample, const Segment& segment, bool reversed, float t);
  /// Sets of which segment the piece after that sample is.
  void setPiece(std::size_t piece, std::uint32_t index, const Segment& segment) {
    segments[piece] = index;
    concave[piece] = segment.concave ? 1 : 0;
  }
  /// Makes all normals of unit length.
  void normalise();
  /// Finds where the samples are seen and, where wanted, to where their normals point.
  void project(const PictureView& view, bool outwards);
  /// Finds to which shares the bounds hold the moves; returns false where all may stay.
  bool findShares(bool outline, const MoveBounds& bounds, Row& shares) const;
  /// Finds the pressures; ends come to a point within `reach` λ, 0: they do not. `unit` is λ in px.
  void findPressures(const PressureRule& rule, float reach, float unit);

  glm::vec3 placeOf(std::size_t i) const { return {place[0][i], place[1][i], place[2][i]}; }
  glm::vec3 normalOf(std::size_t i) const { return {normal[0][i], normal[1][i], normal[2][i]}; }
  glm::vec2 pixelOf(std::size_t i) const { return {pixel[0][i], pixel[1][i]}; }
  glm::vec2 outwardOf(std::size_t i) const { return {outward[0][i], outward[1][i]}; }
  glm::vec2 moveOf(std::size_t i) const { return {move[0][i], move[1][i]}; }
};

}  // namespace sline::render
