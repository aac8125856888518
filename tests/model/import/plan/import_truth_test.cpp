// SPDX-License-Identifier: Apache-2.0
// Tests that no import prints left and right as a fact that is none: whatever files and names say,
// each structure lies where it belongs, or its sides are marked as not certain.
#include <QDir>
#include <QtTest>
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <map>
#include <vector>

#include "model/import/naming/laterality.h"
#include "model/import/plan/import.h"
#include "model/scene/known_frame.h"
#include "model/scene_file/scene_file.h"
#include "tests/model/import/volumes/written_volumes.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

/// Says what tells the frame of the files besides their names.
enum class Header {
  none,
  own,             ///< SPACE in each file
  wrong,           ///< SPACE, turned
  chosen,          ///< the person's choice
  scene,           ///< a scene of 3D Slicer in the folder
  sceneElsewhere,  ///< one in another folder of it, and the files were moved
  scenesDisagree,
  volumes,         ///< label volumes of the same names, which state their frame
  volumesApart,    ///< such volumes of another patient
  neighbours,      ///< further surfaces of the same body, whose files state their frame
  neighboursApart  ///< of a body far away
};

/// The middles of organs in LPS, millimetres.
const std::map<QString, glm::vec3>& body() {
  static const std::map<QString, glm::vec3> places{{"liver", {-70, -30, 10}},
                                                   {"spleen", {80, 20, 15}},
                                                   {"spine", {0, 60, -5}},
                                                   {"left kidney", {50, 40, -40}},
                                                   {"right kidney", {-50, 40, -45}},
                                                   {"left ureter", {40, 30, -90}},
                                                   {"right femur", {-90, 10, -200}},
                                                   {"left masseter", {50, -40, 300}},
                                                   {"linke Niere", {50, 40, -40}},
                                                   {"urinary bladder", {0, -20, -140}},
                                                   {"descending colon", {85, 10, -60}},
                                                   {"appendix", {-80, 0, -110}},
                                                   {"left atrium", {-5, -20, 120}},
                                                   {"left lobe of liver", {-10, -40, 15}},
                                                   {"growth", {30, -10, -20}},
                                                   {"cyst", {100, 30, -20}},
                                                   {"drain", {105, 35, -30}},
                                                   {"stone", {95, 40, -25}},
                                                   {"tumour", {110, 25, -15}},
                                                   {"fat", {100, 45, -35}},
                                                   {"left a", {40, 0, 0}},
                                                   {"right a", {-40, 0, 0}},
                                                   {"left b", {-30, 0, 20}},
                                                   {"right b", {30, 0, 20}},
                                                   {"left e", {45, 0, 60}},
                                                   {"right e", {-45, 0, 60}},
                                                   {"left c", {35, 0, 40}},
                                                   {"right c", {-35, 0, 40}}};
  return places;
}

constexpr float radius = 12.0f;

glm::vec3 inFile(glm::vec3 p, Frame frame) {
  const FrameAxes& axes = axesOf(frame);
  return {axes.left ? p.x : -p.x, axes.posterior ? p.y : -p.y, p.z};
}

Frame otherFrame(Frame frame) {
  return frame == Frame::lps ? Frame::ras : Frame::lps;
}

QByteArray sceneNaming(const QStringList& files, Frame frame) {
  QByteArray text = "<MRML version=\"Slicer4.13.0\">\n";
  for (qsizetype i = 0; i < files.size(); ++i) {
    const QByteArray number = QByteArray::number(i);
    text += "<ModelStorage id=\"S" + number + "\" fileName=\"" + files[i].toUtf8() +
            "\" coordinateSystem=\"" + (frame == Frame::lps ? "LPS" : "RAS") +
            "\"/>\n<Model id=\"M" + number + "\" name=\"model\" storageNodeRef=\"S" + number +
            "\"/>\n";
  }
  return text + "</MRML>\n";
}

/// Writes an organ as a label volume of its own, in LPS.
void writeVolume(const QString& path, const glm::vec3& middle) {
  glm::dmat4 place(1.0);
  for (int axis = 0; axis < 3; ++axis) {
    place[axis][axis] = 2.0;
    place[3][axis] = double(middle[axis]) - 24.0;
  }
  const auto octahedron = [&middle](const glm::dvec3& p) {
    const glm::dvec3 way = glm::abs(p - glm::dvec3(middle));
    return way.x + way.y + way.z <= double(radius) ? 1 : 0;
  };
  test::writeText(path, test::nrrdFile(test::sampled(glm::ivec3(25), place, octahedron),
                                       "left-posterior-superior"));
}

