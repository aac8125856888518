// SPDX-License-Identifier: Apache-2.0
// Tests that lines hold still while the scene turns (METHOD §11.3, §11.5), and that the measure of
// it finds what pops.
#include "render/measures/line_steadiness.h"

#include <QtTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/import/plan/import.h"
#include "render/measures/line_faults.h"
#include "render/measures/steadiness.h"
#include "render/strokes/line_curves.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::render;

namespace {

constexpr int side = 720;

/// Returns a ball with bumps of several sizes, so that lines of each kind come and go.
model::MeshPtr bumpyBall() {
  const model::MeshPtr ball = test::sphere(40.0f, 6);
  std::vector<glm::vec3> positions(ball->positions().begin(), ball->positions().end());
  for (glm::vec3& p : positions) {
    const glm::vec3 q = p / 40.0f;
    p *= 1.0f + 0.07f * std::sin(4.0f * q.x + 1.0f) * std::sin(5.0f * q.y) +
         0.02f * std::sin(11.0f * q.z + 3.0f * q.x) * std::cos(9.0f * q.y);
  }
  return std::make_shared<const model::Mesh>(
      std::move(model::Mesh::create(std::move(positions),
                                    {ball->triangles().begin(), ball->triangles().end()}))
          .value());
}

model::Scene sceneOf(const std::vector<model::MeshPtr>& meshes) {
  model::Scene scene;
  for (const model::MeshPtr& mesh : meshes) {
    model::Node node;
    node.name = "body";
    node.mesh = mesh;
    node.style.gamma = Gamma::clamped(2.0f);
    node.style.fill = model::Fill::paper;
    node.style.hiddenLines = model::HiddenLines::dashed;
    scene.append(std::move(node));
  }
  return scene;
}

model::Scene madeScene(const QString& name) {
  if (name == "torus")
    return sceneOf({test::askew(*test::torus(30.0f, 10.0f, 240, 96))});
  if (name == "bumps")
    return sceneOf({bumpyBall()});
  return sceneOf({bumpyBall(), test::moved(*test::torus(20.0f, 4.0f, 200, 48), 1.0f, {0, -60, 10}),
                  test::moved(*test::sphere(12.0f, 5), 1.0f, {25, -50, -20})});
}

model::Camera frontOf(const model::Scene& scene) {
  return model::anatomicalCamera(model::AnatomicalView::anterior, scene.visibleBounds(), 1.0f);
}

/// Adds up what happens over that many steps.
LinePops turn(const model::Scene& scene, InkRules rules, int steps, float start) {
  InkFrames frames(scene, side, side);
  const glm::vec3 middle = scene.visibleBounds().centre();
  LinePops sum;
  std::optional<InkFrame> before;
  for (int i = 0; i <= steps; ++i) {
    InkFrame now = frames.at(turned(frontOf(scene), middle, start + turnStep * float(i)), rules);
    if (before) {
      const LinePops pops = popsBetween(*before, now);
      sum.drawn += pops.drawn;
      sum.popped += pops.popped;
      sum.dashes += pops.dashes;
      sum.crawled += pops.crawled;
    }
    before.emplace(std::move(now));
  }
  return sum;
}

QString figures(const LinePops& pops) {
  return QString("%1 % pop, %2 % of the dashes crawl")
      .arg(100.0 * pops.share())
      .arg(100.0 * pops.crawl());
}

/// Returns a picture of the bodies that has all lines, and one with its first long line changed.
template <class Change>
LinePops popsAfter(const Change& change) {
  const model::Scene scene = madeScene("bodies");
  const InkFrame frame = InkFrames(scene, side, side).at(frontOf(scene), InkRules::picture);
  InkFrame changed = frame;
  change(changed);
  return popsBetween(frame, changed);
}

}  // namespace

