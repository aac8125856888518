// SPDX-License-Identifier: Apache-2.0
// Tests what all readers are made of: strips, polygons, numbers, the locale, base64 and frames.
#include <QTest>
#include <clocale>
#include <cmath>

#include "model/import/source/base64.h"
#include "model/import/source/polygon.h"
#include "model/import/source/surface_assembly.h"
#include "model/import/source/text_cursor.h"
#include "tests/model/import/readers/mesh_files.h"
#include "tests/model/import/readers/read_triangles.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using model::Triangle;

namespace {

double area(std::span<const glm::vec3> p, const std::vector<Triangle>& triangles) {
  double sum = 0.0;
  for (const auto& [a, b, c] : triangles)
    sum +=
        0.5 * double((p[b].x - p[a].x) * (p[c].y - p[a].y) - (p[b].y - p[a].y) * (p[c].x - p[a].x));
  return sum;
}

}  // namespace

class TestSourceDetails : public QObject {
  Q_OBJECT

 private slots:
  void stripsAlternate() {
    model::FaceList faces;
    const std::uint32_t strip[] = {0, 1, 2, 3, 3, 4, 5};
    model::addStrip(strip, faces, nullptr);
    std::vector<std::vector<std::uint32_t>> found;
    for (std::size_t i = 0; i < faces.size(); ++i)
      found.emplace_back(faces.face(i).begin(), faces.face(i).end());
    const std::vector<std::vector<std::uint32_t>> wanted = {{0, 1, 2}, {2, 1, 3}, {3, 4, 5}};
    QCOMPARE(found, wanted);
  }

