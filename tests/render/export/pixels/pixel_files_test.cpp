// SPDX-License-Identifier: Apache-2.0
#include "render/export/pixels/pixel_files.h"
#include "render/export/pixels/pixel_options.h"

#include <OpenImageIO/imageio.h>

#include <QColorSpace>
#include <QDir>
#include <QFile>
#include <QImageReader>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <set>

#include "model/edit/look.h"
#include "tests/render/export/pixels/ordered_scene.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

using Writer = Status (*)(const render::ExportOrder&, const std::filesystem::path&,
                          const render::ExportProgress&);
struct Kind {
  const char* extension;
  Writer write;
};
constexpr std::array<Kind, 6> kinds{{{"png", render::writePng},
                                     {"tiff", render::writeTiff},
                                     {"jpg", render::writeJpeg},
                                     {"exr", render::writeExr},
                                     {"webp", render::writeWebpPicture},
                                     {"jp2", render::writeJp2}}};

Writer writerOf(const QString& extension) {
  for (const Kind& kind : kinds)
    if (extension == kind.extension)
      return kind.write;
  return nullptr;
}

/// Holds a file as another reader finds it.
struct Read {
  OIIO::ImageSpec spec;
  std::vector<float> values;  ///< as they are in the file
  double mean() const {
    double sum = 0.0;
    for (const float value : values)
      sum += double(value);
    return sum / double(std::max<std::size_t>(values.size(), 1));
  }
};

Read readBack(const QString& file) {
  OIIO::ImageSpec hints;
  hints["oiio:UnassociatedAlpha"] = 1;
  const auto input = OIIO::ImageInput::open(file.toStdString(), &hints);
  if (!input)
    return {};
  Read read{input->spec(), {}};
  read.values.resize(std::size_t(read.spec.width) * std::size_t(read.spec.height) *
                     std::size_t(read.spec.nchannels));
  if (!input->read_image(0, 0, 0, read.spec.nchannels, OIIO::TypeDesc::FLOAT, read.values.data()))
    return {};
  return read;
}

QByteArray contents(const QString& file) {
  QFile source(file);
  return source.open(QIODevice::ReadOnly) ? source.readAll() : QByteArray();
}

/// Returns the names of a PNG's chunks in order, without repetitions.
QStringList chunks(const QByteArray& png) {
  QStringList names;
  for (qsizetype at = 8; at + 12 <= png.size();) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(png.constData() + at);
    const qsizetype length = bytes[0] << 24 | bytes[1] << 16 | bytes[2] << 8 | bytes[3];
    const QString name = QString::fromLatin1(png.mid(at + 4, 4));
    if (names.isEmpty() || names.back() != name)
      names << name;
    at += 12 + length;
  }
  return names;
}

/// Returns the scene drawn for print in black and white.
render::ExportOrder inkOrder() {
  render::ExportOrder order = orderedPicture();
  order.scene = model::withInkAlone(order.scene).scene;
  order.page.dpi = 300.0f;
  order.pureInk = true;
  return order;
}

QStringList everything(const QString& folder) {
  return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
}

}  // namespace

class PixelFilesTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void readBackByOthers_data();
  void readBackByOthers();
  void kindsAgree();
  void pngSaysWhatItIs();
  void sixteenBitsAreReal();
  void inkAlone_data();
  void inkAlone();
  void stopLeavesNothing_data();
  void stopLeavesNothing();
  void badTargets_data();
  void badTargets();
  void tellsNothingElse();
  void tooLarge();

 private:
  QString written(const QString& name, const render::ExportOrder& order);
  QTemporaryDir m_folder;
};

void PixelFilesTest::initTestCase() {
  if (const Studio studio = openStudio(); !studio.picture)
    QSKIP(studio.absent.c_str());
}

QString PixelFilesTest::written(const QString& name, const render::ExportOrder& order) {
  const QString file = m_folder.filePath(name);
  const Status done = writerOf(QFileInfo(name).suffix())(order, file.toStdString(), {});
  if (!done.ok())
    qWarning("%s", done.error().text().c_str());
  return done.ok() ? file : QString();
}

