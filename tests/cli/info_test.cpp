// SPDX-License-Identifier: Apache-2.0
#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/sline_process.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {
namespace {

QJsonObject info(const QStringList& arguments) {
  const Finished finished = runSline(QStringList{"info", "--json"} + arguments);
  return finished.code == 0 ? QJsonDocument::fromJson(finished.out).object() : QJsonObject();
}

QJsonObject structureNamed(const QJsonObject& root, const QString& name) {
  for (const QJsonValue& structure : root["structures"].toArray())
    if (structure["name"].toString().compare(name, Qt::CaseInsensitive) == 0)
      return structure.toObject();
  return {};
}

bool isBox(const QJsonValue& value) {
  const QJsonArray box = value.toArray();
  return box.size() == 2 && box[0].toArray().size() == 3 && box[1].toArray().size() == 3;
}

}  // namespace

class InfoTest : public QObject {
  Q_OBJECT

 private slots:
  void jsonHasItsShape();
  void frameTurnsCoordinates_data();
  void frameTurnsCoordinates();
  void doubtIsTold();
  void openAndPartedMeshes();
  void warningsAreListed();
  void tableNamesStructures();
  void placesAreWrittenOut();
  void namesCannotCommandATerminal();
  void scans();
  void abdomen();
};

/// Scans are listed as they are, and as structures by thresholds; a scene keeps them only on
/// request.
void InfoTest::scans() {
  const QTemporaryDir folder;
  const QString ct = folder.filePath("ct.mha");
  QByteArray text =
      "ObjectType = Image\nNDims = 3\nBinaryData = False\nDimSize = 12 12 12\n"
      "ElementSpacing = 2 2 3\nElementType = MET_SHORT\nElementDataFile = LOCAL\n";
  for (int i = 0; i < 12 * 12 * 12; ++i) {
    const int x = i % 12 - 6;
    const int y = i / 12 % 12 - 6;
    const int z = i / 144 - 6;
    text += QByteArray::number(x * x + y * y + z * z < 16 ? 700 : -1000 - i % 7) + ' ';
  }
  writeFile(ct, text);
  const QJsonObject root = info({ct});
  const QJsonObject scan = root["scans"][0].toObject();
  QCOMPARE(scan["size"].toArray(), QJsonArray({12, 12, 12}));
  QCOMPARE(scan["spacing_mm"].toArray(), QJsonArray({2.0, 2.0, 3.0}));
  QCOMPARE(scan["intensities"].toArray(), QJsonArray({-1006.0, 700.0}));
  QCOMPARE(scan["hounsfield"], QJsonValue(true));
  QVERIFY(root["structures"].toArray().isEmpty());
  QVERIFY(runSline({"info", ct}).out.contains("intensities -1006 to 700 HU"));
  const QString scene = folder.filePath("ct.sline");
  const Finished without = runSline({"import", ct, "-o", scene});
  QCOMPARE(without.code, 1);
  QVERIFY(without.err.contains("--threshold NAME=VALUE"));
  QCOMPARE(runSline({"import", ct, "-o", scene, "--threshold", "bone"}).code, 0);
  QVERIFY(!structureNamed(info({scene}), "bone").isEmpty());
  QVERIFY(info({scene})["scans"].toArray().isEmpty());
  const Finished kept =
      runSline({"import", ct, "-o", scene, "--threshold", "core=500..900", "--keep-volume"});
  QCOMPARE(kept.code, 0);
  QVERIFY(kept.err.contains("MB"));
  QVERIFY(!structureNamed(info({scene}), "core").isEmpty());
  QCOMPARE(info({scene})["scans"][0]["name"].toString(), QString("CT"));
  QCOMPARE(runSline({"import", ct, "-o", scene, "--threshold", "liver"}).code, 2);
}

