// SPDX-License-Identifier: Apache-2.0
#include "model/sculpting/demo_structure.h"

#include <QtTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/geometry/surface.h"
#include "model/geometry/topology.h"
#include "model/sculpting/field_grid.h"
#include "model/sculpting/pipe.h"
#include "model/sculpting/polygonise.h"
#include "tests/model/demo/demo_measures.h"
#include "tests/support/suite.h"

using namespace sline;
using model::Box;
using model::DemoStructure;
using model::Field;
using test::volumeOf;

namespace {
Field sphere(const glm::vec3& centre, float radius) {
  return [=](const glm::vec3& p) { return glm::distance(p, centre) - radius; };
}

DemoStructure ball(const char* name, const glm::vec3& centre, float radius) {
  return {.name = name,
          .groups = {"Balls"},
          .colour = {200, 100, 50},
          .field = sphere(centre, radius),
          .box = {centre - (radius + 3.0f), centre + (radius + 3.0f)},
          .edge = 0.8f};
}

const model::Mesh& meshOf(const model::Scene& scene, const char* name) {
  return *scene.find(scene.named(name).front())->mesh;
}

}  // namespace

class DemoStructureTest : public QObject {
  Q_OBJECT
 private slots:
  void treeInListOrder() {
    DemoStructure a = ball("a", {0, 0, 0}, 4);
    DemoStructure b = ball("b", {20, 0, 0}, 4);
    DemoStructure c = ball("c", {40, 0, 0}, 4);
    b.groups = {"Balls", "Small"};
    b.fill = model::Fill::paper;
    const model::Scene scene = model::demoScene({a, b, c});
    QCOMPARE(scene.nodes().size(), std::size_t(5));
    const model::Node& inner = *scene.find(scene.named("b").front());
    QCOMPARE(scene.groupPath(inner.id), std::string("Balls / Small"));
    QVERIFY(inner.style.fill == model::Fill::paper);
    QCOMPARE(scene.groupPath(scene.named("c").front()), std::string("Balls"));
    QCOMPARE(scene.structuresBelow(model::rootId).size(), std::size_t(3));
  }

  // A ball bitten by another keeps the gap everywhere and stays closed.
  void givesWayWithAGap() {
    DemoStructure bitten = ball("bitten", {0, 0, 0}, 10);
    bitten.givesWayTo = {"biter"};
    bitten.gap = 0.7f;
    const model::Scene scene = model::demoScene({bitten, ball("biter", {9, 2, 1}, 6)});
    const model::Mesh& mesh = meshOf(scene, "bitten");
    float nearest = 1e9f;
    for (const glm::vec3& p : mesh.positions())
      nearest = std::min(nearest, sphere({9, 2, 1}, 6)(p));
    QVERIFY(std::abs(nearest - 0.7f) < 0.02f);
    QVERIFY(model::countEdges(mesh, model::VertexFaces(mesh)).closed());
    const double whole = 4.0 / 3.0 * 3.14159265 * 1000.0;
    QVERIFY(volumeOf(mesh) < 0.9 * whole && volumeOf(mesh) > 0.6 * whole);
    QVERIFY(std::abs(volumeOf(meshOf(scene, "biter")) / (whole * 0.216) - 1.0) < 0.01);
  }

  // The wall of a hollow ball, open below, follows the dent that another leaves.
  void hollowBodyKeepsItsWall() {
    DemoStructure hollow = ball("hollow", {0, 0, 0}, 12);
    hollow.wall = 2.0f;
    hollow.rounding = 0.5f;
    hollow.opening = [](const glm::vec3& p) { return std::max(std::hypot(p.x, p.y) - 2.5f, p.z); };
    hollow.givesWayTo = {"fist"};
    const model::Scene scene = model::demoScene({hollow, ball("fist", {14, 0, 0}, 6)});
    const model::Mesh& mesh = meshOf(scene, "hollow");
    QVERIFY(model::countEdges(mesh, model::VertexFaces(mesh)).closed());
    QCOMPARE(model::connectedComponents(mesh).count, std::size_t(1));
    const double whole = 4.0 / 3.0 * 3.14159265 * (1728.0 - 1000.0);
    QVERIFY(volumeOf(mesh) > 0.85 * whole && volumeOf(mesh) < 1.1 * whole);
    for (const glm::vec3& p : mesh.positions()) {
      const float outer = std::max(sphere({0, 0, 0}, 12)(p), 0.5f - sphere({14, 0, 0}, 6)(p));
      QVERIFY(outer > -2.1f && outer < 0.6f);
    }
  }

