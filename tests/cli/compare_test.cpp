// SPDX-License-Identifier: Apache-2.0
// Tests the comparison sheet and the thresholds of lines on the command line.
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include "tests/cli/sline_process.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

/// What a sheet's SVG holds.
struct Sheet {
  QStringList cells;   ///< ids of groups that begin with "cell-"
  QStringList titles;  ///< of these
  QStringList texts;   ///< of all texts; lines of one are joined by spaces
  QStringList layers;  ///< labels of groups without an id within the pictures
  int paths = 0;
};

Sheet readSheet(const QByteArray& svg) {
  QXmlStreamReader reader(svg);
  Sheet sheet;
  bool pictures = true;
  while (!reader.atEnd()) {
    if (reader.readNext() != QXmlStreamReader::StartElement)
      continue;
    const QString id = reader.attributes().value("id").toString();
    if (reader.name() == QString("path"))
      ++sheet.paths;
    else if (reader.name() == QString("title"))
      sheet.titles << reader.readElementText();
    else if (reader.name() == QString("text"))
      sheet.texts << reader.readElementText(QXmlStreamReader::IncludeChildElements);
    else if (id.startsWith("cell-"))
      sheet.cells << id;
    else if (id == "text")
      pictures = false;
    else if (pictures && id.isEmpty() && reader.name() == QString("g"))
      sheet.layers << reader.attributes()
                          .value("http://www.inkscape.org/namespaces/inkscape", "label")
                          .toString();
  }
  return reader.hasError() ? Sheet() : sheet;
}

}  // namespace

class CompareTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    writeObj(m_ring, *torus(40.0f, 15.0f, 60, 24));
    writeObj(m_ball, *sphere(30.0f, 3));
    writeFile(m_broken, "v 1 2\nf 1 2 3\n");
  }
  void sheetHasRowsAndColumns();
  void noiseAddsRows();
  void thresholdsAreWrittenAndCount();
  void pdfAndPicture();
  void wrongUse_data();
  void wrongUse();
  void thresholdsReachPictures();

 private:
  QByteArray compared(const QStringList& flags) {
    const QString file = m_folder.filePath("sheet.svg");
    QFile::remove(file);
    const Finished finished = runSline(QStringList{"compare"} + flags + QStringList{"-o", file});
    if (finished.code != 0)
      qWarning("%s", finished.err.constData());
    QFile source(file);
    return source.open(QIODevice::ReadOnly) ? source.readAll() : QByteArray();
  }

  QTemporaryDir m_folder;
  QString m_ring = m_folder.filePath("ring.obj");
  QString m_ball = m_folder.filePath("ball.obj");
  QString m_broken = m_folder.filePath("broken.obj");
};

void CompareTest::sheetHasRowsAndColumns() {
  const Sheet sheet = readSheet(compared({m_ring, m_ball, "--view", "superior"}));
  QCOMPARE(sheet.cells.size(), 18);
  QCOMPARE(sheet.cells.first(), QString("cell-1-1"));
  QCOMPARE(sheet.cells.last(), QString("cell-2-9"));
  QVERIFY(sheet.titles.contains("ball, ConFIS"));
  for (const char* text : {"Suggestive contours",
                           "DeCarlo et al. 2003",
                           "ConFIS",
                           "Lawonn et al. 2013",
                           "Apparent ridges",
                           "Judd et al. 2007",
                           "Ridges and valleys",
                           "Ohtake et al. 2004",
                           "Photic extremum lines",
                           "Xie et al. 2007",
                           "Laplacian lines",
                           "Zhang et al. 2011",
                           "Demarcating curves",
                           "Kolomenkin et al. 2008",
                           "Highlight lines",
                           "DeCarlo, Rusinkiewicz 2007",
                           "Streamline hatching",
                           "Zander et al. 2004",
                           "ring",
                           "ball"})
    QVERIFY2(sheet.texts.contains(text), text);
  // Each cell has its figures: thresholds, time and length per area.
  static const QRegularExpression figures("^[a-z_]+ [0-9.]+.*[0-9.]+ ms · [0-9.]+ mm⁻¹$");
  QCOMPARE(sheet.texts.filter(figures).size(), 18);
  // The ring's Laplacian line lies where theory has it; the ball has none but its contour.
  QVERIFY(sheet.layers.contains("Laplacian lines"));
  QCOMPARE(sheet.layers.filter("Contours").size(), 18);
  const Sheet ball = readSheet(compared({m_ball, "--techniques", "laplacian"}));
  QVERIFY(!ball.layers.contains("Laplacian lines"));
  QVERIFY(ball.texts.filter("0.000 mm⁻¹").size() == 1);
}

