// SPDX-License-Identifier: Apache-2.0
// Tests which kinds of lines a style's technique shows.
#include <QtTest>

#include "render/lines/techniques/line_technique.h"
#include "render/strokes/structure_lines.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using model::Technique;
using render::LineKind;

class TechniqueTest : public QObject {
  Q_OBJECT
 private slots:
  void stylesShowTheirTechnique_data() {
    QTest::addColumn<int>("technique");
    QTest::addColumn<float>("gamma");
    QTest::addColumn<bool>("suggestive");
    QTest::addColumn<bool>("confis");
    QTest::addColumn<bool>("hatching");
    QTest::newRow("sline 1") << int(Technique::sline) << 1.0f << false << false << false;
    QTest::newRow("sline 1.5") << int(Technique::sline) << 1.5f << true << false << false;
    QTest::newRow("sline 2.5") << int(Technique::sline) << 2.5f << true << false << true;
    QTest::newRow("confis 1") << int(Technique::confis) << 1.0f << false << false << false;
    QTest::newRow("confis 1.5") << int(Technique::confis) << 1.5f << false << true << false;
    QTest::newRow("confis 3") << int(Technique::confis) << 3.0f << false << true << false;
    QTest::newRow("streamline hatching 2")
        << int(Technique::streamlineHatching) << 2.0f << false << false << false;
    QTest::newRow("noise 2") << int(Technique::noiseLic) << 2.0f << false << false << false;
    QTest::newRow("confis 5") << int(Technique::confis) << 5.0f << false << false << false;
  }
  void stylesShowTheirTechnique() {
    QFETCH(int, technique);
    QFETCH(float, gamma);
    QFETCH(bool, suggestive);
    QFETCH(bool, confis);
    QFETCH(bool, hatching);
    const model::ResolvedStyle style{.gamma = Gamma::clamped(gamma),
                                     .technique = Technique(technique)};
    const render::LineKinds kinds = render::shownKinds(style);
    QVERIFY(kinds.has(LineKind::contour));
    QCOMPARE(kinds.has(LineKind::suggestive), suggestive);
    QCOMPARE(kinds.has(LineKind::confis), confis);
    QCOMPARE(kinds.has(LineKind::hatchingStreamline),
             Technique(technique) == Technique::streamlineHatching);
    QCOMPARE(render::showsHatching(style), hatching);
  }

  /// What a technique computes once is kept for the next view.
  void preparationsAreKept() {
    const model::SurfacePtr surface = model::prepareSurface(test::torus(10, 3, 60, 24));
    render::LinePreparations preparations;
    preparations.make({LineKind::contour, LineKind::confis}, *surface);
    const auto once = preparations.of(LineKind::confis, *surface);
    QVERIFY(once);
    QCOMPARE(preparations.of(LineKind::confis, *surface), once);
  }
};

SLINE_TEST(TechniqueTest)
#include "technique_test.moc"
