// SPDX-License-Identifier: Apache-2.0
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <array>
#include <cmath>

#include "tests/cli/sline_process.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {
namespace {

double distance(const QJsonValue& a, const QJsonValue& b) {
  return std::hypot(a[0].toDouble() - b[0].toDouble(), a[1].toDouble() - b[1].toDouble(),
                    a[2].toDouble() - b[2].toDouble());
}

/// Holds the area of ink on the surface and its middle along x, in mm.
struct Inked {
  double area = 0.0;
  double x = 0.0;
};
Inked inked(const QJsonArray& strokes) {
  Inked sum;
  for (const QJsonValue& stroke : strokes)
    for (int i = 0; i + 1 < stroke["points"].toArray().size(); ++i) {
      const QJsonValue a = stroke["points"][i];
      const QJsonValue b = stroke["points"][i + 1];
      const double area = distance(a, b) * (stroke["half_widths_mm"][i].toDouble() +
                                            stroke["half_widths_mm"][i + 1].toDouble());
      sum.area += area;
      sum.x += area * 0.5 * (a[0].toDouble() + b[0].toDouble());
    }
  sum.x /= sum.area;
  return sum;
}

}  // namespace

class LinesCommandTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void jsonHasItsShape();
  void sphereOutline();
  void kindsAreChosen_data();
  void kindsAreChosen();
  void hiddenLinesAreMarked();
  void sectionIsACircle();
  void frameFileKeepsCoordinates();
  void hatchingHasItsShape();
  void hatchingEntersWithGamma();
  void roundBodiesAreHatchedInTheShade();
  void hatchingIsHiddenPointByPoint();
  void hatchingEndsAtSections();
  void mirroredHatchingIsMirrored();
  void hatchingEndsWithThePicture();

 private:
  QJsonArray strokes(const QString& mesh, const QStringList& flags = {},
                     const QString& camera = "above.json");
  QJsonValue lines(const QString& mesh, const QStringList& flags = {},
                   const QString& camera = "front.json");
  QTemporaryDir m_folder;
};

QJsonValue LinesCommandTest::lines(const QString& mesh, const QStringList& flags,
                                   const QString& camera) {
  const QString file = m_folder.filePath("lines.json");
  QFile::remove(file);
  const Finished finished = runSline(
      QStringList{"lines", mesh, "--camera", m_folder.filePath(camera), "-o", file} +
      (flags.contains("--size") ? QStringList{} : QStringList{"--size", "640x480"}) + flags);
  if (finished.code != 0 || !finished.out.isEmpty() || !finished.err.isEmpty())
    qWarning("%s", finished.err.constData());
  QFile text(file);
  return text.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(text.readAll()).object()
                                        : QJsonObject();
}

QJsonArray LinesCommandTest::strokes(const QString& mesh, const QStringList& flags,
                                     const QString& camera) {
  return lines(m_folder.filePath(mesh), QStringList{"--kinds", "hatching"} + flags,
               camera)["kinds"]["hatching"]["strokes"]
      .toArray();
}

void LinesCommandTest::initTestCase() {
  writeFile(m_folder.filePath("above.json"),
            R"({"eye":[0,-150,300],"target":[0,0,10],"up":[0,0,1],"fovy_deg":20})");
  writeFile(m_folder.filePath("low.json"),
            R"({"eye":[0,-330,70],"target":[0,0,10],"up":[0,0,1],"fovy_deg":20})");
  writeObj(m_folder.filePath("bowl.obj"), *paraboloid(0.05f, 0.05f, 30.0f, 60));
  const model::MeshPtr aside =
      moved(*paraboloid(0.08f, 0.04f, 20.0f, 60), 1.0f, {22.0f, 0.0f, 0.0f});
  writeObj(m_folder.filePath("aside.obj"), *aside);
  writeObj(m_folder.filePath("mirrored.obj"), *mirrored(*aside));
  writeFile(m_folder.filePath("front.json"), frontCamera());
  writeFile(m_folder.filePath("slanted.json"),
            R"({"eye":[0,-300,250],"target":[0,0,0],"up":[0,0,1],"fovy_deg":30})");
  writeObj(m_folder.filePath("ball.obj"), *sphere(30.0f, 5));
  writeObj(m_folder.filePath("ring.obj"), *torus(40.0f, 15.0f, 160, 64));
}