void CompareTest::noiseAddsRows() {
  const QStringList flags{m_ring, "--techniques", "laplacian,ridges", "--view", "superior"};
  const Sheet sheet =
      readSheet(compared(flags + QStringList{"--noise", "staircase=4", "--noise", "jitter"}));
  QCOMPARE(sheet.cells.size(), 6);
  QVERIFY(!sheet.texts.filter("staircase, 4").isEmpty());
  QVERIFY(!sheet.texts.filter("jitter, 0.1").isEmpty());
  // The same noise each time; none leaves the model as it is.
  static const QRegularExpression time("[0-9.]+ ms");
  const auto withoutTimes = [](const QByteArray& svg) {
    return QString::fromUtf8(svg).remove(time);
  };
  const QByteArray once = compared(flags + QStringList{"--noise", "jitter=0.2"});
  QCOMPARE(withoutTimes(compared(flags + QStringList{"--noise", "jitter=0.2"})),
           withoutTimes(once));
  const QStringList lengths =
      readSheet(once).texts.filter("mm⁻¹").replaceInStrings(QRegularExpression("^.* ms · "), "");
  QCOMPARE(lengths.size(), 5);  // four cells and the notes
  QVERIFY(lengths[0] != lengths[2]);
  const QStringList same = readSheet(compared(flags + QStringList{"--noise", "jitter=0"}))
                               .texts.filter("mm⁻¹")
                               .replaceInStrings(QRegularExpression("^.* ms · "), "");
  QCOMPARE(same[0], same[2]);
  QCOMPARE(same[1], same[3]);
}

void CompareTest::thresholdsAreWrittenAndCount() {
  const QStringList flags{m_ring, "--techniques", "laplacian", "--view", "superior"};
  const Sheet usual = readSheet(compared(flags));
  QCOMPARE(usual.texts.filter("slope 2").size(), 1);
  const Sheet strict =
      readSheet(compared(flags + QStringList{"--line-threshold", "laplacian=900"}));
  QCOMPARE(strict.texts.filter("slope 900").size(), 1);
  QVERIFY(usual.layers.contains("Laplacian lines"));
  QVERIFY(!strict.layers.contains("Laplacian lines"));
}

void CompareTest::pdfAndPicture() {
  const QString pdf = m_folder.filePath("sheet.pdf");
  const QStringList flags{"compare", m_ring, "--techniques", "sline,confis", "--cell-mm", "30"};
  const Finished written = runSline(flags + QStringList{"-o", pdf, "--json"});
  QCOMPARE(written.code, 0);
  const QJsonArray cells = QJsonDocument::fromJson(written.out)["rows"][0]["cells"].toArray();
  QCOMPARE(cells.size(), 2);
  const QJsonObject confis = cells[1].toObject();
  QCOMPARE(confis["technique"].toString(), QString("confis"));
  QCOMPARE(confis["thresholds"].toObject()["margin"].toDouble(), 0.15);
  QVERIFY(confis["frame_ms"].toDouble() > 0.0 && confis["lines_per_mm"].toDouble() > 0.0);
  QFile source(pdf);
  QVERIFY(source.open(QIODevice::ReadOnly));
  QVERIFY(source.read(5) == "%PDF-");
  const QString png = m_folder.filePath("sheet.png");
  QCOMPARE(runSline(flags + QStringList{"-o", png, "--dpi", "100"}).code, 0);
  const Pixels picture = readPicture(png);
  // Two columns of 30 mm beside the head, within margins.
  QCOMPARE(picture.width, int(std::lround((12.0 + 27.0 + 2.0 * 34.0 + 8.0) / 25.4 * 100.0)));
  QVERIFY(picture.height > 100);
  const auto dark = std::count_if(picture.rgba.begin(), picture.rgba.end(),
                                  [](unsigned char value) { return value < 100; });
  QVERIFY(dark > 200);
}

