// SPDX-License-Identifier: Apache-2.0
#include "model/scene_file/scene_file.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>
#include <random>

#include "model/disk/whole_file.h"
#include "model/scene_file/fingerprint.h"
#include "model/scene_json/json_value.h"
#include "model/scene_json/scene_json.h"
#include "tests/model/scene_file/sample_scene.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
namespace fs = std::filesystem;

namespace {
std::string sampleFile() {
  auto bytes = sceneFileBytes({.scene = test::sampleScene(), .thumbnail = "no real picture"});
  return bytes.ok() ? std::move(*bytes) : std::string();
}

/// The same with a scan and a member of others.
std::string fullFile() {
  Scene scene = test::sampleScene();
  Scan scan{.name = "CT"};
  scan.size = {4, 3, 2};
  scan.voxels = std::make_shared<const std::vector<std::int16_t>>(24, std::int16_t(7));
  scene.setScans({scan});
  const auto bytes = sceneFileBytes(
      {.scene = scene, .thumbnail = "no real picture", .others = {{"notes.txt", "mine"}}});
  return bytes.ok() ? *bytes : std::string();
}

/// Changes a byte of the packed member.
std::string damaged(std::string file, const std::string& name) {
  constexpr std::size_t beforeName = 30;  // a member's own header
  const std::size_t at = file.find(name, beforeName);
  const auto extra = static_cast<unsigned char>(file[at - 2]);
  char& byte = file[at + name.size() + extra + 2];
  byte = char(byte ^ 0x10);
  return file;
}

std::string newerFile() {
  const std::string file = sampleFile();
  Json root = Json::parse(test::memberOf(file, "scene.json"));
  root["schema"] = sceneSchema + 1;
  root["narrations"] = {{{"text", "liver"}, {"picture", "pictures/1.png"}}};
  return test::withMember(test::withMember(file, "scene.json", root.dump()), "pictures/1.png",
                          "a picture");
}
}  // namespace

class SceneFileTest : public QObject {
  Q_OBJECT
 private slots:
  void roundTrip();
  void savingAgainGivesTheSameBytes();
  void storedExampleOfEachSchema_data();
  void storedExampleOfEachSchema();
  void newerFileIsForReading();
  void unknownMembersAreKept();
  void refuses_data();
  void refuses();
  void whatIsAtFaultIsLeftOut_data();
  void whatIsAtFaultIsLeftOut();
  void aDamagedMeshLeavesAnEmptyRow();
  void whatIsKnownToBeWholeIsNotReadAgain();
  void everyCutIsRefused();
  void mutationsNeverCrash();
  void extensions();
};

void SceneFileTest::roundTrip() {
  const auto document = documentFromBytes(sampleFile());
  QVERIFY2(document.ok(), document.ok() ? "" : document.error().text().c_str());
  QCOMPARE(test::difference(document->scene, test::sampleScene()), std::string());
  QCOMPARE(document->thumbnail, std::string("no real picture"));
  QCOMPARE(document->schema, sceneSchema);
  QVERIFY(document->others.empty() && !document->isNewer() && document->warning().empty());
  // A shared mesh is shared again, and ids go on where they were.
  const auto& nodes = document->scene.nodes();
  QVERIFY(nodes[2].mesh == nodes[3].mesh);
  const NodeId added = Scene(document->scene).append({.name = "new"});
  QVERIFY(!test::sampleScene().find(added));
}

void SceneFileTest::savingAgainGivesTheSameBytes() {
  std::string bytes = sampleFile();
  for (int round = 0; round < 20; ++round) {
    const auto document = documentFromBytes(bytes);
    QVERIFY(document.ok());
    const auto again = sceneFileBytes(*document);
    QVERIFY(again.ok() && *again == bytes);
    bytes = *again;
  }
}

void SceneFileTest::storedExampleOfEachSchema_data() {
  QTest::addColumn<QString>("file");
  const QDir examples(SLINE_EXAMPLES);
  for (const QString& name : examples.entryList({"*.sline"}, QDir::Files))
    QTest::newRow(qPrintable(name)) << examples.filePath(name);
  QCOMPARE(int(examples.entryList({"*.sline"}, QDir::Files).size()), sceneSchema);
}