void PixelFilesTest::readBackByOthers_data() {
  QTest::addColumn<QString>("extension");
  QTest::addColumn<int>("bits");
  QTest::addColumn<bool>("grey");
  QTest::addColumn<bool>("clear");
  QTest::addColumn<int>("channels");
  QTest::addColumn<QString>("type");
  for (const char* extension : {"png", "tiff"})
    for (const int bits : {8, 16})
      for (const bool grey : {false, true})
        for (const bool clear : {false, true})
          QTest::addRow("%s %d%s%s", extension, bits, grey ? " grey" : "", clear ? " clear" : "")
              << extension << bits << grey << clear << (grey ? 1 : 3) + (clear ? 1 : 0)
              << QString("uint%1").arg(bits);
  QTest::newRow("jpeg") << "jpg" << 8 << false << true << 3 << "uint8";
  QTest::newRow("jpeg grey") << "jpg" << 16 << true << false << 1 << "uint8";
  QTest::newRow("exr") << "exr" << 8 << false << true << 4 << "half";
  QTest::newRow("exr opaque") << "exr" << 8 << false << false << 3 << "half";
}

void PixelFilesTest::readBackByOthers() {
  QFETCH(QString, extension);
  QFETCH(int, bits);
  QFETCH(bool, grey);
  QFETCH(bool, clear);
  QFETCH(int, channels);
  QFETCH(QString, type);
  render::ExportOrder order = orderedPicture();
  order.of<render::PixelOptions>() = {.bits = bits, .grey = grey, .samples = 1};
  order.environment.background =
      clear ? render::Background::transparent : render::Background::paper;
  const QString file = written("picture." + extension, order);
  const Read read = readBack(file);
  QCOMPARE(read.spec.width, 472);
  QCOMPARE(read.spec.height, 315);
  QCOMPARE(read.spec.nchannels, channels);
  QCOMPARE(QString(read.spec.format.c_str()), type);
  QVERIFY(std::abs(read.spec.get_float_attribute("XResolution") - 100.0f) < 0.02f);
  QVERIFY(read.spec.get_string_attribute("ResolutionUnit").substr(0, 2) == "in");
  QVERIFY(!read.spec.find_attribute("DateTime"));
  const bool profile = extension == "tiff" || extension == "jpg" || (grey && extension == "png");
  QCOMPARE(read.spec.find_attribute("ICCProfile") != nullptr, profile);
  if (profile)
    QCOMPARE(QString(read.spec.get_string_attribute("ICCProfile:color_space").c_str()),
             QString(grey ? "Gray" : "RGB"));
  if (clear && channels % 2 == 0) {
    // The corner is clear, the shaded ring is not.
    QCOMPARE(read.values[std::size_t(channels - 1)], 0.0f);
    float most = 0.0f;
    for (std::size_t i = std::size_t(channels - 1); i < read.values.size(); i += channels)
      most = std::max(most, read.values[i]);
    QCOMPARE(most, 1.0f);
  }
  if (!QImageReader::supportedImageFormats().contains(extension.toLatin1()))
    return;
  const QImage image(file);
  QCOMPARE(image.size(), QSize(472, 315));
  QVERIFY(std::abs(image.dotsPerMeterX() * 0.0254 - 100.0) < 0.1);
  if (!grey)
    QVERIFY(image.colorSpace() == QColorSpace(QColorSpace::SRgb) ||
            image.colorSpace().primaries() == QColorSpace::Primaries::SRgb);
}

