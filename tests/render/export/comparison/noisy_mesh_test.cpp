// SPDX-License-Identifier: Apache-2.0
// Tests what roughened surfaces are like.
#include "render/export/comparison/noisy_mesh.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

using namespace render;

class NoisyMeshTest : public QObject {
  Q_OBJECT

  model::MeshPtr m_ball = sphere(30.0f, 4);

 private slots:
  /// Vertices gather at the slices' levels, and none passes another.
  void staircasesAreTerraces() {
    const model::MeshPtr rough = withNoise(*m_ball, {NoiseKind::staircase, 3.0f});
    const float slice = 3.0f * meanEdge(*m_ball);
    const auto before = m_ball->positions();
    const auto after = rough->positions();
    std::vector<std::size_t> order(before.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return before[a].z < before[b].z; });
    int near = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      const glm::vec3& p = after[order[i]];
      QVERIFY(p.x == before[order[i]].x && p.y == before[order[i]].y);
      QVERIFY(i == 0 || p.z >= after[order[i - 1]].z - 1e-4f);
      const float level = (p.z - m_ball->bounds().low.z) / slice;
      near += std::abs(level - std::round(level)) < 0.25f ? 1 : 0;
    }
    // Of a straight wall 0.72 lie that near, as z' = u − 0.85/(2π)·sin(2πu) is 1/4 at u = 0.36;
    // without a staircase half would.
    QVERIFY2(near > int(0.69 * double(before.size())), qPrintable(QString::number(near)));
    QVERIFY(std::ranges::equal(rough->triangles(), m_ball->triangles()));
  }
  /// Jitter is as large as it says, in no direction more than in others, and the same each time.
  void jitterIsMeasured() {
    const model::MeshPtr rough = withNoise(*m_ball, {NoiseKind::jitter, 0.2f});
    glm::dvec3 mean(0.0);
    double square = 0.0;
    for (std::size_t i = 0; i < rough->vertexCount(); ++i) {
      const glm::dvec3 way(rough->positions()[i] - m_ball->positions()[i]);
      mean += way / double(rough->vertexCount());
      square += glm::dot(way, way) / double(rough->vertexCount());
    }
    const double wanted = 0.2 * double(meanEdge(*m_ball));
    QVERIFY(std::abs(std::sqrt(square) / wanted - 1.0) < 0.05);
    QVERIFY(glm::length(mean) < 0.1 * wanted);
    QVERIFY(*withNoise(*m_ball, {NoiseKind::jitter, 0.2f}) == *rough);
  }
  void noneChangesNothing() {
    for (const NoiseKind kind : {NoiseKind::staircase, NoiseKind::jitter})
      QVERIFY(*withNoise(*m_ball, {kind, 0.0f}) == *m_ball);
  }
  void textsAreRead_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("kind");  // −1: an error
    QTest::addColumn<float>("amount");
    QTest::newRow("staircase") << QByteArray("staircase") << 0 << 3.0f;
    QTest::newRow("jitter") << QByteArray("jitter") << 1 << 0.1f;
    QTest::newRow("amount") << QByteArray("jitter=0.25") << 1 << 0.25f;
    QTest::newRow("none") << QByteArray("staircase=0") << 0 << 0.0f;
    for (const char* wrong : {"", "hiss", "jitter=", "jitter=x", "jitter=-1", "jitter=21",
                              "jitter=nan", "jitter=1x", "Jitter"})
      QTest::newRow(wrong) << QByteArray(wrong) << -1 << 0.0f;
  }
  void textsAreRead() {
    QFETCH(QByteArray, text);
    QFETCH(int, kind);
    QFETCH(float, amount);
    const Result<Noise> noise = parseNoise(text.toStdString());
    QCOMPARE(noise.ok(), kind >= 0);
    if (noise.ok()) {
      QCOMPARE(int(noise->kind), kind);
      QCOMPARE(noise->amount, amount);
    }
  }
};

}  // namespace sline::test

SLINE_TEST(sline::test::NoisyMeshTest)
#include "noisy_mesh_test.moc"
