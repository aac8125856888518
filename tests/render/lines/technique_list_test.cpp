// SPDX-License-Identifier: Apache-2.0
// Tests the list of techniques that styles choose and what can be set of them.
#include "render/lines/techniques/technique_list.h"

#include <QtTest>
#include <set>

#include "render/lines/techniques/line_technique.h"
#include "tests/support/suite.h"

namespace sline::test {

using model::ThresholdValues;
using namespace render;

class TechniqueListTest : public QObject {
  Q_OBJECT

 private slots:
  void everyTechniqueIsTold() {
    QCOMPARE(techniqueList().size(), model::techniqueNames.size());
    std::set<std::string> names;
    for (std::size_t i = 0; i < techniqueList().size(); ++i) {
      const TechniqueFacts& facts = techniqueList()[i];
      QCOMPARE(std::size_t(facts.technique), i);
      QVERIFY(facts.id == model::techniqueNames[i]);
      QVERIFY2(facts.year > 1990 && std::string(facts.authors).size() > 3, facts.name);
      QVERIFY(QString::fromStdString(facts.citation()).endsWith(QString::number(facts.year)));
      QVERIFY2(facts.drawsLines() == (facts.technique != model::Technique::noiseLic), facts.name);
      for (const TechniqueThreshold& threshold : facts.thresholds) {
        QVERIFY2(names.insert(threshold.name).second, threshold.name.c_str());
        QVERIFY2(!model::thresholdFault(threshold.name, threshold.usual), threshold.name.c_str());
        QVERIFY2(thresholdHelp().find(threshold.name) != std::string::npos, "help");
      }
      for (const LineTechnique& lines : lineTechniques())
        if (lines.drawnBy == facts.technique)
          QVERIFY2(lines.entered(facts.whole) >= 1.0f, facts.name);
    }
  }
  /// Every threshold of every kind is reached by exactly one name, and by it alone.
  void namesReachTheirThresholds() {
    std::size_t reached = 0;
    for (const TechniqueFacts& facts : techniqueList())
      for (const TechniqueThreshold& threshold : facts.thresholds) {
        const float value = 0.5f * (threshold.usual + threshold.limits.high);
        const LineThresholds changed =
            lineThresholds(ThresholdValues{{threshold.name, value}, {"nobody.knows", 1.0f}});
        const LineThresholds usual;
        for (const LineTechnique& lines : lineTechniques())
          for (std::size_t i = 0; i < lines.thresholds.size(); ++i) {
            const bool meant = threshold.kinds.has(lines.kind) && i == threshold.which;
            QCOMPARE(changed.of(lines.kind, i), meant ? value : usual.of(lines.kind, i));
            reached += meant ? 1 : 0;
          }
      }
    std::size_t all = 0;
    for (const LineTechnique& lines : lineTechniques())
      all += lines.thresholds.size();
    QCOMPARE(reached, all);
  }
  void valuesStayWithinLimits() {
    const TechniqueThreshold& margin = factsOf(model::Technique::confis).thresholds.front();
    QCOMPARE(valueOf(margin, ThresholdValues{{margin.name, 1e6f}}), margin.limits.high);
    QCOMPARE(valueOf(margin, {}), margin.usual);
  }
  void textsAreRead_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("name");  // empty: an error that holds `said`
    QTest::addColumn<QByteArray>("said");
    const auto row = [](const char* text, const char* name, const char* said) {
      QTest::newRow(text) << QByteArray(text) << QByteArray(name) << QByteArray(said);
    };
    row("laplacian=0.3", "laplacian.slope", "");
    row("ridges.sharpness=0.3", "ridges.sharpness", "");
    row("confis=0.3", "confis.margin", "");
    row("fur=0.3", "", "highlights.t_h");
    row("laplacian.fur=0.3", "", "laplacian.slope");
    row("laplacian", "", "laplacian.slope=2");
    row("laplacian=", "", "laplacian.slope=2");
    row("laplacian=x", "", "0 to 1000");
    row("laplacian=-1", "", "0 to 1000");
    row("laplacian=1001", "", "0 to 1000");
    row("laplacian=nan", "", "0 to 1000");
    row("laplacian=0.3.1", "", "0 to 1000");
  }
  void textsAreRead() {
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, name);
    QFETCH(QByteArray, said);
    const Result<model::ThresholdValue> value = parseThresholdValue(text.toStdString());
    QCOMPARE(value.ok(), !name.isEmpty());
    if (value.ok())
      QVERIFY(value->name == name.toStdString() && value->value == 0.3f);
    else
      QVERIFY2(value.error().text().find(said.toStdString()) != std::string::npos,
               value.error().text().c_str());
  }
};

}  // namespace sline::test

SLINE_TEST(sline::test::TechniqueListTest)
#include "technique_list_test.moc"
