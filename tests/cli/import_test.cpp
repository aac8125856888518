// SPDX-License-Identifier: Apache-2.0
#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <optional>

#include "tests/cli/sline_process.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {
namespace {

QByteArray contentOf(const QString& name) {
  QFile file(name);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QJsonObject objectOf(const QStringList& arguments) {
  const Finished finished = runSline(arguments);
  return finished.code == 0 ? QJsonDocument::fromJson(finished.out).object() : QJsonObject();
}

/// Runs a shell's script with a disk of that many bytes at /mnt, which no other process sees.
/// Returns nothing if the system does not grant that.
std::optional<Finished> runWithSmallDisk(qint64 bytes, const QString& script,
                                         const QStringList& arguments) {
  QProcess process;
  process.start("unshare", QStringList{"--map-root-user", "--mount", "sh", "-c",
                                       "mount -t tmpfs -o size=" + QString::number(bytes) +
                                           " none /mnt || exit 77\n" + script,
                                       "sh"} +
                               arguments);
  if (!process.waitForStarted() || !process.waitForFinished(120000) ||
      process.exitStatus() != QProcess::NormalExit)
    return std::nullopt;
  Finished finished{process.exitCode(), process.readAllStandardOutput(),
                    process.readAllStandardError()};
  const bool granted = finished.code != 77 && !finished.err.contains("unshare");
  return granted ? std::optional(finished) : std::nullopt;
}
}  // namespace

class ImportTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void holdsWhatTheInputsHold();
  void everyCommandTakesIt_data();
  void everyCommandTakesIt();
  void savedAgainIsTheSame();
  void planAsText();
  void planAsJson();
  void wrongUse_data();
  void wrongUse();
  void brokenFileIsNamed();
  void diskTroubles_data();
  void diskTroubles();
  void fewerTriangles();
  void patientsStayApart();
  void savedScenesKnowTheirPatient();
  void unitsAreAskedAbout();

 private:
  QString at(const QString& name) const { return m_folder.filePath(name); }
  QTemporaryDir m_folder;
  QString m_meshes;
  QString m_scene;
};

namespace {
QByteArray cornerOf(int size) {
  const QByteArray s = QByteArray::number(size);
  return "v 0 0 0\nv " + s + " 0 0\nv 0 " + s + " 0\nv 0 0 " + s +
         "\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
}
}  // namespace

void ImportTest::patientsStayApart() {
  const QStringList inputs{at("sub-01_liver.obj"), at("sub-02_spleen.obj")};
  for (const QString& input : inputs)
    writeFile(input, cornerOf(150));
  for (const QString& command : QStringList{"info", "render", "import", "describe"}) {
    const QString out = at(command == "import" ? "two.sline" : "two.png");
    QStringList arguments = QStringList{command} + inputs;
    if (command == "render" || command == "import")
      arguments += {"-o", out};
    const Finished refused = runSline(arguments);
    QCOMPARE(refused.code, 1);
    for (const QByteArray& part : {QByteArray("sub-01_liver.obj"), QByteArray("sub-02_spleen.obj"),
                                   QByteArray("2 patients"), QByteArray("--together")})
      QVERIFY2(refused.err.contains(part), refused.err.constData());
    QVERIFY(!arguments.contains(out) || !QFile::exists(out));
    QCOMPARE(runSline(arguments + QStringList{"--together"}).code, 0);
  }
}

