// SPDX-License-Identifier: Apache-2.0
// Looks at which streamlines ConFIS draws from a camera, and how strongly.
#include "render/lines/techniques/confis.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using render::LineKind;
using render::Segment;

namespace {

constexpr float degree = 0.0174532925f;

model::Camera fromFront(float heightMm, float turned = 0.0f) {
  return {.projection = model::Projection::orthographic,
          .eye = {80.0f * std::sin(turned), -80.0f * std::cos(turned), 0},
          .target = {0, 0, 0},
          .up = {0, 0, 1},
          .heightMm = heightMm};
}

std::vector<Segment> confis(const model::Surface& surface, const model::Camera& camera,
                            render::LineRequest request = {}) {
  request.kinds = {LineKind::confis};
  request.twoSided = render::needsTwoSides(surface, camera);
  return render::extractLines(surface, camera, request)[LineKind::confis];
}

render::LineRequest with(render::ConfisThreshold which, float value) {
  render::LineRequest request;
  request.thresholds.set(LineKind::confis, which, value);
  return request;
}

double lengthOf(const std::vector<Segment>& segments) {
  double length = 0.0;
  for (const Segment& s : segments)
    length += double(0.5f * (s.opacityA + s.opacityB) * glm::distance(s.a, s.b));
  return length;
}

/// A tube around z with a waist every 4 mm, or seen from within the same.
model::MeshPtr ringedTube(bool insideOut) {
  const model::MeshPtr smooth = test::cylinder(3, 40, 72, 320);
  std::vector<glm::vec3> positions(smooth->positions().begin(), smooth->positions().end());
  for (glm::vec3& p : positions) {
    const float share = 1.0f + 0.02f * std::cos(2.0f * 3.14159265f * p.z / 4.0f);
    p = {share * p.x, share * p.y, p.z};
  }
  std::vector<model::Triangle> triangles(smooth->triangles().begin(), smooth->triangles().end());
  if (insideOut)
    for (model::Triangle& t : triangles)
      std::swap(t[1], t[2]);
  return std::make_shared<const model::Mesh>(
      model::Mesh::create(std::move(positions), std::move(triangles)).value());
}

}  // namespace

class ConfisTest : public QObject {
  Q_OBJECT
 private slots:
  /// nv ≤ √(T·κv·(2 − T·κv)) with T·κv held to 0 … 1.
  void marginsFollowTheCurvature() {
    using render::marginStrength;
    for (const float x : {0.05f, 0.3f, 0.8f, 1.0f}) {
      const float edge = std::sqrt(x * (2.0f - x));
      QCOMPARE(marginStrength(0.0f, x / 0.2f, 0.2f), 1.0f);
      QVERIFY(marginStrength(0.99f * edge, x / 0.2f, 0.2f) > 0.0f);
      QCOMPARE(marginStrength(1.01f * edge, x / 0.2f, 0.2f), 0.0f);
    }
    QCOMPARE(marginStrength(0.5f, 1000.0f, 1.0f), marginStrength(0.5f, 1.0f, 1.0f));
    QCOMPARE(marginStrength(0.0f, 0.0f, 0.2f), 0.0f);
    QCOMPARE(marginStrength(0.1f, -1.0f, 0.2f), 0.0f);
  }

  /// On a tube seen from the side the margin ends 32° from the contour; strokes fade from there
  /// over 60° at most, and never grow darker on their way.
  void strokesLeaveTheContourAndFade() {
    const model::SurfacePtr tube = model::prepareSurface(test::cylinder(3, 20, 96, 120));
    const std::vector<Segment> found = confis(*tube, fromFront(24));
    QVERIFY(found.size() > 200);
    std::array<float, 9> darkest{};
    for (const Segment& s : found) {
      const glm::vec3 middle = 0.5f * (s.a + s.b);
      const float angle = std::asin(std::clamp(std::abs(middle.x) / 3.0f, 0.0f, 1.0f));
      float& most = darkest[std::size_t((90.0f - angle / degree) / 10.01f)];
      most = std::max({most, s.opacityA, s.opacityB});
      QVERIFY(std::abs(s.a.z - s.b.z) < 0.05f * glm::distance(s.a, s.b) + 0.01f);
    }
    QVERIFY(darkest[0] > 0.9f);
    QVERIFY(std::is_sorted(darkest.rbegin(), darkest.rend()));
    QVERIFY(darkest[4] > 0.3f && darkest[4] < 0.75f);
    QVERIFY(darkest[8] < 0.2f);
  }

  void wholeContoursHaveStrokes() {
    const model::SurfacePtr tube = model::prepareSurface(test::cylinder(3, 20, 96, 120));
    const std::vector<Segment> found = confis(*tube, fromFront(24));
    // 5 λ are 0.17 mm: on either side every 2 mm have some.
    for (const float side : {-1.0f, 1.0f})
      for (float z = -8.0f; z <= 8.0f; z += 2.0f) {
        const auto near = std::count_if(found.begin(), found.end(), [&](const Segment& s) {
          return side * s.a.x > 2.5f && std::abs(s.a.z - z) < 1.0f && s.opacityA > 0.5f;
        });
        QVERIFY2(near >= 5, qPrintable(QString("%1 at %2").arg(near).arg(z)));
      }
  }

