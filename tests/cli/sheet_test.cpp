// SPDX-License-Identifier: Apache-2.0
// Tests PDF figures and sheets as other programs read them: what text they hold, in which fonts, on
// what paper, and that they say nothing of who made them.
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "tests/cli/sline_process.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

class SheetTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void paper_data();
  void paper();
  void figureAlone();
  void teachingSheet();
  void whatTheViewSays();
  void ownLabels();
  void legendListsWhatIsVisible();
  void legendExplainsHiddenOutlines();
  void longLegends();
  void patientSheet();
  void textsAndFiles_data();
  void textsAndFiles();
  void picturesBesideASheet();
  void namesAreText();
  void languages();
  void saysNothingElse();

 private:
  QString exported(const QStringList& inputAndFlags);
  QString textOf(const QString& file, int page);
  int pages(const QString& file);
  QString run(const QString& program, const QStringList& arguments);

  QTemporaryDir m_folder;
  QString m_sample = writeSample(m_folder.path());
};

void SheetTest::initTestCase() {
  for (const char* program : {"pdftotext", "pdffonts", "pdfinfo"})
    if (QStandardPaths::findExecutable(program).isEmpty())
      SLINE_ABSENT("poppler-utils are not installed");
}

QString SheetTest::exported(const QStringList& inputAndFlags) {
  const QString file = m_folder.filePath("sheet.pdf");
  QFile::remove(file);
  const Finished finished = runSline(QStringList{"export", "--pdf", file} + inputAndFlags);
  if (finished.code != 0)
    qWarning("%s", finished.err.constData());
  return finished.code == 0 ? file : QString();
}

QString SheetTest::run(const QString& program, const QStringList& arguments) {
  QProcess process;
  process.start(program, arguments);
  if (!process.waitForFinished() || process.exitCode() != 0)
    return {};
  return QString::fromUtf8(process.readAllStandardOutput());
}

/// Returns the text of that page, with single spaces.
QString SheetTest::textOf(const QString& file, int page) {
  const QString number = QString::number(page);
  return run("pdftotext", {"-f", number, "-l", number, file, "-"}).simplified();
}

int SheetTest::pages(const QString& file) {
  static const QRegularExpression count("Pages: *([0-9]+)");
  return count.match(run("pdfinfo", {file})).captured(1).toInt();
}

void SheetTest::paper_data() {
  QTest::addColumn<QStringList>("flags");
  QTest::addColumn<QSizeF>("points");
  const auto row = [](const char* name, const QStringList& flags, double width, double height) {
    QTest::newRow(name) << flags << QSizeF(width, height) * 72.0 / 25.4;
  };
  row("a4", {"--sheet", "figure"}, 210, 297);
  row("letter", {"--sheet", "teaching", "--paper", "letter"}, 215.9, 279.4);
  row("a4 on its side", {"--sheet", "patient", "--landscape"}, 297, 210);
  row("a figure alone", {"--size-mm", "160.5x90.25"}, 160.5, 90.25);
  row("a poster", {"--size-mm", "841x1189"}, 841, 1189);
}

void SheetTest::paper() {
  QFETCH(QStringList, flags);
  QFETCH(QSizeF, points);
  const QString file = exported(QStringList{m_sample} + flags);
  QVERIFY(!file.isEmpty());
  static const QRegularExpression box("MediaBox: *([0-9.-]+) +([0-9.-]+) +([0-9.-]+) +([0-9.-]+)");
  const auto found = box.match(run("pdfinfo", {"-box", file}));
  QCOMPARE(found.captured(1).toDouble(), 0.0);
  QCOMPARE(found.captured(2).toDouble(), 0.0);
  QVERIFY(std::abs(found.captured(3).toDouble() - points.width()) < 0.02);
  QVERIFY(std::abs(found.captured(4).toDouble() - points.height()) < 0.02);
}

