// SPDX-License-Identifier: Apache-2.0
#include "widgets/viewport/picture_outlines.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/base/contrast.h"
#include "render/drawn/surface_fill.h"

namespace sline::widgets {

namespace {

/// Line widths in pixels of the window.
struct OutlinePen {
  float width;
  float casing;
  float strength;
};
constexpr OutlinePen selectedPen{2.5f, 1.0f, 1.0f};
constexpr OutlinePen pointedPen{2.0f, 1.0f, 0.6f};
constexpr OutlinePen litPen{3.5f, 1.25f, 1.0f};

Colour groundOf(render::Background background) {
  const glm::vec4 ground = render::backgroundColour(background);
  if (ground.a <= 0.0f)
    return {255, 255, 255};
  const auto byte = [](float part) { return std::uint8_t(std::lround(255.0f * part)); };
  return {byte(ground.r), byte(ground.g), byte(ground.b)};
}

}  // namespace

bool PictureOutlines::point(std::optional<model::NodeId> id) {
  return std::exchange(m_pointed, id) != id;
}

bool PictureOutlines::light(std::optional<model::NodeId> id) {
  return std::exchange(m_lit, id) != id;
}

std::vector<render::Outline> PictureOutlines::around(const model::Scene& scene,
                                                     std::span<const model::NodeId> selection,
                                                     const Look& look) const {
  constexpr double legible = 3.0;  // WCAG 2.2 §1.4.11, for what is no text
  const Colour casing = groundOf(look.background);
  const Colour accent{std::uint8_t(look.accent.red()), std::uint8_t(look.accent.green()),
                      std::uint8_t(look.accent.blue())};
  const Colour ink = legibleOn(casing, accent, legible);
  std::vector<render::Outline> outlines;
  const auto add = [&](std::vector<model::NodeId> structures, const OutlinePen& pen) {
    if (!structures.empty())
      outlines.push_back({.structures = std::move(structures),
                          .ink = ink,
                          .casing = casing,
                          .width = look.pixels * pen.width,
                          .casingWidth = look.pixels * pen.casing,
                          .strength = pen.strength});
  };
  std::vector<model::NodeId> selected = scene.structuresBelow(selection);
  std::sort(selected.begin(), selected.end());
  add(selected, selectedPen);
  if (look.pointed && m_pointed && scene.find(*m_pointed) && m_pointed != m_lit &&
      !std::binary_search(selected.begin(), selected.end(), *m_pointed))
    add({*m_pointed}, pointedPen);
  if (m_lit && scene.find(*m_lit))
    add({*m_lit}, litPen);
  return outlines;
}

}  // namespace sline::widgets
