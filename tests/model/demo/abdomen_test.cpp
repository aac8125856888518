// SPDX-License-Identifier: Apache-2.0
#include "model/demo/abdomen/abdomen.h"

#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "model/base/parallel.h"
#include "model/demo/demo.h"
#include "model/geometry/bvh.h"
#include "model/geometry/spatial_order.h"
#include "model/geometry/topology.h"
#include "tests/model/demo/demo_measures.h"
#include "tests/support/suite.h"

using namespace sline;
using test::inside;
using test::volumeOf;

namespace {
using model::Box;
using model::Node;

double areaOf(const model::Mesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles())
    sum += double(glm::length(glm::cross(mesh.positions()[b] - mesh.positions()[a],
                                         mesh.positions()[c] - mesh.positions()[a])));
  return 0.5 * sum;
}

std::vector<const Node*> structuresOf(const model::Scene& scene) {
  std::vector<const Node*> all;
  for (const Node& node : scene.nodes())
    if (!node.isGroup())
      all.push_back(&node);
  return all;
}

/// Returns the points of a lattice of `step` mm that the mesh encloses.
std::vector<glm::vec3> pointsInside(const model::Bvh& bvh, const Box& box, float step) {
  std::vector<glm::vec3> points;
  for (float z = box.low.z + 0.31f * step; z < box.high.z; z += step)
    for (float y = box.low.y + 0.47f * step; y < box.high.y; y += step)
      for (float x = box.low.x + 0.53f * step; x < box.high.x; x += step)
        if (inside(bvh, {x, y, z}))
          points.emplace_back(x, y, z);
  return points;
}

struct Size {
  const char* name;
  glm::vec3 low, high;  ///< mm, the least and the greatest extent along each axis
  double leastMl, mostMl;
};
}  // namespace

class AbdomenTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void structuresAndGroups();
  void focusVesselsContext_data();
  void focusVesselsContext();
  void closedAndWhole();
  void hollowOrgans_data();
  void hollowOrgans();
  void overlapsLittle();
  void notBarePrimitives();
  void sizes_data();
  void sizes();
  void neighbours();
  void liverHasItsHollows();
  void shapes_data();
  void shapes();
  void bowelIsOneWay_data();
  void bowelIsOneWay();
  void womanIsSmallerMan();
  void cachedSceneIsTheSame();
  void badCachesAreRemade_data();
  void badCachesAreRemade();

 private:
  const model::Mesh& meshOf(const char* name) const {
    return *m_scene.find(m_scene.named(name).at(0))->mesh;
  }
  glm::vec3 middle(const char* name) const { return meshOf(name).bounds().centre(); }
  QTemporaryDir m_cache;
  model::Scene m_scene;
};

void AbdomenTest::initTestCase() {
  m_scene = model::demo(model::DemoName::abdomen, model::Sex::male, m_cache.path().toStdString());
}

void AbdomenTest::structuresAndGroups() {
  const auto structures = structuresOf(m_scene);
  QVERIFY(structures.size() >= 25);
  std::set<std::string> names;
  std::size_t triangles = 0;
  for (const Node* node : structures) {
    QVERIFY2(names.insert(node->name).second, node->name.c_str());
    QVERIFY2(!m_scene.groupPath(node->id).empty(), node->name.c_str());
    QVERIFY(node->style.colour && node->style.gamma && node->style.fill);
    triangles += node->mesh->triangleCount();
  }
  QVERIFY2(triangles > 150'000 && triangles < 500'000, std::to_string(triangles).c_str());
  for (const char* group : {"Digestive system", "Urinary system", "Arteries", "Veins", "Bones"})
    QCOMPARE(m_scene.named(group).size(), std::size_t(1));
  QCOMPARE(m_scene.views().front().name, std::string("Overview"));
  for (const model::View& view : m_scene.views())
    QVERIFY(!model::cameraFault(view.camera));
}

/// Structures in focus are shaded, vessels are hatched, the rest is drawn in few lines.
void AbdomenTest::focusVesselsContext_data() {
  QTest::addColumn<float>("least");
  QTest::addColumn<float>("most");
  for (const char* name :
       {"liver", "stomach", "Biliary system", "pancreas", "Urinary system", "Glands and spleen"})
    QTest::newRow(name) << 4.0f << 5.0f;
  for (const char* name : {"Arteries", "Veins", "Portal system"})
    QTest::newRow(name) << 3.0f << 3.0f;
  for (const char* name :
       {"Bones", "Discs and cartilage", "Muscles", "transverse colon", "jejunum", "ileum"})
    QTest::newRow(name) << 0.0f << 1.5f;
}

