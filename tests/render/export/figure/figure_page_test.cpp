// SPDX-License-Identifier: Apache-2.0
// Tests figures of several panels: where labels stand, what cameras share, what insets show, and
// what is refused.
#include "render/export/figure/figure_page.h"

#include <QtTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/edit/views.h"
#include "model/scene/visible_structures.h"
#include "render/export/figure/figure_checks.h"
#include "render/export/figure/line_weights.h"
#include "render/labels/seen/screen.h"
#include "tests/render/export/figure/sample_figure.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

using namespace render;

namespace {

/// Returns the millimetres of anatomy in a millimetre of paper at the target.
float scaleOf(const ExportOrder& order) {
  return model::millimetresPerPixel(order.camera, order.camera.target, order.page.sizeMm.y);
}

glm::vec3 directionOf(const model::Camera& camera) {
  return glm::normalize(camera.target - camera.eye);
}

}  // namespace

class FigurePageTest : public QObject {
  Q_OBJECT

 private slots:
  /// Every label's box and leader, every mark and every letter lies in its own panel.
  void labelsStayInTheirPanels_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("four") << 0;
    QTest::newRow("one column") << 1;
    QTest::newRow("eleven small ones") << 2;
    QTest::newRow("inset inside") << 3;
    QTest::newRow("places of their own") << 4;
    QTest::newRow("two scenes") << 5;
  }
  void labelsStayInTheirPanels() {
    QFETCH(int, kind);
    model::Figure figure = fourPanels();
    if (kind == 1)
      figure.columns = {1.0f};
    if (kind == 2) {
      figure.columns = {1.0f, 2.0f, 1.0f, 1.0f};
      figure.panels[3].inset->part = {{8, 6}, {12, 9}};
      for (int i = 0; i < 7; ++i)
        figure.panels.push_back({.view = i % 2 ? "left" : "posterior"});
    }
    if (kind == 3)
      figure.panels[3].inset->inside = model::FigureBox{{55, 3}, {24, 18}};
    if (kind == 4) {
      figure.heightMm = 160.0f;
      figure.panels[0].at = model::FigureBox{{3, 5}, {100, 70}};
      figure.panels[1].at = model::FigureBox{{110, 20}, {50, 60}};
      figure.panels[2].at = model::FigureBox{{5, 90}, {60, 60}};
      figure.panels[3].at = model::FigureBox{{90, 100}, {70, 50}};
    }
    if (kind == 5)
      figure.panels[1].scene = "two.sline";
    const ComposedFigure composed = drawn(figure);
    int labels = 0;
    for (std::size_t i = 0; i < composed.panels.size(); ++i) {
      const glm::vec2 size = composed.plan.layout.panels[i].box.size;
      const LabelBox panel{glm::vec2(-0.01f), size + 0.01f};
      for (const PlacedLabel& label : composed.panels[i].plate.labels->layout.labels) {
        ++labels;
        QVERIFY(panel.contains(label.box.low) && panel.contains(label.box.high));
        for (const glm::vec2& point : label.leader)
          QVERIFY(panel.contains(point));
      }
      for (const LetteringItem& mark : composed.panels[i].plate.marks.lettering.items)
        if (mark.text)
          QVERIFY(panel.contains(mark.text->at));
      // Insets and letters are in nobody's way.
      for (const LabelBox& box : composed.plan.panels[i].labels.reserved)
        for (const PlacedLabel& label : composed.panels[i].plate.labels->layout.labels)
          QVERIFY(!overlap(box, label.box));
    }
    QVERIFY2(labels >= 8, qPrintable(QString::number(labels)));
  }

  /// Cameras that are alike have one direction and one scale, whatever the panels' sizes.
  void linkedCamerasCompare_data() {
    QTest::addColumn<bool>("parallel");
    QTest::newRow("perspective") << false;
    QTest::newRow("parallel") << true;
  }
  void linkedCamerasCompare() {
    QFETCH(bool, parallel);
    model::Figure figure{.scene = "row.sline"};
    figure.columns = {2.0f, 1.0f};
    figure.rows = {1.0f, 2.0f};
    if (parallel)
      figure.projection = model::FigureProjection::parallel;
    figure.panels = {
        {.view = "left"},
        {.view = "anterior", .camera = model::PanelCamera{.like = "a"}},
        {.scene = "two.sline", .camera = model::PanelCamera{.like = "b", .centred = true}},
        {.view = "anterior"}};
    const Result<FigurePlan> plan = planFigure(figure, scenes());
    QVERIFY(plan.ok());
    for (const std::size_t i : {std::size_t(1), std::size_t(2)}) {
      QVERIFY(glm::distance(directionOf(plan->panels[0].camera),
                            directionOf(plan->panels[i].camera)) < 1e-4f);
      QVERIFY(std::abs(scaleOf(plan->panels[i]) / scaleOf(plan->panels[0]) - 1.0f) < 1e-3f);
      QCOMPARE(plan->panels[i].camera.projection == model::Projection::orthographic, parallel);
    }
    QVERIFY(plan->panels[1].page.sizeMm.y != plan->panels[2].page.sizeMm.y);
    QVERIFY(std::abs(scaleOf(plan->panels[3]) / scaleOf(plan->panels[0]) - 1.0f) > 0.01f);
    // Centred: the middle of what it shows is in the middle, as it is in the other panel.
    const auto middle = [&](std::size_t i) {
      const ExportOrder& order = plan->panels[i];
      return *Screen(order.camera, order.page.sizeMm).place(order.scene.visibleBounds().centre()) -
             0.5f * order.page.sizeMm;
    };
    QVERIFY(glm::distance(middle(2), middle(1)) < 0.1f);
  }

  /// The frame surrounds in the parent just what the inset shows, and that is the part.
  void framesAreTrue_data() { linkedCamerasCompare_data(); }
  void framesAreTrue() {
    QFETCH(bool, parallel);
    model::Figure figure = fourPanels();
    if (parallel)
      figure.projection = model::FigureProjection::parallel;
    const Result<FigurePlan> plan = planFigure(figure, scenes());
    QVERIFY(plan.ok());
    QCOMPARE(plan->frames.size(), std::size_t(1));
    const InsetFrame& frame = plan->frames.front();
    const ExportOrder& parent = plan->panels[0];
    const ExportOrder& inset = plan->panels[3];
    const Screen whole(parent.camera, parent.page.sizeMm);
    const Screen part(inset.camera, inset.page.sizeMm);
    const model::PanelInset& asked = *figure.panels[3].inset;
    // 20 by 15 in a panel of 4 by 3: the frame is the part, but for perspective.
    const float slack = parallel ? 0.05f : 0.6f;
    const std::vector<glm::vec2> corners{asked.part.at,
                                         {asked.part.end().x, asked.part.at.y},
                                         asked.part.end(),
                                         {asked.part.at.x, asked.part.end().y}};
    for (std::size_t i = 0; i < corners.size(); ++i)
      QVERIFY(glm::distance(corners[i] + plan->layout.panels[0].box.at, frame.corners[i]) < slack);
    // Any point lies in the inset where it lies in the frame.
    for (const glm::vec3& p : {glm::vec3(0, -12, 0), glm::vec3(3, 0, 4), glm::vec3(-2, 9, 8)}) {
      const glm::vec2 inWhole = *whole.place(p);
      const glm::vec2 share =
          (inWhole - asked.part.at) / asked.part.size;  // of the frame, if it were a rectangle
      const glm::vec2 inPart = *part.place(p) / inset.page.sizeMm;
      QVERIFY(glm::distance(share, inPart) < (parallel ? 0.01f : 0.05f));
    }
  }

  /// Pens are as wide in a small panel as in a large one, and as wide as asked for.
  void pensAreTheSame() {
    model::Figure figure{.scene = "two.sline"};
    figure.thinLines = model::ThinLines::kept;
    figure.labels = false;
    for (const float pen : {0.5f, 1.0f}) {
      figure.penPoints = pen;
      figure.heightMm = 150.0f;
      figure.panels = {{.at = model::FigureBox{{0, 0}, {110, 140}}},
                       {.at = model::FigureBox{{115, 0}, {40, 30}}}};
      const ComposedFigure composed = drawn(figure);
      std::array<float, 2> widths{};
      for (std::size_t i = 0; i < 2; ++i)
        for (const VectorStructure& structure : composed.panels[i].drawing.structures)
          for (const VectorLines& lines : structure.lines)
            if (lines.kind == std::string_view("Contours"))
              widths[i] = usualWidthMm(lines) / millimetresPerPoint;
      QVERIFY2(std::abs(widths[0] / widths[1] - 1.0f) < 0.1f,
               qPrintable(QStringLiteral("%1 %2").arg(widths[0]).arg(widths[1])));
      QVERIFY2(widths[0] > 0.5f * pen && widths[0] < 1.2f * pen,
               qPrintable(QString::number(widths[0])));
    }
  }

  /// Nothing of a drawing lies wholly outside of its panel.
  void panelsHaveOnlyTheirOwn() {
    const ComposedFigure composed = drawn(fourPanels());
    const ComposedPanel& inset = composed.panels[3];
    const ComposedPanel& whole = composed.panels[0];
    QVERIFY(!inset.drawing.structures.empty());
    QVERIFY(inset.drawing.structures.size() < whole.drawing.structures.size());
    QCOMPARE(inset.drawing.sizeMm, composed.plan.layout.panels[3].box.size);
  }

  void smallLettersAreRefused() {
    model::Figure figure = fourPanels();
    QVERIFY(printFaults(drawn(figure)).empty());
    figure.points = 5.0f;
    figure.scaleBars = false;
    figure.panels[1].labels = false;
    figure.sides = false;
    std::vector<Error> faults = printFaults(drawn(figure));
    QCOMPARE(faults.size(), std::size_t(3));
    QCOMPARE(faults[0].where, std::string("panel a"));
    QCOMPARE(faults[1].where, std::string("panel c"));
    const QString reason = QString::fromStdString(faults[0].reason);
    QVERIFY2(reason.contains("ball number") && reason.contains("5 pt") && reason.contains("6 pt"),
             qPrintable(reason));
    figure.leastPoints = 5.0f;
    QVERIFY(printFaults(drawn(figure)).empty());
    figure.points = 8.0f;
    figure.letterPoints = 4.5f;
    faults = printFaults(drawn(figure));
    QCOMPARE(faults.size(), std::size_t(1));
    QCOMPARE(faults[0].where, std::string("letters and legend"));
  }

  void thinLinesAreToldOrRaised() {
    model::Figure figure = fourPanels();
    figure.penPoints = 0.12f;
    QVERIFY(printFaults(drawn(figure)).empty());
    for (const ComposedPanel& panel : drawn(figure).panels)
      for (const VectorStructure& structure : panel.drawing.structures)
        for (const VectorLines& lines : structure.lines)
          for (const VectorShape& shape : lines.shapes)
            QVERIFY(isTone(lines) || shape.penWidth <= 0.0f ||
                    shape.penWidth / millimetresPerPoint > 0.2f || lines.shapes.size() > 1);
    figure.thinLines = model::ThinLines::refused;
    const std::vector<Error> faults = printFaults(drawn(figure));
    QCOMPARE(faults.size(), std::size_t(4));
    QVERIFY(faults[0].reason.find("ball number") != std::string::npos);
    figure.thinLines = model::ThinLines::kept;
    QVERIFY(printFaults(drawn(figure)).empty());
    // Leaders are lines, too.
    figure.leastLine = 0.6f;
    QVERIFY(!printFaults(drawn(figure)).empty());
  }

  void oneLegendForAll() {
    model::Figure figure = fourPanels();
    figure.panels[1].scene = "two.sline";
    figure.legend = model::FigureLegend::all;
    const ComposedFigure composed = drawn(figure);
    QStringList rows;
    for (const LetteringItem& item : composed.writing.items)
      if (item.name.starts_with("legend: ")) {
        rows << plainText(item.text->lines.front());
        QVERIFY(item.text->at.y > composed.plan.layout.panels[3].box.end().y);
        QVERIFY(item.text->at.y < composed.plan.layout.sizeMm.y);
      }
    rows.sort();
    QCOMPARE(rows, (QStringList{"ball number 1", "ball number 2", "ball number 3", "ball number 4",
                                "ball number 5"}));
  }

  void whatIsNotThereIsTold_data() {
    QTest::addColumn<QString>("scene");
    QTest::addColumn<QString>("view");
    QTest::addColumn<QString>("told");
    QTest::newRow("scene") << "none.sline"
                           << "left"
                           << "panel b: there is no scene none.sline";
    QTest::newRow("view") << "row.sline"
                          << "Savd"
                          << "panel b: its scene has no view \"Savd\". Near it: \"Saved\"";
  }
  void whatIsNotThereIsTold() {
    QFETCH(QString, scene);
    QFETCH(QString, view);
    QFETCH(QString, told);
    model::Figure figure{.scene = "row.sline"};
    figure.panels = {{}, {.scene = scene.toStdString(), .view = view.toStdString()}};
    const Result<FigurePlan> plan = planFigure(figure, scenes());
    QVERIFY(!plan.ok());
    QVERIFY2(QString::fromStdString(plan.error().text()).startsWith(told),
             plan.error().text().c_str());
  }

  /// What a figure before shows the same is taken from there.
  void panelsAreDrawnOnce() {
    model::Figure figure = fourPanels();
    const Result<FigurePlan> plan = planFigure(figure, scenes());
    const ComposedFigure before = drawn(figure);
    int told = 0;
    const ExportProgress count([&told](double, std::string_view) { return ++told > 0; });
    QVERIFY(composeFigure(*plan, count, &before).ok());
    QCOMPARE(told, 0);
    figure.panels[1].view = "inferior";
    const Result<FigurePlan> changed = planFigure(figure, scenes());
    QVERIFY(composeFigure(*changed, count, &before).ok());
    QVERIFY(told > 0);
  }

  /// All panels but insets have one scale, that of the one that shows most, and one bar says it.
  void sameScale_data() {
    QTest::addColumn<bool>("parallel");
    QTest::newRow("as saved") << false;
    QTest::newRow("parallel") << true;
  }
  void sameScale() {
    QFETCH(bool, parallel);
    model::Figure figure = fourPanels();
    figure.columns = {1.0f, 2.0f};
    figure.panels.push_back({.scene = "two.sline", .view = "left"});
    if (parallel)
      figure.projection = model::FigureProjection::parallel;
    const auto scale = [](const ExportOrder& order) {
      return model::millimetresPerPixel(order.camera, order.scene.visibleBounds().centre(),
                                        order.page.sizeMm.y);
    };
    const auto bars = [](const ComposedFigure& composed) {
      std::vector<int> all;
      for (const ComposedPanel& panel : composed.panels) {
        const auto& items = panel.plate.marks.lettering.items;
        all.push_back(int(std::count_if(items.begin(), items.end(), [](const LetteringItem& item) {
          return item.name == "scale";
        })));
      }
      return all;
    };
    const ComposedFigure before = drawn(figure);
    figure.sameScale = true;
    const ComposedFigure composed = drawn(figure);
    float widest = 0.0f;
    float narrowest = 1e9f;
    for (const std::size_t i : {0, 1, 2, 4}) {
      widest = std::max(widest, scale(before.plan.panels[i]));
      narrowest = std::min(narrowest, scale(before.plan.panels[i]));
    }
    QVERIFY2(widest > 1.3f * narrowest, "the panels have one scale anyway");
    for (const std::size_t i : {0, 1, 2, 4})
      QVERIFY(std::abs(scale(composed.plan.panels[i]) / widest - 1.0f) < 1e-4f);
    // The inset enlarges its part as much as before; in perspective it is turned, too.
    const auto enlarged = [&scale](const ComposedFigure& of) {
      return scale(of.plan.panels[0]) / scale(of.plan.panels[3]);
    };
    QVERIFY(std::abs(enlarged(composed) / enlarged(before) - 1.0f) < (parallel ? 1e-4f : 0.05f));
    QCOMPARE(bars(before), (std::vector<int>{1, 1, 1, 1, 1}));
    QCOMPARE(bars(composed), (std::vector<int>{1, 0, 0, 1, 0}));
    figure.panels[1].scaleBar = true;
    QCOMPARE(bars(drawn(figure)), (std::vector<int>{1, 1, 0, 1, 0}));
  }

  void stopsWhereAsked() {
    const Result<FigurePlan> plan = planFigure(fourPanels(), scenes());
    const Result<ComposedFigure> composed =
        composeFigure(*plan, {[](double share, std::string_view) { return share < 0.3; }});
    QVERIFY(!composed.ok());
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_GUI(sline::test::FigurePageTest)
#include "figure_page_test.moc"
