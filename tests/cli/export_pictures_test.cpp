// SPDX-License-Identifier: Apache-2.0
#include <QDir>
#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/sline_process.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

class ExportPicturesTest : public QObject {
  Q_OBJECT

 private slots:
  void sizes_data();
  void sizes();
  void severalKindsAtOnce();
  void throughAPipe_data();
  void throughAPipe();
  void withoutTheModule();
  void blackAndWhiteIsPure();
  void wrongUse_data();
  void wrongUse();
  void badTargets();

 private:
  QTemporaryDir m_folder;
  QString m_sample = writeSample(m_folder.path());
};

void ExportPicturesTest::sizes_data() {
  QTest::addColumn<QStringList>("flags");
  QTest::addColumn<QSize>("size");
  QTest::addColumn<double>("dpi");
  QTest::newRow("as usual") << QStringList{} << QSize(1890, 1063) << 300.0;
  QTest::newRow("millimetres") << QStringList{"--size-mm", "50.8x25.4", "--dpi", "150"}
                               << QSize(300, 150) << 150.0;
  QTest::newRow("pixels") << QStringList{"--size-px", "321x123", "--dpi", "96"} << QSize(321, 123)
                          << 96.0;
  QTest::newRow("few pixels") << QStringList{"--size-px", "16x16", "--dpi", "1200"} << QSize(16, 16)
                              << 1200.0;
}

void ExportPicturesTest::sizes() {
  QFETCH(QStringList, flags);
  QFETCH(QSize, size);
  QFETCH(double, dpi);
  const QString file = m_folder.filePath("sized.png");
  const Finished finished = runSline(QStringList{"export", m_sample, "--png", file} + flags);
  QVERIFY2(finished.code == 0, finished.err.constData());
  const QImage image(file);
  QCOMPARE(image.size(), size);
  QVERIFY(std::abs(image.dotsPerMeterX() * 0.0254 - dpi) < 0.1);
}

void ExportPicturesTest::severalKindsAtOnce() {
  QStringList flags{"export", m_sample, "--size-mm",    "40x30",      "--dpi",
                    "72",     "--grey", "--background", "transparent"};
  QStringList files;
  for (const char* kind : {"png", "tiff", "jpeg", "exr", "jp2", "svg"}) {
    files << m_folder.filePath(QString("Bäcken 盆.") + kind);
    flags << QString("--") + kind << files.back();
  }
  const Finished finished = runSline(flags);
  QVERIFY2(finished.code == 0, finished.err.constData());
  for (const QString& file : files)
    QVERIFY2(QFile(file).size() > 500, qPrintable(file));
  QVERIFY(QImage(files[0]).hasAlphaChannel());
}

void ExportPicturesTest::throughAPipe_data() {
  QTest::addColumn<QString>("kind");
  QTest::addColumn<bool>("can");
  QTest::newRow("png") << "png" << true;
  QTest::newRow("jpeg") << "jpeg" << true;
  QTest::newRow("svg") << "svg" << true;
  QTest::newRow("tiff") << "tiff" << false;
  QTest::newRow("exr") << "exr" << false;
  QTest::newRow("WebP") << "webp-picture" << true;
}

void ExportPicturesTest::throughAPipe() {
  QFETCH(QString, kind);
  QFETCH(bool, can);
  const auto exported = [&](const QString& target) {
    return runSline({"export", m_sample, "--" + kind, target, "--size-mm", "30x20", "--dpi", "96"});
  };
  const QString file = m_folder.filePath("whole." + kind.section('-', 0, 0));
  QCOMPARE(exported(file).code, 0);
  QFile whole(file);
  QVERIFY(whole.open(QIODevice::ReadOnly));
  const Finished piped = exported("/dev/stdout");
  QCOMPARE(piped.code, can ? 0 : 1);
  if (can)
    QCOMPARE(piped.out, whole.readAll());
  else
    QVERIFY2(piped.err.contains("through a pipe") && piped.err.contains("Name a file"),
             piped.err.constData());
}

