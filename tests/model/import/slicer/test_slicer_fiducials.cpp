// SPDX-License-Identifier: Apache-2.0
// Tests fiducials of 3D Slicer: in scenes, in tables and in files of markups.
#include <QtTest>

#include "model/import/slicer/fiducials.h"
#include "tests/model/import/slicer/slicer_folder.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

class SlicerFiducialsTest : public QObject {
  Q_OBJECT
 private slots:
  void fiducialsOfAScene();
  void tables_data();
  void tables();
  void markups_data();
  void markups();
  void sceneWithMarkupsBeside();
};

void SlicerFiducialsTest::fiducialsOfAScene() {
  const SlicerFolder folder;
  folder.write("s.mrml",
               "<MRML version=\"Slicer4\">" + fiducial("1") +
                   "<LinearTransform id=\"T\" matrixTransformToParent=\"1 0 0 100 0 1 0 0 0 0 1 0 "
                   "0 0 0 1\"/><AnnotationRuler id=\"R\" name=\"width\" transformNodeRef=\"T\" "
                   "ctrlPtsCoord=\"1 2 3|4 5 6\" ctrlPtsSelected=\"0 0\"/>"
                   "<AnnotationRuler id=\"R2\" name=\"cut\" ctrlPtsCoord=\"1 2 3\"/>"
                   "<AnnotationROI id=\"R3\"/></MRML>");
  const auto imported = folder.import("s.mrml");
  QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
  const auto& annotations = imported->scene.annotations();
  QCOMPARE(annotations.size(), std::size_t(2));
  QCOMPARE(annotations[0].text, std::string("tip"));
  QVERIFY(annotations[0].kind == AnnotationKind::pin && annotations[0].locked);
  QVERIFY(near(std::get<glm::vec3>(annotations[0].anchors[0]), {-10, 20, 30}));
  QCOMPARE(annotations[0].colour, std::optional(Colour{255, 255, 0}));
  QVERIFY(annotations[1].kind == AnnotationKind::distance);
  QVERIFY(near(std::get<glm::vec3>(annotations[1].anchors[0]), {-101, -2, 3}));
  QVERIFY(near(std::get<glm::vec3>(annotations[1].anchors[1]), {-104, -5, 6}));
  const QString warnings = test::warningsOf(*imported);
  QVERIFY2(warnings.contains("\"cut\" has no place") && warnings.contains("AnnotationROI"),
           qPrintable(warnings));
}

void SlicerFiducialsTest::tables_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("expected");  // "text x y z visible locked", or part of the error
  const auto row = [](const char* tag, const char* text, const char* expected) {
    QTest::newRow(tag) << QByteArray(text) << QString(expected);
  };
  const QByteArray four("# Markups fiducial file version = 4.11\n# CoordinateSystem = ");
  const QByteArray columns(
      "\n# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n");
  row("Slicer 3", "# columns = label,x,y,z,sel,vis\na,1,2.5,-3e1,1,1\n", "a -1 -2.5 -30 1 0");
  row("without columns", "a,1,2,3,1,0\r\n", "a -1 -2 3 0 0");
  row("all hidden", "# visibility = 0\na,1,2,3,1,1\n", "a -1 -2 3 0 0");
  row("locked list", "# locked = 1\na,1,2,3,1,1\n", "a -1 -2 3 1 1");
  for (const char* ras : {"0", "RAS"})
    QTest::newRow(ras) << four + ras + columns + "i,1,2,3,0,0,0,1,1,1,0,F-1,,\n"
                       << "F-1 -1 -2 3 1 0";
  for (const char* lps : {"1", "LPS"})
    QTest::newRow(lps) << four + lps + columns + "i,1,2,3,0,0,0,1,1,1,1,F-1,,\n"
                       << "F-1 1 2 3 1 1";
  QTest::newRow("quoted") << four + "1" + columns + "i,1,2,3,0,0,0,1,1,1,0,\"a, \"\"b\"\"\",text,\n"
                          << "a, \"b\" 1 2 3 1 0";
  QTest::newRow("voxels") << four + "2" + columns << "line 2: the coordinate system '2'";
  row("cut", "a,1,2\n", "line 1: z is missing");
  row("no number", "# name = x\n\na,1,2,drei,1,1\n", "line 3: z is no number: 'drei'");
  row("a decimal comma", "a,1,5,2,3,1,1\n", "a -1 -5 2 1 0");
  row("not finite", "a,1,2,inf,1,1\n", "line 1: z is no number");
  row("a picture", "\x89PNG\r\n", "line 1: x is missing");
  row("nothing", "", "empty");
}

void SlicerFiducialsTest::tables() {
  QFETCH(QByteArray, text);
  QFETCH(QString, expected);
  const QTemporaryDir folder;
  const QString path = folder.filePath("points.FCSV");
  test::writeText(path, text);
  const auto read = readFiducials(path.toStdString(), {});
  if (!read.ok()) {
    QVERIFY2(QString::fromStdString(read.error().text()).contains(expected),
             read.error().text().c_str());
    return;
  }
  QCOMPARE(read->items.size(), std::size_t(1));
  const Annotation annotation = annotationOf(read->items[0]);
  const glm::vec3 p = std::get<glm::vec3>(annotation.anchors[0]);
  QCOMPARE(QString("%1 %2 %3 %4 %5 %6")
               .arg(QString::fromStdString(annotation.text))
               .arg(p.x)
               .arg(p.y)
               .arg(p.z)
               .arg(int(annotation.visible))
               .arg(int(annotation.locked)),
           expected);
}

