// SPDX-License-Identifier: Apache-2.0
// Tests what a scene's JSON is refused for, and that the reason says where.
#include "model/scene_json/scene_json.h"

#include <QtTest>
#include <functional>

#include "tests/model/scene_file/sample_scene.h"
#include "tests/model/scene_file/scene_texts.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

namespace {
using Change = std::function<void(Json&)>;
}  // namespace

class SceneJsonRefusalsTest : public QObject {
  Q_OBJECT
 private slots:
  void refuses_data();
  void refuses();
  void parserRefuses_data();
  void parserRefuses();
};

void SceneJsonRefusalsTest::refuses_data() {
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
      "atoms without a residue", [](Json& j) { j["nodes"][2]["atoms"][1] = "1 2 3 1.7"; },
      "nodes[2].atoms[1]", "a bar");
  row(
      "an atom cut short", [](Json& j) { j["nodes"][2]["atoms"][0] = "LYS A 1 | 1 2 3"; },
      "nodes[2].atoms[0]", "x, y, z");
  row(
      "an atom nowhere", [](Json& j) { j["nodes"][2]["atoms"][0] = "LYS A 1 | nan 2 3 1.7"; },
      "nodes[2].atoms[0]", "x, y, z");
  row(
      "an atom without a size", [](Json& j) { j["nodes"][2]["atoms"][0] = "LYS A 1 | 1 2 3 0"; },
      "nodes[2].atoms[0]", "radius");
  row(
      "too many atoms",
      [](Json& j) {
        std::string text = "LYS A 1 |";
        for (std::size_t i = 0; i <= mostKeptAtoms; ++i)
          text += " 0 0 0 1";
        j["nodes"][2]["atoms"][0] = text;
      },
      "nodes[2].atoms[0]", "more than 60000 atoms");
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
      "no paint of the name", [](Json& j) { j["nodes"][2]["paint"]["file"] = "x"; },
      "nodes[2].paint.file", "no such paint");
  row(
      "paint on a group", [](Json& j) { j["nodes"][0]["paint"] = j["nodes"][2]["paint"]; },
      "nodes[0].paint", "nothing to paint on");
  row(
      "paint of another mesh", [](Json& j) { j["nodes"][4]["paint"] = j["nodes"][2]["paint"]; },
      "nodes[4].paint.file", "it has 162 values, and the mesh 96 vertices");
  row(
      "paint without a file", [](Json& j) { j["nodes"][2]["paint"] = {1}; }, "nodes[2].paint",
      "an object");
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
  const auto map = [&row](const char* name, const char* key, const Json& value, const char* where,
                          const char* reason) {
    row(
        name, [=](Json& j) { j["nodes"][2]["style"]["gamma_by"][key] = value; },
        (std::string("nodes[2].style.gamma_by") + where).c_str(), reason);
  };
  map("an unknown scalar", "scalar", "mood", ".scalar", "another word");
  map("a curve of one point", "curve", Json::parse("[[0, 1]]"), "", "2 to 8");
  map("a curve of many points", "curve", Json(100'000, Json::parse("[0, 1]")), ".curve", "2 to 8");
  map("a point of three numbers", "curve", Json::parse("[[0, 1, 2]]"), ".curve[0]", "2 numbers");
  map("scalars that descend", "curve", Json::parse("[[1, 1], [0, 1]]"), "", "ascend");
  map("an offset beyond 5", "curve", Json::parse("[[0, 1], [1, 5.5]]"), "", "-5 to 5");
  map("many targets", "targets", Json(100'000, 1), ".targets", "1000 targets");
  map("a target below 1", "targets", Json::parse("[0]"), ".targets[0]", "whole number");
  const auto threshold = [&row](const char* name, const Json& value, const char* where,
                                const char* reason) {
    row(
        name, [=](Json& j) { j["nodes"][2]["style"]["line_thresholds"] = value; },
        (std::string("nodes[2].style.line_thresholds") + where).c_str(), reason);
  };
  Json many = Json::object();
  for (int i = 0; i < 1000; ++i)
    many["t" + std::to_string(i)] = 1;
  threshold("thresholds in a list", Json::parse("[1]"), "", "an object");
  threshold("many thresholds", many, "", "at most 64");
  threshold("a threshold below 0", {{"ridges.curvature", -1}}, ".ridges.curvature", "0 to 1000000");
  threshold("a threshold that is text", {{"ridges.curvature", "1"}}, ".ridges.curvature", "number");
  threshold("a threshold with a space", {{"a b", 1}}, ".a b", "small letters");
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
      "more than all context", [](Json& j) { j["focus"]["context"] = 1.5; }, "focus.context",
      "0 to 1");
  row(
      "a focus on a name", [](Json& j) { j["views"][3]["focus"]["targets"] = {"liver"}; },
      "views[3].focus.targets[0]", "whole number");
  row(
      "a role of nothing", [](Json& j) { j["focus"]["roles"]["shell"] = 3; }, "focus.roles.shell",
      "a list");
  row(
      "nearness without end", [](Json& j) { j["focus"]["nearness"]["falloff_mm"] = 1e9; },
      "focus.nearness.falloff_mm", "1 to 2000");
  row(
      "nearness without reach", [](Json& j) { j["focus"]["nearness"].erase("falloff_mm"); },
      "focus.nearness", "\"falloff_mm\" is missing");
  row(
      "nearness to two numbers",
      [](Json& j) {
        j["focus"]["nearness"]["place_mm"] = {1, 2};
      },
      "focus.nearness.place_mm", "list of three numbers");
  row(
      "curvature from a place",
      [](Json& j) { j["nodes"][2]["style"]["gamma_by"]["scalar"] = "painted"; },
      "nodes[2].style.gamma_by", "only distances");
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

void SceneJsonRefusalsTest::refuses() {
  QFETCH(Change, change);
  QFETCH(QString, where);
  QFETCH(QString, reason);
  const Scene scene = test::sampleScene();
  Json json = jsonOf(scene);
  change(json);
  const auto read = sceneFromJson(json, partsByName(scene));
  QVERIFY(!read.ok());
  QCOMPARE(QString::fromStdString(read.error().where), where);
  QVERIFY2(QString::fromStdString(read.error().reason).contains(reason),
           read.error().reason.c_str());
  // Where only a part is at fault, a file opens without that; what is left is written and read.
  std::vector<JsonRefusal> leftOut;
  const auto rest = sceneFromJson(json, partsByName(scene), leftOut);
  const QStringList all{"", "nodes", "format", "schema", "frame", "unit"};
  QCOMPARE(rest.ok(), !all.contains(where));
  if (!rest.ok())
    return;
  QVERIFY(!leftOut.empty());
  QVERIFY2(QString::fromStdString(leftOut[0].where).contains(where), leftOut[0].where.c_str());
  QVERIFY(!QString::fromStdString(leftOut[0].reason).isEmpty());
  const auto again = sceneFromJson(jsonOf(*rest), partsByName(*rest));
  QVERIFY2(again.ok(), again.ok() ? "" : again.error().text().c_str());
  QCOMPARE(difference(*again, *rest), std::string());
}

void SceneJsonRefusalsTest::parserRefuses_data() {
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

void SceneJsonRefusalsTest::parserRefuses() {
  QFETCH(QByteArray, text);
  QFETCH(QString, reason);
  const auto json = parseJson(text.toStdString());
  QCOMPARE(json.ok(), reason.isEmpty());
  if (!json.ok())
    QVERIFY2(QString::fromStdString(json.error().reason).contains(reason),
             json.error().reason.c_str());
}

SLINE_TEST(SceneJsonRefusalsTest)
#include "scene_json_refusals_test.moc"
