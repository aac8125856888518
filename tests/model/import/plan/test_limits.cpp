// SPDX-License-Identifier: Apache-2.0
// Tests that what is imported can be saved and opened, whatever files say: names, comments and
// numbers at the limits of what a scene may hold and beyond them.
#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <limits>

#include "model/import/plan/import.h"
#include "model/scene/scene_limits.h"
#include "model/scene_file/scene_file.h"
#include "tests/model/import/written_meshes.h"
#include "tests/model/scene_file/sample_scene.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using test::writeText;

namespace {

constexpr const char* square = "v 0 0 0\nv 50 0 0\nv 0 50 0\nv 50 50 9\n";

/// Returns texts at and beyond the limit and what is no text, without line breaks and zeros.
std::vector<QByteArray> texts(std::size_t most) {
  const QByteArray letter("\xc3\xa4");
  return {QByteArray(int(most), 'n'),
          QByteArray(int(most) + 1, 'n'),
          letter.repeated(int(most)),
          letter.repeated(int(most / 2)) + "n",
          QByteArray(int(most), '\x99'),
          "\xff\xfe half \xe2\x82",
          "\x01\x1f\x7f",
          "{\"name\": [}"};
}

/// Imports the folder or file, saves it and opens it again; returns what is wrong. What was mended
/// must have been told.
QString throughImport(const QString& path, bool unchanged) {
  const auto imported = model::importInputs({{path.toStdString()}}, {.keepFileNames = true});
  if (!imported.ok())
    return "not imported: " + QString::fromStdString(imported.error().text());
  const auto fault = model::limitFault(imported->scene);
  if (fault)
    return "beyond its limits: " + QString::fromStdString(fault->text());
  const QString warnings = test::warningsOf(*imported);
  if (!unchanged && !warnings.contains("; it was") && !warnings.contains("; they became") &&
      !warnings.contains("left out") && !warnings.contains("went to the group"))
    return "nothing was told: " + warnings;
  const auto bytes = model::sceneFileBytes({.scene = imported->scene});
  if (!bytes.ok())
    return "not written: " + QString::fromStdString(bytes.error().text());
  const auto again = model::documentFromBytes(*bytes);
  if (!again.ok() || !again->leftOut.empty())
    return "not read: " +
           QString::fromStdString(again.ok() ? again->leftOut[0] : again.error().text());
  return QString::fromStdString(test::difference(again->scene, imported->scene));
}

/// Tells whether a name needs no mending.
bool mayStay(const QByteArray& name) {
  return name.size() <= int(model::longestSceneName) && QString::fromUtf8(name).toUtf8() == name;
}

}  // namespace

class LimitsOfImportTest : public QObject {
  Q_OBJECT
 private slots:
  void namesInFiles();
  void namesOfFilesAndFolders();
  void comments();
  void deepFolders();
  void farAtoms();

 private:
  QString at(const QString& name) const { return m_folder.filePath(name); }
  QTemporaryDir m_folder;
};

void LimitsOfImportTest::namesInFiles() {
  QStringList wrong;
  for (const QByteArray& name : texts(model::longestSceneName)) {
    writeText(at("names.obj"), QByteArray(square) + "g " + name + "\nf 1 2 3\ng other\nf 2 3 4\n");
    writeText(at("names.stl"), "solid " + name +
                                   "\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 50 0 0\n"
                                   "vertex 0 50 0\nendloop\nendfacet\nendsolid\nsolid two\n"
                                   "facet normal 0 0 1\nouter loop\nvertex 0 0 9\nvertex 50 0 9\n"
                                   "vertex 0 50 9\nendloop\nendfacet\nendsolid\n");
    for (const char* file : {"names.obj", "names.stl"})
      if (const QString fault = throughImport(at(file), true); !fault.isEmpty())
        wrong << QString("%1, %2: %3").arg(file, QString::fromLatin1(name.left(20).toHex()), fault);
  }
  QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
}

void LimitsOfImportTest::namesOfFilesAndFolders() {
  QStringList wrong;
  for (const QByteArray& name : texts(200)) {
    if (name.contains('/') || name.size() > 240)
      continue;
    QTemporaryDir folder;
    const QByteArray inside = folder.path().toUtf8() + "/" + name;
    std::error_code fault;
    std::filesystem::create_directory(inside.constData(), fault);
    QVERIFY(!fault);
    for (const char* file : {"/a.obj", "/b.obj"}) {
      std::FILE* out = std::fopen((inside + "/" + name.left(200) + (file + 1)).constData(), "w");
      QVERIFY(out);
      std::fputs(square, out);
      std::fputs(file[1] == 'a' ? "f 1 2 3\n" : "f 2 3 4\n", out);
      std::fclose(out);
    }
    if (const QString told = throughImport(folder.path(), mayStay(name)); !told.isEmpty())
      wrong << QString::fromLatin1(name.left(20).toHex()) + ": " + told;
  }
  QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
}

void LimitsOfImportTest::comments() {
  QStringList wrong;
  for (const QByteArray& text : texts(model::longestCredit)) {
    for (const QByteArray& line :
         {QByteArray("# CC BY ") + text, "# Author: " + text, "#gpl" + text}) {
      writeText(at("comment.obj"), line + "\n" + square + "f 1 2 3\n");
      if (const QString fault = throughImport(at("comment.obj"), true); !fault.isEmpty())
        wrong << QString::fromLatin1(line.left(20).toHex()) + ": " + fault;
    }
    writeText(at("LICENSE"), "MIT License, " + text + "\n");
    if (const QString fault = throughImport(at("comment.obj"), true); !fault.isEmpty())
      wrong << QString::fromLatin1(text.left(20).toHex()) + ", LICENSE: " + fault;
  }
  QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
}

/// Groups of folders lie in each other no deeper than a scene may have them.
void LimitsOfImportTest::deepFolders() {
  for (const int depth : {int(model::deepestSceneGroup), int(model::deepestSceneGroup) + 40}) {
    QTemporaryDir folder;
    QString path = folder.path();
    for (int i = 0; i < depth; ++i) {
      path += QString("/%1").arg(QChar('a' + i % 26));
      QVERIFY(QDir().mkpath(path));
      writeText(path + "/l.obj", QByteArray(square) + "f 1 2 3\n");
      writeText(path + "/m.obj", QByteArray(square) + "f 2 3 4\n");
    }
    QCOMPARE(throughImport(folder.path(), depth <= int(model::deepestSceneGroup)), QString());
  }
}

void LimitsOfImportTest::farAtoms() {
  for (const char* x : {"  10.000", "9999999."}) {
    QByteArray entry;
    for (int i = 1; i <= 4; ++i)
      entry += QString("ATOM  %1  CA  ALA A%2    %3%4%5  1.00  0.00           C\n")
                   .arg(i, 5)
                   .arg(i, 4)
                   .arg(i == 4 ? x : "  10.000")
                   .arg(double(i), 8, 'f', 3)
                   .arg(double(2 * i), 8, 'f', 3)
                   .toUtf8();
    writeText(at("far.pdb"), entry + "END\n");
    const auto imported = model::importInputs({{at("far.pdb").toStdString()}}, {});
    if (!imported.ok())
      continue;  // refused with a reason
    QVERIFY(!model::limitFault(imported->scene));
    QVERIFY(model::sceneFileBytes({.scene = imported->scene}).ok());
  }
}

SLINE_TEST(LimitsOfImportTest)
#include "test_limits.moc"
