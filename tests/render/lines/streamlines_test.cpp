// SPDX-License-Identifier: Apache-2.0
// Follows streamlines of the principal directions over surfaces on which these are known, and looks
// at how they are laid out for ConFIS.
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "render/lines/streamlines/mean_curvature_features.h"
#include "render/lines/streamlines/streamline_layout.h"
#include "render/lines/streamlines/streamline_tracer.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"
#include "tests/support/torus.h"

using namespace sline;
using render::TracedPoint;

namespace {

/// A surface with all that is needed to follow lines on it.
struct Ground {
  model::SurfacePtr surface;
  model::FaceNeighbours neighbours;
  render::PrincipalField field;
  render::StreamlineTracer tracer;

  explicit Ground(const model::MeshPtr& mesh)
      : surface(model::prepareSurface(mesh)),
        neighbours(*mesh),
        field(*surface),
        tracer(field, neighbours) {}
};

/// Steps of Runge and Kutta, a thousandth of the inradius long, in one triangle after the other,
/// each left by halving the last step.
class SteppedLine {
 public:
  explicit SteppedLine(const Ground& ground) : m_ground(ground) {}

  glm::dvec3 placeAfter(std::uint32_t triangle, const glm::dvec3& direction, double length) {
    m_triangle = triangle;
    m_at = glm::dvec2(1.0 / 3.0);
    m_direction = direction;
    m_left = length;
    while (inTriangle()) {
    }
    return m_ground.field.frame(m_triangle).place(m_at);
  }

 private:
  static bool inside(const glm::dvec2& at) {
    const auto c = render::barycentric(at);
    return c[0] >= 0.0 && c[1] >= 0.0 && c[2] >= 0.0;
  }

  static glm::dvec2 step(const render::LinearFlow& flow, const glm::dvec2& at, double h) {
    const glm::dvec2 k1 = flow.velocity(at);
    const glm::dvec2 k2 = flow.velocity(at + 0.5 * h * k1);
    const glm::dvec2 k3 = flow.velocity(at + 0.5 * h * k2);
    const glm::dvec2 k4 = flow.velocity(at + h * k3);
    return at + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }

  bool inTriangle() {
    const render::PrincipalField::Frame frame = m_ground.field.frame(m_triangle);
    const render::LinearFlow flow = m_ground.field.flow(m_triangle, frame, m_direction);
    while (true) {
      double h = 1e-3 * frame.inradius / glm::length(frame.along(flow.velocity(m_at)));
      glm::dvec2 next = step(flow, m_at, h);
      const bool leaves = !inside(next);
      if (leaves)
        for (double low = 0.0, high = h; high - low > 1e-14 * h;) {
          h = 0.5 * (low + high);
          next = step(flow, m_at, h);
          (inside(next) ? low : high) = h;
        }
      const glm::dvec3 piece = frame.along(next - m_at);
      if (glm::length(piece) >= m_left) {
        m_at += m_left / glm::length(piece) * (next - m_at);
        return false;
      }
      m_left -= glm::length(piece);
      m_at = next;
      m_direction = glm::normalize(frame.along(flow.velocity(m_at)));
      if (leaves)
        return cross();
    }
  }

  bool cross() {
    const auto here = render::barycentric(m_at);
    const int side = int(std::min_element(here.begin(), here.end()) - here.begin());
    const std::uint32_t next = m_ground.neighbours.across(m_triangle, side);
    if (next == model::FaceNeighbours::none)
      return false;
    const glm::dvec3 place = m_ground.field.frame(m_triangle).place(m_at);
    const render::PrincipalField::Frame frame = m_ground.field.frame(next);
    m_at = frame.components(place - frame.origin);
    m_at = glm::max(m_at, glm::dvec2(0.0));
    m_triangle = next;
    return true;
  }

  const Ground& m_ground;
  std::uint32_t m_triangle = 0;
  glm::dvec2 m_at{0.0};
  glm::dvec3 m_direction{0.0};
  double m_left = 0.0;
};

/// Returns how many lines do not keep their way for `length` mm on a surface without end.
int brokenLines(const Ground& ground, std::uint32_t every) {
  int broken = 0;
  for (std::uint32_t i = 0; i < ground.surface->mesh->triangleCount(); i += every) {
    const double length = ground.tracer.length(i);
    const std::vector<TracedPoint> line = ground.tracer.trace({i}, true, length);
    if (line.empty() || line.back().way < 0.999 * length)
      ++broken;
  }
  return broken;
}

}  // namespace

