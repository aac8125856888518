// SPDX-License-Identifier: Apache-2.0
// Tests where panels lie on a page, which letters they have, and that edits keep what refers to
// them.
#include "model/figure/figure_layout.h"

#include <QtTest>

#include "model/figure/figure_edit.h"
#include "tests/support/suite.h"

namespace sline::test {

using namespace model;

namespace {

Figure figureWith(std::size_t panels) {
  Figure figure{.widthMm = 100.0f, .gapMm = 4.0f, .scene = "a.sline"};
  figure.panels.resize(panels);
  return figure;
}

bool near(const FigureBox& a, const FigureBox& b) {
  const glm::vec2 at = a.at - b.at;
  const glm::vec2 size = a.size - b.size;
  return std::abs(at.x) + std::abs(at.y) + std::abs(size.x) + std::abs(size.y) < 0.01f;
}

}  // namespace

class FigureLayoutTest : public QObject {
  Q_OBJECT

 private slots:
  void gridWithWeights() {
    Figure figure = figureWith(3);
    figure.columns = {1.0f, 2.0f};
    figure.rows = {2.0f, 1.0f};
    figure.heightMm = 64.0f;
    const Result<FigureLayout> layout = layOut(figure);
    QVERIFY(layout.ok());
    QVERIFY(near(layout->panels[0].box, {{0, 0}, {32, 40}}));
    QVERIFY(near(layout->panels[1].box, {{36, 0}, {64, 40}}));
    QVERIFY(near(layout->panels[2].box, {{0, 44}, {32, 20}}));
    QCOMPARE(layout->sizeMm, glm::vec2(100.0f, 64.0f));
  }

  void spansAndFreeCells() {
    Figure figure = figureWith(4);
    figure.columns = {1.0f, 1.0f, 1.0f};
    figure.panels[0].columns = 2;
    figure.panels[0].rows = 2;
    const Result<FigureLayout> layout = layOut(figure);
    QVERIFY(layout.ok());
    QVERIFY(layout->panels[1].box.at.x > 60.0f && layout->panels[1].box.at.y == 0.0f);
    QVERIFY(layout->panels[2].box.at.x > 60.0f && layout->panels[2].box.at.y > 0.0f);
    QCOMPARE(layout->panels[3].box.at.x, 0.0f);
  }

  void usualHeightAndLegend() {
    const Figure figure = figureWith(4);
    const Result<FigureLayout> bare = layOut(figure);
    const Result<FigureLayout> legend = layOut(figure, 11.0f);
    QVERIFY(bare.ok() && legend.ok());
    // 4 by 3, two rows, a gap.
    QVERIFY(std::abs(bare->sizeMm.y - (2.0f * 36.0f + 4.0f)) < 0.01f);
    QVERIFY(std::abs(legend->sizeMm.y - bare->sizeMm.y - 15.0f) < 0.01f);
    QVERIFY(near(legend->panels[3].box, bare->panels[3].box));
    QVERIFY(near(legend->legend, {{0, legend->sizeMm.y - 11.0f}, {100, 11}}));
    // In a page of a given height the panels make room.
    Figure fixed = figure;
    fixed.heightMm = 80.0f;
    const Result<FigureLayout> low = layOut(fixed, 11.0f);
    QVERIFY(low.ok());
    QVERIFY(std::abs(low->panels[3].box.end().y - 65.0f) < 0.01f);
  }

  void letters() {
    Figure figure = figureWith(4);
    figure.panels[1].inset =
        PanelInset{.of = "a", .part = {{1, 1}, {9, 9}}, .inside = FigureBox{{20, 10}, {12, 12}}};
    figure.panels[2].letter = "";
    QCOMPARE(lettersOf(figure), (std::vector<std::string>{"a", "", "", "b"}));
    figure.letters = PanelLetters::upper;
    QCOMPARE(lettersOf(figure), (std::vector<std::string>{"A", "", "", "B"}));
    QVERIFY(layOut(figure).ok());  // "of" is written either way
    figure.letters = PanelLetters::none;
    const Result<FigureLayout> layout = layOut(figure);
    QVERIFY(layout.ok());
    QVERIFY(layout->panels[0].letter.empty());
    QCOMPARE(panelName(figure, 1), std::string("panel 2, an inset of a"));
  }

  void followersComeLater() {
    Figure figure = figureWith(4);
    figure.panels[0].camera = PanelCamera{.like = "c"};
    figure.panels[2].camera = PanelCamera{.like = "d"};
    const Result<FigureLayout> layout = layOut(figure);
    QVERIFY(layout.ok());
    const auto place = [&](std::size_t panel) {
      return std::find(layout->order.begin(), layout->order.end(), panel) - layout->order.begin();
    };
    QVERIFY(place(3) < place(2) && place(2) < place(0));
  }

  void editsKeepLinks() {
    Figure figure = figureWith(3);
    figure.panels[0].view = "one";
    figure.panels[1].view = "two";
    figure.panels[2].camera = PanelCamera{.like = "b"};
    figure = withInset(figure, 1, {{2, 2}, {10, 8}});
    QCOMPARE(figure.panels[3].inset->of, std::string("b"));
    // Two becomes the first: what was like b is like a.
    const Figure moved = withPanelMoved(figure, 1, 0);
    QCOMPARE(moved.panels[0].view, std::string("two"));
    QCOMPARE(moved.panels[2].camera->like, std::string("a"));
    QCOMPARE(moved.panels[3].inset->of, std::string("a"));
    QVERIFY(checkFigure(moved).ok());
    // Without it, its inset is gone and the camera is the panel's own.
    const Figure less = withoutPanel(figure, 1);
    QCOMPARE(less.panels.size(), std::size_t(2));
    QVERIFY(!less.panels[1].camera);
    QVERIFY(checkFigure(less).ok());
    QCOMPARE(camerasFor(figure, 1), std::vector<std::size_t>{0});
  }

  void noMoreThanLetters() {
    Figure figure = figureWith(mostPanels);
    QCOMPARE(withPanel(figure, {}).panels.size(), mostPanels);
    QVERIFY(checkFigure(figure).ok());
  }

  void figureOfViews() {
    Scene scene;
    QCOMPARE(figureOf(scene, "a.sline").panels.size(), std::size_t(2));
    scene.setViews({{.name = "One"}, {.name = "Two"}, {.name = "Three"}});
    const Figure figure = figureOf(scene, "a.sline");
    QCOMPARE(figure.panels.size(), std::size_t(3));
    QCOMPARE(figure.panels[2].view, std::string("Three"));
    QVERIFY(checkFigure(figure).ok());
  }
};

}  // namespace sline::test

SLINE_TEST(sline::test::FigureLayoutTest)
#include "figure_layout_test.moc"
