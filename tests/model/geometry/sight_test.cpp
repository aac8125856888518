// SPDX-License-Identifier: Apache-2.0
// Tests which part of a ray planes keep, what it meets of a cut surface, and that each mesh has one
// tree.
#include "model/geometry/sight.h"

#include <QtTest>
#include <array>
#include <glm/geometric.hpp>
#include <random>
#include <thread>

#include "model/geometry/mesh_trees.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

class SightTest : public QObject {
  Q_OBJECT
 private slots:
  void keepsWhatAllPlanesKeep() {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> at(-1.0f, 1.0f);
    const auto anywhere = [&] { return glm::vec3(at(random), at(random), at(random)); };
    int kept = 0;
    for (int i = 0; i < 3000; ++i) {
      std::vector<Plane> planes;
      for (int k = 0; k < i % 4; ++k)
        planes.push_back({glm::normalize(anywhere()), at(random)});
      const Ray ray{anywhere(), glm::normalize(anywhere()), 0.1f, 3.0f};
      const KeptSpan span = keptSpan(ray, planes);
      for (int s = 0; s < 20; ++s) {
        const double t = 0.1 + 2.9 * (double(s) + 0.5) / 20.0;
        const glm::vec3 p = ray.origin + float(t) * ray.direction;
        const bool near = std::any_of(planes.begin(), planes.end(), [&](const Plane& plane) {
          return std::abs(plane.distance(p)) < 1e-5;
        });
        if (near)
          continue;
        const bool within = span.nearest <= t && t <= span.farthest;
        QCOMPARE(within, keptByAll(planes, p));
        kept += within;
      }
      if (!span.empty() && span.entered)
        QVERIFY(std::abs(planes[*span.entered].distance(ray.origin + float(span.nearest) *
                                                                         ray.direction)) < 1e-5);
      if (!span.empty() && span.left)
        QVERIFY(std::abs(planes[*span.left].distance(ray.origin +
                                                     float(span.farthest) * ray.direction)) < 1e-5);
    }
    QVERIFY(kept > 10'000);
  }

  void parallelToAPlane() {
    const std::array planes{Plane{{0, 0, 1}, 0.0f}};
    QVERIFY(keptSpan({{0, 0, 1}, {1, 0, 0}}, planes).empty());
    QVERIFY(!keptSpan({{0, 0, -1}, {1, 0, 0}}, planes).empty());
  }

  void entersThroughTheCutFace() {
    const MeshPtr ball = test::sphere(10.0f, 3);
    const BvhPtr tree = treeOf(ball);
    // The part with z > 0 is taken away; from above one looks onto the face at z = 0.
    const std::array planes{Plane{{0, 0, 1}, 0.0f}};
    const auto face = nearestKept(*tree, {{1, 2, 50}, {0, 0, -1}}, planes);
    QVERIFY(face && face->cutFace);
    QVERIFY(std::abs(face->hit.t - 50.0f) < 1e-4f);
    const auto below = nearestKept(*tree, {{1, 2, -50}, {0, 0, 1}}, planes);
    QVERIFY(below && !below->cutFace && below->hit.t < 41.0f);
    const auto whole = nearestKept(*tree, {{1, 2, 50}, {0, 0, -1}}, {});
    QVERIFY(whole && !whole->cutFace && whole->hit.t < 41.0f);
    QVERIFY(!nearestKept(*tree, {{1, 20, 50}, {0, 0, -1}}, planes));
  }

  void boxesInDoubtAreReached() {
    const Box flat = [] {
      Box box;
      box.add(glm::vec3(-1, -1, 0));
      box.add(glm::vec3(1, 1, 0));
      return box;
    }();
    QVERIFY(reaches({{0, 0, 5}, {0, 0, -1}}, flat));
    QVERIFY(reaches({{-5, 0, 0}, {1, 0, 0}}, flat));  // within the face
    QVERIFY(!reaches({{-5, 0, 1}, {1, 0, 0}}, flat));
    QVERIFY(!reaches({{0, 0, 5}, {0, 0, 1}}, flat));
  }

  void oneTreeForAMesh() {
    const MeshPtr ball = test::sphere(10.0f, 4);
    const std::size_t before = treesInMemory();
    {
      std::array<BvhPtr, 4> held;
      std::vector<std::jthread> threads;
      for (BvhPtr& tree : held)
        threads.emplace_back([&tree, &ball] { tree = treeOf(ball); });
      threads.clear();
      MeshTrees trees;
      QVERIFY(!trees.has(ball));
      const Bvh* again = &trees.of(ball);
      for (const BvhPtr& tree : held)
        QVERIFY(tree && tree.get() == again);
      QCOMPARE(treesInMemory(), before + 1);
      held = {};
      QCOMPARE(&trees.of(ball), again);
      trees.keepOnly({});
      QCOMPARE(treesInMemory(), before);
      trees.of(ball);
      QCOMPARE(treesInMemory(), before + 1);
    }
    QCOMPARE(treesInMemory(), before);
    QCOMPARE(ball.use_count(), 1L);
  }
};

SLINE_TEST(SightTest)
#include "sight_test.moc"
