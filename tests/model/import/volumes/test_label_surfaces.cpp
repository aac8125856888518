// SPDX-License-Identifier: Apache-2.0
// Tests surfaces of label volumes: closed, manifold and outward whatever the voxels, shared where
// structures touch, true to what was sampled.
#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <random>
#include <set>

#include "model/fairing/half_edges.h"
#include "model/import/volumes/label_surfaces.h"
#include "tests/model/import/volumes/written_volumes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

namespace {

glm::dmat4 grid(const glm::dvec3& spacing, const glm::dvec3& origin) {
  glm::dmat4 matrix(1.0);
  for (int i = 0; i < 3; ++i)
    matrix[i][i] = spacing[i];
  matrix[3] = glm::dvec4(origin, 1.0);
  return matrix;
}

double volumeOf(const RawMesh& mesh) {
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles)
    sum += glm::dot(glm::dvec3(mesh.positions[t[0]]),
                    glm::cross(glm::dvec3(mesh.positions[t[1]]), glm::dvec3(mesh.positions[t[2]])));
  return sum / 6.0;
}

/// Tells whether every edge has two triangles that run along it in opposite directions.
bool isClosed(const RawMesh& mesh) {
  const HalfEdges edges(mesh.positions.size(), mesh.triangles);
  if (edges.openCount() + edges.sharedCount() > 0)
    return false;
  for (std::uint32_t h = 0; h < edges.count(); ++h) {
    const std::uint32_t other = edges.opposite(h);
    if (mesh.triangles[h / 3][h % 3] == mesh.triangles[other / 3][other % 3])
      return false;
  }
  return true;
}

/// Tells whether the triangles around each vertex form one fan.
bool hasOneFanEverywhere(const RawMesh& mesh) {
  const HalfEdges edges(mesh.positions.size(), mesh.triangles);
  std::vector<std::size_t> faces(mesh.positions.size(), 0);
  std::vector<std::uint32_t> start(mesh.positions.size(), 0);
  for (std::uint32_t h = 0; h < edges.count(); ++h) {
    const std::uint32_t v = mesh.triangles[h / 3][h % 3];
    ++faces[v];
    start[v] = h;
  }
  for (std::size_t v = 0; v < faces.size(); ++v) {
    std::size_t turned = 0;
    std::uint32_t h = start[v];
    do {
      h = edges.opposite(nextInTriangle(nextInTriangle(h)));
      ++turned;
    } while (h != start[v] && turned <= faces[v]);
    if (turned != faces[v])
      return false;
  }
  return true;
}

RawMeshes surfaces(const LabelVolume& volume, Smoothing::Mode mode = Smoothing::Mode::automatic) {
  Result<RawMeshes> result = labelSurfaces(volume, {.limits = {}, .smoothing = {mode, 0}});
  if (!result)
    qFatal("%s", result.error().text().c_str());
  return std::move(result).value();
}

using Place = std::tuple<float, float, float>;
Place placeOf(const glm::vec3& p) {
  return {p.x, p.y, p.z};
}

}  // namespace

class LabelSurfacesTest : public QObject {
  Q_OBJECT
 private slots:
  void noise_data();
  void noise();
  void sphere_data();
  void sphere();
  void thinVessel();
  void slope();
  void touching();
  void border();
  void mirrored();
  void notOfWhatIsThere();
  void refusals();
};