class StreamlinesTest : public QObject {
  Q_OBJECT
 private slots:
  /// On a torus the lines of the stronger curvature go around the tube, each in its own plane.
  void linesRingATorus() {
    const test::Torus torus{10.0, 3.0};
    const Ground ground(test::torus(10, 3, 240, 90));
    for (std::uint32_t i = 0; i < ground.surface->mesh->triangleCount(); i += 531) {
      const double length = ground.tracer.length(i);
      QVERIFY(std::abs(length - M_PI) < 0.05);  // π/(3/3)
      const std::vector<TracedPoint> line = ground.tracer.trace({i}, true, length);
      QVERIFY(line.size() > 10);
      const double u = torus.at(line.front().place).u;
      for (const TracedPoint& p : line)
        QVERIFY(std::abs(std::remainder(torus.at(p.place).u - u, 2.0 * M_PI)) < 0.01);
      QVERIFY(std::abs(line.back().way - length) < 1e-9);
      const double turned = std::remainder(
          torus.at(line.back().place).v - torus.at(line.front().place).v, 2.0 * M_PI);
      QVERIFY(std::abs(std::abs(turned) - M_PI / 3.0) < 0.02);
    }
    QCOMPARE(brokenLines(ground, 13), 0);
  }

  void bothWaysAreOpposite() {
    const Ground ground(test::torus(10, 3, 120, 45));
    const std::vector<TracedPoint> ahead = ground.tracer.trace({700}, true, 1.0);
    const std::vector<TracedPoint> back = ground.tracer.trace({700}, false, 1.0);
    QVERIFY(ahead.front().place == back.front().place);
    const glm::dvec3 one = glm::normalize(ahead[1].place - ahead[0].place);
    const glm::dvec3 other = glm::normalize(back[1].place - back[0].place);
    QVERIFY(glm::dot(one, other) < -0.99);
  }

  void agreesWithSmallSteps() {
    const auto onTorus = [](const glm::vec3& p) {
      const test::Torus shape{10.0, 3.0};
      return glm::vec3(shape.position(shape.at(glm::dvec3(p))));
    };
    const Ground ground(test::jittered(*test::torus(10, 3, 60, 24), 0.3f, 5, onTorus));
    int compared = 0;
    for (std::uint32_t i = 3; i < ground.surface->mesh->triangleCount(); i += 97) {
      const std::vector<TracedPoint> line = ground.tracer.trace({i}, true, 2.0);
      if (line.empty() || line.back().way < 2.0 - 1e-9)
        continue;
      // Steps measure the way along the curve, pieces along chords no longer than an inradius.
      SteppedLine stepped(ground);
      const glm::dvec3 place = stepped.placeAfter(i, ground.field.direction(i), 2.0);
      const glm::dvec3 end = line.back().place;
      const glm::dvec3 before = line[line.size() - 2].place;
      const glm::dvec3 off = place - end;
      const glm::dvec3 along = glm::normalize(end - before);
      QVERIFY2(glm::length(off - glm::dot(off, along) * along) < 1e-6,
               qPrintable(QString::number(glm::length(off - glm::dot(off, along) * along))));
      ++compared;
    }
    QVERIFY(compared > 20);
  }

  void linesStayOnTheSurface_data() {
    QTest::addColumn<int>("which");
    QTest::newRow("torus") << 0;
    QTest::newRow("saddle with a border") << 1;
    QTest::newRow("rough ball") << 2;
    QTest::newRow("tube") << 3;
  }
  void linesStayOnTheSurface() {
    QFETCH(int, which);
    const auto onBumps = [](const glm::vec3& p) {
      const glm::vec3 n = glm::normalize(p);
      return (5.0f + 0.4f * std::sin(7.0f * n.x) * std::cos(6.0f * n.y)) * n;
    };
    const model::MeshPtr mesh = which == 0   ? test::torus(10, 3, 60, 24)
                                : which == 1 ? test::paraboloid(0.5f, -0.3f, 2.0f, 40)
                                : which == 2
                                    ? test::jittered(*test::sphere(5, 4), 0.35f, 3, onBumps)
                                    : test::cylinder(3, 20, 24, 30);
    const Ground ground(mesh);
    std::size_t points = 0;
    for (std::uint32_t i = 0; i < mesh->triangleCount(); i += 3)
      for (const bool along : {true, false})
        for (const TracedPoint& p : ground.tracer.trace({i}, along, ground.tracer.length(i))) {
          for (const double c : render::barycentric(p.at))
            QVERIFY(c >= -1e-12 && c <= 1.0 + 1e-12);
          const glm::dvec3 there = ground.field.frame(p.triangle).place(p.at);
          QVERIFY(glm::length(there - p.place) < 1e-9);
          ++points;
        }
    QVERIFY(points > 1000);
  }

