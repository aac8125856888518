// SPDX-License-Identifier: Apache-2.0
// Tests that what is written can be read: scenes with values at every limit and beyond it come
// through every door of the model, are saved and opened, and are then as they were kept.
#include <QtTest>
#include <map>
#include <set>

#include "model/packed_scene/packed_scene.h"
#include "model/scene/scene_limits.h"
#include "model/scene/style_fields.h"
#include "model/scene_file/journal_content.h"
#include "model/scene_file/scene_file.h"
#include "model/scene_json/scene_json.h"
#include "tests/model/scene_file/limit_cases.h"
#include "tests/model/scene_file/sample_scene.h"
#include "tests/model/scene_file/scene_texts.h"
#include "tests/support/memory_requests.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

/// Counts the scenes that went through each door, and of which the limits are.
struct Tally {
  std::map<std::string, int> doors;
  std::set<std::string> fields;
  std::set<std::string> fieldsBeyond;
};

/// Returns how the scene differs once it was saved and opened.
std::string afterSaving(const Scene& scene) {
  const auto bytes = sceneFileBytes({.scene = scene});
  if (!bytes.ok())
    return "not written: " + bytes.error().text();
  const auto document = documentFromBytes(*bytes);
  if (!document.ok())
    return "not read: " + document.error().text();
  if (!document->leftOut.empty())
    return "left out: " + document->leftOut[0];
  if (document->scene.scans().size() != scene.scans().size())
    return "scans";
  for (std::size_t i = 0; i < scene.scans().size(); ++i) {
    Scan a = document->scene.scans()[i];
    const Scan& b = scene.scans()[i];
    if (*a.voxels != *b.voxels)
      return "voxels";
    a.voxels = b.voxels;
    if (a != b)
      return "scan " + b.name;
  }
  return test::difference(document->scene, scene);
}

SceneParts partsOf(const Scene& scene) {
  SceneParts parts = test::partsByName(scene);
  for (std::size_t n = 0; n < scene.scans().size(); ++n)
    parts.voxels[voxelsName(n)] = scene.scans()[n].voxels;
  return parts;
}

}  // namespace

class LimitsTest : public QObject {
  Q_OBJECT
 private slots:
  void everyValueThroughEveryDoor();
  void longestScenesAreRead();
  void editsOfLargeScenesAreLookedAtAlone();
  void tooLargeScenesAreRefusedBeforeTheyAreWritten();

 private:
  static std::string throughReader(const Scene& made, bool within);
  static std::string throughEdit(const Scene& made, bool within);
  static std::string throughGuard(const Scene& made, bool within);
  static std::string throughFile(const Scene& made, bool within);
  static std::string throughJournal(const Scene& made, bool within);
  static std::string throughPage(const Scene& made, bool within);
};

/// A reader of other files mends what it made, and tells of it.
std::string LimitsTest::throughReader(const Scene& made, bool within) {
  Scene scene = made;
  std::vector<SceneMending> mended;
  if (const Status kept = bringWithinLimits(scene, mended); !kept.ok())
    return within || kept.error().reason.empty() ? "refused: " + kept.error().text() : "";
  if (within != mended.empty())
    return within ? "mended: " + mended[0].text() : "not mended";
  if (within && !(scene == made))
    return "changed without a word";
  for (const SceneMending& each : mended)
    if (each.fault.empty() || each.done.empty())
      return "mended without a word";
  return afterSaving(scene);
}

/// An edit is refused, or made as it is meant.
std::string LimitsTest::throughEdit(const Scene& made, bool within) {
  const std::optional<Error> fault = limitFault(made);
  if (fault.has_value() == within)
    return within ? "refused: " + fault->text() : "not refused";
  if (fault)
    return fault->reason.empty() || fault->remedy.empty() ? "refused without a reason" : "";
  return afterSaving(made);
}

/// Saving writes what can be read, or nothing.
std::string LimitsTest::throughGuard(const Scene& made, bool within) {
  const auto bytes = sceneFileBytes({.scene = made});
  if (bytes.ok())
    return afterSaving(made);
  return within || bytes.error().reason.empty() ? "refused: " + bytes.error().text() : "";
}

/// A file that another program wrote, with the value in it, opens without the value.
std::string LimitsTest::throughFile(const Scene& made, bool within) {
  const auto json = parseJson(sceneJson(made), sceneJsonLimits);
  if (!json.ok())
    return within ? "no JSON: " + json.error().text() : "";
  std::vector<JsonRefusal> leftOut;
  const auto read = sceneFromJson(*json, partsOf(made), leftOut);
  if (!read.ok())
    return within || read.error().reason.empty() ? "refused: " + read.error().text() : "";
  if (within && !leftOut.empty())
    return "left out: " + leftOut[0].where + ": " + leftOut[0].reason;
  return afterSaving(*read);
}

std::string LimitsTest::throughJournal(const Scene& made, bool within) {
  if (!within)
    return "";  // no edit brings it there
  BulkKeys keys;
  const std::string text = stateText(made, keys);
  std::vector<JsonRefusal> leftOut;
  const auto back = sceneOfState(text, bulkOf(made), leftOut);
  if (!leftOut.empty())
    return "left out: " + leftOut[0].text();
  return back.ok() ? test::difference(*back, made) : "lost: " + back.error().text();
}

std::string LimitsTest::throughPage(const Scene& made, bool within) {
  if (!within)
    return "";
  const PackedScene packed = packedScene(made, {});
  UnpackedScene page;
  const Status read = page.take(packed.first);
  return read.ok() ? "" : "no page: " + read.error().text();
}

