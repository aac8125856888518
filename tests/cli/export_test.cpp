// SPDX-License-Identifier: Apache-2.0
#include <QDir>
#include <QFile>
#include <QImage>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include "tests/cli/sline_process.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

QByteArray contents(const QString& file) {
  QFile source(file);
  return source.open(QIODevice::ReadOnly) ? source.readAll() : QByteArray();
}

/// Returns the labels of the groups with an id, in order; empty if the document is not well-formed.
QStringList labels(const QByteArray& svg) {
  QXmlStreamReader reader(svg);
  QStringList found;
  while (!reader.atEnd())
    if (reader.readNext() == QXmlStreamReader::StartElement && reader.name() == QString("g") &&
        reader.attributes().hasAttribute("id"))
      found << reader.attributes()
                   .value("http://www.inkscape.org/namespaces/inkscape", "label")
                   .toString();
  return reader.hasError() ? QStringList() : found;
}

}  // namespace

class ExportTest : public QObject {
  Q_OBJECT

 private slots:
  void writesGroupsAndPage();
  void optionsReachTheDrawing();
  void techniquesAreLayers();
  void sectionsAndViews();
  void theViewsNameIsTrue();
  void labelsAndMarks();
  void pathsStayOnThePage();
  void wrongUse_data();
  void wrongUse();
  void badTargets_data();
  void badTargets();
  void tellsNothingElse();
  void keysOfGamma();
  void legends_data();
  void legends();
  void films();
  void subtitles();
  void surfacesAndCards();

 private:
  /// Exports the sample; returns nothing if that failed.
  QByteArray exported(const QStringList& flags);
  QTemporaryDir m_folder;
  QString m_sample = writeSample(m_folder.path());
};

QByteArray ExportTest::exported(const QStringList& flags) {
  const QString file = m_folder.filePath("drawing.svg");
  QFile::remove(file);
  const Finished finished = runSline(QStringList{"export", m_sample, "--svg", file} + flags);
  if (finished.code != 0)
    qWarning("%s", finished.err.constData());
  return finished.code == 0 ? contents(file) : QByteArray();
}

void ExportTest::writesGroupsAndPage() {
  const QByteArray svg =
      exported({"--size-mm", "180x120", "--gamma", "1", "--line-variation", "0"});
  QVERIFY(svg.contains("width=\"180mm\" height=\"120mm\" viewBox=\"0 0 180 120\""));
  const QStringList found = labels(svg);
  QCOMPARE(found.first(), QString("Lines"));
  QCOMPARE(found.last(), QString("Marks"));
  QCOMPARE(found.size(), 7);
  for (const char* name : {"Organs", "kidney", "Vessels", "renal artery", "renal vein"})
    QVERIFY2(found.contains(name), name);
  QVERIFY(found.indexOf("renal vein") > found.indexOf("Vessels"));
  // An even pen has a usual width: 2/720 of the page's height.
  static const QRegularExpression width("stroke-width=\"([0-9.]+)\"");
  const double pen = width.match(QString::fromUtf8(svg)).captured(1).toDouble();
  QVERIFY2(std::abs(pen - 2.0 * 120.0 / 720.0) < 0.03, qPrintable(QString::number(pen)));
}

void ExportTest::optionsReachTheDrawing() {
  QVERIFY(exported({}).contains("fill=\"#ffffff\""));
  QVERIFY(exported({"--background", "paper"}).contains("fill=\"#faf6ec\""));
  QVERIFY(!exported({"--background", "transparent"}).contains("id=\"background\""));
  QVERIFY(exported({"--ink-color", "#30405a"}).contains("#30405a"));
  QVERIFY(!labels(exported({"--only", "kidney"})).contains("renal vein"));
  QVERIFY(labels(exported({"--gamma", "5"})).contains("Fills"));
  QVERIFY(exported({"--from", "posterior"}) != exported({}));
  // The drawing has black ink alone.
  static const QRegularExpression colour("(?:fill|stroke)=\"(#[0-9a-f]{6})\"");
  auto colours = colour.globalMatch(QString::fromUtf8(exported({"--gamma", "4", "--bw"})));
  while (colours.hasNext()) {
    const QString one = colours.next().captured(1);
    QVERIFY2(one == "#000000" || one == "#ffffff", qPrintable(one));
  }
}

