// SPDX-License-Identifier: Apache-2.0
#include "model/scene_file/scene_json.h"

#include <QtTest>
#include <clocale>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "model/scene_file/scene_migration.h"
#include "tests/model/scene_file/sample_scene.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {
MeshesByName meshesByName(const Scene& scene) {
  MeshesByName meshes;
  for (const auto& [mesh, name] : meshNames(scene))
    meshes[name] = mesh;
  return meshes;
}

Json jsonOf(const Scene& scene) {
  const auto json = parseJson(sceneJson(scene));
  return json.ok() ? *json : Json();
}

using Change = std::function<void(Json&)>;
}  // namespace
Q_DECLARE_METATYPE(Change)

class SceneJsonTest : public QObject {
  Q_OBJECT
 private slots:
  void roundTrip();
  void keysStandInTheOrderDescribed();
  void unknownKeysAreKeptEverywhere();
  void newerWordsAreKept();
  void numbersAreExact();
  void anotherLocaleChangesNothing();
  void refuses_data();
  void refuses();
  void parserRefuses_data();
  void parserRefuses();
  void onlyOlderSchemasAreMigrated();
  void namesThatAreNoUtf8();
};

void SceneJsonTest::roundTrip() {
  const Scene scene = test::sampleScene();
  const std::string text = sceneJson(scene);
  const auto again = sceneFromJson(jsonOf(scene), meshesByName(scene));
  QVERIFY2(again.ok(), again.ok() ? "" : again.error().text().c_str());
  QCOMPARE(test::difference(scene, *again), std::string());
  QCOMPARE(sceneJson(*again), text);
  const auto empty = sceneFromJson(jsonOf({}), {});
  QVERIFY(empty.ok() && empty->nodes().empty());
}

void SceneJsonTest::keysStandInTheOrderDescribed() {
  const auto root = nlohmann::ordered_json::parse(sceneJson(test::sampleScene()));
  const auto keysOf = [](const nlohmann::ordered_json& object) {
    QStringList keys;
    for (const auto& [key, value] : object.items())
      keys << QString::fromStdString(key);
    return keys.join(' ');
  };
  QCOMPARE(keysOf(root),
           QString("format schema frame unit nodes sections annotations views key_light"));
  QCOMPARE(keysOf(root["nodes"][2]), QString("id parent name mesh style locked provenance"));
  QCOMPARE(
      keysOf(root["nodes"][2]["style"]),
      QString("colour ink_colour gamma opacity fill visible pen_weight hatch_density hatch_tone"));
  QCOMPARE(keysOf(root["sections"][0]), QString("id name normal offset_mm scope enabled hatched"));
  QCOMPARE(keysOf(root["nodes"][2]["provenance"]),
           QString("file frame frame_reason mm_per_unit unit_reason smoothing_steps "
                   "refinement_steps repaired_faces displacement_mm decimated_from decimation_mm "
                   "part fingerprint transform"));
  QCOMPARE(keysOf(root["views"][1]), QString("name camera sections"));
  QCOMPARE(keysOf(root["views"][3]), QString("name camera looks annotations"));
  QCOMPARE(keysOf(root["annotations"][0]),
           QString("id kind at text texts colour visible locked offset"));
  QCOMPARE(keysOf(root["annotations"][1]), QString("id kind at to text visible locked"));
  QCOMPARE(keysOf(root["annotations"][0]["at"]), QString("structure triangle weights"));
  // A mesh that two structures share is named twice and written once.
  QCOMPARE(root["nodes"][2]["mesh"]["file"].dump(), root["nodes"][3]["mesh"]["file"].dump());
}

void SceneJsonTest::unknownKeysAreKeptEverywhere() {
  const Scene scene = test::sampleScene();
  Json json = jsonOf(scene);
  const Json extra = {{"list", {1, 2.5, "x", nullptr}}, {"deep", {{"er", true}}}};
  for (Json* object :
       {&json, &json["nodes"][0], &json["nodes"][2], &json["nodes"][2]["mesh"],
        &json["nodes"][2]["style"], &json["nodes"][2]["provenance"], &json["sections"][0],
        &json["views"][0], &json["views"][0]["camera"], &json["views"][1]["sections"][0],
        &json["views"][3]["looks"][0], &json["views"][3]["looks"][0]["style"],
        &json["annotations"][0], &json["annotations"][0]["at"], &json["annotations"][1]["to"],
        &json["nodes"][2]["provenance"]["fingerprint"], &json["key_light"]})
    (*object)["from the future"] = extra;
  json["nodes"][1]["style"] = {{"from the future", extra}};  // a style with nothing known in it
  const auto again = sceneFromJson(json, meshesByName(scene));
  QVERIFY2(again.ok(), again.ok() ? "" : again.error().text().c_str());
  QVERIFY(!again->nodes()[0].unread.empty());
  QVERIFY(jsonOf(*again) == json);
  // A node's unknown members go where the node goes, and overrule no known value.
  std::vector<Node> nodes = again->nodes();
  nodes[2].style.gamma = Gamma::clamped(1.0f);
  Scene edited = *again;
  edited.setNodes({nodes[0], nodes[1], nodes[2]});
  Json expected = json["nodes"][2];
  expected["style"]["gamma"] = 1.0;
  QVERIFY(jsonOf(edited)["nodes"][2] == expected);
}