void ImportTest::savedScenesKnowTheirPatient() {
  const auto mask = [](const char* study) {
    QByteArray text =
        "NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\nsizes: 6 6 6\n"
        "space directions: (9,0,0) (0,9,0) (0,0,9)\nspace origin: (0,0,0)\nencoding: ascii\n";
    text += QByteArray("0020|000d:=") + study + "\n\n";
    for (int i = 0; i < 216; ++i) {
      const auto inside = [](int k) { return k > 0 && k < 5; };
      text += inside(i % 6) && inside(i / 6 % 6) && inside(i / 36) ? "1 " : "0 ";
    }
    return text;
  };
  writeFile(at("first.nrrd"), mask("1.2.3"));
  writeFile(at("same.nrrd"), mask("1.2.3"));
  writeFile(at("other.nrrd"), mask("1.2.9"));
  const QString saved = at("first.sline");
  QCOMPARE(runSline({"import", at("first.nrrd"), "-o", saved}).code, 0);
  const QStringList out{"-o", at("both.sline")};
  QCOMPARE(runSline(QStringList{"import", saved, at("same.nrrd")} + out).code, 0);
  const QStringList other = QStringList{"import", saved, at("other.nrrd")} + out;
  const Finished refused = runSline(other);
  QCOMPARE(refused.code, 1);
  for (const char* part : {"first.sline", "other.nrrd", "--together"})
    QVERIFY2(refused.err.contains(part), refused.err.constData());
  QCOMPARE(runSline(other + QStringList{"--together"}).code, 0);
}

void ImportTest::unitsAreAskedAbout() {
  const QString kidney = at("left kidney.obj");
  writeFile(kidney, cornerOf(10));
  const QString out = at("kidney.sline");
  const Finished asked = runSline({"import", kidney, "-o", out});
  QCOMPARE(asked.code, 0);
  for (const QByteArray& part : {QByteArray("\"left kidney\" is 10 mm large"),
                                 QByteArray("--unit cm"), QByteArray("--unit mm")})
    QVERIFY2(asked.err.contains(part), asked.err.constData());
  const Finished later = runSline({"info", out});
  QVERIFY2(later.out.contains("10 mm?") && later.err.contains("stand with a"),
           later.out.constData());
  // Small sizes are told in a unit that shows them.
  const QString cell = at("cell.obj");
  writeFile(cell,
            "v 0 0 0\nv 0.05 0 0\nv 0 0.04 0\nv 0 0 0.0125\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  for (const QStringList& command :
       {QStringList{"info", cell}, QStringList{"import", cell, "--plan"}}) {
    const QByteArray told = runSline(command).out;
    QVERIFY2(told.contains("50 × 40 × 12.5 µm"), told.constData());
  }
  const QJsonObject plan = objectOf({"import", kidney, "--plan", "--json"});
  QCOMPARE(plan["unit_doubts"][0]["fitting_mm_per_unit"][0].toDouble(), 10.0);
  for (const QString& unit : QStringList{"cm", "mm", "10", "um", "0.5"}) {
    const Finished settled = runSline({"import", kidney, "-o", out, "--unit", unit});
    QCOMPARE(settled.code, 0);
    QVERIFY2(!settled.err.contains("--unit"), settled.err.constData());
  }
  for (const QString& unit : QStringList{"0", "-1", "nan", "inf"})
    QCOMPARE(runSline({"import", kidney, "-o", out, "--unit", unit}).code, 2);
}

void ImportTest::initTestCase() {
  m_meshes = writeSample(at("meshes"));
  m_scene = at("sample.sline");
  const Finished finished = runSline({"import", m_meshes, "-o", m_scene, "--smooth", "off"});
  QVERIFY2(finished.code == 0, finished.err.constData());
  writeFile(at("camera.json"), frontCamera());
}

void ImportTest::holdsWhatTheInputsHold() {
  const QJsonObject meshes = objectOf({"info", "--json", m_meshes});
  QVERIFY(!meshes.isEmpty());
  QCOMPARE(objectOf({"info", "--json", m_scene}), meshes);
  QVERIFY(contentOf(m_scene).contains("thumbnail.png"));
  // The file holds its data: the meshes may go.
  QTemporaryDir other;
  const QString copy = other.filePath("copy.sline");
  QVERIFY(QFile::copy(m_scene, copy));
  QCOMPARE(objectOf({"info", "--json", copy}), meshes);
}

void ImportTest::everyCommandTakesIt_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QString>("output");
  QTest::newRow("render") << QStringList{"render", "--size", "160x120"} << "a.png";
  QTest::newRow("lines") << QStringList{"lines", "--camera", at("camera.json"), "--size", "160x120"}
                         << "lines.json";
  QTest::newRow("curvature") << QStringList{"curvature"} << "curvature.csv";
  QTest::newRow("import") << QStringList{"import"} << "b.sline";
}

