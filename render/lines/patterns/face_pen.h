// SPDX-License-Identifier: Apache-2.0
// Draws marks on a cut face, in the coordinates of its plane, and keeps them within its rim.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/lines/hatching/hatching.h"
#include "render/lines/patterns/face_field.h"

namespace sline::render {

/// How thick a mark is, λ.
struct MarkWidth {
  float middle = 0.42f;  ///< half of the width
  float ends = 1.0f;     ///< the share of it that the ends have
};

class FacePen {
 public:
  /// `margin` is the distance in mm that all marks keep from the rim.
  FacePen(const model::Plane& plane, const FaceField& field, double margin);

  /// Draws a curve through the points, as far as it lies on the face.
  void curve(std::span<const glm::dvec2> points, const MarkWidth& width);
  /// Draws a closed curve through the points.
  void loop(std::vector<glm::dvec2> points, const MarkWidth& width);
  void dot(const glm::dvec2& at, float halfWidth);
  /// Draws a curve of that length along the rim, at that distance from it, around the place where
  /// the shortest way from `near` meets that line; `near` must lie within `reach` mm of it.
  struct RimMark {
    glm::dvec2 near{0.0};
    double distance = 0.0;  ///< mm
    double length = 0.0;    ///< mm
    double reach = 0.0;     ///< mm
  };
  void alongRim(const RimMark& mark, const MarkWidth& width);

  const FaceField& field() const { return m_field; }
  Hatching take() { return std::move(m_drawn); }

 private:
  void add(const glm::dvec2& at, float halfWidth);
  void end();
  bool towards(double distance, glm::dvec2& at) const;

  const FaceField& m_field;
  double m_margin;
  glm::dvec3 m_origin;
  glm::dvec3 m_u;
  glm::dvec3 m_v;
  glm::vec3 m_normal;
  std::uint32_t m_first = 0;  ///< of the stroke under way
  Hatching m_drawn;
};

}  // namespace sline::render
