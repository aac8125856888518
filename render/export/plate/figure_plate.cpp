// SPDX-License-Identifier: Apache-2.0
#include "render/export/plate/figure_plate.h"

#include <QString>
#include <algorithm>
#include <set>

#include "model/scene/label_words.h"
#include "model/scene/markup.h"
#include "render/export/plate/mark_text.h"
#include "render/labels/seen_map.h"
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
  return SeenMap(scene, Screen(order.camera, order.page.sizeMm), &trees).drawnArea();
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

}  // namespace

FigurePlate figurePlate(const ExportOrder& order, model::MeshTrees& trees, const LabelTurn& turn) {
  FigurePlate plate{.labels = {}, .marks = marksOf(order), .notes = {}};
  const bool labels = order.labels.mode != LabelMode::off && hasLabels(order.scene);
  std::optional<SeenArea> drawn;
  if (labels || !plate.marks.lettering.items.empty())
    drawn = drawnIn(order, trees);
  if (drawn)
    plate.marks = marksBeside(order, std::move(plate.marks), *drawn);
  plate.notes = plate.marks.notes;
  if (order.labels.mode == LabelMode::off)
    return plate;
  LabelStyle style = order.labels;
  style.ground = order.environment.background;
  style.reserved.insert(style.reserved.end(), plate.marks.boxes.begin(), plate.marks.boxes.end());
  const Screen screen(order.camera, order.page.sizeMm);
  // Below what cuts the picture off there is ground.
  if (drawn && plate.marks.cutOff)
    drawn = areaAbove(std::move(*drawn), plate.marks.cutOff->low.y);
  LabelTurn beside = turn;
  beside.drawn = drawn && !turn.anywhere ? &*drawn : nullptr;
  plate.labels = labelPlate(order.scene, screen, style, trees, beside);
  constexpr std::size_t hardlyAny = 25;
  constexpr std::size_t most = 50;
  if (beside.drawn && findFewer(*plate.labels, hardlyAny)) {
    // Where anatomy fills the picture there is no ground beside it: rather than not at all labels
    // stand on it, with their halos.
    LabelPlate over = labelPlate(order.scene, screen, style, trees, turn);
    if (!findFewer(over, most)) {
      plate.labels = std::move(over);
      addLabels(plate.notes, Kind::labelsOnAnatomy, order, labelsOn(*drawn, *plate.labels));
    }
  }
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

void paintPlate(QPainter& painter, const FigurePlate& plate) {
  if (plate.labels)
    paintLabels(painter, *plate.labels);
  paintMarks(painter, plate.marks);
}

}  // namespace sline::render