  /// From one point to the next a line lies in one triangle, so no chord leaves the surface.
  void neighboursShareATriangle() {
    const Ground ground(test::torus(10, 3, 60, 24));
    for (std::uint32_t i = 0; i < ground.surface->mesh->triangleCount(); i += 17) {
      const std::vector<TracedPoint> line = ground.tracer.trace({i}, true, ground.tracer.length(i));
      for (std::size_t k = 1; k < line.size(); ++k) {
        const render::PrincipalField::Frame frame = ground.field.frame(line[k].triangle);
        const glm::dvec2 before = frame.components(line[k - 1].place - frame.origin);
        QVERIFY(glm::length(frame.place(before) - line[k - 1].place) < 1e-6);
        for (const double c : render::barycentric(before))
          QVERIFY(c > -1e-6 && c < 1.0 + 1e-6);
      }
    }
  }

  void nothingStartsOnAnUmbilic() {
    const Ground ball(test::sphere(5, 4));
    for (std::uint32_t i = 0; i < ball.surface->mesh->triangleCount(); ++i)
      QVERIFY(ball.tracer.trace({i}, true, 1.0).empty());
    const Ground flat(test::paraboloid(0, 0, 2, 10));
    for (std::uint32_t i = 0; i < flat.surface->mesh->triangleCount(); ++i)
      QVERIFY(flat.tracer.trace({i}, true, 1.0).empty());
    QVERIFY(render::StreamlineLayout(*ball.surface).lines().empty());
  }

  /// Seen from within, by the signed maximum, a tube would be lined along.
  void tubesAreRingedOnBothSides() {
    const model::MeshPtr outside = test::cylinder(3, 20, 48, 60);
    std::vector<model::Triangle> turned(outside->triangles().begin(), outside->triangles().end());
    for (model::Triangle& t : turned)
      std::swap(t[1], t[2]);
    const auto positions = outside->positions();
    const auto inside = std::make_shared<const model::Mesh>(
        model::Mesh::create({positions.begin(), positions.end()}, std::move(turned)).value());
    for (const model::MeshPtr& mesh : {outside, model::MeshPtr(inside)}) {
      const Ground ground(mesh);
      const render::StreamlineLayout layout(*ground.surface);
      QVERIFY(layout.lines().size() > 50);
      for (const render::Streamline& line : layout.lines()) {
        const auto points = layout.points(line);
        for (const render::StreamlinePoint& p : points)
          QVERIFY(std::abs(p.position.z - points.front().position.z) < 0.05f);
      }
    }
  }

  /// The waist of a bumpy tube and its bulges are extrema of H, the slopes between are not.
  void extremaOfTheMeanCurvature() {
    const test::Torus torus{10.0, 3.0};
    const model::SurfacePtr surface = model::prepareSurface(test::torus(10, 3, 240, 90));
    const std::vector<float> features = render::meanCurvatureFeatures(*surface);
    const auto p = surface->mesh->positions();
    // H of a torus has its maximum on the outer equator and its minimum on the inner one.
    int found = 0;
    for (std::size_t i = 0; i < features.size(); ++i) {
      if (features[i] == 0.0f)
        continue;
      ++found;
      const model::Triangle& t = surface->mesh->triangles()[i];
      const double v = torus.at(glm::dvec3(p[t[0]] + p[t[1]] + p[t[2]]) / 3.0).v;
      const double off = std::min(std::abs(v), M_PI - std::abs(v));
      QVERIFY2(off < 0.1, qPrintable(QString::number(v)));
      const double h = 0.5 * (1.0 / 3.0 + std::cos(v) / (10.0 + 3.0 * std::cos(v)));
      QVERIFY(std::abs(double(features[i]) - std::abs(h) * double(surface->filigreeSize)) < 0.01);
    }
    QVERIFY(found >= 400);
  }