void AbdomenTest::focusVesselsContext() {
  QFETCH(float, least);
  QFETCH(float, most);
  const auto ids = m_scene.structuresBelow(m_scene.named(QTest::currentDataTag()).at(0));
  QVERIFY(!ids.empty());
  for (const model::NodeId id : ids) {
    const float gamma = m_scene.find(id)->style.gamma->value();
    QVERIFY2(gamma >= least && gamma <= most, m_scene.find(id)->name.c_str());
  }
}

void AbdomenTest::closedAndWhole() {
  for (const Node* node : structuresOf(m_scene)) {
    const model::VertexFaces faces(*node->mesh);
    QVERIFY2(model::countEdges(*node->mesh, faces).closed(), node->name.c_str());
    // One body, and perhaps the cavity in it.
    const std::vector<double> parts = test::volumesOfParts(*node->mesh);
    QVERIFY2(parts.size() == 1 || parts.size() == 2, node->name.c_str());
    QVERIFY2(parts.front() > 0.0, node->name.c_str());
    QVERIFY2(parts.size() == 1 || (parts[1] < 0.0 && -parts[1] < parts[0]), node->name.c_str());
  }
}

void AbdomenTest::hollowOrgans_data() {
  QTest::addColumn<double>("leastShare");
  QTest::addColumn<double>("mostShare");
  QTest::newRow("stomach") << 0.5 << 0.85;
  QTest::newRow("duodenum") << 0.35 << 0.8;
  QTest::newRow("jejunum") << 0.35 << 0.8;
  QTest::newRow("ileum") << 0.4 << 0.8;
  QTest::newRow("transverse colon") << 0.5 << 0.85;
  QTest::newRow("gallbladder") << 0.4 << 0.85;
  QTest::newRow("abdominal aorta") << 0.5 << 0.85;
  QTest::newRow("inferior vena cava") << 0.6 << 0.9;
  QTest::newRow("portal vein") << 0.3 << 0.8;
}

/// The cavity takes a certain share of the body.
void AbdomenTest::hollowOrgans() {
  QFETCH(double, leastShare);
  QFETCH(double, mostShare);
  const std::vector<double> parts = test::volumesOfParts(meshOf(QTest::currentDataTag()));
  QCOMPARE(parts.size(), std::size_t(2));
  const double share = -parts[1] / parts[0];
  QVERIFY2(share > leastShare && share < mostShare, std::to_string(share).c_str());
}

void AbdomenTest::overlapsLittle() {
  const auto structures = structuresOf(m_scene);
  std::vector<std::unique_ptr<model::Bvh>> trees;
  for (const Node* node : structures)
    trees.push_back(std::make_unique<model::Bvh>(node->mesh, model::spatialOrder(*node->mesh)));
  std::vector<std::string> complaints(structures.size());
  parallelFor(structures.size(), 1, [&](std::size_t i) {
    const Box& box = structures[i]->mesh->bounds();
    const float volume = float(volumeOf(*structures[i]->mesh));
    const std::vector<glm::vec3> points = pointsInside(*trees[i], box, std::cbrt(volume / 1200.0f));
    for (std::size_t k = 0; k < structures.size(); ++k) {
      if (k == i)
        continue;
      const auto shared = std::count_if(points.begin(), points.end(), [&](const glm::vec3& p) {
        const Box& other = structures[k]->mesh->bounds();
        return glm::all(glm::lessThan(other.low, p)) && glm::all(glm::lessThan(p, other.high)) &&
               inside(*trees[k], p);
      });
      if (double(shared) > 0.01 * double(points.size()))
        complaints[i] += std::to_string(shared) + " of " + std::to_string(points.size()) +
                         " points of " + structures[i]->name + " in " + structures[k]->name + "; ";
    }
  });
  for (const std::string& complaint : complaints)
    QVERIFY2(complaint.empty(), complaint.c_str());
}

