// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/pdf_file.h"

#include "model/disk/whole_file.h"
#include "render/export/order/drawing_notes.h"
#include "render/export/order/view_orders.h"
#include "render/export/pdf/lesson.h"
#include "render/export/pdf/sheet.h"
#include "render/export/pdf/sheet_options.h"

namespace sline::render {

namespace {

Result<QByteArray> documentOf(const ExportOrder& order, const std::filesystem::path& target,
                              const ExportProgress& progress) {
  if (wantsAllViews(order))
    return lessonDocument(order, target, progress);
  return hasSheet(order) ? sheetDocument(order, target, progress)
                         : figureDocument(order, target, progress);
}

}  // namespace

double pdfWeight(const ExportOrder& order, const ExportProgress& progress) {
  const Result<QByteArray> document = documentOf(order, {}, progress);
  return document.ok() ? double(document->size()) : 0.0;
}

Status writePdf(const ExportOrder& order, const std::filesystem::path& target,
                const ExportProgress& progress) {
  const QByteArray document = TRY(documentOf(order, target, progress));
  progress.note(drawingNotes(order));
  if (progress && !progress(0.95, "writing the file"))
    return givenUp(target);
  return model::writeText(target,
                          std::string_view(document.constData(), std::size_t(document.size())));
}

}  // namespace sline::render
