// SPDX-License-Identifier: Apache-2.0
// Draws the window in the states that users meet first, light and dark. The pictures are for people
// to look at: SLINE_SCREENSHOTS names a folder that takes them. The test only checks that they are
// there, in the theme asked for and drawn.
#include <QAbstractButton>
#include <QCheckBox>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QLineEdit>
#include <QRadioButton>
#include <QtTest>

#include "tests/gui/window_fixture.h"
#include "tests/support/suite.h"
#include "widgets/session/demo_scenes.h"
#include "widgets/theme/theme.h"

namespace sline::test {

namespace {

void keep(const QImage& picture, const QString& name) {
  const QString folder = qEnvironmentVariable("SLINE_SCREENSHOTS");
  if (folder.isEmpty())
    return;
  QDir().mkpath(folder);
  const QString file =
      QStringLiteral("%1/%2@%3.png").arg(folder, name).arg(qRound(qApp->devicePixelRatio()));
  QVERIFY2(picture.save(file), qPrintable(file));
}

/// Returns how many colours a picture has, counted up to a thousand.
int colours(const QImage& picture) {
  QSet<QRgb> seen;
  for (int y = 0; y < picture.height(); y += 3)
    for (int x = 0; x < picture.width() && seen.size() < 1000; x += 3)
      seen.insert(picture.pixel(x, y));
  return int(seen.size());
}

}  // namespace

class WindowLooksTest : public QObject {
  Q_OBJECT

 private slots:
  void states_data() {
    QTest::addColumn<QString>("theme");
    for (const char* theme : {"light", "dark"})
      QTest::newRow(theme) << theme;
  }

  void states() {
    QFETCH(QString, theme);
    WindowFixture f;
    const widgets::ThemeFollower dressed(*qApp, f.window.preferences());
    f.window.preferences().set("appearance/theme", theme);
    f.window.preferences().set("picture/background", theme == "dark" ? "dark" : "paper");
    f.window.resize(1280, 800);
    shoot(f, "start-" + theme);

    const QString real =
        QStringLiteral(SLINE_TEST_DATA "/abdomen/AbdominalAtlas-2015Sept-Slicer4-4Version.mrml");
    if (QFileInfo::exists(real)) {
      QVERIFY(f.drop(real));
    } else {
      for (const widgets::DemoScene& demo : widgets::demoScenes())
        if (demo.id.startsWith("abdomen") && !f.session.busy())
          f.session.openMade(demo.title, demo.make);
    }
    QVERIFY(QTest::qWaitFor([&] { return f.session.document().opening != 0; }, 300'000));
    QVERIFY(f.settled());
    QTest::keyClick(&f.viewport(), Qt::Key_A);
    // The panel that is wanted first is the visible one of those that share a place.
    QVERIFY(!f.control<QDockWidget>("focusPanel").visibleRegion().isEmpty());
    shoot(f, "scene-" + theme);
    f.control<QWidget>("messageBar").hide();

    const std::vector<model::NodeId> kidney = f.session.scene().named("left kidney");
    QVERIFY(!kidney.empty());
    f.session.select({kidney.front()});
    const int steps = f.session.history().count();
    QTest::keyClick(&f.viewport(), Qt::Key_F);
    QVERIFY(QTest::qWaitFor([&] { return f.session.history().count() > steps; }, 60'000));
    shoot(f, "focus-" + theme);
    // The one control that matters is visible as a whole, down to its number.
    for (const char* name : {"gammaSlider", "stages", "gammaNumber"}) {
      auto& control = f.control<QWidget>(name);
      QCOMPARE(control.visibleRegion().boundingRect(), control.rect());
    }

    f.control<QAbstractButton>("more").click();
    shoot(f, "expert-" + theme);
    f.control<QAbstractButton>("more").click();

    auto& filter = f.control<QLineEdit>("structureFilter");
    filter.setFocus();
    QTest::keyClicks(&filter, "kid");
    QVERIFY(f.settled());
    QCOMPARE(filter.text(), "kid");
    shoot(f, "filter-" + theme);
  }

  /// Boxes that are not ticked are visible, too.
  void emptyBoxesShow_data() {
    QTest::addColumn<QString>("theme");
    for (const char* theme : {"light", "dark"})
      QTest::newRow(theme) << QString::fromLatin1(theme);
  }
  void emptyBoxesShow() {
    QFETCH(QString, theme);
    WindowFixture f;
    f.window.preferences().set(QStringLiteral("appearance/theme"), theme);
    const widgets::ThemeFollower dressed(*qApp, f.window.preferences());
    QCheckBox box;
    QRadioButton button;
    for (QWidget* empty : {static_cast<QWidget*>(&box), static_cast<QWidget*>(&button)}) {
      const QImage picture = empty->grab().toImage();
      const int ground = empty->palette().color(QPalette::Window).lightness();
      int most = 0;
      for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
          most = std::max(most, std::abs(picture.pixelColor(x, y).lightness() - ground));
      QVERIFY2(most > 50, qPrintable(QString::number(most)));
    }
  }

 private:
  void shoot(WindowFixture& f, const QString& name) {
    QVERIFY(QTest::qWaitFor([&] { return !f.session.busy(); }, 300'000));
    if (f.session.document().opening != 0)
      QVERIFY(f.settled());
    // The window system answers in its own time.
    auto& start = f.control<QWidget>("startPage");
    QVERIFY(QTest::qWaitFor([&] {
      return f.window.size() == QSize(1280, 800) &&
             (!start.isVisible() || start.width() == f.window.width());
    }));
    QCoreApplication::processEvents();
    const QImage picture = f.window.grab().toImage();
    QCOMPARE(picture.size(), f.window.size() * f.window.devicePixelRatio());
    QVERIFY(colours(picture) > 20);
    const bool dark =
        picture.pixelColor(picture.width() - 3, picture.height() - 3).lightness() < 128;
    QCOMPARE(dark, name.endsWith("dark"));
    keep(picture, name);
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::WindowLooksTest)
#include "window_looks_test.moc"
