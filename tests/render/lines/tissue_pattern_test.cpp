// SPDX-License-Identifier: Apache-2.0
#include "render/lines/patterns/tissue_pattern.h"

#include <QTest>
#include <cmath>

#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::render {
namespace {

using model::CutPattern;
using model::Plane;

constexpr float ballRadius = 30.0f;

CutFace discAt(const Plane& plane) {
  static const model::SurfacePtr ball = model::prepareSurface(test::sphere(ballRadius, 5));
  return cutFaces(*ball, std::span(&plane, 1))[0];
}

const Plane sagittal{{1.0f, 0.0f, 0.0f}, 4.0f};

TissuePatternRequest request(CutPattern pattern, double spacing) {
  return {.pattern = pattern, .spacing = spacing, .fibres = {0.0f, 0.6f, 0.8f}};
}

/// Returns how many of the points that pass the test have no partner in `others` within 0.001 mm,
/// seen along x.
template <class Test>
int strangers(const Hatching& some, const Hatching& others, const Test& counts) {
  int strangers = 0;
  for (const HatchPoint& p : some.points) {
    if (!counts(p.position))
      continue;
    const bool met = std::any_of(others.points.begin(), others.points.end(), [&](const auto& q) {
      return std::hypot(p.position.y - q.position.y, p.position.z - q.position.z) < 1e-3f;
    });
    strangers += met ? 0 : 1;
  }
  return strangers;
}

void addPatterns() {
  QTest::addColumn<int>("pattern");
  for (std::size_t i = 1; i < model::cutPatternNames.size(); ++i)
    if (CutPattern(i) != CutPattern::blank)
      QTest::newRow(std::string(model::cutPatternNames[i]).c_str()) << int(i);
}

}  // namespace

class TissuePatternTest : public QObject {
  Q_OBJECT

 private slots:
  void marksStayWithinTheRim_data() { addPatterns(); }
  void marksStayWithinTheRim();
  void otherPlanesEndThem_data() { addPatterns(); }
  void otherPlanesEndThem();
  void finerSpacingMoreMarks_data() { addPatterns(); }
  void finerSpacingMoreMarks();
  void aMovedPlaneKeepsThem();
  void aWindowShowsThem();
  void patternsDiffer();
  void fibresFollowTheirDirection();
  void largeFacesAreCapped();
  void spacingFollowsScaleInSteps();
  void rimOfADisc();
};

void TissuePatternTest::marksStayWithinTheRim() {
  QFETCH(int, pattern);
  const Hatching drawn = tissuePattern(discAt(sagittal), {}, request(CutPattern(pattern), 2.0));
  QVERIFY(drawn.strokes.size() > 20);
  const double rim = std::sqrt(double(ballRadius * ballRadius) - 16.0);
  for (const HatchStroke& stroke : drawn.strokes) {
    QVERIFY(stroke.count > 0 && stroke.first + stroke.count <= drawn.points.size());
    for (std::uint32_t i = stroke.first; i < stroke.first + stroke.count; ++i) {
      const HatchPoint& p = drawn.points[i];
      QVERIFY(std::abs(p.position.x - 4.0f) < 1e-4f);
      QVERIFY(std::hypot(double(p.position.y), double(p.position.z)) < rim);
      QVERIFY(p.normal == sagittal.normal);
      QVERIFY(p.halfWidth > 0.1f && p.halfWidth < 1.0f);
    }
  }
}

void TissuePatternTest::otherPlanesEndThem() {
  QFETCH(int, pattern);
  const Plane other{{0.0f, 0.0f, 1.0f}, 3.3f};
  const TissuePatternRequest wanted = request(CutPattern(pattern), 2.0);
  const Hatching cut = tissuePattern(discAt(sagittal), std::span(&other, 1), wanted);
  QVERIFY(!cut.points.empty());
  for (const HatchPoint& p : cut.points)
    QVERIFY(p.position.z < 3.3001f);
}

void TissuePatternTest::finerSpacingMoreMarks() {
  QFETCH(int, pattern);
  const CutFace disc = discAt(sagittal);
  const auto count = [&](double spacing) {
    return double(tissuePattern(disc, {}, request(CutPattern(pattern), spacing)).strokes.size());
  };
  // Marks along the rim grow with one over the spacing, the others with its square.
  const double growth = count(0.5) / count(1.0);
  const bool rim =
      CutPattern(pattern) == CutPattern::wall || CutPattern(pattern) == CutPattern::rim;
  QVERIFY2(growth > (rim ? 1.7 : 2.8) && growth < (rim ? 2.4 : 5.0),
           qPrintable(QString::number(growth)));
}

/// A plane that moves along its normal leaves marks deep within the face where they were.
void TissuePatternTest::aMovedPlaneKeepsThem() {
  const auto deep = [](const glm::vec3& p) { return std::hypot(p.y, p.z) < 20.0f; };
  for (const CutPattern pattern : {CutPattern::cells, CutPattern::fibres, CutPattern::fascicles}) {
    const Hatching here = tissuePattern(discAt(sagittal), {}, request(pattern, 2.0));
    Plane further = sagittal;
    further.offset = 5.5f;
    const Hatching there = tissuePattern(discAt(further), {}, request(pattern, 2.0));
    QVERIFY(!here.points.empty());
    QCOMPARE(strangers(here, there, deep), 0);
  }
}

