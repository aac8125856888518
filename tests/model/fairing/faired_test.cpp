// SPDX-License-Identifier: Apache-2.0
#include "model/fairing/faired.h"

#include <QtTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <map>

#include "model/geometry/extent.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

constexpr float slice = 2.0f;

/// Returns a height between slices: rounded to the middle of its slice, with a ramp to the next, as
/// a label map's surface has.
float stepped(float z) {
  const float at = z / slice;
  const float whole = std::floor(at);
  const float ramp = std::clamp((at - whole - 0.35f) / 0.3f, 0.0f, 1.0f);
  return slice * (whole + ramp);
}

/// Returns a ball of that radius of which each slice has the radius of its middle.
MeshPtr terracedBall(float radius) {
  const MeshPtr ball = test::sphere(radius, 6);
  std::vector<glm::vec3> positions(ball->positions().begin(), ball->positions().end());
  for (glm::vec3& p : positions)
    p.z = stepped(p.z);
  return std::make_shared<const Mesh>(
      *Mesh::create(positions, {ball->triangles().begin(), ball->triangles().end()}));
}

/// Returns a tube along z whose every slice lies a little off the axis, as slices drawn by hand do.
MeshPtr wanderingTube(float radius, float length) {
  const MeshPtr tube = test::cylinder(radius, length, 16, int(length));
  std::vector<glm::vec3> positions(tube->positions().begin(), tube->positions().end());
  for (glm::vec3& p : positions) {
    const float number = std::floor(p.z / slice);
    p.x += 0.5f * std::sin(2.4f * number);
    p.y += 0.5f * std::sin(1.3f * number + 1.0f);
  }
  return std::make_shared<const Mesh>(
      *Mesh::create(positions, {tube->triangles().begin(), tube->triangles().end()}));
}

double rms(const Mesh& mesh, float (*error)(const glm::vec3&)) {
  double sum = 0.0;
  for (const glm::vec3& p : mesh.positions())
    sum += std::pow(double(error(p)), 2.0);
  return std::sqrt(sum / double(mesh.vertexCount()));
}

float farthest(const Mesh& a, const Mesh& b) {
  float most = 0.0f;
  for (std::size_t v = 0; v < a.vertexCount(); ++v)
    most = std::max(most, glm::distance(a.positions()[v], b.positions()[v]));
  return most;
}

/// Returns the mean distance of the tube's middle part from the middle of its own ring.
double thickness(const Mesh& tube, float length) {
  std::map<int, std::pair<glm::dvec2, int>> rings;
  const auto ringOf = [](const glm::vec3& p) { return int(std::floor(p.z)); };
  for (const glm::vec3& p : tube.positions()) {
    auto& [sum, count] = rings[ringOf(p)];
    sum += glm::dvec2(p);
    ++count;
  }
  double sum = 0.0;
  int count = 0;
  for (const glm::vec3& p : tube.positions()) {
    if (std::abs(p.z - tube.bounds().centre().z) > 0.35f * length)
      continue;
    const auto& [middle, points] = rings.at(ringOf(p));
    sum += glm::length(glm::dvec2(p) - middle / double(points));
    ++count;
  }
  return sum / count;
}

}  // namespace

class FairedTest : public QObject {
  Q_OBJECT
 private slots:
  void withoutSlicesItIsTheSame();
  void terracesOfABallGo();
  void thinTubesKeepTheirWidth();
  void bordersStay();
  void largerFormsLeaveNoWavesBesideAnEdge();
  void smallFormsGoAsAGaussianTakesThem();
};

void FairedTest::withoutSlicesItIsTheSame() {
  const MeshPtr ball = test::sphere(20.0f, 3);
  QCOMPARE(faired(ball, 0.0f), ball);
}