void InfoTest::jsonHasItsShape() {
  const QTemporaryDir folder;
  const QJsonObject root = info({writeSample(folder.path())});
  QStringList keys = root.keys();
  keys.sort();
  QCOMPARE(keys,
           QStringList({"annotations", "bounds_mm", "frame", "frame_reason", "front",
                        "on_other_side", "read_as", "scans", "sides", "structures", "triangles",
                        "unit", "unit_doubted", "up", "vertices", "views", "warnings"}));
  QCOMPARE(root["structures"].toArray().size(), 3);
  QCOMPARE(root["triangles"].toInt(), 5120 + 2 * 1280);
  QCOMPARE(root["vertices"].toInt(), 2562 + 2 * 642);
  QCOMPARE(root["frame"].toString(), QString("LPS"));
  QVERIFY(isBox(root["bounds_mm"]));
  QCOMPARE(root["bounds_mm"][1][0].toDouble(), 70.0);
  QVERIFY(root["warnings"].toArray().isEmpty());
  const QJsonObject artery = structureNamed(root, "renal artery");
  keys = artery.keys();
  keys.sort();
  QCOMPARE(keys, QStringList({"bounds_mm", "closed", "components", "frame", "front", "group",
                              "name", "read_as", "sides", "triangles", "up", "vertices"}));
  QCOMPARE(artery["group"].toString(), QString("Vessels"));
  QCOMPARE(artery["triangles"].toInt(), 1280);
  QCOMPARE(artery["vertices"].toInt(), 642);
  QCOMPARE(artery["closed"], QJsonValue(true));
  QCOMPARE(artery["components"].toInt(), 1);
  QVERIFY(isBox(artery["bounds_mm"]));
}

void InfoTest::frameTurnsCoordinates_data() {
  QTest::addColumn<QString>("frame");
  QTest::addColumn<double>("x");  // of the artery's middle
  QTest::newRow("LPS") << "LPS" << 60.0;
  QTest::newRow("RAS") << "RAS" << -60.0;
  QTest::newRow("file") << "file" << 60.0;
}

void InfoTest::frameTurnsCoordinates() {
  QFETCH(QString, frame);
  QFETCH(double, x);
  const QTemporaryDir folder;
  const QJsonObject root = info({writeSample(folder.path()), "--frame", frame});
  // The bounds are those in the scene, whatever frame the files have.
  QCOMPARE(root["frame"].toString(), frame == "file" ? frame : QString("LPS"));
  QCOMPARE(root["read_as"].toString(), frame);
  QCOMPARE(root["sides"].toString(), frame == "file" ? QString("none") : QString("settled"));
  const QJsonValue box = structureNamed(root, "renal artery")["bounds_mm"];
  QCOMPARE(0.5 * (box[0][0].toDouble() + box[1][0].toDouble()), x);
}

/// What was assumed is said to be, on standard error and for programs, until it is settled.
void InfoTest::doubtIsTold() {
  const QTemporaryDir folder;
  const QString sample = writeSample(folder.path());
  const Finished doubted = runSline({"info", sample, "--json"});
  QCOMPARE(doubted.err.count("left and right are not certain of 3 structures (LPS: no header"), 1);
  QJsonObject root = QJsonDocument::fromJson(doubted.out).object();
  QCOMPARE(root["sides"].toString(), QString("assumed"));
  QCOMPARE(structureNamed(root, "renal artery")["sides"].toString(), QString("assumed"));
  const QJsonValue before = structureNamed(root, "renal artery")["bounds_mm"];
  const Finished mirrored = runSline({"info", sample, "--json", "--sides", "mirror"});
  QCOMPARE(mirrored.err, QByteArray());
  root = QJsonDocument::fromJson(mirrored.out).object();
  QCOMPARE(root["sides"].toString(), QString("settled"));
  QCOMPARE(root["read_as"].toString(), QString("RPS"));
  const QJsonValue after = structureNamed(root, "renal artery")["bounds_mm"];
  QCOMPARE(after[0][0].toDouble(), -before[1][0].toDouble());
  QCOMPARE(after[0][1].toDouble(), before[0][1].toDouble());
  const QString scene = folder.filePath("kept.sline");
  QVERIFY(runSline({"import", sample, "-o", scene}).err.contains("not certain"));
  QVERIFY(runSline({"info", scene}).err.contains("not certain"));
  QCOMPARE(runSline({"import", scene, "-o", scene, "--sides", "right"}).err, QByteArray());
  QCOMPARE(runSline({"info", scene}).err, QByteArray());
  QCOMPARE(runSline({"info", scene, "--sides", "left"}).code, 2);
}