  void polygons_data() {
    QTest::addColumn<QList<QPointF>>("corners");
    QTest::addColumn<double>("wanted");
    QTest::newRow("square") << QList<QPointF>{{0, 0}, {1, 0}, {1, 1}, {0, 1}} << 1.0;
    QTest::newRow("arrow") << QList<QPointF>{{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}} << 1.0;
    QTest::newRow("arrow from its notch")
        << QList<QPointF>{{0.5, 0.5}, {0, 2}, {0, 0}, {2, 0}} << 1.0;
    QTest::newRow("L") << QList<QPointF>{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}} << 3.0;
    QTest::newRow("with middles of sides")
        << QList<QPointF>{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 2}, {0, 1}} << 3.0;
    QList<QPointF> comb;
    for (int i = 0; i < 100; ++i)
      comb << QPointF(100 - i, 1.0) << QPointF(99.5 - i, 0.1);
    comb << QPointF(0, 0) << QPointF(100, 0);
    QTest::newRow("comb") << comb << -1.0;
  }

  /// No triangle of a cut turns over, and together they cover the polygon.
  void polygons() {
    QFETCH(QList<QPointF>, corners);
    QFETCH(double, wanted);
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> loop;
    for (const QPointF& p : corners) {
      loop.push_back(std::uint32_t(positions.size()));
      positions.emplace_back(p.x(), p.y(), 7.0);
    }
    double outline = 0.0;
    for (qsizetype i = 0; i < corners.size(); ++i) {
      const QPointF& a = corners[i];
      const QPointF& b = corners[(i + 1) % corners.size()];
      outline += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    if (wanted > 0.0)
      QCOMPARE(outline, wanted);
    for (int turn = 0; turn < 2; ++turn) {
      std::vector<Triangle> triangles;
      model::cutPolygon(loop, positions, triangles);
      QCOMPARE(triangles.size(), loop.size() - 2);
      double unsignedArea = 0.0;
      for (const Triangle& t : triangles)
        unsignedArea += std::abs(area(positions, {t}));
      const double sign = turn == 0 ? 1.0 : -1.0;
      QVERIFY(std::abs(area(positions, triangles) - sign * outline) < 1e-4);
      QVERIFY(std::abs(unsignedArea - std::abs(outline)) < 1e-4);
      std::reverse(loop.begin(), loop.end());
    }
  }

  void longPolygonsEndSoon() {
    QByteArray text = "OFF\n40000 1 0\n";
    QByteArray face = "40000";
    for (int i = 0; i < 40000; ++i) {
      text += QByteArray::number(std::cos(i * 0.1) * (1 + i % 2)) + ' ' +
              QByteArray::number(std::sin(i * 0.1)) + " 0\n";
      face += ' ' + QByteArray::number(i);
    }
    QCOMPARE(trianglesOf(".off", text + face + '\n').size(), std::size_t(39998));
  }

  void numbers_data() {
    QTest::addColumn<bool>("good");
    QTest::addColumn<float>("value");
    const auto row = [](const char* text, bool good, float value = 0.0f) {
      QTest::newRow(text) << good << value;
    };
    row("1", true, 1.0f);
    row("+1.5", true, 1.5f);
    row("-.5e1", true, -5.0f);
    row("1.", true, 1.0f);
    row("1e-60", true, 0.0f);
    row("0.00000000000000000000000000000000000000000000000000000000000001", true, 0.0f);
    row("16777217", true, 16777216.0f);
    row("1,5", false);
    row("1.5x", false);
    row("+-1", false);
    row("--1", false);
    row("", false);
    row("one", false);
    row("0x10", false);
  }

  void numbers() {
    QFETCH(bool, good);
    const std::string text = QTest::currentDataTag();
    model::TextCursor at(text);
    float value = 0.0f;
    QCOMPARE(at.number(value), good);
    if (good) {
      QTEST(value, "value");
      QVERIFY(at.atEnd());
    } else {
      QVERIFY(at.at() == text.data());
    }
  }

  void notFinite_data() {
    QTest::addColumn<bool>("dummy");
    for (const char* text : {"nan", "NaN", "-nan", "inf", "-Inf", "+inf", "INFINITY", "1e39",
                             "-1e400", "1.#INF", "-1.#IND", "1.#QNAN"})
      QTest::newRow(text) << true;
  }

  void notFinite() {
    model::TextCursor at{std::string_view(QTest::currentDataTag())};
    float value = 0.0f;
    QVERIFY(at.number(value));
    QVERIFY(!std::isfinite(value));
    QVERIFY(at.atEnd());
  }

  void localeChangesNothing() {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    bool found = false;
    for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE", "fr_FR", "ru_RU.UTF-8"})
      found = found || std::setlocale(LC_ALL, name) != nullptr;
    if (!found)
      QSKIP("no locale with decimal commas is installed");
    for (const MeshFile& file : cubeFiles()) {
      QTemporaryDir folder;
      const auto read = readBytes(folder, QString("cube") + file.extension, file.bytes);
      QVERIFY2(read && volume(read->meshes.front()) == 6.0, file.kind);
    }
    std::setlocale(LC_ALL, before.c_str());
  }

  void base64() {
    QCOMPARE(model::decodeBase64("U2xpbmU="), std::optional<std::string>("Sline"));
    QCOMPARE(model::decodeBase64("U2xp\n bmU"), std::optional<std::string>("Sline"));
    QCOMPARE(model::decodeBase64(""), std::optional<std::string>(""));
    QVERIFY(!model::decodeBase64("U2xp*mU="));
    QVERIFY(!model::decodeBase64("U2xpb"));
    QVERIFY(!model::decodeBase64("U2=xpbmU"));
    QCOMPARE(model::decodeBase64Prefix("U2xpbmU=####", 5), std::optional<std::string>("Sline"));
    QVERIFY(!model::decodeBase64Prefix("U2xpbmU=", 6));
  }

  void frames_data() {
    QTest::addColumn<QString>("extension");
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("obj") << ".obj"
                         << "# SPACE=@\n" + cubeFile("obj");
    QTest::newRow("stl text")
        << ".stl" << cubeFile("stl text").replace("solid cube", "solid 3D Slicer output. SPACE=@");
    QTest::newRow("stl binary") << ".stl"
                                << QByteArray("3D Slicer output. SPACE=@").leftJustified(78) +
                                       cubeFile("stl binary").mid(80);
    QTest::newRow("ply")
        << ".ply"
        << cubeFile("ply big endian")
               .replace("ply\n", "ply\ncomment SPACE=@\n")
               .replace("comment SPACE=@\nformat binary_big_endian 1.0",
                        "format binary_big_endian 1.0\ncomment 3D Slicer output. SPACE=@");
    QTest::newRow("off") << ".off" << cubeFile("off").replace("OFF\n", "OFF\n# SPACE=@\n");
    QTest::newRow("vtk title")
        << ".vtk" << cubeFile("vtk 4.2 text").replace("\ncube\n", "\n3D Slicer output. SPACE=@\n");
    QTest::newRow("vtk field")
        << ".vtk"
        << cubeFile("vtk 4.2 text")
               .replace("POINTS 8",
                        "FIELD FieldData 2\na 2 2 int\n1 2 3 4\nSPACE 1 1 string\n@\nPOINTS 8");
    QTest::newRow("vtk binary field")
        << ".vtk"
        << cubeFile("vtk 5.1 binary")
               .replace("POINTS 8",
                        QByteArray("FIELD FieldData 1\nSPACE 1 1 string\n\xc3@\nPOINTS 8"));
    QTest::newRow("vtp") << ".vtp"
                         << cubeFile("vtp binary")
                                .replace(
                                    "<PolyData>",
                                    "<PolyData><FieldData><DataArray type=\"Float32\" Name=\"t\" "
                                    "NumberOfTuples=\"1\" format=\"ascii\">1</DataArray>"
                                    "<Array type=\"String\" Name=\"SPACE\" NumberOfTuples=\"1\" "
                                    "format=\"ascii\">#</Array></FieldData>");
  }

  void frames() {
    QFETCH(QString, extension);
    QFETCH(QByteArray, bytes);
    QTemporaryDir folder;
    for (const auto& [name, codes, frame] : {std::tuple("LPS", "76 80 83 0", model::Frame::lps),
                                             std::tuple("RAS", "82 65 83 0", model::Frame::ras)}) {
      QByteArray named = bytes;
      named.replace("SPACE=@", QByteArray("SPACE=") + name)
          .replace("\n@\n", QByteArray("\n") + name + "\n");
      named.replace("\xc3@\n", QByteArray("\xc3") + name + "\n")
          .replace(">#<", QByteArray(">") + codes + "<");
      const auto read = readBytes(folder, "frame" + extension, named);
      QVERIFY2(read, read ? "" : read.error().text().c_str());
      QVERIFY(read->meshes.front().frame == frame);
      QVERIFY(read->meshes.front().frameReason.starts_with("SPACE in"));
      QCOMPARE(read->meshes.front().triangles.size(), std::size_t(12));
    }
  }
};

SLINE_TEST_WITH_EVENTS(TestSourceDetails)
#include "test_source_details.moc"
