// SPDX-License-Identifier: Apache-2.0
// Tests that files which are added to a scene are read as they would be in one folder with the
// files that it was made of, be it open or saved; and that its patient is known by what it keeps.
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <map>

#include "model/edit/sides.h"
#include "model/import/naming/laterality.h"
#include "model/import/plan/patients.h"
#include "model/import/plan/plan.h"
#include "model/import/plan/scene_inputs.h"
#include "model/packed_scene/packed_scene.h"
#include "model/scene/known_frame.h"
#include "model/scene_file/scene_file.h"
#include "model/scene_json/scene_json.h"
#include "tests/model/import/dicom/written_structures.h"
#include "tests/model/import/volumes/written_volumes.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

using Path = std::filesystem::path;

constexpr float radius = 12.0f;

/// The middles of organs in LPS, millimetres.
const std::map<QString, glm::vec3>& body() {
  static const std::map<QString, glm::vec3> places{{"liver", {-70, -280, 10}},
                                                   {"spleen", {80, -230, 15}},
                                                   {"spine", {0, -190, -5}},
                                                   {"urinary bladder", {0, -270, -140}},
                                                   {"growth", {30, -260, -20}},
                                                   {"left kidney", {50, -210, -40}},
                                                   {"right kidney", {-50, -210, -45}},
                                                   {"left masseter", {50, -290, 300}},
                                                   {"right masseter", {-50, -290, 300}}};
  return places;
}

glm::vec3 inFile(glm::vec3 p, Frame frame) {
  const FrameAxes& axes = axesOf(frame);
  return {axes.left ? p.x : -p.x, axes.posterior ? p.y : -p.y, p.z};
}

/// Organs in files of one frame, which say so or not.
struct Organs {
  QStringList names;
  Frame frame = Frame::lps;
  bool say = false;
  glm::vec3 away{0.0f};
};

void write(const QString& folder, const Organs& organs) {
  QDir().mkpath(folder);
  for (const QString& name : organs.names)
    test::writeMesh(folder + "/" + name + ".ply",
                    *test::octahedron(inFile(body().at(name) + organs.away, organs.frame), radius),
                    organs.say ? std::optional(organs.frame) : std::nullopt);
}

/// Returns "growth RAS right sure", or "… front marked" or "… marked", for each structure, in the
/// order of names.
QStringList told(const Scene& scene, const glm::vec3& away) {
  QStringList all;
  for (const Node& node : scene.nodes()) {
    if (node.isGroup())
      continue;
    QString name = QString::fromStdString(node.name);
    name.remove(QStringLiteral(" 2"));  // names of one folder are told apart
    const glm::vec3 middle = node.mesh->bounds().centre();
    const bool right = glm::length(middle - body().at(name)) < 0.1f ||
                       glm::length(middle - body().at(name) - away) < 0.1f;
    all << name + " " + QString::fromStdString(node.provenance.frame) +
               (right ? " right" : " wrong") +
               (node.provenance.evidence.isSure()        ? " sure"
                : isSure(node.provenance.evidence.sides) ? " front marked"
                                                         : " marked");
  }
  all.sort();
  return all;
}

ImportOptions unsmoothed() {
  ImportOptions options;
  options.smoothing.mode = Smoothing::Mode::off;
  return options;
}

Scene importedFrom(const std::vector<Path>& inputs) {
  const auto imported = importInputs(inputs, unsmoothed());
  return imported.ok() ? imported->scene : Scene();
}

/// Adds what lies in the folder to the scene, as the window does.
Scene withAdded(const Scene& open, const Path& folder, ImportReport* report = nullptr) {
  ImportOptions options = unsmoothed();
  options.into = std::make_shared<const Scene>(open);
  const auto added = importInputs(std::array{folder}, options);
  if (!added.ok())
    return {};
  Scene together =
      added->report.frameAnew ? withFrameAnew(open, *added->report.frameAnew).scene : open;
  append(together, added->scene);
  if (report)
    *report = added->report;
  return together;
}

struct Said {
  QByteArray study = "1.2.826.0.1.99.3";
  QByteArray frame = "1.2.826.0.1.99.4";
  QByteArray id = "";
};