void SheetTest::figureAlone() {
  const QString file = exported({m_sample});
  QCOMPARE(pages(file), 1);
  const QString text = textOf(file, 1);
  for (const char* mark : {"Anterior view", "at mid-depth", "R", "L", "S", "I"})
    QVERIFY2(text.contains(mark), qPrintable(text));
  QVERIFY(!text.contains("kidney"));
  QCOMPARE(textOf(exported({m_sample, "--marks", "off"}), 1), QString());
}

/// The sample has no labels, so its structures get some.
void SheetTest::teachingSheet() {
  const QString file = exported({m_sample, "--sheet", "teaching", "--title", "The left kidney"});
  QCOMPARE(pages(file), 3);
  const QStringList names{"kidney", "renal artery", "renal vein"};
  const QString first = textOf(file, 1);
  const QString test = textOf(file, 2);
  const QString key = textOf(file, 3);
  for (const QString& page : {first, test, key})
    QVERIFY2(page.contains("The left kidney") && page.contains("Anterior view"), qPrintable(page));
  for (const QString& name : names) {
    QVERIFY(first.contains(name));
    QVERIFY(key.contains(name));
    QVERIFY(!QString(test).remove("The left kidney").contains(name));
  }
  QVERIFY(first.contains("Legend"));
  QVERIFY(test.contains("Self-test") && test.contains("Name") && test.contains("Date"));
  QVERIFY(key.contains("Key"));
  for (const char* number : {"1", "2", "3"})
    QVERIFY(test.contains(number));
  // The columns are name, type, encoding, embedded, a subset, with what its letters mean.
  static const QRegularExpression font("^\\S+ .+ (yes|no) +(yes|no) +(yes|no) +[0-9]+ +0$");
  const QStringList fonts = run("pdffonts", {file}).split('\n', Qt::SkipEmptyParts).mid(2);
  QVERIFY(!fonts.isEmpty());
  for (const QString& line : fonts) {
    const auto found = font.match(line.trimmed());
    QVERIFY2(found.captured(1) == "yes" && found.captured(3) == "yes", qPrintable(line));
  }
}

/// What the view says stands below the figure, not on the test's page, where it might tell answers.
void SheetTest::whatTheViewSays() {
  const QString scene = m_folder.filePath("says.sline");
  QCOMPARE(runSline({"import", m_sample, "-o", scene}).code, 0);
  QCOMPARE(runSline({"view", scene, "--add", "Front", "--title", "The <b>kidney</b>", "--title",
                     "de=Die Niere", "--text", "Seen *from the front*", "--notes", "secret"})
               .code,
           0);
  const QStringList flags{scene, "--view", "Front", "--sheet", "teaching"};
  const QString file = exported(flags);
  QCOMPARE(pages(file), 3);
  QVERIFY2(textOf(file, 1).contains("The <b>kidney</b> Seen from the front"),
           qPrintable(textOf(file, 1)));
  QVERIFY(!textOf(file, 2).contains("Seen") && !textOf(file, 3).contains("Seen"));
  for (int page = 1; page <= 3; ++page)
    QVERIFY(!textOf(file, page).contains("secret"));
  QVERIFY(textOf(exported(flags + QStringList{"--language", "de"}), 1).contains("Die Niere"));
  QVERIFY(!textOf(exported(flags + QStringList{"--marks", "view"}), 1).contains("Seen"));
  // A figure alone has it at its foot.
  QVERIFY(textOf(exported({scene, "--view", "Front"}), 1).contains("Seen from the front"));
}