void LinesCommandTest::jsonHasItsShape() {
  const QJsonObject root = lines(m_folder.filePath("ring.obj"), {}, "slanted.json").toObject();
  QCOMPARE(root.keys(), QStringList{"kinds"});
  const QJsonObject kinds = root["kinds"].toObject();
  QCOMPARE(kinds.keys(), QStringList({"contour", "suggestive"}));
  for (const QString& kind : kinds.keys()) {
    const QJsonArray segments = kinds[kind]["segments"].toArray();
    QVERIFY2(!segments.isEmpty(), qPrintable(kind));
    for (const QJsonValue& segment : segments) {
      QCOMPARE(segment.toObject().keys(), QStringList({"a", "b", "opacity", "visible"}));
      QCOMPARE(segment["a"].toArray().size(), 3);
      QCOMPARE(segment["b"].toArray().size(), 3);
      QVERIFY(segment["opacity"].toDouble() >= 0.0 && segment["opacity"].toDouble() <= 1.0);
      QVERIFY(segment["visible"].isBool());
    }
  }
  const QJsonValue confis = lines(m_folder.filePath("ring.obj"), {"--kinds", "confis"},
                                  "slanted.json")["kinds"]["confis"];
  QVERIFY(confis["segments"].toArray().size() > 100);
  QVERIFY(std::abs(confis["thresholds"]["margin"].toDouble() - 0.15) < 1e-6);
  const QJsonValue thresholds = kinds["suggestive"]["thresholds"];
  QCOMPARE(thresholds["t_d"].toDouble(), 1.0);  // the defaults of METHOD §5, at gamma 2
  QVERIFY(std::abs(thresholds["theta_c"].toDouble() - 0.05) < 1e-6);
  QVERIFY(std::abs(thresholds["feature_size_mm"].toDouble() - 55.0) < 0.1);
}

void LinesCommandTest::sphereOutline() {
  const QJsonArray segments =
      lines(m_folder.filePath("ball.obj"))["kinds"]["contour"]["segments"].toArray();
  QVERIFY(segments.size() > 50);
  // From 400 mm the outline of a ball of radius r is the circle at depth r²/400.
  const double depth = 30.0 * 30.0 / 400.0;
  const double radius = std::sqrt(30.0 * 30.0 - depth * depth);
  double length = 0.0;
  for (const QJsonValue& segment : segments) {
    QVERIFY(std::abs(segment["a"][1].toDouble() + depth) < 0.1);
    const double r = std::hypot(segment["a"][0].toDouble(), segment["a"][2].toDouble());
    QVERIFY2(std::abs(r - radius) < 0.05, qPrintable(QString::number(r)));
    QVERIFY(segment["visible"].toBool());
    length += distance(segment["a"], segment["b"]);
  }
  QVERIFY(std::abs(length / (2.0 * M_PI * radius) - 1.0) < 0.01);
}

void LinesCommandTest::kindsAreChosen_data() {
  QTest::addColumn<QString>("kinds");
  QTest::addColumn<QStringList>("found");
  QTest::newRow("one") << "suggestive" << QStringList{"suggestive"};
  QTest::newRow("two") << "silhouette,contour" << QStringList{"contour", "silhouette"};
  QTest::newRow("all") << "contour,suggestive,confis,ridge,valley,apparent_ridge,photic,"
                          "laplacian,demarcating,suggestive_highlight,principal_highlight,"
                          "streamline_hatching,"
                          "silhouette,section,hatching"
                       << QStringList{"apparent_ridge", "confis",
                                      "contour",        "demarcating",
                                      "hatching",       "laplacian",
                                      "photic",         "principal_highlight",
                                      "ridge",          "section",
                                      "silhouette",     "streamline_hatching",
                                      "suggestive",     "suggestive_highlight",
                                      "valley"};
}

void LinesCommandTest::kindsAreChosen() {
  QFETCH(QString, kinds);
  QFETCH(QStringList, found);
  const QJsonValue root = lines(m_folder.filePath("ring.obj"), {"--kinds", kinds});
  QCOMPARE(root["kinds"].toObject().keys(), found);
}

