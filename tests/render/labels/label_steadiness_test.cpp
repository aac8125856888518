// SPDX-License-Identifier: Apache-2.0
// Measures how often labels jump while the camera turns: at most once in 20° on its way, seldom
// more if none may be left out. If the places of two labels pass each other, one label must go, or
// their leaders would cross.
#include <QDir>
#include <QtTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numeric>
#include <optional>

#include "model/demo/demo.h"
#include "model/import/plan/import.h"
#include "render/labels/anchors.h"
#include "render/labels/seen/seen_map.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::render;

namespace {

constexpr glm::vec2 paper{338.7f, 190.5f};
constexpr int window = 20;  // in degrees
/// A label jumps if it goes this much farther than its place from one degree to the next: more than
/// half a line of text.
constexpr float jump = 2.5f;

model::Camera around(const model::Scene& scene, float degrees) {
  const model::Box box = scene.visibleBounds();
  model::Camera camera =
      model::anatomicalCamera(model::AnatomicalView::anterior, box, 0.6f * paper.x / paper.y);
  const glm::vec3 way = camera.eye - box.centre();
  const float c = std::cos(glm::radians(degrees));
  const float s = std::sin(glm::radians(degrees));
  camera.target = box.centre();
  // The camera is a fifth farther away, so that the scene fits from every side.
  camera.eye = box.centre() + 1.2f * glm::vec3(c * way.x - s * way.y, s * way.x + c * way.y, way.z);
  return camera;
}

/// Adds up to that many labels, on the largest structures.
void label(model::Scene& scene, std::size_t number) {
  std::vector<std::pair<float, model::NodeId>> sizes;
  for (const model::NodeId id : scene.structuresBelow(model::rootId))
    if (scene.resolve(id).visible)
      sizes.emplace_back(-glm::length(scene.find(id)->mesh->bounds().size()), id);
  std::sort(sizes.begin(), sizes.end());
  const Screen screen(around(scene, 0.0f), paper);
  const SeenMap map(scene, screen);
  for (std::size_t i = 0; i < sizes.size() && scene.annotations().size() < number; ++i)
    if (const auto best = map.find(sizes[i].second))
      scene.appendAnnotation(
          {.anchors = {best->anchor}, .text = scene.find(sizes[i].second)->name});
}

struct Jumps {
  int worst = 0;       ///< jumps of any label in any window
  double mean = 0.0;   ///< jumps of a label in a window
  double often = 0.0;  ///< the share of windows in which a label jumps more than once
  double out = 0.0;    ///< the share of labels that are left out
};

/// Turns in steps of a degree, with each layout made from the one before.
class Turn {
 public:
  Turn(std::size_t labels, bool moving) : m_moving(moving), m_jumped(labels), m_seen(labels) {}

  void step(LabelRequest request) {
    request.moving = m_moving;
    const LabelLayout after = layOutLabels(request, m_steps > 0 ? &m_layout : nullptr);
    for (std::size_t i = 0; i < request.items.size(); ++i) {
      const glm::vec2 place = request.items[i].places.front();
      std::optional<Seen>& seen = m_seen[i];
      const PlacedLabel* is = after.find(request.items[i].id);
      m_out += is ? 0 : 1;
      // A label that was gone and comes back where it was has not jumped.
      const bool jumps = is && m_steps > 0 &&
                         (!seen || glm::length(is->box.middle() - seen->middle) >
                                       jump + glm::length(place - seen->place));
      if (m_steps > 0)
        m_jumped[i].push_back(jumps ? 1 : 0);
      if (is)
        seen = Seen{is->box.middle(), place};
    }
    m_layout = after;
    ++m_steps;
  }

