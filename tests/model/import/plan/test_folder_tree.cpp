// SPDX-License-Identifier: Apache-2.0
#include <QDir>
#include <QtTest>
#include <array>

#include "model/import/naming/part_of_table.h"
#include "model/import/plan/import.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

using Path = std::filesystem::path;

Path path(const QTemporaryDir& folder, const QString& below = {}) {
  return Path(folder.filePath(below).toStdString());
}

/// Writes one small mesh per name, at different places.
void writeMeshes(const QTemporaryDir& folder, const QStringList& names) {
  float x = 0.0f;
  for (const QString& name : names)
    test::writeMesh(folder.filePath(name + ".ply"), *test::octahedron({x += 10.0f, 0, 0}, 20));
}

/// Returns "Group / Sub > name" of every structure, in tree order.
QStringList tree(const Scene& scene) {
  QStringList rows;
  for (const Node& node : scene.nodes())
    if (!node.isGroup())
      rows << QString::fromStdString(scene.groupPath(node.id) + " > " + node.name);
  return rows;
}

}  // namespace

class FolderTreeTest : public QObject {
  Q_OBJECT
 private slots:
  void subFolders();
  void chainsAreShortened();
  void manifest();
  void partOfTables();
  void damagedTables();
  void systemsByName();
  void fewStructuresStayFlat();
  void coloursInFiles_data();
  void coloursInFiles();
  void looseFilesAreGroupedTogether();
  void severalInputsAreWrapped();
  void duplicateNames();
  void otherFilesAreIgnored();
};

void FolderTreeTest::subFolders() {
  const QTemporaryDir folder;
  writeMeshes(folder,
              {"arteries/aorta", "arteries/small/renal_artery", "veins/vena_cava", "liver"});
  const auto imported = importInputs(std::array{path(folder)}, {});
  QVERIFY(imported.ok());
  QCOMPARE(tree(imported->scene),
           (QStringList{"arteries / small > renal artery", "arteries > aorta", "veins > vena cava",
                        " > liver"}));
}

void FolderTreeTest::chainsAreShortened() {
  const QTemporaryDir folder;
  writeMeshes(folder, {"export/v2/bones/sacrum", "export/v2/bones/ilium",
                       "export/v2/organs/deep/er/liver"});
  const auto imported = importInputs(std::array{path(folder)}, {});
  QVERIFY(imported.ok());
  QCOMPARE(tree(imported->scene),
           (QStringList{"bones > ilium", "bones > sacrum", "group 2 > liver"}));
}

void FolderTreeTest::manifest() {
  const QTemporaryDir folder;
  writeMeshes(folder, {"a1_liver", "a2_colon", "a3_femur", "a4_tibia", "a5_thing"});
  test::writeText(folder.filePath("MANIFEST.tsv"),
                  "File\tname\tSystem\na1_liver.ply\tx\talimentary\na2_colon.ply\tx\talimentary\r\n"
                  "a3_femur.ply\tx\tskeletal\na4_tibia.ply\tx\tskeletal\nshort\n");
  const auto imported = importInputs(std::array{path(folder)}, {});
  QVERIFY(imported.ok());
  QCOMPARE(tree(imported->scene),
           (QStringList{"Alimentary > a1 liver", "Alimentary > a2 colon", "Skeletal > a3 femur",
                        "Skeletal > a4 tibia", " > structure"}));
}

void FolderTreeTest::partOfTables() {
  const QTemporaryDir folder;
  writeMeshes(folder, {"meshes/FJ1_liver", "meshes/FJ2_colon", "meshes/FJ3_rectum",
                       "meshes/FJ4_femur", "meshes/FJ5_tibia", "meshes/FJ6M_patella"});
  test::writeText(
      folder.filePath("partof_inclusion_relation_list.txt"),
      "parent id\tparent name\tchild id\tchild name\n"
      "B\tbody\tD\tdigestive system\nB\tbody\tL\tlower limb\nD\tdigestive system\tG\tgut\n"
      "G\tgut\tC\tlarge intestine\nL\tlower limb\tX\tleg\n");
  test::writeText(
      folder.filePath("partof_element_parts.txt"),
      "concept id\tname\telement file id\nB\tbody\tFJ1\nD\tdigestive system\tFJ1\n"
      "C\tlarge intestine\tFJ2\nG\tgut\tFJ2\nC\tlarge intestine\tFJ3\nL\tlower limb\tFJ4\n"
      "L\tlower limb\tFJ5\nX\tleg\tFJ5\nX\tleg\tFJ6M\n");
  const auto imported = importInputs(std::array{path(folder, "meshes")}, {});
  QVERIFY(imported.ok());
  // "Gut" holds the large intestine only and is left out.
  QCOMPARE(tree(imported->scene),
           (QStringList{"Digestive system / Large intestine > colon",
                        "Digestive system / Large intestine > rectum", "Digestive system > liver",
                        "Lower limb / Leg > tibia", "Lower limb / Leg > patella",
                        "Lower limb > femur"}));
}

void FolderTreeTest::damagedTables() {
  const QTemporaryDir folder;
  writeMeshes(folder, {"FJ1_liver", "FJ2_colon"});
  // The tables have a circle, short rows, and one does not know the files.
  test::writeText(folder.filePath("partof_inclusion_relation_list.txt"),
                  "h\nA\ta\tB\tb\nB\tb\tA\ta\nC\n");
  test::writeText(folder.filePath("partof_element_parts.txt"), "h\nA\ta\tFJ1\nB\tb\tFJ2\nZ\n");
  const std::vector<std::string> files{"FJ1_liver.ply", "FJ2_colon.ply"};
  QVERIFY(readPartOfTable(path(folder), files).has_value());
  const std::vector<std::string> others{"x.ply", "y.ply"};
  QVERIFY(!readPartOfTable(path(folder), others).has_value());
  QVERIFY(importInputs(std::array{path(folder)}, {}).ok());
}