QByteArray structures(const Said& said) {
  test::WrittenSet set =
      test::structureSet({{"Liver", "ORGAN", {}, test::ball({0, 0, 0}, 50, -49, 2)}});
  for (const auto& [tag, value] :
       {std::pair(Tag{0x0010, 0x0020}, said.id), std::pair(Tag{0x0010, 0x0010}, QByteArray()),
        std::pair(Tag{0x0020, 0x000d}, said.study), std::pair(Tag{0x0020, 0x0052}, said.frame)})
    for (test::WrittenElement& element : set)
      if (element.tag == tag)
        element.value = value;
  return test::dicomFile(set);
}

Path put(const QTemporaryDir& folder, const QString& name, const Said& said) {
  test::writeText(folder.filePath(name), structures(said));
  return folder.filePath(name).toStdString();
}

/// Imports the file and saves the scene.
Path savedOf(const QTemporaryDir& folder, const QString& name, const Said& said) {
  const Path file = put(folder, name + ".dcm", said);
  const auto imported = importInputs(std::array{file}, {});
  Path saved = folder.filePath(name + ".sline").toStdString();
  if (!imported.ok() || !writeSceneFile(saved, {.scene = imported->scene}).ok())
    qFatal("%s cannot be saved", qPrintable(name));
  return saved;
}

}  // namespace

class ImportIntoTest : public QObject {
  Q_OBJECT
 private slots:
  void asInOneFolder_data();
  void asInOneFolder();
  void whatIsSettledStays();
  void nothingMovesWithoutNeed();
  void whatComesTwiceIsTold();
  void savedScenesKnowTheirPatient_data();
  void savedScenesKnowTheirPatient();
  void scenesThatCannotBeCompared();
  void theTraceTellsNobody();
};

void ImportIntoTest::asInOneFolder_data() {
  QTest::addColumn<QStringList>("open");
  QTest::addColumn<QStringList>("added");
  QTest::addColumn<bool>("openSays");
  QTest::addColumn<bool>("addedSays");
  QTest::addColumn<float>("away");
  QTest::addColumn<bool>("right");    // all is
  QTest::addColumn<bool>("certain");  // and is sure
  const QStringList surroundings{"liver", "spine", "urinary bladder", "spleen"};
  QTest::newRow("fits in") << surroundings << QStringList{"growth"} << true << false << 0.0f << true
                           << false;
  QTest::newRow("fits nowhere") << surroundings << QStringList{"growth"} << true << false << 900.0f
                                << false << false;
  QTest::newRow("what is open is assumed, what comes fits")
      << QStringList{"growth"} << surroundings << false << true << 0.0f << true << false;
  QTest::newRow("both halves of a pair")
      << QStringList{"left masseter"} << QStringList{"right masseter"} << false << false << 0.0f
      << true << false;
  QTest::newRow("a pair beside what was assumed")
      << QStringList{"growth"} << QStringList{"left kidney", "right kidney"} << false << false
      << 0.0f << true << false;
  QTest::newRow("a pair and what lies before it")
      << QStringList{"growth"} << QStringList{"left kidney", "right kidney", "liver"} << false
      << false << 0.0f << true << false;
  QTest::newRow("a pair and what lies before and below it")
      << QStringList{"growth"}
      << QStringList{"left kidney", "right kidney", "liver", "urinary bladder"} << false << false
      << 0.0f << true << true;
  QTest::newRow("nothing tells") << QStringList{"growth"} << QStringList{"urinary bladder"} << false
                                 << false << 0.0f << false << false;
  QTest::newRow("a weak name beside what was assumed")
      << QStringList{"urinary bladder"} << QStringList{"left masseter"} << false << false << 0.0f
      << false << false;
  QTest::newRow("the same name") << QStringList{"growth", "liver"} << QStringList{"growth"} << true
                                 << false << 0.0f << true << true;
}

void ImportIntoTest::asInOneFolder() {
  QFETCH(QStringList, open);
  QFETCH(QStringList, added);
  QFETCH(bool, openSays);
  QFETCH(bool, addedSays);
  QFETCH(float, away);
  QFETCH(bool, right);
  QFETCH(bool, certain);
  for (const Frame frame : {Frame::lps, Frame::ras}) {
    const QTemporaryDir folder;
    const glm::vec3 shift(0.0f, 0.0f, away);
    write(folder.filePath("all/open"), {open, frame, openSays});
    write(folder.filePath("all/added"), {added, frame, addedSays, shift});
    const Path root(folder.path().toStdString());
    const QStringList together = told(importedFrom({root / "all"}), shift);
    QCOMPARE(together.size(), open.size() + added.size());
    for (const QString& each : together)
      QVERIFY2(!right || each.contains(certain ? " right sure" : " right "), qPrintable(each));
    const Scene before = importedFrom({root / "all/open"});
    ImportReport report;
    QCOMPARE(told(withAdded(before, root / "all/added", &report), shift), together);
    QCOMPARE(knownSides(withAdded(before, root / "all/added")).inDoubt(), !certain);
    QVERIFY(writeSceneFile(root / "open.sline", {.scene = before}).ok());
    QCOMPARE(told(importedFrom({root / "open.sline", root / "all/added"}), shift), together);
    // Whoever reads what was there otherwise says so.
    bool says = false;
    for (const std::string& note : report.notes)
      says = says || note.find("what was there already") != std::string::npos;
    QCOMPARE(says, report.frameAnew.has_value());
  }
}

