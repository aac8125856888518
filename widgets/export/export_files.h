// SPDX-License-Identifier: Apache-2.0
// Turns what the window shows and what the user wants exported of it into the files to write.
#pragma once

#include <vector>

#include "render/export/formats/assembled.h"
#include "widgets/export/export_draft.h"

namespace sline::widgets {

/// Holds what the window shows when an export is asked for.
struct ExportSource {
  model::Scene scene;
  model::Camera camera;
  float aspect = 1.0f;  ///< of the picture in the window, width / height
  bool keyLight = false;
  QString title;             ///< of the document
  render::ExportOrder seen;  ///< how the window shows it: its ground, labels and marks
};

/// Returns the files to write (`render::assembled`): never none.
std::vector<render::ExportPiece> exportFiles(const ExportDraft& draft, const ExportSource& source);
/// Returns what can be looked at of those files: these or, where one holds all views, each view as
/// it is in there.
std::vector<render::ExportPiece> previewedFiles(const ExportDraft& draft,
                                                const std::vector<render::ExportPiece>& files);

/// Returns the languages in which labels have texts, or in which structures have names.
QStringList labelLanguages(const model::Scene& scene);

}  // namespace sline::widgets
