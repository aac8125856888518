// SPDX-License-Identifier: Apache-2.0
// Tests `sline export --views all`: lessons as other programs read them, page by page, self-tests,
// sets of pictures, and that the same flags mean the same for every kind of file.
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <map>

#include "tests/cli/sline_process.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

constexpr const char* oddTitle = "The <b>left</b> & {{c1::$x}} %s \\(y\\)";

QString toolOutput(const QString& program, const QStringList& arguments) {
  QProcess process;
  process.start(program, arguments);
  if (!process.waitForFinished(60'000) || process.exitCode() != 0)
    return {};
  return QString::fromUtf8(process.readAllStandardOutput());
}

}  // namespace

class LessonCommandTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  QString m_scene = m_folder.filePath("lesson.sline");
  QString m_file = m_folder.filePath("lesson.pdf");

  Finished exported(const QStringList& flags) const {
    QFile::remove(m_file);
    return runSline(QStringList{"export", m_scene, "--pdf", m_file, "--views", "all"} + flags);
  }
  /// Returns the text of each page, with single spaces.
  QStringList pages() const {
    static const QRegularExpression count("Pages: *([0-9]+)");
    const int pages = count.match(toolOutput("pdfinfo", {m_file})).captured(1).toInt();
    QStringList texts;
    for (int page = 1; page <= pages; ++page) {
      const QString number = QString::number(page);
      texts << toolOutput("pdftotext", {"-f", number, "-l", number, m_file, "-"}).simplified();
    }
    return texts;
  }
  /// Returns the pages that the index names, of each structure; page numbers count from 1.
  static std::map<QString, QStringList> indexIn(const QString& page, const QStringList& names) {
    std::map<QString, QStringList> found;
    for (const QString& name : names) {
      const QRegularExpression entry(QRegularExpression::escape(name) + " ([0-9]+(, [0-9]+)*)\\b");
      const auto match = entry.match(page);
      if (match.hasMatch())
        found[name] = match.captured(1).split(", ");
    }
    return found;
  }

 private slots:
  void initTestCase() {
    for (const char* program : {"pdftotext", "pdfinfo"})
      if (QStandardPaths::findExecutable(program).isEmpty())
        SLINE_ABSENT("poppler-utils are not installed");
    const QString sample = writeSample(m_folder.path());
    QCOMPARE(runSline({"import", sample, "-o", m_scene}).code, 0);
    for (const char* name : {"kidney", "renal artery", "renal vein"})
      QCOMPARE(runSline({"annotate", m_scene, "--on", name, "--label",
                         QString("The ") + QLatin1String(name)})
                   .code,
               0);
    const auto add = [this](const QStringList& flags) {
      return runSline(QStringList{"view", m_scene, "--add"} + flags).code;
    };
    QCOMPARE(add({"Front", "--from", "anterior", "--title", "From in front", "--title",
                  "de=Von vorn", "--text", "Look *at the* hilum", "--notes", "secret"}),
             0);
    QCOMPARE(add({"Side", "--from", "left", "--title", oddTitle, "--labels", "1,2", "--text",
                  "<script>alert(1)</script>"}),
             0);
    QCOMPARE(add({"Back", "--from", "posterior", "--labels", "1", "--focus", "kidney"}), 0);
  }

  void eachViewHasAPage() {
    QCOMPARE(exported({"--title", "Kidneys & <i>more</i>"}).code, 0);
    const QStringList pages = this->pages();
    QCOMPARE(pages.size(), 5);
    QVERIFY2(pages[0].contains("Kidneys & <i>more</i>") && pages[0].contains("Contents"),
             qPrintable(pages[0]));
    for (const QString& entry : {QString("From in front 2"), oddTitle + QString(" 3"),
                                 QString("Back 4"), QString("Index of structures 5")})
      QVERIFY2(pages[0].contains(entry), qPrintable(entry + ": " + pages[0]));
    QVERIFY(pages[1].contains("From in front") && pages[1].contains("Look at the hilum"));
    QVERIFY2(pages[2].contains(oddTitle) && pages[2].contains("<script>alert(1)</script>"),
             qPrintable(pages[2]));
    for (const QString& page : pages)
      QVERIFY(!page.contains("secret") && !page.contains("Self-test"));
    QVERIFY2(pages[3].contains(QRegularExpression("4 ?/ ?5")), qPrintable(pages[3]));
  }

  /// The index names a page if and only if that page has the label.
  void indexIsRight() {
    for (const QStringList& flags :
         {QStringList{}, QStringList{"--sheet", "teaching"},
          QStringList{"--sheet", "teaching", "--key", "end", "--landscape", "--word-bank"},
          QStringList{"--paper", "letter", "--sheet", "figure", "--labels", "on"}}) {
      QCOMPARE(exported(flags).code, 0);
      const QStringList pages = this->pages();
      const QStringList names{"The kidney", "The renal artery", "The renal vein"};
      const auto index = indexIn(pages.last(), names);
      std::map<QString, QStringList> labelled;
      for (int page = 1; page < pages.size() - 1; ++page)
        if (!pages[page].contains("Self-test") && !pages[page].contains("Key"))
          for (const QString& name : names)
            if (pages[page].contains(name))
              labelled[name] << QString::number(page + 1);
      QVERIFY2(index == labelled, qPrintable(flags.join(' ') + "\n" + pages.join('\n')));
      QCOMPARE(labelled[names[0]].size(), 3);
      QCOMPARE(labelled[names[1]].size(), 2);
      QCOMPARE(labelled[names[2]].size(), 1);
    }
  }

  void keysStandApart() {
    QCOMPARE(exported({"--sheet", "teaching"}).code, 0);
    QStringList pages = this->pages();
    QCOMPARE(pages.size(), 1 + 3 * 3 + 1);
    for (const int view : {1, 4, 7}) {
      QVERIFY(pages[view + 1].contains("Self-test"));
      QVERIFY2(!pages[view + 1].contains("The kidney"), qPrintable(pages[view + 1]));
      QVERIFY(pages[view + 2].contains("Key") && pages[view + 2].contains("The kidney"));
    }
    QCOMPARE(exported({"--sheet", "teaching", "--key", "end"}).code, 0);
    pages = this->pages();
    QCOMPARE(pages.size(), 1 + 2 * 3 + 3 + 1);
    QVERIFY2(pages[0].contains("Key 8"), qPrintable(pages[0]));
    for (const int page : {7, 8, 9})
      QVERIFY(pages[page].contains("Key") && pages[page].contains("The kidney"));
  }

  void instructions_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("write");
    QTest::addColumn<QString>("choose");
    QTest::newRow("en") << ""
                        << "Write on each line"
                        << "Words to choose from";
    QTest::newRow("de") << "de"
                        << "Schreiben Sie auf jede Linie"
                        << "Wörter zur Auswahl";
    QTest::newRow("nl") << "nl"
                        << "Schrijf op elke lijn"
                        << "Woorden om uit te kiezen";
    QTest::newRow("nb") << "nb"
                        << "Skriv på hver linje"
                        << "Ord å velge mellom";
    QTest::newRow("la") << "la"
                        << "Scribe in quaque linea"
                        << "Verba eligenda";
  }
  void instructions() {
    QFETCH(QString, language);
    QFETCH(QString, write);
    QFETCH(QString, choose);
    const QStringList flags{"--sheet", "teaching", "--language", language};
    QCOMPARE(exported(flags).code, 0);
    QString test = pages()[2];
    QVERIFY2(test.contains(write) && !test.contains(choose), qPrintable(test));
    QCOMPARE(exported(flags + QStringList{"--word-bank"}).code, 0);
    test = pages()[2];
    QVERIFY2(test.contains(write) && test.contains(choose), qPrintable(test));
    for (const char* name : {"The kidney", "The renal artery", "The renal vein"})
      QCOMPARE(test.count(name), 1);
    // The bank is not in the order of the numbers, which the key has.
    const QString key = pages()[3];
    const auto order = [](const QString& page) {
      std::map<qsizetype, QString> places;
      for (const char* name : {"The kidney", "The renal artery", "The renal vein"})
        places[page.indexOf(name)] = name;
      return places;
    };
    QStringList asked;
    QStringList offered;
    for (const auto& [at, name] : order(key))
      asked << name;
    for (const auto& [at, name] : order(test))
      offered << name;
    QVERIFY(asked != offered);
  }

  void difficulty_data() {
    QTest::addColumn<QStringList>("flags");
    QTest::addColumn<QStringList>("front");  ///< what the first view's key has
    QTest::newRow("all") << QStringList{}
                         << QStringList{"The kidney", "The renal artery", "The renal vein"};
    QTest::newRow("a structure") << QStringList{"--ask-only", "renal vein"}
                                 << QStringList{"The renal vein"};
    QTest::newRow("a group and a structure")
        << QStringList{"--ask-only", " Vessels , kidney"}
        << QStringList{"The kidney", "The renal artery", "The renal vein"};
    QTest::newRow("a group") << QStringList{"--ask-only", "Vessels"}
                             << QStringList{"The renal artery", "The renal vein"};
    QTest::newRow("in focus, where there is none")
        << QStringList{"--ask", "focus"} << QStringList{};
  }
  void difficulty() {
    QFETCH(QStringList, flags);
    QFETCH(QStringList, front);
    QCOMPARE(exported(QStringList{"--sheet", "teaching"} + flags).code, 0);
    const QStringList pages = this->pages();
    const QString key = pages[3];
    QCOMPARE(key.contains("Key"), !front.isEmpty());
    for (const char* name : {"The kidney", "The renal artery", "The renal vein"})
      QCOMPARE(key.contains("Key") && key.contains(name), front.contains(name));
    // The last view has its own focus.
    if (flags.contains("focus"))
      QVERIFY(pages[pages.size() - 2].contains("Key") &&
              pages[pages.size() - 2].contains("The kidney"));
  }

  void unknownNamesAreRefused() {
    const Finished finished = exported({"--sheet", "teaching", "--ask-only", "kidney,spleen"});
    QCOMPARE(finished.code, 2);
    QVERIFY2(finished.err.contains("\"spleen\"") && finished.err.contains("--ask-only"),
             finished.err.constData());
    QVERIFY(!QFile::exists(m_file));
  }

  void setsOfPictures() {
    const QString folder = m_folder.filePath("set");
    QVERIFY(QDir().mkpath(folder));
    const Finished finished = runSline({"export", m_scene, "--png", folder, "--svg",
                                        folder + "/kidney.svg", "--views", "all", "--dpi", "30"});
    QVERIFY2(finished.code == 0, finished.err.constData());
    QCOMPARE(QDir(folder).entryList(QDir::Files, QDir::Name),
             QStringList({"1 Front.png", "2 Side.png", "3 Back.png", "kidney - 1 Front.svg",
                          "kidney - 2 Side.svg", "kidney - 3 Back.svg"}));
    QSet<QByteArray> contents;
    for (const QString& name : QDir(folder).entryList(QDir::Files)) {
      QFile file(folder + '/' + name);
      QVERIFY(file.open(QIODevice::ReadOnly));
      contents << file.readAll();
    }
    QCOMPARE(contents.size(), 6);
  }

  /// What is shown alone is the same with and without the flag, and so is a view that is named.
  void oneViewIsTheUsual() {
    const QString other = m_folder.filePath("other.pdf");
    for (const QStringList& flags :
         {QStringList{}, QStringList{"--view", "Side", "--marks", "sides"}}) {
      QCOMPARE(runSline(QStringList{"export", m_scene, "--pdf", m_file} + flags).code, 0);
      QCOMPARE(pages().size(), 1);
      QCOMPARE(
          runSline(QStringList{"export", m_scene, "--pdf", other, "--views", "shown"} + flags).code,
          0);
      QFile a(m_file);
      QFile b(other);
      QVERIFY(a.open(QIODevice::ReadOnly) && b.open(QIODevice::ReadOnly));
      QVERIFY(a.readAll() == b.readAll());
    }
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::LessonCommandTest)
#include "lesson_command_test.moc"