void ImportIntoTest::whatIsSettledStays() {
  const QTemporaryDir folder;
  write(folder.filePath("open"), {{"growth"}, Frame::ras});
  write(folder.filePath("added"), {{"left kidney", "right kidney"}, Frame::ras});
  const Path root(folder.path().toStdString());
  const Scene open = withSidesSettled(importedFrom({root / "open"}), SideAnswer::right).scene;
  const Scene after = withAdded(open, root / "added");
  QCOMPARE(told(after, {}),
           (QStringList{"growth LPS wrong sure", "left kidney RAS right front marked",
                        "right kidney RAS right front marked"}));
}

/// What is assumed on both sides stays where it is, together.
void ImportIntoTest::nothingMovesWithoutNeed() {
  const QTemporaryDir folder;
  write(folder.filePath("open"), {{"growth"}, Frame::lps});
  write(folder.filePath("added"), {{"urinary bladder"}, Frame::lps});
  const Path root(folder.path().toStdString());
  const Scene open = importedFrom({root / "open"});
  ImportReport report;
  const Scene after = withAdded(open, root / "added", &report);
  QVERIFY(!report.frameAnew);
  QVERIFY(test::named(after, "growth").mesh == test::named(open, "growth").mesh);
}

/// Two bodies in one place are told whichever comes first, once.
void ImportIntoTest::whatComesTwiceIsTold() {
  const QTemporaryDir folder;
  const QStringList organs{"liver", "spleen", "spine", "left kidney", "right kidney"};
  write(folder.filePath("open"), {organs, Frame::lps, true});
  write(folder.filePath("added"), {organs, Frame::lps, true, {3.0f, 0.0f, 0.0f}});
  write(folder.filePath("other"), {{"growth"}, Frame::lps, true});
  const Path root(folder.path().toStdString());
  const auto says = [](const ImportReport& report) {
    return std::count_if(report.warnings.begin(), report.warnings.end(),
                         [](const ImportWarning& w) {
                           return w.reason.find("two versions or two bodies") != std::string::npos;
                         });
  };
  const Scene open = importedFrom({root / "open"});
  ImportReport report;
  const Scene both = withAdded(open, root / "added", &report);
  QCOMPARE(says(report), 1);
  withAdded(both, root / "other", &report);
  QCOMPARE(says(report), 0);
  QVERIFY(writeSceneFile(root / "open.sline", {.scene = open}).ok());
  const auto saved = importInputs(std::array{root / "open.sline", root / "added"}, unsmoothed());
  QVERIFY(saved.ok());
  QCOMPARE(says(saved->report), 1);
}

void ImportIntoTest::savedScenesKnowTheirPatient_data() {
  QTest::addColumn<QByteArray>("study");
  QTest::addColumn<QByteArray>("frame");
  QTest::addColumn<QString>("outcome");
  QTest::newRow("same study") << Said().study << Said().frame << "one";
  QTest::newRow("same study, another frame") << Said().study << QByteArray("1.9.9") << "frames";
  QTest::newRow("another study") << QByteArray("1.9") << QByteArray("1.9.9") << "apart";
  QTest::newRow("another study, frame shared") << QByteArray("1.9") << Said().frame << "apart";
  QTest::newRow("no study, same frame") << QByteArray() << Said().frame << "one";
  QTest::newRow("no study, another frame") << QByteArray() << QByteArray("1.9.9") << "apart";
  QTest::newRow("nothing said") << QByteArray() << QByteArray() << "one";
}

