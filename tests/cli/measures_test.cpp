// SPDX-License-Identifier: Apache-2.0
// Tests `sline ramp` and `sline steadiness` on small shapes.
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/sline_process.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

class MeasuresTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void rampJsonHasItsShape();
  void rampMeasuresWhatItDraws();
  void rampTextAndSheet();
  void rampOfSeveralStructures();
  void checkTellsByTheExitCode();
  void steadinessJsonHasItsShape();
  void refusals_data();
  void refusals();

 private:
  QString path(const QString& name) const { return m_folder.filePath(name); }
  QJsonObject json(const QStringList& arguments);
  QTemporaryDir m_folder;
  QString m_vessels;
};

namespace {
const QStringList small{"--size", "160x120"};

QJsonObject firstOf(const QJsonObject& root) {
  return root["structures"][0].toObject();
}
}  // namespace

void MeasuresTest::initTestCase() {
  m_vessels = writeSample(m_folder.path()) + "/Vessels";
  writeObj(path("ring.obj"), *torus(40.0f, 15.0f, 96, 40));
  writeFile(path("slanted.json"),
            R"({"eye":[0,-300,250],"target":[0,0,0],"up":[0,0,1],"fovy_deg":30})");
  writeFile(path("away.json"), R"({"eye":[0,-300,0],"target":[0,-600,0],"up":[0,0,1]})");
}

QJsonObject MeasuresTest::json(const QStringList& arguments) {
  const Finished finished = runSline(arguments + QStringList{"--json"} + small);
  if (finished.code != 0 || !finished.err.isEmpty())
    qWarning("%d: %s", finished.code, finished.err.constData());
  return QJsonDocument::fromJson(finished.out).object();
}

void MeasuresTest::rampJsonHasItsShape() {
  const QJsonObject root = json({"ramp", path("ring.obj")});
  QCOMPARE(root.keys(), QStringList({"passes", "structures"}));
  QVERIFY(root["passes"].isBool());
  QCOMPARE(root["structures"].toArray().size(), 1);
  const QJsonObject ramp = firstOf(root);
  QCOMPARE(ramp.keys(), QStringList({"area", "faults", "fill", "group", "luminance", "name",
                                     "pixels", "stages", "steps", "tone"}));
  QCOMPARE(ramp["name"].toString(), QString("ring"));
  QCOMPARE(ramp["steps"].toArray().size(), 100);
  QCOMPARE(ramp["luminance"].toArray().size(), 101);
  QCOMPARE(ramp["stages"].toArray().size(), 5);
  for (const QJsonValue& stage : ramp["stages"].toArray()) {
    QCOMPARE(stage.toObject().keys(),
             QStringList({"dead", "end_to_end", "exempt", "from", "jumps", "largest", "largest_at",
                          "mean", "stalls", "timing", "to", "weakest", "weakest_at", "whole"}));
    QCOMPARE(stage["timing"].toArray().size(), 9);
  }
  QCOMPARE(root["passes"].toBool(), ramp["faults"].toArray().isEmpty());
}

void MeasuresTest::rampMeasuresWhatItDraws() {
  // A ring seen slanted: its hole hides a contour, its tube has suggestive contours, its fill
  // closes.
  const QJsonObject ramp =
      firstOf(json({"ramp", path("ring.obj"), "--camera", path("slanted.json")}));
  const auto stage = [&](int s) { return ramp["stages"][s].toObject(); };
  for (const int s : {3, 4})
    QVERIFY2(stage(s)["whole"].toDouble() > 0.02, qPrintable(QString::number(s)));
  double sum = 0.0;
  for (const QJsonValue& step : ramp["steps"].toArray())
    sum += step.toDouble();
  double stages = 0.0;
  for (int s = 0; s < 5; ++s) {
    stages += stage(s)["whole"].toDouble();
    QVERIFY(stage(s)["end_to_end"].toDouble() <= stage(s)["whole"].toDouble() + 1e-6);
  }
  QVERIFY(std::abs(sum - stages) < 1e-5);
  // White paper with a few lines is lighter than a shaded surface; that is filled everywhere.
  const QJsonArray luminance = ramp["luminance"].toArray();
  QVERIFY(luminance[0].toDouble() > 0.9);
  QVERIFY(luminance[100].toDouble() < 0.8);
  QCOMPARE(ramp["fill"]["open_at_5"].toDouble(), 0.0);
  QVERIFY(ramp["pixels"].toInt() > 1000 && ramp["pixels"].toInt() < 160 * 120);
}

void MeasuresTest::rampTextAndSheet() {
  const Finished finished =
      runSline(QStringList{"ramp", path("ring.obj"), "--sheet", path("sheet.png")} + small);
  QCOMPARE(finished.code, 0);
  QVERIFY(finished.err.isEmpty());
  for (const char* part : {"ring", "0–1", "4–5", "tone", "fill"})
    QVERIFY2(finished.out.contains(part), part);
  const Pixels sheet = readPicture(path("sheet.png"));
  QVERIFY(sheet.width >= 6 * 160);
  QVERIFY(sheet.height >= 2 * 120);
}

