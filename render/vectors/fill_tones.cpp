// SPDX-License-Identifier: Apache-2.0
#include "render/vectors/fill_tones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/base/parallel.h"
#include "render/drawn/fill_shading.h"
#include "render/lines/ground/view_fields.h"
#include "render/sight/flat_triangle.h"

namespace sline::render {

namespace {

float luminance(const glm::vec4& colour) {
  return glm::dot(glm::vec3(colour), glm::vec3(0.299f, 0.587f, 0.114f));
}

// Steps of opacity, and as many of light, where Γ varies: there light is no function of opacity.
constexpr int gridSide = 15;

/// Returns a threshold, 0 … 1, of a pixel's place among its 4 × 4 neighbours (Bayer 1973): the mean
/// of pixels is nearer to the truth than a step.
float ditherAt(std::size_t column, std::size_t row) {
  constexpr std::array<int, 16> order{0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
  return (float(order[4 * (row % 4) + column % 4]) + 0.5f) / 16.0f;
}

/// Returns the tone of a colour, premultiplied, among gridSide².
int gridTone(const glm::vec4& colour, float dither) {
  const auto step = [dither](float value) {
    return std::clamp(int(std::floor(value * float(gridSide - 1) + dither)), 0, gridSide - 1);
  };
  return step(colour.a) * gridSide + step(luminance(colour) / std::max(colour.a, 1e-4f));
}

/// Shades one pixel after the other.
class Shader {
 public:
  Shader(const DrawnStructure& shown, const LayerInput& input)
      : m_surface(shown.surface()),
        m_input(input),
        m_fill(surfaceFill(shown, input.view, input.background)),
        m_shading(m_fill, input.keyLight) {
    if (m_fill.kind == SurfaceFill::Kind::phong && m_fill.byForm)
      findGradients();
  }

  bool flat() const { return m_fill.kind != SurfaceFill::Kind::phong; }
  /// Tells whether some parts of the fill let more through than others.
  bool variesInOpacity() const {
    return m_fill.leastComplete < 1.0f && m_fill.wash.a < 0.999f * m_fill.opacity;
  }
  bool gammaVaries() const { return m_fill.gammaOffsets != nullptr; }
  const glm::vec4& wash() const { return m_fill.wash; }

  glm::vec4 colourAt(std::uint32_t triangle, const glm::vec2& pixel) const {
    const auto& corners = m_surface.mesh->triangles()[triangle];
    const auto positions = m_surface.mesh->positions();
    const PictureView::Point a = m_input.view.project(positions[corners[0]]);
    const PictureView::Point b = m_input.view.project(positions[corners[1]]);
    const PictureView::Point c = m_input.view.project(positions[corners[2]]);
    const FlatTriangle seen({a.pixel, b.pixel, c.pixel}, 1.0f / glm::vec3(a.w, b.w, c.w));
    const glm::vec3 w = seen.inSpace(glm::clamp(seen.sharesAt(pixel), 0.0f, 1.0f));
    glm::vec3 place(0.0f);
    glm::vec3 normal(0.0f);
    float gradient = 0.0f;
    float offset = 0.0f;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = corners[std::size_t(k)];
      place += w[k] * positions[vertex];
      normal += w[k] * m_surface.normals[vertex];
      if (!m_gradients.empty())
        gradient += w[k] * m_gradients[vertex];
      if (m_fill.gammaOffsets)
        offset += w[k] * (*m_fill.gammaOffsets)[vertex];
    }
    return m_shading.colourAt(glm::normalize(normal), directionTo(m_input.view.eye(), place),
                              gradient, offset);
  }

 private:
  void findGradients() {
    const auto positions = m_surface.mesh->positions();
    const model::EyePoint& eye = m_input.view.eye();
    m_gradients.resize(positions.size());
    parallelFor(positions.size(), 4096, [&](std::size_t i) {
      const glm::vec3 v = directionTo(eye, positions[i]);
      const glm::vec3 n = m_surface.normals[i];
      const float distance = eye.atInfinity ? std::numeric_limits<float>::infinity()
                                            : glm::distance(eye.value, positions[i]);
      const glm::vec3 k =
          lightGradient(n, m_surface.curvature.e1[i], m_surface.curvature.k[i], v, distance);
      m_gradients[i] = m_fill.filigree * glm::dot(k, v - glm::dot(n, v) * n);
    });
  }

  const model::Surface& m_surface;
  const LayerInput& m_input;
  SurfaceFill m_fill;
  FillShading m_shading;
  std::vector<float> m_gradients;
};

}  // namespace

void fillTones(const DrawnStructure& shown, const LayerInput& input,
               std::span<const std::uint32_t> triangles, DepthLayer& layer) {
  const Shader shader(shown, input);
  if (shader.flat()) {
    layer.colours.push_back(shader.wash());
    for (std::size_t i = 0; i < triangles.size(); ++i)
      layer.tones[i] = triangles[i] > 0 ? 1 : 0;
    return;
  }
  const bool byOpacity = shader.variesInOpacity();
  const bool byBoth = byOpacity && shader.gammaVaries();
  struct Sum {
    glm::dvec4 colour{0.0};
    std::size_t pixels = 0;
  };
  const auto area = std::count_if(triangles.begin(), triangles.end(),
                                  [](std::uint32_t triangle) { return triangle > 0; });
  // Tones that let something through become pixels, in which their number costs nothing.
  const int toneSteps = byOpacity ? mostToneSteps
                                  : std::clamp(int(std::sqrt(double(area)) / input.pixelsPerTone),
                                               fewestToneSteps, mostToneSteps);
  std::vector<Sum> sums(std::size_t(byBoth ? gridSide * gridSide : mostToneSteps + 1));
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (triangles[i] == 0)
      continue;
    const std::size_t row = i / std::size_t(layer.area.width);
    const std::size_t column = i % std::size_t(layer.area.width);
    const glm::vec2 pixel =
        glm::vec2(layer.area.x, layer.area.y) + glm::vec2(float(column), float(row)) + 0.5f;
    const glm::vec4 colour = shader.colourAt(triangles[i] - 1, pixel);
    const float value = byOpacity ? colour.a : luminance(colour);
    const int step = byBoth ? gridTone(colour, ditherAt(column, row))
                            : std::clamp(int(std::lround(value * float(toneSteps))), 0, toneSteps);
    layer.tones[i] = std::uint8_t(step + 1);
    sums[std::size_t(step)].colour += glm::dvec4(colour);
    ++sums[std::size_t(step)].pixels;
  }
  // Leaves out tones that no pixel has.
  std::vector<std::uint8_t> renamed(sums.size() + 1);
  for (std::size_t step = 0; step < sums.size(); ++step)
    if (sums[step].pixels > 0) {
      layer.colours.emplace_back(sums[step].colour / double(sums[step].pixels));
      renamed[step + 1] = std::uint8_t(layer.colours.size());
    }
  for (std::uint8_t& tone : layer.tones)
    tone = renamed[tone];
}

}  // namespace sline::render