void LabelSurfacesTest::notOfWhatIsThere() {
  // The third label has no voxel.
  const WrittenVolume written =
      sampled({8, 8, 8}, grid({1.0, 1.0, 1.0}, {0.0, 0.0, 0.0}), [](const glm::dvec3& p) {
        return p.x < 2.0 ? 0 : p.x < 5.0 ? 1 : 2;
      });
  LabelVolume volume = inMemory(written, 3);
  for (std::size_t i = 0; i < 3; ++i)
    volume.labels[i].name = std::array{"liver", "spleen", "nothing"}[i];
  ReadOptions options;
  options.isThere = [](const std::string& name) { return name != "spleen"; };
  const Result<RawMeshes> one = labelSurfaces(volume, options);
  QVERIFY(one.ok());
  QCOMPARE(one->meshes.size(), std::size_t(1));
  QCOMPARE(one->meshes.front().name, std::string("spleen"));
  QVERIFY(isClosed(one->meshes.front()));
  QCOMPARE(one->thereAlready, std::uint64_t(1));
  options.isThere = [](const std::string&) { return true; };
  const Result<RawMeshes> none = labelSurfaces(volume, options);
  QVERIFY(none.ok() && none->meshes.empty());
  QCOMPARE(none->thereAlready, std::uint64_t(2));
  std::fill(volume.voxels.begin(), volume.voxels.end(), std::uint16_t(0));
  QVERIFY(!labelSurfaces(volume, options).ok());
}

void LabelSurfacesTest::noise_data() {
  QTest::addColumn<int>("labels");
  QTest::addColumn<bool>("smooth");
  for (const int labels : {1, 2, 3, 7})
    for (const bool smooth : {false, true})
      QTest::addRow("%d labels%s", labels, smooth ? ", relaxed" : "") << labels << smooth;
}

/// Random voxels have every configuration, the ambiguous ones in all combinations.
void LabelSurfacesTest::noise() {
  QFETCH(int, labels);
  QFETCH(bool, smooth);
  std::mt19937 random(7);
  const WrittenVolume written =
      sampled(glm::ivec3(17, 16, 15), grid({1.0, 0.8, 1.7}, {5.0, 6.0, 7.0}),
              [&](const glm::dvec3&) { return int(random() % unsigned(labels + 1)); });
  const RawMeshes made = surfaces(inMemory(written, labels),
                                  smooth ? Smoothing::Mode::automatic : Smoothing::Mode::off);
  QCOMPARE(made.meshes.size(), std::size_t(labels));
  for (std::size_t i = 0; i < made.meshes.size(); ++i) {
    const RawMesh& mesh = made.meshes[i];
    QVERIFY(isClosed(mesh));
    QVERIFY(hasOneFanEverywhere(mesh));
    QVERIFY(mesh.smooth);
    if (smooth) {
      QVERIFY(mesh.displacement > 0.1f && mesh.displacement < 2.2f);
      continue;
    }
    QCOMPARE(mesh.displacement, 0.0f);
    // Faces half-way between voxels enclose just the voxels.
    const auto voxels = std::count(written.values.begin(), written.values.end(), int(i) + 1);
    QVERIFY(std::abs(volumeOf(mesh) - 1.36 * double(voxels)) < 1e-2 * double(voxels));
  }
}

void LabelSurfacesTest::sphere_data() {
  QTest::addColumn<double>("radius");
  QTest::addColumn<glm::dvec3>("spacing");
  QTest::addColumn<double>("tolerance");
  QTest::newRow("even") << 20.0 << glm::dvec3(1.0) << 0.25;
  QTest::newRow("thick slices") << 20.0 << glm::dvec3(0.8, 0.8, 3.0) << 0.8;
  QTest::newRow("large") << 40.0 << glm::dvec3(1.5) << 0.4;
}

void LabelSurfacesTest::sphere() {
  QFETCH(double, radius);
  QFETCH(glm::dvec3, spacing);
  QFETCH(double, tolerance);
  const glm::dvec3 centre(3.3, -20.0, 111.7);
  const glm::ivec3 size(2.0 * (radius + 4.0) / spacing);
  const glm::dvec3 origin = centre - 0.5 * glm::dvec3(size) * spacing;
  const RawMeshes made = surfaces(
      inMemory(sampled(size, grid(spacing, origin),
                       [&](const glm::dvec3& p) { return int(glm::length(p - centre) < radius); }),
               1));
  QCOMPARE(made.meshes.size(), std::size_t(1));
  const RawMesh& mesh = made.meshes.front();
  double farthest = 0.0;
  double mean = 0.0;
  for (const glm::vec3& p : mesh.positions) {
    const double off = glm::length(glm::dvec3(p) - centre) - radius;
    farthest = std::max(farthest, std::abs(off));
    mean += off / double(mesh.positions.size());
  }
  QVERIFY2(farthest < tolerance, qPrintable(QString::number(farthest)));
  QVERIFY2(std::abs(mean) < 0.2 * tolerance, qPrintable(QString::number(mean)));
  const double truth = 4.0 / 3.0 * M_PI * radius * radius * radius;
  QVERIFY2(std::abs(volumeOf(mesh) / truth - 1.0) < 0.01,
           qPrintable(QString::number(volumeOf(mesh) / truth)));
}