QStringList organFiles(const QStringList& organs) {
  QStringList files;
  for (const QString& organ : organs)
    files << organ + ".ply";
  return files;
}

/// Says how the files of a row are written.
struct Written {
  Frame frame;
  Header how;
  glm::vec3 shift;  ///< of the body from the origin
};

void writeOrgans(const QTemporaryDir& folder, const QStringList& organs, const Written& row) {
  const std::optional<Frame> stated = row.how == Header::own ? std::optional(row.frame)
                                      : row.how == Header::wrong
                                          ? std::optional(otherFrame(row.frame))
                                          : std::nullopt;
  for (const QString& organ : organs) {
    const glm::vec3 middle = body().at(organ) + row.shift;
    test::writeMesh(folder.filePath("models/" + organ + ".ply"),
                    *test::octahedron(inFile(middle, row.frame), radius), stated);
    if (row.how == Header::volumes || row.how == Header::volumesApart)
      writeVolume(
          folder.filePath("labels/" + organ + ".nrrd"),
          middle + (row.how == Header::volumes ? glm::vec3(0.0f) : glm::vec3(0.0f, 20.0f, 300.0f)));
  }
}

void writeSurroundings(const QTemporaryDir& folder, QStringList files, const Written& row) {
  if (row.how == Header::scene || row.how == Header::scenesDisagree)
    test::writeText(folder.filePath("models/a.mrml"), sceneNaming(files, row.frame));
  if (row.how == Header::scenesDisagree)
    test::writeText(folder.filePath("models/b.mrml"), sceneNaming(files, otherFrame(row.frame)));
  if (row.how == Header::sceneElsewhere)
    test::writeText(folder.filePath("scenes/a.mrml"),
                    sceneNaming(files.replaceInStrings("growth", "Data/growth"), row.frame));
  if (row.how != Header::neighbours && row.how != Header::neighboursApart)
    return;
  const glm::vec3 away(0.0f, 0.0f, row.how == Header::neighbours ? 0.0f : 900.0f);
  for (const char* organ : {"liver", "spine", "urinary bladder", "spleen"})
    test::writeMesh(folder.filePath(QString("others/%1.ply").arg(organ)),
                    *test::octahedron(body().at(organ) + row.shift + away, radius), Frame::lps);
}

}  // namespace

class ImportTruthTest : public QObject {
  Q_OBJECT
 private slots:
  void nothingIsSilent_data();
  void nothingIsSilent();
  void leftMasseter_data();
  void leftMasseter();
  void foldersOfDifferentFrames_data();
  void foldersOfDifferentFrames();
  void besideASceneThatNamesIt();
  void besideASceneFile();
};

