// SPDX-License-Identifier: Apache-2.0
#include <QTest>
#include <glm/geometric.hpp>

#include "render/labels/seen/screen.h"
#include "render/lettering/scale_length.h"
#include "tests/support/suite.h"

Q_DECLARE_METATYPE(glm::vec3)

using namespace sline;
using namespace sline::render;

class ScaleLengthTest : public QObject {
  Q_OBJECT
 private slots:
  void steps_data() {
    QTest::addColumn<double>("most");
    QTest::addColumn<double>("step");
    QTest::newRow("1") << 1.0 << 1.0;
    QTest::newRow("1.9") << 1.9 << 1.0;
    QTest::newRow("2") << 2.0 << 2.0;
    QTest::newRow("4.99") << 4.99 << 2.0;
    QTest::newRow("5") << 5.0 << 5.0;
    QTest::newRow("9.9") << 9.9 << 5.0;
    QTest::newRow("70") << 70.0 << 50.0;
    QTest::newRow("0.03") << 0.03 << 0.02;
    QTest::newRow("1234") << 1234.0 << 1000.0;
  }
  void steps() {
    QFETCH(double, most);
    QFETCH(double, step);
    QVERIFY(std::abs(roundStep(most) - step) < 1e-9 * step);
  }

  /// The bar is as long on screen as two points that far apart at the pivot's depth.
  void isTrue_data() {
    QTest::addColumn<int>("projection");
    QTest::addColumn<glm::vec3>("pivot");
    const auto row = [](const char* name, model::Projection projection, glm::vec3 pivot) {
      QTest::newRow(name) << int(projection) << pivot;
    };
    row("perspective", model::Projection::perspective, {0, 0, 0});
    row("perspective, near", model::Projection::perspective, {20, -400, 10});
    row("perspective, far", model::Projection::perspective, {-30, 900, 50});
    row("orthographic", model::Projection::orthographic, {0, 0, 0});
  }
  void isTrue() {
    QFETCH(int, projection);
    QFETCH(glm::vec3, pivot);
    model::Camera camera = model::anatomicalCamera(model::AnatomicalView::anterior, {}, 1.0f);
    camera.projection = model::Projection(projection);
    const glm::vec2 size(900.0f, 700.0f);
    const auto bar = scaleLength(camera, pivot, size.y, 140.0);
    QVERIFY(bar && bar->drawn <= 140.0 && bar->drawn > 140.0 / 2.6);
    const glm::vec3 end = pivot + float(bar->millimetres) * model::cameraFrame(camera).right;
    const Screen screen(camera, size);
    const float drawn = glm::length(*screen.place(end) - *screen.place(pivot));
    QVERIFY2(std::abs(double(drawn) - bar->drawn) < 0.1, qPrintable(QString::number(drawn)));
  }
  void noneBehindTheEye() {
    const model::Camera camera;
    QVERIFY(!scaleLength(camera, {0, -2000, 0}, 700.0, 140.0));
  }

  void texts_data() {
    QTest::addColumn<double>("millimetres");
    QTest::addColumn<QString>("english");
    QTest::addColumn<QString>("german");
    QTest::newRow("half") << 0.5 << "0.5 mm"
                          << "0,5 mm";
    QTest::newRow("a tenth") << 0.1 << "0.1 mm"
                             << "0,1 mm";
    QTest::newRow("0.05") << 0.05 << "50 µm"
                          << "50 µm";
    QTest::newRow("0.002") << 0.002 << "2 µm"
                           << "2 µm";
    QTest::newRow("0.0000005") << 0.0000005 << "0.5 nm"
                               << "0,5 nm";
    QTest::newRow("5") << 5.0 << "5 mm"
                       << "5 mm";
    QTest::newRow("10") << 10.0 << "1 cm"
                        << "1 cm";
    QTest::newRow("200") << 200.0 << "20 cm"
                         << "20 cm";
    QTest::newRow("1000") << 1000.0 << "1 m"
                          << "1 m";
  }
  void texts() {
    QFETCH(double, millimetres);
    QFETCH(QString, english);
    QFETCH(QString, german);
    QCOMPARE(lengthText(millimetres, QLocale(QLocale::English)), english);
    QCOMPARE(lengthText(millimetres, QLocale(QLocale::German)), german);
  }
  void aDoubtedUnitIsMarked() {
    const QLocale english(QLocale::English);
    const auto text = [&english](double millimetres) {
      return lengthText(millimetres, english, model::DrawnUnit::doubtedMillimetre);
    };
    QCOMPARE(text(5.0), QStringLiteral("5 mm?"));
    QCOMPARE(text(0.05), QStringLiteral("50 µm?"));
    QCOMPARE(text(200.0), QStringLiteral("20 cm?"));
    QCOMPARE(text(2000.0), QStringLiteral("2 m?"));
  }
  void moleculesAreInAngstroms() {
    const QLocale english(QLocale::English);
    QCOMPARE(lengthText(10.0, english, model::DrawnUnit::angstrom), QStringLiteral("10 Å"));
    QCOMPARE(lengthText(0.5, english, model::DrawnUnit::angstrom), QStringLiteral("0.5 Å"));
    QCOMPARE(lengthText(1000.0, english, model::DrawnUnit::angstrom), QStringLiteral("1,000 Å"));
    QCOMPARE(lengthText(20000.0, english, model::DrawnUnit::angstrom), QStringLiteral("20,000 Å"));
  }
};

SLINE_TEST(ScaleLengthTest)
#include "scale_length_test.moc"
