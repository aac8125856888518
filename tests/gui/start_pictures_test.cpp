// SPDX-License-Identifier: Apache-2.0
// Tests the start page's pictures: drawn by the program or read from scene files, and remembered.
#include <QBuffer>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include "model/scene_file/scene_file.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"
#include "widgets/start/demo_pictures.h"
#include "widgets/start/scene_thumbnails.h"

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
      DemoPictures pictures(cache("demos"));
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
    DemoPictures again(cache("demos"));
    QSignalSpy drawn(&again, &DemoPictures::drawn);
    again.ask({ball(made)}, DemoPictures::Missing::leave);
    QTRY_COMPARE(drawn.count(), 1);
    QCOMPARE(*made, times);
    QVERIFY(drawn[0][1].value<QImage>().convertToFormat(QImage::Format_RGB32) == first);
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
