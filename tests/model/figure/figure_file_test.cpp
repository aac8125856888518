// SPDX-License-Identifier: Apache-2.0
// Tests the file of a figure: what it says comes back, and what it says wrongly is refused with its
// place.
#include "model/figure/figure_file.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include "model/figure/figure_keys.h"
#include "model/figure/figure_layout.h"
#include "model/scene/scene_limits.h"
#include "tests/support/mutator.h"
#include "tests/support/suite.h"

namespace sline::test {

using namespace model;

namespace {

/// A figure in which every key says something unusual.
Figure fullFigure() {
  Figure figure{.widthMm = 120.0f,
                .heightMm = 200.0f,
                .gapMm = 5.0f,
                .columns = {1.0f, 2.0f},
                .rows = {1.0f, 0.5f, 1.0f},
                .scene = "pelvis.sline",
                .projection = FigureProjection::parallel,
                .sameScale = true,
                .letters = PanelLetters::upper,
                .letterPoints = 12.0f,
                .points = 8.0f,
                .language = "de+la",
                .labels = false,
                .scaleBars = false,
                .sides = false,
                .legend = FigureLegend::focus,
                .penPoints = 0.7f,
                .blackAndWhite = false,
                .leastPoints = 5.0f,
                .leastLine = 0.1f,
                .thinLines = ThinLines::refused};
  figure.panels = {
      {.view = "Front", .letter = "X", .camera = PanelCamera{.fit = true}},
      {.scene = "other/knee.sline",
       .view = "left",
       .camera = PanelCamera{.like = "X", .centred = true},
       .labels = true,
       .scaleBar = true,
       .sides = true},
      {.inset = PanelInset{.of = "X", .part = {{1, 2}, {8, 6}}, .lines = true}, .columns = 2},
      {.view = "Front", .at = FigureBox{{60, 150}, {50, 30}}},
      {.inset =
           PanelInset{
               .of = "X", .part = {{1, 2}, {8, 6}}, .inside = FigureBox{{10, 20}, {12, 11}}}},
      {.view = "left", .columns = 1, .rows = 1}};
  return figure;
}

std::string withPanel(const std::string& panel) {
  return R"({"sline_figure": 1, "scene": "a.sline", "panels": [{"view": "left"}, )" + panel + "]}";
}

}  // namespace

class FigureFileTest : public QObject {
  Q_OBJECT

 private slots:
  /// A view's name, or a letter, may be what a figure's file refuses; the file that was there
  /// stays.
  void onlyWhatCanBeReadIsWritten() {
    const QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath("figure.json").toStdString();
    QVERIFY(writeFigure(fullFigure(), file).ok());
    for (const std::string& name :
         {std::string("Front\nand back"), std::string(longestSceneName + 1, 'x')}) {
      Figure figure = fullFigure();
      figure.panels[0].view = name;
      const Status written = writeFigure(figure, file);
      QVERIFY(!written.ok());
      QCOMPARE(written.error().file, file.string());
      QVERIFY2(written.error().where.find("panels[0].view") != std::string::npos,
               written.error().text().c_str());
      QVERIFY(*readFigure(file) == fullFigure());
    }
    Figure longest = fullFigure();
    longest.panels[0].view = std::string(longestSceneName, 'x');
    QVERIFY(writeFigure(longest, file).ok() && *readFigure(file) == longest);
  }

  void allComesBack() {
    const Figure figure = fullFigure();
    const Result<Figure> again = figureFromText(figureText(figure));
    QVERIFY2(again.ok(), again.ok() ? "" : again.error().text().c_str());
    QVERIFY(*again == figure);
    QCOMPARE(figureText(*again), figureText(figure));
    // Every key is written that is unusual.
    const std::string text = figureText(figure);
    for (const FigureKeyNote& note : figureKeyNotes())
      if (std::string(note.id) != "black_and_white")
        QVERIFY2(text.find('"' + std::string(note.id) + '"') != std::string::npos, note.id);
  }

