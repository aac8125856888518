// SPDX-License-Identifier: Apache-2.0
// Tests that pictures are read as they were written, whatever their names; damaged ones and those
// that promise too much are refused.
#include "render/export/pixels/read_picture.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "render/export/pixels/image_file.h"
#include "tests/support/mutator.h"
#include "tests/support/process_memory.h"
#include "tests/support/suite.h"

namespace sline::test {

using namespace render;

namespace {

/// Returns colours with soft transitions; if `clear`, a quarter of it is half clear.
Image sample(bool clear) {
  Image image{.width = 61, .height = 47, .rgba = {}};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (const int value : {4 * x, 5 * y, (x * y) % 256, clear && x > 30 && y > 20 ? 128 : 255})
        image.rgba.push_back(std::uint8_t(value));
  return image;
}

QByteArray contents(const QString& file) {
  QFile source(file);
  return source.open(QIODevice::ReadOnly) ? source.readAll() : QByteArray();
}

void put(const QString& file, const QByteArray& bytes) {
  QFile target(file);
  if (!target.open(QIODevice::WriteOnly) || target.write(bytes) != bytes.size())
    qFatal("cannot write %s", qPrintable(file));
}

}  // namespace

class ReadPictureTest : public QObject {
  Q_OBJECT

 private slots:
  void asWritten_data();
  void asWritten();
  void sixteenBits_data();
  void sixteenBits();
  void contentCounts();
  void limits_data();
  void limits();
  void spoiled_data();
  void spoiled();

 private:
  QString written(const QString& name, const Image& image);
  QTemporaryDir m_folder;
};

QString ReadPictureTest::written(const QString& name, const Image& image) {
  const QString file = m_folder.filePath(name);
  const Status done = writeImage(image, file.toStdString());
  if (!done.ok())
    qFatal("%s", done.error().text().c_str());
  return file;
}

void ReadPictureTest::asWritten_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<bool>("clear");
  QTest::addColumn<int>("tolerance");  // out of 65535
  for (const char* kind : {"png", "tiff", "webp", "jp2"})
    for (const bool clear : {false, true})
      QTest::addRow("%s%s", kind, clear ? " clear" : "")
          << QString("a.") + kind << clear << (clear ? 400 : 0);
  QTest::newRow("exr") << "a.exr" << false << 200;
  QTest::newRow("exr clear") << "a.exr" << true << 400;
  QTest::newRow("jpg") << "a.jpg" << false << 12000;
}

void ReadPictureTest::asWritten() {
  QFETCH(QString, name);
  QFETCH(bool, clear);
  QFETCH(int, tolerance);
  const Image image = sample(clear);
  const Result<PixelRows> read = readPicture(written(name, image).toStdString());
  QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
  QCOMPARE(read->width, image.width);
  QCOMPARE(read->height, image.height);
  const PixelRows wanted = rowsOf(image, 0, image.height);
  double most = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < wanted.rgba.size(); ++i) {
    const double apart = std::abs(double(read->rgba[i]) - double(wanted.rgba[i]));
    most = std::max(most, apart);
    sum += apart;
  }
  QVERIFY2(most <= tolerance, qPrintable(QString::number(most)));
  QVERIFY2(sum <= 0.1 * tolerance * double(wanted.rgba.size()), qPrintable(QString::number(sum)));
}

void ReadPictureTest::sixteenBits_data() {
  QTest::addColumn<int>("kind");
  QTest::newRow("png") << int(PixelKind::png);
  QTest::newRow("tiff") << int(PixelKind::tiff);
  QTest::newRow("jp2") << int(PixelKind::jp2);
}

/// All sixteen bits survive writing and reading.
void ReadPictureTest::sixteenBits() {
  QFETCH(int, kind);
  const std::string file = m_folder.filePath("deep").toStdString();
  const PixelLayout layout{.width = 40, .height = 40, .channels = 1, .bits = 16};
  std::vector<std::uint16_t> values(40 * 40);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = std::uint16_t(i * 40);
  const auto rows = rowFile(PixelKind(kind), layout, file);
  QVERIFY(rows.ok());
  QVERIFY((*rows)->add(std::as_bytes(std::span(values))).ok());
  QVERIFY((*rows)->finish().ok());
  const Result<PixelRows> read = readPicture(file);
  QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t c = 0; c < 4; ++c)
      QCOMPARE(read->rgba[4 * i + c], c < 3 ? values[i] : std::uint16_t(65535));
}

void ReadPictureTest::contentCounts() {
  const QString other = m_folder.filePath("other.tiff");
  put(other, contents(written("a.jpg", sample(false))));
  QVERIFY(readPicture(other.toStdString()).ok());
  for (const QByteArray& bytes : {QByteArray(), QByteArray("solid a\n"), QByteArray("GIF89a"),
                                  QByteArray("<svg/>"), QByteArray(128, '\0') + "DICM"}) {
    put(other, bytes);
    const Result<PixelRows> refused = readPicture(other.toStdString());
    QVERIFY(!refused.ok());
    QCOMPARE(refused.error().file, other.toStdString());
    QVERIFY(!refused.error().reason.empty() && !refused.error().remedy.empty());
  }
  QVERIFY(!readPicture(m_folder.filePath("nothing.png").toStdString()).ok());
}

void ReadPictureTest::limits_data() {
  QTest::addColumn<QString>("name");
  for (const char* kind : {"png", "tiff", "exr", "jpg", "webp", "jp2"})
    QTest::newRow(kind) << QString("a.") + kind;
}

void ReadPictureTest::limits() {
  QFETCH(QString, name);
  const Image image = sample(false);
  const std::string file = written(name, image).toStdString();
  const auto pixels = std::uint64_t(image.width * image.height);
  QVERIFY(readPicture(file, {.pixels = pixels}).ok());
  const Result<PixelRows> refused = readPicture(file, {.pixels = pixels - 1});
  QVERIFY(!refused.ok());
  QVERIFY2(refused.error().reason.find("61×47") != std::string::npos,
           refused.error().reason.c_str());
  QVERIFY(!readPicture(file, {.fileBytes = 100}).ok());
}

void ReadPictureTest::spoiled_data() {
  limits_data();
}

/// Pictures may come from anywhere.
void ReadPictureTest::spoiled() {
  QFETCH(QString, name);
  const QByteArray whole = contents(written(name, sample(true)));
  const QString file = m_folder.filePath("spoiled");
  Mutator spoil(17, {});
  int read = 0;
  int silent = 0;
  resetPeak();
  const double before = residentMiB();
  for (int i = 0; i < 200; ++i) {
    put(file, spoil(whole));
    const Result<PixelRows> result = readPicture(file.toStdString(), {.pixels = 4'000'000});
    read += result.ok();
    silent += !result.ok() && (result.error().reason.empty() || result.error().remedy.empty());
  }
  const double taken = peakResidentMiB() - before;
  qInfo("%d of 200 are read, %d refused, %.0f MiB at most", read, 200 - read, taken);
  QVERIFY2(sanitized || taken < 300.0, qPrintable(QString::number(taken)));
  QCOMPARE(silent, 0);
}

}  // namespace sline::test

SLINE_TEST(sline::test::ReadPictureTest)
#include "read_picture_test.moc"
