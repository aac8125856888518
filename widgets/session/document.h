// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "model/import/plan/patients.h"
#include "model/import/plan/plan.h"
#include "model/import/plan/reload.h"
#include "widgets/session/document_file.h"

namespace sline::widgets {

/// Holds what is open: a scene and its name. It is a value, so that undo restores the previous one.
struct Document {
  model::Scene scene;
  QString title;
  /// A number for each opening, by which views of the document notice that another one begins; 0
  /// while nothing has been opened yet.
  int opening = 0;
  bool operator==(const Document&) const = default;
};

/// What is to be asked before files become a scene, because they are of several patients.
struct PatientQuestion {
  model::Patients patients;
  bool firstAlone = true;  ///< what is of the first patient may come alone
  /// Loads what was asked for as it was answered; called on the GUI's thread.
  std::function<void(model::PatientsWanted)> goOn;
};

/// What was imported into a document, and how, so that it can be imported again otherwise; without
/// what was read.
using ImportRecipe = std::shared_ptr<const model::ImportPlan>;

/// A scene that is being loaded, and what its reader had to leave out or mend.
struct LoadedDocument {
  model::Scene scene;
  QString title;
  QStringList remarks;
  std::vector<std::filesystem::path> paths;  ///< the sources; none if the scene was made here
  std::vector<model::UnitDoubt> unitDoubts;
  std::vector<ImportRecipe> recipes;
  /// How to read what was assumed of the open scene, now that this is added to it.
  std::optional<model::FrameAnew> frameAnew;
  std::optional<PatientQuestion> question;  ///< instead of a scene
  /// Instead of a scene: a plan of scans alone, of which somebody must say what to make.
  std::shared_ptr<const model::ImportPlan> scans;
  /// New meshes for the open scene, instead of a scene.
  std::optional<std::vector<model::NewMesh>> renewed;
  std::optional<DocumentFile> file;  ///< of a scene file
  /// The history that a journal has brought back; `scene` is its first state.
  std::optional<model::Recovered> recovered;
  bool added = false;  ///< the scene goes below what is open, as an edit of it
  int reverts = 0;     ///< the opening that returns to the state on disk; 0: a new opening
};

/// Returns a title for files and folders of what of their names may be shown to others
/// (model/anatomy/shown_names.h): "pelvis", or "liver and 3 more"; that of a scene file is its
/// name.
QString titleOf(const std::vector<std::filesystem::path>& paths);

/// Returns what was imported by the plan, ready to become a document.
LoadedDocument loadedDocument(model::Imported imported, const model::ImportPlan& plan);

}  // namespace sline::widgets
