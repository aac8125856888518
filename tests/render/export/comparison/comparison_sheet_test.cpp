// SPDX-License-Identifier: Apache-2.0
// Tests comparisons and where a sheet puts what it shows.
#include "render/export/comparison/comparison_sheet.h"

#include <QtTest>

#include "model/scene/visible_structures.h"
#include "render/lettering/label_texts.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

using namespace render;

namespace {

ComparedModel ring(const std::string& name) {
  ComparedModel model{.name = name, .note = {}, .scene = {}, .camera = {}};
  model.scene.append({.name = "ring", .mesh = torus(40.0f, 15.0f, 60, 24)});
  model.camera = model::fittedView(model.scene, model::AnatomicalView::superior, 1.0f);
  return model;
}

ComparisonOrder order(const std::string& name) {
  return {.models = {ring(name), roughened(ring("short"), {NoiseKind::jitter, 0.1f})},
          .techniques = {model::Technique::laplacian, model::Technique::photic},
          .thresholds = {},
          .timings = 1};
}

}  // namespace

class ComparisonSheetTest : public QObject {
  Q_OBJECT

 private slots:
  /// A page twice as wide shows the same lines at half the length per area.
  void figuresAreTrue() {
    ComparisonOrder wanted = order("ring");
    const auto comparison = compareTechniques(wanted, {});
    QVERIFY(comparison.ok());
    QCOMPARE(comparison->rows.size(), std::size_t(2));
    const std::vector<ComparedCell>& row = comparison->rows.front();
    QVERIFY(row[0].frameMs > 0.0 && row[0].linesPerMm > 0.0);
    wanted.cellMm *= 2.0f;
    const auto larger = compareTechniques(wanted, {});
    QVERIFY(larger.ok());
    QVERIFY(std::abs(row[0].linesPerMm / larger->rows[0][0].linesPerMm - 2.0) < 0.05);
    QCOMPARE(larger->rows[0][0].drawing.sizeMm.x, 84.0f);
  }
  void givesUpWhenAsked() {
    int asked = 0;
    const auto comparison = compareTechniques(
        order("ring"), ExportProgress([&asked](double, std::string_view) { return ++asked < 2; }));
    QVERIFY(!comparison.ok());
    QCOMPARE(asked, 2);
  }
  void everythingHasItsPlace_data() {
    QTest::addColumn<QByteArray>("name");
    QTest::newRow("short") << QByteArray("ring");
    QTest::newRow("long") << QByteArray("a ring with a name of many words that go on and on");
    QTest::newRow("one long word") << QByteArray("aringwithanameofonewordthatgoesonandonandon");
  }
  void everythingHasItsPlace() {
    QFETCH(QByteArray, name);
    const auto comparison = compareTechniques(order(name.toStdString()), {});
    QVERIFY(comparison.ok());
    const ComparisonSheet sheet = comparisonSheet(*comparison);
    QCOMPARE(sheet.cells.size(), std::size_t(4));
    for (std::size_t i = 0; i < sheet.cells.size(); ++i) {
      const SheetCell& cell = sheet.cells[i];
      QVERIFY(cell.at.x >= 0.0f && cell.at.x + cell.drawing->sizeMm.x <= sheet.sizeMm.x);
      QVERIFY(cell.at.y >= 0.0f && cell.at.y + cell.drawing->sizeMm.y <= sheet.sizeMm.y);
      for (std::size_t j = 0; j < i; ++j) {
        const glm::vec2 apart = glm::abs(cell.at - sheet.cells[j].at);
        QVERIFY(apart.x >= cell.drawing->sizeMm.x || apart.y >= cell.drawing->sizeMm.y);
      }
    }
    for (const LetteringItem& item : sheet.lettering.items) {
      if (!item.text)
        continue;
      const LetteringText& text = *item.text;
      for (const TextLine& line : text.lines)
        QVERIFY2(text.at.x + textWidthMm(line, text.points) <= sheet.sizeMm.x, item.name.c_str());
      const float bottom = text.at.y + float(text.lines.size() - 1) * text.leading;
      QVERIFY2(text.at.y > 0.0f && bottom < sheet.sizeMm.y, item.name.c_str());
      // Heads of rows end before the pictures.
      if (text.at.x < sheet.cells.front().at.x && item.name != "notes")
        for (const TextLine& line : text.lines)
          QVERIFY2(text.at.x + textWidthMm(line, text.points) <= sheet.cells.front().at.x,
                   item.name.c_str());
    }
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_GUI(sline::test::ComparisonSheetTest)
#include "comparison_sheet_test.moc"
