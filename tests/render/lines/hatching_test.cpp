// SPDX-License-Identifier: Apache-2.0
// Tests the properties that hatching must have whatever it looks like: its places, that strokes
// keep apart, that a mirror mirrors it.
#include "render/lines/hatching/hatching.h"

#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "render/lines/ground/view_fields.h"
#include "render/lines/ground/view_scale.h"
#include "tests/render/lines/hatched_subject.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"
#include "tests/support/torus.h"

using namespace sline;
using namespace sline::test;

namespace {
const test::Torus ring{10.0, 7.0};

/// Returns the direction of the light that leaves shadows.
glm::vec3 lightOf(const model::Camera& camera) {
  const model::CameraFrame frame = model::cameraFrame(camera);
  const glm::vec3 light = render::HatchingRequest().light;
  return light.x * frame.right + light.y * frame.up + light.z * frame.back;
}

/// Returns by how much a line turns within the surface from point to point: the sum of the
/// squares, radians².
double turns(const std::vector<glm::vec3>& points, const std::vector<glm::vec3>& normals) {
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const glm::vec3 in = glm::normalize(points[i] - points[i - 1]);
    const glm::vec3 out = glm::normalize(points[i + 1] - points[i]);
    const double sine = glm::dot(glm::cross(in, out), normals[i]);
    sum += sine * sine;
  }
  return sum;
}

}  // namespace

class HatchingTest : public QObject {
  Q_OBJECT
 private slots:
  // ▲ Convex forms have a shadow, on the side away from the light and nowhere else.
  void aSphereHasAShadow() {
    const Subject sphere(test::sphere(8.0f, 5));
    const model::Camera camera = orthographic(slanted, 30.0f);
    const render::Hatching hatching = sphere.hatched(camera);
    QVERIFY(hatching.strokes.size() > 10);
    for (const render::HatchPoint& p : hatching.points)
      if (p.halfWidth > 0.0f)
        QVERIFY(glm::dot(p.normal, lightOf(camera)) < 0.32f);
    const model::CameraFrame frame = model::cameraFrame(camera);
    for (const glm::vec3& side : {frame.right, -frame.up})
      QVERIFY(std::any_of(hatching.points.begin(), hatching.points.end(), [&](const auto& p) {
        return p.halfWidth > 0.5f && glm::dot(p.normal, side) > 0.6f;
      }));
  }

  // On a torus κr < 0 only within the ring's inner half; S eq. 6 puts hatching there.
  void onlyInHollowsAndShadows() {
    const Subject torus = torusSubject();
    const model::Camera camera = orthographic(slanted, 30.0f);
    const render::Hatching hatching = torus.hatched(camera);
    QVERIFY(hatching.strokes.size() > 10);
    const glm::dvec3 towards(glm::normalize(slanted));
    int hollow = 0;
    for (const render::HatchPoint& p : hatching.points) {
      const test::Torus::Point at = ring.at(glm::dvec3(p.position));
      QVERIFY(glm::distance(ring.position(at), glm::dvec3(p.position)) < 0.02);
      QVERIFY(ring.nv(at, towards) > -0.03);
      if (!(p.halfWidth > 0.0f))
        continue;
      const bool concave = ring.radialCurvature(at, towards) < 0.02 / ring.minor;
      hollow += concave;
      QVERIFY(concave || glm::dot(p.normal, lightOf(camera)) < 0.32f);
    }
    QVERIFY(hollow > 50);
  }

  // Strokes run across hollows and around limbs, wherever it is clear which curvature is the
  // stronger.
  void strokesRunAlongTheStrongerCurvature() {
    const Subject torus = torusSubject();
    int along = 0;
    int around = 0;
    for (const glm::vec3& from : {slanted, glm::vec3(1, 0, -0.2f)}) {
      const render::Hatching hatching = torus.hatched(orthographic(from, 30.0f));
      for (const render::HatchStroke& s : hatching.strokes) {
        const auto points = pointsOf(hatching, s);
        for (std::size_t i = 1; i < points.size(); ++i) {
          const glm::dvec3 step(points[i].position - points[i - 1].position);
          const test::Torus::Point at =
              ring.at(0.5 * glm::dvec3(points[i].position + points[i - 1].position));
          const double hollow = -std::cos(at.v) / (ring.major + ring.minor * std::cos(at.v));
          const double bulge = 0.3 / ring.minor;
          if (glm::length(step) < 0.05 || (hollow > 0.5 * bulge && hollow < 2.0 * bulge))
            continue;
          const bool ringwise = hollow > bulge;
          ++(ringwise ? along : around);
          const glm::dvec3 expected = ringwise ? ring.alongRing(at) : ring.alongTube(at);
          QVERIFY(std::abs(glm::dot(glm::normalize(step), expected)) > 0.97);
        }
      }
    }
    QVERIFY(along > 50);
    QVERIFY(around > 50);
  }