  void usualKeysAreLeftOut() {
    Figure figure;
    figure.panels = {{.view = "left"}};
    const std::string text = figureText(figure);
    QVERIFY(text.find("points") == std::string::npos && text.find("camera") == std::string::npos);
    const Result<Figure> again = figureFromText(text);
    QVERIFY(again.ok() && *again == figure);
  }

  void widthsOfJournals() {
    for (const auto& [said, mm] : {std::pair<const char*, float>{"\"single\"", 85.0f},
                                   {"\"middle\"", 114.0f},
                                   {"\"double\"", 174.0f},
                                   {"90.5", 90.5f}}) {
      const Result<Figure> figure = figureFromText(
          std::string(R"({"sline_figure": 1, "panels": [{}], "width": )") + said + "}");
      QVERIFY(figure.ok());
      QCOMPARE(figure->widthMm, mm);
    }
  }

  void wrongTexts_data() {
    QTest::addColumn<std::string>("text");
    QTest::addColumn<QString>("told");
    const auto row = [](const char* name, const std::string& text, const char* told) {
      QTest::newRow(name) << text << QString::fromUtf8(told);
    };
    const auto whole = [](const char* more) {
      return std::string(R"({"sline_figure": 1, "panels": [{"view": "left"}], )") + more + "}";
    };
    row("no JSON", "{", "Write the figure as JSON");
    row("a list", "[]", "an object is expected");
    row("nothing", "{}", "\"sline_figure\" is missing");
    row("no panels", R"({"sline_figure": 1})", "\"panels\" is missing");
    row("empty", R"({"sline_figure": 1, "panels": []})", "has no panels");
    row("newer", R"({"sline_figure": 2, "panels": [{}]})", "format 1");
    row(
        "many",
        R"({"sline_figure": 1, "panels": [)" + std::string(26 * 3, ' ') +
            [] {
              std::string panels = "{}";
              for (int i = 0; i < 26; ++i)
                panels += ",{}";
              return panels;
            }() +
            "]}",
        "at most 26");
    row("unknown key", whole(R"("legends": "all")"), "Near it: \"legend\"");
    row("unknown in panel", withPanel(R"({"wiew": "left"})"), "panels[1]: no key is called");
    row("unknown width", whole(R"("width": "triple")"), "\"double\"");
    row("narrow", whole(R"("width": 5)"), "a number from 20 to 1000");
    row("huge", whole(R"("width": 1e30)"), "a number from 20 to 1000");
    row("points", whole(R"("points": "8")"), "points: a number is expected");
    row("no weights", whole(R"("columns": [])"), "one to 12 weights");
    row("many columns", whole(R"("columns": 13)"), "from 1 to 12");
    row("zero weight", whole(R"("rows": [1, 0])"), "rows[1]: a number from 0.05");
    row("control", whole(R"("scene": "a\nb.sline")"), "control characters");
    row("letters", whole(R"("letters": "greek")"), "\"lower\", \"upper\" or \"none\"");
    row("like nobody", withPanel(R"({"camera": {"like": "q"}})"), "names panel \"q\"");
    row("like itself", withPanel(R"({"camera": {"like": "b"}})"), "panel b: its camera leads back");
    row("like and fit", withPanel(R"({"camera": {"like": "a", "fit": true}})"),
        "Leave \"fit\" out");
    row("centred alone", withPanel(R"({"camera": {"centred": true}})"), "Add \"like\"");
    row("no part", withPanel(R"({"inset": {"of": "a"}})"), "panels[1].inset");
    row("part outside", withPanel(R"({"inset": {"of": "a", "part": [80, 0, 20, 20]}})"),
        "over the edge of panel a");
    row("part of nobody", withPanel(R"({"inset": {"of": "z", "part": [0, 0, 20, 20]}})"),
        "names panel \"z\"");
    row("inset with a camera",
        withPanel(R"({"camera": {"fit": true}, "inset": {"of": "a", "part": [0, 0, 9, 9]}})"),
        "Leave \"camera\" out");
    row("two letters", withPanel(R"({"letter": "A"})"), "two panels have that letter");
    row("over another", withPanel(R"({"at": [10, 10, 40, 40]})"), "panel b: it lies over panel a");
    row("over the edge", withPanel(R"({"at": [160, 80, 40, 40]})"), "the page's edge");
    row("small", withPanel(R"({"at": [100, 80, 4, 40]})"), "narrower or lower than 10 mm");
    row("many columns for it", withPanel(R"({"columns": 3})"), "more columns than there are");
    row("legend without colours", whole(R"("legend": "all", "black_and_white": true)"),
        "ink alone has none");
  }
  void wrongTexts() {
    QFETCH(std::string, text);
    QFETCH(QString, told);
    const Result<Figure> figure = figureFromText(text);
    QVERIFY(!figure.ok());
    const QString error = QString::fromStdString(figure.error().text());
    QVERIFY2(error.contains(told), qPrintable(error));
    QVERIFY(!figure.error().remedy.empty());
  }