  void linesAreLaidEvenly() {
    const Ground ground(test::torus(10, 3, 240, 90));
    const render::StreamlineLayout layout(*ground.surface);
    const auto lines = layout.lines();
    QVERIFY(std::is_sorted(lines.begin(), lines.end(),
                           [](const auto& a, const auto& b) { return a.distance > b.distance; }));
    // Of those that are laid at 1 mm or more, each is far from where every other one starts, and
    // no place is farther from all than twice that.
    std::vector<glm::vec3> taken;
    for (const render::Streamline& line : lines) {
      if (line.distance < 1.0f)
        break;
      const auto points = layout.points(line);
      const auto middle =
          std::min_element(points.begin(), points.end(), [&](const auto& a, const auto& b) {
            return std::abs(int(a.way) - 32768) < std::abs(int(b.way) - 32768);
          });
      if (line.length > 1.99f * line.reach)
        for (const glm::vec3& other : taken)
          QVERIFY(glm::distance(other, middle->position) > 0.7f * line.distance);
      for (const render::StreamlinePoint& p : points)
        taken.push_back(p.position);
    }
    for (const glm::vec3& p : ground.surface->mesh->positions())
      QVERIFY(std::any_of(taken.begin(), taken.end(),
                          [&](const glm::vec3& other) { return glm::distance(other, p) < 1.6f; }));
  }

  void layoutsAreCompactAndTrue() {
    const Ground ground(test::torus(10, 3, 240, 90));
    const render::StreamlineLayout layout(*ground.surface);
    QVERIFY(layout.bytes() <= 120 * ground.surface->mesh->triangleCount());
    const test::Torus torus{10.0, 3.0};
    for (const render::Streamline& line : layout.lines()) {
      const auto points = layout.points(line);
      QVERIFY(points.front().way == 0 && points.back().way == 65535);
      for (const render::StreamlinePoint& p : points) {
        const test::Torus::Point at = torus.at(glm::dvec3(p.position));
        QVERIFY(glm::distance(torus.position(at), glm::dvec3(p.position)) < 0.01);
        const glm::dvec3 normal(glm::unpackSnorm3x10_1x2(p.normal));
        QVERIFY(glm::distance(torus.normal(at), normal) < 0.01);
        // Along the ring: cos v/(R + r cos v), within what the steps hold.
        const glm::dvec3 d = torus.alongRing(at);
        std::array<double, 6> s{};
        for (std::size_t i = 0; i < 6; ++i)
          s[i] = double(line.bend * float(p.s[i]) / render::bendSteps) /
                 double(ground.surface->filigreeSize);
        const double k = d.x * (s[0] * d.x + 2.0 * (s[1] * d.y + s[2] * d.z)) +
                         d.y * (s[3] * d.y + 2.0 * s[4] * d.z) + s[5] * d.z * d.z;
        QVERIFY(std::abs(k - std::cos(at.v) / (10.0 + 3.0 * std::cos(at.v))) < 0.005);
        QVERIFY(glm::distance(p.position, line.bounds.centre) <= 1.001f * line.bounds.radius);
        QVERIFY(glm::dot(line.axis, render::normalOf(p)) >= line.within);
        QVERIFY(line.steepest > 0.95f && line.steepest < 1.1f);
      }
    }
  }

  void layoutsDoNotChange() {
    const model::SurfacePtr surface = model::prepareSurface(test::torus(10, 3, 120, 45));
    const render::StreamlineLayout one(*surface);
    const render::StreamlineLayout other(*surface);
    QCOMPARE(one.lines().size(), other.lines().size());
    for (std::size_t i = 0; i < one.lines().size(); ++i) {
      const auto a = one.points(one.lines()[i]);
      const auto b = other.points(other.lines()[i]);
      QCOMPARE(a.size(), b.size());
      for (std::size_t k = 0; k < a.size(); ++k)
        QVERIFY(a[k].position == b[k].position && a[k].feature == b[k].feature);
    }
  }
};

SLINE_TEST(StreamlinesTest)
#include "streamlines_test.moc"