  // Without an opening the cavity is a closed surface of its own that faces inward.
  void closedCavityFacesInward() {
    DemoStructure hollow = ball("hollow", {0, 0, 0}, 12);
    hollow.wall = 2.0f;
    hollow.folds = [](const glm::vec3& p) { return p.z > 0.0f ? 1.0f : 0.0f; };
    const model::Scene scene = model::demoScene({hollow});
    const model::Mesh& mesh = meshOf(scene, "hollow");
    QVERIFY(model::countEdges(mesh, model::VertexFaces(mesh)).closed());
    QCOMPARE(model::connectedComponents(mesh).count, std::size_t(2));
    const double ballOf1mm = 4.0 / 3.0 * 3.14159265;
    const double cavity = ballOf1mm * 0.5 * (1000.0 + 729.0);
    QVERIFY(std::abs(volumeOf(mesh) / (ballOf1mm * 1728.0 - cavity) - 1.0) < 0.02);
    for (const auto& [a, b, c] : mesh.triangles()) {
      const glm::vec3 middle =
          (mesh.positions()[a] + mesh.positions()[b] + mesh.positions()[c]) / 3.0f;
      const glm::vec3 normal = glm::cross(mesh.positions()[b] - mesh.positions()[a],
                                          mesh.positions()[c] - mesh.positions()[a]);
      if (std::abs(middle.z) > 2.0f)
        QCOMPARE(glm::dot(normal, middle) > 0.0f, glm::length(middle) > 11.0f);
    }
  }

  // Smoothing takes off what is finer than it and leaves the rest.
  void smoothingTakesOffFineRipples() {
    DemoStructure rippled = ball("rippled", {0, 0, 0}, 12);
    rippled.field = [](const glm::vec3& p) {
      return glm::length(p) - 12.0f + 0.3f * std::sin(1.6f * p.x) * std::sin(1.6f * p.z);
    };
    const auto roughness = [&](float smoothing) {
      rippled.smoothing = smoothing;
      const model::Scene scene = model::demoScene({rippled});
      double sum = 0.0;
      double squares = 0.0;
      const model::Mesh& mesh = meshOf(scene, "rippled");
      for (const glm::vec3& p : mesh.positions()) {
        sum += double(glm::length(p));
        squares += double(glm::dot(p, p));
      }
      const double mean = sum / double(mesh.vertexCount());
      return std::sqrt(squares / double(mesh.vertexCount()) - mean * mean);
    };
    QVERIFY(roughness(0.0f) > 0.1);
    QVERIFY(roughness(1.5f) < 0.02);
  }

  // A rod cut by a ball near one end keeps the longer piece only.
  void crumbsAreDropped() {
    const std::array<model::TubePoint, 2> ends{{{{0, 0, 0}, 2.0f}, {{40, 0, 0}, 2.0f}}};
    const model::Tube tube(ends);
    DemoStructure rod = ball("rod", {0, 0, 0}, 1);
    rod.field = [tube](const glm::vec3& p) { return tube.distance(p); };
    rod.box = {{-5, -5, -5}, {45, 5, 5}};
    rod.givesWayTo = {"ball"};
    const model::Scene scene = model::demoScene({rod, ball("ball", {10, 0, 0}, 5)});
    const model::Mesh& mesh = meshOf(scene, "rod");
    QCOMPARE(model::connectedComponents(mesh).count, std::size_t(1));
    QVERIFY(std::abs(mesh.bounds().low.x - 15.5f) < 0.3f);
    QVERIFY(std::abs(mesh.bounds().high.x - 42.0f) < 0.05f);
  }

