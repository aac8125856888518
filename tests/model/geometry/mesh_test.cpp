// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/mesh.h"

#include <QtTest>
#include <cmath>
#include <limits>

#include "model/geometry/scale_limits.h"
#include "tests/support/suite.h"

using namespace sline::model;

class MeshTest : public QObject {
  Q_OBJECT
 private slots:
  void create_data() {
    QTest::addColumn<float>("coordinate");
    QTest::addColumn<unsigned>("index");
    QTest::addColumn<QString>("fault");
    QTest::newRow("sound") << 1.0f << 2u << QString();
    QTest::newRow("index out of range") << 1.0f << 3u << "triangle 0";
    QTest::newRow("huge index") << 1.0f << 0xffffffffu << "triangle 0";
    QTest::newRow("not a number") << std::numeric_limits<float>::quiet_NaN() << 2u << "vertex 1";
    QTest::newRow("as far as may be") << 1e8f << 2u << QString();
    QTest::newRow("farther") << std::nextafter(1e8f, 2e8f) << 2u << "vertex 1";
    QTest::newRow("farther on the other side") << -1e30f << 2u << "vertex 1";
    QTest::newRow("infinite") << std::numeric_limits<float>::infinity() << 2u << "vertex 1";
  }
  void create() {
    QFETCH(float, coordinate);
    QFETCH(unsigned, index);
    QFETCH(QString, fault);
    const auto mesh = Mesh::create({{0, 0, 0}, {coordinate, 0, 0}, {0, 1, 0}}, {{0, 1, index}});
    QCOMPARE(mesh.ok(), fault.isEmpty());
    if (!mesh.ok())
      QCOMPARE(QString::fromStdString(mesh.error().where), fault);
    else
      QVERIFY((mesh->bounds() == Box{{0, 0, 0}, {coordinate, 1, 0}}));
  }

  void plausibleSizes_data() {
    QTest::addColumn<float>("size");
    QTest::addColumn<bool>("plausible");
    QTest::newRow("a point") << 0.0f << true;
    QTest::newRow("an atom") << 0.9e-4f << false;
    QTest::newRow("a virus") << 1.1e-4f << true;
    QTest::newRow("a whale") << 3e4f << true;
    QTest::newRow("a town") << 1.1e5f << false;
  }
  void plausibleSizes() {
    QFETCH(float, size);
    QFETCH(bool, plausible);
    QCOMPARE(isPlausibleSize(Box{{0, 0, 0}, {0.1f * size, size, 0}}), plausible);
    QVERIFY(isPlausibleSize(Box()));
  }

  void errorTextNamesEverything() {
    const sline::Error error{
        .file = "liver.obj", .where = "line 3", .reason = "no number", .remedy = "Export again"};
    QCOMPARE(error.text(), std::string("liver.obj: line 3: no number. Export again."));
  }
};

SLINE_TEST(MeshTest)
#include "mesh_test.moc"
