// SPDX-License-Identifier: Apache-2.0
#include "model/demo/kidney/kidney.h"

#include <QtTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/geometry/bvh.h"
#include "model/geometry/spatial_order.h"
#include "model/geometry/surface.h"
#include "model/geometry/topology.h"
#include "model/sculpting/implicit.h"
#include "model/sculpting/polygonise.h"
#include "tests/model/demo/demo_measures.h"
#include "tests/support/suite.h"

using namespace sline;
using test::inside;

class KidneyTest : public QObject {
  Q_OBJECT
 private slots:
  void polygonisedSphere() {
    const auto mesh = model::polygonise([](const glm::vec3& p) { return glm::length(p) - 10.0f; },
                                        {glm::vec3(-13), glm::vec3(13)}, 0.8f);
    const auto surface = model::prepareSurface(mesh);
    QVERIFY(surface->closed);
    for (std::size_t v = 0; v < mesh->vertexCount(); ++v) {
      QVERIFY(std::abs(glm::length(mesh->positions()[v]) - 10.0f) < 1e-3f);
      QVERIFY(glm::dot(surface->normals[v], mesh->positions()[v]) > 0.0f);
    }
    QVERIFY(std::abs(surface->filigreeSize - 10.0f) < 0.2f);
  }

  void tubeHasItsRadius() {
    const std::array<model::TubePoint, 3> through{
        {{{0, 0, 0}, 2.0f}, {{20, 0, 0}, 2.0f}, {{40, 0, 0}, 2.0f}}};
    const model::Tube tube(through);
    QVERIFY(std::abs(tube.distance({17, 0, 5}) - 3.0f) < 1e-4f);
    QVERIFY(std::abs(tube.distance({45, 0, 0}) - 3.0f) < 1e-4f);
    QVERIFY(tube.distance({17, 0, 1}) < 0.0f);
  }

  void fourClosedStructuresInTwoGroups() {
    const model::Scene scene = model::kidneyDemo();
    QCOMPARE(scene.structuresBelow(model::rootId).size(), std::size_t(4));
    for (const model::Node& node : scene.nodes()) {
      if (node.isGroup())
        continue;
      const auto surface = model::prepareSurface(node.mesh);
      QVERIFY2(surface->closed, node.name.c_str());
      // The kidney is solid, vessels and ureter are hollow.
      const std::vector<double> parts = test::volumesOfParts(*node.mesh);
      QCOMPARE(parts.size(), std::size_t(node.name == "left kidney" ? 1 : 2));
      QVERIFY(parts.front() > 0.0);
      QVERIFY(parts.size() == 1 || parts.back() < 0.0);
    }
    const auto kidney = scene.find(scene.named("left kidney").front())->mesh;
    const glm::vec3 size = kidney->bounds().size();
    QVERIFY(size.z > 90 && size.z < 125 && size.x > 40 && size.x < 70 && size.y > 30 &&
            size.y < 50);
    // In a left kidney the vessels come from the patient's right, which is −x.
    const auto artery = scene.find(scene.named("left renal artery").front())->mesh;
    QVERIFY(artery->bounds().centre().x < kidney->bounds().centre().x);
  }

  // No vertex of one structure lies inside another.
  void structuresDoNotOverlap() {
    const model::Scene scene = model::kidneyDemo();
    for (const model::Node& a : scene.nodes()) {
      if (a.isGroup())
        continue;
      const model::Bvh bvh(a.mesh, model::spatialOrder(*a.mesh));
      for (const model::Node& b : scene.nodes()) {
        if (b.isGroup() || b.id == a.id)
          continue;
        int within = 0;
        for (std::size_t v = 0; v < b.mesh->vertexCount(); v += 7)
          within += inside(bvh, b.mesh->positions()[v]);
        QVERIFY2(within == 0, (b.name + " inside " + a.name).c_str());
      }
    }
  }
};

SLINE_TEST(KidneyTest)
#include "kidney_test.moc"
