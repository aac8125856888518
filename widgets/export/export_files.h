// SPDX-License-Identifier: Apache-2.0
// From what a person wants to the files that come of it.
#pragma once

#include <filesystem>
#include <vector>

#include "widgets/export/export_draft.h"

namespace sline::widgets {

/// What the window shows when an export is asked for.
struct ExportSource {
  model::Scene scene;
  model::Camera camera;
  float aspect = 1.0f;  ///< of the picture in the window, width / height
  bool keyLight = false;
  QString title;  ///< of the document
};

struct ExportFile {
  render::ExportOrder order;
  bool filled = false;  ///< as in the draft; `readyOrder` sees to it
  std::filesystem::path target;
};

/// What can stand in a file's name everywhere, in any script: marks that separate folders, control
/// and direction marks are blanks or dashes, and nobody's limit is passed. "picture" where nothing
/// is left.
QString safeFileName(const QString& text);

/// "anterior" and so on, as `anatomicalViewNames`, where the camera looks along an axis of the
/// body; else nothing. Marks say it in the language of the labels.
std::string viewNameOf(const model::Camera& camera);

/// The camera such that all that a picture of width / height `before` shows is in one of `aspect`.
model::Camera reframed(model::Camera camera, float before, float aspect);

/// A PDF whose paper is the sheet's, not the page's.
bool isSheet(const ExportDraft& draft);

/// One file, or one for each saved view with its name behind the target's: "pelvis - Front.svg".
/// No two have the same name, whatever the views are called.
std::vector<ExportFile> exportFiles(const ExportDraft& draft, const ExportSource& source);

/// The order with its camera moved where the page is to be filled. Looks at each vertex: nothing
/// for the window's thread.
render::ExportOrder readyOrder(const ExportFile& file);

/// The languages that labels have texts in.
QStringList labelLanguages(const model::Scene& scene);

}  // namespace sline::widgets
