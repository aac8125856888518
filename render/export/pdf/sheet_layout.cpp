// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/sheet_layout.h"

#include <algorithm>
#include <functional>

#include "model/scene/label_words.h"
#include "model/scene/visible_structures.h"
#include "render/export/order/test_options.h"
#include "render/export/pdf/sheet_figure.h"
#include "render/export/pdf/sheet_options.h"
#include "render/export/plate/legend.h"
#include "render/export/plate/marks.h"
#include "render/lettering/patient_text.h"

namespace sline::render {

namespace {

constexpr float sideMargin = 15.0f;
constexpr float topMargin = 14.0f;
constexpr float bottomMargin = 15.0f;
constexpr float headerHeight = 13.0f;  ///< title and rule
constexpr float belowFigure = 4.0f;
/// The largest share of the content that lists take before they continue on the next page.
constexpr float mostOfHeight = 0.44f;
constexpr float slightlyMore = 0.5f;
constexpr float sideWidth = 62.0f;  ///< of lists beside a figure on landscape paper
constexpr float captionPoints = 10.0f;
constexpr float instructionHeight = 5.5f;
constexpr float mostFigure = 0.65f;       ///< of its frame's height, where it has a caption
constexpr float mostPatientText = 0.42f;  ///< of the first page's height

glm::vec2 paperSize(const SheetOptions& sheet) {
  const glm::vec2 upright =
      sheet.paper == Paper::a4 ? glm::vec2(210.0f, 297.0f) : glm::vec2(215.9f, 279.4f);
  return sheet.landscape ? glm::vec2(upright.y, upright.x) : upright;
}

constexpr float tolerance = 0.01f;  ///< for heights, which are sums

bool isHeading(RowKind kind) {
  return kind == RowKind::heading || kind == RowKind::group;
}

/// Fills columns of that height from the first row on.
class Filling {
 public:
  Filling(std::span<const RowKind> rows, float height, int columns)
      : m_rows(rows), m_height(height), m_columns(columns) {}

  /// Returns the places of the rows that fit: the column, and how far down.
  std::vector<glm::vec2> fill() const {
    std::vector<glm::vec2> places;
    int column = 0;
    float y = 0.0f;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
      // A heading needs room for the first row below it.
      float need = 0.0f;
      for (std::size_t k = i; k < m_rows.size(); ++k) {
        need += rowHeight(m_rows[k]);
        if (!isHeading(m_rows[k]))
          break;
      }
      if (y > 0.0f && y + need > m_height + tolerance) {
        y = 0.0f;
        ++column;
      }
      if (column == m_columns || need > m_height + tolerance)
        break;
      places.emplace_back(float(column), y);
      y += rowHeight(m_rows[i]);
    }
    return places;
  }

 private:
  std::span<const RowKind> m_rows;
  float m_height;
  int m_columns;
};

/// Returns the least height in which all rows fit, or the frame's where they do not.
float evenHeight(std::span<const RowKind> rows, float most, int columns) {
  if (Filling(rows, most, columns).fill().size() < rows.size())
    return most;
  float low = 0.0f;
  float high = most;
  for (int i = 0; i < 24; ++i) {
    const float middle = 0.5f * (low + high);
    (Filling(rows, middle, columns).fill().size() < rows.size() ? low : high) = middle;
  }
  return high;
}

/// Returns the height of a list below a figure: what it needs or, where that is too much, as much
/// as lists take. One that nearly fits gets a little more, and spares a page.
float listsHeight(std::span<const RowKind> rows, float height, int columns) {
  const float little = evenHeight(rows, slightlyMore * height, columns);
  return Filling(rows, little, columns).fill().size() == rows.size()
             ? little
             : evenHeight(rows, mostOfHeight * height, columns);
}

int columnsOf(float width) {
  constexpr float usual = 56.0f;
  return std::max(1, int((width + columnSpace) / (usual + columnSpace) + 0.05f));
}

/// Returns at least as many as the figure will have labels.
std::size_t labelsAtMost(const model::Scene& scene) {
  const auto& annotations = scene.annotations();
  constexpr std::size_t usual = 24;
  return hasLabels(scene)
             ? std::size_t(std::count_if(annotations.begin(), annotations.end(),
                                         [](const model::Annotation& a) { return a.visible; }))
             : std::min(usual, model::visibleStructures(scene).size());
}

}  // namespace

LabelCounts labelCounts(const ExportOrder& order) {
  const std::size_t labels = labelsAtMost(order.scene);
  if (!hasLabels(order.scene))
    return {labels, labels};
  LabelCounts counts{.labels = labels, .asked = 0};
  for (const model::Question& question : questionsOf(order))
    counts.asked += question.labels.size();
  return counts;
}

float rowHeight(RowKind kind) {
  switch (kind) {
    case RowKind::heading:
      return 7.5f;
    case RowKind::group:
    case RowKind::legend:
    case RowKind::hidden:
      return 5.6f;
    case RowKind::number:
    case RowKind::word:
      return 5.0f;
    case RowKind::writeLine:
      break;
  }
  return 8.0f;
}

