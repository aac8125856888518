// SPDX-License-Identifier: Apache-2.0
#include "tests/model/import/worker/spoiled_copies.h"

#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>

#include "model/import/kinds/file_kinds.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/mutator.h"

namespace sline::test {

SpoiledCopies readSpoiledCopies(const QString& name, const QByteArray& bytes) {
  bool told = false;
  const int asked = qEnvironmentVariableIntValue("SLINE_SPOILED_COPIES", &told);
  const QTemporaryDir folder;
  const QString path = folder.filePath(name);
  Mutator mutate(20261123, {});
  SpoiledCopies all;
  for (int i = 0; i < (told ? asked : 15); ++i) {
    writeText(path, mutate(bytes));
    const Result<model::RawMeshes> read = model::readSurfaces(path.toStdString());
    if (read) {
      ++all.read;
      continue;
    }
    ++all.refused;
    all.crashed += read.error().reason.find("crashed") != std::string::npos;
    if (read.error().reason.empty() || read.error().remedy.empty())
      all.silent += QString::fromStdString(read.error().text());
  }
  return all;
}

void judgeSpoiledCopies(const QString& name, const QByteArray& bytes) {
  const SpoiledCopies all = readSpoiledCopies(name, bytes);
  qInfo().noquote() << QStringLiteral("%1: %2 read, %3 refused, %4 of them by a crash in the child")
                           .arg(name)
                           .arg(all.read)
                           .arg(all.refused)
                           .arg(all.crashed);
  QVERIFY2(all.silent.isEmpty(), qPrintable(all.silent.join(QLatin1Char('\n'))));
  QVERIFY2(all.refused > 0, "nothing was spoiled");
}

}  // namespace sline::test