void FolderTreeTest::systemsByName() {
  const QTemporaryDir folder;
  writeMeshes(folder,
              {"aorta", "left_renal_artery", "left_renal_vein", "vena_cava", "liver", "xyz"});
  const auto imported = importInputs(std::array{path(folder)}, {});
  QVERIFY(imported.ok());
  QCOMPARE(tree(imported->scene), (QStringList{"Arteries > aorta", "Arteries > left renal artery",
                                               "Veins > left renal vein", "Veins > vena cava",
                                               " > liver", " > structure"}));
  const Scene& scene = imported->scene;
  const Colour red = scene.resolve(test::named(scene, "aorta").id).colour;
  const Colour blue = scene.resolve(test::named(scene, "vena cava").id).colour;
  QVERIFY(red.red > 150 && red.blue < 80);
  QVERIFY(blue.blue > 120 && blue.red < 80);
  QCOMPARE(test::named(scene, "Arteries").style.colour, std::optional(red));
}

void FolderTreeTest::fewStructuresStayFlat() {
  const QTemporaryDir folder;
  writeMeshes(folder, {"aorta", "left_renal_artery", "liver"});
  const auto imported = importInputs(std::array{path(folder)}, {});
  QVERIFY(imported.ok());
  QCOMPARE(tree(imported->scene), (QStringList{" > aorta", " > left renal artery", " > liver"}));
}

void FolderTreeTest::coloursInFiles_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QByteArray>("material");
  QTest::addColumn<QList<int>>("expected");
  const QByteArray green = "[0,1,0,1]";
  const QByteArray grey = "[0.5,0.5,0.5,1]";
  const QList<int> bile{60, 130, 90};
  QTest::newRow("unknown name, chosen colour") << "gizmo" << green << QList<int>{0, 255, 0};
  QTest::newRow("unknown name, grey") << "gizmo" << grey << QList<int>{200, 200, 200};
  QTest::newRow("known name, grey") << "gallbladder" << grey << bile;
  QTest::newRow("known name, chosen colour") << "gallbladder" << green << bile;
}

void FolderTreeTest::coloursInFiles() {
  QFETCH(QString, name);
  QFETCH(QByteArray, material);
  QFETCH(QList<int>, expected);
  const QTemporaryDir folder;
  const QString file = folder.filePath(name + ".gltf");
  test::writeMesh(file, *test::octahedron({}, 20));
  QFile written(file);
  QVERIFY(written.open(QIODevice::ReadOnly));
  QByteArray text = written.readAll();
  text.replace("\"indices\":0}", "\"indices\":0,\"material\":0}");
  text.chop(1);
  test::writeText(file, text + ",\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorFactor\":" +
                            material + "}}]}");
  const auto imported = importInputs(std::array{path(folder)}, {});
  QVERIFY(imported.ok());
  const Colour c = imported->scene.resolve(imported->scene.nodes().front().id).colour;
  QCOMPARE((QList<int>{c.red, c.green, c.blue}), expected);
}

void FolderTreeTest::looseFilesAreGroupedTogether() {
  const QTemporaryDir folder;
  writeMeshes(folder, {"aorta", "left_renal_artery", "femur", "tibia"});
  const auto imported =
      importInputs(std::array{path(folder, "femur.ply"), path(folder, "aorta.ply"),
                              path(folder, "tibia.ply"), path(folder, "left_renal_artery.ply")},
                   {});
  QVERIFY(imported.ok());
  QCOMPARE(tree(imported->scene), (QStringList{"Bones > femur", "Bones > tibia", "Arteries > aorta",
                                               "Arteries > left renal artery"}));
}

void FolderTreeTest::severalInputsAreWrapped() {
  const QTemporaryDir folder;
  writeMeshes(folder, {"one/aorta", "one/liver", "two/femur", "two/tibia"});
  const auto imported = importInputs(std::array{path(folder, "one/"), path(folder, "two")}, {});
  QVERIFY(imported.ok());
  QCOMPARE(tree(imported->scene),
           (QStringList{"one > aorta", "one > liver", "two > femur", "two > tibia"}));
}

void FolderTreeTest::duplicateNames() {
  const QTemporaryDir folder;
  writeMeshes(folder, {"a/liver", "b/liver", "b/Liver_"});
  const auto imported = importInputs(std::array{path(folder)}, {});
  QVERIFY(imported.ok());
  QCOMPARE(tree(imported->scene), (QStringList{"a > liver", "b > liver 2", "b > Liver 3"}));
}

void FolderTreeTest::otherFilesAreIgnored() {
  const QTemporaryDir folder;
  writeMeshes(folder, {"liver"});
  test::writeText(folder.filePath("README.txt"), "hello");
  test::writeText(folder.filePath("slices.jpg"), "JFIF");
  const auto imported = importInputs(std::array{path(folder)}, {});
  QVERIFY(imported.ok());
  QVERIFY(imported->report.warnings.empty());
  QCOMPARE(imported->scene.nodes().size(), std::size_t(1));
}

SLINE_TEST(FolderTreeTest)
#include "test_folder_tree.moc"