void FairedTest::terracesOfABallGo() {
  const MeshPtr before = terracedBall(40.0f);
  const MeshPtr after = faired(before, slice);
  const auto error = [](const glm::vec3& p) { return glm::length(p) - 40.0f; };
  const double was = rms(*before, error);
  const double is = rms(*after, error);
  QVERIFY2(is < 0.4 * was, qPrintable(QString("%1 → %2 mm").arg(was).arg(is)));
  QVERIFY(farthest(*before, *after) <= fairingShare * slice + 1e-4f);
  const double volume = *extentOf(*before).volume;
  QVERIFY(std::abs(*extentOf(*after).volume / volume - 1.0) < 0.01);
  QVERIFY(before->triangles().size() == after->triangles().size());
}

void FairedTest::thinTubesKeepTheirWidth() {
  const MeshPtr before = wanderingTube(3.0f, 80.0f);
  const MeshPtr after = faired(before, slice);
  const double was = thickness(*before, 80.0f);
  const double is = thickness(*after, 80.0f);
  QVERIFY2(std::abs(is / was - 1.0) < 0.03, qPrintable(QString("%1 → %2 mm").arg(was).arg(is)));
  // The borders stay where they are, and what lies near them with them.
  const auto off = [](const glm::vec3& p) {
    return std::abs(p.z) < 25.0f ? glm::length(glm::vec2(p)) - 3.0f : 0.0f;
  };
  QVERIFY2(rms(*after, off) < 0.6 * rms(*before, off),
           qPrintable(QString("%1 → %2 mm").arg(rms(*before, off)).arg(rms(*after, off))));
}

void FairedTest::bordersStay() {
  const MeshPtr before = wanderingTube(6.0f, 60.0f);
  const MeshPtr after = faired(before, slice);
  for (std::size_t v = 0; v < before->vertexCount(); ++v) {
    const glm::vec3& p = before->positions()[v];
    if (p.z == before->bounds().low.z || p.z == before->bounds().high.z)
      QCOMPARE(glm::distance(after->positions()[v], p), 0.0f);
  }
}

/// Returns a sheet in the plane z = 0, bent by that function of x.
static MeshPtr bent(float (*height)(float)) {
  const MeshPtr flat = test::paraboloid(0.0f, 0.0f, 40.0f, 80);
  std::vector<glm::vec3> positions(flat->positions().begin(), flat->positions().end());
  for (glm::vec3& p : positions)
    p.z = height(p.x);
  return std::make_shared<const Mesh>(
      *Mesh::create(positions, {flat->triangles().begin(), flat->triangles().end()}));
}

void FairedTest::largerFormsLeaveNoWavesBesideAnEdge() {
  const MeshPtr step = bent([](float x) { return x < 0.3f ? 0.0f : 5.0f; });
  const MeshPtr soft = withoutSmallForms(*step, 3.0f);
  float steepest = 0.0f;
  for (const glm::vec3& p : soft->positions()) {
    QVERIFY2(p.z > -0.01f && p.z < 5.01f, qPrintable(QString::number(p.z)));
    if (std::abs(p.y) < 20.0f && std::abs(p.x - 0.3f) < 1.5f)
      steepest = std::max(steepest, std::abs(p.z - 2.5f));
  }
  QVERIFY(steepest < 1.2f);
}

void FairedTest::smallFormsGoAsAGaussianTakesThem() {
  constexpr float deviation = 3.0f;
  const MeshPtr waves = bent([](float x) { return std::sin(0.35f * x); });
  const MeshPtr soft = withoutSmallForms(*waves, deviation);
  float highest = 0.0f;
  for (const glm::vec3& p : soft->positions())
    if (std::max(std::abs(p.x), std::abs(p.y)) < 22.0f)
      highest = std::max(highest, p.z);
  const float wanted = std::exp(-0.5f * std::pow(0.35f * deviation, 2.0f));
  // A grid's edges are not all alike.
  QVERIFY2(std::abs(highest - wanted) < 0.12f,
           qPrintable(QString("%1, not %2").arg(highest).arg(wanted)));
}

SLINE_TEST(FairedTest)
#include "faired_test.moc"