void ImportTest::everyCommandTakesIt() {
  QFETCH(QStringList, arguments);
  QFETCH(QString, output);
  const QStringList rest = arguments.mid(1);
  const Finished fromScene =
      runSline(QStringList{arguments[0], m_scene, "-o", at("of scene " + output)} + rest);
  QVERIFY2(fromScene.code == 0, fromScene.err.constData());
  const QStringList off{"--smooth", "off"};
  const Finished fromMeshes =
      runSline(QStringList{arguments[0], m_meshes, "-o", at("of meshes " + output)} + rest + off);
  QVERIFY2(fromMeshes.code == 0, fromMeshes.err.constData());
  QVERIFY(!contentOf(at("of scene " + output)).isEmpty());
  QVERIFY(contentOf(at("of scene " + output)) == contentOf(at("of meshes " + output)));
}

void ImportTest::savedAgainIsTheSame() {
  const QByteArray before = contentOf(m_scene);
  QCOMPARE(runSline({"import", m_scene, "-o", at("again.sline")}).code, 0);
  QVERIFY(contentOf(at("again.sline")) == before);
  QCOMPARE(runSline({"import", m_scene, "-o", m_scene}).code, 0);  // over itself
  QVERIFY(contentOf(m_scene) == before);
  QVERIFY(QDir(m_folder.path()).entryList({".*"}, QDir::Files | QDir::Hidden).isEmpty());
}

void ImportTest::planAsText() {
  writeFile(m_meshes + "/Organs/broken.obj", "v 0 0\nf 1 2 3\n");
  const Finished finished = runSline({"import", m_meshes, "--plan", "--frame", "RAS"});
  QVERIFY(QFile::remove(m_meshes + "/Organs/broken.obj"));
  QCOMPARE(finished.code, 0);
  const QByteArray expected =
      "Organs\n"
      "  kidney: 5120 triangles from kidney.obj\n"
      "Vessels\n"
      "  renal artery: 1280 triangles from renal artery.obj\n"
      "  renal vein: 1280 triangles from renal vein.obj\n"
      "3 structures, 7680 triangles, 140 × 60 × 60 mm\n"
      "frame RAS (chosen by the user): 3 structures\n"
      "one unit is 1.0 mm (no unit in the file: millimetres assumed): 3 structures\n"
      "left out or mended: broken.obj: ";
  QVERIFY2(finished.out.startsWith(expected), finished.out.constData());
}

void ImportTest::planAsJson() {
  const QJsonObject plan =
      objectOf({"import", m_meshes, "--plan", "--json", "--unit", "cm", "-o", at("never.sline")});
  QCOMPARE(plan.keys(), QStringList({"bounds_mm", "decimate_mm", "inputs", "left_out", "nodes",
                                     "notes", "repaired", "unit_doubts"}));
  const QJsonArray nodes = plan["nodes"].toArray();
  QCOMPARE(nodes.size(), 5);
  QVERIFY(!nodes[0].toObject().contains("file"));
  const QJsonObject kidney = nodes[1].toObject();
  QCOMPARE(kidney["parent"].toInt(), nodes[0].toObject()["id"].toInt());
  QCOMPARE(kidney["file"].toString(), QString("kidney.obj"));
  QCOMPARE(kidney["mm_per_unit"].toDouble(), 10.0);
  QCOMPARE(kidney["unit_reason"].toString(), QString("chosen by the user"));
  QCOMPARE(kidney["frame"].toString(), QString("LPS"));
  QCOMPARE(kidney["read_as"].toString(), QString("LPS"));
  QCOMPARE(kidney["sides"].toString(), QString("assumed"));
  QVERIFY(!kidney["frame_reason"].toString().isEmpty());
  QCOMPARE(plan["bounds_mm"][1][0].toDouble(), 700.0);
  QVERIFY(!QFile::exists(at("never.sline")));
}