/// A ball, box, capsule or ellipsoid is convex; anatomy is not: some of the space that a
/// structure's own points span lies outside it.
void AbdomenTest::notBarePrimitives() {
  for (const Node* node : structuresOf(m_scene)) {
    const model::Mesh& mesh = *node->mesh;
    const model::Bvh bvh(node->mesh, model::spatialOrder(mesh));
    std::size_t outside = 0;
    std::size_t asked = 0;
    const std::size_t count = mesh.vertexCount();
    for (std::size_t i = 0; i < 800; ++i) {
      const glm::vec3 a = mesh.positions()[i * 7919 % count];
      const glm::vec3 b = mesh.positions()[(i * 104729 + count / 2) % count];
      if (glm::distance(a, b) < 0.05f * glm::length(mesh.bounds().size()))
        continue;
      ++asked;
      outside += !inside(bvh, 0.5f * (a + b));
    }
    QVERIFY2(
        outside * 100 > asked,
        (node->name + ": " + std::to_string(outside) + " of " + std::to_string(asked)).c_str());
  }
}

void AbdomenTest::sizes_data() {
  QTest::addColumn<glm::vec3>("low");
  QTest::addColumn<glm::vec3>("high");
  QTest::addColumn<double>("leastMl");
  QTest::addColumn<double>("mostMl");
  // Textbooks give these sizes for adults, with their range.
  const std::array<Size, 13> rows{{{"liver", {190, 130, 130}, {240, 190, 190}, 1000, 2000},
                                   {"spleen", {40, 50, 70}, {100, 110, 130}, 100, 260},
                                   {"left kidney", {40, 35, 95}, {75, 70, 125}, 100, 200},
                                   {"right kidney", {40, 35, 95}, {75, 70, 125}, 100, 200},
                                   {"pancreas", {120, 50, 60}, {200, 110, 130}, 50, 140},
                                   {"gallbladder", {20, 40, 40}, {60, 100, 100}, 20, 60},
                                   {"stomach", {110, 90, 130}, {180, 180, 220}, 300, 900},
                                   {"L3 vertebra", {85, 75, 40}, {105, 90, 60}, 40, 120},
                                   {"T12 vertebra", {45, 65, 35}, {65, 80, 55}, 25, 80},
                                   {"right twelfth rib", {50, 20, 35}, {85, 45, 65}, 2, 10},
                                   {"right adrenal gland", {16, 18, 25}, {28, 40, 42}, 2.5, 8},
                                   {"left adrenal gland", {16, 18, 25}, {28, 40, 50}, 2.5, 8},
                                   {"abdominal aorta", {20, 25, 180}, {50, 70, 260}, 50, 130}}};
  for (const Size& row : rows)
    QTest::newRow(row.name) << row.low << row.high << row.leastMl << row.mostMl;
}

void AbdomenTest::sizes() {
  QFETCH(glm::vec3, low);
  QFETCH(glm::vec3, high);
  QFETCH(double, leastMl);
  QFETCH(double, mostMl);
  const model::Mesh& mesh = meshOf(QTest::currentDataTag());
  const glm::vec3 size = mesh.bounds().size();
  const double ml = test::volumesOfParts(mesh).front() / 1000.0;  // with its cavity
  const std::string is = std::to_string(size.x) + " × " + std::to_string(size.y) + " × " +
                         std::to_string(size.z) + " mm, " + std::to_string(ml) + " ml";
  QVERIFY2(glm::all(glm::greaterThan(size, low)) && glm::all(glm::lessThan(size, high)),
           is.c_str());
  QVERIFY2(ml > leastMl && ml < mostMl, is.c_str());
}

/// Neighbours lie as in LPS: +x to the patient's left, +y to the back, +z to the head.
void AbdomenTest::neighbours() {
  QVERIFY(middle("liver").x < 0 && middle("spleen").x > 0 && middle("stomach").x > 0);
  QVERIFY(middle("inferior vena cava").x < middle("abdominal aorta").x);
  QVERIFY(middle("right kidney").z < middle("left kidney").z);
  QVERIFY(middle("left kidney").x > 0 && middle("left kidney").y > middle("pancreas").y);
  QVERIFY(middle("stomach").y < middle("pancreas").y);
  QVERIFY(middle("gallbladder").z < middle("liver").z);
  QVERIFY(middle("ascending colon").x < middle("transverse colon").x &&
          middle("transverse colon").x < middle("descending colon").x);
  QVERIFY(middle("left adrenal gland").z > middle("left kidney").z);
  QVERIFY(meshOf("superior mesenteric vein").bounds().high.x <
          meshOf("superior mesenteric artery").bounds().high.x);
  QVERIFY(middle("L5 vertebra").z < middle("L1 vertebra").z);
  // The left renal vein crosses in front of the aorta.
  const Box vein = meshOf("left renal vein").bounds();
  QVERIFY(vein.low.x < middle("abdominal aorta").x && vein.high.x > middle("abdominal aorta").x);
}