void SceneJsonTest::newerWordsAreKept() {
  const Scene scene = test::sampleScene();
  Json json = jsonOf(scene);
  json["nodes"][2]["style"]["fill"] = "hologram";
  const auto asOurs = sceneFromJson(json, meshesByName(scene));
  QVERIFY(!asOurs.ok() && asOurs.error().where == "nodes[2].style.fill");
  json["schema"] = sceneSchema + 1;
  const auto asNewer = sceneFromJson(json, meshesByName(scene));
  QVERIFY(asNewer.ok());
  QVERIFY(!asNewer->nodes()[2].style.fill);
  QVERIFY(jsonOf(*asNewer)["nodes"][2] == json["nodes"][2]);
}

void SceneJsonTest::numbersAreExact() {
  std::mt19937 random(5);
  const auto same = [](float value) {
    const Json json = Json::parse(Json(jsonNumber(value)).dump());
    JsonFault fault;
    const float again = JsonValue(json, fault).number();
    return !fault.any() &&
           std::bit_cast<std::uint32_t>(again) == std::bit_cast<std::uint32_t>(value);
  };
  for (const float value : {0.0f, -0.0f, 0.1f, 1e-45f, 1.17549435e-38f, 3.4028235e38f, 16777217.0f,
                            7.0385307e-26f, -1.0f / 3.0f})
    QVERIFY2(same(value), std::to_string(value).c_str());
  for (int i = 0; i < 200'000; ++i) {
    const auto value = std::bit_cast<float>(std::uint32_t(random()));
    QVERIFY(!std::isfinite(value) || same(value));
  }
  QCOMPARE(Json(jsonNumber(0.1f)).dump(), std::string("0.1"));
}

void SceneJsonTest::anotherLocaleChangesNothing() {
  const Scene scene = test::sampleScene();
  const std::string text = sceneJson(scene);
  const std::string before = std::setlocale(LC_ALL, nullptr);
  bool found = false;
  for (const char* name :
       {"de_DE.UTF-8", "de_DE.utf8", "nl_NL.UTF-8", "fr_FR.UTF-8", "nb_NO.UTF-8"})
    found = found || (std::setlocale(LC_ALL, name) && std::localeconv()->decimal_point[0] == ',');
  const std::string there = sceneJson(scene);
  const auto again = sceneFromJson(jsonOf(scene), meshesByName(scene));
  std::setlocale(LC_ALL, before.c_str());
  if (!found)
    QSKIP("no locale with a decimal comma is installed");
  QCOMPARE(there, text);
  QVERIFY(again.ok());
  QCOMPARE(test::difference(scene, *again), std::string());
}