/// Kinds of 8 bits show the same pixels, and so do those of more. Those are drawn by another
/// painter, which may decide otherwise where a surface ends between two samples.
void PixelFilesTest::kindsAgree() {
  render::ExportOrder order = orderedPicture();
  order.of<render::PixelOptions>().samples = 2;
  const Read png = readBack(written("a.png", order));
  const Read tiff = readBack(written("a.tiff", order));
  const Read jpeg = readBack(written("a.jpg", order));
  const Read exr = readBack(written("a.exr", order));
  order.of<render::PixelOptions>().bits = 16;
  const Read deep = readBack(written("b.png", order));
  const Read deepTiff = readBack(written("b.tiff", order));
  QCOMPARE(png.values, tiff.values);
  QCOMPARE(deep.values, deepTiff.values);
  QCOMPARE(deep.values, readBack(written("b.jp2", order)).values);
  QCOMPARE(png.values, readBack(written("a.webp", order)).values);
  QCOMPARE(jpeg.values.size(), png.values.size());
  double apart = 0.0;
  double fromDeep = 0.0;
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < png.values.size(); ++i) {
    const float off = std::abs(png.values[i] - deep.values[i]);
    fromDeep += double(off);
    beyond += off >= 2.1f / 255.0f;
    const float light = exr.values[i];
    const float srgb =
        light <= 0.0031308f ? 12.92f * light : 1.055f * std::pow(light, 1.0f / 2.4f) - 0.055f;
    QVERIFY2(std::abs(deep.values[i] - srgb) < 1.0f / 255.0f,
             qPrintable(QString("%1 %2").arg(double(deep.values[i])).arg(double(srgb))));
    apart += std::abs(double(png.values[i]) - double(jpeg.values[i]));
  }
  const auto count = double(png.values.size());
  QVERIFY(apart / count < 0.01);
  QVERIFY2(double(beyond) < 0.001 * count, qPrintable(QString::number(beyond)));
  QVERIFY2(fromDeep / count < 0.2 / 255.0, qPrintable(QString::number(255.0 * fromDeep / count)));
}

void PixelFilesTest::pngSaysWhatItIs() {
  render::ExportOrder order = orderedPicture();
  order.altText = "off";
  QCOMPARE(chunks(contents(written("a.png", order))),
           QStringList({"IHDR", "sRGB", "gAMA", "cHRM", "pHYs", "tEXt", "IDAT", "IEND"}));
  order.of<render::PixelOptions>().grey = true;
  QCOMPARE(chunks(contents(written("a.png", order))),
           QStringList({"IHDR", "iCCP", "pHYs", "tEXt", "IDAT", "IEND"}));
}

void PixelFilesTest::sixteenBitsAreReal() {
  render::ExportOrder order = orderedPicture();
  order.labels.mode = render::LabelMode::off;
  order.of<render::PixelOptions>().bits = 16;
  std::set<int> reds;
  for (const float value : readBack(written("a.png", order)).values)
    reds.insert(int(std::lround(value * 65535.0f)));
  order.of<render::PixelOptions>().bits = 8;
  std::set<int> coarse;
  for (const float value : readBack(written("b.png", order)).values)
    coarse.insert(int(std::lround(value * 255.0f)));
  QVERIFY(coarse.size() <= 256);
  // Shading and softened edges have far more tones than 8 bits can hold.
  QVERIFY2(reds.size() > 5000, qPrintable(QString::number(reds.size())));
}

void PixelFilesTest::inkAlone_data() {
  QTest::addColumn<QString>("extension");
  QTest::addColumn<int>("bits");
  for (const char* extension : {"png", "tiff"})
    for (const int bits : {1, 8})
      QTest::addRow("%s, %d", extension, bits) << extension << bits;
}

void PixelFilesTest::inkAlone() {
  QFETCH(QString, extension);
  QFETCH(int, bits);
  render::ExportOrder order = inkOrder();
  order.of<render::PixelOptions>().bits = bits;
  const QString file = written("ink." + extension, order);
  const Read read = readBack(file);
  QCOMPARE(read.spec.nchannels, 1);
  // The reader widens PNG's bits; the header has the truth.
  QCOMPARE(extension == "png" ? int(contents(file).at(24))
                              : read.spec.get_int_attribute("oiio:BitsPerSample", 8),
           bits);
  std::size_t greys = 0;
  for (const float value : read.values)
    greys += value != 0.0f && value != 1.0f;
  QCOMPARE(greys, std::size_t(0));
  QVERIFY(read.mean() < 0.99);
  // There is as much ink as in the picture with soft edges.
  order.of<render::PixelOptions>() = {.bits = 8, .grey = true};
  const Read soft = readBack(written("soft." + extension, order));
  QCOMPARE(soft.values.size(), read.values.size());
  const double share = (1.0 - read.mean()) / (1.0 - soft.mean());
  QVERIFY2(std::abs(share - 1.0) < 0.03, qPrintable(QString::number(share)));
  if (bits == 1)
    QVERIFY(contents(file).size() < contents(m_folder.filePath("soft." + extension)).size());
}

