// SPDX-License-Identifier: Apache-2.0
#include "render/lettering/column_widths.h"

#include <QFontMetricsF>
#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <limits>
#include <utility>

#include "model/scene/cut_place.h"
#include "model/scene/label_words.h"
#include "model/scene/visible_structures.h"
#include "render/labels/label_room.h"

namespace sline::render {

namespace {

/// Describes the room that a width of lines needs.
struct Trial {
  std::array<float, 2> widths{};
  std::array<float, 2> heights{};
  float highest = 0.0f;  ///< that of the highest label
  float text = 0.0f;
};

/// Holds all labels that a column has room for, measured once so that many widths can be tried.
class Trials {
 public:
  explicit Trials(const LabelTexts& texts) : m_texts(texts) {
    std::vector<LabelItem> items;
    for (const ShownLabel& label : texts.labels)
      items.push_back(label.item);
    const float middle = middleBetweenColumns(items, texts.anatomy);
    const float widest = widestTextMm(texts.space.size.x, texts.style);
    const WordRoom words = wordRoom(texts.space.size.x, texts.style);
    for (const ShownLabel& label : texts.labels) {
      if (label.item.offset || label.item.kind == model::AnnotationKind::pin ||
          label.item.kind == model::AnnotationKind::distance)
        continue;
      MeasuredText text(label, texts.style, words);
      if (hasRoom(frameOf(texts.space), text.boxAt(widest)))
        m_columns[placeOf(label.item).x < middle ? 0 : 1].push_back(std::move(text));
    }
  }

  /// Returns trials from narrow to wide.
  std::vector<Trial> all() const {
    constexpr float narrowest = 5.0f;  // of the font's size
    constexpr float step = 0.5f;
    const float em = m_texts.style.points * millimetresPerPoint;
    const float widest = widestTextMm(m_texts.space.size.x, m_texts.style);
    std::vector<Trial> trials;
    for (float width = narrowest * em; width < widest; width += step * em)
      trials.push_back(at(width));
    trials.push_back(at(widest));
    return trials;
  }

 private:
  Trial at(float width) const {
    Trial trial{.text = width};
    for (std::size_t side = 0; side < 2; ++side)
      for (const MeasuredText& text : m_columns[side]) {
        const glm::vec2 box = text.boxAt(width);
        trial.widths[side] = std::max(trial.widths[side], box.x);
        trial.heights[side] += box.y + columnGap;
        trial.highest = std::max(trial.highest, box.y);
      }
    return trial;
  }

