// SPDX-License-Identifier: Apache-2.0
// Turns what the user wants exported into the files to write.
#pragma once

#include <filesystem>
#include <vector>

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

struct ExportFile {
  render::ExportOrder order;
  bool filled = false;  ///< as in the draft; `readyOrder` moves the camera
  std::filesystem::path target;
};

/// Returns "anterior" and so on, as `anatomicalViewNames` has them, where the camera looks along an
/// axis of the body; otherwise an empty string. Marks say it in the language of the labels.
std::string viewNameOf(const model::Camera& camera);

/// Returns the camera moved such that a picture of width / height `aspect` shows all that one of
/// `before` shows.
model::Camera reframed(model::Camera camera, float before, float aspect);

/// Tells whether the draft is a PDF with the paper's size instead of the page's.
bool isSheet(const ExportDraft& draft);
/// Tells whether the draft is one file of all saved views, and there are some.
bool isLesson(const ExportDraft& draft, const model::Scene& scene);

/// Tells whether the page that the draft was given is not that of its files: sheets have their
/// paper's, films their pictures' size.
bool hasOwnPage(const ExportDraft& draft);

/// Returns one file, or one for each saved view, numbered and with its name appended to the
/// target's: "pelvis - 1 Front.svg".
std::vector<ExportFile> exportFiles(const ExportDraft& draft, const ExportSource& source);
/// Returns what can be looked at of those files: these or, where one holds all views, each view as
/// it is in there.
std::vector<ExportFile> previewedFiles(const ExportDraft& draft,
                                       const std::vector<ExportFile>& files);

/// Returns the order with its camera moved where the page is to be filled. It looks at each vertex,
/// so it must not run on the window's thread.
render::ExportOrder readyOrder(const ExportFile& file);

/// Returns the languages in which labels have texts, or in which structures have names.
QStringList labelLanguages(const model::Scene& scene);

}  // namespace sline::widgets