void ExportTest::techniquesAreLayers() {
  const QString ring = m_folder.filePath("ring.obj");
  writeObj(ring, *torus(40.0f, 15.0f, 120, 48));
  const auto drawn = [&](const QStringList& flags) {
    const QString file = m_folder.filePath("ring.svg");
    QFile::remove(file);
    runSline(QStringList{"export", ring, "--svg", file, "--gamma", "3", "--from", "superior"} +
             flags);
    return contents(file);
  };
  const QByteArray usual = drawn({});
  QVERIFY(usual.contains("\"Contours\"") && usual.contains("\"Hatching\""));
  QVERIFY(!usual.contains("\"ConFIS\""));
  const QByteArray streamlines = drawn({"--technique", "ring=confis"});
  QCOMPARE(streamlines.count("\"ConFIS\""), 1);
  QVERIFY(streamlines.contains("\"Contours\""));
  QVERIFY(!streamlines.contains("\"Hatching\"") &&
          !streamlines.contains("\"Suggestive contours\""));
  QCOMPARE(runSline({"export", ring, "--svg", "x.svg", "--technique", "fur"}).code, 2);
}

void ExportTest::sectionsAndViews() {
  const QByteArray cut = exported({"--section", "coronal", "--section-hatching"});
  QVERIFY(cut.contains("Cut outlines"));
  QVERIFY(labels(cut).contains("Fills"));
  QVERIFY(!exported({}).contains("Cut outlines"));
  // What the kidney is made of has a layer too, unless it is not asked for.
  QVERIFY(cut.contains("Cut tissue"));
  QVERIFY(!exported({"--section", "coronal", "--section-faces", "tint"}).contains("Cut tissue"));
}

/// A side is named only where the camera sees it, whatever a view or a flag is called.
void ExportTest::theViewsNameIsTrue() {
  const QString camera = m_folder.filePath("camera.json");
  writeFile(camera, frontCamera());
  QVERIFY(exported({"--camera", camera}).contains("Anterior view"));
  writeFile(camera, QByteArray(frontCamera()).replace("-400", "400"));
  QVERIFY(exported({"--camera", camera}).contains("Posterior view"));
  writeFile(camera, QByteArray(frontCamera()).replace("[0,-400,0]", "[200,-400,0]"));
  QVERIFY(!exported({"--camera", camera}).contains("view<"));
  const QString scene = m_folder.filePath("views.sline");
  QCOMPARE(runSline({"import", m_sample, "-o", scene}).code, 0);
  const Finished hidden = runSline({"view", scene, "--add", "Anterior", "--from", "posterior"});
  QCOMPARE(hidden.code, 0);
  QVERIFY2(hidden.err.contains("--view Anterior shows this saved view"), hidden.err.constData());
  QCOMPARE(runSline({"view", scene, "--add", "Urinary System"}).code, 0);
  const QString file = m_folder.filePath("views.svg");
  QCOMPARE(runSline({"export", scene, "--svg", file, "--view", "anterior"}).code, 0);
  QVERIFY(contents(file).contains("Posterior view"));
  QCOMPARE(runSline({"export", scene, "--svg", file, "--view", "urinary_system"}).code, 0);
  QVERIFY(contents(file).contains(">Urinary System<"));
}

