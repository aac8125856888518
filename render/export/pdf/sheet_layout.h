// SPDX-License-Identifier: Apache-2.0
// Decides where things stand on a sheet: the figure, and lists that flow through columns and pages.
// All lengths are millimetres from the paper's upper left corner.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "render/export/order/export_order.h"
#include "render/lettering/caption.h"

namespace sline::render {

/// A line of a list.
enum class RowKind {
  heading,    ///< of a list
  group,      ///< of structures
  legend,     ///< a structure's colour, sample and name
  hidden,     ///< how outlines go on where they are hidden
  number,     ///< a label's number and text
  writeLine,  ///< a number, and a line to write on
  word        ///< one of those to choose from
};
float rowHeight(RowKind kind);

/// The place of a row: the page of the list on which it stands, counted from 0, and its upper left
/// corner.
struct RowPosition {
  std::size_t page = 0;
  glm::vec2 at{0.0f};
};

/// Frames with columns of equal width; rows that do not fit into `first` continue in `next`, page
/// by page.
struct ListFrames {
  LabelBox first;
  int firstColumns = 1;
  LabelBox next;
  int nextColumns = 1;
};
/// The space above the words to choose from.
inline constexpr float wordBankSpace = 3.0f;
/// The space between columns.
inline constexpr float columnSpace = 5.0f;
float columnWidth(const LabelBox& frame, int columns);

/// Returns the rows' places, in their order. Columns of a page are as even as possible, and no
/// heading is the last row of its column.
std::vector<RowPosition> flowIntoColumns(std::span<const RowKind> rows, const ListFrames& frames);

/// Returns the frames that are left below rows in those places, on the last of their pages: that
/// page is their first.
ListFrames framesBelow(std::span<const RowKind> rows, std::span<const RowPosition> places,
                       const ListFrames& frames);

struct SheetLayout {
  glm::vec2 paper{0.0f};
  LabelBox content;  ///< within the margins
  LabelBox figure;
  LabelBox instruction;  ///< above the figure of a test
  LabelBox caption;      ///< what the view says, below the figure; empty where it says nothing
  ListFrames lists;
  LabelBox text;  ///< for `patient`, on the first page
};

/// Returns the layout of the order's sheet; the rows of its lists decide how much of the paper is
/// left to the figure.
SheetLayout sheetLayout(const ExportOrder& order);

/// Tells whether the view says something that is wanted on the order's sheet.
bool hasCaption(const ExportOrder& order);
/// Returns what the view says as it stands on the order's sheet, in that box; nothing where it says
/// nothing or is not wanted, or has no room.
std::optional<Caption> sheetCaption(const ExportOrder& order, const LabelBox& box);

/// How many labels a sheet shows and its test asks for.
struct LabelCounts {
  std::size_t labels = 0;
  std::size_t asked = 0;
};
/// Returns at least as many as the order's sheet will have.
LabelCounts labelCounts(const ExportOrder& order);
/// The rows of the first page's, the test's and the key's lists, and of words to choose from below
/// the test's, where the sheet has them. Labels
/// that the sheet adds have their numbers in the legend, unless that leaves structures out.
struct SheetRows {
  std::vector<RowKind> first;
  std::vector<RowKind> test;
  std::vector<RowKind> words;
  std::vector<RowKind> key;
};
struct LegendRow;
SheetRows sheetRows(const ExportOrder& order, const LabelCounts& counts,
                    const std::vector<LegendRow>& legend);
/// Tells whether the legend of the order's sheet has the numbers of labels.
bool numbersInLegend(const ExportOrder& order);

/// A structure that the legend lists; `newGroup` tells whether its group's heading stands before
/// it.
struct LegendRow {
  const model::Node* node = nullptr;
  bool newGroup = false;
};
/// Returns rows for the structures of the scene that such a legend lists on a sheet, in the order
/// of the scene; what is in no group stands before all groups, or behind them under a heading of
/// its own.
std::vector<LegendRow> legendRows(const model::Scene& scene, LegendList list);

/// Returns in which ways outlines of visible structures are drawn where they are hidden: the legend
/// explains each.
std::vector<model::HiddenLines> hiddenLinesShown(const model::Scene& scene);

/// Returns the size of the order's paper, whether or not it has a sheet.
glm::vec2 sheetPaperMm(const ExportOrder& order);

/// Returns the size of the figure on the order's sheet, to which cameras are fitted; without a
/// sheet, the page's own size.
glm::vec2 sheetFigureMm(const ExportOrder& order);

}  // namespace sline::render