  // Where the surface runs, the sparse grid holds what a full one holds; it asks far less.
  void gridIsExactAtTheSurface_data() {
    QTest::addColumn<float>("overstated");
    QTest::newRow("a distance") << 1.0f;
    QTest::newRow("half a distance") << 0.5f;
    QTest::newRow("four distances far away") << 4.0f;
  }
  void gridIsExactAtTheSurface() {
    QFETCH(const float, overstated);
    const Field ball = sphere({1, 2, 3}, 20.0f);
    const Field field = [&](const glm::vec3& p) {
      const float d = ball(p);
      return std::abs(d) < 1.0f ? d : overstated * d;
    };
    const Box box{glm::vec3(-26, -26, -26), glm::vec3(27, 27, 27)};
    const model::FieldGrid grid(field, box, 0.7f);
    const glm::ivec3 size = grid.size();
    const auto at = [&](int x, int y, int z) {
      return grid.values()[std::size_t((z * size.y + y) * size.x + x)];
    };
    for (int z = 0; z < size.z; ++z)
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
          const float truth = field(box.low + 0.7f * glm::vec3(x, y, z));
          QVERIFY((truth < 0.0f) == (at(x, y, z) < 0.0f));
          if (x + 1 < size.x && (at(x, y, z) < 0.0f) != (at(x + 1, y, z) < 0.0f))
            QCOMPARE(at(x, y, z), truth);
        }
    if (overstated >= 1.0f)
      QVERIFY(grid.exactCount() < grid.values().size() / 4);
  }

  // Triangles are near equilateral and the surface is where the field says.
  void polygonsAreEvenAndOnTheSurface() {
    const std::array<model::TubePoint, 4> through{
        {{{0, 0, 0}, 4.0f}, {{15, 5, 0}, 3.0f}, {{25, 0, 8}, 4.0f}, {{40, 0, 20}, 5.0f}}};
    const model::Tube tube(through);
    const Field field = [&](const glm::vec3& p) {
      return model::blendedUnion(tube.distance(p), glm::distance(p, {20, 2, 4}) - 7.0f, 4.0f);
    };
    const auto mesh = model::polygonise(field, {{-8, -12, -8}, {48, 14, 28}}, 1.0f);
    QVERIFY(model::prepareSurface(mesh)->closed);
    for (const glm::vec3& p : mesh->positions())
      QVERIFY(std::abs(field(p)) < 5e-3f);
    double quality = 0.0;
    for (const auto& [a, b, c] : mesh->triangles()) {
      const glm::vec3 u = mesh->positions()[b] - mesh->positions()[a];
      const glm::vec3 v = mesh->positions()[c] - mesh->positions()[b];
      const glm::vec3 w = mesh->positions()[a] - mesh->positions()[c];
      const double area = 0.5 * double(glm::length(glm::cross(u, v)));
      const double squares = double(glm::dot(u, u) + glm::dot(v, v) + glm::dot(w, w));
      quality += 4.0 * std::sqrt(3.0) * area / squares;  // 1 where equilateral
    }
    QVERIFY(quality / double(mesh->triangleCount()) > 0.93);
    // The mesh is as even as drawn lines need it: two in three vertices have six neighbours.
    const model::VertexFaces faces(*mesh);
    std::size_t regular = 0;
    for (std::size_t v = 0; v < mesh->vertexCount(); ++v)
      regular += faces[v].size() == 6;
    QVERIFY(3 * regular > 2 * mesh->vertexCount());
  }

  // A bent pipe cut askew: closed, of one handle, six neighbours everywhere, its wall between the
  // two radii and its ends in their planes.
  void pipeIsEven() {
    const std::array<model::TubePoint, 4> through{
        {{{-10, 0, 0}, 5.0f}, {{15, 5, 0}, 5.0f}, {{25, 0, 8}, 4.0f}, {{40, 0, 20}, 5.0f}}};
    const model::Tube tube(through);
    const std::array<model::PipeEnd, 2> ends{
        {{{0, 2.5f, 0}, glm::normalize(glm::vec3(-1, 0.2f, 0.1f))},
         {{33, 0, 15}, glm::normalize(glm::vec3(1, 0.3f, 0.5f))}}};
    model::Facets facets = model::pipe(tube.course(), 1.5f, ends, 1.2f);
    const auto mesh = std::make_shared<const model::Mesh>(
        model::Mesh::create(std::move(facets.positions), std::move(facets.triangles)).value());
    const model::VertexFaces faces(*mesh);
    QVERIFY(model::countEdges(*mesh, faces).closed());
    QCOMPARE(model::connectedComponents(*mesh).count, std::size_t(1));
    QCOMPARE(test::handlesOf(*mesh), 1);
    std::size_t inPlane = 0;
    for (std::size_t v = 0; v < mesh->vertexCount(); ++v) {
      QCOMPARE(faces[v].size(), std::size_t(6));
      const glm::vec3& p = mesh->positions()[v];
      const float d = tube.distance(p);
      QVERIFY(std::abs(d) < 0.02f || std::abs(d + 1.5f) < 0.02f);
      for (const model::PipeEnd& end : ends) {
        const float beyond = glm::dot(p - end.point, end.normal);
        QVERIFY(beyond < 1e-3f);
        inPlane += beyond > -1e-3f;
      }
    }
    QVERIFY(inPlane >= 4 * 12);
  }

  // Drawing edges together coarsens a body and neither opens nor pinches it. A tetrahedron has none
  // to give.
  void remeshingKeepsTheSurfaceClosed() {
    const Field drop = [](const glm::vec3& p) { return model::ellipsoid(p, {9, 5, 4}); };
    const auto even = model::polygonise(drop, {{-11, -7, -6}, {11, 7, 6}}, 0.8f);
    model::Facets facets{{even->positions().begin(), even->positions().end()},
                         {even->triangles().begin(), even->triangles().end()}};
    const std::size_t before = facets.triangles.size();
    for (int pass = 0; pass < 6; ++pass) {
      model::drawTogether(facets, 1.1f, 2.2f);
      model::turnEdges(facets);
    }
    QVERIFY(facets.triangles.size() < before * 3 / 4);
    const auto coarse = model::Mesh::create(facets.positions, facets.triangles).value();
    QVERIFY(model::countEdges(coarse, model::VertexFaces(coarse)).closed());
    QCOMPARE(test::handlesOf(coarse), 0);
    QVERIFY(std::abs(volumeOf(coarse) / volumeOf(*even) - 1.0) < 0.03);

    model::Facets tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                              {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
    model::drawTogether(tetrahedron, 10.0f, 20.0f);
    model::turnEdges(tetrahedron);
    QCOMPARE(tetrahedron.triangles.size(), std::size_t(4));
  }
};

SLINE_TEST(DemoStructureTest)
#include "demo_structure_test.moc"
