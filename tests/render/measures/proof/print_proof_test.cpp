// SPDX-License-Identifier: Apache-2.0
#include "render/measures/proof/print_proof.h"

#include <QTest>
#include <algorithm>

#include "model/edit/locks.h"
#include "tests/render/picture/section_scenes.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

using render::PrintProof;
using render::ProofPair;
using render::ProofSettings;
using render::Vision;

// These look alike to eyes without cones for middle waves.
constexpr Colour rust{190, 70, 60};
constexpr Colour olive{72, 136, 48};
constexpr Colour black{12, 12, 12};
constexpr Colour white{245, 245, 245};

/// Returns two balls side by side that touch in the picture, `gap` mm apart.
render::ExportOrder twoBalls(const model::Style& left, const model::Style& right,
                             float gap = -6.0f) {
  render::ExportOrder order;
  add(order.scene, moved(*sphere(24.0f, 4), 1.0f, {-24.0f - 0.5f * gap, 0, 0}), left);
  add(order.scene, moved(*sphere(20.0f, 4), 1.0f, {20.0f + 0.5f * gap, 0, 0}), right);
  order.camera = frontal(70.0f);
  order.page = {.sizeMm = {120.0f, 80.0f}, .dpi = 96.0f};
  return order;
}

PrintProof proofOf(const render::ExportOrder& order, const ProofSettings& settings = {}) {
  Result<PrintProof> proof = render::printProof(order, settings, {});
  if (!proof.ok())
    qWarning("%s", proof.error().text().c_str());
  return proof.ok() ? *proof : PrintProof{};
}

bool anyAlike(const std::vector<ProofPair>& pairs, const ProofSettings& settings = {}) {
  return std::any_of(pairs.begin(), pairs.end(),
                     [&](const ProofPair& pair) { return pair.alikeAnywhere(settings); });
}

}  // namespace

class PrintProofTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void whatIsFlagged_data();
  void whatIsFlagged();
  void proposalsPass_data();
  void proposalsPass();
  void neighboursOfTheNeighbourCount();
  void whatIsMeantIsLeftAlone();
  void lockedStays();
  void gammaWhereNoColourShows();
  void sectionsDecideWhoIsSeen();
  void stops();
};

void PrintProofTest::initTestCase() {
  if (const Studio studio = openStudio(); !studio.picture)
    QSKIP(studio.absent.c_str());
}

void PrintProofTest::whatIsFlagged_data() {
  QTest::addColumn<Colour>("left");
  QTest::addColumn<Colour>("right");
  QTest::addColumn<float>("leftGamma");
  QTest::addColumn<float>("gap");
  QTest::addColumn<int>("pairs");
  QTest::addColumn<QStringList>("alike");
  QTest::newRow("red and green") << rust << olive << 5.0f << -6.0f << 1
                                 << QStringList{"deuteranopia"};
  QTest::newRow("black and white") << black << white << 5.0f << -6.0f << 1 << QStringList{};
  QTest::newRow("told by gamma") << rust << olive << 3.0f << -6.0f << 1 << QStringList{};
  QTest::newRow("apart") << rust << olive << 5.0f << 12.0f << 0 << QStringList{};
  QTest::newRow("the same") << rust << rust << 5.0f << -6.0f << 1
                            << QStringList{"normal", "grey", "protanopia", "deuteranopia",
                                           "tritanopia"};
}

void PrintProofTest::whatIsFlagged() {
  QFETCH(Colour, left);
  QFETCH(Colour, right);
  QFETCH(float, leftGamma);
  QFETCH(float, gap);
  QFETCH(int, pairs);
  QFETCH(QStringList, alike);
  const PrintProof proof = proofOf(twoBalls(styled(leftGamma, left), styled(5.0f, right), gap));
  QCOMPARE(int(proof.neighbours.size()), pairs);
  const ProofSettings settings;
  QStringList found;
  for (const ProofPair& pair : proof.neighbours) {
    QVERIFY(pair.border > 0.05);
    for (const Vision vision : render::visions)
      if (pair.alike(vision, settings))
        found << render::nameOf(vision);
  }
  if (alike == QStringList{"deuteranopia"}) {
    QVERIFY2(found.contains("deuteranopia"), qPrintable(found.join(' ')));
    QVERIFY(!found.contains("normal"));
    return;
  }
  QCOMPARE(found, alike);
}

void PrintProofTest::proposalsPass_data() {
  QTest::addColumn<float>("gamma");
  QTest::addColumn<double>("threshold");
  QTest::newRow("shaded") << 5.0f << 10.0;
  QTest::newRow("hatched and shaded") << 3.8f << 10.0;
  QTest::newRow("stricter") << 5.0f << 16.0;
}