class LineSteadinessTest : public QObject {
  Q_OBJECT
 private slots:
  void nothingPopsWhereNothingChanges() {
    const LinePops pops = popsAfter([](InkFrame&) {});
    QVERIFY(pops.drawn > 500.0);
    QVERIFY(pops.dashes > 500.0);
    QCOMPARE(pops.popped, 0.0);
    QCOMPARE(pops.crawled, 0.0);
  }
  void whatVanishesIsFound() {
    const LinePops pops = popsAfter([](InkFrame& frame) { frame.structures[1].lines.clear(); });
    QVERIFY2(pops.share() > 0.1, qPrintable(figures(pops)));
  }
  void halfOfTheWeightMayGo_data() {
    QTest::addColumn<float>("share");
    QTest::addColumn<bool>("popping");
    QTest::newRow("a little less") << 0.6f << false;
    QTest::newRow("much less") << 0.4f << true;
  }
  void halfOfTheWeightMayGo() {
    QFETCH(float, share);
    QFETCH(bool, popping);
    const LinePops pops = popsAfter([&](InkFrame& frame) {
      for (InkLine& line : frame.structures[2].lines)
        for (InkPoint& p : line.points)
          p.weight *= share;
    });
    QCOMPARE(pops.popped > 0.0, popping);
  }
  void shortPiecesMayGo() {
    const LinePops pops = popsAfter([](InkFrame& frame) {
      std::vector<InkPoint>& points = frame.structures[2].lines.front().points;
      QVERIFY(points.size() > 100);
      points.erase(points.begin() + 40, points.begin() + 52);
    });
    QCOMPARE(pops.popped, 0.0);
  }
  void whatIsCoveredHasNotVanished() {
    // A body comes before all others at once.
    const model::Scene scene = madeScene("bodies");
    const model::Scene covered =
        sceneOf({bumpyBall(), test::moved(*test::torus(20.0f, 4.0f, 200, 48), 1.0f, {0, -60, 10}),
                 test::moved(*test::sphere(12.0f, 5), 2.0f, {12, -75, -10})});
    const model::Camera camera = frontOf(scene);
    const InkFrame before = InkFrames(scene, side, side).at(camera, InkRules::picture);
    InkFrame after = InkFrames(covered, side, side).at(camera, InkRules::picture);
    after.structures[2].lines = before.structures[2].lines;  // its own outline did move
    const LinePops pops = popsBetween(before, after);
    InkFrame open = after;
    open.layers[2] = before.layers[2];
    QVERIFY(popsBetween(before, open).popped > 50.0);
    QVERIFY2(pops.popped == 0.0, qPrintable(figures(pops)));
  }
  void dashesThatMoveAreFound() {
    const LinePops pops = popsAfter([](InkFrame& frame) {
      for (StructureInk& ink : frame.structures)
        ink.dashes.resize(ink.dashes.size() / 2);
    });
    QVERIFY2(pops.crawl() > 0.15, qPrintable(figures(pops)));
  }

  void linesHoldStill_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<float>("start");
    for (const char* name : {"torus", "bumps", "bodies"})
      for (const float start : {0.0f, 37.0f})
        QTest::addRow("%s from %.0f°", name, double(start)) << name << start;
  }
  void linesHoldStill() {
    QFETCH(QString, name);
    QFETCH(float, start);
    for (const InkRules rules : {InkRules::picture, InkRules::vectors}) {
      const LinePops pops = turn(madeScene(name), rules, 12, start);
      QVERIFY(pops.drawn > 0.0);
      QVERIFY2(pops.share() <= popLimit, qPrintable(figures(pops)));
      QVERIFY2(pops.crawl() <= crawlLimit, qPrintable(figures(pops)));
    }
  }
  void linesOfRealOrgansHoldStill() {
    const std::string folder = std::string(SLINE_TEST_DATA) + "/pelvis/bodyparts3d";
    if (!std::filesystem::exists(folder))
      SLINE_ABSENT("there is no such anatomy here");
    const std::vector<std::filesystem::path> inputs{folder};
    const auto imported = model::importInputs(inputs, {});
    QVERIFY(imported.ok());
    model::Scene scene = imported->scene;
    std::vector<model::Node> nodes = scene.nodes();
    for (model::Node& node : nodes) {
      node.style.gamma = Gamma::clamped(2.0f);
      node.style.fill = model::Fill::paper;
      node.style.hiddenLines = model::HiddenLines::dashed;
    }
    scene.setNodes(std::move(nodes));
    const LinePops pops = turn(scene, InkRules::picture, 6, 0.0f);
    QVERIFY2(pops.share() <= popLimit, qPrintable(figures(pops)));
    QVERIFY2(pops.crawl() <= crawlLimit, qPrintable(figures(pops)));
    CurveFaults faults;
    InkFrames(scene, side, side)
        .forEachCurve(frontOf(scene), [&](const std::string&, const PictureView& view,
                                          const LineSet& exact, const StructureLines& curves) {
          addFaults(view, exact, curves.lines, faults);
        });
    for (const std::vector<float>& distances : faults.distances)
      QVERIFY(percentile(distances, 1.0) <= curveBound);
    QVERIFY(faults.exactWidth > 0.0);
    QVERIFY(std::abs(faults.narrowing()) <= narrowLimit);
  }
};

SLINE_TEST(LineSteadinessTest)
#include "line_steadiness_test.moc"