void ImportTruthTest::nothingIsSilent_data() {
  QTest::addColumn<int>("written");
  QTest::addColumn<int>("header");
  QTest::addColumn<QStringList>("organs");
  QTest::addColumn<float>("aside");  // how far the origin lies at the body's right
  QTest::addColumn<QString>("outcome");
  const auto row = [](const char* tag, Frame frame, Header header, const QStringList& organs,
                      const char* outcome, float aside = 0.0f) {
    QTest::addRow("%s, %s", tag, frameName(frame).c_str())
        << int(frame) << int(header) << organs << aside << QString(outcome);
  };
  const QStringList nameless{"growth", "urinary bladder"};
  for (const Frame frame : {Frame::lps, Frame::ras}) {
    const char* const guessed = frame == Frame::lps ? "marked, right" : "marked, wrong";
    row("nothing", frame, Header::none, nameless, guessed);
    row("header", frame, Header::own, nameless, "right");
    row("chosen", frame, Header::chosen, nameless, "right");
    row("scene", frame, Header::scene, nameless, "right");
    row("scene elsewhere", frame, Header::sceneElsewhere, nameless, "right");
    row("scenes that disagree", frame, Header::scenesDisagree, nameless, guessed);
    row("volumes of the same names", frame, Header::volumes, nameless, "right");
    row("one volume of the same name", frame, Header::volumes, {"growth"}, "right");
    row("volumes of others", frame, Header::volumesApart, nameless, guessed);
    row("neighbours", frame, Header::neighbours, {"growth"}, "marked, right");
    row("neighbours apart", frame, Header::neighboursApart, {"growth"}, guessed);
    row("pair", frame, Header::none, {"left kidney", "right kidney"}, "front marked, right");
    row("pair far from the origin", frame, Header::none, {"left kidney", "right kidney"},
        "front marked, right", 400.0f);
    row("pair, and what lies before it", frame, Header::none,
        {"left kidney", "right kidney", "liver"}, "up marked, right");
    row("pair, and what lies before and below it", frame, Header::none,
        {"left kidney", "right kidney", "liver", "urinary bladder"}, "right");
    const QStringList oneSided{"left kidney", "spleen", "cyst", "drain", "stone", "tumour", "fat"};
    row("one side of the body", frame, Header::none, oneSided, "marked, right");
    row("one side of the body, header", frame, Header::own, oneSided, "right");
    row("pair that contradicts", frame, Header::wrong, {"left kidney", "right kidney"},
        "marked, wrong");
    row("one left", frame, Header::none, {"left masseter"}, "marked, right");
    row("one left in German", frame, Header::none, {"linke Niere"}, "marked, right");
    row("one right", frame, Header::none, {"right femur"}, "marked, right");
    row("liver", frame, Header::none, {"liver"}, "marked, right");
    row("spleen", frame, Header::none, {"spleen"}, "marked, right");
    row("appendix", frame, Header::none, {"appendix"}, "marked, right");
    row("descending colon", frame, Header::none, {"descending colon"}, "marked, right");
    row("liver and spleen", frame, Header::none, {"liver", "spleen"}, "up marked, right");
    row("liver and spleen far off", frame, Header::none, {"liver", "spleen"}, "up marked, right",
        400.0f);
    row("liver, spleen and bladder", frame, Header::none, {"liver", "spleen", "urinary bladder"},
        "right");
    row("two of different names", frame, Header::none, {"left ureter", "right femur"},
        "front marked, right");
    row("two of the same side", frame, Header::none, {"left ureter", "left kidney"},
        "marked, right");
    row("one with the spine", frame, Header::none, {"left kidney", "spine"}, "marked, right", 400);
    row("two with the spine", frame, Header::none, {"left kidney", "left ureter", "spine"},
        "front marked, right", 400);
    row("part of an organ in the middle", frame, Header::none, {"left atrium"}, guessed);
    row("one of three pairs against", frame, Header::none,
        {"left a", "right a", "left b", "right b", "left c", "right c"}, "marked, right");
    row("weak name, neighbours fit", frame, Header::neighbours, {"left kidney"}, "marked, right");
  }
  // Files may be mirror images, which no side in a name tells.
  for (const Frame frame : {Frame::las, Frame::rps}) {
    row("mirrored, chosen", frame, Header::chosen, nameless, "right");
    row("mirrored, names of sides alone", frame, Header::none, {"left kidney", "right kidney"},
        "front marked, wrong");
    row("mirrored, spine behind the organs", frame, Header::none,
        {"left kidney", "right kidney", "spine", "liver", "urinary bladder"}, "marked, wrong");
    row("mirrored, volumes of the same names", frame, Header::volumes, {"liver", "spleen", "spine"},
        "right");
  }
}

void ImportTruthTest::nothingIsSilent() {
  QFETCH(int, written);
  QFETCH(int, header);
  QFETCH(QStringList, organs);
  QFETCH(float, aside);
  QFETCH(QString, outcome);
  const auto frame = Frame(written);
  const auto how = Header(header);
  const glm::vec3 shift(aside, -250.0f, 0.0f);
  const QTemporaryDir folder;
  const QStringList files = organFiles(organs);
  writeOrgans(folder, organs, {frame, how, shift});
  writeSurroundings(folder, files, {frame, how, shift});
  ImportOptions options;
  options.smoothing.mode = Smoothing::Mode::off;
  if (how == Header::chosen)
    options.frame = frame;
  const auto imported =
      importInputs(std::array{std::filesystem::path(folder.path().toStdString())}, options);
  QVERIFY2(imported.ok(), imported ? "" : imported.error().text().c_str());
  bool right = true;
  SideEvidence evidence;
  int found = 0;
  for (const Node& node : imported->scene.nodes()) {
    const auto organ = files.indexOf(QString::fromStdString(node.provenance.file));
    if (node.isGroup() || organ < 0 || node.provenance.frame.empty())
      continue;
    ++found;
    evidence.sides = std::max(evidence.sides, node.provenance.evidence.sides);
    evidence.front = std::max(evidence.front, node.provenance.evidence.front);
    evidence.up = std::max(evidence.up, node.provenance.evidence.up);
    right = right &&
            glm::length(node.mesh->bounds().centre() - body().at(organs[organ]) - shift) < 0.1f;
  }
  QCOMPARE(found, int(organs.size()));
  const bool sure = evidence.isSure();
  const QString mark = sure                      ? ""
                       : !isSure(evidence.sides) ? "marked, "
                       : !isSure(evidence.front) ? "front marked, "
                                                 : "up marked, ";
  const QString got = mark + (right ? "right" : sure ? "wrong and nothing says so" : "wrong");
  QCOMPARE(got, outcome);
  QCOMPARE(knownSides(imported->scene).inDoubt(), !sure);
}