/// A scene's own labels are shown in the mode that was asked for; their numbers are the same on all
/// pages.
void SheetTest::ownLabels() {
  const QString scene = m_folder.filePath("own.sline");
  QCOMPARE(runSline({"import", m_sample, "-o", scene}).code, 0);
  QCOMPARE(runSline({"annotate", scene, "--label", "Cortex", "--on", "kidney"}).code, 0);
  QCOMPARE(runSline({"annotate", scene, "--label", "Hilum", "--on", "renal vein"}).code, 0);
  QString file = exported({scene, "--sheet", "teaching"});
  for (const char* word : {"Labels", "1 Hilum", "2 Cortex", "Legend", "kidney"})
    QVERIFY2(textOf(file, 1).contains(word), word);
  QCOMPARE(pages(file), 3);
  QVERIFY(!textOf(file, 2).contains("Cortex"));
  QVERIFY(textOf(file, 3).contains("1 Hilum") && textOf(file, 3).contains("2 Cortex"));
  // What a test leaves out takes its number with it.
  file = exported({scene, "--sheet", "teaching", "--ask-only", "kidney", "--marks", "off"});
  QVERIFY(textOf(file, 1).contains("1 Hilum") && textOf(file, 1).contains("2 Cortex"));
  static const QRegularExpression one("\\b1\\b");
  QVERIFY2(textOf(file, 2).contains("2") && !textOf(file, 2).contains(one),
           qPrintable(textOf(file, 2)));
  QVERIFY2(textOf(file, 3).contains("2 Cortex") && !textOf(file, 3).contains("Hilum"),
           qPrintable(textOf(file, 3)));
  file = exported({scene, "--sheet", "teaching", "--labels", "on"});
  QVERIFY(!textOf(file, 1).contains("Labels"));
  QVERIFY(textOf(file, 1).contains("Cortex"));
  QVERIFY(!textOf(file, 2).contains("Cortex"));
  file = exported({scene, "--sheet", "figure"});
  QCOMPARE(pages(file), 1);
  QVERIFY(!textOf(file, 1).contains("Cortex"));
}

void SheetTest::legendListsWhatIsVisible() {
  const QString file = exported({m_sample, "--sheet", "figure", "--only", "Vessels"});
  const QString text = textOf(file, 1);
  QVERIFY(text.contains("renal artery"));
  QVERIFY(text.contains("renal vein"));
  QVERIFY(!text.contains("kidney"));
  QCOMPARE(text.count("renal"), 2);
  QVERIFY(!text.contains("Hidden outline"));
  // Or what was asked for.
  const QStringList sheet{m_sample, "--sheet", "figure"};
  const QString focus =
      textOf(exported(sheet + QStringList{"--legend", "focus", "--focus", "kidney"}), 1);
  QVERIFY(focus.contains("kidney") && !focus.contains("renal"));
  QVERIFY(!textOf(exported(sheet + QStringList{"--legend", "none"}), 1).contains("Legend"));
  // On a sheet for teaching each number finds its name, whatever the legend leaves out.
  const QString numbers = textOf(
      exported({m_sample, "--sheet", "teaching", "--legend", "focus", "--focus", "kidney"}), 1);
  QVERIFY2(numbers.contains("Labels") && numbers.contains("renal vein"), qPrintable(numbers));
  const QString labelled =
      textOf(exported({m_sample, "--sheet", "teaching", "--legend", "labelled"}), 1);
  QVERIFY2(labelled.contains("Legend") && labelled.contains("renal vein"), qPrintable(labelled));
}

// A reader learns what dashes and thin lines mean, each once; not where no visible structure has
// them.
void SheetTest::legendExplainsHiddenOutlines() {
  const QStringList sheet{m_sample, "--sheet", "figure"};
  const QString dashed = textOf(exported(sheet + QStringList{"--hidden-lines", "dashed"}), 1);
  QCOMPARE(dashed.count("Hidden outline"), 1);
  const QString both =
      textOf(exported(sheet + QStringList{"--hidden-lines", "dashed", "--hidden-lines",
                                          "renal artery=thin", "--language", "de"}),
             1);
  QCOMPARE(both.count("Verdeckter Umriss"), 2);
  const QString hidden = textOf(
      exported(sheet + QStringList{"--only", "renal vein", "--hidden-lines", "renal artery=thin"}),
      1);
  QVERIFY(hidden.contains("renal vein") && !hidden.contains("Hidden outline"));
}