void LinesCommandTest::hiddenLinesAreMarked() {
  // Seen along its plane, the ring hides the contours around its hole.
  const QJsonValue kinds =
      lines(m_folder.filePath("ring.obj"), {"--kinds", "contour,silhouette"})["kinds"];
  int visible = 0;
  int hidden = 0;
  for (const QJsonValue& segment : kinds["contour"]["segments"].toArray())
    ++(segment["visible"].toBool() ? visible : hidden);
  QVERIFY(visible > 100);
  QVERIFY(hidden > 100);
  const auto outline = kinds["silhouette"]["segments"].toArray();
  QVERIFY(!outline.isEmpty());
  QVERIFY(outline.size() <= visible + 10);
}

void LinesCommandTest::sectionIsACircle() {
  const QJsonValue kinds =
      lines(m_folder.filePath("ball.obj"),
            {"--kinds", "section,contour", "--section", "axial=18:inferior"})["kinds"];
  double length = 0.0;
  for (const QJsonValue& segment : kinds["section"]["segments"].toArray()) {
    QVERIFY(std::abs(segment["a"][2].toDouble() - 18.0) < 1e-4);
    const double r = std::hypot(segment["a"][0].toDouble(), segment["a"][1].toDouble());
    QVERIFY(std::abs(r - 24.0) < 0.05);
    length += distance(segment["a"], segment["b"]);
  }
  QVERIFY(std::abs(length / (2.0 * M_PI * 24.0) - 1.0) < 0.005);
  const QJsonArray contours = kinds["contour"]["segments"].toArray();
  QVERIFY(contours.size() > 50);
  for (const QJsonValue& segment : contours)
    QVERIFY(segment["a"][2].toDouble() <= 18.0001 && segment["b"][2].toDouble() <= 18.0001);
}

void LinesCommandTest::frameFileKeepsCoordinates() {
  writeObj(m_folder.filePath("shifted.obj"), *moved(*sphere(10.0f, 3), 1.0f, {50.0f, 0.0f, 0.0f}));
  const auto middle = [this](const QString& frame) {
    const QJsonArray segments =
        lines(m_folder.filePath("shifted.obj"), {"--frame", frame})["kinds"]["contour"]["segments"]
            .toArray();
    double sum = 0.0;
    for (const QJsonValue& segment : segments)
      sum += segment["a"][0].toDouble();
    return segments.isEmpty() ? 0.0 : sum / double(segments.size());
  };
  QVERIFY(middle("file") > 40.0);
  QVERIFY(middle("RAS") < -40.0);
}

void LinesCommandTest::hatchingHasItsShape() {
  const QJsonValue hatching = lines(m_folder.filePath("bowl.obj"), {"--kinds", "hatching"},
                                    "above.json")["kinds"]["hatching"];
  QCOMPARE(hatching.toObject().keys(), QStringList({"strokes", "thresholds"}));
  QCOMPARE(hatching["thresholds"]["gamma"].toDouble(), 3.0);
  QCOMPARE(hatching["thresholds"]["t_h"].toDouble(), 1.0);
  const QJsonArray strokes = hatching["strokes"].toArray();
  QVERIFY2(strokes.size() > 50, qPrintable(QString::number(strokes.size())));
  // From 335 mm a picture 20° high shows 118 mm, so λ is 0.164 mm around its middle.
  const double unit = 2.0 * std::hypot(150.0, 290.0) * std::tan(10.0 * M_PI / 180.0) / 720.0;
  for (const QJsonValue& stroke : strokes) {
    QCOMPARE(stroke.toObject().keys(),
             QStringList({"half_widths", "half_widths_mm", "points", "seed", "visible"}));
    QCOMPARE(stroke["seed"].toObject().keys(), QStringList({"axis", "i", "j", "level"}));
    const auto count = stroke["points"].toArray().size();
    QVERIFY(count > 0);
    for (const char* list : {"half_widths", "half_widths_mm", "visible"})
      QCOMPARE(stroke[list].toArray().size(), count);
    double widest = 0.0;
    for (int i = 0; i < count; ++i) {
      const QJsonValue p = stroke["points"][i];
      const double x = p[0].toDouble();
      const double y = p[1].toDouble();
      QVERIFY(std::abs(p[2].toDouble() - 0.025 * (x * x + y * y)) < 0.02);
      const double width = stroke["half_widths"][i].toDouble();
      QVERIFY(width >= 0.0);
      QVERIFY(std::abs(stroke["half_widths_mm"][i].toDouble() - unit * width) <=
              0.2 * unit * width);
      widest = std::max(widest, width);
    }
    QVERIFY(widest > 0.0);  // strokes end in points, but none is nothing
  }
}