void SceneJsonTest::refuses_data() {
  QTest::addColumn<Change>("change");
  QTest::addColumn<QString>("where");
  QTest::addColumn<QString>("reason");
  const auto row = [](const char* name, const Change& change, const char* where,
                      const char* reason) {
    QTest::newRow(name) << change << QString(where) << QString(reason);
  };
  row(
      "no list", [](Json& j) { j["nodes"] = 3; }, "nodes", "a list");
  row(
      "no nodes", [](Json& j) { j.erase("nodes"); }, "", "\"nodes\" is missing");
  row(
      "another format", [](Json& j) { j["format"] = "mesh"; }, "format", "no scene of Sline");
  row(
      "a schema of 0", [](Json& j) { j["schema"] = 0; }, "schema", "whole number");
  row(
      "another frame", [](Json& j) { j["frame"] = "RAS"; }, "frame", "\"LPS\"");
  row(
      "another unit", [](Json& j) { j["unit"] = "m"; }, "unit", "\"mm\"");
  row(
      "a list as node", [](Json& j) { j["nodes"][0] = {1}; }, "nodes[0]", "an object");
  row(
      "no id", [](Json& j) { j["nodes"][0].erase("id"); }, "nodes[0]", "\"id\" is missing");
  row(
      "an id of 0", [](Json& j) { j["nodes"][0]["id"] = 0; }, "nodes[0].id", "whole number");
  row(
      "an id too large", [](Json& j) { j["nodes"][0]["id"] = UINT64_MAX; }, "nodes[0].id", "whole");
  row(
      "an id of 1.5", [](Json& j) { j["nodes"][0]["id"] = 1.5; }, "nodes[0].id", "whole number");
  row(
      "an id twice", [](Json& j) { j["nodes"][2]["id"] = 1; }, "nodes[2]", "same id");
  row(
      "a strange parent", [](Json& j) { j["nodes"][2]["parent"] = 77; }, "nodes[2]", "parent");
  row(
      "a mesh as parent", [](Json& j) { j["nodes"][3]["parent"] = 3; }, "nodes[3]", "parent");
  row(
      "its own parent", [](Json& j) { j["nodes"][0]["parent"] = 1; }, "nodes[0]", "parent");
  row(
      "a number as name", [](Json& j) { j["nodes"][0]["name"] = 1; }, "nodes[0].name", "a text");
  row(
      "no mesh of the name", [](Json& j) { j["nodes"][2]["mesh"]["file"] = "x"; },
      "nodes[2].mesh.file", "no such mesh");
  row(
      "another count", [](Json& j) { j["nodes"][2]["mesh"]["triangles"] = 1; },
      "nodes[2].mesh.triangles", "the mesh has");
  row(
      "gamma beyond 5", [](Json& j) { j["nodes"][2]["style"]["gamma"] = 5.01; },
      "nodes[2].style.gamma", "0 to 5");
  row(
      "a huge number", [](Json& j) { j["nodes"][2]["style"]["pen_weight"] = 1e300; },
      "nodes[2].style.pen_weight", "too large");
  row(
      "a colour by name", [](Json& j) { j["nodes"][2]["style"]["colour"] = "red"; },
      "nodes[2].style.colour", "#rrggbb");
  row(
      "a colour with a bad digit", [](Json& j) { j["nodes"][2]["style"]["colour"] = "#12g456"; },
      "nodes[2].style.colour", "#rrggbb");
  row(
      "1 as flag", [](Json& j) { j["nodes"][2]["style"]["visible"] = 1; }, "nodes[2].style.visible",
      "true or false");
  row(
      "negative steps", [](Json& j) { j["nodes"][2]["provenance"]["smoothing_steps"] = -1; },
      "nodes[2].provenance.smoothing_steps", "whole number");
  row(
      "a normal of two",
      [](Json& j) {
        j["sections"][0]["normal"] = {1, 0};
      },
      "sections[0].normal", "three numbers");
  row(
      "a long normal",
      [](Json& j) {
        j["sections"][0]["normal"] = {1, 1, 0};
      },
      "sections[0]", "unit vector");
  row(
      "a section twice", [](Json& j) { j["sections"].push_back(j["sections"][0]); }, "sections[1]",
      "same id");
  row(
      "eye in target",
      [](Json& j) { j["views"][0]["camera"]["eye_mm"] = j["views"][0]["camera"]["target_mm"]; },
      "views[0].camera", "same point");
  row(
      "a text in a point", [](Json& j) { j["views"][0]["camera"]["up"][1] = "0"; },
      "views[0].camera.up[1]", "a number");
  row(
      "a view's section", [](Json& j) { j["views"][1]["sections"][0]["offset_mm"] = nullptr; },
      "views[1].sections[0].offset_mm", "a number");
  row(
      "an unknown kind", [](Json& j) { j["annotations"][0]["kind"] = "balloon"; },
      "annotations[0].kind", "\"label\"");
  row(
      "an annotation twice", [](Json& j) { j["annotations"][1]["id"] = 4; }, "annotations[1]",
      "same id");
  row(
      "an annotation nowhere", [](Json& j) { j["annotations"][0].erase("at"); }, "annotations[0]",
      "\"at\" is missing");
  row(
      "a distance to nowhere", [](Json& j) { j["annotations"][1].erase("to"); }, "annotations[1]",
      "\"to\" is missing");
  row(
      "on no structure", [](Json& j) { j["annotations"][0]["at"]["structure"] = 77; },
      "annotations[0]", "no structure");
  row(
      "on a group", [](Json& j) { j["annotations"][0]["at"]["structure"] = 1; }, "annotations[0]",
      "no structure");
  row(
      "on a triangle too many", [](Json& j) { j["annotations"][0]["at"]["triangle"] = 1'000'000; },
      "annotations[0]", "no structure");
  row(
      "beside its triangle",
      [](Json& j) {
        j["annotations"][0]["at"]["weights"] = {0.75, 0.5};
      },
      "annotations[0]", "none in a triangle");
  row(
      "three weights",
      [](Json& j) {
        j["annotations"][0]["at"]["weights"] = {0, 0, 1};
      },
      "annotations[0].at.weights", "2 numbers");
  row(
      "a number as text", [](Json& j) { j["annotations"][0]["texts"]["la"] = 1; },
      "annotations[0].texts.la", "a text");
  row(
      "texts in a list", [](Json& j) { j["annotations"][0]["texts"] = {"Arteria"}; },
      "annotations[0].texts", "an object");
  row(
      "a text moved to nowhere",
      [](Json& j) {
        j["annotations"][0]["offset"] = {1.0e6, 0};
      },
      "annotations[0]", "farther away");
  row(
      "an offset of one number", [](Json& j) { j["annotations"][0]["offset"] = {1}; },
      "annotations[0].offset", "2 numbers");
  row(
      "a look twice", [](Json& j) { j["views"][3]["looks"][1]["node"] = 3; }, "views[3].looks[1]",
      "twice");
  row(
      "a look at nothing", [](Json& j) { j["views"][3]["looks"][0].erase("node"); },
      "views[3].looks[0]", "\"node\" is missing");
  row(
      "a name among ids", [](Json& j) { j["views"][3]["annotations"][0] = "Artery"; },
      "views[3].annotations[0]", "whole number");
  row(
      "a light from nowhere",
      [](Json& j) {
        j["key_light"]["towards"] = {0, 0, 0};
      },
      "key_light", "unit vector");
  row(
      "a checksum too long",
      [](Json& j) { j["nodes"][2]["provenance"]["fingerprint"]["crc32"] = 1LL << 32; },
      "nodes[2].provenance.fingerprint.crc32", "whole number");
  row(
      "a transform of two",
      [](Json& j) {
        j["nodes"][2]["provenance"]["transform"] = {1, 0};
      },
      "nodes[2].provenance.transform", "12 numbers");
}

