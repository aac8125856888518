// SPDX-License-Identifier: Apache-2.0
// Tests our drawings in Inkscape, opened without a display: nothing is lost, renamed or drawn
// otherwise.
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>
#include <cmath>
#include <map>

#include "tests/cli/ink_agreement.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

constexpr int patience = 120'000;  // milliseconds
constexpr double pixelsPerMm = 96.0 / 25.4;
constexpr double pageWidth = 240.0;
constexpr double pageHeight = 135.0;
constexpr const char* spaceOfInkscape = "http://www.inkscape.org/namespaces/inkscape";

/// Holds what a user meets in a drawing.
struct Outline {
  QString width;
  QString height;
  QString viewBox;
  QString title;                      ///< that of the document
  std::map<QString, QString> titles;  ///< titles of groups, by their ids
  std::map<QString, QString> labels;  ///< labels as Inkscape shows them, by ids too
  QStringList layers;                 ///< ids, in order
  QStringList texts;
  bool wellFormed = false;
};

Outline outlineOf(const QString& file) {
  Outline outline;
  QFile source(file);
  if (!source.open(QIODevice::ReadOnly))
    return outline;
  QXmlStreamReader reader(&source);
  QStringList open;  // ids of elements that are open
  while (!reader.atEnd()) {
    reader.readNext();
    if (reader.isEndElement())
      open.removeLast();
    if (!reader.isStartElement())
      continue;
    const QXmlStreamAttributes attributes = reader.attributes();
    const QString id = attributes.value("id").toString();
    const QString label = attributes.value(spaceOfInkscape, "label").toString();
    if (reader.name() == QLatin1String("svg") && open.isEmpty()) {
      outline.width = attributes.value("width").toString();
      outline.height = attributes.value("height").toString();
      outline.viewBox = attributes.value("viewBox").toString();
    }
    if (reader.name() == QLatin1String("g") && !label.isEmpty())
      outline.labels[id] = label;
    if (attributes.value(spaceOfInkscape, "groupmode") == QLatin1String("layer"))
      outline.layers << id;
    if (reader.name() == QLatin1String("title")) {
      const QString title = reader.readElementText();
      (open.size() == 1 ? outline.title : outline.titles[open.value(open.size() - 1)]) = title;
      continue;
    }
    if (reader.name() == QLatin1String("text")) {
      outline.texts << reader.readElementText(QXmlStreamReader::IncludeChildElements).simplified();
      continue;
    }
    open << id;
  }
  outline.wellFormed = !reader.hasError();
  return outline;
}

/// Returns the names without those that a program makes up for unnamed elements.
std::map<QString, QString> named(const std::map<QString, QString>& all) {
  std::map<QString, QString> own;
  for (const auto& [id, name] : all)
    if (id.contains(QLatin1Char('-')))
      own[id] = name;
  return own;
}

}  // namespace

class InkscapeTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void savedAgainItIsTheSame_data();
  void savedAgainItIsTheSame();
  void openedAgainItIsTheSame();
  void listsOurGroups();
  void drawsWhatOthersDraw();

 private:
  /// Returns standard output; fails if Inkscape complains of anything.
  QByteArray inkscape(const QStringList& arguments);
  QString at(const char* name) const { return m_folder.filePath(QLatin1String(name)); }

  QTemporaryDir m_folder;
  QString m_program;
};

void InkscapeTest::initTestCase() {
  m_program = QStandardPaths::findExecutable("inkscape");
  if (m_program.isEmpty())
    SLINE_ABSENT("inkscape is not installed: nobody looks at our drawings with it");
  const QString scene = at("pelvis.sline");
  QCOMPARE(runSline({"demo", "pelvis", "-o", scene}).code, 0);
  QStringList annotate{"annotate", scene};
  for (const char* name : {"uterus", "urinary bladder", "sacrum", "left ureter"})
    annotate << "--on" << name;
  QCOMPARE(runSline(annotate).code, 0);
  QCOMPARE(runSline({"annotate", scene, "--label",
                     QString::fromUtf8("<b>Colon</b> & „sigmoideum“ with a name of many words"),
                     "--on", "sigmoid colon"})
               .code,
           0);
  const Finished finished = runSline(
      {"export", scene, "--svg", at("ours.svg"), "--labels", "on", "--size-mm", "240x135"});
  if (finished.code != 0)
    QSKIP(("no drawing can be made here: " + finished.err).constData());
}

QByteArray InkscapeTest::inkscape(const QStringList& arguments) {
  QProcess process;
  // Inkscape writes settings and recent files below our folder, and nowhere else.
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  for (const char* name : {"HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME",
                           "XDG_STATE_HOME", "XDG_RUNTIME_DIR", "INKSCAPE_PROFILE_DIR"})
    environment.insert(name, at("home"));
  environment.remove("DISPLAY");
  environment.remove("WAYLAND_DISPLAY");
  if (!QDir().mkpath(at("home")))
    qFatal("no folder for Inkscape");
  process.setProcessEnvironment(environment);
  process.setWorkingDirectory(m_folder.path());
  process.start(m_program, arguments);
  if (!process.waitForFinished(patience) || process.exitCode() != 0) {
    process.kill();
    process.waitForFinished();
    QTest::qFail("Inkscape does not end, or with an error", __FILE__, __LINE__);
  }
  for (const QByteArray& line : process.readAllStandardError().split('\n'))
    // Without a display Inkscape's list of recent files complains, whatever the drawing is.
    if (!line.trimmed().isEmpty() && !line.contains("GtkRecentManager"))
      QTest::qFail(line.constData(), __FILE__, __LINE__);
  return process.readAllStandardOutput();
}

void InkscapeTest::savedAgainItIsTheSame_data() {
  QTest::addColumn<bool>("plain");
  QTest::newRow("plain SVG") << true;
  QTest::newRow("Inkscape's SVG") << false;
}

