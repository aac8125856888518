// SPDX-License-Identifier: Apache-2.0
#include "render/export/plate/picture_frame.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>

#include "model/camera/camera_moves.h"
#include "render/export/plate/figure_plate.h"
#include "render/export/plate/mark_text.h"
#include "render/lettering/column_widths.h"
#include "render/lettering/looks_in_colour.h"

namespace sline::render {

namespace {

constexpr float leastShare = 0.5f;  // of the page that is left within a frame
constexpr float framePen = 0.2f;    // millimetres

void move(glm::vec2& p, const glm::vec2& by) {
  p += by;
}

void move(LabelBox& box, const glm::vec2& by) {
  box = {box.low + by, box.high + by};
}

void move(LabelLayout& layout, const glm::vec2& by) {
  for (PlacedLabel& label : layout.labels) {
    move(label.box, by);
    for (glm::vec2& p : label.leader)
      move(p, by);
  }
  for (float& edge : layout.edges)
    edge += by.x;
  for (LabelLayout& unmoved : layout.unmoved)
    move(unmoved, by);
}

void move(LabelItem& item, const glm::vec2& by) {
  for (glm::vec2& place : item.places)
    move(place, by);
  if (item.base)
    move(*item.base, by);
  if (item.height)
    *item.height += by.y;
}

void move(LabelPlate& plate, const glm::vec2& by) {
  move(plate.layout, by);
  for (ShownLabel& label : plate.labels)
    move(label.item, by);
}

}  // namespace

std::optional<LabelBox> frameBeside(const ExportOrder& order, const LabelPlate& labels,
                                    const Marks& marks) {
  const glm::vec2& page = order.page.sizeMm;
  float widest = 0.0f;
  for (const ShownLabel& label : labels.labels)
    if (!label.item.offset)
      widest = std::max(widest, label.item.box.x);
  const float most = 0.5f * (1.0f - leastShare) * page.x;
  float column = std::min(widest + besideColumnMm(), most);
  // A legend that is wider than that finds no room, which is told; names stand beside what they
  // name.
  if (marks.legend && page.x - marks.legend->low.x <= most)
    column = std::max(column, page.x - marks.legend->low.x);
  const glm::vec2 around{
      column, std::max(markMargin, std::max(marks.edges.top, marks.edges.bottom) + framePen)};
  const glm::vec2 left = page - 2.0f * around;
  constexpr float rounding = 1e-3f;
  if (left.x < leastShare * page.x - rounding || left.y < leastShare * page.y)
    return std::nullopt;
  return LabelBox{around, page - around};
}

Screen screenWithin(const Screen& page, const LabelBox& frame) {
  return Screen(model::withHeight(page.camera(), frame.size().y / page.size().y), frame.size())
      .onDark(page.dark());
}

SeenArea areaWithin(SeenArea area, const LabelBox& frame) {
  for (int y = 0; y < area.grid.rows; ++y)
    for (int x = 0; x < area.grid.columns; ++x)
      if (!frame.contains(area.grid.middle(x, y)))
        area.cells[std::size_t(y) * std::size_t(area.grid.columns) + std::size_t(x)] = false;
  return area;
}

LabelPlate labelsBesideFrame(const ExportOrder& order, const LabelStyle& style,
                             const LabelBox& frame, model::MeshTrees& trees,
                             const LabelTurn& turn) {
  const Screen screen = screenWithin(pageScreen(order), frame);
  LabelStyle within = style;
  within.edges.top = std::max(0.0f, style.edges.top - frame.low.y);
  within.edges.bottom = std::max(0.0f, style.edges.bottom - frame.low.y);
  for (LabelBox& box : within.reserved)
    move(box, -frame.low);
  const SeenArea drawn =
      SeenMap(withLooksInColour(order.scene, style.inColour), screen, &trees).drawnArea();
  std::optional<LabelLayout> before;
  if (turn.before) {
    before = *turn.before;
    move(*before, -frame.low);
  }
  LabelTurn there = turn;
  there.before = before ? &*before : nullptr;
  there.drawn = &drawn;
  there.sideMargin = frame.low.x;
  LabelPlate plate = labelPlate(order.scene, screen, within, trees, there);
  move(plate, frame.low);
  plate.style = style;
  return plate;
}

void addFrame(Marks& marks, const LabelBox& frame, const ExportOrder& order) {
  // Pens reach a little beyond the page on paper that goes on there.
  constexpr float beyond = 0.6f;
  const LabelBox all = LabelBox{glm::vec2(0.0f), order.page.sizeMm}.grown(beyond);
  // They lie over each other: where edges meet within a pixel the drawing would shine through.
  addGround(marks, std::array<LabelBox, 4>{{{all.low, {all.high.x, frame.low.y}},
                                            {{all.low.x, frame.high.y}, all.high},
                                            {all.low, {frame.low.x, all.high.y}},
                                            {{frame.high.x, all.low.y}, all.high}}});
  LetteringItem item{.name = std::string(frameName), .shapes = {}, .text = {}};
  item.shapes.push_back({.path = roundedBox(frame.low, frame.high, 0.0f),
                         .pen = framePen,
                         .ink = letteringColours(order.environment.background).ink,
                         .fill = {},
                         .dashed = false,
                         .halo = 0.0f});
  marks.lettering.items.insert(marks.lettering.items.begin() + 1, std::move(item));
}

}  // namespace sline::render