/// A copy of the program alone draws PNG, and says what other kinds need.
void ExportPicturesTest::withoutTheModule() {
  const QString folder = m_folder.filePath("alone");
  QVERIFY(QDir().mkpath(folder));
  const auto exported = [&](const QString& kind, const QString& name) {
    return runSlineCopiedTo(
        folder, {"export", m_sample, "--" + kind, folder + '/' + name, "--size-px", "40x30"});
  };
  for (const char* kind : {"tiff", "jpeg", "exr", "jp2"}) {
    const Finished refused = exported(kind, "figure");
    QCOMPARE(refused.code, 1);
    QVERIFY2(
        refused.err.contains("libsline-pixels.so") && refused.err.contains("Install OpenImageIO"),
        refused.err.constData());
  }
  QCOMPARE(exported("png", "a.png").code, 0);
  QCOMPARE(QDir(folder).entryList(QDir::Files), QStringList({"a.png", "sline"}));
}

void ExportPicturesTest::blackAndWhiteIsPure() {
  const QString file = m_folder.filePath("ink.png");
  for (const char* bits : {"1", "8"}) {
    const Finished finished =
        runSline({"export", m_sample, "--png", file, "--size-mm", "60x40", "--bw", "--bits", bits});
    QVERIFY2(finished.code == 0, finished.err.constData());
    const QImage image = QImage(file).convertToFormat(QImage::Format_Grayscale8);
    int black = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const int value = image.constScanLine(y)[x];
        QVERIFY(value == 0 || value == 255);
        black += value == 0;
      }
    QVERIFY(black > 1000);
  }
}

void ExportPicturesTest::wrongUse_data() {
  QTest::addColumn<QStringList>("flags");
  QTest::addColumn<QByteArray>("says");
  QTest::newRow("odd depth") << QStringList{"--bits", "12"} << QByteArray("8, 16 or 1");
  QTest::newRow("grey bits") << QStringList{"--bits", "1"} << QByteArray("--bw");
  QTest::newRow("two sizes") << QStringList{"--size-px", "20x20", "--size-mm", "20x20"}
                             << QByteArray("--size-mm");
  QTest::newRow("too many pixels") << QStringList{"--size-px", "20001x20"} << QByteArray("20000");
  QTest::newRow("no dots") << QStringList{"--dpi", "0"} << QByteArray("--dpi");
  QTest::newRow("many samples") << QStringList{"--samples", "9"}
                                << QByteArray("auto, 1, 2, 3 or 4");
}

void ExportPicturesTest::wrongUse() {
  QFETCH(QStringList, flags);
  QFETCH(QByteArray, says);
  const QString file = m_folder.filePath("wrong.png");
  const Finished finished = runSline(QStringList{"export", m_sample, "--png", file} + flags);
  QCOMPARE(finished.code, 2);
  QVERIFY2(finished.err.contains(says), finished.err.constData());
  QVERIFY(!QFile::exists(file));
}

void ExportPicturesTest::badTargets() {
  const QStringList before = QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::Hidden);
  for (const char* kind : {"png", "tiff", "jpeg", "exr"}) {
    const Finished finished = runSline({"export", m_sample, QString("--") + kind,
                                        m_folder.filePath("nowhere/a"), "--size-px", "64x64"});
    QCOMPARE(finished.code, 1);
    QVERIFY(finished.err.contains("nowhere"));
  }
  // The drawing of a page finds that it has too many pixels.
  const Finished finished =
      runSline({"export", m_sample, "--png", m_folder.filePath("a.png"), "--size-mm", "2000x2000"});
  QCOMPARE(finished.code, 1);
  QVERIFY(finished.err.contains("20000"));
  QCOMPARE(QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::Hidden), before);
}

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::ExportPicturesTest)
#include "export_pictures_test.moc"
