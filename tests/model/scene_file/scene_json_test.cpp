// SPDX-License-Identifier: Apache-2.0
// Tests a scene's JSON: all comes back, in the order described, and what is newer is kept.
#include "model/scene_json/scene_json.h"

#include <QtTest>
#include <clocale>
#include <cmath>
#include <random>

#include "model/scene_json/scene_migration.h"
#include "tests/model/scene_file/sample_scene.h"
#include "tests/model/scene_file/scene_texts.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

class SceneJsonTest : public QObject {
  Q_OBJECT
 private slots:
  void roundTrip();
  void drawnColours();
  void sectionsWithoutFacesAreTinted();
  void keysStandInTheOrderDescribed();
  void unknownKeysAreKeptEverywhere();
  void newerWordsMakeNoFault();
  void restsOfFieldsGoWithThem();
  void numbersAreExact();
  void anotherLocaleChangesNothing();
  void onlyOlderSchemasAreMigrated();
  void namesThatAreNoUtf8();
};

void SceneJsonTest::roundTrip() {
  const Scene scene = test::sampleScene();
  const std::string text = sceneJson(scene);
  const auto again = sceneFromJson(jsonOf(scene), partsByName(scene));
  QVERIFY2(again.ok(), again.ok() ? "" : again.error().text().c_str());
  QCOMPARE(test::difference(scene, *again), std::string());
  QCOMPARE(sceneJson(*again), text);
  const auto empty = sceneFromJson(jsonOf({}), {});
  QVERIFY(empty.ok() && empty->nodes().empty());
}

/// What a drawing style has taken is there when the scene is opened again.
void SceneJsonTest::drawnColours() {
  Scene scene = test::sampleScene();
  std::vector<Node> nodes = scene.nodes();
  nodes[2].drawn = DrawnColour{.given = {255, 255, 255}, .had = Colour{1, 2, 3}};
  nodes[3].drawn = DrawnColour{.given = {10, 0, 200}, .had = {}};
  scene.setNodes(nodes);
  auto json = jsonOf(scene);
  QVERIFY(json["nodes"][2]["drawn_colour"] == Json({{"given", "#ffffff"}, {"had", "#010203"}}));
  QVERIFY(json["nodes"][3]["drawn_colour"] == Json({{"given", "#0a00c8"}}));
  json["nodes"][2]["drawn_colour"]["more"] = 1;
  const auto read = sceneFromJson(json, partsByName(scene));
  QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
  QVERIFY(read->nodes()[2].drawn == nodes[2].drawn && read->nodes()[3].drawn == nodes[3].drawn);
  QVERIFY(jsonOf(*read) == json);
  for (const char* fault : {"{}", "{\"given\": \"white\"}", "7"}) {
    json["nodes"][2]["drawn_colour"] = Json::parse(fault);
    const auto faulty = sceneFromJson(json, partsByName(scene));
    QVERIFY2(!faulty.ok() || !faulty->nodes()[2].drawn, fault);
  }
}

/// Files from before there were patterns look as they did.
void SceneJsonTest::sectionsWithoutFacesAreTinted() {
  const Scene scene = test::sampleScene();
  auto json = jsonOf(scene);
  for (const auto& [said, meant] : {std::pair<const char*, CutFaces>{"off", CutFaces::off},
                                    {"tint", CutFaces::tint},
                                    {"tissue", CutFaces::tissue},
                                    {nullptr, CutFaces::tint}}) {
    json["sections"][0].erase("faces");
    if (said)
      json["sections"][0]["faces"] = said;
    const auto read = sceneFromJson(json, partsByName(scene));
    QVERIFY(read.ok());
    QCOMPARE(read->sections()[0].faces, meant);
  }
}