/// A hundred structures with long names take columns and further pages, and none gets lost.
void SheetTest::longLegends() {
  const QString folder = m_folder.filePath("many");
  QVERIFY(QDir().mkpath(folder));
  for (int i = 0; i < 100; ++i)
    writeObj(
        folder + QString("/branch of a vessel with a long wall %1.obj").arg(i, 2, 10, QChar('0')),
        *moved(*sphere(4.0f, 1), 1.0f, {float(i % 10) * 10.0f, 0.0f, float(i / 10) * 10.0f}));
  for (const QStringList& flags : {QStringList{}, QStringList{"--landscape"}}) {
    const QString file = exported(QStringList{folder, "--sheet", "figure"} + flags);
    QVERIFY(pages(file) >= 2);
    QString all;
    for (int page = 1; page <= pages(file); ++page)
      all += textOf(file, page) + ' ';
    QVERIFY(all.contains("continued"));
    QCOMPARE(all.count("with a long"), 100);
    for (int i = 0; i < 100; ++i)
      QVERIFY(all.contains(QString("wall %1").arg(i, 2, 10, QChar('0'))));
  }
}

void SheetTest::patientSheet() {
  QString text = "Before the operation\n\nPlease <b>bring</b> this sheet & the others.\n";
  for (int i = 0; i < 60; ++i)
    text +=
        QString("Sentence %1 tells what will be done and why, so that it fills its line.\n").arg(i);
  const QString source = m_folder.filePath("text.txt");
  writeFile(source, text.toUtf8());
  QString file =
      exported({m_sample, "--sheet", "patient", "--title", "Your kidney", "--text", source});
  QVERIFY(pages(file) >= 2);
  QVERIFY(run("pdfinfo", {file}).contains(QRegularExpression("Title: +Your kidney\\n")));
  QString all;
  for (int page = 1; page <= pages(file); ++page)
    all += textOf(file, page) + ' ';
  QVERIFY(all.contains("Please <b>bring</b> this sheet & the others."));
  int from = 0;
  for (int i = 0; i < 60; ++i) {
    const int at = int(all.indexOf(QString("Sentence %1 tells").arg(i), from));
    QVERIFY2(at > from, qPrintable(QString::number(i)));
    from = at;
  }
  QVERIFY(!all.contains("Self-test"));
  QVERIFY(all.contains("renal artery"));
  file = exported({m_sample, "--sheet", "patient", "--text", "Short and on the command line"});
  QCOMPARE(pages(file), 1);
  QVERIFY(textOf(file, 1).contains("Short and on the command line"));
  // The figure takes the room that a short text leaves, so that the text stands at the page's foot.
  static const QRegularExpression word("yMin=\"([0-9.]+)\"[^>]*>Short<");
  const QRegularExpressionMatch found = word.match(run("pdftotext", {"-bbox", file, "-"}));
  QVERIFY(found.hasMatch());
  QVERIFY2(found.captured(1).toDouble() > 0.88 * 842.0, qPrintable(found.captured(1)));
}

void SheetTest::textsAndFiles_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<bool>("fine");
  QTest::newRow("a text") << "Take 1/2 tablet, see page 3.b below" << true;
  QTest::newRow("a word") << "Fasting" << true;
  QTest::newRow("a sentence of one word") << "Fasting." << true;
  QTest::newRow("a page's address") << "https://example.org/kidney.html" << true;
  QTest::newRow("lines") << "leaflet.txt\nis attached" << true;
  QTest::newRow("a file that is not there") << "leaflets/nothere.txt" << false;
  QTest::newRow("without a folder") << "nothere.txt" << false;
  QTest::newRow("without an ending") << "leaflets/nothere" << false;
  QTest::newRow("a folder") << m_sample << false;
}

void SheetTest::textsAndFiles() {
  QFETCH(QString, text);
  QFETCH(bool, fine);
  const QString file = m_folder.filePath("texts.pdf");
  QFile::remove(file);
  const Finished finished =
      runSline({"export", m_sample, "--pdf", file, "--sheet", "patient", "--text", text});
  QCOMPARE(finished.code, fine ? 0 : 2);
  QCOMPARE(QFile::exists(file), fine);
  if (!fine)
    QVERIFY2(finished.err.contains(text.toUtf8()), finished.err.constData());
}