void SceneFileTest::storedExampleOfEachSchema() {
  QFETCH(QString, file);
  const auto document = readSceneFile(file.toStdString());
  QVERIFY2(document.ok(), document.ok() ? "" : document.error().text().c_str());
  QCOMPARE(test::difference(document->scene, test::sampleScene()), std::string());
}

void SceneFileTest::newerFileIsForReading() {
  const QTemporaryDir folder;
  const fs::path file = folder.filePath("a.sline").toStdString();
  QVERIFY(writeText(file, newerFile()).ok());
  const auto document = readSceneFile(file);
  QVERIFY2(document.ok(), document.ok() ? "" : document.error().text().c_str());
  QVERIFY(document->isNewer());
  QVERIFY(document->warning().find("newer version") != std::string::npos);
  const Status over = writeSceneFile(file, *document);
  QVERIFY(!over.ok() && over.error().remedy.find("another name") != std::string::npos);
  QVERIFY(!writeSceneFile(file, {}).ok());  // whatever is saved there
  QCOMPARE(*readText(file, 1 << 20), newerFile());
  // Under another name it keeps members that this version does not know.
  const fs::path other = folder.filePath("b.sline").toStdString();
  QVERIFY(writeSceneFile(other, *document).ok());
  const std::string saved = *readText(other, 1 << 20);
  Json expected = Json::parse(test::memberOf(newerFile(), "scene.json"));
  expected["schema"] = sceneSchema;
  QVERIFY(Json::parse(test::memberOf(saved, "scene.json")) == expected);
  QCOMPARE(test::memberOf(saved, "pictures/1.png"), std::string("a picture"));
}

void SceneFileTest::unknownMembersAreKept() {
  const std::string file = test::withMember(sampleFile(), "notes/by hand.txt", "keep me");
  const auto document = documentFromBytes(file);
  QVERIFY(document.ok());
  const auto saved = sceneFileBytes(*document);
  QVERIFY(saved.ok());
  QCOMPARE(test::memberOf(*saved, "notes/by hand.txt"), std::string("keep me"));
}

void SceneFileTest::refuses_data() {
  QTest::addColumn<QByteArray>("bytes");
  QTest::addColumn<QString>("message");
  const auto row = [](const char* name, const std::string& bytes, const char* message) {
    QTest::newRow(name) << QByteArray::fromStdString(bytes) << QString(message);
  };
  const std::string good = sampleFile();
  row("no ZIP file", "solid cube", "no whole ZIP file");
  row("nothing", "", "it is empty");
  const ZipMember member{"word/document.xml", "<w/>"};
  row("a document of others", *zipped({&member}), "holds no scene.json");
  row("no JSON", test::withMember(good, "scene.json", "[1,"), "scene.json: byte 4");
  row("another JSON", test::withMember(good, "scene.json", "{}"), "\"format\" is missing");
  row("a damaged scene.json", damaged(good, "scene.json"), "scene.json: it is cut or damaged");
  Json root = Json::parse(test::memberOf(good, "scene.json"));
  root["frame"] = "RAS";
  row("another frame", test::withMember(good, "scene.json", root.dump()),
      "scene.json: frame: \"LPS\" is expected here");
}

