// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/target_problems.h"

#include <QDir>
#include <QFileInfo>

#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {

QFileInfo infoOf(const std::filesystem::path& path) {
  return QFileInfo(QString::fromStdString(path.string()));
}

QString problemOf(const QFileInfo& target) {
  const QString folder = QDir::toNativeSeparators(target.absolutePath());
  const QFileInfo above(target.absolutePath());
  if (target.fileName().isEmpty())
    return tr("Say what the file is to be called.");
  constexpr int longestName = 255;  // the bytes that file systems take
  if (target.fileName().toUtf8().size() > longestName)
    return tr("The name is too long for a file: take a shorter one.");
  if (!above.exists())
    return tr("There is no folder “%1”: choose one that is there.").arg(folder);
  if (!above.isDir())
    return tr("“%1” is a file and no folder: choose a folder.").arg(folder);
  if (target.isDir())
    return tr("“%1” is a folder: give the file another name.").arg(target.fileName());
  if (target.exists() ? !target.isWritable() : !above.isWritable())
    return tr("You may not write to “%1”: choose another folder or name.")
        .arg(target.exists() ? target.fileName() : folder);
  return {};
}

}  // namespace

QString targetProblem(const std::vector<std::filesystem::path>& targets) {
  for (const std::filesystem::path& target : targets)
    if (const QString problem = problemOf(infoOf(target)); !problem.isEmpty())
      return problem;
  return {};
}

QStringList existingFiles(const std::vector<std::filesystem::path>& targets) {
  QStringList names;
  for (const std::filesystem::path& target : targets)
    if (const QFileInfo file = infoOf(target); file.isFile())
      names << file.fileName();
  return names;
}

}  // namespace sline::widgets
