// SPDX-License-Identifier: Apache-2.0
// Tests that the liver is on the patient's right, whatever the file states in whatever format.
#include <QtTest>
#include <array>
#include <glm/geometric.hpp>

#include "model/import/naming/laterality.h"
#include "model/import/plan/import.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

class LateralityTest : public QObject {
  Q_OBJECT
 private slots:
  void vote_data();
  void vote();
  void clearVotes_data();
  void clearVotes();
  void otherSideNamesTheStructures();
  void liverOnTheRight_data();
  void liverOnTheRight();
  void fileFrameTouchesNothing();
  void mirroredFrames();
  void contradictionIsTold_data();
  void contradictionIsTold();
};

void LateralityTest::vote_data() {
  QTest::addColumn<QStringList>("names");
  QTest::addColumn<QList<double>>("xs");
  QTest::addColumn<int>("lps");
  QTest::addColumn<int>("ras");
  const auto row = [](const char* tag, const QStringList& names, const QList<double>& xs, int lps,
                      int ras) { QTest::newRow(tag) << names << xs << lps << ras; };
  row("pair LPS", {"left kidney", "right kidney"}, {50, -50}, 1, 0);
  row("pair RAS", {"kidney_left", "kidney_right"}, {-50, 50}, 0, 1);
  row("single by the pairs' middle", {"left kidney", "right kidney", "left ureter"}, {-50, 50, -20},
      0, 2);
  row("single by the spine", {"right femur", "sacrum"}, {-80, 0}, 1, 0);
  row("single alone, by the origin", {"left kidney"}, {50}, 1, 0);
  row("two singles, by each other", {"left kidney", "right femur"}, {450, 520}, 0, 2);
  row("each of several singles", {"left kidney", "left ureter", "spleen", "liver", "right femur"},
      {-70, 40, 80, -60, -90}, 4, 1);
  row("organs by nature", {"liver", "spleen"}, {-50, 50}, 2, 0);
  row("organs by nature, by the spine", {"Leber", "spleen", "sacrum"}, {-50, 50, 0}, 2, 0);
  row("the middle of others is none", {"left kidney", "spleen", "a", "b", "c", "d", "e"},
      {50, 80, 95, 100, 105, 100, 110}, 2, 0);
  row("nor is what grows in the middle", {"left kidney", "spine tumour"}, {50, 80}, 1, 0);
  row("single by the hull", {"left eye", "body"}, {480, 500}, 0, 1);
  row("parts of what lies in the middle", {"left atrium", "right lobe of liver"}, {-5, -20}, 0, 0);
  row("no sides", {"bowel", "bladder"}, {-50, 50}, 0, 0);
  row("too close to say", {"left vein", "right vein", "bowel"}, {0.2, 0.1, 100}, 0, 0);
  row("outvoted", {"left a", "right a", "left b", "right b", "left c", "right c"},
      {50, -50, 40, -40, -10, 10}, 2, 1);
}

void LateralityTest::vote() {
  QFETCH(QStringList, names);
  QFETCH(QList<double>, xs);
  QFETCH(int, lps);
  QFETCH(int, ras);
  std::vector<NamedPosition> places;
  for (qsizetype i = 0; i < names.size(); ++i)
    places.push_back({names[i].toStdString(), float(xs[i])});
  const FrameVote vote = voteOnFrame(places);
  QCOMPARE(vote.lps, lps);
  QCOMPARE(vote.ras, ras);
  QCOMPARE(vote.winner().has_value(), lps != ras);
  // Seen as LPS, the structures with votes against it are those on the other side; a mirror swaps
  // the two.
  // What only the origin tells is no reason to doubt a name.
  QCOMPARE(namedForOtherSide(places).empty(), ras == 0 || vote.byOrigin);
  for (NamedPosition& place : places)
    place.x = -place.x;
  QCOMPARE(namedForOtherSide(places).empty(), lps == 0 || vote.byOrigin);
}

