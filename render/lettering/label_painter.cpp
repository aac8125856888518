// SPDX-License-Identifier: Apache-2.0
#include "render/lettering/label_painter.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>
#include <tuple>
#include <utility>

#include "render/lettering/column_widths.h"
#include "render/lettering/looks_in_colour.h"

namespace sline::render {

namespace {

// Millimetres of the output.
constexpr float leaderWidth = 0.2f;
constexpr float distanceWidth = 0.25f;
constexpr float lineHalo = 0.35f;  // on either side of lines
constexpr float dotHalo = 0.4f;    // around dots
constexpr float dotRadius = 0.5f;
constexpr float pinRadius = 0.8f;

/// Sets one plate's labels as shapes and text.
class Setting {
 public:
  explicit Setting(const LabelPlate& plate)
      : m_plate(plate), m_colours(letteringColours(plate.style.ground)) {}

  Lettering make() {
    Lettering lettering{.ground = m_colours.ground, .clear = m_colours.clear, .items = {}};
    for (std::size_t i = 0; i < m_plate.labels.size(); ++i)
      if (const PlacedLabel* placed = m_plate.layout.find(m_plate.labels[i].item.id)) {
        m_item = {.name = nameOf(i), .shapes = {}, .text = {}};
        addLeader(*placed);
        addPlaces(i);
        addBox(i, *placed);
        lettering.items.push_back(std::move(m_item));
      }
    return lettering;
  }

 private:
  /// Returns an item's name; a test's lines must not reveal their answers.
  std::string nameOf(std::size_t i) const {
    return m_plate.style.mode == LabelMode::on ? plainText(m_plate.texts[i].lines).toStdString()
                                               : std::to_string(m_plate.labels[i].number);
  }

  LetteringShape& add(Path path, float pen, float halo = lineHalo) {
    return m_item.shapes.emplace_back(
        LetteringShape{.path = std::move(path), .pen = pen, .ink = m_colours.ink, .halo = halo});
  }

  void addLeader(const PlacedLabel& placed) {
    if (placed.leader.size() >= 2)
      add(polyline(placed.leader), leaderWidth).dashed = placed.hidden;
  }

  void addPlaces(std::size_t i) {
    const LabelItem& item = m_plate.labels[i].item;
    if (item.kind == model::AnnotationKind::distance) {
      addDistance(item);
      return;
    }
    const float radius = item.kind == model::AnnotationKind::pin ? pinRadius : dotRadius;
    const Colour colour = m_plate.labels[i].colour.value_or(m_colours.ink);
    for (const glm::vec2& place : item.places) {
      const float pen = item.hidden ? leaderWidth : 0.0f;
      LetteringShape& dot = add(circle(place, radius), pen, dotHalo - 0.5f * pen);
      dot.ink = colour;
      dot.fill = item.hidden ? m_colours.ground : colour;
    }
  }

  /// Adds a line with a bar across at either end. Where surfaces touch the bars are all there is.
  void addDistance(const LabelItem& item) {
    if (item.places.size() != 2)
      return;
    const glm::vec2 way = item.places[1] - item.places[0];
    const float length = glm::length(way);
    const glm::vec2 across =
        1.2f * (length > 0.0f ? glm::vec2(way.y, -way.x) / length : glm::vec2(0.0f, 1.0f));
    for (const glm::vec2& end : item.places)
      add(polyline({end - across, end + across}), distanceWidth).dashed = item.hidden;
    add(polyline(item.places), distanceWidth).dashed = item.hidden;
  }

  void addBox(std::size_t i, const PlacedLabel& placed) {
    const LabelBox& box = placed.box;
    const bool callout = m_plate.labels[i].item.kind == model::AnnotationKind::callout;
    const bool badge = m_plate.style.mode == LabelMode::numbers;
    if (badge || callout)
      add(roundedBox(box.low, box.high, badge ? 0.5f * box.size().y : 0.6f), leaderWidth).fill =
          m_colours.ground;
    if (m_plate.style.mode != LabelMode::blank)
      addText(i, placed);
    else if (!callout)  // a line to write on, which continues the leader
      add(polyline({{box.low.x, box.middle().y}, {box.high.x, box.middle().y}}), leaderWidth);
  }