/// Labels and marks are text in layers of their own; a name is text whatever it looks like.
void ExportTest::labelsAndMarks() {
  const QString scene = m_folder.filePath("labelled.sline");
  QCOMPARE(runSline({"import", m_sample, "--sides", "right", "-o", scene}).code, 0);
  const QString name = "<b>Nephros</b> & \"νεφρός\"";
  QCOMPARE(runSline({"annotate", scene, "--label", name, "--on", "kidney"}).code, 0);
  const QString file = m_folder.filePath("labelled.svg");
  // Texts need no flag, as in the window.
  QCOMPARE(runSline({"export", scene, "--svg", file}).code, 0);
  QXmlStreamReader reader(contents(file));
  QStringList texts;
  while (!reader.atEnd())
    if (reader.readNext() == QXmlStreamReader::StartElement && reader.name() == QString("text"))
      texts << reader.readElementText(QXmlStreamReader::IncludeChildElements);
  QVERIFY(!reader.hasError());
  QString label;
  for (const QString& text : texts)
    if (text.contains("Nephros"))
      label = text;
  QCOMPARE(QString(label).remove(' '), QString(name).remove(' '));
  for (const char* mark : {"R", "L", "S", "I", "Anterior view"})
    QVERIFY2(texts.contains(mark), mark);
  QVERIFY(labels(contents(file)).contains("Labels"));
  QVERIFY(contents(file).contains("font-family=\"DejaVu Sans,"));
  const QStringList bare{"export", scene, "--svg", file, "--labels", "off", "--marks"};
  QCOMPARE(runSline(bare + QStringList{"off"}).code, 0);
  QVERIFY(!contents(file).contains("<text"));
  QCOMPARE(runSline(bare + QStringList{"sides,scale"}).code, 0);
  QCOMPARE(contents(file).count("<text"), 5);
}

/// The camera is so near that the drawing goes on beside the page.
void ExportTest::pathsStayOnThePage() {
  const QString camera = m_folder.filePath("near.json");
  writeFile(camera, QByteArray(frontCamera()).replace("\"fovy_deg\":30", "\"fovy_deg\":6"));
  const QByteArray svg = exported(
      {"--camera", camera, "--gamma", "kidney=5", "--gamma", "Vessels=1", "--marks", "off"});
  static const QRegularExpression path(
      "<path[^>]*?(?: stroke-width=\"([0-9.]+)\")?[^>]* d=\"([^\"]+)\"");
  static const QRegularExpression step("([MlcZz])|(-?[0-9]*\\.?[0-9]+)");
  int curves = 0;
  auto all = path.globalMatch(QString::fromUtf8(svg));
  while (all.hasNext()) {
    const QRegularExpressionMatch one = all.next();
    const double beyond = 0.5 * one.captured(1).toDouble() + 0.3;
    QPointF at;
    QChar letter;
    QList<double> numbers;
    auto steps = step.globalMatch(one.captured(2));
    while (steps.hasNext()) {
      const QRegularExpressionMatch part = steps.next();
      if (!part.captured(1).isEmpty()) {
        letter = part.captured(1)[0];
        curves += letter == 'M';
        numbers.clear();
        continue;
      }
      numbers << part.captured(2).toDouble();
      const qsizetype needed = letter == 'c' ? 6 : 2;
      if (numbers.size() < needed)
        continue;
      const QPointF end(numbers[needed - 2], numbers[needed - 1]);
      at = letter == 'M' ? end : at + end;
      numbers.clear();
      QVERIFY2(QRectF(0, 0, 160, 90).adjusted(-beyond, -beyond, beyond, beyond).contains(at),
               qPrintable(QString("%1, %2").arg(at.x()).arg(at.y())));
    }
  }
  QVERIFY2(curves >= 3, qPrintable(QString::number(curves)));
}

void ExportTest::wrongUse_data() {
  QTest::addColumn<QStringList>("flags");
  QTest::addColumn<QByteArray>("says");
  const QString svg = m_folder.filePath("wrong.svg");
  QTest::newRow("no target") << QStringList{} << QByteArray("--svg");
  QTest::newRow("no size") << QStringList{"--svg", svg, "--size-mm", "large"}
                           << QByteArray("160x90");
  QTest::newRow("too small") << QStringList{"--svg", svg, "--size-mm", "5x90"}
                             << QByteArray("10 to 5000");
  QTest::newRow("not a number") << QStringList{"--svg", svg, "--size-mm", "nanx90"}
                                << QByteArray("10 to 5000");
  QTest::newRow("unknown view") << QStringList{"--svg", svg, "--view", "askance"}
                                << QByteArray("anterior");
  QTest::newRow("unknown name") << QStringList{"--svg", svg, "--only", "heart"}
                                << QByteArray("heart");
  QTest::newRow("grey hatching") << QStringList{"--svg", svg, "--hatching", "as-printed"}
                                 << QByteArray("sline render");
  QTest::newRow("unknown mark") << QStringList{"--svg", svg, "--marks", "sides,north"}
                                << QByteArray("sections");
  QTest::newRow("unknown sheet") << QStringList{"--pdf", svg, "--sheet", "poster"}
                                 << QByteArray("teaching");
  QTest::newRow("unknown paper") << QStringList{"--pdf", svg, "--sheet", "figure", "--paper", "a3"}
                                 << QByteArray("letter");
  QTest::newRow("a text for teachers")
      << QStringList{"--pdf", svg, "--sheet", "teaching", "--text", "Hello"}
      << QByteArray("patient");
}

