// SPDX-License-Identifier: Apache-2.0
// Tests how structures relate to those in focus, where geometry leaves no doubt: a ball with a
// vessel that comes to it from a stem, another that passes by, a neighbour, a shell around all and
// something far off.
#include <QTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "model/focus/analysis.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::model {

namespace {

/// Returns a tube between two places, with lids or open.
MeshPtr tube(const glm::vec3& from, const glm::vec3& to, float radius, int around = 16,
             bool lids = true) {
  const glm::vec3 along = glm::normalize(to - from);
  const glm::vec3 u = glm::normalize(
      glm::cross(along, std::abs(along.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0)));
  const glm::vec3 v = glm::cross(along, u);
  const int rings = std::max(2, int(glm::length(to - from) / radius));
  std::vector<glm::vec3> positions;
  for (int i = 0; i <= rings; ++i)
    for (int k = 0; k < around; ++k) {
      const float angle = 2.0f * float(M_PI) * float(k) / float(around);
      positions.push_back(from + (to - from) * (float(i) / float(rings)) +
                          radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
  const auto at = [&](int i, int k) { return std::uint32_t(i * around + k % around); };
  std::vector<Triangle> triangles;
  for (int i = 0; i < rings; ++i)
    for (int k = 0; k < around; ++k) {
      triangles.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
      triangles.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
    }
  for (int k = 1; lids && k + 1 < around; ++k) {
    triangles.push_back({at(0, 0), at(0, k + 1), at(0, k)});
    triangles.push_back({at(rings, 0), at(rings, k), at(rings, k + 1)});
  }
  Result<Mesh> mesh = Mesh::create(std::move(positions), std::move(triangles));
  return std::make_shared<const Mesh>(std::move(*mesh));
}

/// Returns a vessel as two walls without lids, the inner one facing its lumen.
MeshPtr hollowTube(const glm::vec3& from, const glm::vec3& to, float radius) {
  const MeshPtr outer = tube(from, to, radius, 16, false);
  const MeshPtr inner = tube(from, to, 0.85f * radius, 16, false);
  std::vector<Triangle> triangles(inner->triangles().begin(), inner->triangles().end());
  for (Triangle& t : triangles)
    std::swap(t[1], t[2]);
  Result<Mesh> turned =
      Mesh::create(std::vector<glm::vec3>(inner->positions().begin(), inner->positions().end()),
                   std::move(triangles));
  return test::together(*outer, *turned);
}

}  // namespace

class FocusAnalysisTest : public QObject {
  Q_OBJECT

  struct Part {
    std::string name;
    MeshPtr mesh;
    ContextRole role;
  };
  /// Returns the parts; `levels` says how fine the triangles of the balls are.
  static std::vector<Part> parts(int levels = 4) {
    const auto ball = [levels](float radius, const glm::vec3& place) {
      return test::moved(*test::sphere(radius, levels), 1.0f, place);
    };
    return {{"target", ball(20.0f, {0, 0, 0}), ContextRole::target},
            {"vessel", tube({0, 0, 19}, {2, 1, 52}, 1.5f), ContextRole::feeder},
            {"stem", tube({-38, 3, 56}, {38, -3, 56}, 5.0f), ContextRole::feeder},
            {"passing", tube({-45, -22.2f, 0}, {45, -22.2f, 3}, 2.0f), ContextRole::neighbour},
            {"neighbour", ball(8.0f, {28.5f, 0, -2}), ContextRole::neighbour},
            {"shell", ball(75.0f, {3, 2, 1}), ContextRole::shell},
            {"far", ball(5.0f, {-5, 55, -10}), ContextRole::backdrop}};
  }
  static Scene sceneOf(const std::vector<Part>& all) {
    Scene scene;
    for (const Part& part : all)
      scene.append({.name = part.name, .mesh = part.mesh});
    return scene;
  }
  static std::optional<FocusAnalysis> ask(const Scene& scene, const char* target = "target",
                                          const std::optional<Camera>& camera = std::nullopt) {
    FormIndex forms;
    const std::vector<NodeId> ids = scene.named(target);
    return analysed(scene, {ids, camera}, forms);
  }
  static Relation of(const Scene& scene, const FocusAnalysis& analysis, const std::string& name) {
    const NodeId id = scene.named(name).front();
    return *std::find_if(analysis.relations.begin(), analysis.relations.end(),
                         [id](const Relation& r) { return r.structure == id; });
  }
  static void compare(const Scene& a, const Scene& b, float near) {
    const auto one = ask(a);
    const auto other = ask(b);
    QVERIFY(one && other);
    for (const Part& part : parts()) {
      const Relation x = of(a, *one, part.name);
      const Relation y = of(b, *other, part.name);
      const std::string about = part.name + ": gap " + std::to_string(x.gap) + " " +
                                std::to_string(y.gap) + ", hides " + std::to_string(x.hides) + " " +
                                std::to_string(y.hides) + ", outside " + std::to_string(x.outside) +
                                " " + std::to_string(y.outside);
      QVERIFY2(x.role == y.role, about.c_str());
      QVERIFY2(std::abs(x.gap - y.gap) <= near && std::abs(x.hides - y.hides) <= near &&
                   std::abs(x.outside - y.outside) <= near,
               about.c_str());
    }
  }

 private slots:
  /// A vessel modelled as two walls without lids is as much a vessel as a solid one.
  void hollowVesselsAreVessels() {
    std::vector<Part> all = parts();
    all[1].mesh = hollowTube({0, 0, 19}, {2, 1, 52}, 1.5f);
    all[2].mesh = hollowTube({-38, 3, 56}, {38, -3, 56}, 5.0f);
    const std::optional<FocusAnalysis> analysis = ask(sceneOf(all));
    QVERIFY(analysis);
    for (std::size_t i = 0; i < all.size(); ++i)
      QVERIFY2(analysis->relations[i].role == all[i].role, all[i].name.c_str());
  }
  void rolesFollowFromForm_data() {
    QTest::addColumn<int>("index");
    const std::vector<Part> all = parts();
    for (std::size_t i = 0; i < all.size(); ++i)
      QTest::newRow(all[i].name.c_str()) << int(i);
  }
  void rolesFollowFromForm() {
    QFETCH(int, index);
    const std::vector<Part> all = parts();
    const Scene scene = sceneOf(all);
    const auto analysis = ask(scene);
    QVERIFY(analysis);
    QCOMPARE(int(analysis->relations[std::size_t(index)].role), int(all[std::size_t(index)].role));
    QVERIFY(of(scene, *analysis, "stem").reason == RoleReason::feedsStem);
    QVERIFY(of(scene, *analysis, "stem").through == scene.named("vessel").front());
    QVERIFY(of(scene, *analysis, "neighbour").reason == RoleReason::touches);
  }

  /// What comes to the target like a vessel is none where its name says otherwise.
  void namesSayWhatIsNoVessel_data() {
    QTest::addColumn<bool>("feeds");
    for (const char* name : {"vessel", "left renal artery", "carotid", "sciatic nerve",
                             "left ureter", "common bile duct", "surface 12"})
      QTest::newRow(name) << true;
    for (const char* name : {"vertebrae_L3", "Rib6_left", "rib", "third ventricle", "ventricle",
                             "left lateral ventricle", "caudate nucleus", "nuclei", "left-VIIA",
                             "psoas muscle", "costal cartilage", "tumour", "pancreas"})
      QTest::newRow(name) << false;
  }
  void namesSayWhatIsNoVessel() {
    QFETCH(bool, feeds);
    std::vector<Part> all = parts();
    all[1].name = QTest::currentDataTag();
    const Scene scene = sceneOf(all);
    const auto analysis = ask(scene);
    QVERIFY(analysis);
    QCOMPARE(analysis->relations[1].role == ContextRole::feeder, feeds);
  }

  void measuresAreRight() {
    const Scene scene = sceneOf(parts());
    const auto analysis = ask(scene);
    QVERIFY(analysis);
    // Gaps are in units of the ball's radius, apart from the error of its facets.
    QVERIFY(std::abs(of(scene, *analysis, "neighbour").gapMm - 0.57f) < 0.15f);
    QVERIFY(std::abs(of(scene, *analysis, "far").gap - (56.1f - 25.0f) / 20.0f) < 0.02f);
    QVERIFY(of(scene, *analysis, "shell").hides > 0.99f);
    QVERIFY(of(scene, *analysis, "shell").outside > 0.95f);
    // This is the most of a ball's disc that a smaller one in front covers.
    QVERIFY(std::abs(of(scene, *analysis, "neighbour").hides - 64.0f / 400.0f) < 0.06f);
  }

  void mirroredScenesGiveTheMirroredAnswer() {
    std::vector<Part> mirrored = parts();
    for (Part& part : mirrored)
      part.mesh = test::mirrored(*part.mesh);
    compare(sceneOf(parts()), sceneOf(mirrored), 1e-3f);
  }

  void orderChangesNothing() {
    std::vector<Part> turned = parts();
    std::reverse(turned.begin(), turned.end());
    compare(sceneOf(parts()), sceneOf(turned), 1e-5f);
  }

  void finerTrianglesChangeLittle() { compare(sceneOf(parts(3)), sceneOf(parts(5)), 0.05f); }

  void scaleChangesNothing() {
    std::vector<Part> large = parts();
    for (Part& part : large)
      part.mesh = test::moved(*part.mesh, 8.0f, {100, -50, 20});
    compare(sceneOf(parts()), sceneOf(large), 0.02f);
  }

  void groupsCanBeInFocus() {
    Scene scene;
    const NodeId group = scene.append({.name = "pair"});
    const MeshPtr ball = test::sphere(10.0f, 3);
    scene.append({.parent = group, .name = "a", .mesh = ball});
    scene.append({.parent = group, .name = "b", .mesh = test::moved(*ball, 1.0f, {40, 0, 0})});
    scene.append({.name = "c", .mesh = test::moved(*ball, 1.0f, {20.5f, 0, 0})});
    const auto analysis = ask(scene, "pair");
    QVERIFY(analysis);
    QCOMPARE(analysis->targets.size(), std::size_t(2));
    QVERIFY(of(scene, *analysis, "a").role == ContextRole::target);
    QVERIFY(of(scene, *analysis, "c").role == ContextRole::neighbour);
    QVERIFY(of(scene, *analysis, "c").gapMm < 1.0f);
  }

  void theCameraDecidesWhatHides() {
    const Scene scene = sceneOf(parts());
    Camera camera;
    camera.eye = {500, 0, 0};
    const auto before = ask(scene, "target", camera);
    camera.eye = {-500, 0, 0};
    const auto behind = ask(scene, "target", camera);
    QVERIFY(before && behind && before->camera);
    QVERIFY(of(scene, *before, "neighbour").hides > 0.1f);
    QCOMPARE(of(scene, *behind, "neighbour").hides, 0.0f);
    camera.eye = {50, 0, 0};  // inside the shell
    const auto inside = ask(scene, "target", camera);
    QCOMPARE(of(scene, *inside, "shell").hides, 0.0f);
  }

  void whatSectionsTakeAwayHidesNothing() {
    Scene scene = sceneOf(parts());
    Camera camera;
    camera.eye = {0, -500, 0};
    QVERIFY(of(scene, *ask(scene, "target", camera), "shell").hides > 0.99f);
    const NodeId shell = scene.named("shell").front();
    scene.appendSection({.plane = {{0, -1, 0}, 40.0f}, .scope = shell});  // keeps y ≥ −40
    QCOMPARE(of(scene, *ask(scene, "target", camera), "shell").hides, 0.0f);
    scene.appendSection({.plane = {{0, 1, 0}, -100.0f}});  // takes all away
    QVERIFY(!ask(scene));
  }

  void nothingIsAnsweredInVain() {
    const Scene scene = sceneOf(parts());
    FormIndex forms;
    std::stop_source stop;
    stop.request_stop();
    const std::vector<NodeId> target = scene.named("target");
    QVERIFY(!analysed(scene, {target, std::nullopt}, forms, stop.get_token()));
    QVERIFY(!analysed(scene, {{}, std::nullopt}, forms));
    QVERIFY(!analysed({}, {target, std::nullopt}, forms));
  }

  /// The middle of a body that lies askew is found, too: of pairs along its spine and a bladder at
  /// its end, near one hip, both hips count alike.
  void aBodyMayLieAskew() {
    constexpr float angle = 0.7f;
    const auto placed = [](float left, float along, float up, float radius) {
      return test::moved(*test::sphere(radius, 2), 1.0f,
                         {std::cos(angle) * left - std::sin(angle) * along,
                          std::sin(angle) * left + std::cos(angle) * along, up});
    };
    Scene scene;
    const NodeId bladder =
        scene.append({.name = "urinary bladder", .mesh = placed(1.0f, 90.0f, 0.0f, 10.0f)});
    const NodeId left = scene.append({.name = "left kidney", .mesh = placed(18, 90, 0, 6)});
    const NodeId right = scene.append({.name = "right kidney", .mesh = placed(-45, 90, 0, 6)});
    for (const float along : {-90.0f, 0.0f, 90.0f})
      for (const char* side : {"left", "right"})
        scene.append({.name = std::string(side) + " muscle " + char('d' + int(along / 30.0f)),
                      .mesh = placed(side[0] == 'l' ? 80.0f : -80.0f, along, 0, 5)});
    FormIndex forms;
    const auto analysis = analysed(scene, {{&bladder, 1}, std::nullopt}, forms);
    QVERIFY(analysis);
    std::map<std::uint64_t, Relation> relations;
    for (const Relation& relation : analysis->relations)
      relations[relation.structure.value] = relation;
    QCOMPARE(relations[left.value].gap, relations[right.value].gap);
    QVERIFY(relations[left.value].role == relations[right.value].role);
  }
};

}  // namespace sline::model

SLINE_TEST(sline::model::FocusAnalysisTest)
#include "focus_analysis_test.moc"