void MeasuresTest::rampOfSeveralStructures() {
  const QJsonObject vessels =
      json({"ramp", m_vessels, "--structure", "renal vein", "--structure", "renal artery"});
  QCOMPARE(vessels["structures"].toArray().size(), 2);
  QCOMPARE(vessels["structures"][0]["name"].toString(), QString("renal vein"));
  // A structure is drawn as if it were alone: the other one changes nothing.
  const QJsonObject artery = json({"ramp", m_vessels + "/renal artery.obj"});
  QCOMPARE(vessels["structures"][1]["steps"].toArray(), firstOf(artery)["steps"].toArray());
  const QJsonObject all = json({"ramp", m_vessels, "--all"});
  QCOMPARE(all["structures"].toArray().size(), 2);
}

void MeasuresTest::checkTellsByTheExitCode() {
  for (const QString command : {"ramp", "steadiness"}) {
    const QStringList arguments =
        QStringList{command, path("ring.obj"), "--json", "--camera", path("slanted.json")} + small;
    const Finished plain = runSline(arguments);
    QCOMPARE(plain.code, 0);
    const bool passes = QJsonDocument::fromJson(plain.out).object()["passes"].toBool();
    const Finished checked = runSline(arguments + QStringList{"--check"});
    QCOMPARE(checked.code, passes ? 0 : 1);
    QCOMPARE(checked.out, plain.out);
  }
}

void MeasuresTest::steadinessJsonHasItsShape() {
  const QJsonObject root = json({"steadiness", path("ring.obj"), "--frames", "2"});
  QCOMPARE(root.keys(), QStringList({"passes", "structures"}));
  const QJsonObject structure = firstOf(root);
  QCOMPARE(structure.keys(), QStringList({"as_printed", "faults", "group", "name", "ratio",
                                          "ratio_over_hatching", "ratio_per_ink", "strokes"}));
  for (const char* way : {"strokes", "as_printed"}) {
    const QJsonObject flicker = structure[way].toObject();
    QCOMPARE(flicker.keys(), QStringList({"hatched_share", "ink", "mid_tones", "mid_tones_in_print",
                                          "over_hatching", "over_surface"}));
    QVERIFY(flicker["over_surface"].toDouble() >= 0.0);
    QVERIFY(flicker["over_hatching"].toDouble() >= flicker["over_surface"].toDouble());
  }
  // At Γ = 1 there is no hatching, whatever its method.
  const QJsonObject drawing =
      firstOf(json({"steadiness", path("ring.obj"), "--frames", "1", "--gamma", "1"}));
  QCOMPARE(drawing["strokes"]["hatched_share"].toDouble(), 0.0);
  QVERIFY(drawing["ratio"].isNull());
}

void MeasuresTest::refusals_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<int>("code");
  QTest::addColumn<QByteArray>("says");
  QTest::newRow("which structure")
      << QStringList{"ramp", m_vessels} << 2 << QByteArray("2 structures");
  QTest::newRow("unknown structure") << QStringList{"ramp", m_vessels, "--structure", "renal vain"}
                                     << 2 << QByteArray("renal vein");
  QTest::newRow("unknown view") << QStringList{"ramp", path("ring.obj"), "--view", "sideways"} << 2
                                << QByteArray("anterior");
  QTest::newRow("no such file") << QStringList{"ramp", path("absent.obj")} << 1
                                << QByteArray("absent.obj");
  QTest::newRow("bad size") << QStringList{"ramp", path("ring.obj"), "--size", "12"} << 2
                            << QByteArray("12");
  QTest::newRow("bad sheet") << QStringList{"ramp", path("ring.obj"), "--sheet", "sheet.bmp"} << 2
                             << QByteArray("bmp");
  QTest::newRow("nothing in sight")
      << QStringList{"ramp", path("ring.obj"), "--camera", path("away.json")} << 1
      << QByteArray("covers no pixel");
  QTest::newRow("nothing turns in sight")
      << QStringList{"steadiness", path("ring.obj"), "--camera", path("away.json")} << 1
      << QByteArray("no surface in common");
  QTest::newRow("bad gamma") << QStringList{"steadiness", path("ring.obj"), "--gamma", "7"} << 2
                             << QByteArray("7");
  QTest::newRow("bad frames") << QStringList{"steadiness", path("ring.obj"), "--frames", "0"} << 2
                              << QByteArray("frames");
}

void MeasuresTest::refusals() {
  QFETCH(QStringList, arguments);
  QFETCH(int, code);
  QFETCH(QByteArray, says);
  if (!arguments.contains("--size"))
    arguments += small;
  const Finished finished = runSline(arguments);
  QCOMPARE(finished.code, code);
  QVERIFY2(finished.err.contains(says), finished.err.constData());
  QVERIFY(finished.out.isEmpty());
}

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::MeasuresTest)
#include "measures_test.moc"
