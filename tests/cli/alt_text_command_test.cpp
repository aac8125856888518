// SPDX-License-Identifier: Apache-2.0
// Tests that files say what they show and, where that is wished, whose work the surfaces are; that
// they give no answer away; and that whatever is said stays text.
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>
#include <map>

#include "render/export/formats/export_formats.h"
#include "tests/cli/sline_process.h"
#include "tests/support/marker_scan.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

/// What ends texts, elements and attributes wherever it is not escaped.
constexpr const char* hostile =
    "QZXHOSTILE</desc></title></text>\"'><script>alert(1)</script>]]>&amp;<!-- %1 \\ ) (";

QByteArray contents(const QString& file) {
  QFile source(file);
  return source.open(QIODevice::ReadOnly) ? source.readAll() : QByteArray();
}

}  // namespace

class AltTextCommandTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  QString m_scene = m_folder.filePath("scene.sline");

  QString path(const QString& name) const { return m_folder.filePath(name); }

  /// Exports the scene as every kind at once, but frames, which are pictures of a film; returns
  /// what each kind's file holds.
  std::map<QString, QByteArray> exported(const QString& scene, const QStringList& flags) {
    QStringList arguments{"export", scene, "--dpi",         "72", "--seconds", "0.5",
                          "--fps",  "6",   "--film-height", "96", "--size-mm", "80x60"};
    std::map<QString, QByteArray> files;
    for (const render::ExportFormat& format : render::exportFormats())
      if (*format.extension) {
        arguments << QString("--") + format.id
                  << path(QString("all-%1.%2").arg(format.id, format.extension));
        files[format.id] = {};
      }
    const Finished finished = runSline(arguments + flags);
    if (finished.code != 0)
      qWarning("%s", finished.err.constData());
    for (auto& [kind, bytes] : files) {
      const QString file =
          path(QString("all-%1.%2").arg(kind, render::exportFormat(kind.toStdString())->extension));
      bytes = finished.code == 0 ? contents(file) : QByteArray();
      QFile::remove(file);
    }
    return files;
  }
  /// Returns the kinds whose files have the words, parted by blanks.
  QString kindsThatSay(const QString& words, const QString& scene, const QStringList& flags) {
    QStringList kinds;
    for (const auto& [kind, bytes] : exported(scene, flags)) {
      if (bytes.isEmpty())
        return kind + " was not written";
      if (!markersIn(bytes, {words}).isEmpty())
        kinds << kind;
    }
    return kinds.join(' ');
  }
  static QString all(const QStringList& but = {}) {
    QStringList kinds;
    for (const render::ExportFormat& format : render::exportFormats())
      if (*format.extension && !but.contains(format.id))
        kinds << format.id;
    kinds.sort();
    return kinds.join(' ');
  }

  static QString described(const QStringList& arguments) {
    const Finished finished = runSline(QStringList{"describe"} + arguments);
    return finished.code == 0 ? QString::fromUtf8(finished.out).trimmed()
                              : QString::fromUtf8(finished.err);
  }

 private slots:
  void initTestCase() {
    const QString sample = writeSample(m_folder.path());
    QCOMPARE(runSline({"import", sample, "--sides", "right", "-o", m_scene}).code, 0);
    QCOMPARE(runSline({"annotate", m_scene, "--on", "kidney", "--label", "QZXLABEL"}).code, 0);
    QCOMPARE(runSline({"view", m_scene, "--add", "front", "--from", "anterior"}).code, 0);
  }

  void everyFileSaysWhatItShows() {
    QCOMPARE(kindsThatSay("seen from the front", m_scene, {}), all());
    QCOMPARE(kindsThatSay("gesehen von vorn", m_scene, {"--language", "de"}), all());
    QCOMPARE(kindsThatSay("seen from the front", m_scene, {"--alt", "off"}), QString());
    // What asks says nothing that might answer.
    QCOMPARE(kindsThatSay("QZXSAID by hand", m_scene, {"--alt", "QZXSAID by hand"}),
             all({"anki", "h5p", "moodle", "qti"}));
  }

  /// No file but those that hold the labels all the same names what it does not write out.
  void noAnswersAreGivenAway_data() {
    QTest::addColumn<QString>("labels");
    for (const char* labels : {"off", "numbers", "blank"})
      QTest::newRow(labels) << labels;
  }
  void noAnswersAreGivenAway() {
    QFETCH(QString, labels);
    QCOMPARE(kindsThatSay("QZXLABEL", m_scene, {"--labels", labels}),
             QString("anki cmi5 glb h5p moodle page qti scorm12 scorm2004"));
  }

  /// The pictures of a deck name what they answer alone.
  void cardsNameTheirOwnAnswer() {
    QCOMPARE(runSline({"export", m_scene, "--anki", path("deck"), "--size-mm", "80x60"}).code, 0);
    const QByteArray deck = contents(path("deck/deck.txt"));
    QVERIFY2(deck.contains("alt=\"Drawing of 3 structures, seen from the front. The patient"),
             deck.constData());
    QList<QByteArray> cards;
    for (const QByteArray& line : deck.split('\n'))
      if (!line.isEmpty() && !line.startsWith('#'))
        cards << line;
    QCOMPARE(cards.size(), 2);
    for (const QByteArray& card : cards) {
      const QList<QByteArray> columns = card.split('\t');
      // The second card asks for the name's number, so that it says the name, above its picture.
      const QByteArray& question = columns.at(1);
      QCOMPARE(question.count("QZXLABEL"), card == cards.front() ? 0 : 1);
      QVERIFY(!question.mid(question.indexOf("<img")).contains("QZXLABEL"));
      QCOMPARE(columns.at(2).count("QZXLABEL"), 2);  // in the answer's picture and below it
    }
  }

  void viewsHaveTheirOwn() {
    const QString scene = path("own.sline");
    QVERIFY(QFile::copy(m_scene, scene));
    QCOMPARE(runSline({"view", scene, "--tell", "front", "--alt", "A kidney & vessels", "--alt",
                       "de=Eine Niere"})
                 .code,
             0);
    QCOMPARE(described({scene, "--view", "front"}), QString("A kidney & vessels"));
    QCOMPARE(described({scene, "--view", "front", "--language", "de"}), QString("Eine Niere"));
    QVERIFY(described({scene, "--view", "front", "--seen"}).startsWith("Drawing of 3 structures"));
    QVERIFY(!described({scene, "--view", "front", "--labels", "numbers"}).contains("kidney"));
    const QByteArray list = runSline({"view", scene, "--list", "--json"}).out;
    QVERIFY2(list.contains("\"de\": \"Eine Niere\""), list.constData());
    QCOMPARE(runSline({"view", scene, "--tell", "front", "--alt", ""}).code, 0);
    QVERIFY(described({scene, "--view", "front"}).startsWith("Drawing of 3 structures"));
  }

  void describesInSoManyWords() {
    const QString text = described({m_scene, "--words", "12"});
    QVERIFY2(text.split(' ').size() <= 12 && text.startsWith("Drawing of 3"), qPrintable(text));
    QCOMPARE(runSline({"describe", m_scene, "--words", "5"}).code, 2);
    QCOMPARE(runSline({"describe", path("none.sline")}).code, 1);
  }

  void creditsAreSaidAndTold() {
    const QString scene = path("credited.sline");
    QVERIFY(QFile::copy(m_scene, scene));
    QVERIFY(runSline({"credit", scene}).out.contains("does not say whose work"));
    QCOMPARE(runSline({"credit", scene, "--source", "An\natlas", "--licence", "CC BY 4.0"}).code,
             0);
    QCOMPARE(runSline({"credit", scene, "kidney", "--authors", "Jane Doe"}).code, 0);
    const QByteArray told = runSline({"credit", scene}).out;
    QVERIFY2(told.contains("kidney: An atlas, Jane Doe, CC BY 4.0\n"), told.constData());
    QCOMPARE(told.count("An atlas, CC BY 4.0\n"), 2);
    const Finished unknown = runSline({"credit", scene, "kidnee", "--authors", "x"});
    QCOMPARE(unknown.code, 2);
    QVERIFY(unknown.err.contains("kidney"));
    QCOMPARE(runSline({"credit", scene, "kidney", "--clear"}).code, 0);
    QVERIFY(!runSline({"credit", scene}).out.contains("Jane Doe"));
    QVERIFY(runSline({"credit", scene, "--json"}).out.contains("\"licence\": \"CC BY 4.0\""));
  }

  void creditsArePrintedWhereWished() {
    const QString scene = path("printed.sline");
    QVERIFY(QFile::copy(m_scene, scene));
    QCOMPARE(runSline({"credit", scene, "--source", "QZXSOURCE"}).code, 0);
    QCOMPARE(kindsThatSay("QZXSOURCE", scene, {}), QString("cmi5 glb page scorm12 scorm2004"));
    QCOMPARE(kindsThatSay("QZXSOURCE", scene, {"--credits", "off"}), QString());
    QCOMPARE(kindsThatSay("QZXSOURCE", scene, {"--credits", "line"}), all());
    QCOMPARE(kindsThatSay("QZXSOURCE", scene, {"--credits", "page"}), all());
  }

  /// A page of credits is one more page, and a slide one more slide.
  void creditsHaveAPage() {
    const QString credited = path("paged.sline");
    QVERIFY(QFile::copy(m_scene, credited));
    QCOMPARE(runSline({"credit", credited, "--source", "QZXSOURCE"}).code, 0);
    QCOMPARE(runSline({"export", credited, "--pdf", path("paged.pdf"), "--pptx", path("paged.pptx"),
                       "--size-mm", "80x60", "--credits", "page"})
                 .code,
             0);
    QVERIFY(contents(path("paged.pptx")).contains("ppt/slides/slide2.xml"));
    const QByteArray text = textOfPdf(path("paged.pdf"));
    if (text.isEmpty())
      SLINE_ABSENT("no program that reads PDF is installed");
    QVERIFY2(text.contains("Sources") && text.contains("QZXSOURCE"), text.constData());
    QVERIFY(text.contains("Pages:           2"));
  }

  /// Whatever is said of a picture, a structure or its source stays text.
  void hostileTextsStayText() {
    const QString scene = path("hostile.sline");
    QVERIFY(QFile::copy(m_scene, scene));
    QCOMPARE(runSline({"annotate", scene, "--on", "renal artery", "--label", hostile}).code, 0);
    QCOMPARE(runSline({"credit", scene, "--source", hostile, "--authors", hostile}).code, 0);
    QCOMPARE(runSline({"view", scene, "--tell", "front", "--alt", hostile}).code, 0);
    for (const QStringList& flags :
         {QStringList{"--view", "front"}, QStringList{"--alt", hostile}, QStringList()}) {
      const QString svg = path("hostile.svg");
      const QString deck = path("hostile");
      QCOMPARE(runSline(QStringList{"export", scene, "--svg", svg, "--anki", deck, "--glb",
                                    path("hostile.glb"), "--pdf", path("hostile.pdf"), "--credits",
                                    "line", "--size-mm", "240x160"} +
                        flags)
                   .code,
               0);
      QXmlStreamReader xml(contents(svg));
      QString shown;
      while (!xml.atEnd())
        if (xml.readNext() == QXmlStreamReader::StartElement) {
          QVERIFY(xml.name() != QLatin1String("script"));
          if (xml.name() == QLatin1String("desc"))
            shown = xml.readElementText();
        }
      QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
      QVERIFY2(shown.contains("QZXHOSTILE</desc>"), qPrintable(shown));
      const QByteArray cards = contents(deck + "/deck.txt");
      QVERIFY(cards.contains("&lt;script&gt;") && !cards.contains("<script>"));
      QVERIFY(QDir(deck).removeRecursively());
    }
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::AltTextCommandTest)
#include "alt_text_command_test.moc"
