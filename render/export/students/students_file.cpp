// SPDX-License-Identifier: Apache-2.0
#include "render/export/students/students_file.h"

#include "model/disk/whole_file.h"
#include "model/disk/whole_folder.h"
#include "render/export/students/page_order.h"
#include "render/export/students/page_questions.h"
#include "render/export/students/students_page.h"

namespace sline::render {

namespace fs = std::filesystem;

namespace {

/// More than that needs patience and memory that telephones do not have.
constexpr std::size_t largeScene = 1'000'000;  // triangles

/// Returns "1.3".
std::string millions(std::size_t count) {
  const std::size_t tenths = (count + 50'000) / 100'000;
  return std::to_string(tenths / 10) + '.' + std::to_string(tenths % 10);
}

Error named(Error error, const fs::path& target) {
  if (error.file.empty())
    error.file = target.string();
  return error;
}

}  // namespace

Status writeStudentsPage(const ExportOrder& order, const fs::path& target,
                         const ExportProgress& progress) {
  StudentsOptions own = order.of<StudentsOptions>();
  own.folder = false;
  own.fileTitle = target.stem().string();
  const Result<StudentsPage> page = studentsPage(order, own, progress);
  if (!page.ok())
    return named(page.error(), target);
  progress.note(studentsNotes(order));
  if (progress && !progress(0.95, "writing the file"))
    return givenUp(target);
  return model::writeText(target, page->html);
}

Status writeStudentsFolder(const ExportOrder& order, const fs::path& target,
                           const ExportProgress& progress) {
  StudentsOptions own = order.of<StudentsOptions>();
  own.folder = true;
  own.fileTitle = (target / ".").parent_path().filename().string();
  return model::writeFolder(target, [&](const fs::path& folder) -> Status {
    const Result<StudentsPage> page = studentsPage(order, own, progress);
    if (!page.ok())
      return named(page.error(), target);
    progress.note(studentsNotes(order));
    for (const auto& [name, bytes] : page->files)
      TRY(model::writeText(folder / name, bytes));
    return model::writeText(folder / "index.html", page->html);
  });
}

ExportNotes studentsNotes(const ExportOrder& order) {
  ExportNotes notes;
  const StudentsOptions& own = order.of<StudentsOptions>();
  const std::size_t triangles = trianglesOf(order.scene);
  const bool asked = own.errorMm > 0.0 || own.triangles > 0;
  if (triangles > largeScene && !asked)
    notes.push_back(
        {.kind = ExportNote::Kind::pageLarge, .names = {}, .detail = millions(triangles)});
  if (own.quiz != QuizMode::off && !hasQuestions(order))
    notes.push_back({.kind = ExportNote::Kind::quizEmpty, .names = {}, .detail = {}});
  return notes;
}

}  // namespace sline::render