void ImportTest::wrongUse_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QByteArray>("says");
  const QString out = at("wrong.sline");
  QTest::newRow("no output") << QStringList{} << QByteArray("--plan");
  QTest::newRow("another kind") << QStringList{"-o", at("a.stl")} << QByteArray(".sline");
  QTest::newRow("JSON without plan") << QStringList{"-o", out, "--json"} << QByteArray("--plan");
  QTest::newRow("unit") << QStringList{"-o", out, "--unit", "mile"} << QByteArray("inch");
  QTest::newRow("bound below nothing")
      << QStringList{"-o", out, "--decimate-mm", "-1"} << QByteArray("--decimate-mm");
  QTest::newRow("unit of nothing")
      << QStringList{"-o", out, "--unit", "m", "--frame", "file"} << QByteArray("--frame file");
}

void ImportTest::wrongUse() {
  QFETCH(QStringList, arguments);
  QFETCH(QByteArray, says);
  const Finished finished = runSline(QStringList{"import", m_meshes} + arguments);
  QCOMPARE(finished.code, 2);
  QVERIFY2(finished.err.contains(says), finished.err.constData());
  QVERIFY(!QFile::exists(at("wrong.sline")));
}

void ImportTest::brokenFileIsNamed() {
  writeFile(at("cut.sline"), contentOf(m_scene).left(5000));
  const Finished finished = runSline({"info", at("cut.sline")});
  QCOMPARE(finished.code, 1);
  QVERIFY2(finished.err.contains("cut.sline") && finished.err.contains("ZIP"),
           finished.err.constData());
}

void ImportTest::diskTroubles_data() {
  QTest::addColumn<QString>("trouble");
  QTest::addColumn<QByteArray>("says");
  QTest::newRow("full disk") << "true" << QByteArray("No space left on device");
  QTest::newRow("read-only disk") << "mount -o remount,ro none /mnt"
                                  << QByteArray("Read-only file system");
}

void ImportTest::diskTroubles() {
  QFETCH(QString, trouble);
  QFETCH(QByteArray, says);
  const QString small = at("small.sline");
  QCOMPARE(runSline({"import", m_meshes + "/Vessels/renal vein.obj", "-o", small}).code, 0);
  const qint64 old = QFileInfo(small).size();
  const qint64 whole = QFileInfo(m_scene).size();
  QVERIFY(whole > 20000);
  const auto finished = runWithSmallDisk(old + whole / 2,
                                         "cp \"$2\" /mnt/a.sline && " + trouble +
                                             " || exit 77\n"
                                             "\"$1\" import \"$3\" -o /mnt/a.sline; code=$?\n"
                                             "cmp \"$2\" /mnt/a.sline && ls -A /mnt && exit $code",
                                         {SLINE_PROGRAM, small, m_scene});
  if (!finished)
    QSKIP("this system lets nobody mount");
  QCOMPARE(finished->code, 1);
  QCOMPARE(finished->out, QByteArray("a.sline\n"));  // as it was, and nothing beside it
  QVERIFY2(finished->err.contains("/mnt/a.sline") && finished->err.contains(says),
           finished->err.constData());
}

void ImportTest::fewerTriangles() {
  const QStringList off{"--smooth", "off"};
  const QString fewer = at("fewer.sline");
  const Finished finished =
      runSline(QStringList{"import", m_meshes, "-o", fewer, "--decimate-mm", "0.5"} + off);
  QVERIFY2(finished.code == 0, finished.err.constData());
  const QJsonObject plan = objectOf({"import", fewer, "--plan", "--json"});
  for (const QJsonValue& node : plan["nodes"].toArray())
    if (node["name"].toString() == "kidney")
      QVERIFY(node["triangles"].toInt() > 100 && node["triangles"].toInt() < 2000);
  const Finished planned = runSline({"import", m_meshes, "--plan", "--decimate-mm", "0.5"});
  QVERIFY2(planned.out.contains("5120 triangles") && planned.out.contains("more than 0.5 mm"),
           planned.out.constData());
}

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::ImportTest)
#include "import_test.moc"
