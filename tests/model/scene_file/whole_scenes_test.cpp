// SPDX-License-Identifier: Apache-2.0
// Tests scenes of full size through the scene file: one of the data's and those the program models.
#include <QFileInfo>
#include <QtTest>
#include <array>

#include "model/demo/demo.h"
#include "model/import/plan/import.h"
#include "model/scene_file/scene_file.h"
#include "tests/model/scene_file/sample_scene.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

class WholeScenesTest : public QObject {
  Q_OBJECT
 private slots:
  void demos_data();
  void demos();
  void atlas();

 private:
  static void roundsOf(const Scene& scene);
};

/// Saves and opens twenty times: the bytes and the scene stay the same, with no more than 16 bytes
/// per triangle.
void WholeScenesTest::roundsOf(const Scene& scene) {
  const auto first = sceneFileBytes({.scene = scene});
  QVERIFY(first.ok());
  std::size_t triangles = 0;
  for (const Node& node : scene.nodes())
    triangles += node.isGroup() ? 0 : node.mesh->triangleCount();
  const double each = double(first->size()) / double(triangles);
  qInfo("%zu triangles, %.2f bytes each", triangles, each);
  QVERIFY(each < 16.0);
  std::string bytes = *first;
  for (int round = 0; round < 20; ++round) {
    const auto document = documentFromBytes(bytes);
    QVERIFY2(document.ok(), document.ok() ? "" : document.error().text().c_str());
    if (round == 0)
      QCOMPARE(test::difference(document->scene, scene), std::string());
    auto again = sceneFileBytes(*document);
    QVERIFY(again.ok() && *again == *first);
    bytes = std::move(*again);
  }
}

void WholeScenesTest::demos_data() {
  QTest::addColumn<int>("name");
  QTest::addColumn<int>("sex");
  for (std::size_t i = 0; i < demoNames.size(); ++i)
    QTest::newRow(std::string(demoNames[i]).c_str()) << int(i) << int(Sex::female);
}

void WholeScenesTest::demos() {
  QFETCH(int, name);
  QFETCH(int, sex);
  roundsOf(demo(DemoName(name), Sex(sex), {}));
}

void WholeScenesTest::atlas() {
  const QString file =
      QString(SLINE_TEST_DATA) + "/abdomen/AbdominalAtlas-2015Sept-Slicer4-4Version.mrml";
  if (!QFileInfo::exists(file))
    SLINE_ABSENT("no abdomen scene among the test data");
  const auto imported = importInputs(std::array{std::filesystem::path(file.toStdString())}, {});
  QVERIFY(imported.ok());
  roundsOf(imported->scene);
}

SLINE_TEST(WholeScenesTest)
#include "whole_scenes_test.moc"
