// SPDX-License-Identifier: Apache-2.0
#include "model/scene_file/mesh_codec.h"

#include <QtTest>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <random>

#include "model/geometry/scale_limits.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {
MeshPtr meshOf(std::vector<glm::vec3> positions, std::vector<Triangle> triangles) {
  auto mesh = Mesh::create(std::move(positions), std::move(triangles));
  return mesh.ok() ? std::make_shared<const Mesh>(std::move(*mesh)) : nullptr;
}

/// Returns any finite floats and any indices, at random.
MeshPtr noise(std::size_t vertices, std::size_t triangles) {
  std::mt19937 random(7);
  std::vector<glm::vec3> positions(vertices);
  for (glm::vec3& p : positions)
    for (int axis = 0; axis < 3; ++axis)
      do
        p[axis] = std::bit_cast<float>(std::uint32_t(random()));
      while (!(std::abs(p[axis]) <= farthestCoordinate));
  std::vector<Triangle> faces(triangles);
  for (Triangle& face : faces)
    for (std::uint32_t& vertex : face)
      vertex = std::uint32_t(random() % vertices);
  return meshOf(std::move(positions), std::move(faces));
}
}  // namespace
Q_DECLARE_METATYPE(sline::model::MeshPtr)

class MeshCodecTest : public QObject {
  Q_OBJECT
 private slots:
  void exact_data();
  void exact();
  void refuses_data();
  void refuses();
  void layoutIsAsDescribed();
};

void MeshCodecTest::exact_data() {
  QTest::addColumn<MeshPtr>("mesh");
  QTest::newRow("nothing") << meshOf({}, {});
  QTest::newRow("points only") << meshOf({{1, 2, 3}, {-1, -2, -3}}, {});
  QTest::newRow("zeros of both signs") << meshOf({{0.0f, -0.0f, 0.0f}, {-0.0f, 1, 1}}, {{0, 1, 1}});
  QTest::newRow("extremes") << meshOf(
      {{farthestCoordinate, -farthestCoordinate, 1e-45f}, {-1e-45f, farthestCoordinate, 0}}, {});
  QTest::newRow("last vertex first") << meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{2, 0, 1}});
  QTest::newRow("sphere") << test::sphere(50.0f, 5);
  QTest::newRow("torus") << test::torus(90, 20, 64, 32);
  QTest::newRow("noise") << noise(1000, 3000);
}

void MeshCodecTest::exact() {
  QFETCH(MeshPtr, mesh);
  QVERIFY(mesh);
  const std::string bytes = encodedMesh(*mesh);
  const auto again = decodedMesh(bytes);
  QVERIFY2(again.ok(), again.ok() ? "" : again.error().text().c_str());
  QCOMPARE(again->vertexCount(), mesh->vertexCount());
  QCOMPARE(again->triangleCount(), mesh->triangleCount());
  QVERIFY(std::equal(std::as_bytes(mesh->positions()).begin(),
                     std::as_bytes(mesh->positions()).end(),
                     std::as_bytes(again->positions()).begin()));
  QVERIFY(std::ranges::equal(mesh->triangles(), again->triangles()));
  QCOMPARE(encodedMesh(*again), bytes);
}

void MeshCodecTest::refuses_data() {
  QTest::addColumn<QByteArray>("bytes");
  QTest::addColumn<QString>("reason");
  const std::string sphere = encodedMesh(*test::sphere(5.0f, 1));
  const auto row = [](const char* name, const std::string& bytes, const char* reason) {
    QTest::newRow(name) << QByteArray::fromStdString(bytes) << QString(reason);
  };
  const auto with = [&](std::size_t at, char value) {
    std::string changed = sphere;
    changed[at] = value;
    return changed;
  };
  row("nothing", "", "no mesh");
  row("another magic", with(7, '2'), "no mesh");
  row("cut", sphere.substr(0, sphere.size() - 1), "promises");
  row("longer", sphere + "x", "promises");
  row("more vertices", with(8, '\xff'), "promises");
  row("all vertices there can be", with(11, '\xff'), "promises");
  row("a wild vertex", with(sphere.size() - 1, '\xff'), "it uses vertex");
  row("a coordinate that is none", with(16 + 3 * 42, '\xff'), "not a finite number");
}

void MeshCodecTest::refuses() {
  QFETCH(QByteArray, bytes);
  QFETCH(QString, reason);
  const auto mesh = decodedMesh(bytes.toStdString());
  QVERIFY(!mesh.ok());
  QVERIFY2(QString::fromStdString(mesh.error().text()).contains(reason),
           mesh.error().text().c_str());
}

void MeshCodecTest::layoutIsAsDescribed() {
  // resources/help/scene_file.md, worked by hand: x goes 0 → 1, so from order 0x80000000 to
  // 0xbf800000: the difference 0x3f800000 becomes 0x7f000000. The corners 0 1 0 are told from 0, 0
  // and 1, the differences are 0, 1, −1.
  const std::string bytes = encodedMesh(*meshOf({{0, 0, 0}, {1, 0, 0}}, {{0, 1, 0}}));
  QByteArray expected("SlineMe1");
  expected += QByteArray::fromHex(
      "02000000"
      "01000000");
  expected += QByteArray::fromHex(
      "0000"
      "0000"
      "0000"
      "007f");                       // x
  expected += QByteArray(16, '\0');  // y, z
  expected += QByteArray::fromHex(
      "00000000"
      "02000000"
      "01000000");
  QCOMPARE(QByteArray::fromStdString(bytes).toHex(), expected.toHex());
}

SLINE_TEST(MeshCodecTest)
#include "mesh_codec_test.moc"