/// A fair part of the visceral surface, seen from below, is hollow, deeper than the convex dome.
void AbdomenTest::liverHasItsHollows() {
  const model::Mesh& liver = meshOf("liver");
  const double sphere = 36.0 * 3.14159265 * volumeOf(liver) * volumeOf(liver);
  const double sphericity = std::cbrt(sphere) / areaOf(liver);
  QVERIFY2(sphericity > 0.45 && sphericity < 0.80, std::to_string(sphericity).c_str());
  const model::Bvh bvh(m_scene.find(m_scene.named("liver").at(0))->mesh,
                       model::spatialOrder(liver));
  // Gallbladder, right kidney and vena cava lie in hollows: beside their middles on both sides
  // there is liver.
  const glm::vec3 bladder = middle("gallbladder");
  QVERIFY(inside(bvh, bladder + glm::vec3(-28, 0, 22)));
  QVERIFY(inside(bvh, bladder + glm::vec3(18, -6, 30)));
  QVERIFY(!inside(bvh, bladder));
}

void AbdomenTest::shapes_data() {
  QTest::addColumn<QString>("organ");
  QTest::addColumn<glm::vec3>("place");
  QTest::addColumn<bool>("within");
  const auto row = [](const char* name, const char* organ, const glm::vec3& place, bool within) {
    QTest::newRow(name) << QString(organ) << place << within;
  };
  row("gullet", "stomach", {16, -20, 105}, true);
  row("cardial notch", "stomach", {29, -10, 100}, false);
  row("fundus", "stomach", {62, 8, 110}, true);
  row("body at the angular notch", "stomach", {44, -66, -8}, true);
  row("angular notch", "stomach", {23, -70, -2}, false);
  row("antrum", "stomach", {0, -73, -12}, true);
  row("left of the round ligament", "liver", {14, -62, 46}, true);
  row("fissure of the round ligament", "liver", {-5, -66, 36}, false);
  row("quadrate lobe", "liver", {-28, -66, 12}, true);
  row("gastroduodenal artery", "coeliac trunk", {-20, -47, 4}, true);
  row("left hepatic artery", "coeliac trunk", {-20, -34, 49}, true);
  row("jejunal artery", "superior mesenteric artery", {13, -58, -71}, true);
  row("right colic artery", "superior mesenteric artery", {-26, -57, -88}, true);
  row("blade of the spinous process above", "L3 vertebra", {0, 71, -66}, true);
  row("blade of the spinous process below", "L3 vertebra", {0, 71, -82}, true);
  row("vertebral foramen beside the middle", "L3 vertebra", {9, 35, -59}, false);
  row("lamina", "L3 vertebra", {8, 47, -72}, true);
  row("right adrenal gland's lateral leaf", "right adrenal gland", {-51, 32, 29}, true);
  row("between the leaves", "right adrenal gland", {-40, 31, 36}, false);
}

/// Before neighbours press in, notches part what they part.
void AbdomenTest::shapes() {
  QFETCH(QString, organ);
  QFETCH(glm::vec3, place);
  QFETCH(bool, within);
  const auto all = model::abdomenStructures(model::Sex::male);
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const auto& s) { return s.name == organ.toStdString(); });
  QVERIFY(found != all.end());
  const float distance = found->field(place);
  QVERIFY2((distance < 0.0f) == within, std::to_string(distance).c_str());
}

void AbdomenTest::bowelIsOneWay_data() {
  QTest::addColumn<QString>("next");
  QTest::newRow("stomach") << "duodenum";
  QTest::newRow("duodenum") << "jejunum";
  QTest::newRow("jejunum") << "ileum";
  QTest::newRow("ileum") << "ascending colon";
  QTest::newRow("ascending colon") << "transverse colon";
  QTest::newRow("transverse colon") << "descending colon";
  QTest::newRow("descending colon") << "sigmoid colon";
}