void InfoTest::openAndPartedMeshes() {
  const QTemporaryDir folder;
  writeObj(folder.filePath("tube.obj"), *cylinder(5.0f, 40.0f, 24, 20));
  const QJsonObject tube = structureNamed(info({folder.filePath("tube.obj")}), "tube");
  QCOMPARE(tube["closed"], QJsonValue(false));
  QCOMPARE(tube["components"].toInt(), 1);
}

void InfoTest::warningsAreListed() {
  const QTemporaryDir folder;
  writeFile(folder.filePath("broken.stl"), "solid broken\n facet normal 0 0");
  const QJsonObject root = info({writeSample(folder.path()), folder.filePath("broken.stl")});
  QCOMPARE(root["structures"].toArray().size(), 3);
  QCOMPARE(root["warnings"].toArray().size(), 1);
  const QJsonValue warning = root["warnings"][0];
  QVERIFY(warning["file"].toString().contains("broken.stl"));
  QVERIFY(!warning["reason"].toString().isEmpty());
}

void InfoTest::tableNamesStructures() {
  const QTemporaryDir folder;
  const Finished finished = runSline({"info", writeSample(folder.path()), "--sides", "right"});
  QCOMPARE(finished.code, 0);
  for (const char* text : {"kidney", "renal artery", "Vessels", "3 structures", "LPS"})
    QVERIFY2(finished.out.contains(text), finished.out.constData());
  QCOMPARE(finished.err, QByteArray());
}

void InfoTest::placesAreWrittenOut() {
  const QTemporaryDir folder;
  const QString scene = folder.filePath("scene.sline");
  QCOMPARE(runSline({"import", writeSample(folder.path()), "-o", scene}).code, 0);
  QCOMPARE(
      runSline({"annotate", scene, "--kind", "distance", "--on", "kidney", "--to", "renal artery"})
          .code,
      0);
  const QString told = QString::fromUtf8(runSline({"info", scene}).out);
  const QString place = R"(\(-?\d+\.\d, -?\d+\.\d, -?\d+\.\d\))";
  QVERIFY2(told.contains(QRegularExpression("at " + place + " to " + place)), qPrintable(told));
}

void InfoTest::namesCannotCommandATerminal() {
  const QTemporaryDir folder;
  const QString scene = folder.filePath("a.sline");
  QCOMPARE(runSline({"import", writeSample(folder.path()), "-o", scene}).code, 0);
  const QString name = "\x1b]0;evil\x07 \x1b[31mred";
  QCOMPARE(runSline({"view", scene, "--add", name}).code, 0);
  QCOMPARE(runSline({"annotate", scene, "--on", "kidney", "--label", name}).code, 0);
  for (const QStringList& arguments :
       {QStringList{"info", scene}, QStringList{"view", scene, "--list"},
        QStringList{"annotate", scene, "--list"},
        QStringList{"export", scene, "--view", "nope", "--svg", folder.filePath("a.svg")},
        QStringList{"view", scene, "--add", name}}) {
    const Finished finished = runSline(arguments);
    const QByteArray said = finished.out + finished.err;
    QVERIFY2(!said.contains('\x1b') && !said.contains('\x07'), said.constData());
    QVERIFY(said.contains("red"));
  }
}

void InfoTest::abdomen() {
  const QString scene =
      QStringLiteral(SLINE_TEST_DATA "/abdomen/AbdominalAtlas-2015Sept-Slicer4-4Version.mrml");
  if (!QFile::exists(scene))
    SLINE_ABSENT("the abdomen is not there");
  const QJsonObject root = info({scene});
  QCOMPARE(root["structures"].toArray().size(), 94);
  QVERIFY(!root["warnings"].toArray().isEmpty());  // the scene refers to files that are absent
}

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::InfoTest)
#include "info_test.moc"
