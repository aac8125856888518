// SPDX-License-Identifier: Apache-2.0
// Shades fills on the processor by the rules of shade.glsl (METHOD §7).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/drawn/surface_fill.h"

namespace sline::render {

/// Names samples of a surface that lie side by side, each value in a row of its own. Normals need
/// not be of unit length; they and the directions are in the patient's frame.
struct SampleRow {
  std::array<const float*, 3> normal{};
  const float* gradient = nullptr;     ///< ⟨k, v̂⟩·F_c; read where `SurfaceFill::byForm`
  const float* gammaOffset = nullptr;  ///< read where Γ varies
  glm::vec3 towardsEye{0.0f};          ///< at the picture's column 0, of any length
  glm::vec3 step{0.0f};                ///< by how much that differs from column to column
  int column = 0;                      ///< the first sample's
  std::size_t count = 0;
};

/// Returns the colour of a fill's soft edge, where the normal lies in the picture, across the
/// contour; `key` is the direction towards a key light in the camera's frame, 0: there is none.
glm::vec3 edgeColour(const glm::vec3& colour, const glm::vec3& key, const glm::vec2& outward);

/// Says how light falls: the fill's shading of a place with a normal.
class FillShading {
 public:
  /// Takes the unit direction towards a key light in the patient's frame; 0: there is none.
  FillShading(const SurfaceFill& fill, const glm::vec3& key);

  /// Returns the premultiplied colour. Both directions have unit length; `offset` is by how much Γ
  /// differs there, where it varies.
  glm::vec4 colourAt(const glm::vec3& normal, const glm::vec3& towardsEye, float gradient,
                     float offset) const;
  /// Finds the colours of the row's samples: red in the lowest 8 bits, premultiplied, alpha in the
  /// highest.
  void shade(const SampleRow& row, std::uint32_t* colours) const;

 private:
  struct Stages {
    float shading;
    float complete;
  };
  Stages stagesAt(float offset) const;
  template <bool keyed, bool varies, bool byForm>
  void shadeRow(const SampleRow& row, std::uint32_t* colours) const;
  template <bool keyed>
  void shadeKeyed(const SampleRow& row, std::uint32_t* colours) const;

  SurfaceFill m_fill;
  FillStages m_stages{};
  glm::vec3 m_key;
  glm::vec3 m_shadow;  ///< the colour where no light falls
};

}  // namespace sline::render
