// SPDX-License-Identifier: Apache-2.0
#include "model/edit/blend.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <type_traits>

#include "model/scene/gamma_map.h"
#include "model/scene/resolved_styles.h"
#include "model/scene/style_fields.h"
#include "model/scene/threshold_values.h"

namespace sline::model {

namespace {

std::uint8_t between(std::uint8_t a, std::uint8_t b, float part) {
  return std::uint8_t(std::lround(std::lerp(float(a), float(b), part)));
}

Colour between(const Colour& a, const Colour& b, float part) {
  return {between(a.red, b.red, part), between(a.green, b.green, part),
          between(a.blue, b.blue, part)};
}

float between(float a, float b, float part) {
  return std::lerp(a, b, part);
}

template <class T>
T between(const T& a, const T& b, float part) {
  if constexpr (std::is_enum_v<T>)
    return part < 0.5f ? a : b;
  else
    return T::clamped(std::lerp(a.value(), b.value(), part));
}

/// Blends two answers; where one end has none, it returns that of the nearer end.
template <class T>
std::optional<T> between(const std::optional<T>& a, const std::optional<T>& b, float part) {
  if (a && b)
    return between(*a, *b, part);
  return part < 0.5f ? a : b;
}

/// Returns a look that is as faint as possible, with neither fill nor strokes, for the end at which
/// a structure is hidden; otherwise it is the look of the other end.
ResolvedStyle faint(const ResolvedStyle& look) {
  ResolvedStyle style = look;
  style.opacity = Opacity::clamped(0.0f);
  style.penWeight = 0.0f;
  style.hatchTone = HatchTone::clamped(0.0f);
  return style;
}

Style styleAt(const ResolvedStyle& a, const ResolvedStyle& b, float part) {
  Style style;
  style.visible = a.visible || b.visible;
  forEachLookField([&](const auto& field) {
    style.*field.own = between(a.*field.resolved, b.*field.resolved, part);
  });
  return style;
}

}  // namespace

SceneBlend::SceneBlend(const Scene& from, Scene to) : m_to(std::move(to)) {
  const std::vector<ResolvedStyle> before = resolveAll(from);
  const std::vector<ResolvedStyle> after = resolveAll(m_to);
  std::map<NodeId, std::size_t> places;
  for (std::size_t i = 0; i < from.nodes().size(); ++i)
    places[from.nodes()[i].id] = i;
  for (std::size_t i = 0; i < m_to.nodes().size(); ++i) {
    if (m_to.nodes()[i].isGroup())
      continue;
    const auto place = places.find(m_to.nodes()[i].id);
    Way way{i, place == places.end() ? after[i] : before[place->second], after[i]};
    if (way.from.visible != way.to.visible) {
      ResolvedStyle& hidden = way.from.visible ? way.to : way.from;
      hidden = faint(way.from.visible ? way.from : way.to);
    }
    m_ways.push_back(way);
  }
  for (std::size_t i = 0; i < m_to.sections().size(); ++i)
    for (const Section& old : from.sections())
      if (const Section& now = m_to.sections()[i];
          old.id == now.id && old.plane.normal == now.plane.normal)
        m_slides.push_back({i, double(old.plane.offset)});
}

Scene SceneBlend::at(double part) const {
  if (part >= 1.0)
    return m_to;
  const double inside = std::max(part, 0.0);
  const auto eased = float(inside * inside * (3.0 - 2.0 * inside));
  Scene scene = m_to;
  std::vector<Node> nodes = m_to.nodes();
  for (Node& node : nodes)
    if (node.isGroup())
      node.style.visible = true;  // each structure answers for itself
  for (const Way& way : m_ways)
    nodes[way.node].style = styleAt(way.from, way.to, eased);
  scene.setNodes(std::move(nodes));
  std::vector<Section> sections = m_to.sections();
  for (const Slide& slide : m_slides) {
    float& offset = sections[slide.section].plane.offset;
    offset = float(std::lerp(slide.from, double(offset), double(eased)));
  }
  scene.setSections(std::move(sections));
  return scene;
}

}  // namespace sline::model
