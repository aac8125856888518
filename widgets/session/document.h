// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>
#include <filesystem>
#include <optional>
#include <vector>

#include "model/import/plan/reload.h"
#include "widgets/session/document_file.h"

namespace sline::widgets {

/// What is open: a scene and the name it goes by. A value, so that undo is the previous one.
struct Document {
  model::Scene scene;
  QString title;
  /// One for each opening, so that whoever shows the document sees where another begins; 0: nothing
  /// was opened yet.
  int opening = 0;
  bool operator==(const Document&) const = default;
};

/// A scene on its way in, and what its reader had to leave out or mend.
struct Loaded {
  model::Scene scene;
  QString title;
  QStringList remarks;
  std::vector<std::filesystem::path> paths;            ///< where it came from; none: it was made
  std::optional<std::vector<model::NewMesh>> renewed;  ///< instead of a scene: new meshes for it
  std::optional<DocumentFile> file;                    ///< of a scene file
  bool added = false;  ///< the scene goes below what is open, as an edit of it
  int reverts = 0;     ///< the opening that goes back to what the disk has; 0: it is a new one
};

/// What files and folders go by: "pelvis", or "liver.stl and 3 more".
QString titleOf(const std::vector<std::filesystem::path>& paths);

/// What was imported from the paths, as a document to be.
Loaded loadedFrom(model::Imported imported, const std::vector<std::filesystem::path>& paths);

}  // namespace sline::widgets