void LateralityTest::clearVotes_data() {
  QTest::addColumn<QStringList>("names");
  QTest::addColumn<QList<double>>("xs");
  QTest::addColumn<bool>("clear");
  const auto row = [](const char* tag, const QStringList& names, const QList<double>& xs,
                      bool clear) { QTest::newRow(tag) << names << xs << clear; };
  row("a pair", {"left kidney", "right kidney"}, {50, -50}, true);
  row("one name", {"left kidney", "sacrum"}, {50, 0}, false);
  row("two names", {"left kidney", "left femur", "sacrum"}, {50, 90, 0}, true);
  row("the origin", {"left kidney", "left femur"}, {50, 90}, false);
  row("each other", {"left kidney", "right femur"}, {50, -90}, true);
  const QStringList pairs{"left a", "right a", "left b", "right b",
                          "left c", "right c", "left d", "right d"};
  row("one in four", pairs, {50, -50, 50, -50, 50, -50, -50, 50}, true);
  row("two in four", pairs, {50, -50, 50, -50, -50, 50, -50, 50}, false);
  row("one in three", pairs.mid(0, 6), {50, -50, 50, -50, -50, 50}, false);
  row("no names", {"a", "b"}, {50, -50}, false);
  row("the hull", {"left kidney", "left femur", "body"}, {50, 90, 0}, false);
  row("others", {"left kidney", "spleen", "a", "b", "c", "d", "e"},
      {50, 80, 95, 100, 105, 100, 110}, false);
  row("hardly beside the middle", {"left kidney", "heart", "sacrum"}, {50, 1.2, 0}, false);
}

void LateralityTest::clearVotes() {
  QFETCH(QStringList, names);
  QFETCH(QList<double>, xs);
  QFETCH(bool, clear);
  std::vector<NamedPosition> places;
  for (qsizetype i = 0; i < names.size(); ++i)
    places.push_back({names[i].toStdString(), float(xs[i]), 0.0f, 10.0f});
  QCOMPARE(voteOnFrame(places).isClear(), clear);
}

void LateralityTest::otherSideNamesTheStructures() {
  const std::vector<NamedPosition> places{{"left kidney", 50},  {"right kidney", -50},
                                          {"left femur", -80},  {"right femur", 80},
                                          {"left ureter", -10}, {"liver", -60}};
  QCOMPARE(namedForOtherSide(places), (std::vector<std::size_t>{2, 3, 4}));
  // What is left and right within one organ has its middle there.
  const std::vector<NamedPosition> liver{
      {"left hepatic vein", -40}, {"right hepatic vein", -70}, {"gallbladder", -50}};
  QCOMPARE(voteOnFrame(liver).ras, 0);
  QVERIFY(namedForOtherSide(liver).empty());
}

void LateralityTest::liverOnTheRight_data() {
  QTest::addColumn<QString>("format");
  QTest::addColumn<int>("written");   // the frame of the coordinates: 0 LPS, 1 RAS
  QTest::addColumn<bool>("header");   // whether the file states it
  QTest::addColumn<bool>("chosen");   // whether the user states it
  QTest::addColumn<bool>("kidneys");  // whether there are names to vote
  for (const char* format : test::meshFormats()) {
    const auto row = [&](const char* what, int written, bool header, bool chosen, bool kidneys) {
      QTest::newRow(qPrintable(QString("%1 %2").arg(format, what)))
          << QString(format) << written << header << chosen << kidneys;
    };
    row("without a word", 0, false, false, false);
    if (QString(format) == "gltf")
      continue;
    row("LPS header", 0, true, false, false);
    row("RAS header", 1, true, false, false);
    row("LPS vote", 0, false, false, true);
    row("RAS vote", 1, false, false, true);
    row("LPS chosen", 0, false, true, false);
    row("RAS chosen", 1, false, true, false);
  }
}

void LateralityTest::liverOnTheRight() {
  QFETCH(QString, format);
  QFETCH(int, written);
  QFETCH(bool, header);
  QFETCH(bool, chosen);
  QFETCH(bool, kidneys);
  const Frame frame = written == 0 ? Frame::lps : Frame::ras;
  const QTemporaryDir folder;
  const auto write = [&](const char* name, const glm::vec3& lps) {
    const glm::vec3 centre = frame == Frame::ras ? halfTurn(lps) : lps;
    test::writeMesh(folder.filePath(QString("%1.%2").arg(name, format)),
                    *test::octahedron(centre, 20.0f), header ? std::optional(frame) : std::nullopt);
  };
  write("liver", {-70, -30, 10});
  write("spleen", {80, 20, 15});
  write("spine", {0, 60, -5});
  if (kidneys) {
    write("left_kidney", {50, 40, -40});
    write("right_kidney", {-50, 40, -45});
  }
  ImportOptions options;
  if (chosen)
    options.frame = frame;
  const auto imported =
      importInputs(std::array{std::filesystem::path(folder.path().toStdString())}, options);
  QVERIFY2(imported.ok(),
           imported ? "" : qPrintable(QString::fromStdString(imported.error().text())));
  const auto centre = [&](const char* name) {
    const Node& node = test::named(imported->scene, name);
    return node.mesh ? node.mesh->bounds().centre() : glm::vec3(1e9f);
  };
  QVERIFY(glm::length(centre("liver") - glm::vec3(-70, -30, 10)) < 0.01f);
  QVERIFY(glm::length(centre("spleen") - glm::vec3(80, 20, 15)) < 0.01f);
  QVERIFY(glm::length(centre("spine") - glm::vec3(0, 60, -5)) < 0.01f);
  QCOMPARE(imported->report.frame, frame);
  const Provenance& provenance = test::named(imported->scene, "liver").provenance;
  QCOMPARE(provenance.frame, frameName(frame));
  const char* const reason = chosen             ? "chosen"
                             : format == "gltf" ? "glTF"
                             : header           ? "SPACE"
                             : kidneys          ? "3 of 3 left/right names"
                                                : "2 of 2 left/right names";
  QVERIFY2(QString::fromStdString(provenance.frameReason).contains(reason),
           provenance.frameReason.c_str());
}

