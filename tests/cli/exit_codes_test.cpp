// SPDX-License-Identifier: Apache-2.0
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/sline_process.h"
#include "tests/support/suite.h"

namespace sline::test {

/// Tests how the program answers right and wrong command lines. In the arguments, SAMPLE is a good
/// scene, DIR the test's folder.
class ExitCodesTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void answers_data();
  void answers();
  void outputThatGoesNowhere_data();
  void outputThatGoesNowhere();

 private:
  QTemporaryDir m_folder;
  QString m_sample;
};

void ExitCodesTest::initTestCase() {
  QVERIFY(m_folder.isValid());
  m_sample = writeSample(m_folder.path());
  writeFile(m_folder.filePath("front.json"), frontCamera());
  writeFile(m_folder.filePath("blind.json"), R"({"eye":[1,2,3],"target":[1,2,3]})");
  writeFile(m_folder.filePath("broken.json"), R"({"eye":[1,2)");
  writeFile(m_folder.filePath("broken.stl"), "solid broken\n facet normal 0 0");
  writeFile(m_folder.filePath("notes.txt"), "no mesh");
  QVERIFY(QDir(m_folder.path()).mkdir("empty"));
}

void ExitCodesTest::answers_data() {
  QTest::addColumn<QString>("arguments");
  QTest::addColumn<int>("code");
  QTest::addColumn<QString>(
      "says");  // somewhere in either stream; '|' separates texts that must all be there
  const QString render = "render|SAMPLE|-o|DIR/a.png|--size|64x64";

  QTest::newRow("version") << "--version" << 0 << "sline ";
  QTest::newRow("help") << "--help" << 0 << "gamma|render|lines|curvature|info";
  QTest::newRow("render's help") << "render|--help" << 0 << "--camera|--only|anterior|#rrggbb";
  QTest::newRow("lines' help") << "lines|--help" << 0 << "theta_c|--kinds";

  QTest::newRow("an option for a value")
      << "render|SAMPLE|--labels|-o|DIR/a.png" << 2 << "--labels needs a value|-o follows";
  QTest::newRow("no command") << "" << 2 << "";
  QTest::newRow("unknown command") << "draw" << 2 << "";
  QTest::newRow("unknown flag") << render + "|--gama|2" << 2 << "--gama";
  QTest::newRow("no input") << "render|-o|DIR/a.png" << 2 << "INPUT";
  QTest::newRow("no output") << "render|SAMPLE" << 2 << "--output";
  QTest::newRow("unknown picture kind") << "render|SAMPLE|-o|DIR/a.bmpx" << 2 << "png|tiff|exr|jpg";
  QTest::newRow("picture without kind") << "render|SAMPLE|-o|DIR/a" << 2 << "extension|png";
  QTest::newRow("size of words") << "render|SAMPLE|-o|DIR/a.png|--size|big" << 2 << "big|1920x1080";
  QTest::newRow("size too small") << "render|SAMPLE|-o|DIR/a.png|--size|15x64" << 2 << "16|20000";
  QTest::newRow("size too large") << "render|SAMPLE|-o|DIR/a.png|--size|64x20001" << 2 << "20000";
  QTest::newRow("samples of words") << render + "|--samples|many" << 2 << "many|auto";
  QTest::newRow("samples of a large picture")
      << "render|SAMPLE|-o|DIR/a.png|--size|64x10001|--samples|2" << 2 << "20000";
  QTest::newRow("gamma too large") << render + "|--gamma|5.1" << 2 << "5.1";
  QTest::newRow("gamma of words") << render + "|--gamma|much" << 2 << "much";
  QTest::newRow("gamma not a number") << render + "|--gamma|nan" << 2 << "nan";
  QTest::newRow("gamma of a name too large") << render + "|--gamma|kidney=9" << 2 << "9";
  QTest::newRow("hatch density too large") << render + "|--hatch-density|4.5" << 2 << "4.5|0 to 4";
  QTest::newRow("hatch tone of words") << render + "|--hatch-tone|kidney=dark" << 2 << "dark";
  QTest::newRow("pen below nothing") << render + "|--pen|-1" << 2 << "-1|0 to 10";
  QTest::newRow("unknown name") << render + "|--gamma|kidny=2" << 2 << "kidny|\"kidney\"";
  QTest::newRow("part of a name") << render + "|--only|renal" << 2 << "renal artery|renal vein";
  QTest::newRow("colour by name") << render + "|--color|kidney=red" << 2 << "red|#rrggbb";
  QTest::newRow("colour without name") << render + "|--color|#ff0000" << 2 << "NAME";
  QTest::newRow("unknown fill") << render + "|--fill|water" << 2 << "water|tint";
  QTest::newRow("unknown background") << render + "|--background|pink" << 2 << "pink|transparent";
  QTest::newRow("unknown hatching") << render + "|--hatching|grey" << 2 << "grey|as-printed";
  QTest::newRow("unknown ink") << render + "|--ink-colour|kidney=blue" << 2 << "blue|#rrggbb";
  QTest::newRow("ink of nothing") << render + "|--ink-color|kidny=#0000ff" << 2 << "kidny";
  QTest::newRow("black and white on dark") << render + "|--bw|--background|dark" << 2 << "--bw";
  QTest::newRow("black and white in blue") << render + "|--ink-color|#0000ff|--bw" << 2 << "--bw";
  QTest::newRow("focus on nothing") << render + "|--focus|kidny" << 2 << "kidny|\"kidney\"";
  QTest::newRow("more than everything")
      << render + "|--focus|kidney|--context|1.5" << 2 << "0 to 1";
  QTest::newRow("context without focus") << render + "|--context|0.5" << 2 << "--focus";
  QTest::newRow("context from nowhere")
      << render + "|--focus|kidney|--context-from|above" << 2 << "above|around";
  QTest::newRow("near nothing") << render + "|--focus-near|kidny" << 2 << "kidny|\"kidney\"";
  QTest::newRow("near two numbers") << render + "|--focus-near|1,2" << 2 << "1";
  QTest::newRow("falloff of nothing") << render + "|--falloff|50" << 2 << "--focus-near";
  QTest::newRow("no falloff") << render + "|--focus-near|kidney|--falloff|0" << 2
                              << "--falloff|1 to 2000";
  QTest::newRow("two kinds of focus")
      << render + "|--focus|kidney|--focus-near|kidney" << 2 << "--focus-near";
  QTest::newRow("unknown view") << render + "|--view|front" << 2 << "front|anterior|superior";
  QTest::newRow("view and camera") << render + "|--view|left|--camera|DIR/front.json" << 2 << "";
  QTest::newRow("absent camera") << render + "|--camera|DIR/none.json" << 2 << "none.json";
  QTest::newRow("broken camera") << render + "|--camera|DIR/broken.json" << 2 << "broken.json|byte";
  QTest::newRow("blind camera") << render + "|--camera|DIR/blind.json" << 2 << "same point";
  QTest::newRow("unknown frame") << render + "|--frame|XYZ" << 2 << "XYZ|RAS";
  QTest::newRow("unknown smoothing") << render + "|--smooth|soft" << 2 << "soft|auto";
  QTest::newRow("lines without camera")
      << "lines|SAMPLE/Organs/kidney.obj|--size|64x64|-o|DIR/l.json" << 2 << "--camera";
  QTest::newRow("section of another side")
      << "render|SAMPLE|-o|DIR/a.png|--section|axial:left" << 2 << "inferior or superior";
  QTest::newRow("hatching without a section")
      << "render|SAMPLE|-o|DIR/a.png|--section-hatching" << 2 << "--section";
  QTest::newRow("unknown kind of lines")
      << "lines|SAMPLE/Organs/kidney.obj|--camera|DIR/front.json|--size|64x64|-o|DIR/l.json|"
         "--kinds|crease"
      << 2 << "crease";

  QTest::newRow("absent file") << "render|DIR/none.stl|-o|DIR/a.png" << 1 << "none.stl";
  QTest::newRow("broken file") << "render|DIR/broken.stl|-o|DIR/a.png" << 1 << "broken.stl";
  QTest::newRow("unsupported kind") << "info|DIR/notes.txt" << 1 << "notes.txt";
  QTest::newRow("folder without meshes") << "info|DIR/empty" << 1 << "empty";
  QTest::newRow("no such folder to write to")
      << "render|SAMPLE|-o|DIR/none/a.png|--size|64x64" << 1 << "none/a.png";
  QTest::newRow("a folder as output")
      << "curvature|SAMPLE/Organs/kidney.obj|-o|DIR/empty" << 1 << "folder";

  const QString exported = "export|--svg|DIR/a.svg|--size-mm|20x20|";
  // Inputs follow options that take several values, in every command that has them.
  const QString after = "|SAMPLE|--svg|DIR/a.svg|--size-mm|20x20";
  QTest::newRow("input after an ink") << "export|--ink-color|#30405a" + after << 0 << "";
  QTest::newRow("input after an ink of a name")
      << "export|--ink-colour|kidney=#30405a" + after << 0 << "";
  QTest::newRow("input after a focus") << "export|--focus|kidney" + after << 0 << "";
  QTest::newRow("input after what is swept")
      << "export|--sweep|kidney|SAMPLE|--gif|DIR/a.gif|--film-height|24|--seconds|0.2|--fps|10|"
         "--motion|gamma-sweep"
      << 0 << "";
  QTest::newRow("input after kinds of lines")
      << "lines|--kinds|contour|SAMPLE/Organs/kidney.obj|--camera|DIR/front.json|--size|64x64|"
         "-o|DIR/l.json"
      << 0 << "";
  QTest::newRow("absent input after an ink")
      << "export|--ink-color|#30405a|DIR/none.stl|--svg|DIR/a.svg" << 1 << "none.stl";

  for (const char* flag : {"--dpi", "--label-size", "--fps", "--seconds", "--film-height", "--hold",
                           "--size-mm", "--size-px", "--pen", "--gamma"})
    for (const char* number : {"nan", "inf", "-inf"})
      QTest::addRow("%s %s", flag, number)
          << exported.chopped(1).replace("|--size-mm|20x20", "") + "|SAMPLE|" + flag + "=" + number
          << 2 << number;
  QTest::newRow("no context") << exported + "SAMPLE|--focus|kidney|--context=nan" << 2 << "0 to 1";
  QTest::newRow("section nowhere") << exported + "SAMPLE|--section|axial=nan" << 2 << "nan";
  QTest::newRow("threshold of nothing") << "proof|SAMPLE|--threshold|nan" << 2 << "nan";
  QTest::newRow("decimated by nothing")
      << "import|SAMPLE|-o|DIR/a.sline|--decimate-mm|nan" << 2 << "nan";

  QTest::newRow("good") << render << 0 << "";
  QTest::newRow("good with all flags")
      << render +
             "|--view|superior|--gamma|1|--gamma|Vessels=4|--only|Vessels|--color|"
             "renal_artery=#ff0000|--fill|tint|--smooth|off|--frame|lps|--background|dark"
      << 0 << "";
  QTest::newRow("camera") << render + "|--camera|DIR/front.json" << 0 << "";
  QTest::newRow("a broken part") << "render|SAMPLE|DIR/broken.stl|-o|DIR/a.png|--size|64x64" << 0
                                 << "warning|broken.stl";
}

