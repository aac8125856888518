// SPDX-License-Identifier: Apache-2.0
#include "render/export/plate/gamma_key.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/scene/visible_structures.h"
#include "render/export/plate/legend.h"
#include "render/lettering/label_texts.h"
#include "render/lines/ground/stages.h"

namespace sline::render {

namespace {

// Shares of a swatch's width, which is that of a body and the gap beside it.
constexpr float bodyRadius = 0.42f;
constexpr float silhouettePen = 0.045f;
constexpr float contourPen = 0.04f;
constexpr float suggestivePen = 0.028f;
constexpr float hatchPen = 0.02f;
constexpr float widestSwatch = 8.0f;  // millimetres
constexpr float keyHalo = 0.35f;      // millimetres

bool sameScalar(const model::GammaMap& a, const model::GammaMap& b) {
  return a.scalar == b.scalar && a.targets == b.targets && a.place == b.place;
}

/// Returns what is said of the scalar; nothing where it is a distance from what is not there. Of
/// more structures than that, only the first is named.
QString titleOf(const ExportOrder& order, const model::GammaMap& map, const MarkWords& words,
                qsizetype few) {
  const model::DrawnUnit unit = drawnUnit(order.scene);
  if (map.scalar != model::GammaScalar::distance)
    return words.gammaScalar(map.scalar, unit);
  QStringList names;
  for (const model::NodeId target : map.targets)
    if (const model::Node* node = order.scene.find(target))
      names << QString::fromStdString(structureName(*node, order.labels.language)).simplified();
  if (names.isEmpty() && !map.place)
    return {};
  const QString from = names.isEmpty()       ? words.somePlace()
                       : names.size() <= few ? names.join(QStringLiteral(", "))
                                             : names.front() + QStringLiteral(", …");
  return words.gammaScalar(map.scalar, unit).arg(from);
}

Limits<float> rangeOf(const model::GammaMap& map) {
  Limits<float> range{map.curve.front().scalar, map.curve.back().scalar};
  if (map.scalar == model::GammaScalar::distance || map.scalar == model::GammaScalar::painted)
    range.low = std::min(range.low, 0.0f);
  if (map.scalar == model::GammaScalar::painted)
    range.high = std::max(range.high, 1.0f);
  return range;
}

Colour mixed(const Colour& a, const Colour& b, float part) {
  const auto between = [part](std::uint8_t x, std::uint8_t y) {
    return std::uint8_t(std::lround(std::lerp(float(x), float(y), part)));
  };
  return {between(a.red, b.red), between(a.green, b.green), between(a.blue, b.blue)};
}

/// Draws one body as structures of that Γ are drawn.
class Body {
 public:
  Body(const glm::vec2& middle, float swatch, const LetteringColours& colours)
      : m_middle(middle), m_swatch(swatch), m_radius(bodyRadius * swatch), m_colours(colours) {}

  std::vector<LetteringShape> drawn(Gamma gamma, const Colour& colour) {
    const Transitions stage = transitions(gamma);
    const float shade = std::max(stage.shading, stage.complete);
    m_shapes.push_back({.path = circle(m_middle, m_radius),
                        .pen = 0.0f,
                        .ink = m_colours.ink,
                        .fill = mixed(m_colours.ground, colour, shade),
                        .dashed = false,
                        .halo = 0.0f});
    if (shade > 0.0f)
      addShadow(mixed(m_colours.ground, mixed(colour, {0, 0, 0}, 0.45f), shade));
    addHatching(stage.hatching * stage.lines);
    // A fold at the left, as an inner contour, and the form beside it.
    addArc({-0.62f, -0.05f}, {-0.1f, -0.42f}, contourPen * stage.contours * stage.lines);
    addArc({-0.2f, 0.62f}, {0.42f, 0.22f}, suggestivePen * stage.suggestive * stage.lines);
    m_shapes.push_back({.path = circle(m_middle, m_radius),
                        .pen = silhouettePen * m_swatch * std::max(stage.lines, 0.25f),
                        .ink = m_colours.ink,
                        .fill = {},
                        .dashed = false,
                        .halo = keyHalo});
    return std::move(m_shapes);
  }

 private:
  glm::vec2 at(const glm::vec2& p) const { return m_middle + m_radius * p; }

  void addStroke(Path path, float pen) {
    if (pen > 0.0f)
      m_shapes.push_back({.path = std::move(path),
                          .pen = pen * m_swatch,
                          .ink = m_colours.ink,
                          .fill = {},
                          .dashed = false,
                          .halo = 0.0f});
  }

  void addArc(const glm::vec2& from, const glm::vec2& to, float pen) {
    Curve curve{.start = at(from), .pieces = {}, .closed = false};
    const glm::vec2 way = to - from;
    const glm::vec2 out{way.y, -way.x};
    curve.pieces.push_back(
        {at(from + 0.3f * way + 0.35f * out), at(from + 0.7f * way + 0.35f * out), at(to)});
    addStroke({curve}, pen);
  }

