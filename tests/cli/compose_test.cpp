// SPDX-License-Identifier: Apache-2.0
// Tests `sline compose`: what it writes, what it refuses, and that files tell nothing else.
#include <QDir>
#include <QFile>
#include <QImage>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include "model/edit/views.h"
#include "model/scene/visible_structures.h"
#include "model/scene_file/scene_file.h"
#include "tests/cli/sline_process.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

QByteArray bytesOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

model::Scene twoBalls() {
  model::Scene scene;
  model::Node liver{.name = "liver & <b>\"", .mesh = sphere(30.0f, 3)};
  liver.provenance.credit.source = "Atlas of Balls";
  liver.provenance.credit.licence = "CC BY 4.0";
  scene.append(liver);
  scene.append({.name = "QZXHIDDEN",
                .style = {.visible = false},
                .mesh = moved(*sphere(10.0f, 2), 1.0f, {60, 0, 0})});
  model::View view;
  view.name = "QZXVIEW";
  view.camera = model::fittedView(scene, model::AnatomicalView::anterior, 1.3f);
  view.words.notes.text = "QZXNOTES";
  scene.setViews({view});
  return scene;
}

}  // namespace

class ComposeTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    QVERIFY(QDir(m_folder.path()).mkpath("qzxpath"));
    QVERIFY(model::writeSceneFile(path("a.sline").toStdString(), {.scene = twoBalls()}).ok());
  }

  /// SVG, PDF and PNG show the same page, of its width.
  void writesAllThree() {
    writeFile(path("figure.json"), m_figure);
    const Finished finished = runSline({"compose", path("figure.json"), "-o", path("f.svg"), "-o",
                                        path("f.pdf"), "-o", path("f.png"), "--dpi", "100"});
    QVERIFY2(finished.code == 0, finished.err.constData());
    const QImage picture(path("f.png"));
    QCOMPARE(picture.width(), 685);  // 174 mm
    QCOMPARE(qRound(picture.dotsPerMeterX() * 0.0254), 100);
    const QByteArray svg = bytesOf(path("f.svg"));
    QVERIFY(svg.contains("width=\"174mm\""));
    QXmlStreamReader reader(svg);
    QStringList ids;
    QStringList texts;
    while (!reader.atEnd())
      if (reader.readNext() == QXmlStreamReader::StartElement) {
        ids << reader.attributes().value("id").toString();
        if (reader.name() == QString("text"))
          texts << reader.readElementText(QXmlStreamReader::IncludeChildElements);
      }
    QVERIFY2(!reader.hasError(), qPrintable(reader.errorString()));
    for (const char* id : {"panel-1", "panel-2", "panel-3", "frames", "letters"})
      QVERIFY2(ids.contains(QLatin1String(id)), id);
    // No id stands twice, although panels show the same structures.
    ids.removeAll({});
    QCOMPARE(QSet<QString>(ids.begin(), ids.end()).size(), ids.size());
    for (const char* text : {"a", "b", "c", "R", "L", "liver & <b>\""})
      QVERIFY2(texts.contains(QLatin1String(text)), text);
    QVERIFY(bytesOf(path("f.pdf")).startsWith("%PDF"));
  }

  /// Files tell of no path, no view's name, no notes, nothing hidden, and the same each time.
  void tellsNothingElse() {
    writeFile(path("figure.json"), m_figure);
    for (const char* kind : {"svg", "pdf", "png"}) {
      const QString one = path("one.") + kind;
      const QString two = path("two.") + kind;
      for (const QString& target : {one, two}) {
        const Finished finished =
            runSline({"compose", path("figure.json"), "-o", target, "--dpi", "60"});
        QVERIFY2(finished.code == 0, finished.err.constData());
      }
      const QByteArray bytes = bytesOf(one);
      QVERIFY(!bytes.isEmpty());
      QCOMPARE(bytes, bytesOf(two));
      for (const char* marker : {"QZX", "qzxpath", "a.sline", "figure.json"})
        QVERIFY2(!bytes.contains(marker), marker);
    }
  }

  void creditTravels() {
    writeFile(path("figure.json"), m_figure);
    const Finished finished = runSline({"compose", path("figure.json"), "-o", path("c.svg"),
                                        "--author", "Jane <Doe>", "--copyright", "CC BY 4.0"});
    QVERIFY2(finished.code == 0, finished.err.constData());
    QVERIFY(bytesOf(path("c.svg")).contains("Jane &lt;Doe&gt;"));
    QVERIFY(bytesOf(path("c.svg")).contains("CC BY 4.0"));
  }

  /// Whose work the surfaces are and what the figure shows are said where it is asked for.
  void sourcesAndDescription() {
    writeFile(path("figure.json"), m_figure);
    Finished finished = runSline({"compose", path("figure.json"), "-o", path("c.svg"), "--credits",
                                  "line", "--alt", "Two livers and a part"});
    QVERIFY2(finished.code == 0, finished.err.constData());
    const QByteArray svg = bytesOf(path("c.svg"));
    QVERIFY(svg.count("Atlas of Balls, CC BY 4.0") >= 2);  // on the page and in its credit
    QVERIFY(svg.contains("Two livers and a part"));
    finished = runSline({"compose", path("figure.json"), "-o", path("c.svg")});
    QVERIFY2(finished.code == 0, finished.err.constData());
    QVERIFY(!bytesOf(path("c.svg")).contains("Atlas of Balls"));
  }

  /// TIFF has the page's pixels; black and white is ink or paper alone, in single bits if wanted.
  void printsLineArt() {
    QByteArray figure = m_figure;
    figure.replace("\"legend\": \"all\"", "\"black_and_white\": true, \"same_scale\": true");
    writeFile(path("ink.json"), figure);
    const Finished finished = runSline({"compose", path("ink.json"), "-o", path("ink.png"), "-o",
                                        path("ink.tiff"), "--dpi", "100", "--bits", "1"});
    QVERIFY2(finished.code == 0, finished.err.constData());
    const QImage ink(path("ink.png"));
    QCOMPARE(ink.format(), QImage::Format_Mono);
    QCOMPARE(ink.width(), 685);
    const QByteArray tiff = bytesOf(path("ink.tiff"));
    QVERIFY(tiff.startsWith(QByteArray("II*\0", 4)) && tiff.size() < 685 * 520 / 8 + 20'000);
    writeFile(path("figure.json"), m_figure);
    const Finished refused =
        runSline({"compose", path("figure.json"), "-o", path("no.png"), "--bits", "1"});
    QCOMPARE(refused.code, 2);
    QVERIFY2(refused.err.contains("black and white"), refused.err.constData());
    QVERIFY(!QFile::exists(path("no.png")));
  }

  void refuses_data() {
    QTest::addColumn<QByteArray>("figure");
    QTest::addColumn<QString>("target");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("told");
    const auto with = [this](const char* more) {
      QByteArray figure = m_figure;
      return figure.replace("\"panels\"", QByteArray(more) + ", \"panels\"");
    };
    const auto row = [](const char* name, const QByteArray& figure, const char* target, int code,
                        const char* told) {
      QTest::newRow(name) << figure << target << code << QString::fromUtf8(told);
    };
    row("small letters", with("\"points\": 5"), "r.svg", 1,
        "panel a: \"1 cm at mid-depth\" is set in 4 pt, and letters smaller than 6 pt are refused");
    row("thin lines", with("\"pen\": 0.15, \"thin_lines\": \"refused\""), "r.svg", 1,
        "lines thinner than 0.25 pt are refused");
    row("kind of file", m_figure, "r.gif", 2, "a figure is a pdf, svg, png or tiff file");
    row("over its scene", m_figure, "a.sline", 2, "pdf, svg, png or tiff");
    row("unknown key", with("\"colour\": 1"), "r.svg", 1, "no key is called \"colour\"");
    QByteArray elsewhere = m_figure;
    row("scene elsewhere", elsewhere.replace("a.sline", "../a.sline"), "r.svg", 1,
        "does not lie in the figure's folder");
    QByteArray absent = m_figure;
    row("no scene", absent.replace("a.sline", "b.sline"), "r.svg", 1, "b.sline");
    QByteArray view = m_figure;
    row("no view", view.replace("QZXVIEW", "QZXVEW"), "r.svg", 1, "Near it: \"QZXVIEW\"");
  }
  void refuses() {
    QFETCH(QByteArray, figure);
    QFETCH(QString, target);
    QFETCH(int, code);
    QFETCH(QString, told);
    writeFile(path("refused.json"), figure);
    const QByteArray scene = bytesOf(path("a.sline"));
    const Finished finished = runSline({"compose", path("refused.json"), "-o", path(target)});
    QCOMPARE(finished.code, code);
    QVERIFY2(finished.err.contains(told.toUtf8()), finished.err.constData());
    QVERIFY(!QFile::exists(path("r.svg")));
    QCOMPARE(bytesOf(path("a.sline")), scene);
  }

  void helpListsKeys() {
    const Finished finished = runSline({"compose", "--help"});
    QCOMPARE(finished.code, 0);
    for (const char* key : {"least_points", "scale_bar", "centred", "inside"})
      QVERIFY2(finished.out.contains(key), key);
  }

 private:
  QString path(const QString& name) const { return m_folder.filePath("qzxpath/" + name); }

  QTemporaryDir m_folder;
  const QByteArray m_figure =
      R"({"sline_figure": 1, "scene": "a.sline", "legend": "all",
          "panels": [{"view": "QZXVIEW"}, {"view": "left", "camera": {"like": "a"}},
                     {"inset": {"of": "a", "part": [30, 20, 20, 15], "lines": true}}]})";
};

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::ComposeTest)
#include "compose_test.moc"