void LateralityTest::fileFrameTouchesNothing() {
  const QTemporaryDir folder;
  ImportOptions options;
  options.frame = Frame::file;
  options.smoothing.mode = Smoothing::Mode::off;
  options.repair = false;
  const MeshPtr mesh = test::octahedron({0.25f, 0.5f, -0.75f}, 0.125f);
  const QString path = folder.filePath("liver.ply");
  test::writeMesh(path, *mesh, Frame::ras);
  const auto imported =
      importInputs(std::array{std::filesystem::path(path.toStdString())}, options);
  QVERIFY(imported.ok());
  QVERIFY(*test::named(imported->scene, "liver").mesh == *mesh);
  QCOMPARE(test::named(imported->scene, "liver").provenance.frame, std::string("file"));
}

void LateralityTest::mirroredFrames() {
  for (const Frame frame : {Frame::las, Frame::rps}) {
    const QTemporaryDir folder;
    ImportOptions options;
    options.frame = frame;
    options.smoothing.mode = Smoothing::Mode::off;
    const QString path = folder.filePath("liver.ply");
    test::writeMesh(path, *test::octahedron({10, 20, 30}, 5.0f), std::nullopt);
    const auto imported =
        importInputs(std::array{std::filesystem::path(path.toStdString())}, options);
    QVERIFY(imported.ok());
    const Node& liver = test::named(imported->scene, "liver");
    const glm::vec3 there = frame == Frame::las ? glm::vec3(10, -20, 30) : glm::vec3(-10, 20, 30);
    QVERIFY(glm::length(liver.mesh->bounds().centre() - there) < 1e-4f);
    QCOMPARE(liver.provenance.frame, frameName(frame));
    // The mirror image is not inside out.
    for (const Triangle& t : liver.mesh->triangles()) {
      const auto& p = liver.mesh->positions();
      const glm::vec3 outward = glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
      QVERIFY(glm::dot(outward, p[t[0]] - there) > 0.0f);
    }
  }
}

void LateralityTest::contradictionIsTold_data() {
  QTest::addColumn<float>("posteriorY");
  QTest::addColumn<QString>("advice");
  QTest::newRow("front and back are right") << 30.0f << "mirrored, choose RPS";
  QTest::newRow("front and back are swapped") << -30.0f << "swapped too: choose RAS";
  QTest::newRow("nothing tells front from back") << 0.0f << "choose RAS where front and back";
}

void LateralityTest::contradictionIsTold() {
  QFETCH(float, posteriorY);
  QFETCH(QString, advice);
  const QTemporaryDir folder;
  // The header says LPS, but left lies at −x.
  const std::pair<const char*, glm::vec3> places[] = {
      {"left kidney", {-50, 0, 0}},
      {"right kidney", {50, 0, 0}},
      {"left femur", {-90, 0, 0}},
      {"right femur", {90, 0, 0}},
      {"anterior limb of internal capsule", {0, -posteriorY, 0}},
      {"posterior limb of internal capsule", {0, posteriorY, 0}}};
  for (const auto& [name, place] : places)
    test::writeMesh(folder.filePath(QString(name) + ".ply"), *test::octahedron(place, 10.0f),
                    Frame::lps);
  const auto imported =
      importInputs(std::array{std::filesystem::path(folder.path().toStdString())}, {});
  QVERIFY(imported.ok());
  QVERIFY(test::warningsOf(*imported).contains("contradict"));
  QVERIFY2(test::warningsOf(*imported).contains(advice), qPrintable(test::warningsOf(*imported)));
  QCOMPARE(imported->report.frame, Frame::lps);
}

SLINE_TEST(LateralityTest)
#include "test_laterality.moc"
