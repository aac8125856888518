// SPDX-License-Identifier: Apache-2.0
#include "render/export/pixels/image_file.h"

#include <OpenImageIO/imageio.h>

#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "tests/support/suite.h"

namespace sline::render {
namespace {

/// Returns 3 × 2 pixels: opaque red, half green, clear; half white, opaque black, opaque grey.
Image sample() {
  return {3, 2, {255, 0,   0,   255, 0, 200, 0, 128, 0,   0,   0,   0,
                 255, 255, 255, 128, 0, 0,   0, 255, 128, 128, 128, 255}};
}

/// Holds the file's content as floats, channel by channel, with alpha as the file has it.
struct Held {
  int channels = 0;
  std::vector<float> values;
  bool half = false;
  bool straight = false;
  bool hasPrivateData = false;
  float at(int pixel, int channel) const { return values[std::size_t(pixel * channels + channel)]; }
};

Held held(const QString& file) {
  OIIO::ImageSpec hints;
  hints["oiio:UnassociatedAlpha"] = 1;  // leave it as it is in the file
  const auto input = OIIO::ImageInput::open(file.toStdString(), &hints);
  if (!input)
    return {};
  const OIIO::ImageSpec& spec = input->spec();
  Held h{spec.nchannels,
         {},
         spec.format == OIIO::TypeDesc::HALF,
         spec.get_int_attribute("oiio:UnassociatedAlpha") == 1,
         false};
  h.hasPrivateData = spec.find_attribute("DateTime") || spec.find_attribute("HostComputer") ||
                     spec.find_attribute("Artist");
  h.values.resize(std::size_t(spec.width * spec.height * spec.nchannels));
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, h.values.data()))
    return {};
  return h;
}

bool close(float a, float b, float tolerance = 0.004f) {
  return std::abs(a - b) <= tolerance;
}

}  // namespace

class ImageFileTest : public QObject {
  Q_OBJECT

 private slots:
  void keepsStraightAlpha_data();
  void keepsStraightAlpha();
  void exrIsLinearAndAssociated();
  void jpegStandsOnWhite();
  void opaquePicturesHaveNoAlpha();
  void names_data();
  void names();
  void oldFileSurvivesFailure();
};

void ImageFileTest::keepsStraightAlpha_data() {
  QTest::addColumn<QString>("name");
  QTest::newRow("png") << "a.png";
  QTest::newRow("tiff") << "a.tiff";
}

void ImageFileTest::keepsStraightAlpha() {
  QFETCH(QString, name);
  const QTemporaryDir folder;
  const Status written = writeImage(sample(), folder.filePath(name).toStdString());
  QVERIFY2(written.ok(), written.ok() ? "" : written.error().text().c_str());
  const Held h = held(folder.filePath(name));
  QCOMPARE(h.channels, 4);
  QVERIFY(!h.half);
  QVERIFY(!h.hasPrivateData);
  const Image image = sample();
  for (int i = 0; i < 24; ++i)
    QVERIFY(close(h.values[std::size_t(i)], float(image.rgba[std::size_t(i)]) / 255.0f, 0.001f));
}

void ImageFileTest::exrIsLinearAndAssociated() {
  const QTemporaryDir folder;
  QVERIFY(writeImage(sample(), folder.filePath("a.exr").toStdString()).ok());
  const Held h = held(folder.filePath("a.exr"));
  QCOMPARE(h.channels, 4);
  QVERIFY(h.half);
  QVERIFY(close(h.at(0, 0), 1.0f));
  const float alpha = 128.0f / 255.0f;
  QVERIFY(close(h.at(1, 1), alpha * std::pow((200.0f / 255.0f + 0.055f) / 1.055f, 2.4f)));
  QVERIFY(close(h.at(1, 3), alpha));
  QVERIFY(close(h.at(2, 3), 0.0f));
  QVERIFY(close(h.at(3, 0), alpha));
  QVERIFY(close(h.at(5, 0), 0.2158f));  // mid grey in linear light
}

void ImageFileTest::jpegStandsOnWhite() {
  const QTemporaryDir folder;
  Image image{32, 32, std::vector<std::uint8_t>(32 * 32 * 4, 0)};  // all clear
  QVERIFY(writeImage(image, folder.filePath("a.jpg").toStdString()).ok());
  Held h = held(folder.filePath("a.jpg"));
  QCOMPARE(h.channels, 3);
  QVERIFY(close(h.at(500, 0), 1.0f, 0.01f));
  for (std::size_t i = 3; i < image.rgba.size(); i += 4)
    image.rgba[i] = 128;  // half black
  QVERIFY(writeImage(image, folder.filePath("a.jpg").toStdString()).ok());
  h = held(folder.filePath("a.jpg"));
  QVERIFY(close(h.at(500, 1), 127.0f / 255.0f, 0.01f));
}

void ImageFileTest::opaquePicturesHaveNoAlpha() {
  const QTemporaryDir folder;
  const Image image{16, 16, std::vector<std::uint8_t>(16 * 16 * 4, 255)};
  for (const char* name : {"a.png", "a.tiff", "a.exr"}) {
    QVERIFY(writeImage(image, folder.filePath(name).toStdString()).ok());
    QCOMPARE(held(folder.filePath(name)).channels, 3);
  }
}

void ImageFileTest::names_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<bool>("good");
  for (const char* name : {"a.png", "a.PNG", "a.b.tif", "a.tiff", "a.exr", "a.jpg", "a.jpeg"})
    QTest::newRow(name) << name << true;
  for (const char* name : {"a", "a.", "a.svg", "a.png.txt", ".png", ""})
    QTest::addRow("refused: %s", name) << name << false;
}

void ImageFileTest::names() {
  QFETCH(QString, name);
  QFETCH(bool, good);
  const Status status = checkImageName(name.toStdString());
  QCOMPARE(status.ok(), good);
  if (!good)
    QVERIFY(status.error().text().find("png, tiff, tif, exr, jpg, jpeg") != std::string::npos);
}

void ImageFileTest::oldFileSurvivesFailure() {
  const QTemporaryDir folder;
  QVERIFY(!writeImage(sample(), folder.filePath("none/a.png").toStdString()).ok());
  QVERIFY(QDir(folder.path()).mkdir("a.png"));
  const Status onFolder = writeImage(sample(), folder.filePath("a.png").toStdString());
  QVERIFY(!onFolder.ok());
  QCOMPARE(onFolder.error().file, folder.filePath("a.png").toStdString());
  QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden), QStringList());
}

}  // namespace sline::render

SLINE_TEST(sline::render::ImageFileTest)
#include "image_file_test.moc"