/// An oblique vessel as wide as a voxel keeps its volume and stays one piece.
void LabelSurfacesTest::thinVessel() {
  for (const double radius : {0.75, 1.2, 2.0}) {
    const glm::dvec3 along = glm::normalize(glm::dvec3(0.3, 0.2, 1.0));
    const WrittenVolume written = sampled(
        glm::ivec3(40, 36, 60), grid(glm::dvec3(1.0), glm::dvec3(0.0)), [&](const glm::dvec3& p) {
          const glm::dvec3 q = p - glm::dvec3(20.0, 18.0, 30.0);
          const bool inside = glm::length(q - glm::dot(q, along) * along) < radius;
          return int(inside && std::abs(q.z) < 25.0);
        });
    const RawMeshes made = surfaces(inMemory(written, 1));
    const double voxels = double(std::count(written.values.begin(), written.values.end(), 1));
    const double kept = volumeOf(made.meshes.front()) / voxels;
    QVERIFY2(kept > 0.85 && kept < 1.1, qPrintable(QString("%1: %2").arg(radius).arg(kept)));
    QVERIFY(isClosed(made.meshes.front()));
  }
}

/// The steps of a shallow slope are twenty voxels long; relaxation removes them.
void LabelSurfacesTest::slope() {
  const auto height = [](const glm::dvec3& p) { return 20.0 + 0.05 * p.x + 0.012 * p.y; };
  const LabelVolume volume =
      inMemory(sampled(glm::ivec3(80, 60, 40), grid(glm::dvec3(1.0), glm::dvec3(0.0)),
                       [&](const glm::dvec3& p) { return int(p.z < height(p)); }),
               1);
  const auto deviation = [&](Smoothing::Mode mode) {
    double sum = 0.0;
    int count = 0;
    const RawMeshes made = surfaces(volume, mode);
    for (const glm::vec3& p : made.meshes.front().positions)
      if (p.x > 15.0f && p.x < 65.0f && p.y > 15.0f && p.y < 45.0f && p.z > 10.0f) {
        const double off = double(p.z) - height(glm::dvec3(p));
        sum += off * off;
        ++count;
      }
    return std::sqrt(sum / count);
  };
  QVERIFY(deviation(Smoothing::Mode::off) > 0.25);
  QVERIFY2(deviation(Smoothing::Mode::automatic) < 0.12,
           qPrintable(QString::number(deviation(Smoothing::Mode::automatic))));
}

/// Two half balls have a shell around them: where two structures meet, each has the other's
/// triangles in the opposite direction, vertex for vertex.
void LabelSurfacesTest::touching() {
  const LabelVolume volume =
      inMemory(sampled(glm::ivec3(40), grid({1.0, 1.1, 1.2}, glm::dvec3(-20.0)),
                       [](const glm::dvec3& p) {
                         const double r = glm::length(p - glm::dvec3(0.3, 0.7, 1.1));
                         return r < 10.0 ? (p.x + 0.4 * p.y < 0.0 ? 1 : 2) : r < 14.0 ? 3 : 0;
                       }),
               3);
  for (const auto mode : {Smoothing::Mode::off, Smoothing::Mode::automatic}) {
    const RawMeshes made = surfaces(volume, mode);
    QCOMPARE(made.meshes.size(), std::size_t(3));
    using Corners = std::array<Place, 3>;
    const auto turned = [](Corners corners) {
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      return corners;
    };
    std::array<std::set<Corners>, 3> triangles;
    for (std::size_t i = 0; i < 3; ++i)
      for (const Triangle& t : made.meshes[i].triangles) {
        const auto& p = made.meshes[i].positions;
        triangles[i].insert(turned({placeOf(p[t[0]]), placeOf(p[t[1]]), placeOf(p[t[2]])}));
      }
    const auto shared = [&](std::size_t a, std::size_t b) {
      return std::count_if(triangles[a].begin(), triangles[a].end(), [&](const Corners& t) {
        return triangles[b].contains(turned({t[0], t[2], t[1]}));
      });
    };
    // The balls' halves have no face towards the background.
    QCOMPARE(std::size_t(shared(0, 1) + shared(0, 2)), triangles[0].size());
    QCOMPARE(std::size_t(shared(1, 0) + shared(1, 2)), triangles[1].size());
    QVERIFY(shared(0, 1) > 300 && shared(0, 2) > 500);
  }
}