void ImportIntoTest::savedScenesKnowTheirPatient() {
  QFETCH(QByteArray, study);
  QFETCH(QByteArray, frame);
  QFETCH(QString, outcome);
  const QTemporaryDir folder;
  const Path scene = savedOf(folder, "scene", {});
  const Path other = put(folder, "other.dcm", {study, frame, "8"});
  const auto read = readSceneFile(scene);
  QVERIFY(read.ok());
  QCOMPARE(read->scene.traces().size(), std::size_t(1));
  const bool apart = outcome == "apart";
  const auto inputs = std::array{scene, other};
  QCOMPARE(patientsAmong(inputs, {}, ScannerSlices::read).several(), apart);
  QCOMPARE(patientsAmong(std::array{other}, {}, ScannerSlices::read, &read->scene).several(),
           apart);
  for (ImportOptions options :
       {ImportOptions(), ImportOptions{.patients = PatientsWanted::together},
        ImportOptions{.patients = PatientsWanted::first}}) {
    const auto imported = importInputs(inputs, options);
    QCOMPARE(imported.ok(), !apart || options.patients != PatientsWanted::one);
    if (!imported.ok()) {
      const QString error = QString::fromStdString(imported.error().text());
      QVERIFY2(error.contains("scene.sline") && error.contains("other.dcm"), qPrintable(error));
      continue;
    }
    const bool left = apart && options.patients == PatientsWanted::first;
    QCOMPARE(imported->scene.structuresBelow(rootId).size(), std::size_t(left ? 1 : 2));
    bool frames = false;
    for (const ImportWarning& warning : imported->report.warnings)
      frames = frames || warning.reason.find("frames of reference") != std::string::npos;
    QCOMPARE(frames, outcome == "frames");
  }
  // What was put together once belongs together.
  const auto both = importInputs(inputs, {.patients = PatientsWanted::together});
  QVERIFY(both.ok());
  QVERIFY(!patientsAmong(std::array{other}, {}, ScannerSlices::read, &both->scene).several());
}

void ImportIntoTest::scenesThatCannotBeCompared() {
  const QTemporaryDir folder;
  const Path one = savedOf(folder, "one", {});
  const Path two = savedOf(folder, "two", {});
  const Path copy = folder.filePath("copy.sline").toStdString();
  std::filesystem::copy_file(one, copy);
  QVERIFY(importInputs(std::array{one, copy}, {}).ok());
  const auto refused = importInputs(std::array{one, two}, {});
  QVERIFY(!refused.ok());
  QVERIFY(patientsAmong(std::array{one, two}, {}, ScannerSlices::read).several());
  QVERIFY(importInputs(std::array{one, two}, {.patients = PatientsWanted::together}).ok());
  // Scenes of files that say nothing go with any.
  write(folder.filePath("body"), {{"liver"}, Frame::lps, true});
  const Scene body = importedFrom({Path(folder.filePath("body").toStdString())});
  QVERIFY(body.traces().empty());
  const Path silent = folder.filePath("silent.sline").toStdString();
  QVERIFY(writeSceneFile(silent, {.scene = body}).ok());
  QVERIFY(importInputs(std::array{one, silent}, {}).ok());
}

void ImportIntoTest::theTraceTellsNobody() {
  const QTemporaryDir folder;
  const Said jane{"9.8.7.6.5", "9.8.7.6.4", "QZX7"};
  const auto first = importInputs(std::array{put(folder, "a.dcm", jane)}, {});
  const auto second = importInputs(std::array{put(folder, "b.dcm", jane)}, {});
  const auto other = importInputs(std::array{put(folder, "c.dcm", {.id = "QZX8"})}, {});
  QVERIFY(first.ok() && second.ok() && other.ok());
  const SourceTrace& a = first->scene.traces().front();
  const SourceTrace& b = second->scene.traces().front();
  QVERIFY(a.salt != b.salt && a.study != b.study && a.frame != b.frame);
  QVERIFY(a.study != a.frame);
  // A number of a register, and a name, leave nothing behind.
  PatientMarks named;
  named.id = 7;
  named.name = 8;
  named.subject = 9;
  QVERIFY(newTraces(std::array{named}, {}).empty());
  const std::string text = sceneJson(first->scene);
  QVERIFY(text.find(a.salt) != std::string::npos);
  for (const QByteArray& word : {jane.study, jane.frame, jane.id})
    QVERIFY(text.find(word.toStdString()) == std::string::npos);
  // Pages do not carry it.
  const PackedScene page = packedScene(first->scene, {});
  QVERIFY(page.first.find(a.salt) == std::string::npos);
  QVERIFY(page.first.find(a.study) == std::string::npos);
}

SLINE_TEST(ImportIntoTest)
#include "import_into_test.moc"