void ExportTest::wrongUse() {
  QFETCH(QStringList, flags);
  QFETCH(QByteArray, says);
  const Finished finished = runSline(QStringList{"export", m_sample} + flags);
  QCOMPARE(finished.code, 2);
  QVERIFY2(finished.err.contains(says), finished.err.constData());
  QVERIFY(!QFile::exists(m_folder.filePath("wrong.svg")));
}

void ExportTest::badTargets_data() {
  QTest::addColumn<QString>("target");
  QTest::newRow("no such folder") << m_folder.filePath("nowhere/drawing.svg");
  QTest::newRow("a folder") << m_folder.filePath("sample");
  QTest::newRow("no space") << "/dev/full";
  QTest::newRow("below a file") << m_folder.filePath("sample/Organs/kidney.obj/drawing.svg");
  QTest::newRow("name too long") << m_folder.filePath(QString(300, 'x') + ".svg");
}

void ExportTest::badTargets() {
  QFETCH(QString, target);
  if (target == "/dev/full" && !QFile::exists(target))
    QSKIP("this system has no device without space");
  const QStringList before = QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::Hidden);
  for (const char* kind : {"--svg", "--pdf"}) {
    const QString named = QString(target).replace(".svg", QString(kind).replace("--", "."));
    const Finished finished = runSline({"export", m_sample, kind, named});
    QCOMPARE(finished.code, 1);
    QVERIFY(finished.err.startsWith("sline: "));
    QCOMPARE(QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::Hidden), before);
  }
}

void ExportTest::tellsNothingElse() {
  QTemporaryDir planted(QDir::tempPath() + "/planted-marker-XXXXXX");
  const QString source = planted.filePath("Patient-4711.obj");
  writeObj(source, *sphere(10.0f, 3), "heart");
  const QString target = planted.filePath("out.svg");
  QCOMPARE(runSline({"export", source, "--svg", target}).code, 0);
  const QByteArray svg = contents(target);
  QVERIFY(!svg.isEmpty());
  QVERIFY(!svg.contains("planted-marker"));
  QVERIFY(!svg.contains(".obj"));
  QVERIFY(!svg.contains("/tmp"));
  for (const char* variable : {"USER", "HOME", "HOSTNAME", "LOGNAME"})
    if (const QByteArray value = qgetenv(variable); value.size() > 3)
      QVERIFY2(!svg.contains(value), variable);
  // The file is the same each time: no date, no random number.
  const QString again = planted.filePath("again.svg");
  QCOMPARE(runSline({"export", source, "--svg", again}).code, 0);
  QCOMPARE(contents(again), svg);
}

void ExportTest::legends_data() {
  QTest::addColumn<QStringList>("flags");
  QTest::addColumn<QStringList>("listed");
  QTest::newRow("none said") << QStringList{} << QStringList{};
  QTest::newRow("none") << QStringList{"--legend", "none"} << QStringList{};
  QTest::newRow("all") << QStringList{"--legend", "all"}
                       << QStringList{"kidney", "renal artery", "renal vein"};
  QTest::newRow("labelled") << QStringList{"--legend", "labelled"} << QStringList{"renal vein"};
  QTest::newRow("focus") << QStringList{"--legend", "focus", "--focus", "kidney"}
                         << QStringList{"kidney"};
  QTest::newRow("in German") << QStringList{"--legend", "labelled", "--language", "de"}
                             << QStringList{"renal vein"};
}