void ImportTruthTest::leftMasseter_data() {
  QTest::addColumn<bool>("mirrored");
  QTest::addColumn<QString>("with");
  QTest::addColumn<bool>("sure");
  for (const bool mirrored : {false, true}) {
    QTest::addRow("alone%s", mirrored ? ", mirrored" : "") << mirrored << "" << false;
    QTest::addRow("with its twin%s", mirrored ? ", mirrored" : "") << mirrored << "twin" << true;
    QTest::addRow("in a folder of twenty others%s", mirrored ? ", mirrored" : "")
        << mirrored << "others" << true;
  }
}

void ImportTruthTest::leftMasseter() {
  QFETCH(bool, mirrored);
  QFETCH(QString, with);
  QFETCH(bool, sure);
  const QString file = QString(SLINE_TEST_DATA) + "/reports/left_masseter.vtk";
  if (!QFileInfo::exists(file))
    SLINE_ABSENT("the muscle is absent");
  ImportOptions raw;
  raw.frame = Frame::file;
  raw.smoothing.mode = Smoothing::Mode::off;
  const auto read = importInputs(std::array{std::filesystem::path(file.toStdString())}, raw);
  QVERIFY(read.ok());
  const Mesh& muscle = *test::named(read->scene, "left masseter").mesh;
  const auto written = [&muscle](bool flipped) {
    std::vector<glm::vec3> positions(muscle.positions().begin(), muscle.positions().end());
    for (glm::vec3& p : positions)
      p.x = flipped ? -p.x : p.x;
    std::vector<Triangle> triangles(muscle.triangles().begin(), muscle.triangles().end());
    if (flipped)
      for (Triangle& t : triangles)
        std::swap(t[1], t[2]);
    return Mesh::create(std::move(positions), std::move(triangles)).value();
  };
  const QTemporaryDir folder;
  if (mirrored)
    test::writeMesh(folder.filePath("left_masseter.vtk"), written(true));
  else
    QVERIFY(QFile::copy(file, folder.filePath("left_masseter.vtk")));
  if (with == "twin")
    test::writeMesh(folder.filePath("right_masseter.vtk"), written(!mirrored));
  for (int i = 0; with == "others" && i < 20; ++i) {
    const float side = (i % 2 == 0 ? -1.0f : 1.0f) * (mirrored ? -1.0f : 1.0f);
    test::writeMesh(
        folder.filePath(
            QString("%1_part_%2.vtk").arg(i % 2 == 0 ? "left" : "right").arg(QChar('a' + i / 2))),
        *test::octahedron({side * float(30 + i / 2), float(i), float(-80 - i)}, 5.0f));
  }
  ImportOptions options;
  options.smoothing.mode = Smoothing::Mode::off;
  const auto imported =
      importInputs(std::array{std::filesystem::path(folder.path().toStdString())}, options);
  QVERIFY(imported.ok());
  const Node& node = test::named(imported->scene, "left masseter");
  QVERIFY2(node.mesh->bounds().centre().x > 30.0f, node.provenance.frameReason.c_str());
  QCOMPARE(QString::fromStdString(node.provenance.frame), QString(mirrored ? "LPS" : "RAS"));
  QCOMPARE(isSure(node.provenance.evidence.sides), sure);
}

/// A file that is opened alone belongs to the scene beside it.
void ImportTruthTest::besideASceneThatNamesIt() {
  for (const char* place : {"models/a.mrml", "a.mrml"}) {
    const QTemporaryDir folder;
    const QString file = folder.filePath("models/growth.ply");
    test::writeMesh(file, *test::octahedron({10, 20, 30}, radius));
    test::writeText(folder.filePath(place),
                    sceneNaming({QString(place).contains('/') ? "growth.ply" : "models/growth.ply"},
                                Frame::ras));
    const auto imported = importInputs(std::array{std::filesystem::path(file.toStdString())}, {});
    QVERIFY(imported.ok());
    const Node& node = test::named(imported->scene, "growth");
    QCOMPARE(node.provenance.frame, std::string("RAS"));
    QVERIFY(node.provenance.evidence.isSure());
  }
}