  void thresholdsDecide() {
    const model::SurfacePtr ring = model::prepareSurface(test::torus(10, 3, 240, 90));
    const model::Camera camera = fromFront(30);
    using enum render::ConfisThreshold;
    const double usual = lengthOf(confis(*ring, camera));
    QVERIFY(lengthOf(confis(*ring, camera, with(contourMargin, 0.4f))) > 1.1 * usual);
    QVERIFY(lengthOf(confis(*ring, camera, with(leastFeature, 0.2f))) > 1.02 * usual);
    QVERIFY(lengthOf(confis(*ring, camera, with(lineSpacing, 10.0f))) < 0.7 * usual);
    render::LineRequest none = with(contourMargin, 0.0f);
    none.thresholds.set(LineKind::confis, leastFeature, 8.0f);
    QVERIFY(confis(*ring, camera, none).empty());
    for (const render::LineThreshold& t : render::confisThresholds)
      QVERIFY(t.limits.contain(t.usual) && t.id[0] != '\0' && t.meaning[0] != '\0');
  }

  /// Half as large in the picture: lines are twice as far apart on the surface.
  void spacingIsThatOfThePicture() {
    const model::SurfacePtr ring = model::prepareSurface(test::torus(10, 3, 360, 120));
    const double near = lengthOf(confis(*ring, fromFront(40)));
    const double far = lengthOf(confis(*ring, fromFront(80)));
    QVERIFY2(far < 0.7 * near && far > 0.35 * near, qPrintable(QString::number(far / near)));
  }

  /// While the camera turns each piece of a line stays where it is and changes a little.
  void turningIsSteady() {
    const model::SurfacePtr ring = model::prepareSurface(test::torus(10, 3, 240, 90));
    using Key = std::tuple<float, float, float>;
    std::map<Key, float> before;
    for (const Segment& s : confis(*ring, fromFront(30)))
      before[{s.a.x, s.a.y, s.a.z}] = s.opacityA;
    int met = 0;
    float most = 0.0f;
    for (const Segment& s : confis(*ring, fromFront(30, 0.5f * degree)))
      if (const auto same = before.find({s.a.x, s.a.y, s.a.z}); same != before.end()) {
        ++met;
        most = std::max(most, std::abs(s.opacityA - same->second));
      } else {
        most = std::max(most, s.opacityA - 0.02f);
      }
    QVERIFY(met > 1000);
    QVERIFY2(most < 0.15f, qPrintable(QString::number(most)));
  }

  void scaleChangesNothing() {
    const model::MeshPtr mesh = test::torus(10, 3, 120, 45);
    const auto one = confis(*model::prepareSurface(mesh), fromFront(30));
    model::Camera camera = fromFront(30 * 1024.0f);
    camera.eye *= 1024.0f;
    const auto other =
        confis(*model::prepareSurface(test::moved(*mesh, 1024.0f, glm::vec3(0.0f))), camera);
    QVERIFY(!one.empty());
    QCOMPARE(other.size(), one.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      QVERIFY(glm::distance(other[i].a / 1024.0f, one[i].a) < 1e-4f);
      QVERIFY(std::abs(other[i].opacityA - one[i].opacityA) < 1e-3f);
    }
  }

  void whatIsOutsideThePictureIsLeftOut() {
    const model::SurfacePtr ring = model::prepareSurface(test::torus(10, 3, 240, 90));
    render::LineRequest request;
    request.aspect = 1.0f;
    const auto all = confis(*ring, fromFront(6));
    const auto some = confis(*ring, fromFront(6), request);
    QVERIFY(some.size() < all.size());
    for (const Segment& s : all)
      if (std::abs(s.a.x) < 3.0f && std::abs(s.a.z) < 3.0f)
        QVERIFY(std::any_of(some.begin(), some.end(),
                            [&](const Segment& t) { return t.a == s.a && t.b == s.b; }));
  }

  /// Seen along a bumpy tube from within, strokes ring it, whichever side its triangles face.
  void tubesAreRingedFromWithin_data() {
    QTest::addColumn<bool>("insideOut");
    QTest::newRow("normals outwards") << false;
    QTest::newRow("normals inwards") << true;
  }
  void tubesAreRingedFromWithin() {
    QFETCH(bool, insideOut);
    const model::SurfacePtr tube = model::prepareSurface(ringedTube(insideOut));
    const model::Camera camera{.projection = model::Projection::perspective,
                               .eye = {0.3f, 0.2f, 19},
                               .target = {0, 0, 0},
                               .up = {0, 1, 0}};
    const std::vector<Segment> found = confis(*tube, camera);
    QVERIFY(lengthOf(found) > 40.0);
    double along = 0.0;
    double across = 0.0;
    for (const Segment& s : found) {
      along += double(std::abs(s.a.z - s.b.z));
      across += double(std::hypot(s.a.x - s.b.x, s.a.y - s.b.y));
      QVERIFY(glm::dot(s.normalA, camera.eye - s.a) >= 0.0f);
    }
    QVERIFY2(along < 0.1 * across, qPrintable(QString("%1 : %2").arg(along).arg(across)));
  }

  void entersFromOneToThree() {
    QCOMPARE(render::confisEntered(Gamma::clamped(1)), 0.0f);
    QCOMPARE(render::confisEntered(Gamma::clamped(2)), 0.5f);
    QCOMPARE(render::confisEntered(Gamma::clamped(3)), 1.0f);
    QCOMPARE(render::confisEntered(Gamma::clamped(5)), 1.0f);
    const model::SurfacePtr ring = model::prepareSurface(test::torus(10, 3, 120, 45));
    std::vector<Segment> found = confis(*ring, fromFront(30));
    render::rankConfisLines(found, *ring, fromFront(30), 0.5f);
    double early = 0.0;
    double late = 0.0;
    for (const Segment& s : found)
      (s.entryA < 0.5f ? early : late) += double(glm::distance(s.a, s.b));
    QVERIFY(early > 0.3 * late && late > 0.3 * early);
  }
};

SLINE_TEST(ConfisTest)
#include "confis_test.moc"
