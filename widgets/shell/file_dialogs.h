// SPDX-License-Identifier: Apache-2.0
// Asks about files. No dialog waits in a loop of its own: each answer goes to the function given.
#pragma once

#include <QStringList>
#include <functional>

class QWidget;

namespace sline::widgets {

/// The setting that keeps the folder from which files were last chosen.
inline constexpr const char* lastFolderKey = "files/folder";

using PathsChosen = std::function<void(const QStringList&)>;

void chooseFiles(QWidget& window, const QString& folder, const PathsChosen& chosen);
void chooseFolder(QWidget& window, const QString& folder, const PathsChosen& chosen);

struct SceneFileQuestion {
  QString title;
  QString suggestion;  ///< with its folder
  /// Gets a path that ends with ".sline" and may be overwritten.
  std::function<void(const QString&)> chosen;
  std::function<void()> cancelled;
};
void chooseSceneFile(QWidget& window, const SceneFileQuestion& question);

struct UnsavedQuestion {
  QString title;  ///< of the document
  std::function<void()> save;
  std::function<void()> discard;
};
/// Asks whether to save, to discard, or neither.
void askAboutUnsaved(QWidget& window, const UnsavedQuestion& question);

/// Asks whether to return to the state on disk.
void askAboutReverting(QWidget& window, const QString& title, const std::function<void()>& revert);

}  // namespace sline::widgets