float columnWidth(const LabelBox& frame, int columns) {
  return (frame.size().x - float(columns - 1) * columnSpace) / float(columns);
}

std::vector<RowPosition> flowIntoColumns(std::span<const RowKind> rows, const ListFrames& frames) {
  std::vector<RowPosition> places;
  for (std::size_t page = 0; places.size() < rows.size(); ++page) {
    const LabelBox& frame = page == 0 ? frames.first : frames.next;
    const int columns = page == 0 ? frames.firstColumns : frames.nextColumns;
    const std::span<const RowKind> rest = rows.subspan(places.size());
    const float height = evenHeight(rest, frame.size().y, columns);
    const float step = columnWidth(frame, columns) + columnSpace;
    const std::vector<glm::vec2> filled = Filling(rest, height, columns).fill();
    for (const glm::vec2& place : filled)
      places.push_back({page, frame.low + glm::vec2(place.x * step, place.y)});
  }
  return places;
}

ListFrames framesBelow(std::span<const RowKind> rows, std::span<const RowPosition> places,
                       const ListFrames& frames) {
  if (rows.empty())
    return frames;
  const bool onFirst = places.back().page == 0;
  ListFrames left{.first = onFirst ? frames.first : frames.next,
                  .firstColumns = onFirst ? frames.firstColumns : frames.nextColumns,
                  .next = frames.next,
                  .nextColumns = frames.nextColumns};
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (places[i].page == places.back().page)
      left.first.low.y = std::max(left.first.low.y, places[i].at.y + rowHeight(rows[i]));
  return left;
}

std::vector<LegendRow> legendRows(const model::Scene& scene, LegendList list) {
  std::vector<LegendRow> rows;
  for (const model::Node* node :
       legendStructures(scene, list == LegendList::onSheets ? LegendList::all : list))
    rows.push_back({node});
  // What is in no group would stand under the heading of the one before it.
  const auto isGrouped = [&scene](const LegendRow& row) { return scene.find(row.node->parent); };
  std::stable_partition(std::find_if(rows.begin(), rows.end(), isGrouped), rows.end(), isGrouped);
  std::size_t groups = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].newGroup = i == 0 || rows[i - 1].node->parent != rows[i].node->parent;
    groups += rows[i].newGroup ? 1 : 0;
  }
  // Headings that would name each structure's own group, or one for all, say nothing; what stands
  // first needs none where it is in no group.
  for (LegendRow& row : rows)
    row.newGroup = row.newGroup && groups > 1 && 2 * groups <= rows.size() &&
                   (isGrouped(row) || row.node != rows.front().node);
  return rows;
}

std::vector<model::HiddenLines> hiddenLinesShown(const model::Scene& scene) {
  const std::vector<model::VisibleStructure> visible = model::visibleStructures(scene);
  std::vector<model::HiddenLines> shown;
  for (const model::HiddenLines how : {model::HiddenLines::thin, model::HiddenLines::dashed})
    if (std::any_of(visible.begin(), visible.end(), [how](const model::VisibleStructure& each) {
          return each.style.hiddenLines == how;
        }))
      shown.push_back(how);
  return shown;
}

bool numbersInLegend(const ExportOrder& order) {
  return !hasLabels(order.scene) && order.legend != LegendList::none &&
         order.legend != LegendList::focus;
}

SheetRows sheetRows(const ExportOrder& order, const LabelCounts& counts,
                    const std::vector<LegendRow>& legend) {
  const SheetKind kind = order.of<SheetOptions>().kind;
  SheetRows rows;
  if (kind != SheetKind::figure && kind != SheetKind::teaching)
    return rows;
  const bool teaching = kind == SheetKind::teaching;
  const LabelMode mode = order.labels.mode;
  const bool numbered = mode == LabelMode::numbers || (teaching && mode == LabelMode::off);
  if (counts.labels > 0 && numbered && !numbersInLegend(order)) {
    rows.first.push_back(RowKind::heading);
    rows.first.insert(rows.first.end(), counts.labels, RowKind::number);
  }
  if (!legend.empty())
    rows.first.push_back(RowKind::heading);
  // Ways of drawing belong to no group: where there are some, they stand before all.
  const std::size_t hidden = legend.empty() ? 0 : hiddenLinesShown(order.scene).size();
  const bool grouped = std::any_of(legend.begin(), legend.end(), std::mem_fn(&LegendRow::newGroup));
  rows.first.insert(rows.first.end(), grouped ? hidden : 0, RowKind::hidden);
  for (const LegendRow& row : legend) {
    if (row.newGroup)
      rows.first.push_back(RowKind::group);
    rows.first.push_back(RowKind::legend);
  }
  rows.first.insert(rows.first.end(), grouped ? 0 : hidden, RowKind::hidden);
  if (teaching) {
    rows.test.assign(counts.asked, RowKind::writeLine);
    rows.key.assign(counts.asked, RowKind::number);
    if (order.of<TestOptions>().wordBank)
      rows.words.assign(counts.asked, RowKind::word);
  }
  return rows;
}

