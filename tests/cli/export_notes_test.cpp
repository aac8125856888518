// SPDX-License-Identifier: Apache-2.0
// Tests that the lack of anything in a file is reported when it is written: what it is, of which
// structure, and what to do.
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/sline_process.h"
#include "tests/support/suite.h"

namespace sline::test {

class ExportNotesTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  QString m_sample = writeSample(m_folder.path());
  QString m_scene = m_folder.filePath("labelled.sline");

 private slots:
  void initTestCase() {
    QCOMPARE(runSline({"import", m_sample, "--sides", "right", "-o", m_scene}).code, 0);
    for (const auto& [label, structure] : {std::pair("the kidney", "kidney"),
                                           {"the artery", "renal artery"},
                                           {"the vein", "renal vein"}})
      QCOMPARE(runSline({"annotate", m_scene, "--label", label, "--on", structure}).code, 0);
    writeFile(m_folder.filePath("near.json"),
              frontCamera().replace("\"fovy_deg\":30", "\"fovy_deg\":6"));
  }

  void said_data() {
    QTest::addColumn<QStringList>("flags");
    QTest::addColumn<QStringList>("says");  // empty: nothing at all
    const QString near = m_folder.filePath("near.json");
    const auto row = [](const char* name, const QStringList& flags, const QStringList& says) {
      QTest::newRow(name) << flags << says;
    };
    row("all is well", {"--svg", "a.svg", "--labels", "on"}, {});
    row("room", {"--svg", "a.svg", "--labels", "on", "--label-size", "30", "--size-mm", "40x16"},
        {"labels found no room: \"the ", "--label-size", "--labels numbers"});
    row("room in a figure",
        {"--pdf", "a.pdf", "--labels", "on", "--label-size", "30", "--size-mm", "40x16"},
        {"labels found no room: \"the "});
    row("room in pixels",
        {"--png", "a.png", "--labels", "on", "--label-size", "30", "--size-mm", "40x16"},
        {"labels found no room: \"the "});
    row("room in a film",
        {"--webp", "a.webp", "--labels", "on", "--label-size", "48", "--size-mm", "16x40",
         "--seconds", "0.2", "--fps", "10", "--film-height", "90"},
        {"labels found no room: \"the "});
    row("hidden", {"--svg", "a.svg", "--labels", "on", "--only", "kidney"},
        {"2 labels are left out, as nothing is drawn there: \"the artery\", \"the vein\"."});
    row("hidden surfaces", {"--glb", "a.glb", "--only", "kidney", "renal artery"},
        {"1 label is left out, as nothing is drawn there: \"the vein\"."});
    row("beside", {"--svg", "a.svg", "--labels", "on", "--camera", near},
        {"2 labels point to places beside the picture: \"the artery\", \"the vein\". Choose a "
         "view"});
    row("language", {"--svg", "a.svg", "--labels", "on", "--language", "de"},
        {"3 labels have no text in de", "--language"});
    row("cards", {"--anki", "a.apkg", "--label-size", "24", "--size-mm", "60x30", "--marks", "off"},
        {"found no room and ha", "no card: \"the "});
    row("marks", {"--svg", "a.svg", "--label-size", "48", "--size-mm", "30x12"},
        {"at the picture's edge found no room: ", "--marks"});
    row("a name of a view", {"--svg", "a.svg", "--size-mm", "20x60"},
        {"1 text was too long and is shortened: \"Anterior view\""});
    row("directions", {"--svg", "a.svg", "--frame", "file"}, {"R and L are left out", "--frame"});
    row("title",
        {"--pdf", "a.pdf", "--sheet", "figure", "--title", QString("long words ").repeated(20)},
        {"1 text was too long and is shortened: \"long words", "…\""});
    row("cuts", {"--glb", "a.glb", "--section", "sagittal"},
        {"1 section cuts nothing in the file, which holds whole surfaces"});
    row("white", {"--jpeg", "a.jpg", "--background", "transparent"}, {"stands on white", "--png"});
    row("depth", {"--jpeg", "a.jpg", "--bits", "16"}, {"fewer than 16 bits"});
    row("two kinds", {"--jpeg", "a.jpg", "--tiff", "a.tiff", "--bits", "16"}, {"a.jpg: a channel"});
    row("simplified page", {"--page", "a.html", "--page-error", "0.5"},
        {"surfaces are simplified and off by 0.", "mm at most", "--page-error"});
    row("a quiz of nothing", {"--page", "a.html", "--ask-only", "renal vein", "--only", "kidney"},
        {"the quiz asks nothing", "--quiz off"});
    row("odd film", {"--gif", "a.gif", "--seconds", "0.27", "--fps", "10", "--film-height", "35"},
        {"36 pixels large", "0.30 seconds"});
  }
  void said() {
    QFETCH(QStringList, flags);
    QFETCH(QStringList, says);
    const bool unknown = flags.contains("--frame");
    for (QString& flag : flags)
      if (flag.startsWith("a."))
        flag = m_folder.filePath(flag);
    if (!flags.contains("--size-mm") && !flags.contains("--sheet"))
      flags << "--size-mm"
            << "160x90";
    flags << "--dpi"
          << "72";
    const Finished finished = runSline(QStringList{"export", unknown ? m_sample : m_scene} + flags);
    const QString said = QString::fromUtf8(finished.err);
    QVERIFY2(finished.code == 0, qPrintable(said));
    for (const QString& text : says)
      QVERIFY2(said.contains(text), qPrintable(text + "\n" + said));
    for (const QString& line : said.split('\n', Qt::SkipEmptyParts))
      QVERIFY2(line.startsWith("sline: warning: " + m_folder.path()), qPrintable(line));
    QVERIFY2(!says.isEmpty() || said.isEmpty(), qPrintable(said));
    // A file that holds all that was asked for is not mentioned.
    QVERIFY2(!said.contains("a.tiff"), qPrintable(said));
  }