  const LabelTexts& m_texts;
  std::array<std::vector<MeasuredText>, 2> m_columns;
};

/// Returns the columns' height as a share of the room for them; at most 1 where they fit.
float crowding(const Trial& trial, const LabelSpace& space) {
  const LabelBox frame = frameOf(space);
  const float height = std::max(frame.size().y, 1.0f);
  // The rest is left for reserved areas, at which columns have gaps.
  constexpr float usable = 0.9f;
  return std::max(trial.heights[0], trial.heights[1]) / (usable * height);
}

ColumnWidths widthsOf(const Trial& trial) {
  return {.left = trial.widths[0], .right = trial.widths[1], .text = trial.text};
}

/// Returns the scale of the anatomy, reduced where columns are crowded or much higher than it, or a
/// label has many lines.
float worth(const Trial& trial, const LabelTexts& texts) {
  const LabelSpace& space = texts.space;
  const glm::vec2 shape = glm::max(texts.anatomy.size(), glm::vec2(1e-3f));
  float width = space.size.x;
  for (const float column : trial.widths)
    width -= column > 0.0f ? column + besideColumnMm() : edgePadding;
  const float height = space.size.y - space.edges.top - space.edges.bottom;
  const float scale = std::max(std::min(width / shape.x, height / shape.y), 1e-3f);
  const float crowded = std::max(crowding(trial, space), 1.0f);
  const float tall = std::max(trial.heights[0], trial.heights[1]) / (scale * shape.y);
  constexpr float dearness = 0.3f;  // of leaders that spread
  constexpr float lineDearness = 0.02f;
  constexpr float fewLines = 3.5f;
  const float lines = trial.highest / lineHeightMm(texts.style);
  return scale / (crowded * crowded) / (1.0f + dearness * std::max(tall - 1.0f, 0.0f)) /
         (1.0f + lineDearness * std::max(lines - fewLines, 0.0f));
}

/// Returns the labels in front of the eye, in the picture or not.
std::vector<ShownLabel> visibleLabels(const model::Scene& scene, const Screen& screen,
                                      const LabelStyle& style) {
  std::vector<ShownLabel> labels;
  int number = 0;
  for (const model::Annotation& annotation : scene.annotations()) {
    if (!annotation.visible)
      continue;
    ShownLabel label;
    label.item.id = annotation.id;
    label.item.kind = annotation.kind;
    label.item.offset = annotation.offset;
    label.text = model::writtenIn(scene, annotation, style.language);
    label.number = ++number;
    for (const model::Anchor& anchor : model::pointedAt(annotation))
      if (const auto point = scene.placeOf(anchor))
        if (const auto place = screen.place(*point))
          label.item.places.push_back(*place);
    if (!label.item.places.empty())
      labels.push_back(std::move(label));
  }
  return labels;
}

/// Returns the extent of the visible structures' boxes; the whole picture where there are none.
LabelBox extentOf(const model::Scene& scene, const Screen& screen) {
  LabelBox anatomy{glm::vec2(std::numeric_limits<float>::infinity()),
                   glm::vec2(-std::numeric_limits<float>::infinity())};
  for (const model::VisibleStructure& structure : model::visibleStructures(scene))
    for (const glm::vec3& point : structure.node->mesh->bounds().corners())
      if (const auto corner = screen.place(point)) {
        anatomy.low = glm::min(anatomy.low, *corner);
        anatomy.high = glm::max(anatomy.high, *corner);
      }
  return anatomy.low.x <= anatomy.high.x ? anatomy : LabelBox{glm::vec2(0.0f), screen.size()};
}

}  // namespace

float besideColumnMm() {
  return edgePadding + anatomyGap;
}

ColumnWidths widthsBesideFitted(const LabelTexts& texts) {
  constexpr float aboutAsLarge = 0.985f;
  const std::vector<Trial> trials = Trials(texts).all();
  float most = 0.0f;
  for (const Trial& trial : trials)
    most = std::max(most, worth(trial, texts));
  const auto widest = std::find_if(trials.rbegin(), trials.rend(), [&](const Trial& trial) {
    return worth(trial, texts) >= aboutAsLarge * most;
  });
  return widthsOf(*widest);
}

ColumnWidths widthsBeside(const LabelTexts& texts) {
  const LabelBox frame = frameOf(texts.space);
  const std::array<float, 2> room{texts.anatomy.low.x - anatomyGap - frame.low.x,
                                  frame.high.x - texts.anatomy.high.x - anatomyGap};
  const auto cost = [&](const Trial& trial) {
    constexpr float dear = 100.0f;
    float over = dear * std::max(crowding(trial, texts.space) - 1.0f, 0.0f);
    for (std::size_t side = 0; side < 2; ++side)
      over += std::max(trial.widths[side] - std::max(room[side], 0.0f), 0.0f);
    return over;
  };
  const std::vector<Trial> trials = Trials(texts).all();
  float least = std::numeric_limits<float>::infinity();
  for (const Trial& trial : trials)
    least = std::min(least, cost(trial));
  constexpr float negligible = 0.4f;
  // Where columns reach into the anatomy anyway, lines are not made very short to avoid it.
  constexpr float shortest = 8.0f;  // of the font's size
  const float em = texts.style.points * millimetresPerPoint;
  const bool reaches = least > negligible;
  const auto counts = [&](const Trial& trial) {
    return !reaches || trial.text >= std::min(shortest * em, trials.back().text);
  };
  if (reaches) {
    least = std::numeric_limits<float>::infinity();
    for (const Trial& trial : trials)
      least = counts(trial) ? std::min(least, cost(trial)) : least;
  }
  const auto widest = std::find_if(trials.rbegin(), trials.rend(), [&](const Trial& trial) {
    return counts(trial) && cost(trial) <= least + negligible;
  });
  return widthsOf(*widest);
}

ColumnWidths widthsBesideFitted(const model::Scene& scene, const Screen& screen,
                                const LabelStyle& style) {
  const std::vector<ShownLabel> labels = visibleLabels(scene, screen, style);
  if (labels.empty())
    return {};
  LabelSpace space;
  space.size = screen.size();
  space.edges = style.edges;
  space.reserved = style.reserved;
  return widthsBesideFitted({labels, style, space, extentOf(scene, screen)});
}

}  // namespace sline::render