  Jumps jumps() const {
    Jumps jumps;
    double all = 0.0;
    double windows = 0.0;
    for (const std::vector<int>& label : m_jumped)
      for (std::size_t i = 0; i + window <= label.size(); ++i) {
        const int inWindow = std::accumulate(label.begin() + std::ptrdiff_t(i),
                                             label.begin() + std::ptrdiff_t(i + window), 0);
        jumps.worst = std::max(jumps.worst, inWindow);
        all += inWindow;
        windows += 1.0;
        jumps.often += inWindow > 1 ? 1.0 : 0.0;
      }
    jumps.mean = windows > 0.0 ? all / windows : 0.0;
    jumps.often = windows > 0.0 ? jumps.often / windows : 0.0;
    jumps.out = double(m_out) / double(std::max<std::size_t>(m_steps * m_jumped.size(), 1));
    return jumps;
  }

 private:
  /// Holds where a label was seen last.
  struct Seen {
    glm::vec2 middle{0.0f};
    glm::vec2 place{0.0f};
  };

  bool m_moving;
  LabelLayout m_layout;
  std::size_t m_steps = 0;
  std::size_t m_out = 0;
  std::vector<std::vector<int>> m_jumped;
  std::vector<std::optional<Seen>> m_seen;
};

/// Turns once round, by camera positions that follow each other and with a camera that keeps
/// moving.
std::pair<Jumps, Jumps> onceRound(const model::Scene& scene) {
  model::MeshTrees trees;
  Turn steps(scene.annotations().size(), false);
  Turn motion(scene.annotations().size(), true);
  for (int degrees = 0; degrees <= 360; ++degrees) {
    const Screen screen(around(scene, float(degrees)), paper);
    LabelRequest request{.items = {},
                         .space = {paper},
                         .obstacles = obstaclesOf(scene, screen),
                         .towardsEye = model::cameraFrame(screen.camera()).back};
    for (ShownLabel& label : shownLabels(scene, screen, {}, trees)) {
      label.item.box = {1.9f * float(label.text.size()) + 2.0f, 4.3f};
      request.items.push_back(label.item);
    }
    if (request.items.size() != scene.annotations().size())
      continue;
    steps.step(request);
    motion.step(request);
  }
  return {steps.jumps(), motion.jumps()};
}

}  // namespace

class LabelSteadinessTest : public QObject {
  Q_OBJECT
 private slots:
  void demoTurns() {
    model::Scene scene = model::demo(model::DemoName::kidney, model::Sex::female, {});
    label(scene, 20);
    judge(scene);
  }
  void pelvisTurns() {
    model::Scene scene =
        model::demo(model::DemoName::pelvis, model::Sex::female, QDir::tempPath().toStdString());
    label(scene, 20);
    QCOMPARE(scene.annotations().size(), std::size_t(20));
    judge(scene);
  }
  void abdomenTurns() {
    const QString file =
        QStringLiteral(SLINE_TEST_DATA "/abdomen/AbdominalAtlas-2015Sept-Slicer4-4Version.mrml");
    if (!QFile::exists(file))
      SLINE_ABSENT("no abdomen atlas here");
    const std::vector<std::filesystem::path> inputs{file.toStdString()};
    auto imported = model::importInputs(inputs, {.smoothing = model::Smoothing{}},
                                        [](double, const std::string&) { return true; });
    QVERIFY(imported.ok());
    label(imported->scene, 20);
    QVERIFY(imported->scene.annotations().size() >= 18);
    judge(imported->scene);
  }

 private:
  static void tell(const char* how, const Jumps& jumps) {
    qInfo(
        "%s: a label jumps %d times in 20 degrees at worst, %.3f times on average, more than once "
        "in %.2f %% of all turns by 20 degrees; %.2f %% left out",
        how, jumps.worst, jumps.mean, 100.0 * jumps.often, 100.0 * jumps.out);
  }

  static void judge(const model::Scene& scene) {
    const auto [steps, motion] = onceRound(scene);
    tell("position by position", steps);
    QVERIFY(steps.worst <= 3);
    QVERIFY(steps.often <= 0.03);
    QVERIFY(steps.mean <= 0.3);
    QCOMPARE(steps.out, 0.0);
    tell("on the way", motion);
    QVERIFY(motion.worst <= 1);
    QVERIFY(motion.worst == 1 || motion.mean == 0.0);
    QVERIFY(motion.out <= 0.03);
  }
};

SLINE_TEST(LabelSteadinessTest)
#include "label_steadiness_test.moc"