namespace {

/// Returns the layout of a sheet whose view says nothing.
SheetLayout layoutWithoutCaption(const ExportOrder& order) {
  const auto& sheet = order.of<SheetOptions>();
  SheetLayout layout;
  layout.paper = paperSize(sheet);
  const bool header = !sheet.title.empty() || sheet.kind == SheetKind::teaching;
  layout.content = {{sideMargin, topMargin + (header ? headerHeight : 0.0f)},
                    layout.paper - glm::vec2(sideMargin, bottomMargin)};
  layout.figure = layout.content;
  // Marks at the figure's sides are aligned with everything else.
  layout.figure.low.x -= markMargin;
  layout.figure.high.x += markMargin;
  if (sheet.kind == SheetKind::teaching) {
    layout.instruction = {layout.content.low,
                          {layout.content.high.x, layout.content.low.y + instructionHeight}};
    layout.figure.low.y += instructionHeight;
  }
  layout.lists.next = layout.content;
  layout.lists.nextColumns = columnsOf(layout.content.size().x);
  layout.text = layout.content;
  const float height = layout.content.size().y;
  if (sheet.kind == SheetKind::patient) {
    if (!sheet.text.empty()) {
      const float text = patientTextHeight(sheet.text, layout.content.size().x);
      layout.figure.high.y -= std::min(mostPatientText * height, text + belowFigure + tolerance);
      layout.text.low.y = layout.figure.high.y + belowFigure;
    }
    return layout;
  }
  layout.lists.first = layout.content;
  if (sheet.landscape) {
    layout.figure.high.x -= sideWidth + columnSpace;
    layout.lists.first.low.x = layout.content.high.x - sideWidth;
    return layout;
  }
  layout.lists.firstColumns = layout.lists.nextColumns;
  // Where the sheet adds labels, those that it labels are not known yet.
  const bool anyMayBe = order.legend == LegendList::labelled && !hasLabels(order.scene);
  const LabelCounts counts = labelCounts(order);
  std::vector<LegendRow> legend =
      legendRows(order.scene, anyMayBe ? LegendList::all : order.legend);
  if (anyMayBe)
    legend.resize(std::min(legend.size(), counts.labels));
  const SheetRows rows = sheetRows(order, counts, legend);
  const int columns = layout.lists.firstColumns;
  float lists = listsHeight(rows.first, height, columns);
  lists = std::max(lists, listsHeight(rows.key, height, columns));
  float test = listsHeight(rows.test, height, columns);
  if (!rows.words.empty())
    test += wordBankSpace + rowHeight(RowKind::heading) + listsHeight(rows.words, height, columns);
  lists = std::max(lists, std::min(test, mostOfHeight * height));
  layout.lists.first.low.y = layout.content.high.y - lists - 2.0f * tolerance;
  layout.figure.high.y = layout.lists.first.low.y - belowFigure;
  return layout;
}

}  // namespace

bool hasCaption(const ExportOrder& order) {
  const std::string language = model::firstLanguage(order.labels.language);
  const std::string markup =
      captionMarkup(order.words.title.in(language), order.words.text.in(language));
  return order.marks.words && !QString::fromStdString(markup).trimmed().isEmpty();
}

std::optional<Caption> sheetCaption(const ExportOrder& order, const LabelBox& box) {
  if (!order.marks.words)
    return std::nullopt;
  const std::string language = model::firstLanguage(order.labels.language);
  LabelStyle style{.mode = LabelMode::on, .points = captionPoints, .language = language};
  std::optional<Caption> caption =
      captionOf(captionMarkup(order.words.title.in(language), order.words.text.in(language)), style,
                {.middle = box.middle().x,
                 .foot = box.high.y,
                 .width = box.size().x,
                 .height = box.size().y});
  if (!caption)
    return std::nullopt;
  // On paper it needs no box, and begins where everything else does.
  caption->item.shapes.clear();
  caption->item.text->at = {box.low.x, caption->item.text->at.y + box.low.y - caption->box.low.y};
  caption->box = {box.low, box.low + caption->box.size()};
  return caption;
}

SheetLayout sheetLayout(const ExportOrder& order) {
  SheetLayout layout = layoutWithoutCaption(order);
  const LabelBox room{
      {layout.content.low.x, layout.figure.low.y + mostFigure * layout.figure.size().y},
      {layout.figure.high.x - markMargin, layout.figure.high.y}};
  if (const std::optional<Caption> caption = sheetCaption(order, room)) {
    layout.caption = {{room.low.x, room.high.y - caption->box.size().y}, room.high};
    layout.figure.high.y = layout.caption.low.y - belowFigure;
  }
  return layout;
}

glm::vec2 sheetPaperMm(const ExportOrder& order) {
  return paperSize(order.of<SheetOptions>());
}

glm::vec2 sheetFigureMm(const ExportOrder& order) {
  return hasSheet(order) ? sheetLayout(order).figure.size() : order.page.sizeMm;
}

}  // namespace sline::render