  /// Returns the anchor on the side of the place: in the left column right, in the right one and
  /// beside the place left.
  TextAnchor anchorOf(std::size_t i, const PlacedLabel& placed) const {
    if (m_plate.style.mode == LabelMode::numbers)
      return TextAnchor::middle;
    if (m_plate.texts[i].list)
      return TextAnchor::start;
    const float place = m_plate.labels[i].item.places.front().x;
    if (placed.post == LabelPost::left ||
        (placed.post == LabelPost::beside && placed.box.high.x < place))
      return TextAnchor::end;
    return TextAnchor::start;
  }

  void addText(std::size_t i, const PlacedLabel& placed) {
    const LabelText& text = m_plate.texts[i];
    const float height = lineHeightMm(m_plate.style);
    const float padding = paddingOf(m_plate.labels[i].item.kind, m_plate.style).x;
    const TextAnchor anchor = anchorOf(i, placed);
    const float x = anchor == TextAnchor::end      ? placed.box.high.x - padding
                    : anchor == TextAnchor::middle ? placed.box.middle().x
                                                   : placed.box.low.x + padding;
    // Capitals stand in the middle of their line.
    const float first = placed.box.middle().y - 0.5f * height * (float(text.lines.size()) - 1.0f);
    m_item.text = LetteringText{.lines = text.lines,
                                .at = {x, first + 0.5f * capHeightMm(m_plate.style.points)},
                                .leading = height,
                                .points = m_plate.style.points,
                                .anchor = anchor,
                                .ink = m_colours.ink};
  }