void SheetTest::picturesBesideASheet() {
  const QString png = m_folder.filePath("beside.png");
  const QStringList flags{"export",  m_sample, "--pdf", m_folder.filePath("beside.pdf"),
                          "--sheet", "figure", "--png", png};
  const Finished sized = runSline(flags + QStringList{"--size-px", "100x100"});
  QCOMPARE(sized.code, 2);
  QVERIFY2(sized.err.contains("--size-px"), sized.err.constData());
  QVERIFY(!QFile::exists(png));
  const Finished both = runSline(flags + QStringList{"--dpi", "25.4"});
  QCOMPARE(both.code, 0);
  const Pixels picture = readPicture(png);
  const QByteArray size =
      QByteArray::number(picture.width) + " by " + QByteArray::number(picture.height) + " mm";
  QVERIFY2(both.err.contains("beside.png is of the sheet's figure: " + size), both.err.constData());
}

/// Markup, quotes and brackets of PDF are letters like others; a letter that no font has breaks
/// nothing.
void SheetTest::namesAreText() {
  const QString title = "<i>Nephros</i> (νεφρός) \\ & \"office\" %s";
  const QString file = exported({m_sample, "--sheet", "figure", "--title", title});
  QVERIFY2(textOf(file, 1).contains(title), qPrintable(textOf(file, 1)));
  for (const char* other : {"كلية يسرى", "左腎", "\u0001\u0007", "𝒦 \xF0\x9F\xAB\x80"})
    QVERIFY(!exported({m_sample, "--sheet", "teaching", "--title", QString::fromUtf8(other)})
                 .isEmpty());
  const QString endless = QString("kidney ").repeated(300);
  QVERIFY(textOf(exported({m_sample, "--sheet", "figure", "--title", endless}), 1).contains("…"));
}

void SheetTest::languages() {
  const QString file = exported({m_sample, "--sheet", "teaching", "--language", "de"});
  QVERIFY(textOf(file, 1).contains("Legende"));
  QVERIFY(textOf(file, 1).contains("Ansicht von vorn"));
  QVERIFY(textOf(file, 2).contains("Selbsttest"));
  QVERIFY(textOf(file, 3).contains("Lösung"));
  QVERIFY(textOf(file, 3).contains("Niere"));
}

void SheetTest::saysNothingElse() {
  QTemporaryDir planted(QDir::tempPath() + "/planted-marker-XXXXXX");
  const QString source = planted.filePath("Patient-Qz47Xw.obj");
  writeObj(source, *sphere(10.0f, 3), "heart");
  QByteArray before;
  for (const char* kind : {"figure", "teaching", "patient"}) {
    const QString file = exported({source, "--sheet", kind});
    QFile pdf(file);
    QVERIFY(pdf.open(QIODevice::ReadOnly));
    const QByteArray bytes = pdf.readAll();
    for (const char* marker : {"planted-marker", "Qz47Xw", ".obj", "Qt 6", "CreationDate",
                               "ModDate", "Producer", "Creator", "/Info", "/Metadata", "D:20"})
      QVERIFY2(
          !bytes.contains(marker),
          bytes.mid(std::max<qsizetype>(0, bytes.indexOf(marker) - 40), 80).toPercentEncoding());
    for (const char* variable : {"USER", "HOME", "HOSTNAME", "LOGNAME"})
      if (const QByteArray value = qgetenv(variable); value.size() > 3)
        QVERIFY2(!bytes.contains(value), variable);
    static const QRegularExpression told("^(Title|Creator|Producer|CreationDate|ModDate|Author):",
                                         QRegularExpression::MultilineOption);
    QVERIFY(!run("pdfinfo", {file}).contains(told));
    // The file is the same each time.
    const QString again = exported({source, "--sheet", kind});
    QFile second(again);
    QVERIFY(second.open(QIODevice::ReadOnly));
    QCOMPARE(second.readAll(), bytes);
  }
}

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::SheetTest)
#include "sheet_test.moc"