  // METHOD §6.10: strokes drawn in one view are where they were in the one before.
  void turningMovesNoStroke() {
    const Subject torus = torusSubject();
    std::set<std::array<float, 3>> before;
    for (const render::HatchPoint& p : torus.hatched(orthographic(slanted, 30.0f)).points)
      before.insert({p.position.x, p.position.y, p.position.z});
    const glm::vec3 turned = slanted + glm::vec3(0.01f, 0.0f, 0.0f);
    int points = 0;
    int known = 0;
    for (const render::HatchPoint& p : torus.hatched(orthographic(turned, 30.0f)).points)
      if (p.halfWidth > 0.6f) {
        ++points;
        known += int(before.count({p.position.x, p.position.y, p.position.z}));
      }
    QVERIFY(points > 100);
    QVERIFY2(known >= 0.97 * points, qPrintable(QString("%1 of %2").arg(known).arg(points)));
  }

  // A layout's strokes do not depend on which views were drawn before.
  void viewsLeaveNoTrace() {
    const Subject fresh = torusSubject();
    const Subject used = torusSubject();
    for (const float height : {60.0f, 12.0f})
      used.hatched(orthographic(glm::vec3(1, 0.4f, -0.3f), height));
    // There are so many that the results of the first ones are forgotten.
    for (int i = 0; i < 14; ++i)
      used.hatched(orthographic(slanted + glm::vec3(0.02f * float(i), 0, 0), 20.0f));
    const render::Hatching a = fresh.hatched(orthographic(slanted, 24.0f));
    const render::Hatching b = used.hatched(orthographic(slanted, 24.0f));
    QCOMPARE(a.points.size(), b.points.size());
    for (std::size_t i = 0; i < a.points.size(); ++i) {
      QCOMPARE(a.points[i].position, b.points[i].position);
      QCOMPARE(a.points[i].halfWidth, b.points[i].halfWidth);
    }
  }

  // Strokes of one sheet never touch: between their middles there is room for both half widths.
  void strokesDoNotTouch() {
    const Subject torus = torusSubject();
    const model::Camera camera = orthographic(slanted, 24.0f);
    const render::ViewScale scale(camera);
    const render::Hatching hatching = torus.hatched(camera);
    int close = 0;
    int pairs = 0;
    for (std::size_t a = 0; a < hatching.strokes.size(); ++a)
      for (std::size_t b = a + 1; b < hatching.strokes.size(); ++b)
        for (const render::HatchPoint& p : pointsOf(hatching, hatching.strokes[a]))
          for (const render::HatchPoint& q : pointsOf(hatching, hatching.strokes[b])) {
            if (!(p.halfWidth > 0.45f) || !(q.halfWidth > 0.45f) ||
                glm::distance(p.position, q.position) > 1.0f)
              continue;
            ++pairs;
            const float apart =
                glm::distance(scale.project(p.position).at, scale.project(q.position).at);
            close += apart < p.halfWidth + q.halfWidth;
          }
    QVERIFY(pairs > 100);
    QVERIFY2(close <= pairs / 100, qPrintable(QString("%1 of %2").arg(close).arg(pairs)));
  }

  void aMirrorMirrorsStrokes() {
    const model::MeshPtr mesh =
        test::moved(*test::askew(*test::torus(10.0f, 7.0f, 200, 100)), 1.0f, {3.0f, 1.0f, -2.0f});
    const Subject here(mesh);
    const Subject there(test::mirrored(*mesh));
    const model::Camera camera = orthographic(slanted, 40.0f);
    const model::Camera mirror = orthographic(slanted * glm::vec3(-1, 1, 1), 40.0f);
    const render::Hatching a = here.hatched(camera);
    // In a mirror the light is on the other side, too.
    const glm::vec3 mirroredLight = render::HatchingRequest().light * glm::vec3(-1, 1, 1);
    const render::Hatching b = there.hatched(mirror, {.light = mirroredLight});
    QVERIFY(a.strokes.size() > 10);
    int matched = 0;
    for (const render::HatchStroke& s : a.strokes) {
      const glm::vec3 image = s.seedPosition * glm::vec3(-1, 1, 1);
      matched += std::any_of(b.strokes.begin(), b.strokes.end(), [&](const auto& other) {
        return glm::distance(other.seedPosition, image) < 0.01f;
      });
    }
    QVERIFY2(matched >= 0.97 * double(a.strokes.size()),
             qPrintable(QString("%1 of %2").arg(matched).arg(a.strokes.size())));
    QVERIFY(std::abs(ink(a, camera) / ink(b, mirror) - 1.0) < 0.03);
  }