  const LabelPlate& m_plate;
  LetteringColours m_colours;
  LetteringItem m_item;
};

/// Returns the width of the picture before: lines that break anew while a camera turns would jump.
float textWidthFor(const LabelPlate& plate, const LabelRequest& request, const LabelTurn& turn) {
  if (turn.before && turn.before->textWidth > 0.0f)
    return turn.before->textWidth;
  const LabelBox everywhere{glm::vec2(0.0f), request.space.size};
  return widthsBeside({.labels = plate.labels,
                       .style = plate.style,
                       .space = request.space,
                       .anatomy = request.obstacles.extent.value_or(everywhere)})
      .text;
}

/// Sets the texts in lines of the request's width, and makes them its items.
void setTexts(LabelPlate& plate, LabelRequest& request) {
  const WordRoom words = wordRoom(request.space.size.x, plate.style);
  plate.texts.clear();
  request.items.clear();
  for (ShownLabel& label : plate.labels) {
    plate.texts.push_back(textOf(label, plate.style, request.textWidth, words));
    label.item.box = plate.texts.back().box;
    request.items.push_back(label.item);
  }
}

void setPlate(LabelPlate& plate, LabelRequest& request, const LabelTurn& turn) {
  setTexts(plate, request);
  plate.layout = layOutLabels(request, turn.before);
}

LabelRequest requestOf(const LabelSights& sights, const LabelStyle& style, const LabelTurn& turn) {
  return {.items = {},
          .space = {sights.size, turn.sideMargin, style.edges, style.reserved},
          .obstacles = sights.obstacles,
          .towardsEye = sights.towardsEye,
          .moving = turn.moving,
          .still = turn.still,
          .widths = turn.widths,
          .drawn = turn.drawn};
}

/// Tells whether a column reaches into the anatomy.
bool reachesIn(const LabelLayout& layout, const ObstacleMask& obstacles) {
  return obstacles.extent &&
         (layout.edges[0] > obstacles.extent->low.x || layout.edges[1] < obstacles.extent->high.x);
}

/// Returns widths of lines that may leave fewer labels out. Beside marks there may be room for long
/// lines where there is none for several; beside anatomy that must stay clear, for short ones.
std::vector<float> otherWidths(const LabelSights& sights, const LabelStyle& style, bool shortToo) {
  constexpr float nearlyHalf = 0.42f;
  const float em = style.points * millimetresPerPoint;
  std::vector<float> widths{
      std::max(widestTextMm(sights.size.x, style), nearlyHalf * sights.size.x)};
  if (shortToo)
    for (const float ems : {5.0f, 8.0f})
      widths.push_back(ems * em);
  return widths;
}

LabelPlate emptyPlate(const LabelSights& sights, const LabelStyle& style) {
  return {.style = style,
          .labels = sights.labels.shown,
          .texts = {},
          .layout = {},
          .unseen = sights.labels.unseen};
}

/// Numbers labels as one reads them round the figure: the left column from the top down, then what
/// stands beside its place, then the right column; those without a place come last. In a picture
/// that follows another one labels keep their numbers, and new ones take none that was there.
void numberInReadingOrder(LabelPlate& plate, const LabelLayout* before) {
  std::vector<std::size_t> order(plate.labels.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto key = [&](std::size_t i) {
    const LabelItem& item = plate.labels[i].item;
    const PlacedLabel* was = before ? before->find(item.id) : nullptr;
    const PlacedLabel* placed = plate.layout.find(item.id);
    if (was && was->number > 0)
      return std::tuple(0, was->number, 0.0f);
    if (!placed)
      return std::tuple(2, 0, 0.0f);
    const bool left =
        placed->post == LabelPost::left ||
        (placed->post == LabelPost::byHand && placed->box.middle().x < item.places.front().x);
    const int column = placed->post == LabelPost::beside ? 1 : left ? 0 : 2;
    return std::tuple(1, column, placed->box.middle().y);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&key](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::vector<ShownLabel> labels;
  std::vector<LabelText> texts;
  int last = 0;
  if (before)
    for (const PlacedLabel& was : before->labels)
      last = std::max(last, was.number);
  for (const std::size_t i : order) {
    labels.push_back(std::move(plate.labels[i]));
    const PlacedLabel* was = before ? before->find(labels.back().item.id) : nullptr;
    labels.back().number = was && was->number > 0 ? was->number : ++last;
    texts.push_back(std::move(plate.texts[i]));
    texts.back().lines = {QString::number(labels.back().number)};
    for (PlacedLabel& placed : plate.layout.labels)
      if (placed.id == labels.back().item.id)
        placed.number = labels.back().number;
  }
  plate.labels = std::move(labels);
  plate.texts = std::move(texts);
}

LabelPlate numbered(LabelPlate plate, const LabelTurn& turn) {
  if (plate.style.mode == LabelMode::numbers)
    numberInReadingOrder(plate, turn.before);
  return plate;
}

}  // namespace

LabelSights labelSights(const model::Scene& scene, const Screen& screen,
                        const std::string& language, model::MeshTrees& trees,
                        const LabelsBefore& before) {
  LabelSights sights{.labels = labelsInPicture(scene, screen, language, trees, before),
                     .obstacles = {},
                     .size = screen.size(),
                     .towardsEye = model::cameraFrame(screen.camera()).back};
  if (!sights.labels.shown.empty())
    sights.obstacles = obstaclesOf(scene, screen);
  return sights;
}

float textWidthOf(const LabelSights& sights, const LabelStyle& style) {
  return textWidthFor(emptyPlate(sights, style), requestOf(sights, style, {}), {});
}

LabelRequest filmRequest(const LabelSights& sights, const LabelStyle& style, float textWidth) {
  LabelPlate plate = emptyPlate(sights, style);
  LabelRequest request = requestOf(sights, style, {.still = true});
  request.textWidth = textWidth;
  setTexts(plate, request);
  return request;
}

LabelPlate labelPlate(const LabelSights& sights, const LabelStyle& style, const LabelTurn& turn) {
  LabelPlate plate = emptyPlate(sights, style);
  LabelRequest request = requestOf(sights, style, turn);
  request.textWidth = textWidthFor(plate, request, turn);
  setPlate(plate, request, turn);
  const bool chosen = !turn.before || request.textWidth != turn.before->textWidth;
  if (chosen)
    for (const float width :
         otherWidths(sights, style, turn.drawn && reachesIn(plate.layout, sights.obstacles))) {
      if (plate.layout.leftOut.empty())
        break;
      LabelPlate other = plate;
      request.textWidth = width;
      setPlate(other, request, turn);
      if (other.layout.leftOut.size() < plate.layout.leftOut.size())
        plate = std::move(other);
    }
  return numbered(std::move(plate), turn);
}

static void leaveOutHidden(LabelsInPicture& labels) {
  std::erase_if(labels.shown, [](const ShownLabel& label) { return label.item.hidden; });
  labels.unseen.hidden.clear();
}

LabelPlate labelPlate(const model::Scene& scene, const Screen& screen, const LabelStyle& style,
                      model::MeshTrees& trees, const LabelTurn& turn) {
  LabelSights sights =
      labelSights(withLooksInColour(scene, style.inColour),
                  screen.coveredBy(style.reserved).onDark(style.ground == Background::dark),
                  style.language, trees, {turn.before, turn.hurried});
  if (style.seenOnly)
    leaveOutHidden(sights.labels);
  return labelPlate(sights, style, turn);
}

Lettering letteringOf(const LabelPlate& plate) {
  return Setting(plate).make();
}

void paintLabels(QPainter& painter, const LabelPlate& plate) {
  paintLettering(painter, letteringOf(plate));
}

}  // namespace sline::render