void SlicerFiducialsTest::markups_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("expected");
  const auto row = [](const char* tag, const QByteArray& markup, const char* expected) {
    QTest::newRow(tag) << "{\"markups\":[" + markup + "]}" << QString(expected);
  };
  const auto points = [](const char* type, const char* more, const char* list) {
    return QByteArray("{\"type\":\"") + type + "\"," + more + "\"controlPoints\":[" + list + "]}";
  };
  const char* const one = "{\"label\":\"F-1\",\"position\":[1,2.5,-3]}";
  row("LPS is what is not said", points("Fiducial", "", one), "pin F-1 1 2.5 -3 1");
  row("LPS", points("Fiducial", "\"coordinateSystem\":\"LPS\",", one), "pin F-1 1 2.5 -3 1");
  row("RAS", points("Fiducial", "\"coordinateSystem\":\"RAS\",", one), "pin F-1 -1 -2.5 -3 1");
  row("metres", points("Fiducial", "\"coordinateUnits\":\"m\",", one), "pin F-1 1000 2500 -3000 1");
  row("coded", points("Fiducial", "\"coordinateUnits\":[\"mm\",\"UCUM\",\"millimeter\"],", one),
      "pin F-1 1 2.5 -3 1");
  row("hidden", points("Fiducial", "\"display\":{\"visibility\":false},", one),
      "pin F-1 1 2.5 -3 0");
  row("not yet set",
      points("Fiducial", "", "{\"positionStatus\":\"undefined\",\"position\":[0,0,0]}"), "");
  row("a line", points("Line", "", "{\"position\":[1,2,3]},{\"position\":[4,5,6]}"),
      "distance points 1 2 3 4 5 6 1");
  row("half a line", points("Line", "", "{\"position\":[1,2,3]}"), "");
  row("a curve", points("Curve", "", one), "");
  row("voxels", points("Fiducial", "\"coordinateSystem\":\"IJK\",", one),
      "markups[0].coordinateSystem: the coordinate system is neither");
  row("parsecs", points("Fiducial", "\"coordinateUnits\":\"pc\",", one), "none of mm");
  row("two coordinates", points("Fiducial", "", "{\"position\":[1,2]}"),
      "markups[0].controlPoints[0].position: ");
  row("no type", "{}", "\"type\" is missing");
  QTest::newRow("another JSON") << QByteArray("{\"asset\":{}}") << "\"markups\" is missing";
  QTest::newRow("no JSON") << QByteArray("solid x") << "Save the markups again";
}

void SlicerFiducialsTest::markups() {
  QFETCH(QByteArray, text);
  QFETCH(QString, expected);
  const QTemporaryDir folder;
  const QString path = folder.filePath("points.mrk.json");
  test::writeText(path, text);
  const auto read = readFiducials(path.toStdString(), {});
  if (!read.ok()) {
    QVERIFY2(QString::fromStdString(read.error().text()).contains(expected) && !expected.isEmpty(),
             read.error().text().c_str());
    return;
  }
  QStringList told;
  for (const Fiducial& fiducial : read->items) {
    const Annotation annotation = annotationOf(fiducial);
    told << (annotation.kind == AnnotationKind::pin ? "pin" : "distance")
         << QString::fromStdString(annotation.text);
    for (const Anchor& anchor : annotation.anchors)
      for (int axis = 0; axis < 3; ++axis)
        told << QString::number(std::get<glm::vec3>(anchor)[axis]);
    told << QString::number(int(annotation.visible));
  }
  QCOMPARE(told.join(' '), expected);
}

void SlicerFiducialsTest::sceneWithMarkupsBeside() {
  const SlicerFolder folder;
  folder.write("Data/F 1.mrk.json",
               "{\"markups\":[{\"type\":\"Fiducial\",\"coordinateSystem\":\"LPS\","
               "\"controlPoints\":[{\"label\":\"hilum\",\"position\":[1,2,3]}]}]}");
  folder.write("s.mrml",
               "<MRML version=\"Slicer 5.2.2\"><MarkupsFiducial id=\"F\" name=\"points\" "
               "locked=\"1\" references=\"display:D;storage:S;\"/>"
               "<MarkupsFiducialDisplay id=\"D\" color=\"0 0 1\" selectedColor=\"0 1 0\" "
               "visibility=\"false\"/>"
               "<MarkupsFiducialStorage id=\"S\" fileName=\"Data/F%201.mrk.json\"/>"
               "<MarkupsFiducial id=\"F2\" references=\"storage:S2;\"/>"
               "<MarkupsFiducialStorage id=\"S2\" fileName=\"../away.fcsv\"/></MRML>");
  const auto imported = folder.import("s.mrml");
  QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
  QCOMPARE(imported->scene.annotations().size(), std::size_t(1));
  const Annotation& annotation = imported->scene.annotations()[0];
  QCOMPARE(annotation.text, std::string("hilum"));
  QVERIFY(near(std::get<glm::vec3>(annotation.anchors[0]), {1, 2, 3}));
  QVERIFY(annotation.locked && !annotation.visible);
  QCOMPARE(annotation.colour, std::optional(Colour{0, 255, 0}));
  QVERIFY(test::warningsOf(*imported).contains("outside its folder"));
}

SLINE_TEST(SlicerFiducialsTest)
#include "test_slicer_fiducials.moc"