  /// Scenes lie in the figure's folder or below it, links followed.
  void scenesStayBelow() {
    const QTemporaryDir folder;
    QDir(folder.path()).mkpath("figures/sub");
    for (const char* name : {"outer.sline", "figures/a.sline", "figures/sub/b.sline"}) {
      QFile file(folder.filePath(name));
      QVERIFY(file.open(QIODevice::WriteOnly));
    }
    QVERIFY(QFile::link(folder.filePath("outer.sline"), folder.filePath("figures/link.sline")));
    const std::filesystem::path file = folder.filePath("figures/figure.json").toStdString();
    for (const char* fine : {"a.sline", "sub/b.sline", "sub/../a.sline"})
      QVERIFY2(scenePath(file, fine).ok(), fine);
    for (const char* wrong : {"../outer.sline", "/etc/passwd.sline", "link.sline", "a.obj", "",
                              "sub/../../outer.sline"})
      QVERIFY2(!scenePath(file, wrong).ok(), wrong);
    const Result<std::string> name =
        sceneName(file, folder.filePath("figures/sub/b.sline").toStdString());
    QVERIFY(name.ok());
    QCOMPARE(*name, std::string("sub/b.sline"));
    QVERIFY(!sceneName(file, folder.filePath("outer.sline").toStdString()).ok());
  }

  /// Whatever is changed in a file, it is read or refused with a reason.
  void changedFiles() {
    const std::string text = figureText(fullFigure());
    Mutator mutator(7, {});
    for (int i = 0; i < 3000; ++i) {
      const Result<Figure> figure =
          figureFromText(mutator(QByteArray::fromStdString(text)).toStdString());
      if (figure.ok())
        QVERIFY(checkFigure(*figure).ok());
      else
        QVERIFY(!figure.error().reason.empty());
    }
  }

  /// The guide tells every key.
  void guideTellsEveryKey() {
    QFile page(QStringLiteral(SLINE_HELP_PAGE));
    QVERIFY(page.open(QIODevice::ReadOnly));
    const QString text = QString::fromUtf8(page.readAll());
    for (const FigureKeyNote& note : figureKeyNotes())
      QVERIFY2(text.contains(QStringLiteral("`%1`").arg(QLatin1String(note.id))), note.id);
    const auto from = text.indexOf(QLatin1String("    {\n"));
    QVERIFY(from >= 0);
    const auto to = text.indexOf(QLatin1String("\n    }\n"), from);
    QVERIFY(to > from);
    const Result<Figure> example = figureFromText(text.mid(from, to + 7 - from).toStdString());
    QVERIFY2(example.ok(), example.ok() ? "" : example.error().text().c_str());
  }
};

}  // namespace sline::test

SLINE_TEST(sline::test::FigureFileTest)
#include "figure_file_test.moc"
