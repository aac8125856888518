// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/document.h"

#include <memory>
#include <utility>

#include "model/anatomy/shown_names.h"
#include "model/import/kinds/file_kinds.h"
#include "model/scene_file/scene_file.h"
#include "widgets/session/session.h"

namespace sline::widgets {

namespace {

QStringList remarksOf(const model::ImportReport& report) {
  QStringList remarks;
  for (const model::ImportWarning& warning : report.warnings)
    remarks << QString::fromStdString(warning.file.empty() ? warning.reason
                                                           : warning.file + ": " + warning.reason);
  for (const std::string& note : report.notes)
    remarks << QString::fromStdString(note);
  if (!report.repairs.summary.empty())
    remarks << QString::fromStdString(report.repairs.summary);
  return remarks;
}

}  // namespace

QString titleOf(const std::vector<std::filesystem::path>& paths) {
  std::filesystem::path path = paths.empty() ? std::filesystem::path() : paths.front();
  if (!path.has_filename())  // "folder/"
    path = path.parent_path();
  // Whoever saved a scene has named it; what is imported is often named after a patient.
  const std::string shown =
      model::isSceneFile(path) ? path.filename().string() : model::shownName(model::stemOf(path));
  const QString name = shown.empty() ? Session::tr("Untitled") : QString::fromStdString(shown);
  return paths.size() < 2 ? name
                          : Session::tr("%1 and %n more", nullptr, int(paths.size()) - 1).arg(name);
}

LoadedDocument loadedDocument(model::Imported imported, const model::ImportPlan& plan) {
  LoadedDocument loaded{
      .scene = std::move(imported.scene),
      .title = titleOf(plan.inputs),
      .remarks = remarksOf(imported.report),
      .paths = plan.inputs,
      .unitDoubts = imported.report.unitDoubts,
      .recipes = {std::make_shared<const model::ImportPlan>(model::withoutContents(plan))},
      .frameAnew = imported.report.frameAnew};
  if (!imported.others.empty())
    loaded.file = DocumentFile{.others = std::make_shared<const std::vector<model::ZipMember>>(
                                   std::move(imported.others))};
  return loaded;
}

}  // namespace sline::widgets