  void scaleChangesNothing() {
    const model::MeshPtr mesh = test::torus(10.0f, 7.0f, 120, 60);
    const Subject small(mesh);
    const Subject large(test::moved(*mesh, 8.0f, glm::vec3(0.0f)));
    model::Camera camera = orthographic(slanted, 40.0f);
    const render::Hatching a = small.hatched(camera);
    camera.eye *= 8.0f;
    camera.heightMm *= 8.0f;
    const render::Hatching b = large.hatched(camera);
    QVERIFY(!a.strokes.empty());
    QVERIFY(std::abs(double(a.strokes.size()) / double(b.strokes.size()) - 1.0) < 0.02);
  }

  // Seen from within a closed body, as by an endoscope, the wall is a tube's inner side.
  void seenFromWithin() {
    const Subject tube(test::torus(30.0f, 6.0f, 300, 60));
    model::Camera camera{.eye = {30, 0, 0}, .target = {29, 8, 0}, .up = {0, 0, 1}};
    camera.fovyDegrees = 80.0f;
    const render::Hatching hatching = tube.hatched(camera, {.twoSided = true});
    QVERIFY(hatching.strokes.size() > 10);
    for (const render::HatchPoint& p : hatching.points)
      QVERIFY(glm::dot(p.normal, render::directionTo(render::eyeOf(camera), p.position)) > -0.05f);
    QVERIFY(tube.hatched(camera, {.twoSided = false}).strokes.size() < hatching.strokes.size());
  }

  void rowsSayWhatTheSurfaceIs() {
    const auto surface =
        model::prepareSurface(std::make_shared<const model::Mesh>(*test::torus(24, 8, 90, 40)));
    render::StrokeLayout layout(surface, 10.0f);
    layout.beginView();
    std::size_t points = 0;
    for (const render::LaidCell& cell :
         layout.cellsNear(layout.firstLevel() + 5, surface->boundingSphere)) {
      const auto tile = layout.tile(cell);
      for (const render::LaidStroke& stroke : tile->strokes) {
        for (std::uint32_t i = 0; i < stroke.count; ++i, ++points) {
          const render::LaidPoint& point = tile->points[stroke.first + i];
          // Evened out, points lie a little beside where the mesh was followed, along the surface.
          const glm::vec3 beside = tile->position(stroke, i) - layout.position(point);
          QVERIFY2(glm::length(beside) < 0.25f * layout.spacing(layout.firstLevel() + 5),
                   qPrintable(QString::number(glm::length(beside) /
                                              layout.spacing(layout.firstLevel() + 5))));
          QVERIFY(std::abs(glm::dot(beside, tile->normal(stroke, i))) < 1e-4f);
          if (i == 0 || i + 1 == stroke.count)
            QCOMPARE(beside, glm::vec3(0.0f));
          const glm::vec3 normal =
              glm::normalize(render::valueAt(*surface->mesh, surface->normals, layout.at(point)));
          QVERIFY(glm::distance(tile->normal(stroke, i), normal) < 1e-4f);
          QVERIFY(glm::dot(tile->normal(stroke, i), stroke.cone.axis) >= stroke.cone.cosine);
          // Across the tube the curvature is 1/8.
          const glm::vec3 p = tile->position(stroke, i);
          const glm::vec3 outwards = glm::normalize(glm::vec3(p.x, p.y, 0.0f));
          const glm::vec3 across = glm::cross(normal, glm::cross(normal, outwards));
          if (glm::length(across) < 0.1f)
            continue;
          const glm::vec3 d = glm::normalize(across);
          const auto s = [&](std::size_t k) {
            return stroke.bendingStep * float(tile->shapeRow(stroke, 3 + k)[i]);
          };
          const float bending = s(0) * d.x * d.x + s(3) * d.y * d.y + s(5) * d.z * d.z +
                                2.0f * (s(1) * d.x * d.y + s(2) * d.x * d.z + s(4) * d.y * d.z);
          QVERIFY(std::abs(bending - 0.125f) < 0.004f);
        }
        const float* x = tile->positionRow(stroke, 0);
        for (std::uint32_t i = stroke.count; i < stroke.rowLength(); ++i)
          QCOMPARE(x[i], x[stroke.count - 1]);
      }
    }
    QVERIFY(points > 100);
  }