void LimitsTest::everyValueThroughEveryDoor() {
  const std::vector<std::pair<const char*, std::string (*)(const Scene&, bool)>> doors{
      {"reader", throughReader}, {"edit", throughEdit},       {"saving", throughGuard},
      {"file", throughFile},     {"journal", throughJournal}, {"page", throughPage}};
  Tally tally;
  QStringList wrong;
  int scenes = 0;
  for (const test::LimitCase& each : test::limitCases()) {
#ifndef NDEBUG
    if (each.asserted)
      continue;
#endif
    Scene scene = test::sampleScene();
    each.put(scene);
    ++scenes;
    tally.fields.insert(each.field);
    if (!each.within)
      tally.fieldsBeyond.insert(each.field);
    for (const auto& [name, door] : doors) {
      if (each.slow && (name == std::string("page") || name == std::string("file")))
        continue;
      const std::string fault = door(scene, each.within);
      ++tally.doors[name];
      if (!fault.empty())
        wrong << QString::fromStdString(each.field + " = " + each.value + ", " + name + ": " +
                                        fault);
    }
  }
  for (const auto& [door, count] : tally.doors)
    qInfo("%s: %d scenes", door.c_str(), count);
  qInfo("%d scenes of %zu fields, %zu of them beyond their limits", scenes, tally.fields.size(),
        tally.fieldsBeyond.size());
  QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
  QVERIFY(tally.fields.size() >= 80 && tally.fieldsBeyond.size() >= 75);
}

/// Many views of many structures say much, and a scene with them must open.
void LimitsTest::longestScenesAreRead() {
  Scene scene = test::sampleScene();
  std::vector<Node> nodes = scene.nodes();
  while (nodes.size() < 5000)
    nodes.push_back({.id = {nodes.size() + 1}, .name = "structure", .mesh = nodes[2].mesh});
  scene.setNodes(std::move(nodes));
  Style whole = answersOf(scene.resolve(NodeId{3}));
  View view{.name = "One", .looks = std::vector<Look>{}};
  for (const Node& node : scene.nodes())
    view.looks->push_back({.node = node.id, .style = whole});
  scene.setViews(std::vector<View>(40, view));
  QVERIFY(!limitFault(scene));
  const auto bytes = sceneFileBytes({.scene = scene});
  QVERIFY2(bytes.ok(), bytes.ok() ? "" : bytes.error().text().c_str());
  const auto document = documentFromBytes(*bytes);
  QVERIFY2(document.ok(), document.ok() ? "" : document.error().text().c_str());
  QCOMPARE(document->scene.views().size(), std::size_t(40));
  QVERIFY(document->leftOut.empty());
}

/// An edit is looked at without the rest of a large scene, and nothing that it breaks is missed.
void LimitsTest::editsOfLargeScenesAreLookedAtAlone() {
  Scene scene = test::sampleScene();
  std::vector<Node> nodes = scene.nodes();
  Node more = nodes[2];
  more.parent = rootId;
  while (nodes.size() < 5000) {
    more.id = {nodes.size() + 1};
    nodes.push_back(more);
  }
  scene.setNodes(std::move(nodes));
  QVERIFY(!limitFault(scene));
  const auto edited = [&scene](const auto& change) {
    std::vector<Node> changed = scene.nodes();
    change(changed);
    Scene after = scene;
    after.setNodes(std::move(changed));
    return after;
  };
  const Scene renamed = edited([](std::vector<Node>& all) { all[4000].name = "another"; });
  const auto requests = [](const auto& work) {
    const std::uint64_t before = test::memoryRequests();
    work();
    return test::memoryRequests() - before;
  };
  const std::uint64_t whole = requests([&] { QVERIFY(!limitFault(renamed)); });
  const std::uint64_t alone = requests([&] { QVERIFY(!limitFault(renamed, scene)); });
  qInfo("an edit among 5,000 structures: %llu requests for memory, without what was there %llu",
        static_cast<unsigned long long>(whole), static_cast<unsigned long long>(alone));
  QVERIFY(2 * alone < whole);
  const auto isRefused = [&scene](const Scene& after) { return limitFault(after, scene); };
  QVERIFY(isRefused(edited([](auto& all) { all[4000].name = std::string(1001, 'x'); })));
  QVERIFY(isRefused(
      edited([](auto& all) { all.push_back({.id = {9000}, .name = std::string(1001, 'x')}); })));
  QVERIFY(isRefused(edited([](auto& all) {
    for (std::size_t i = 0; i <= deepestSceneGroup; ++i)
      all.push_back({.id = {9000 + i}, .parent = i == 0 ? rootId : all.back().id, .name = "deep"});
  })));
  // A label stays where its structure went.
  QVERIFY(isRefused(edited([](auto& all) { all.erase(all.begin() + 2); })));
  Scene wordy = scene;
  std::vector<View> views = wordy.views();
  views[0].name = std::string(1001, 'x');
  wordy.setViews(std::move(views));
  QVERIFY(isRefused(wordy));
}

void LimitsTest::tooLargeScenesAreRefusedBeforeTheyAreWritten() {
  Scene scene;
  // Each text is within its limit; together they are not.
  const std::string text(longestSceneText, '\x01');  // which JSON writes with six letters
  View view{.name = "One"};
  view.words.text.text = text;
  scene.setViews(std::vector<View>(1000, view));
  QVERIFY(!limitFault(scene));
  const auto bytes = sceneFileBytes({.scene = scene});
  QVERIFY(!bytes.ok());
  QVERIFY2(bytes.error().reason.find("too large for a scene file") != std::string::npos,
           bytes.error().text().c_str());
  QVERIFY(!bytes.error().remedy.empty());
}

SLINE_TEST(LimitsTest)
#include "limits_test.moc"