/// Folders of one import may be written by programs of different habits.
void ImportTruthTest::foldersOfDifferentFrames_data() {
  QTest::addColumn<QStringList>("first");
  QTest::addColumn<QStringList>("second");
  QTest::addColumn<bool>("beside");  // files that state their frame lie around them
  QTest::addColumn<QString>("outcome");
  const QStringList pair{"left e", "right e"};
  const QStringList many{"left a",       "right a", "left c", "right c", "left kidney",
                         "right kidney", "liver",   "spleen", "appendix"};
  QTest::newRow("pair against pair")
      << QStringList{"left a", "right a"} << pair << false << "right, right";
  QTest::newRow("many against one") << many << pair << false << "right, marked, wrong";
  QTest::newRow("where they fit") << QStringList{"growth"} << QStringList{"left ureter"} << true
                                  << "marked, right, marked, right";
}

void ImportTruthTest::foldersOfDifferentFrames() {
  QFETCH(QStringList, first);
  QFETCH(QStringList, second);
  QFETCH(bool, beside);
  QFETCH(QString, outcome);
  const glm::vec3 shift(0.0f, -250.0f, 0.0f);
  const QTemporaryDir folder;
  const auto put = [&](const char* in, const QStringList& organs, const Written& how) {
    QDir(folder.path()).mkdir(in);
    for (const QString& organ : organs)
      test::writeMesh(folder.filePath(QString("%1/%2.ply").arg(in, organ)),
                      *test::octahedron(inFile(body().at(organ) + shift, how.frame), radius),
                      how.how == Header::own ? std::optional(how.frame) : std::nullopt);
  };
  put("a", first, {Frame::lps, Header::none, shift});
  put("b", second, {Frame::ras, Header::none, shift});
  if (beside)
    put("c", {"descending colon", "spine", "urinary bladder", "right femur"},
        {Frame::lps, Header::own, shift});
  ImportOptions options;
  options.smoothing.mode = Smoothing::Mode::off;
  const auto imported =
      importInputs(std::array{std::filesystem::path(folder.path().toStdString())}, options);
  QVERIFY(imported.ok());
  const auto toldOf = [&](const QStringList& organs) {
    bool right = true;
    bool sure = true;
    for (const QString& organ : organs) {
      const Node& node = test::named(imported->scene, organ.toStdString());
      right = right && glm::length(node.mesh->bounds().centre() - body().at(organ) - shift) < 0.1f;
      sure = sure && isSure(node.provenance.evidence.sides);
    }
    return right ? QString(sure ? "right" : "marked, right")
                 : QString(sure ? "wrong and nothing says so" : "marked, wrong");
  };
  QCOMPARE(toldOf(first) + ", " + toldOf(second), outcome);
}

/// What is imported beside a scene file fits in with it.
void ImportTruthTest::besideASceneFile() {
  const QString growth("growth.ply");
  for (const Frame frame : {Frame::lps, Frame::ras}) {
    const QTemporaryDir folder;
    for (const char* organ : {"liver", "spine", "urinary bladder", "spleen"})
      test::writeMesh(folder.filePath(QString("body/%1.ply").arg(organ)),
                      *test::octahedron(body().at(organ) + glm::vec3(0, -250, 0), radius),
                      Frame::lps);
    const glm::vec3 there = body().at("growth") + glm::vec3(0, -250, 0);
    test::writeMesh(folder.filePath(growth), *test::octahedron(inFile(there, frame), radius));
    const std::filesystem::path root(folder.path().toStdString());
    const auto others = importInputs(std::array{root / "body"}, {});
    QVERIFY(others.ok());
    QVERIFY(writeSceneFile(root / "body.sline", {.scene = others->scene}).ok());
    const auto imported = importInputs(std::array{root / "body.sline", root / "growth.ply"}, {});
    QVERIFY(imported.ok());
    const Node& node = test::named(imported->scene, "growth");
    QVERIFY(glm::length(node.mesh->bounds().centre() - there) < 0.1f);
    // A box within another is a guess.
    QVERIFY(!node.provenance.evidence.isSure());
  }
}

SLINE_TEST(ImportTruthTest)
#include "import_truth_test.moc"
