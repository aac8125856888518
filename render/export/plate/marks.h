// SPDX-License-Identifier: Apache-2.0
// Lays out the marks at a picture's edges: the sides of the body, the view's name, what sections
// have taken away, a scale bar. Text is as large as that of labels, in points of the output.
#pragma once

#include <optional>
#include <string_view>

#include "render/export/order/export_order.h"
#include "render/labels/seen/seen_map.h"
#include "render/lettering/lettering.h"

namespace sline::render {

/// Says of an order, among its options, whether its scale bar holds for other pictures, too, of
/// which one has a unit that is doubted.
struct SharedScale {
  bool doubted = false;
};

/// Millimetres between marks and the output's edge.
inline constexpr float markMargin = 3.0f;
/// The name of the item that is nothing but ground, below what is written at the foot or around a
/// frame, and that of the frame (picture_frame.h).
inline constexpr std::string_view groundName = "ground";
inline constexpr std::string_view frameName = "frame";

/// Holds an item for each mark: "side L", "view", "section 1" …, "scale", "caption", "sources", and
/// one for each row of the legend and each part of the keys of Γ.
struct Marks {
  Lettering lettering;
  EdgeRoom edges;     ///< the room that they take at each edge, for films, where they come and go
  float foot = 0.0f;  ///< what whose work it is takes of the lower edge, below the others
  /// The box that each mark takes, with air around it; labels and leaders keep out of it
  /// (LabelStyle::reserved).
  std::vector<LabelBox> boxes;
  std::optional<LabelBox> legend;   ///< the one of them that the legend takes
  std::optional<LabelBox> caption;  ///< and what the view says
  /// What is cut off the picture at its foot, for what is written there: a camera of one's own left
  /// no room for it. It has an item, `groundName`, that covers the anatomy.
  std::optional<LabelBox> cutOff;
  ExportNotes notes;  ///< marks that are wanted but missing or shortened
};

/// Lays out the marks that are wanted for the order's scene, camera and page, in the labels' size
/// and language. Letters stand where a side of the body lies in the picture's plane, as in the
/// window; there are none where everything visible comes from files of unknown directions. A mark
/// that has no room on the page, beside what the labels' style reserves, is left out. The camera
/// must be valid.
///
/// Marks keep off what the picture shows, where that is given: a letter moves along its edge, other
/// marks along theirs or to another corner, what the view says in a narrower box if need be, and
/// what would touch anatomy wherever it stood is left out and told. What the view says and whose
/// work it is then stand at the foot of the page, and
/// the picture ends above them (`Marks::cutOff`), which is told, too. Without it each mark is in
/// its usual place: for a camera that is yet to be fitted. In films it is what any frame shows, so
/// that marks stay where they are.
Marks marksOf(const ExportOrder& order, const SeenArea* drawn = nullptr);
/// Covers what lies in the box at the page's foot with ground, below the other marks.
void cutOffAt(Marks& marks, const LabelBox& foot);

/// Tells whether the scene has a visible annotation. If it has none, sheets label structures by
/// themselves (`sheetFigure`).
bool hasLabels(const model::Scene& scene);
/// Returns the sections that are on and take something away of what is visible.
std::vector<const model::Section*> sectionsSeen(const model::Scene& scene);

/// Paints the marks. The painter's unit must be a millimetre, from the picture's upper left corner.
void paintMarks(QPainter& painter, const Marks& marks);

}  // namespace sline::render
