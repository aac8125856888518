// SPDX-License-Identifier: Apache-2.0
// Tests that a Gaussian that looks at groups of vertices does what one does that visits them all.
#include <QtTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "model/fairing/coarse_rings.h"
#include "model/fairing/windowed_sinc.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

struct Wave {
  double height = 0.0;
  double rest = 0.0;  ///< root mean square of what is no such wave
};

/// Holds a sheet with a wave along x.
class Sheet {
 public:
  Sheet(const Mesh& mesh, float length)
      : m_positions(mesh.positions().begin(), mesh.positions().end()),
        m_rings(mesh.vertexCount(), mesh.triangles(),
                HalfEdges(mesh.vertexCount(), mesh.triangles())),
        m_rate(2.0 * std::numbers::pi / double(length)),
        m_inner(0.25f * mesh.bounds().size().x) {
    for (glm::vec3& p : m_positions)
      p.z = float(std::sin(m_rate * double(p.x)));
  }
  const VertexRings& rings() const { return m_rings; }

  /// Returns the wave that is left in the middle of the sheet, far from its border.
  Wave after(float deviation) const {
    const std::vector<glm::vec3> smooth = gaussian(m_positions, m_rings, deviation);
    double along = 0.0, square = 0.0, whole = 0.0;
    int count = 0;
    for (const glm::vec3& p : smooth) {
      if (std::max(std::abs(p.x), std::abs(p.y)) > m_inner)
        continue;
      const double sine = std::sin(m_rate * double(p.x));
      along += sine * double(p.z);
      square += sine * sine;
      whole += double(p.z) * double(p.z);
      ++count;
    }
    const double height = along / square;
    return {height, std::sqrt(std::max(whole - height * along, 0.0) / count)};
  }

 private:
  std::vector<glm::vec3> m_positions;
  VertexRings m_rings;
  double m_rate;
  float m_inner;
};

}  // namespace

class GaussianTest : public QObject {
  Q_OBJECT
 private slots:
  void groupsCoverTheSurface();
  void farAndNearAgree();
  void wavesShrinkAsTheyShould_data();
  void wavesShrinkAsTheyShould();
  void bordersStay();
};

void GaussianTest::groupsCoverTheSurface() {
  const MeshPtr ball = test::sphere(10.0f, 6);
  const VertexRings rings(ball->vertexCount(), ball->triangles(),
                          HalfEdges(ball->vertexCount(), ball->triangles()));
  const CoarseRings coarse(rings);
  const std::size_t count = coarse.rings().vertexCount();
  QVERIFY(count > ball->vertexCount() / 20);
  QVERIFY(count < ball->vertexCount() / 4);
  std::vector<std::uint32_t> sizes(count, 0);
  for (const std::uint32_t group : coarse.groups())
    ++sizes.at(group);
  QVERIFY(std::find(sizes.begin(), sizes.end(), 0u) == sizes.end());
  // Neighbours are mutual, and those across an edge of the surface.
  for (std::uint32_t v = 0; v < ball->vertexCount(); ++v)
    for (const std::uint32_t other : rings[v]) {
      const std::uint32_t a = coarse.groups()[v];
      const std::uint32_t b = coarse.groups()[other];
      const auto ring = coarse.rings()[a];
      QCOMPARE(std::count(ring.begin(), ring.end(), b), a == b ? 0 : 1);
    }
}

void GaussianTest::farAndNearAgree() {
  const Sheet sheet(*test::paraboloid(0.0f, 0.0f, 200.0f, 400), 40.0f);
  const double near = sheet.after(5.99f).height;
  const double far = sheet.after(6.01f).height;
  QVERIFY2(std::abs(far / near - 1.0) < 0.05, qPrintable(QString("%1 %2").arg(near).arg(far)));
}

void GaussianTest::wavesShrinkAsTheyShould_data() {
  QTest::addColumn<float>("deviation");
  QTest::addColumn<float>("length");
  QTest::newRow("twelve edges") << 12.0f << 60.0f;
  QTest::newRow("twenty edges") << 20.0f << 90.0f;
  // Groups of groups.
  QTest::newRow("forty edges") << 40.0f << 160.0f;
}

void GaussianTest::wavesShrinkAsTheyShould() {
  QFETCH(float, deviation);
  QFETCH(float, length);
  const Sheet sheet(*test::paraboloid(0.0f, 0.0f, 400.0f, 500), length);
  constexpr float known = 5.9f;
  const double exact = std::pow(sheet.after(known).height, std::pow(deviation / known, 2.0f));
  const Wave left = sheet.after(deviation);
  const QString figures = QString("%1 of %2, rest %3").arg(left.height).arg(exact).arg(left.rest);
  // The deviation, of which a wave's logarithm is the square, is true to some hundredths.
  const double truth = std::sqrt(std::log(left.height) / std::log(exact));
  QVERIFY2(std::abs(truth - 1.0) < 0.05, qPrintable(figures));
  QVERIFY2(left.rest < 0.0005, qPrintable(figures));
}

void GaussianTest::bordersStay() {
  const MeshPtr sheet = test::paraboloid(0.01f, 0.02f, 100.0f, 100);
  const VertexRings rings(sheet->vertexCount(), sheet->triangles(),
                          HalfEdges(sheet->vertexCount(), sheet->triangles()));
  const std::vector<glm::vec3> smooth = gaussian(sheet->positions(), rings, 15.0f);
  for (std::size_t v = 0; v < smooth.size(); ++v)
    if (rings.onBorder(v))
      QVERIFY(smooth[v] == sheet->positions()[v]);
}

SLINE_TEST(GaussianTest)
#include "gaussian_test.moc"