void TissuePatternTest::aWindowShowsThem() {
  TissuePatternRequest wanted = request(CutPattern::spongy, 1.0);
  const Hatching whole = tissuePattern(discAt(sagittal), {}, wanted);
  wanted.window = PlaneWindow{{-12.0, -9.0}, {6.0, 14.0}};
  const Hatching part = tissuePattern(discAt(sagittal), {}, wanted);
  QVERIFY(part.points.size() > 100 && part.points.size() < whole.points.size() / 2);
  const auto within = [](const glm::vec3& p) {
    const model::PlaneAxes axes = model::axesOf(sagittal);
    const double u = glm::dot(axes.u, glm::dvec3(p));
    const double v = glm::dot(axes.v, glm::dvec3(p));
    return u > -10.0 && u < 4.0 && v > -7.0 && v < 12.0;
  };
  QCOMPARE(strangers(whole, part, within), 0);
  QCOMPARE(strangers(part, whole, within), 0);
}

void TissuePatternTest::patternsDiffer() {
  const CutFace disc = discAt(sagittal);
  QVERIFY(tissuePattern(disc, {}, request(CutPattern::plain, 1.0)).points.empty());
  QVERIFY(tissuePattern(CutFace{.plane = sagittal}, {}, request(CutPattern::cells, 1.0))
              .points.empty());
  // Dots of parenchyma are sparse, a lesion is dark.
  const auto ink = [&](CutPattern pattern) {
    const Hatching drawn = tissuePattern(disc, {}, request(pattern, 1.0));
    double sum = 0.0;
    for (const HatchStroke& s : drawn.strokes) {
      double length = s.count == 1 ? 0.2 : 0.0;
      for (std::uint32_t i = s.first; i + 1 < s.first + s.count; ++i)
        length += double(glm::distance(drawn.points[i].position, drawn.points[i + 1].position));
      sum += length;
    }
    return sum;
  };
  QVERIFY(ink(CutPattern::stipple) < 0.3 * ink(CutPattern::crossed));
  QVERIFY(ink(CutPattern::lacunae) < 0.3 * ink(CutPattern::fascicles));
  QVERIFY(ink(CutPattern::waterlines) < ink(CutPattern::fibres));
}

void TissuePatternTest::fibresFollowTheirDirection() {
  TissuePatternRequest wanted = request(CutPattern::fibres, 1.0);
  const auto longest = [&] {
    const Hatching drawn = tissuePattern(discAt(sagittal), {}, wanted);
    float most = 0.0f;
    for (const HatchStroke& s : drawn.strokes) {
      const glm::vec3 along =
          drawn.points[s.first + s.count - 1].position - drawn.points[s.first].position;
      most = std::max(most, glm::length(along));
      // Short rests at the rim may bend away by the wave of a stroke.
      if (glm::length(along) > 2.0f &&
          glm::length(glm::cross(glm::normalize(along), glm::vec3(0.0f, 0.6f, 0.8f))) > 0.2f)
        return -1.0f;
    }
    return most;
  };
  QVERIFY(longest() > 3.0f);
  // Fibres that stand on the face are short.
  wanted.fibres = {1.0f, 0.0f, 0.0f};
  QVERIFY(longest() < 1.5f);
}

void TissuePatternTest::largeFacesAreCapped() {
  const Hatching drawn = tissuePattern(discAt(sagittal), {}, request(CutPattern::cells, 0.001));
  QVERIFY(!drawn.strokes.empty());
  QVERIFY2(drawn.strokes.size() < 60'000, qPrintable(QString::number(drawn.strokes.size())));
}

void TissuePatternTest::spacingFollowsScaleInSteps() {
  for (double unit = 0.01; unit < 20.0; unit *= 1.07) {
    const double spacing = patternSpacing(unit);
    const double least = leastPatternSpacing * unit;
    QVERIFY(spacing >= least * (1.0 - 1e-9) && spacing < patternStep * least);
    const double step = std::log2(spacing) / std::log2(patternStep);
    QVERIFY(std::abs(step - std::round(step)) < 1e-9);
  }
}

void TissuePatternTest::rimOfADisc() {
  const CutFace disc = discAt(sagittal);
  const double radius = std::sqrt(double(ballRadius * ballRadius) - 16.0);
  const FaceField field(disc, *windowOf(disc), 0.25);
  for (double r = 0.0; r < radius + 4.0; r += 0.9)
    for (double angle = 0.0; angle < 6.28; angle += 0.5) {
      const glm::dvec2 p(r * std::cos(angle), r * std::sin(angle));
      QVERIFY2(std::abs(field.rim(p) - std::max(radius - r, 0.0)) < 0.375,
               qPrintable(QString("%1 at %2").arg(field.rim(p)).arg(r)));
      if (r > 5.0 && r < radius - 1.0)
        QVERIFY(glm::dot(field.inwards(p), -p / r) > 0.97);
    }
}

}  // namespace sline::render

SLINE_TEST(sline::render::TissuePatternTest)
#include "tissue_pattern_test.moc"