  void namesOnALine() {
    const QString scene = m_folder.filePath("many.sline");
    QVERIFY(QFile::copy(m_scene, scene));
    for (int i = 0; i < 12; ++i)
      QCOMPARE(runSline({"annotate", scene, "--label", QStringLiteral("label\x1b[31m\n%1").arg(i),
                         "--on", "renal vein"})
                   .code,
               0);
    const Finished finished = runSline({"export", scene, "--svg", m_folder.filePath("a.svg"),
                                        "--labels", "on", "--only", "kidney"});
    QVERIFY2(finished.err.contains("14 labels are left out"), finished.err.constData());
    QVERIFY2(finished.err.contains(" and 6 more."), finished.err.constData());
    QCOMPARE(finished.err.count('\n'), 1);
    QVERIFY(!finished.err.contains('\x1b'));
  }

  void jobsSayTheirs() {
    writeFile(m_folder.filePath("list.csv"),
              "input,svg,labels,only\n"
              "labelled.sline,out/a.svg,on,\n"
              "labelled.sline,out/b.svg,on,kidney\n");
    const Finished finished = runSline({"jobs", m_folder.filePath("list.csv")});
    QVERIFY2(finished.code == 0, finished.err.constData());
    QVERIFY2(finished.err.contains("sline: warning: line 3: "), finished.err.constData());
    QVERIFY2(finished.err.contains("out/b.svg: 2 labels are left out"), finished.err.constData());
    QVERIFY2(!finished.err.contains("line 2"), finished.err.constData());
    QVERIFY2(finished.err.contains("2 jobs done, 0 failed, 0 skipped, of 2 in the list; 1 with "
                                   "warnings"),
             finished.err.constData());
  }

  void wholeNumbers() {
    for (const auto& [flag, value] : {std::pair("--fps", "29.97"), {"--film-height", "720.5"}}) {
      const Finished finished =
          runSline({"export", m_scene, "--gif", m_folder.filePath("a.gif"), flag, value});
      QCOMPARE(finished.code, 2);
      QVERIFY2(finished.err.contains("whole number"), finished.err.constData());
    }
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::ExportNotesTest)
#include "export_notes_test.moc"