void SceneJsonTest::keysStandInTheOrderDescribed() {
  const auto root = nlohmann::ordered_json::parse(sceneJson(test::sampleScene()));
  const auto keysOf = [](const nlohmann::ordered_json& object) {
    QStringList keys;
    for (const auto& [key, value] : object.items())
      keys << QString::fromStdString(key);
    return keys.join(' ');
  };
  QCOMPARE(keysOf(root), QString("format schema frame unit nodes sections annotations views focus "
                                 "key_light"));
  QCOMPARE(keysOf(root["focus"]),
           QString("targets context seen_from roles hidden_too nearness given"));
  QCOMPARE(keysOf(root["focus"]["nearness"]), QString("falloff_mm place_mm"));
  QCOMPARE(keysOf(root["nodes"][2]),
           QString("id parent name mesh paint style locked provenance atoms"));
  QCOMPARE(
      keysOf(root["nodes"][2]["style"]),
      QString("colour ink_colour gamma opacity fill visible technique line_thresholds pen_weight "
              "line_variation line_smoothing shortest_line line_scale hidden_lines halo grain "
              "hatch_density hatch_tone gamma_by"));
  QCOMPARE(keysOf(root["nodes"][2]["style"]["gamma_by"]), QString("scalar targets place_mm curve"));
  QCOMPARE(keysOf(root["sections"][0]),
           QString("id name normal offset_mm scope enabled faces hatched"));
  QCOMPARE(keysOf(root["nodes"][2]["provenance"]),
           QString("file frame frame_reason mm_per_unit unit_reason smoothing_steps "
                   "refinement_steps repaired_faces displacement_mm sides front name_evidence "
                   "unit_evidence "
                   "slice_mm decimated_from decimation_mm part fingerprint transform credit "
                   "as_read"));
  QCOMPARE(keysOf(root["views"][1]), QString("name camera sections"));
  QCOMPARE(keysOf(root["views"][3]), QString("name camera looks annotations focus"));
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
  for (Json* object : {&json,
                       &json["nodes"][0],
                       &json["nodes"][2],
                       &json["nodes"][2]["paint"],
                       &json["focus"]["nearness"],
                       &json["nodes"][2]["mesh"],
                       &json["nodes"][2]["style"],
                       &json["nodes"][2]["style"]["gamma_by"],
                       &json["nodes"][2]["provenance"],
                       &json["sections"][0],
                       &json["views"][0],
                       &json["views"][0]["camera"],
                       &json["views"][1]["sections"][0],
                       &json["views"][3]["looks"][0],
                       &json["views"][3]["looks"][0]["style"],
                       &json["annotations"][0],
                       &json["annotations"][0]["at"],
                       &json["annotations"][1]["to"],
                       &json["nodes"][2]["provenance"]["fingerprint"],
                       &json["key_light"],
                       &json["focus"],
                       &json["focus"]["seen_from"],
                       &json["focus"]["roles"],
                       &json["focus"]["given"][0],
                       &json["views"][3]["focus"]})
    (*object)["from the future"] = extra;
  json["nodes"][1]["style"] = {{"from the future", extra}};  // a style with nothing known in it
  const auto again = sceneFromJson(json, partsByName(scene));
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

void SceneJsonTest::newerWordsMakeNoFault() {
  const Scene scene = test::sampleScene();
  Json json = jsonOf(scene);
  json["nodes"][2]["style"]["fill"] = "hologram";
  const auto asOurs = sceneFromJson(json, partsByName(scene));
  QVERIFY(!asOurs.ok() && asOurs.error().where == "nodes[2].style.fill");
  json["schema"] = sceneSchema + 1;
  json["nodes"][2]["style"]["from the future"] = 1;
  const auto asNewer = sceneFromJson(json, partsByName(scene));
  QVERIFY(asNewer.ok());
  QVERIFY(!asNewer->nodes()[2].style.fill);
  // In a file of this schema the word would be at fault, so that it stays away; a key stays.
  const Json written = jsonOf(*asNewer);
  json["nodes"][2]["style"].erase("fill");
  QVERIFY(written["nodes"][2] == json["nodes"][2]);
  QVERIFY(sceneFromJson(written, partsByName(scene)).ok());
}

/// What a newer program adds to a field is of no use, and at fault, once the field is gone.
void SceneJsonTest::restsOfFieldsGoWithThem() {
  const Scene scene = test::sampleScene();
  Json json = jsonOf(scene);
  for (Json* object : {&json["nodes"][2]["paint"], &json["nodes"][2]["style"]["gamma_by"],
                       &json["nodes"][2]["provenance"]["fingerprint"], &json["focus"]["seen_from"],
                       &json["focus"]["nearness"]})
    (*object)["from the future"] = 1;
  const auto read = sceneFromJson(json, partsByName(scene));
  QVERIFY(read.ok());
  Scene edited = *read;
  std::vector<Node> nodes = edited.nodes();
  nodes[2].paint.reset();
  nodes[2].style.gammaMap.reset();
  nodes[2].provenance.fingerprint.reset();
  edited.setNodes(std::move(nodes));
  Focus focus = edited.focus();
  focus.seenFrom.reset();
  focus.nearness.reset();
  edited.setFocus(focus);
  const Json written = jsonOf(edited);
  const auto again = sceneFromJson(written, partsByName(edited));
  QVERIFY2(again.ok(), again.ok() ? "" : again.error().text().c_str());
  QVERIFY(!written["nodes"][2].contains("paint") && !written["focus"].contains("nearness"));
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
  const auto again = sceneFromJson(jsonOf(scene), partsByName(scene));
  std::setlocale(LC_ALL, before.c_str());
  if (!found)
    QSKIP("no locale with a decimal comma is installed");
  QCOMPARE(there, text);
  QVERIFY(again.ok());
  QCOMPARE(test::difference(scene, *again), std::string());
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