  /// Strokes have no kinks, also where a coarse mesh's directions are rough.
  void strokesAreSmooth() {
    const auto surface = model::prepareSurface(
        test::jittered(*test::torus(24, 8, 45, 20), 0.25f, 7, [](const glm::vec3& p) {
          return p * (1.0f + 0.004f * std::sin(9.0f * p.x) * std::sin(8.0f * p.y + p.z));
        }));
    render::StrokeLayout layout(surface, 10.0f);
    layout.beginView();
    double laid = 0.0;
    double followed = 0.0;
    for (const render::LaidCell& cell :
         layout.cellsNear(layout.firstLevel() + 3, surface->boundingSphere)) {
      const auto tile = layout.tile(cell);
      for (const render::LaidStroke& stroke : tile->strokes) {
        std::vector<glm::vec3> points;
        std::vector<glm::vec3> traced;
        std::vector<glm::vec3> normals;
        for (std::uint32_t i = 0; i < stroke.count; ++i) {
          points.push_back(tile->position(stroke, i));
          traced.push_back(layout.position(tile->points[stroke.first + i]));
          normals.push_back(tile->normal(stroke, i));
        }
        laid += turns(points, normals);
        followed += turns(traced, normals);
      }
    }
    QVERIFY(followed > 0.0);
    QVERIFY2(laid < 0.6 * followed, qPrintable(QString::number(laid / followed)));
  }

  void cellsAreFoundFromCoarserOnes() {
    const auto surface =
        model::prepareSurface(std::make_shared<const model::Mesh>(*test::torus(24, 8, 90, 40)));
    render::StrokeLayout layout(surface, 10.0f);
    for (const render::KeptCell* coarse : layout.coarsest())
      for (const render::KeptCell* cell : layout.finer(*coarse)) {
        const model::Box reached = layout.reached(cell->cell);
        std::vector<std::uint32_t> clusters;
        for (std::uint32_t c = 0; c < surface->clusters.items.size(); ++c)
          if (render::touches(surface->clusters.items[c].bounds, reached))
            clusters.push_back(c);
        QCOMPARE(cell->clusters, clusters);
        QVERIFY(!clusters.empty());
      }
  }

  /// Cubes are as large as the form's details ask; all the way to a stray vertex there were more
  /// than memory holds.
  void strayVertexNeedsFewCells() {
    const model::MeshPtr ball = test::sphere(40.0f, 4);
    std::vector<glm::vec3> positions(ball->positions().begin(), ball->positions().end());
    positions[7] = {1e7f, 5e6f, -3e6f};
    auto stray = model::Mesh::create(std::move(positions),
                                     {ball->triangles().begin(), ball->triangles().end()});
    const auto surface =
        model::prepareSurface(std::make_shared<const model::Mesh>(std::move(*stray)));
    render::StrokeLayout layout(surface, 10.0f);
    QVERIFY(!layout.coarsest().empty() && layout.coarsest().size() <= 4096);
    // Strokes lie no closer than coordinates are told apart.
    QVERIFY(layout.lastLevel() < render::finestHatchLevel);
    QVERIFY(layout.spacing(layout.lastLevel()) > 10.0f);
    QVERIFY(layout.spacing(layout.lastLevel() + 1) < 20.0f);
  }

  void sameEveryTime() {
    const Subject torus = torusSubject();
    const render::Hatching a = torus.hatched(orthographic(slanted, 24.0f));
    const render::Hatching b = torus.hatched(orthographic(slanted, 24.0f));
    QCOMPARE(a.strokes.size(), b.strokes.size());
    for (std::size_t i = 0; i < a.points.size(); ++i)
      QCOMPARE(a.points[i].position, b.points[i].position);
  }

  void nothingFromNothing() {
    const Subject torus = torusSubject();
    const model::Camera away{.eye = {0, -100, 0}, .target = {0, -200, 0}};
    QVERIFY(torus.hatched(away).strokes.empty());
    const Subject flat(test::paraboloid(0.0f, 0.0f, 5.0f, 8));
    QVERIFY(flat.hatched(orthographic(slanted, 24.0f), {.twoSided = true}).strokes.empty());
  }
};

SLINE_TEST(HatchingTest)
#include "hatching_test.moc"
