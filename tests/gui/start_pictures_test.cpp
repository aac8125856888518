// SPDX-License-Identifier: Apache-2.0
// Tests the start page's pictures: drawn by the program or read from scene files, and remembered.
#include <QApplication>
#include <QBuffer>
#include <QDir>
#include <QFileInfo>
#include <QMainWindow>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include "model/look/drawing_styles.h"
#include "model/scene_file/scene_file.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"
#include "widgets/session/recent_files.h"
#include "widgets/start/demo_pictures.h"
#include "widgets/start/drawing_choice.h"
#include "widgets/start/scene_thumbnails.h"
#include "widgets/start/start_page.h"
#include "widgets/start/thumbnail_card.h"

namespace sline::test {

using widgets::DemoPictures;
using widgets::PictureCache;

class StartPicturesTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

  static widgets::DemoScene ball(const std::shared_ptr<int>& made) {
    return {
        .id = QStringLiteral("ball"),
        .title = QStringLiteral("Ball"),
        .key = QStringLiteral("ball-v2"),
        .make = [made](const model::ImportProgress&,
                       const std::stop_token&) -> Result<widgets::LoadedDocument> {
          ++*made;
          model::Scene scene;
          scene.append(
              {.name = "ball", .style = {.gamma = Gamma::clamped(5.0f)}, .mesh = sphere(10.0f, 3)});
          return widgets::LoadedDocument{.scene = std::move(scene), .title = {}, .remarks = {}};
        }};
  }
  static QByteArray png(const QSize& size, const QColor& colour) {
    QImage image(size, QImage::Format_RGB32);
    image.fill(colour);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!buffer.open(QIODevice::WriteOnly) || !image.save(&buffer, "PNG"))
      qFatal("no PNG");
    return bytes;
  }
  PictureCache cache(const char* name) const {
    return PictureCache(m_folder.filePath(QLatin1String(name)).toStdString());
  }

 private slots:
  void demosAreDrawnOnce() {
    const auto made = std::make_shared<int>(0);
    QImage first;
    {
      DemoPictures pictures(cache("none"), cache("demos"));
      QSignalSpy drawn(&pictures, &DemoPictures::drawn);
      pictures.ask({ball(made)}, DemoPictures::Missing::leave);
      pictures.ask({ball(made)}, DemoPictures::Missing::draw);
      QTRY_VERIFY_WITH_TIMEOUT(drawn.count() > 0, 60'000);
      QCOMPARE(drawn[0][0].toString(), QStringLiteral("ball"));
      first = drawn[0][1].value<QImage>();
    }
    const int times = *made;
    QVERIFY(times >= 1);
    const QColor corner = first.pixelColor(0, 0);
    int darkest = 255;
    for (int x = 0; x < first.width(); ++x)
      darkest = std::min(darkest, first.pixelColor(x, first.height() / 2).lightness());
    QVERIFY2(corner.lightness() > darkest + 60, "a shaded ball before paper");
    DemoPictures again(cache("none"), cache("demos"));
    QSignalSpy drawn(&again, &DemoPictures::drawn);
    again.ask({ball(made)}, DemoPictures::Missing::leave);
    QTRY_COMPARE(drawn.count(), 1);
    QCOMPARE(*made, times);
    QVERIFY(drawn[0][1].value<QImage>().convertToFormat(QImage::Format_RGB32) == first);
  }

  void builtPicturesAreThereAtOnce() {
    QImage green(480, 360, QImage::Format_RGB32);
    green.fill(Qt::green);
    cache("built").keep(QStringLiteral("ball-v2"), green);
    const auto made = std::make_shared<int>(0);
    DemoPictures pictures(cache("built"), cache("unused"));
    QSignalSpy drawn(&pictures, &DemoPictures::drawn);
    pictures.ask({ball(made)}, DemoPictures::Missing::draw);
    QCOMPARE(drawn.count(), 1);
    QVERIFY(drawn[0][1].value<QImage>().convertToFormat(QImage::Format_RGB32) == green);
    QTest::qWait(50);
    QCOMPARE(*made, 0);
    QVERIFY(!QDir(m_folder.filePath(QStringLiteral("unused"))).exists());
  }

  void picturesOfOlderDemosAreNot() {
    QImage green(480, 360, QImage::Format_RGB32);
    green.fill(Qt::green);
    cache("older").keep(QStringLiteral("ball-v1"), green);
    const auto made = std::make_shared<int>(0);
    DemoPictures pictures(cache("older"), cache("newer"));
    QSignalSpy drawn(&pictures, &DemoPictures::drawn);
    pictures.ask({ball(made)}, DemoPictures::Missing::draw);
    QCOMPARE(drawn.count(), 0);
    QTRY_VERIFY_WITH_TIMEOUT(drawn.count() > 0, 60'000);
    QCOMPARE(*made, 1);
    QVERIFY(drawn[0][1].value<QImage>().pixelColor(0, 0) != QColor(Qt::green));
  }

  // Without a turn of the event loop, and without drawing, each card has its own picture.
  void thePageShowsThem() {
    const auto demos = widgets::demoScenes();
    for (std::size_t i = 0; i < demos.size(); ++i) {
      QImage picture(480, 360, QImage::Format_RGB32);
      picture.fill(QColor::fromHsv(int(60 * i), 255, 255));
      cache("page").keep(demos[i].key, picture);
    }
    QSettings settings(m_folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat);
    widgets::RecentFiles recent(settings);
    QMainWindow window;
    window.resize(1200, 800);
    widgets::StartPage page(window, recent,
                            {m_folder.filePath(QStringLiteral("page")).toStdString(), {}});
    page.setDrawing(false);
    window.show();
    page.show();
    for (std::size_t i = 0; i < demos.size(); ++i) {
      auto* card =
          page.findChild<widgets::ThumbnailCard*>(QStringLiteral("startDemo-") + demos[i].id);
      QVERIFY(card && card->hasPicture());
      const QColor shown = card->grab().toImage().pixelColor(card->width() / 2, card->height() / 3);
      QVERIFY2(std::abs(shown.hsvHue() - int(60 * i)) < 10, qPrintable(shown.name()));
    }
  }

  // The build has drawn them: as many as there are demos, small, and each of something.
  void theBuildHasDrawnThem() {
    const QDir folder(QString::fromStdString(widgets::builtDemoPictures().string()));
    if (!folder.exists())
      QSKIP("this build draws no demos");
    for (const widgets::DemoScene& demo : widgets::demoScenes()) {
      const QString file = folder.filePath(demo.key + QStringLiteral(".png"));
      QVERIFY2(QFileInfo(file).size() < 40 * 1024, qPrintable(file));
      const QImage picture(file);
      QCOMPARE(picture.size(), QSize(480, 360));
      int dark = 0;
      for (int x = 0; x < picture.width(); ++x)
        dark += picture.pixelColor(x, picture.height() / 2).lightness() < 140;
      QVERIFY2(dark > 4, qPrintable(file));
    }
  }

  void theBuildHasDrawnStyles() {
    const QDir folder(QString::fromStdString(widgets::builtDemoPictures().string()));
    if (!folder.exists())
      QSKIP("this build draws no demos");
    for (const model::DrawingStyle& style : model::drawingStyles()) {
      const QString file =
          folder.filePath(QStringLiteral("drawing-%1.png").arg(QLatin1String(style.id.data())));
      QVERIFY2(QFileInfo(file).size() > 0 && QFileInfo(file).size() < 40 * 1024, qPrintable(file));
      const int corner = QImage(file).pixelColor(2, 2).lightness();
      QVERIFY2(style.background == "dark" ? corner < 60 : corner > 230, qPrintable(file));
    }
  }

  // The cards are radio buttons: one is checked, Tab stops at it, the arrow keys choose.
  void aDrawingIsChosen() {
    QImage green(480, 360, QImage::Format_RGB32);
    green.fill(Qt::green);
    cache("styles").keep(QStringLiteral("drawing-b"), green);
    widgets::DrawingChoice choice(cache("styles"));
    choice.offer({{.id = "a", .picture = "drawing-a", .name = "A", .description = "First"},
                  {.id = "b", .picture = "drawing-b", .name = "B", .description = "Second"},
                  {.id = "c", .picture = "drawing-c", .name = "C", .description = "Third"}});
    choice.resize(700, 200);
    choice.show();
    QApplication::setActiveWindow(&choice);
    QVERIFY(QTest::qWaitForWindowExposed(&choice));
    const auto card = [&choice](const char* id) {
      return choice.findChild<widgets::ThumbnailCard*>(QStringLiteral("startDrawing-") + id);
    };
    QVERIFY(card("b")->hasPicture() && !card("a")->hasPicture());
    QCOMPARE(card("b")->accessibleDescription(), QStringLiteral("Second"));
    QSignalSpy chosen(&choice, &widgets::DrawingChoice::chosen);
    choice.setChosen(QStringLiteral("none of them"));
    QVERIFY(!card("a")->isChecked() && !card("b")->isChecked());
    QVERIFY(card("a")->focusPolicy() & Qt::TabFocus);
    choice.setChosen(QStringLiteral("b"));
    QVERIFY(card("b")->isChecked());
    QVERIFY(card("b")->focusPolicy() & Qt::TabFocus);
    QVERIFY(!(card("a")->focusPolicy() & Qt::TabFocus));
    QCOMPARE(chosen.count(), 0);
    const QImage before = card("a")->grab().toImage();
    QTest::mouseClick(card("a"), Qt::LeftButton);
    QCOMPARE(chosen.takeFirst()[0].toString(), QStringLiteral("a"));
    QVERIFY(card("a")->isChecked() && !card("b")->isChecked());
    card("c")->setFocus();
    QVERIFY2(card("a")->grab().toImage() != before, "a mark");
    card("a")->setFocus();
    QTest::keyClick(card("a"), Qt::Key_Right);
    QCOMPARE(chosen.takeFirst()[0].toString(), QStringLiteral("b"));
    QVERIFY(card("b")->isChecked() && card("b")->hasFocus());
  }

  void picturesOfFiles_data() {
    QTest::addColumn<QByteArray>("thumbnail");
    QTest::addColumn<bool>("shown");
    QTest::newRow("a picture") << png({32, 24}, Qt::red) << true;
    QTest::newRow("none") << QByteArray() << false;
    QTest::newRow("no picture") << QByteArray("Dear Sir or Madam") << false;
    QTest::newRow("cut short") << png({32, 24}, Qt::red).left(40) << false;
    QTest::newRow("too large") << png({5000, 1}, Qt::red) << false;
  }
  void picturesOfFiles() {
    QFETCH(QByteArray, thumbnail);
    QFETCH(bool, shown);
    const QString file = m_folder.filePath(QStringLiteral("a.sline"));
    QVERIFY(model::writeSceneFile(file.toStdString(), {.thumbnail = thumbnail.toStdString()}).ok());
    widgets::SceneThumbnails thumbnails(cache("files"));
    QSignalSpy found(&thumbnails, &widgets::SceneThumbnails::found);
    thumbnails.ask(file);
    QTRY_COMPARE(found.count(), 1);
    QCOMPARE(found[0][1].value<QImage>().isNull(), !shown);
    thumbnails.ask(file);  // from the cache now, where there is one
    QTRY_COMPARE(found.count(), 2);
    QCOMPARE(found[1][1].value<QImage>().isNull(), !shown);
  }

  void whatIsMissingIsSaid() {
    widgets::SceneThumbnails thumbnails(cache("files"));
    QSignalSpy missing(&thumbnails, &widgets::SceneThumbnails::missing);
    thumbnails.ask(m_folder.filePath(QStringLiteral("gone.sline")));
    QTRY_COMPARE(missing.count(), 1);
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::StartPicturesTest)
#include "start_pictures_test.moc"
