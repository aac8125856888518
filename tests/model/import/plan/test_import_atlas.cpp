// SPDX-License-Identifier: Apache-2.0
// Tests real anatomy: the abdomen's Slicer scene, its bare folder, and the two pelves.
#include <QDir>
#include <QtTest>
#include <array>
#include <map>
#include <set>

#include "model/import/naming/names.h"
#include "model/import/plan/import.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

Result<Imported> import(const QString& below, const ImportOptions& options = {}) {
  const QString whole = QString(SLINE_TEST_DATA) + "/" + below;
  return importInputs(std::array{std::filesystem::path(whole.toStdString())}, options);
}

bool absent(const QString& below) {
  return !QFileInfo::exists(QString(SLINE_TEST_DATA) + "/" + below);
}

std::size_t structures(const Scene& scene) {
  return scene.structuresBelow(rootId).size();
}

glm::vec3 centre(const Scene& scene, const std::string& name) {
  const Node& node = test::named(scene, name);
  if (!node.mesh)
    qFatal("no structure %s", name.c_str());
  return node.mesh->bounds().centre();
}

/// Returns how many left/right pairs lie on their sides in LPS, and how many there are.
std::pair<int, int> pairsOnTheirSides(const Scene& scene) {
  std::map<std::string, std::map<Side, float>> places;
  for (const Node& node : scene.nodes())
    if (node.mesh)
      if (const SidedName name = sidedName(node.name); name.side != Side::none)
        places[name.rest][name.side] = node.mesh->bounds().centre().x;
  int right = 0;
  int all = 0;
  for (auto& [name, sides] : places) {
    if (sides.size() != 2)
      continue;
    ++all;
    right += sides[Side::left] > sides[Side::right];
  }
  return {right, all};
}

constexpr const char* abdomen = "abdomen/AbdominalAtlas-2015Sept-Slicer4-4Version.mrml";

}  // namespace

class ImportAtlasTest : public QObject {
  Q_OBJECT
 private slots:
  void abdomenScene();
  void abdomenAsItIs();
  void abdomenFolderVotes();
  void pelvis();
  void pelvisInGltf();
  void largeLiver();
};

void ImportAtlasTest::abdomenScene() {
  if (absent(abdomen))
    SLINE_ABSENT("the folder of real data is absent");
  const auto imported = import(abdomen);
  QVERIFY(imported.ok());
  const Scene& scene = imported->scene;
  QCOMPARE(structures(scene), std::size_t(94));
  QCOMPARE(scene.nodes().size() - structures(scene), std::size_t(11));
  QCOMPARE(scene.groupPath(test::named(scene, "liver").id), std::string("Abdominal Organs / GI"));
  QCOMPARE(test::named(scene, "liver").style.colour, std::optional(Colour{147, 59, 0}));
  QCOMPARE(imported->report.frame, Frame::ras);
  QVERIFY(test::warningsOf(*imported).contains("I.nrrd"));
  QVERIFY(centre(scene, "liver").x < centre(scene, "aorta").x);
  QVERIFY(centre(scene, "spleen").x > centre(scene, "aorta").x);
  const auto [right, all] = pairsOnTheirSides(scene);
  QVERIFY2(all >= 20 && right == all, qPrintable(QString("%1 of %2").arg(right).arg(all)));
  for (const Node& node : scene.nodes())
    if (node.mesh)
      QVERIFY2(node.provenance.smoothingSteps > 0, node.name.c_str());
}

void ImportAtlasTest::abdomenAsItIs() {
  if (absent(abdomen))
    SLINE_ABSENT("the folder of real data is absent");
  ImportOptions options;
  options.smoothing.mode = Smoothing::Mode::off;
  const auto imported = import(abdomen, options);
  QVERIFY(imported.ok());
  std::size_t triangles = 0;
  for (const Node& node : imported->scene.nodes())
    if (node.mesh)
      triangles += node.mesh->triangleCount();
  QCOMPARE(triangles, std::size_t(1'200'358));
}