  /// Adds a crescent at the lower right.
  void addShadow(const Colour& colour) {
    const glm::vec2 from{0.93f, -0.37f};
    const glm::vec2 to{-0.37f, 0.93f};
    Curve curve{.start = at(from), .pieces = {}, .closed = true};
    curve.pieces.push_back({at({1.12f, 0.62f}), at({0.62f, 1.12f}), at(to)});
    curve.pieces.push_back({at({0.35f, 0.85f}), at({0.85f, 0.35f}), at(from)});
    m_shapes.push_back({.path = {curve},
                        .pen = 0.0f,
                        .ink = m_colours.ink,
                        .fill = colour,
                        .dashed = false,
                        .halo = 0.0f});
  }

  /// Adds strokes across the side away from the light.
  void addHatching(float amount) {
    if (amount <= 0.0f)
      return;
    const glm::vec2 along = glm::normalize(glm::vec2(1.0f, -1.0f));
    const glm::vec2 across = glm::normalize(glm::vec2(1.0f, 1.0f));
    for (float t = 0.25f; t < 0.9f; t += 0.16f) {
      const float half = 0.93f * std::sqrt(1.0f - t * t);
      addStroke(polyline({at(t * across - half * along), at(t * across + half * along)}),
                hatchPen * amount);
    }
  }

  glm::vec2 m_middle;
  float m_swatch;
  float m_radius;
  LetteringColours m_colours;
  std::vector<LetteringShape> m_shapes;
};

float swatchOf(const GammaKeyStyle& style) {
  return std::min(widestSwatch, style.width / float(gammaSwatches));
}

float titleBaseline(const GammaKeyStyle& style) {
  return 1.25f * capHeightMm(style.points);
}

float stripTop(const GammaKeyStyle& style) {
  return titleBaseline(style) + 0.6f * style.points * millimetresPerPoint;
}

/// Returns the number as its scalar has it: whole millimetres, else with a decimal.
QString numberText(const GammaKey& key, float value, const QLocale& locale) {
  const bool whole = key.style.gammaMap.scalar == model::GammaScalar::distance &&
                     key.range.high - key.range.low >= 10.0f;
  return locale.toString(double(value), 'f', whole ? 0 : 1);
}

}  // namespace

std::vector<GammaKey> gammaKeys(const ExportOrder& order, const MarkWords& words) {
  constexpr qsizetype few = 2;
  std::vector<GammaKey> keys;
  for (const model::VisibleStructure& structure : model::visibleStructures(order.scene)) {
    const model::GammaMap& map = structure.style.gammaMap;
    if (map.scalar == model::GammaScalar::none || map.curve.empty() ||
        (map.scalar == model::GammaScalar::painted && !structure.node->paint))
      continue;
    const auto known = std::find_if(keys.begin(), keys.end(), [&map](const GammaKey& key) {
      return sameScalar(key.style.gammaMap, map);
    });
    if (known != keys.end())
      known->alone = false;
    else if (const QString title = titleOf(order, map, words, few); !title.isEmpty())
      keys.push_back({.style = structure.style,
                      .title = title,
                      .fullTitle = titleOf(order, map, words, map.targets.size()),
                      .range = rangeOf(map)});
  }
  return keys;
}

glm::vec2 gammaKeySize(const GammaKey& key, const GammaKeyStyle& style) {
  const float strip = float(gammaSwatches) * swatchOf(style);
  const float numbers = 1.5f * style.points * millimetresPerPoint;
  return {std::max(strip, textWidthMm(key.title, style.points)),
          stripTop(style) + swatchOf(style) + numbers};
}

std::vector<LetteringItem> drawnGammaKey(const GammaKey& key, const glm::vec2& corner,
                                         const GammaKeyStyle& style, const MarkWords& words) {
  constexpr Colour grey{178, 178, 178};
  const float swatch = swatchOf(style);
  const auto text = [&](const QString& line, const glm::vec2& at, TextAnchor anchor) {
    return LetteringText{.lines = {line},
                         .at = corner + at,
                         .leading = 0.0f,
                         .points = style.points,
                         .anchor = anchor,
                         .ink = style.colours.ink};
  };
  std::vector<LetteringItem> items;
  items.push_back({.name = "gamma: " + key.title.toStdString(),
                   .shapes = {},
                   .text = text(key.title, {0.0f, titleBaseline(style)}, TextAnchor::start)});
  const float below = stripTop(style) + swatch + 1.1f * style.points * millimetresPerPoint;
  for (int i = 0; i < gammaSwatches; ++i) {
    const float part = float(i) / float(gammaSwatches - 1);
    const float scalar = std::lerp(key.range.low, key.range.high, part);
    const glm::vec2 middle{(float(i) + 0.5f) * swatch, stripTop(style) + 0.5f * swatch};
    const Gamma gamma =
        Gamma::clamped(key.style.gamma.value() + key.style.gammaMap.offsetAt(scalar));
    LetteringItem item{.name = "gamma " + std::to_string(i + 1),
                       .shapes = Body(corner + middle, swatch, style.colours)
                                     .drawn(gamma, key.alone ? key.style.colour : grey),
                       .text = {}};
    // Every other number has room.
    if (i == 0 || i == gammaSwatches - 1 || (i == 2 && swatch > 0.9f * widestSwatch))
      item.text =
          text(numberText(key, scalar, words.locale()), {middle.x, below}, TextAnchor::middle);
    items.push_back(std::move(item));
  }
  return items;
}

}  // namespace sline::render