void CompareTest::wrongUse_data() {
  QTest::addColumn<QStringList>("flags");
  QTest::addColumn<int>("code");
  QTest::addColumn<QByteArray>("said");
  const auto row = [](const char* name, const QStringList& flags, int code, const char* said) {
    QTest::newRow(name) << flags << code << QByteArray(said);
  };
  const QString svg = m_folder.filePath("no.svg");
  row("a technique of pixels", {m_ring, "-o", svg, "--techniques", "noise_lic"}, 2, "pixels");
  row("unknown technique", {m_ring, "-o", svg, "--techniques", "sline,fur"}, 2, "apparent_ridges");
  row("unknown threshold", {m_ring, "-o", svg, "--line-threshold", "fur=1"}, 2, "laplacian.slope");
  row("bad threshold", {m_ring, "-o", svg, "--line-threshold", "laplacian=-1"}, 2, "0 to 1000");
  row("unknown noise", {m_ring, "-o", svg, "--noise", "hiss"}, 2, "staircase");
  row("bad noise", {m_ring, "-o", svg, "--noise", "jitter=x"}, 2, "0 to 20");
  row("unknown view", {m_ring, "-o", svg, "--view", "inside"}, 1, "anterior");
  row("unknown kind", {m_ring, "-o", m_folder.filePath("no.gif")}, 2, "pdf, svg, png or tiff");
  row("over its input", {m_ring, "-o", m_ring}, 2, "pdf, svg, png or tiff");
  row("small cells", {m_ring, "-o", svg, "--cell-mm", "1"}, 2, "--cell-mm");
  row("missing file", {m_folder.filePath("none.obj"), "-o", svg}, 1, "none.obj");
  row("broken mesh", {m_ring, m_broken, "-o", svg}, 1, "broken.obj");
  row("no input", {"-o", svg}, 2, "INPUT");
  row("no output", {m_ring}, 2, "--output");
}

void CompareTest::wrongUse() {
  QFETCH(QStringList, flags);
  QFETCH(int, code);
  QFETCH(QByteArray, said);
  const Finished finished = runSline(QStringList{"compare"} + flags);
  QVERIFY2(finished.err.contains(said), finished.err.constData());
  QCOMPARE(finished.code, code);
  QVERIFY(!QFile::exists(m_folder.filePath("no.svg")));
}

void CompareTest::thresholdsReachPictures() {
  const auto drawn = [&](const QStringList& flags) {
    const QString file = m_folder.filePath("ring.png");
    QFile::remove(file);
    const Finished finished =
        runSline(QStringList{"render", m_ring, "-o", file, "--size", "200x200", "--view",
                             "superior", "--look", "plain", "--technique", "laplacian"} +
                 flags);
    if (finished.code != 0)
      qWarning("%s", finished.err.constData());
    return readPicture(file).rgba;
  };
  const auto usual = drawn({});
  QVERIFY(!usual.empty());
  QVERIFY(drawn({"--line-threshold", "laplacian=2"}) == usual);
  QVERIFY(drawn({"--line-threshold", "ridges=900"}) == usual);
  const auto strict = drawn({"--line-threshold", "laplacian.slope=900"});
  QVERIFY(!strict.empty() && strict != usual);
}

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::CompareTest)
#include "compare_test.moc"