void PixelFilesTest::stopLeavesNothing_data() {
  QTest::addColumn<QString>("extension");
  QTest::addColumn<double>("share");
  for (const Kind& kind : kinds)
    for (const double share : {0.0, 0.3, 0.96})
      QTest::addRow("%s at %g", kind.extension, share) << kind.extension << share;
}

void PixelFilesTest::stopLeavesNothing() {
  QFETCH(QString, extension);
  QFETCH(double, share);
  const QTemporaryDir folder;
  const std::string target = folder.filePath("a." + extension).toStdString();
  render::ExportOrder order = orderedPicture();
  order.page.dpi = 300.0f;
  double reached = -1.0;
  const Status done = writerOf(extension)(order, target, [&](double behind, std::string_view what) {
    reached = std::max(reached, behind);
    return what.empty() || behind < share;
  });
  QVERIFY(!done.ok());
  QCOMPARE(done.error().text(), render::givenUp(target).text());
  QVERIFY(reached >= share);
  QCOMPARE(everything(folder.path()), QStringList());
}

void PixelFilesTest::badTargets_data() {
  QTest::addColumn<QString>("extension");
  QTest::addColumn<QString>("target");
  for (const Kind& kind : kinds) {
    const QString extension = kind.extension;
    QTest::addRow("%s, no such folder", kind.extension) << extension << "nowhere/a." + extension;
    QTest::addRow("%s, a folder", kind.extension) << extension << "folder";
    QTest::addRow("%s, below a file", kind.extension) << extension << "file/a." + extension;
    QTest::addRow("%s, name too long", kind.extension)
        << extension << QString(300, 'x') + '.' + extension;
    QTest::addRow("%s, no space", kind.extension) << extension << "/dev/full";
  }
}

void PixelFilesTest::badTargets() {
  QFETCH(QString, extension);
  QFETCH(QString, target);
  if (target == "/dev/full" && !QFile::exists(target))
    QSKIP("no device without space");
  const QTemporaryDir folder;
  QVERIFY(QDir(folder.path()).mkdir("folder"));
  QFile file(folder.filePath("file"));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.close();
  const QStringList before = everything(folder.path());
  const std::string path = QDir(folder.path()).filePath(target).toStdString();
  render::ExportOrder order = orderedPicture();
  order.of<render::PixelOptions>().samples = 1;
  const Status done = writerOf(extension)(order, path, {});
  QVERIFY(!done.ok());
  QCOMPARE(done.error().file, path);
  QVERIFY(!done.error().reason.empty() && !done.error().remedy.empty());
  QCOMPARE(everything(folder.path()), before);
}

void PixelFilesTest::tellsNothingElse() {
  const QTemporaryDir folder(QDir::tempPath() + "/planted-marker-XXXXXX");
  render::ExportOrder order = orderedPicture();
  order.of<render::PixelOptions>().samples = 1;
  for (const Kind& kind : kinds) {
    QByteArray first;
    for (const char* name : {"one.", "two ß 日本."}) {
      const QString file = folder.filePath(QString::fromUtf8(name) + kind.extension);
      QVERIFY(kind.write(order, file.toStdString(), {}).ok());
      const QByteArray bytes = contents(file);
      for (const char* word : {"planted", "/tmp", "a ball"})
        QVERIFY2(!bytes.contains(word), word);
      for (const char* variable : {"USER", "HOME", "HOSTNAME", "LOGNAME"})
        if (const QByteArray value = qgetenv(variable); value.size() > 3)
          QVERIFY2(!bytes.contains(value), variable);
      // The files are the same each time, under any name.
      if (first.isEmpty())
        first = bytes;
      QCOMPARE(bytes, first);
    }
  }
}

void PixelFilesTest::tooLarge() {
  render::ExportOrder order = orderedPicture();
  order.page = {.sizeMm = {1000.0f, 1700.0f}, .dpi = 300.0f};
  const Status done = render::writePng(order, m_folder.filePath("large.png").toStdString(), {});
  QVERIFY(!done.ok());
  QVERIFY(done.error().text().find("20000") != std::string::npos);
  QVERIFY(!QFile::exists(m_folder.filePath("large.png")));
}

}  // namespace sline::test

SLINE_TEST(sline::test::PixelFilesTest)
#include "pixel_files_test.moc"