/// Where Γ varies over surfaces, a drawing says by what.
void ExportTest::keysOfGamma() {
  const QString file = m_folder.filePath("keys.svg");
  const auto drawn = [&](const QStringList& flags) {
    const Finished finished = runSline(QStringList{"export", m_sample, "--svg", file} + flags);
    return finished.code == 0 ? contents(file) : finished.err;
  };
  QVERIFY(!drawn({}).contains("gamma: "));
  const QByteArray key = drawn({"--gamma-by", "kidney=distance:renal artery", "--language", "de"});
  QVERIFY(key.contains("gamma: Abstand von: "));
  QVERIFY(key.contains("\"gamma 6\""));
  QVERIFY(drawn({"--focus-near", "kidney"}).contains("gamma: Distance from kidney (mm)"));
  QVERIFY(drawn({"--focus-near", "1,2,3"}).contains("gamma: Distance from a place (mm)"));
  QVERIFY(!drawn({"--focus-near", "kidney", "--marks", "sides"}).contains("gamma: "));
}

void ExportTest::legends() {
  QFETCH(QStringList, flags);
  QFETCH(QStringList, listed);
  const QString scene = m_folder.filePath("legend.sline");
  QFile::remove(scene);
  QCOMPARE(runSline({"import", m_sample, "-o", scene}).code, 0);
  QCOMPARE(runSline({"annotate", scene, "--label", "the vein", "--on", "renal vein"}).code, 0);
  const QString file = m_folder.filePath("legend.svg");
  const Finished finished = runSline(QStringList{"export", scene, "--svg", file} + flags);
  QVERIFY2(finished.code == 0, finished.err.constData());
  const QByteArray svg = contents(file);
  QStringList found;
  for (const char* name : {"kidney", "renal artery", "renal vein"})
    if (svg.contains(QByteArray("legend: ") + name + '"'))
      found << name;
  QCOMPARE(found, listed);
  if (flags.contains("de"))
    QVERIFY(svg.contains("Nierenvene"));
}

void ExportTest::films() {
  const QStringList small{"--film-height", "36", "--seconds", "0.2", "--fps", "10"};
  const QStringList flags = QStringList{"export", m_sample} + small;
  const QString webp = m_folder.filePath("film.WEBP");
  QCOMPARE(runSline(flags + QStringList{"--video", webp}).code, 0);
  QVERIFY(contents(webp).startsWith("RIFF"));
  const QString gif = m_folder.filePath("film.gif");
  const QString frames = m_folder.filePath("frames");
  QCOMPARE(runSline(flags + QStringList{"--video", gif, "--frames", frames, "--motion",
                                        "gamma-sweep", "--sweep", "kidney"})
               .code,
           0);
  QVERIFY(contents(gif).startsWith("GIF89a"));
  QCOMPARE(QDir(frames).entryList(QDir::Files), QStringList({"frame_0001.png", "frame_0002.png"}));
  for (const auto& [wrong, says] :
       {std::pair<QStringList, QByteArray>({"--video", m_folder.filePath("film.avi")}, "mp4, webp"),
        {{"--video", webp, "--motion", "dance"}, "gamma-sweep"},
        {{"--video", webp, "--motion", "gamma-sweep", "--sweep", "heart"}, "heart"},
        {{"--video", webp, "--sweep", "kidney"}, "gamma-sweep"},
        {{"--video", webp, "--hold", "long"}, "0 to 600"}}) {
    const Finished finished = runSline(flags + wrong);
    QCOMPARE(finished.code, 2);
    QVERIFY2(finished.err.contains(says), finished.err.constData());
  }
  // Pixels are as they were asked for, whatever the page beside them is.
  for (const auto& [size, pixels] :
       {std::pair("square", QSize(1080, 1080)), std::pair("64x36", QSize(64, 36)),
        std::pair("1280x720", QSize(1280, 720)), std::pair("1920x1080", QSize(1920, 1080))}) {
    const QString folder = m_folder.filePath(QString("size ") + size);
    const Finished sized = runSline({"export", m_sample, "--frames", folder, "--film-size", size,
                                     "--size-mm", "50x80", "--seconds", "0.1", "--fps", "10"});
    QVERIFY2(sized.code == 0, sized.err.constData());
    QCOMPARE(QImage(QDir(folder).filePath(QDir(folder).entryList(QDir::Files).first())).size(),
             pixels);
  }
  const Finished unsized = runSline(flags + QStringList{"--video", webp, "--film-size", "huge"});
  QCOMPARE(unsized.code, 2);
  QVERIFY2(unsized.err.contains("--film-size huge is unknown"), unsized.err.constData());
  const Finished tour = runSline(flags + QStringList{"--video", webp, "--motion", "tour"});
  QCOMPARE(tour.code, 1);
  QVERIFY2(tour.err.contains("no saved views"), tour.err.constData());
}

