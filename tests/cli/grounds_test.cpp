// SPDX-License-Identifier: Apache-2.0
// Tests what `sline export` writes over pictures: whose work the surfaces are where nothing else is
// written, halos of the ground's own colour, and the same labels in black ink as in colours.
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/sline_process.h"
#include "tests/support/suite.h"

namespace sline::test {

class GroundsTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

  QString path(const QString& name) const { return m_folder.filePath(name); }
  QByteArray exported(const QString& kind, const QStringList& flags) {
    const QString file = path("picture." + kind);
    QFile::remove(file);
    const Finished finished = runSline(QStringList{"export", path("scene.sline"), "--" + kind, file,
                                                   "--size-mm", "100x80", "--dpi", "100"} +
                                       flags);
    if (finished.code != 0)
      qWarning("%s", finished.err.constData());
    QFile written(file);
    return written.open(QIODevice::ReadOnly) ? written.readAll() : QByteArray();
  }

 private slots:
  void initTestCase() {
    const QString scene = path("scene.sline");
    QCOMPARE(runSline({"import", writeSample(m_folder.path()), "-o", scene}).code, 0);
    QCOMPARE(runSline({"annotate", scene, "--on", "kidney"}).code, 0);
    QCOMPARE(
        runSline({"credit", scene, "--source", "Atlas of Samples", "--licence", "CC BY 4.0"}).code,
        0);
  }

  /// A picture with neither labels nor marks still says whose work it shows, and has its legend.
  void bareButCredited_data() {
    QTest::addColumn<QStringList>("flags");
    QTest::newRow("credits") << QStringList{"--credits", "line"};
    QTest::newRow("legend") << QStringList{"--legend", "all"};
  }
  void bareButCredited() {
    QFETCH(QStringList, flags);
    const QStringList bare{"--labels", "off", "--marks", "off"};
    QVERIFY(!exported("png", bare).isEmpty());
    const QImage without(path("picture.png"));
    QVERIFY(!exported("png", bare + flags).isEmpty());
    const QImage with(path("picture.png"));
    // In the lower right quarter of the credits' line, or where the legend stands.
    const QRect foot(0, with.height() * 6 / 10, with.width(), with.height() * 4 / 10);
    QVERIFY(with.copy(foot) != without.copy(foot));
    int dark = 0;
    for (int y = foot.top(); y < with.height(); ++y)
      for (int x = 0; x < with.width(); ++x)
        dark += qGray(with.pixel(x, y)) < 100 && qGray(without.pixel(x, y)) > 200;
    QVERIFY2(dark > 40, qPrintable(QString::number(dark)));
  }

  void halosOfTheGround_data() {
    QTest::addColumn<QString>("ground");
    QTest::addColumn<QString>("colour");
    QTest::newRow("white") << "white"
                           << "#ffffff";
    QTest::newRow("paper") << "paper"
                           << "#faf6ec";
    QTest::newRow("dark") << "dark"
                          << "#1c1e22";
    QTest::newRow("transparent") << "transparent" << QString();
  }
  void halosOfTheGround() {
    QFETCH(QString, ground);
    QFETCH(QString, colour);
    const QString svg =
        QString::fromUtf8(exported("svg", {"--labels", "on", "--background", ground}));
    QVERIFY(!svg.isEmpty());
    static const QRegularExpression halos("label=\"Halos\"[^>]*stroke=\"(#[0-9a-f]{6})\"");
    int found = 0;
    for (const QRegularExpressionMatch& each : halos.globalMatch(svg)) {
      ++found;
      QCOMPARE(each.captured(1), colour);
    }
    QCOMPARE(found > 0, !colour.isEmpty());
    QCOMPARE(svg.contains("url(#gaps)"), colour.isEmpty());
    if (!colour.isEmpty())
      QVERIFY(svg.contains("<rect id=\"background\"") && svg.contains("fill=\"" + colour + "\""));
  }

  /// Over no ground nothing of a picture is white but what is drawn so: halos are gaps.
  void gapsWithoutGround() {
    QVERIFY(!exported("png", {"--labels", "on", "--background", "transparent", "--gamma", "1",
                              "--fill", "none"})
                 .isEmpty());
    const QImage picture(path("picture.png"));
    QVERIFY(picture.hasAlphaChannel());
    int white = 0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x)
        white += qAlpha(picture.pixel(x, y)) > 200 && qGray(picture.pixel(x, y)) > 200;
    QVERIFY2(white < 20, qPrintable(QString::number(white)));
  }

  /// And so they are in a PDF: none of its halos is white, and lines end where they end on white.
  void gapsInPdf() {
    if (QStandardPaths::findExecutable("pdftocairo").isEmpty())
      SLINE_ABSENT("poppler-utils are not installed");
    const auto drawn = [&](const QString& ground) {
      const QByteArray pdf = exported(
          "pdf", {"--labels", "on", "--background", ground, "--gamma", "1", "--fill", "none"});
      QProcess reader;
      reader.start("pdftocairo", {"-png", "-transp", "-r", "150", "-singlefile",
                                  path("picture.pdf"), path("page")});
      return !pdf.isEmpty() && reader.waitForFinished() && reader.exitCode() == 0
                 ? QImage(path("page.png"))
                 : QImage();
    };
    const QImage clear = drawn("transparent");
    const QImage white = drawn("white");
    QVERIFY(!clear.isNull() && clear.size() == white.size());
    int pale = 0;
    int dark = 0;
    int other = 0;
    for (int y = 0; y < clear.height(); ++y)
      for (int x = 0; x < clear.width(); ++x) {
        const QRgb pixel = clear.pixel(x, y);
        const bool ink = qAlpha(pixel) > 200 && qGray(pixel) < 100;
        pale += qAlpha(pixel) > 200 && qGray(pixel) > 200;
        dark += ink;
        other += ink && qGray(white.pixel(x, y)) > 200;
      }
    QVERIFY2(pale < 20, qPrintable(QString::number(pale)));
    QVERIFY2(dark > 1000 && other < 20, qPrintable(QString("%1 %2").arg(dark).arg(other)));
  }

  /// Labels stand in black ink where they stand in colours.
  void sameLabelsInInk() {
    const auto places = [](const QByteArray& svg) {
      const QByteArray labels = svg.mid(svg.indexOf("<g id=\"labels\""));
      return labels.left(labels.indexOf("</svg>"));
    };
    const QStringList shaded{"--labels", "on", "--gamma", "5", "--view", "left"};
    const QByteArray colour = places(exported("svg", shaded));
    QVERIFY(colour.contains("kidney"));
    QCOMPARE(places(exported("svg", shaded + QStringList{"--bw"})), colour);
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::GroundsTest)
#include "grounds_test.moc"