void ExitCodesTest::answers() {
  QFETCH(QString, arguments);
  QFETCH(int, code);
  QFETCH(QString, says);
  arguments.replace("SAMPLE", m_sample).replace("DIR", m_folder.path());
  const Finished finished = runSline(arguments.split('|', Qt::SkipEmptyParts));
  const QByteArray text = finished.out + finished.err;
  QVERIFY2(finished.code == code, "exit code " + QByteArray::number(finished.code) + ": " + text);
  for (const QString& part : says.split('|', Qt::SkipEmptyParts))
    QVERIFY2(text.contains(part.toUtf8()), text.constData());
  if (code != 0)
    QVERIFY2(!finished.err.isEmpty(), "a failure says why on standard error");
}

void ExitCodesTest::outputThatGoesNowhere_data() {
  QTest::addColumn<QString>("streams");
  QTest::addColumn<QString>("arguments");
  QTest::addColumn<bool>("tells");  // it prints something on standard output
  const QString scene = m_folder.filePath("labelled.sline");
  QCOMPARE(runSline({"import", m_sample, "-o", scene}).code, 0);
  for (const char* streams : {">&-", ">/dev/full", "<&- >&-"}) {
    const auto row = [&](const char* name, const QString& arguments, bool tells) {
      QTest::addRow("%s %s", name, streams) << streams << arguments << tells;
    };
    row("version", "--version", true);
    row("help", "export|--help", true);
    row("number of a label", "annotate|DIR/labelled.sline|--on|kidney", true);
    row("labels", "annotate|DIR/labelled.sline|--list", true);
    row("views", "view|DIR/labelled.sline|--list", true);
    row("info", "info|SAMPLE", true);
    row("plan", "import|SAMPLE|--plan", true);
    row("key of numbers",
        "render|DIR/labelled.sline|-o|DIR/n.png|--size|64x64|--labels|numbers|--only|kidney", true);
    row("measures", "steadiness|SAMPLE/Organs/kidney.obj|--frames|1|--size|32x32|--oversampling|1",
        true);
    row("a picture", "render|SAMPLE|-o|DIR/a.png|--size|64x64", false);
  }
}

void ExitCodesTest::outputThatGoesNowhere() {
  QFETCH(QString, streams);
  QFETCH(QString, arguments);
  QFETCH(bool, tells);
  if (streams.contains("/dev/full") && !QFile::exists("/dev/full"))
    QSKIP("this system has no device without space");
  arguments.replace("SAMPLE", m_sample).replace("DIR", m_folder.path());
  const Finished finished = runSlineLed(streams, arguments.split('|'));
  QVERIFY2(finished.code == (tells ? 1 : 0), finished.err.constData());
  QCOMPARE(finished.err.contains("standard output cannot be written"), tells);
  // No printed output went into a file that was written meanwhile.
  QCOMPARE(runSline({"info", m_folder.filePath("labelled.sline")}).code, 0);
}

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::ExitCodesTest)
#include "exit_codes_test.moc"