/// What views say is a WebVTT file beside the film only where it is wanted.
void ExportTest::subtitles() {
  const QString scene = m_folder.filePath("said.sline");
  QCOMPARE(runSline({"import", m_sample, "-o", scene}).code, 0);
  QCOMPARE(runSline({"view", scene, "--add", "Front", "--text", "From the front"}).code, 0);
  QCOMPARE(runSline({"view", scene, "--add", "Left", "--from", "left"}).code, 0);
  const QStringList flags{"export",      scene,
                          "--motion",    "tour",
                          "--seconds",   "1",
                          "--fps",       "4",
                          "--film-size", "160x90",
                          "--webp",      m_folder.filePath("said.webp"),
                          "--frames",    m_folder.filePath("said frames")};
  QCOMPARE(runSline(flags).code, 0);
  QVERIFY(!QFile::exists(m_folder.filePath("said.vtt")));
  QVERIFY(QDir(m_folder.filePath("said frames")).removeRecursively());
  QCOMPARE(runSline(flags + QStringList{"--subtitles"}).code, 0);
  const QByteArray beside = contents(m_folder.filePath("said.vtt"));
  QCOMPARE(beside, QByteArray("WEBVTT\n\n00:00:00.000 --> 00:00:00.500\nFrom the front\n"));
  QCOMPARE(contents(m_folder.filePath("said frames/subtitles.vtt")), beside);
  const Finished silent = runSline({"export", scene, "--motion", "turntable", "--seconds", "1",
                                    "--fps", "2", "--film-size", "160x90", "--webp",
                                    m_folder.filePath("silent.webp"), "--subtitles"});
  QVERIFY2(silent.code != 0 || silent.err.contains("subtitles are empty"), silent.err.constData());
}

void ExportTest::surfacesAndCards() {
  const QString glb = m_folder.filePath("sample.glb");
  QCOMPARE(runSline({"export", m_sample, "--glb", glb}).code, 0);
  QVERIFY(contents(glb).startsWith("glTF"));
  QVERIFY(contents(glb).contains("renal vein"));
  QVERIFY(!contents(glb).contains(".obj"));
  const QString scene = m_folder.filePath("labelled.sline");
  QCOMPARE(runSline({"import", m_sample, "--sides", "right", "-o", scene}).code, 0);
  QCOMPARE(runSline({"annotate", scene, "--on", "kidney", "--on", "renal vein"}).code, 0);
  const QString deck = m_folder.filePath("deck");
  QCOMPARE(
      runSline({"export", scene, "--anki", deck, "--deck", "Niere", "--size-mm", "100x60"}).code,
      0);
  const QByteArray text = contents(deck + "/deck.txt");
  QVERIFY(text.contains("#deck column:5\n") && text.contains("\tNiere\n"));
  // The picture, and over it each name, each mark and the numbers.
  QCOMPARE(QDir(deck).entryList({"*.png"}).size(), 6);
  const Finished bare = runSline({"export", m_sample, "--anki", m_folder.filePath("none.apkg")});
  QCOMPARE(bare.code, 1);
  QVERIFY2(bare.err.contains("no labels"), bare.err.constData());
}

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::ExportTest)
#include "export_test.moc"
