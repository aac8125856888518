// SPDX-License-Identifier: Apache-2.0
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "tests/cli/sline_process.h"
#include "tests/support/shapes.h"

namespace sline::test {
namespace {

double distance(const QJsonValue& a, const QJsonValue& b) {
  return std::hypot(a[0].toDouble() - b[0].toDouble(), a[1].toDouble() - b[1].toDouble(),
                    a[2].toDouble() - b[2].toDouble());
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

 private:
  QJsonValue lines(const QString& mesh, const QStringList& flags = {},
                   const QString& camera = "front.json");
  QTemporaryDir m_folder;
};

QJsonValue LinesCommandTest::lines(const QString& mesh, const QStringList& flags,
                                   const QString& camera) {
  const QString file = m_folder.filePath("lines.json");
  QFile::remove(file);
  const Finished finished =
      runSline(QStringList{"lines", mesh, "--camera", m_folder.filePath(camera), "--size",
                           "640x480", "-o", file} +
               flags);
  if (finished.code != 0 || !finished.out.isEmpty() || !finished.err.isEmpty())
    qWarning("%s", finished.err.constData());
  QFile text(file);
  return text.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(text.readAll()).object()
                                        : QJsonObject();
}

void LinesCommandTest::initTestCase() {
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
  QTest::newRow("all") << "contour,suggestive,silhouette,section"
                       << QStringList{"contour", "section", "silhouette", "suggestive"};
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
  writeObj(m_folder.filePath("aside.obj"), *moved(*sphere(10.0f, 3), 1.0f, {50.0f, 0.0f, 0.0f}));
  const auto middle = [this](const QString& frame) {
    const QJsonArray segments =
        lines(m_folder.filePath("aside.obj"), {"--frame", frame})["kinds"]["contour"]["segments"]
            .toArray();
    double sum = 0.0;
    for (const QJsonValue& segment : segments)
      sum += segment["a"][0].toDouble();
    return segments.isEmpty() ? 0.0 : sum / double(segments.size());
  };
  QVERIFY(middle("file") > 40.0);
  QVERIFY(middle("RAS") < -40.0);
}

}  // namespace sline::test

QTEST_GUILESS_MAIN(sline::test::LinesCommandTest)
#include "lines_command_test.moc"