void LinesCommandTest::hatchingEntersWithGamma() {
  QVERIFY(strokes("bowl.obj", {"--gamma", "2"}).isEmpty());
  const double half = inked(strokes("bowl.obj", {"--gamma", "2.5"})).area;
  const double whole = inked(strokes("bowl.obj", {"--gamma", "3"})).area;
  QVERIFY2(half > 0.2 * whole && half < 0.8 * whole,
           qPrintable(QString("%1 of %2").arg(half).arg(whole)));
}

void LinesCommandTest::roundBodiesAreHatchedInTheShade() {
  int inked = 0;
  for (const QJsonValue& stroke : strokes("ball.obj", {}, "front.json"))
    for (int i = 0; i < stroke["points"].toArray().size(); ++i)
      if (stroke["half_widths"][i].toDouble() > 0.0) {
        // From the front the upper left is towards −x and +z, the eye towards −y.
        const QJsonValue p = stroke["points"][i];
        const double lit =
            -0.538 * p[0].toDouble() + 0.606 * p[2].toDouble() - 0.586 * p[1].toDouble();
        QVERIFY2(lit < 0.32 * 30.0, qPrintable(QString::number(lit)));
        ++inked;
      }
  QVERIFY(inked > 100);
}

void LinesCommandTest::hatchingIsHiddenPointByPoint() {
  const auto shown = [this](const QString& camera) {
    std::array<int, 2> count{};
    for (const QJsonValue& stroke : strokes("bowl.obj", {}, camera))
      for (const QJsonValue& visible : stroke["visible"].toArray())
        ++count[visible.toBool()];
    return count;
  };
  const auto [hiddenAbove, seenAbove] = shown("above.json");
  QCOMPARE(hiddenAbove, 0);
  QVERIFY(seenAbove > 1000);
  // From low down the near rim hides the bottom.
  const auto [hiddenLow, seenLow] = shown("low.json");
  QVERIFY2(hiddenLow > 100, qPrintable(QString::number(hiddenLow)));
  QVERIFY2(seenLow > 100, qPrintable(QString::number(seenLow)));
}

void LinesCommandTest::hatchingEndsAtSections() {
  const QJsonArray cut = strokes("bowl.obj", {"--section", "axial=7:inferior"});
  QVERIFY(cut.size() > 10);
  double highest = 0.0;
  for (const QJsonValue& stroke : cut)
    for (const QJsonValue& point : stroke["points"].toArray())
      highest = std::max(highest, point[2].toDouble());
  QVERIFY2(std::abs(highest - 7.0) < 1e-3, qPrintable(QString::number(highest)));
}

void LinesCommandTest::mirroredHatchingIsMirrored() {
  const Inked here = inked(strokes("aside.obj"));
  const Inked there = inked(strokes("mirrored.obj"));
  QVERIFY(here.area > 1.0);
  // In the mirror image seeds have other names and take their places in another order.
  QVERIFY2(std::abs(there.area / here.area - 1.0) < 0.1,
           qPrintable(QString("%1 and %2").arg(here.area).arg(there.area)));
  QVERIFY2(std::abs(there.x + here.x) < 1.0,
           qPrintable(QString("%1 and %2").arg(here.x).arg(there.x)));
}

void LinesCommandTest::hatchingEndsWithThePicture() {
  writeFile(m_folder.filePath("near.json"),
            R"({"eye":[0,-150,300],"target":[0,0,10],"up":[0,0,1],"fovy_deg":6})");
  const auto widest = [this](const QString& size) {
    double x = 0.0;
    for (const QJsonValue& stroke : strokes("bowl.obj", {"--size", size}, "near.json"))
      for (const QJsonValue& point : stroke["points"].toArray())
        x = std::max(x, std::abs(point[0].toDouble()));
    return x;
  };
  const double wide = widest("640x480");
  const double narrow = widest("120x480");
  QVERIFY2(narrow > 5.0 && narrow < 0.7 * wide, qPrintable(QString::number(narrow)));
}

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::LinesCommandTest)
#include "lines_command_test.moc"