void PrintProofTest::proposalsPass() {
  QFETCH(float, gamma);
  QFETCH(double, threshold);
  const ProofSettings settings{.leastDifference = threshold};
  const render::ExportOrder order = twoBalls(styled(gamma, rust), styled(gamma, olive));
  const PrintProof proof = proofOf(order, settings);
  QVERIFY(anyAlike(proof.neighbours, settings));
  QCOMPARE(proof.proposals.size(), std::size_t(1));
  QVERIFY(!anyAlike(proof.afterwards, settings));
  // A second proof of the proposed scene finds nothing more.
  render::ExportOrder again = order;
  again.scene = render::withProposals(order.scene, proof.proposals);
  QVERIFY(again.scene == proof.proposed);
  const PrintProof second = proofOf(again, settings);
  QVERIFY(!anyAlike(second.neighbours, settings));
  QVERIFY(second.proposals.empty());
}

void PrintProofTest::neighboursOfTheNeighbourCount() {
  // A third ball touches the smaller one: the change that sets the smaller apart from the first
  // must not make it like the third.
  render::ExportOrder order = twoBalls(styled(5.0f, rust), styled(5.0f, olive));
  add(order.scene, moved(*sphere(16.0f, 4), 1.0f, {22.0f, -10.0f, 26.0f}),
      styled(5.0f, Colour{200, 190, 110}));
  const PrintProof proof = proofOf(order);
  QVERIFY(proof.neighbours.size() >= 2);
  QVERIFY(!proof.proposals.empty());
  QVERIFY(!anyAlike(proof.afterwards));
}

void PrintProofTest::whatIsMeantIsLeftAlone() {
  const render::ExportOrder order = twoBalls(styled(5.0f, rust), styled(5.0f, rust));
  const PrintProof proof = proofOf(order);
  QVERIFY(proof.neighbours.front().alikeOnScreen({}));
  QVERIFY(proof.proposals.empty());
  QVERIFY(proof.proposed == order.scene);
  const ProofSettings all{.all = true};
  const PrintProof mended = proofOf(order, all);
  QCOMPARE(mended.proposals.size(), std::size_t(1));
  QVERIFY(!anyAlike(mended.afterwards, all));
}

void PrintProofTest::lockedStays() {
  render::ExportOrder order = twoBalls(styled(5.0f, rust), styled(5.0f, olive));
  const model::NodeId smaller = order.scene.nodes().back().id;
  const std::array<model::NodeId, 1> one{smaller};
  order.scene = model::withLocked(order.scene, one, true).scene;
  const PrintProof proof = proofOf(order);
  QCOMPARE(proof.proposals.size(), std::size_t(1));
  QVERIFY(proof.proposals.front().node != smaller);
  QVERIFY(!anyAlike(proof.afterwards));
}

void PrintProofTest::gammaWhereNoColourShows() {
  // Black and white drawings have no colours to change.
  model::Style style = styled(2.0f, rust);
  style.fill = model::Fill::paper;
  const ProofSettings all{.all = true};
  const PrintProof proof = proofOf(twoBalls(style, style), all);
  QVERIFY(anyAlike(proof.neighbours, all));
  QCOMPARE(proof.proposals.size(), std::size_t(1));
  QVERIFY(proof.proposals.front().gamma && !proof.proposals.front().colour);
  QVERIFY(!anyAlike(proof.afterwards, all));
}

void PrintProofTest::sectionsDecideWhoIsSeen() {
  render::ExportOrder order = twoBalls(styled(5.0f, rust), styled(5.0f, olive));
  cut(order.scene, model::AnatomicalView::left, -40.0f, order.scene.nodes().back().id);
  QVERIFY(!proofOf(order).neighbours.empty());
  // The whole of the right ball is taken away.
  order = twoBalls(styled(5.0f, rust), styled(5.0f, olive));
  cut(order.scene, model::AnatomicalView::left, 60.0f, order.scene.nodes().back().id);
  QVERIFY(proofOf(order).neighbours.empty());
}

void PrintProofTest::stops() {
  const Result<PrintProof> proof =
      render::printProof(twoBalls(styled(5.0f, rust), styled(5.0f, olive)), {},
                         [](double share, std::string_view) { return share < 0.3; });
  QVERIFY(proof.ok());  // finished before it could be stopped
  const Result<PrintProof> none =
      render::printProof(twoBalls(styled(5.0f, rust), styled(5.0f, olive)), {},
                         [](double, std::string_view what) { return what != "trying changes"; });
  QVERIFY(!none.ok());
  QCOMPARE(none.error().reason, render::givenUp({}).reason);
}

}  // namespace sline::test

SLINE_TEST(sline::test::PrintProofTest)
#include "print_proof_test.moc"