/// Each part begins where the one before it ends: a ring of either wall lies close to the other's.
void AbdomenTest::bowelIsOneWay() {
  QFETCH(QString, next);
  const model::Mesh& before = meshOf(QTest::currentDataTag());
  const model::Mesh& after = meshOf(next.toUtf8().constData());
  constexpr float close = 3.5f;  // mm
  Box seam;
  for (const glm::vec3& p : before.positions())
    if (std::any_of(after.positions().begin(), after.positions().end(),
                    [&p](const glm::vec3& q) { return glm::distance(p, q) < close; }))
      seam.add(p);
  QVERIFY(!seam.empty());
  QVERIFY2(glm::length(seam.size()) > 12.0f, std::to_string(glm::length(seam.size())).c_str());
}

void AbdomenTest::womanIsSmallerMan() {
  const model::Scene woman = model::abdomenDemo(model::Sex::female);
  const auto hers = structuresOf(woman);
  const auto his = structuresOf(m_scene);
  QCOMPARE(hers.size(), his.size());
  for (std::size_t i = 0; i < hers.size(); ++i) {
    QCOMPARE(hers[i]->name, his[i]->name);
    const glm::vec3 ratio = hers[i]->mesh->bounds().size() / his[i]->mesh->bounds().size();
    const std::string is = hers[i]->name + ": " + std::to_string(ratio.x) + ", " +
                           std::to_string(ratio.y) + ", " + std::to_string(ratio.z);
    QVERIFY2(glm::length(ratio - 0.93f) < 0.05f, is.c_str());
  }
}

namespace {
void compareScenes(const model::Scene& a, const model::Scene& b) {
  QCOMPARE(a.nodes().size(), b.nodes().size());
  QVERIFY(a.views() == b.views());
  for (std::size_t i = 0; i < a.nodes().size(); ++i) {
    QCOMPARE(a.nodes()[i].name, b.nodes()[i].name);
    QVERIFY(a.nodes()[i].style == b.nodes()[i].style);
    QCOMPARE(a.nodes()[i].isGroup(), b.nodes()[i].isGroup());
    if (!a.nodes()[i].isGroup())
      QVERIFY2(*a.nodes()[i].mesh == *b.nodes()[i].mesh, a.nodes()[i].name.c_str());
  }
}
}  // namespace

void AbdomenTest::cachedSceneIsTheSame() {
  const std::filesystem::path cache = m_cache.path().toStdString();
  const auto file = cache / model::demoCacheFile(model::DemoName::abdomen, model::Sex::male);
  QVERIFY(std::filesystem::exists(file));
  QVERIFY(file != cache / model::demoCacheFile(model::DemoName::abdomen, model::Sex::female));
  const auto written = std::filesystem::last_write_time(file);
  compareScenes(m_scene, model::demo(model::DemoName::abdomen, model::Sex::male, cache));
  QVERIFY(std::filesystem::last_write_time(file) == written);
}

void AbdomenTest::badCachesAreRemade_data() {
  QTest::addColumn<QByteArray>("content");
  QTest::newRow("empty") << QByteArray();
  QTest::newRow("foreign") << QByteArray("ply\nformat ascii 1.0\n");
  QTest::newRow("cut") << QByteArray("PK\3\4\24\0\0\0\10\0", 10);
}

/// This is tested with the kidney, which is the quickest to model.
void AbdomenTest::badCachesAreRemade() {
  QFETCH(QByteArray, content);
  const QTemporaryDir folder;
  const std::filesystem::path cache = folder.path().toStdString();
  const auto file = cache / model::demoCacheFile(model::DemoName::kidney, model::Sex::female);
  std::ofstream(file, std::ios::binary) << content.toStdString();
  const model::Scene scene = model::demo(model::DemoName::kidney, model::Sex::female, cache);
  QCOMPARE(structuresOf(scene).size(), std::size_t(4));
  QVERIFY(std::filesystem::file_size(file) > 100'000);
  // A folder that cannot be made, and no folder at all, change nothing.
  compareScenes(scene, model::demo(model::DemoName::kidney, model::Sex::female, file / "below"));
  compareScenes(scene, model::demo(model::DemoName::kidney, model::Sex::female, {}));
}

SLINE_TEST(AbdomenTest)
#include "abdomen_test.moc"
