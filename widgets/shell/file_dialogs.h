// SPDX-License-Identifier: Apache-2.0
// What is asked about files. None waits in a loop of its own: answers come to the function given.
#pragma once

#include <QStringList>
#include <functional>

class QWidget;

namespace sline::widgets {

/// The setting that keeps the folder files were last chosen from.
inline constexpr const char* lastFolderKey = "files/folder";

using PathsChosen = std::function<void(const QStringList&)>;

void chooseFiles(QWidget& window, const QString& folder, const PathsChosen& chosen);
void chooseFolder(QWidget& window, const QString& folder, const PathsChosen& chosen);

struct SceneFileQuestion {
  QString title;
  QString suggestion;                          ///< with its folder
  std::function<void(const QString&)> chosen;  ///< ends with ".sline"; may be overwritten
  std::function<void()> cancelled;
};
void chooseSceneFile(QWidget& window, const SceneFileQuestion& question);

struct UnsavedQuestion {
  QString title;  ///< of the document
  std::function<void()> save;
  std::function<void()> discard;
};
/// Save, discard, or neither.
void askAboutUnsaved(QWidget& window, const UnsavedQuestion& question);

/// Whether to go back to what the disk has.
void askAboutReverting(QWidget& window, const QString& title, const std::function<void()>& revert);

}  // namespace sline::widgets
