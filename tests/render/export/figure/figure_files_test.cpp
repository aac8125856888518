// SPDX-License-Identifier: Apache-2.0
// Tests the files of figures: their pixels, ink alone, stopping, and whose work they say they show.
#include <QTemporaryDir>
#include <QtTest>

#include "render/export/figure/figure_checks.h"
#include "render/export/pixels/pixel_options.h"
#include "render/export/pixels/read_picture.h"
#include "render/lettering/label_texts.h"
#include "tests/render/export/figure/sample_figure.h"
#include "tests/support/suite.h"

namespace sline::test {

class FigureFilesTest : public QObject {
  Q_OBJECT

 private slots:
  /// PNG and TIFF show what the preview shows, without a seam between the bands that they are drawn
  /// in.
  void pixelsAreThePage_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("png") << "page.png";
    QTest::newRow("tiff") << "page.tiff";
    QTest::newRow("tif") << "page.tif";
  }
  void pixelsAreThePage() {
    QFETCH(QString, name);
    const ComposedFigure composed = drawn(fourPanels());
    QTemporaryDir folder;
    const std::filesystem::path target = folder.filePath(name).toStdString();
    ExportOrder options = usualFigureOrder();
    options.page.dpi = 400.0f;
    const Status written = writeFigure(composed, options, target, {});
    if (!written.ok())
      SLINE_ABSENT(written.error().text().c_str());
    const Result<PixelRows> read = readPicture(target);
    QVERIFY(read.ok());
    const QImage page = pagePicture(pageOf(composed), read->width);
    QCOMPARE(read->height, page.height());
    QVERIFY(read->height * read->width > 4'500'000);  // several bands
    int other = 0;
    for (int y = 0; y < page.height(); ++y)
      for (int x = 0; x < page.width(); ++x) {
        const QRgb pixel = page.pixel(x, y);
        const std::size_t at = (std::size_t(y) * std::size_t(read->width) + std::size_t(x)) * 4;
        other += std::abs(int(read->rgba[at]) / 257 - qRed(pixel)) > 2;
      }
    QVERIFY2(other < 200, qPrintable(QString::number(other)));
  }

  /// What is black and white has no grey, in bytes or in single bits.
  void inkAlone_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("bits");
    for (const char* name : {"ink.png", "ink.tiff"})
      for (const int bits : {8, 1})
        QTest::addRow("%s, %d bits", name, bits) << QString::fromLatin1(name) << bits;
  }
  void inkAlone() {
    QFETCH(QString, name);
    QFETCH(int, bits);
    model::Figure figure = fourPanels();
    ExportOrder options = usualFigureOrder();
    options.page.dpi = 150.0f;
    options.of<PixelOptions>().bits = bits;
    QTemporaryDir folder;
    const std::filesystem::path target = folder.filePath(name).toStdString();
    if (bits == 1)
      QVERIFY(!writeFigure(drawn(figure), options, target, {}).ok());
    QVERIFY(!std::filesystem::exists(target));
    figure.blackAndWhite = true;
    const Status written = writeFigure(drawn(figure), options, target, {});
    if (!written.ok())
      SLINE_ABSENT(written.error().text().c_str());
    const Result<PixelRows> read = readPicture(target);
    QVERIFY(read.ok());
    std::size_t black = 0;
    for (std::size_t i = 0; i < read->rgba.size(); i += 4) {
      QVERIFY(read->rgba[i] == 0 || read->rgba[i] == 65535);
      black += read->rgba[i] == 0;
    }
    QVERIFY(black > 1000 && black < read->rgba.size() / 40);
    const auto bytes = std::filesystem::file_size(target);
    QVERIFY2(bits == 8 || bytes < read->rgba.size() / 4 / 8 + 20'000,
             qPrintable(QString::number(bytes)));
  }

  /// Who stops writing has the file that was there before, or none, and nothing beside it.
  void stoppedWritingLeavesNothing_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"f.png", "f.tiff", "f.svg", "f.pdf"})
      QTest::newRow(name) << name;
  }
  void stoppedWritingLeavesNothing() {
    QFETCH(QString, name);
    const ComposedFigure composed = drawn(fourPanels());
    QTemporaryDir folder;
    const std::filesystem::path target = folder.filePath(name).toStdString();
    const ExportProgress stop([](double share, std::string_view) { return share < 0.4; });
    QVERIFY(!writeFigure(composed, usualFigureOrder(), target, stop).ok());
    QVERIFY(std::filesystem::is_empty(target.parent_path()));
    QFile(folder.filePath(name)).open(QIODevice::WriteOnly);
    QVERIFY(!writeFigure(composed, usualFigureOrder(), target, stop).ok());
    QCOMPARE(std::filesystem::file_size(target), std::uintmax_t(0));
    QCOMPARE(std::distance(std::filesystem::directory_iterator(target.parent_path()), {}), 1);
  }

  /// Whose work the surfaces are stands whole at the foot, however long it is.
  void creditsAreWhole() {
    model::Scene scene = rowOfBalls(5);
    std::vector<model::Node> nodes = scene.nodes();
    for (std::size_t i = 0; i < nodes.size(); ++i)
      nodes[i].provenance.credit.source = "A source number " + std::to_string(i) +
                                          " with a long name, of people and institutes " +
                                          std::string(200, 'x') + ", CC BY 4.0";
    scene.setNodes(nodes);
    const FigureScenes own{{"row.sline", std::make_shared<const model::Scene>(scene)}};
    ExportOrder options = usualFigureOrder();
    QVERIFY(planFigure(fourPanels(), own, options)->credits.drawnAt({}, 174.0f).empty());
    options.sources = SourceCredits::line;
    const Result<FigurePlan> plan = planFigure(fourPanels(), own, options);
    QVERIFY(plan.ok());
    const Result<ComposedFigure> composed = composeFigure(*plan, {});
    QVERIFY(printFaults(*composed).empty());
    QString said;
    float foot = 0.0f;
    for (const LetteringItem& item : composed->writing.items)
      if (item.name == "sources") {
        for (const TextLine& line : item.text->lines) {
          said += plainText(line) + QChar(u' ');
          QVERIFY(textWidthMm(line, item.text->points) <= 174.0f);
        }
        foot = item.text->at.y + float(item.text->lines.size() - 1) * item.text->leading;
      }
    for (int i = 0; i < 5; ++i)
      QVERIFY(said.contains(QStringLiteral("A source number %1").arg(i)));
    QCOMPARE(said.count(QChar(u'x')), 5 * 200);
    QVERIFY(foot > 0.0f && foot <= plan->layout.sizeMm.y);
    QVERIFY(creditOf(*composed, options).copyright.size() > 5 * 200);
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_GUI(sline::test::FigureFilesTest)
#include "figure_files_test.moc"