void InkscapeTest::savedAgainItIsTheSame() {
  QFETCH(bool, plain);
  const QString file = at(plain ? "plain.svg" : "full.svg");
  QStringList arguments{"--export-type=svg", "--export-filename=" + file, at("ours.svg")};
  if (plain)
    arguments.prepend("--export-plain-svg");
  inkscape(arguments);
  const Outline ours = outlineOf(at("ours.svg"));
  const Outline theirs = outlineOf(file);
  QVERIFY(ours.wellFormed && theirs.wellFormed);
  QCOMPARE(ours.width, QString("240mm"));
  QCOMPARE(theirs.width, ours.width);
  QCOMPARE(theirs.height, ours.height);
  QCOMPARE(theirs.viewBox, ours.viewBox);
  QVERIFY(ours.texts.contains("uterus"));
  QVERIFY(ours.texts.contains("Anterior view"));
  QCOMPARE(theirs.texts, ours.texts);
  // Structures are compared by id and name: a layer's name is Inkscape's own, a title is standard
  // SVG.
  QVERIFY2(ours.titles.size() > 40, qPrintable(QString::number(ours.titles.size())));
  QCOMPARE(theirs.titles, ours.titles);
  QVERIFY2(ours.title.startsWith("Drawing of"), qPrintable(ours.title));
  QCOMPARE(theirs.title, ours.title);
  QCOMPARE(named(ours.labels), named(ours.titles));
  if (plain)
    return;
  QCOMPARE(ours.layers, (QStringList{"fills", "lines", "marks", "labels"}));
  QCOMPARE(theirs.layers, ours.layers);
  QCOMPARE(named(theirs.labels), named(ours.labels));
  for (const QString& layer : ours.layers)
    QCOMPARE(theirs.labels.at(layer), ours.labels.at(layer));
  QCOMPARE(ours.labels.at("fills"), QString("Fills"));
}

void InkscapeTest::openedAgainItIsTheSame() {
  inkscape({"--export-type=svg", "--export-filename=" + at("once.svg"), at("ours.svg")});
  inkscape({"--export-type=svg", "--export-filename=" + at("twice.svg"), at("once.svg")});
  const Outline once = outlineOf(at("once.svg"));
  const Outline twice = outlineOf(at("twice.svg"));
  QCOMPARE(twice.width, QString("240mm"));
  QCOMPARE(twice.viewBox, QString("0 0 240 135"));
  QCOMPARE(twice.titles, once.titles);
  QCOMPARE(twice.texts, once.texts);
}

/// Inkscape lists the groups with boxes on the page, in the page's pixels.
void InkscapeTest::listsOurGroups() {
  std::map<QString, QRectF> boxes;
  for (const QByteArray& line : inkscape({"--query-all", at("ours.svg")}).split('\n'))
    if (const QList<QByteArray> cells = line.trimmed().split(','); cells.size() == 5)
      boxes[QString::fromUtf8(cells[0])] = {cells[1].toDouble(), cells[2].toDouble(),
                                            cells[3].toDouble(), cells[4].toDouble()};
  const QRectF page(0.0, 0.0, pageWidth * pixelsPerMm, pageHeight * pixelsPerMm);
  QVERIFY(boxes.contains("background"));
  QVERIFY(std::abs(boxes["background"].width() - page.width()) < 0.1);
  QVERIFY(std::abs(boxes["background"].height() - page.height()) < 0.1);
  const Outline ours = outlineOf(at("ours.svg"));
  for (const auto& [id, title] : ours.titles) {
    QVERIFY2(boxes.contains(id), qPrintable(id + ": " + title));
    QVERIFY2(!boxes[id].isEmpty(), qPrintable(id));
    QVERIFY2(page.adjusted(-3, -3, 3, 3).contains(boxes[id]), qPrintable(id));
  }
}

void InkscapeTest::drawsWhatOthersDraw() {
  const QString rsvg = QStandardPaths::findExecutable("rsvg-convert");
  if (rsvg.isEmpty())
    SLINE_ABSENT("rsvg-convert is not installed");
  const QString width = "1440";
  const QString height = "810";
  inkscape({"--export-type=png", "--export-filename=" + at("theirs.png"), "-w", width, "-h", height,
            at("ours.svg")});
  QCOMPARE(
      QProcess::execute(rsvg, {"-w", width, "-h", height, at("ours.svg"), "-o", at("rsvg.png")}),
      0);
  const Pixels theirs = readPicture(at("theirs.png"));
  const Pixels other = readPicture(at("rsvg.png"));
  QCOMPARE(theirs.width, 1440);
  QCOMPARE(theirs.height, other.height);
  const Agreement there = agreement(theirs, other);
  const Agreement back = agreement(other, theirs);
  qInfo("%d pixels of ink, %.2f %% near the other's; %d, %.2f %%", there.ink, 100.0 * there.share,
        back.ink, 100.0 * back.share);
  QVERIFY(there.ink > 5000 && back.ink > 5000);
  QVERIFY(there.share >= 0.99);
  QVERIFY(back.share >= 0.99);
  // The fills have the same colours, too, except for rounding and edges.
  qsizetype different = 0;
  for (int y = 0; y < theirs.height; ++y)
    for (int x = 0; x < theirs.width; ++x)
      for (int channel = 0; channel < 3; ++channel)
        if (std::abs(theirs.at(x, y)[channel] - other.at(x, y)[channel]) > 40) {
          ++different;
          break;
        }
  const double share = double(different) / double(theirs.width) / double(theirs.height);
  QVERIFY2(share < 0.005, qPrintable(QString::number(100.0 * share) + " %"));
}

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::InkscapeTest)
#include "inkscape_test.moc"