void SceneFileTest::whatIsAtFaultIsLeftOut_data() {
  QTest::addColumn<QByteArray>("bytes");
  QTest::addColumn<QString>("message");
  const auto row = [](const char* name, const std::string& bytes, const char* message) {
    QTest::newRow(name) << QByteArray::fromStdString(bytes) << QString(message);
  };
  const std::string good = fullFile();
  row("a broken mesh", test::withMember(good, "meshes/3.mesh", "x"),
      "\"Ärterie \"a\"\" (nodes[2].mesh.file): meshes/3.mesh: it is no mesh of this format; "
      "the structure stays as an empty row");
  row("broken paint", test::withMember(good, "paint/3.paint", "x"),
      "(nodes[2].paint.file): paint/3.paint: it does not begin like what is painted");
  row("a broken scan", test::withMember(good, "scans/1.scan", "x"),
      "(scans[0].voxels): scans/1.scan: it does not begin like the voxels");
  row("a damaged mesh", damaged(good, "meshes/3.mesh"),
      "(nodes[2].mesh.file): meshes/3.mesh: it is cut or damaged");
  row("damaged paint", damaged(good, "paint/3.paint"),
      "(nodes[2].paint.file): paint/3.paint: it is cut or damaged");
  row("a damaged scan", damaged(good, "scans/1.scan"),
      "(scans[0].voxels): scans/1.scan: it is cut or damaged");
  row("a damaged picture", damaged(good, "thumbnail.png"), "thumbnail.png: it is cut or damaged");
  row("a damaged member of others", damaged(good, "notes.txt"), "notes.txt: it is cut or damaged");
  row("paint of too few", test::withMember(good, "paint/3.paint", "SlinePa1\x01\x02"),
      "\"Ärterie \"a\"\" (nodes[2].paint.file): it has 2 values");
  row("paint of too many",
      test::withMember(good, "paint/3.paint", "SlinePa1" + std::string(1'000'000, '\1')),
      "(nodes[2].paint.file): it has 1000000 values");
  const Json whole = Json::parse(test::memberOf(good, "scene.json"));
  const auto changed = [&](const char* name, const char* message, const auto& change) {
    Json root = whole;
    change(root);
    row(name, test::withMember(good, "scene.json", root.dump()), message);
  };
  changed("a value out of range", "(nodes[2].style.gamma): a number from 0 to 5 is expected here",
          [](Json& root) { root["nodes"][2]["style"]["gamma"] = 7; });
  changed("a mesh elsewhere", "(nodes[2].mesh.file): the file holds no such mesh",
          [](Json& root) { root["nodes"][2]["mesh"]["file"] = "../secret"; });
  changed("a long licence", "(nodes[2].provenance.credit.licence): a line of at most 300 bytes",
          [](Json& root) {
            root["nodes"][2]["provenance"]["credit"]["licence"] = std::string(301, 'x');
          });
  changed("a long name", "the name is longer than 1000 bytes; it was cut there",
          [](Json& root) { root["nodes"][0]["name"] = std::string(1001, 'x'); });
  changed("many faults", "and 2 more", [](Json& root) {
    for (const char* key : {"halo", "grain", "fill", "technique", "opacity"})
      root["nodes"][2]["style"][key] = "?";
  });
}

/// The rest opens; the file stays as it is, and saved under another name the scene is whole.
void SceneFileTest::whatIsAtFaultIsLeftOut() {
  QFETCH(QByteArray, bytes);
  QFETCH(QString, message);
  const QTemporaryDir folder;
  const fs::path file = folder.filePath("a.sline").toStdString();
  QVERIFY(writeText(file, bytes.toStdString()).ok());
  const auto document = readSceneFile(file);
  QVERIFY2(document.ok(), document.ok() ? "" : document.error().text().c_str());
  QVERIFY(document->isForReading() && !document->isNewer());
  QVERIFY2(QString::fromStdString(document->warning()).contains(message),
           document->warning().c_str());
  QVERIFY(document->scene.nodes().size() >= 4 && document->scene.views().size() == 4);
  for (const SceneDocument& saved : {*document, SceneDocument()}) {
    const Status over = writeSceneFile(file, saved);
    QVERIFY(!over.ok());
    QCOMPARE(over.error().remedy, std::string("Save under another name"));
  }
  QCOMPARE(*readText(file, std::size_t(1) << 24), bytes.toStdString());
  const fs::path other = folder.filePath("b.sline").toStdString();
  QVERIFY(writeSceneFile(other, *document).ok());
  const auto again = readSceneFile(other);
  QVERIFY(again.ok() && !again->isForReading());
  QCOMPARE(test::difference(again->scene, document->scene), std::string());
  QVERIFY(writeSceneFile(other, *again).ok());
}

void SceneFileTest::aDamagedMeshLeavesAnEmptyRow() {
  const Scene whole = test::sampleScene();
  const auto document = documentFromBytes(damaged(sampleFile(), "meshes/3.mesh"));
  QVERIFY2(document.ok(), document.ok() ? "" : document.error().text().c_str());
  QCOMPARE(document->scene.nodes().size(), whole.nodes().size());
  for (std::size_t i = 0; i < whole.nodes().size(); ++i) {
    const Node& node = document->scene.nodes()[i];
    QCOMPARE(node.id, whole.nodes()[i].id);
    QCOMPARE(node.parent, whole.nodes()[i].parent);
    QCOMPARE(node.name, whole.nodes()[i].name);
    QVERIFY(node.style == whole.nodes()[i].style);
    // The mesh of the node 3, which others may share.
    const bool empty = whole.nodes()[i].isGroup() || whole.nodes()[i].mesh == whole.nodes()[2].mesh;
    QCOMPARE(node.isGroup(), empty);
  }
}