void SceneJsonTest::refuses() {
  QFETCH(Change, change);
  QFETCH(QString, where);
  QFETCH(QString, reason);
  const Scene scene = test::sampleScene();
  Json json = jsonOf(scene);
  change(json);
  const auto read = sceneFromJson(json, meshesByName(scene));
  QVERIFY(!read.ok());
  QCOMPARE(QString::fromStdString(read.error().where), where);
  QVERIFY2(QString::fromStdString(read.error().reason).contains(reason),
           read.error().reason.c_str());
}

void SceneJsonTest::parserRefuses_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("reason");
  QByteArray keys = "{";
  for (int i = 0; i < 5000; ++i)
    keys += "\"" + QByteArray::number(i) + "\":0,";
  keys += "\"x\":0}";
  QTest::newRow("nothing") << QByteArray() << "unexpected end";
  QTest::newRow("cut") << QByteArray("{\"a\": [1, 2") << "unexpected end";
  QTest::newRow("more after it") << QByteArray("{} {}") << "end of input";
  QTest::newRow("no UTF-8") << QByteArray("{\"a\": \"\xff\"}") << "UTF-8";
  QTest::newRow("a number beyond all") << QByteArray("[1e999]") << "overflow";
  QTest::newRow("deep") << QByteArray(100'000, '[') << "deep in each other";
  QTest::newRow("many values") << QByteArray("[") + QByteArray(5'000'000, ',') << "values";
  QTest::newRow("many keys") << keys << "keys";
  QTest::newRow("brackets in texts do not count")
      << QByteArray("[\"") + QByteArray(1000, '[') + "\\\"" + QByteArray(1000, '{') + "\"]"
      << "";
}

void SceneJsonTest::parserRefuses() {
  QFETCH(QByteArray, text);
  QFETCH(QString, reason);
  const auto json = parseJson(text.toStdString());
  QCOMPARE(json.ok(), reason.isEmpty());
  if (!json.ok())
    QVERIFY2(QString::fromStdString(json.error().reason).contains(reason),
             json.error().reason.c_str());
}

void SceneJsonTest::onlyOlderSchemasAreMigrated() {
  for (const int schema : {sceneSchema, sceneSchema + 1}) {
    Json root = {{"format", "sline scene"}, {"schema", schema}, {"old", 7}};
    const Json before = root;
    QVERIFY(migrate(root).ok() && root == before);
  }
  Json ancient = {{"format", "sline scene"}, {"schema", 0}};
  const Status stuck = migrate(ancient);
  QVERIFY(!stuck.ok() && stuck.error().where == "schema");
}

void SceneJsonTest::namesThatAreNoUtf8() {
  Scene scene;
  scene.append({.name = "M\xfcller"});
  const auto again = sceneFromJson(jsonOf(scene), {});
  QVERIFY(again.ok());
  QCOMPARE(again->nodes()[0].name, std::string("M\xef\xbf\xbdller"));
}

SLINE_TEST(SceneJsonTest)
#include "scene_json_test.moc"
