// SPDX-License-Identifier: Apache-2.0
#include "render/export/svg/svg_file.h"

#include "model/disk/whole_file.h"
#include "render/export/description/alt_text.h"
#include "render/export/order/drawing_notes.h"
#include "render/export/plate/figure_plate.h"
#include "render/export/svg/svg_document.h"
#include "render/vectors/vector_drawing.h"

namespace sline::render {

Result<std::string> svgText(const ExportOrder& order, const std::filesystem::path& target,
                            const ExportProgress& progress) {
  bool wanted = true;
  const auto tell = [&](double share, std::string_view what) {
    wanted = wanted && (!progress || progress(share, what));
  };
  const VectorDrawing drawing = TRY(drawVectors(
      order.scene, order.camera, {.sizeMm = order.page.sizeMm, .environment = order.environment},
      [&tell](double share, std::string_view what) { tell(0.9 * share, what); }));
  tell(0.9, "writing the file");
  if (!wanted)
    return givenUp(target);
  std::vector<SvgWriting> writings;
  const FigurePlate plate = figurePlate(order);
  progress.note(drawingNotes(order));
  progress.note(plate.notes);
  writings.push_back({"marks", "Marks", plate.marks.lettering});
  if (plate.labels)
    writings.push_back({"labels", "Labels", letteringOf(*plate.labels)});
  return svgDocument(drawing, order.scene, writings, fileCredit(order));
}

Status writeSvg(const ExportOrder& order, const std::filesystem::path& target,
                const ExportProgress& progress) {
  const Result<std::string> text = svgText(order, target, progress);
  return text.ok() ? model::writeText(target, *text) : Status(text.error());
}

double svgWeight(const ExportOrder& order, const ExportProgress& progress) {
  const Result<std::string> text = svgText(order, {}, progress);
  return text.ok() ? double(text->size()) : 0.0;
}

}  // namespace sline::render