/// A file of which all was read need not be read again before it is written over, as long as it is
/// that file; of another one it is not known.
void SceneFileTest::whatIsKnownToBeWholeIsNotReadAgain() {
  const QTemporaryDir folder;
  const fs::path file = folder.filePath("a.sline").toStdString();
  QVERIFY(writeText(file, sampleFile()).ok());
  auto document = readSceneFile(file);
  QVERIFY(document.ok() && document->whole == *fingerprintOfFile(file));
  QVERIFY(writeText(file, damaged(sampleFile(), "meshes/3.mesh")).ok());
  QVERIFY(!writeSceneFile(file, *document).ok());
  QVERIFY(!readSceneFile(file)->whole);
  // Whoever says that it is whole is believed: nothing of it is unpacked.
  document->whole = *fingerprintOfFile(file);
  QVERIFY(writeSceneFile(file, *document).ok());
}

void SceneFileTest::refuses() {
  QFETCH(QByteArray, bytes);
  QFETCH(QString, message);
  const QTemporaryDir folder;
  const fs::path file = folder.filePath("a.sline").toStdString();
  QVERIFY(writeText(file, bytes.toStdString()).ok());
  const auto document = readSceneFile(file);
  QVERIFY(!document.ok());
  QCOMPARE(document.error().file, file.string());
  QVERIFY(!document.error().remedy.empty());
  QVERIFY2(QString::fromStdString(document.error().text()).contains(message),
           document.error().text().c_str());
}

void SceneFileTest::everyCutIsRefused() {
  const std::string bytes = sampleFile();
  for (std::size_t size = 0; size < bytes.size(); size += size < 200 ? 1 : 61)
    QVERIFY2(!documentFromBytes(std::string_view(bytes).substr(0, size)).ok(),
             std::to_string(size).c_str());
}

/// Bytes are changed, cut out and put in, in the ZIP file and – packed again, so that they get past
/// its checksums – in scene.json and in a mesh. Each change gives a scene or a message.
void SceneFileTest::mutationsNeverCrash() {
  const std::string good = sampleFile();
  const std::string json = test::memberOf(good, "scene.json");
  const std::string mesh = test::memberOf(good, "meshes/3.mesh");
  std::mt19937 random(11);
  const auto mutated = [&random](std::string bytes) {
    constexpr std::string_view telling = "[]{}\",:-0e9\xff\x80\x01\x7f";
    for (std::size_t changes = 1 + random() % 4; changes > 0 && !bytes.empty(); --changes) {
      const std::size_t at = random() % bytes.size();
      const std::size_t length = 1 + random() % 8;
      switch (random() % 4) {
        case 0:
          bytes[at] = char(bytes[at] ^ (1 << random() % 8));
          break;
        case 1:
          bytes[at] = telling[random() % telling.size()];
          break;
        case 2:
          bytes.erase(at, length);
          break;
        default:
          bytes.insert(at, bytes.substr(random() % bytes.size(), length));
      }
    }
    return bytes;
  };
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::string bytes = i % 3 == 0   ? mutated(good)
                              : i % 3 == 1 ? test::withMember(good, "scene.json", mutated(json))
                                           : test::withMember(good, "meshes/3.mesh", mutated(mesh));
    const auto document = documentFromBytes(bytes);
    refused += !document.ok();
    QVERIFY(document.ok() || !document.error().reason.empty());
    QVERIFY(!document.ok() || sceneFileBytes(*document).ok());
  }
  QVERIFY2(refused > 1000, std::to_string(refused).c_str());
}

void SceneFileTest::extensions() {
  QVERIFY(isSceneFile("a.sline") && isSceneFile("b/A.SLINE"));
  QVERIFY(!isSceneFile("sline") && !isSceneFile("a.sline.ply") && !isSceneFile(""));
}

SLINE_TEST(SceneFileTest)
#include "scene_file_test.moc"