/// A structure that reaches the border of the volume is closed half a voxel outside.
void LabelSurfacesTest::border() {
  const LabelVolume volume =
      inMemory(sampled(glm::ivec3(4, 3, 2), grid(glm::dvec3(1.0), glm::dvec3(0.0)),
                       [](const glm::dvec3&) { return 1; }),
               1);
  const RawMesh mesh = surfaces(volume, Smoothing::Mode::off).meshes.front();
  QVERIFY(isClosed(mesh));
  Box box;
  for (const glm::vec3& p : mesh.positions)
    box.add(p);
  QCOMPARE(box.low, glm::vec3(-0.5f));
  QCOMPARE(box.high, glm::vec3(3.5f, 2.5f, 1.5f));
}

/// A grid that counts its voxels in the opposite direction makes the same surface, not an
/// inside-out one.
void LabelSurfacesTest::mirrored() {
  const auto label = [](const glm::dvec3& p) {
    return int(glm::length(p - glm::dvec3(9.0, 10.0, 11.0)) < 6.0 || p.x + p.y < 8.0);
  };
  glm::dmat4 turned = grid({-1.0, 1.0, 1.0}, {19.0, 0.0, 0.0});
  const RawMesh plain =
      surfaces(inMemory(sampled(glm::ivec3(20), grid(glm::dvec3(1.0), glm::dvec3(0.0)), label), 1))
          .meshes.front();
  const RawMesh other =
      surfaces(inMemory(sampled(glm::ivec3(20), turned, label), 1)).meshes.front();
  QVERIFY(volumeOf(plain) > 1000.0);
  QVERIFY(std::abs(volumeOf(other) / volumeOf(plain) - 1.0) < 1e-3);
  QCOMPARE(other.triangles.size(), plain.triangles.size());
}

void LabelSurfacesTest::refusals() {
  const WrittenVolume written =
      sampled(glm::ivec3(8), grid(glm::dvec3(1.0), glm::dvec3(0.0)),
              [](const glm::dvec3& p) { return int(glm::length(p - 4.0) < 2.0); });
  LabelVolume volume = inMemory(written, 1);
  QVERIFY(labelSurfaces(volume, {}).ok());
  ReadOptions few;
  few.limits.vertices = 20;
  QVERIFY(labelSurfaces(volume, few).error().reason.find("20 vertices") != std::string::npos);
  few = {};
  few.limits.triangles = 20;
  QVERIFY(labelSurfaces(volume, few).error().reason.find("20 triangles") != std::string::npos);
  ReadOptions cancelled;
  cancelled.goesOn = [] { return false; };
  QVERIFY(!labelSurfaces(volume, cancelled).ok());
  LabelVolume flat = volume;
  flat.toLps[2] = flat.toLps[0];
  QVERIFY(!labelSurfaces(flat, {}).ok());
  LabelVolume small = volume;
  small.voxels.pop_back();
  QVERIFY(!labelSurfaces(small, {}).ok());
  std::fill(volume.voxels.begin(), volume.voxels.end(), std::uint16_t(0));
  QVERIFY(labelSurfaces(volume, {}).error().reason.find("background") != std::string::npos);
}

SLINE_TEST(LabelSurfacesTest)
#include "test_label_surfaces.moc"