void ImportAtlasTest::abdomenFolderVotes() {
  if (absent("abdomen/Data"))
    SLINE_ABSENT("the folder of real data is absent");
  ImportOptions options;
  options.smoothing.mode = Smoothing::Mode::off;
  // The scene beside the folder would decide.
  const auto beside = import("abdomen/Data", options);
  QVERIFY(beside.ok());
  QCOMPARE(beside->report.frame, Frame::ras);
  QCOMPARE(beside->report.frameReason, std::string("scene of Slicer before 4.11"));
  // Without it the label volume does, and without that the names.
  const QTemporaryDir apart;
  const auto linked = [&](const QString& kinds) {
    const QDir data(QString(SLINE_TEST_DATA) + "/abdomen/Data");
    for (const QString& file : data.entryList({kinds}, QDir::Files))
      QFile::link(data.filePath(file), apart.filePath(file));
    return importInputs(std::array{std::filesystem::path(apart.path().toStdString())}, options);
  };
  const auto imported = linked("*.vtk");
  QVERIFY(imported.ok());
  const auto laid = linked("*");
  QVERIFY(laid.ok());
  QCOMPARE(laid->report.frame, Frame::ras);
  QVERIFY(QString::fromStdString(laid->report.frameReason).startsWith("laid over surfaces"));
  QCOMPARE(imported->report.frame, Frame::ras);
  QVERIFY(QString::fromStdString(imported->report.frameReason).startsWith("vote: "));
  QVERIFY(imported->scene.nodes().back().provenance.evidence.isSure());
  const auto [right, all] = pairsOnTheirSides(imported->scene);
  QVERIFY(all >= 20 && right == all);
  QCOMPARE(imported->scene.groupPath(test::named(imported->scene, "aorta").id),
           std::string("Arteries"));
}

void ImportAtlasTest::pelvis() {
  if (absent("pelvis/bodyparts3d"))
    SLINE_ABSENT("the folder of real data is absent");
  const auto imported = import("pelvis/bodyparts3d");
  QVERIFY(imported.ok());
  const Scene& scene = imported->scene;
  QCOMPARE(structures(scene), std::size_t(40));
  QCOMPARE(imported->report.frame, Frame::lps);
  const auto [right, all] = pairsOnTheirSides(scene);
  QVERIFY(all >= 14 && right == all);
  QCOMPARE(scene.groupPath(test::named(scene, "right hip bone").id), std::string("Skeletal"));
  for (const Node& node : scene.nodes())
    if (node.mesh) {
      QCOMPARE(node.provenance.smoothingSteps, 0);
      QVERIFY2(node.provenance.displacementMm < 1.5f, node.name.c_str());
    }
  QCOMPARE(test::named(scene, "urinary bladder").provenance.refinementSteps, 2);
}

void ImportAtlasTest::pelvisInGltf() {
  if (absent("pelvis/hra_vh_male"))
    SLINE_ABSENT("the folder of real data is absent");
  ImportOptions options;
  options.smoothing.mode = Smoothing::Mode::off;
  const auto imported = import("pelvis/hra_vh_male", options);
  QVERIFY(imported.ok());
  const Scene& scene = imported->scene;
  QCOMPARE(structures(scene), std::size_t(75));
  QVERIFY(centre(scene, "ascending colon").x < centre(scene, "descending colon").x);
  const auto [right, all] = pairsOnTheirSides(scene);
  // One pair of the collection itself is named the wrong way round.
  QVERIFY2(all >= 20 && right >= all - 1, qPrintable(QString("%1 of %2").arg(right).arg(all)));
  // The scene is in millimetres, head up, the sacrum behind the bladder.
  QVERIFY(scene.visibleBounds().size().z > 200.0f && scene.visibleBounds().size().z < 600.0f);
  QVERIFY(centre(scene, "sacrum").y > centre(scene, "trigone of urinary bladder").y);
  QVERIFY(centre(scene, "transverse colon").z > centre(scene, "rectum").z);
}

void ImportAtlasTest::largeLiver() {
  if (absent("large"))
    SLINE_ABSENT("the folder of real data is absent");
  const auto imported = import("large");
  QVERIFY(imported.ok());
  const Node& node = imported->scene.nodes().front();
  QCOMPARE(node.mesh->triangleCount(), std::size_t(1'074'432));
  QCOMPARE(node.provenance.smoothingSteps + node.provenance.refinementSteps, 0);
}

SLINE_TEST(ImportAtlasTest)
#include "test_import_atlas.moc"
