// SPDX-License-Identifier: Apache-2.0
#include "render/export/plate/figure_plate.h"

#include <QString>
#include <algorithm>
#include <cmath>
#include <set>

#include "model/scene/label_words.h"
#include "model/scene/markup.h"
#include "render/export/plate/mark_text.h"
#include "render/export/plate/picture_frame.h"
#include "render/labels/seen/seen_map.h"
#include "render/lettering/looks_in_colour.h"

namespace sline::render {

namespace {

using Kind = ExportNote::Kind;

/// Returns the name by which the user knows the annotation; a distance need not have a text.
std::string nameOf(const model::Annotation& annotation, const std::string& language) {
  const QString text =
      QString::fromStdString(model::plainTextIn(annotation, language)).simplified();
  return text.isEmpty() ? "distance" : text.toStdString();
}

/// Gathers notes of labels of one kind.
void addLabels(ExportNotes& notes, Kind kind, const ExportOrder& order,
               const std::vector<model::AnnotationId>& ids) {
  const std::set<model::AnnotationId> those(ids.begin(), ids.end());
  ExportNote note{.kind = kind, .names = {}, .detail = {}};
  for (const model::Annotation& annotation : order.scene.annotations())
    if (those.contains(annotation.id))
      note.names.push_back(nameOf(annotation, order.labels.language));
  if (!note.names.empty())
    addNote(notes, std::move(note));
}

/// Notes untranslated texts. Blank lines show no text, and text in the program's own language needs
/// no translation.
void addUntranslated(ExportNotes& notes, const ExportOrder& order, const LabelPlate& plate) {
  const std::string& language = order.labels.language;
  std::vector<std::string> tags = model::languagesIn(language);
  std::erase_if(tags, [](const std::string& tag) { return tag.empty() || tag.starts_with("en"); });
  if (tags.empty() || order.labels.mode == LabelMode::blank)
    return;
  std::set<model::AnnotationId> placed;
  for (const PlacedLabel& label : plate.layout.labels)
    placed.insert(label.id);
  ExportNote note{.kind = Kind::labelsUntranslated, .names = {}, .detail = language};
  for (const model::Annotation& annotation : order.scene.annotations())
    if (placed.contains(annotation.id) && !annotation.text.empty() &&
        std::any_of(tags.begin(), tags.end(), [&annotation](const std::string& tag) {
          return !annotation.texts.contains(tag);
        }))
      note.names.push_back(nameOf(annotation, language));
  if (!note.names.empty())
    addNote(notes, std::move(note));
}

/// Returns what the picture shows, of which marks and labels keep off.
SeenArea drawnIn(const ExportOrder& order, model::MeshTrees& trees) {
  const model::Scene scene = withLooksInColour(order.scene, order.labels.inColour);
  return SeenMap(scene, pageScreen(order), &trees).drawnArea();
}

/// Returns how much of the strips at the left and the right edge, each that share of the width,
/// shows something.
float shareDrawn(const SeenArea& drawn, float strip) {
  const int columns = int(strip * float(drawn.grid.columns));
  int shown = 0;
  for (int y = 0; y < drawn.grid.rows; ++y)
    for (int x = 0; x < columns; ++x)
      shown += int(drawn.at(x, y)) + int(drawn.at(drawn.grid.columns - 1 - x, y));
  return float(shown) / float(std::max(2 * columns * drawn.grid.rows, 1));
}

/// Tells whether fewer than so many in a hundred labels find room.
bool findFewer(const LabelPlate& plate, std::size_t percent) {
  const std::size_t placed = plate.layout.labels.size();
  return 100 * placed < percent * (placed + plate.layout.leftOut.size());
}

/// Returns the labels that stand on what the picture shows.
std::vector<model::AnnotationId> labelsOn(const SeenArea& drawn, const LabelPlate& plate) {
  std::vector<model::AnnotationId> over;
  for (const PlacedLabel& label : plate.layout.labels)
    if (drawn.anyIn(label.box))
      over.push_back(label.id);
  return over;
}

/// Returns the marks, which keep off what the picture shows.
Marks marksBeside(const ExportOrder& order, Marks usual, const SeenArea& drawn) {
  const bool clear = std::none_of(usual.boxes.begin(), usual.boxes.end(),
                                  [&](const LabelBox& box) { return drawn.anyIn(box); });
  return clear ? std::move(usual) : marksOf(order, &drawn);
}

/// Returns the labels' style for what the marks leave of the page.
LabelStyle styleBeside(const ExportOrder& order, const Marks& marks) {
  LabelStyle style = order.labels;
  style.ground = order.environment.background;
  style.reserved.insert(style.reserved.end(), marks.boxes.begin(), marks.boxes.end());
  return style;
}

/// Frames the picture, with labels and marks around it; returns whether that gives more of them
/// ground.
bool framed(FigurePlate& plate, const ExportOrder& order, model::MeshTrees& trees,
            const LabelTurn& turn, const SeenArea& drawn) {
  const std::optional<LabelBox> frame = frameBeside(order, *plate.labels, marksOf(order));
  if (!frame)
    return false;
  const SeenArea within = areaWithin(drawn, *frame);
  Marks marks = marksOf(order, &within);
  LabelPlate labels = labelsBesideFrame(order, styleBeside(order, marks), *frame, trees, turn);
  if (marks.cutOff || labels.layout.labels.size() <= plate.labels->layout.labels.size())
    return false;
  addFrame(marks, *frame, order);
  plate = {.labels = std::move(labels), .marks = std::move(marks), .frame = frame, .notes = {}};
  plate.notes = plate.marks.notes;
  addNote(plate.notes, {.kind = Kind::pictureFramed,
                        .names = {},
                        .detail = std::to_string(std::lround(frame->low.x))});
  return true;
}

/// Lays out the labels beside what is drawn; where that leaves hardly any of them ground, beside a
/// frame; and where there is no room for one, on it.
void addLabelPlate(FigurePlate& plate, const ExportOrder& order, model::MeshTrees& trees,
                   const LabelTurn& turn, std::optional<SeenArea> drawn) {
  const LabelStyle style = styleBeside(order, plate.marks);
  const Screen screen = pageScreen(order);
  // Below what cuts the picture off there is ground.
  if (drawn && plate.marks.cutOff)
    drawn = areaAbove(std::move(*drawn), plate.marks.cutOff->low.y);
  LabelTurn beside = turn;
  beside.drawn = drawn && !turn.anywhere ? &*drawn : nullptr;
  plate.labels = labelPlate(order.scene, screen, style, trees, beside);
  constexpr std::size_t hardlyAny = 25;
  constexpr std::size_t most = 50;
  if (!beside.drawn || !findFewer(*plate.labels, hardlyAny) ||
      (!turn.whole && framed(plate, order, trees, turn, *drawn)))
    return;
  LabelPlate over = labelPlate(order.scene, screen, style, trees, turn);
  if (findFewer(over, most))
    return;
  plate.labels = std::move(over);
  addLabels(plate.notes, Kind::labelsOnAnatomy, order, labelsOn(*drawn, *plate.labels));
}

}  // namespace

FigurePlate figurePlate(const ExportOrder& order, model::MeshTrees& trees, const LabelTurn& turn) {
  FigurePlate plate{.labels = {}, .marks = marksOf(order), .frame = {}, .notes = {}};
  const bool labels = order.labels.mode != LabelMode::off && hasLabels(order.scene);
  std::optional<SeenArea> drawn;
  if (labels || !plate.marks.lettering.items.empty())
    drawn = drawnIn(order, trees);
  if (drawn)
    plate.marks = marksBeside(order, std::move(plate.marks), *drawn);
  plate.notes = plate.marks.notes;
  if (order.labels.mode == LabelMode::off)
    return plate;
  addLabelPlate(plate, order, trees, turn, std::move(drawn));
  const UnseenLabels& unseen = plate.labels->unseen;
  addLabels(plate.notes, Kind::labelsWithoutRoom, order, plate.labels->layout.leftOut);
  addLabels(plate.notes, Kind::labelsOfHidden, order, unseen.notDrawn);
  addLabels(plate.notes, Kind::labelsOffPage, order, unseen.offPicture);
  std::vector<model::AnnotationId> hidden;
  for (const model::AnnotationId id : unseen.hidden)
    if (plate.labels->layout.find(id))
      hidden.push_back(id);
  addLabels(plate.notes, Kind::labelsHidden, order, hidden);
  addUntranslated(plate.notes, order, *plate.labels);
  return plate;
}

FigurePlate figurePlate(const ExportOrder& order) {
  model::MeshTrees trees;
  return figurePlate(order, trees);
}

Screen pageScreen(const ExportOrder& order) {
  return Screen(order.camera, order.page.sizeMm)
      .onDark(order.environment.background == Background::dark);
}

Screen screenSeen(const ExportOrder& order, model::MeshTrees& trees) {
  Screen page = pageScreen(order);
  // Where much is free beside the anatomy labels have ground; it need not be tried.
  constexpr float beside = 0.2f;  // of the width
  constexpr float full = 0.35f;
  if (order.labels.mode == LabelMode::off || !hasLabels(order.scene) ||
      shareDrawn(drawnIn(order, trees), beside) < full)
    return page;
  const FigurePlate plate = figurePlate(order, trees);
  return plate.frame ? screenWithin(page, *plate.frame) : page;
}

void paintPlate(QPainter& painter, const FigurePlate& plate) {
  // Labels stand on the ground around a frame, which is among the marks.
  paintMarks(painter, plate.marks);
  if (plate.labels)
    paintLabels(painter, *plate.labels);
}

}  // namespace sline::render
