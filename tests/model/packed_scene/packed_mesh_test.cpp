// SPDX-License-Identifier: Apache-2.0
#include "model/packed_scene/packed_mesh.h"

#include <QtTest>
#include <algorithm>
#include <glm/geometric.hpp>
#include <random>

#include "tests/support/mutator.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {
MeshPtr packable(std::vector<glm::vec3> positions, std::vector<Triangle> triangles) {
  auto mesh = Mesh::create(std::move(positions), std::move(triangles));
  return mesh.ok() ? std::make_shared<const Mesh>(std::move(*mesh)) : nullptr;
}

/// Returns triangles without any order, many of which share edges that others have, too.
MeshPtr tangle() {
  std::mt19937 random(11);
  std::vector<glm::vec3> positions(60);
  for (glm::vec3& p : positions)
    p = {float(random() % 1000), float(random() % 100), float(random() % 10)};
  std::vector<Triangle> triangles(500);
  for (Triangle& t : triangles)
    for (std::uint32_t& vertex : t)
      vertex = std::uint32_t(random() % 59);  // the last one is used by none
  return packable(std::move(positions), std::move(triangles));
}
}  // namespace
Q_DECLARE_METATYPE(sline::model::MeshPtr)

class PackedMeshTest : public QObject {
  Q_OBJECT
 private slots:
  void sameTriangles_data() {
    QTest::addColumn<MeshPtr>("mesh");
    QTest::newRow("nothing") << packable({}, {});
    QTest::newRow("points only") << packable({{1, 2, 3}}, {});
    QTest::newRow("one point") << packable({{5, 5, 5}}, {{0, 0, 0}});
    QTest::newRow("one triangle") << packable({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{2, 0, 1}});
    QTest::newRow("twice the same")
        << packable({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{2, 0, 1}, {2, 0, 1}, {0, 2, 1}});
    QTest::newRow("sphere") << test::sphere(50.0f, 5);
    QTest::newRow("torus") << test::torus(90, 20, 64, 32);
    QTest::newRow("open tube") << test::cylinder(10, 50, 20, 30);
    QTest::newRow("two bodies") << test::together(*test::sphere(50.0f, 3),
                                                  *test::torus(9, 2, 8, 8));
    QTest::newRow("tangle") << tangle();
  }

  void sameTriangles() {
    QFETCH(MeshPtr, mesh);
    const PackedMesh packed = packedMesh(*mesh);
    const Result<Mesh> again = unpackedMesh(packed.bytes);
    QVERIFY2(again.ok(), again.ok() ? "" : again.error().text().c_str());
    QCOMPARE(again->triangleCount(), mesh->triangleCount());
    QCOMPARE(packed.places.size(), mesh->triangleCount());
    QCOMPARE(again->vertexCount(), packed.vertices.size());
    std::vector<bool> seen(mesh->triangleCount(), false);
    for (std::size_t i = 0; i < mesh->triangleCount(); ++i) {
      const PackedMesh::Place& place = packed.places[i];
      QVERIFY(!seen[place.triangle]);
      seen[place.triangle] = true;
      const Triangle& now = again->triangles()[place.triangle];
      for (std::size_t corner = 0; corner < 3; ++corner)
        QCOMPARE(packed.vertices[now[corner]], mesh->triangles()[i][(place.first + corner) % 3]);
    }
    const glm::vec3 size = mesh->bounds().empty() ? glm::vec3(0.0f) : mesh->bounds().size();
    const float side = std::max({size.x, size.y, size.z});
    for (std::size_t v = 0; v < again->vertexCount(); ++v)
      for (int axis = 0; axis < 3; ++axis)
        QVERIFY(std::abs(again->positions()[v][axis] -
                         mesh->positions()[packed.vertices[v]][axis]) <= side * (0.51f / 65535.0f));
  }

  void isSmall() {
    const MeshPtr mesh = test::torus(90, 20, 400, 200);
    const std::string bytes = packedMesh(*mesh).bytes;
    const QByteArray small = qCompress(QByteArray::fromStdString(bytes), 9);
    const double each = double(small.size()) / double(mesh->triangleCount());
    QVERIFY2(each < 3.0, qPrintable(QString::number(each)));
  }

  void spoiledBytes() {
    const QByteArray good = QByteArray::fromStdString(packedMesh(*test::sphere(50.0f, 2)).bytes);
    test::Mutator mutate(3, {});
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
      const QByteArray bad = mutate(good);
      const Result<Mesh> mesh = unpackedMesh(bad.toStdString());
      refused += mesh.ok() ? 0 : 1;
      if (!mesh.ok())
        QVERIFY(!mesh.error().reason.empty());
    }
    QVERIFY(refused > 1000);
  }
};

SLINE_TEST(PackedMeshTest)
#include "packed_mesh_test.moc"
