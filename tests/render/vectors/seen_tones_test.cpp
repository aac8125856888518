// SPDX-License-Identifier: Apache-2.0
// Tests tones of fills and how many of them are drawn.
#include "render/vectors/seen_tones.h"

#include <QtTest>
#include <cmath>

#include "tests/support/suite.h"

using namespace sline;
using namespace sline::render;

namespace {

/// Returns stripes of tones 1 … `tones`, each `width` pixels wide and 10 high, grey from black to
/// white.
SeenTones stripes(int tones, int width, float transmittance = 1.0f) {
  SeenTones seen;
  seen.area = {5, 7, tones * width, 10};
  for (int y = 0; y < seen.area.height; ++y)
    for (int x = 0; x < seen.area.width; ++x)
      seen.tones.push_back(std::uint8_t(1 + x / width));
  for (int k = 0; k < tones; ++k)
    seen.colours.emplace_back(glm::vec3(float(k) / float(tones)), 1.0f);
  seen.firstCapTone = std::size_t(tones);
  seen.transmittance = transmittance;
  return seen;
}

}  // namespace

class SeenTonesTest : public QObject {
  Q_OBJECT
 private slots:
  void outlinesAreAsLongAsTheSteps() {
    // There are eleven borders between twelve stripes, ten pixels each.
    QCOMPARE(outlineLength(stripes(12, 3)), 110.0);
    QCOMPARE(outlineLength(stripes(1, 40)), 0.0);
    // A step over three tones is three outlines.
    SeenTones jump = stripes(4, 1);
    for (std::uint8_t& tone : jump.tones)
      tone = tone < 3 ? 1 : 4;
    QCOMPARE(outlineLength(jump), 30.0);
  }

  void neighboursBecomeOneOfTheirMeanColour() {
    SeenTones seen = stripes(5, 2);
    // The second stripe loses half of its pixels to the first.
    for (std::size_t i = 0; i < seen.tones.size(); ++i)
      if (i % 10 == 2)
        seen.tones[i] = 1;
    joinTones(seen, 2);
    QCOMPARE(seen.firstCapTone, std::size_t(3));
    QCOMPARE(seen.colours.size(), std::size_t(3));
    QVERIFY(std::abs(seen.colours[0].r - 0.05f) < 1e-4f);  // (3 · 0 + 1 · 0.2) / 4
    QVERIFY(std::abs(seen.colours[1].r - 0.5f) < 1e-4f);
    QVERIFY(std::abs(seen.colours[2].r - 0.8f) < 1e-4f);
    const std::vector<std::uint8_t> row(seen.tones.begin(), seen.tones.begin() + 10);
    QCOMPARE(row, (std::vector<std::uint8_t>{1, 1, 1, 1, 2, 2, 2, 2, 3, 3}));
  }

  void unseenStaysUnseenAndCutFacesKeepTheirTones() {
    SeenTones seen = stripes(6, 1);
    seen.firstCapTone = 4;
    seen.tones[0] = 0;
    joinTones(seen, 4);
    QCOMPARE(seen.firstCapTone, std::size_t(1));
    QCOMPARE(seen.colours.size(), std::size_t(3));
    const std::vector<std::uint8_t> row(seen.tones.begin(), seen.tones.begin() + 6);
    QCOMPARE(row, (std::vector<std::uint8_t>{0, 1, 1, 1, 2, 3}));
    QVERIFY(std::abs(seen.colours[2].r - 5.0f / 6.0f) < 1e-6f);
  }

  void plentyOfRoomChangesNothing() {
    std::vector<SeenTones> all{stripes(20, 2), stripes(30, 1)};
    joinTonesWithin(all, 1e6);
    QCOMPARE(all[0].colours.size(), std::size_t(20));
    QCOMPARE(all[1].tones, stripes(30, 1).tones);
  }

  void outlinesStayWithinWhatIsAllowed() {
    std::vector<SeenTones> all(10, stripes(60, 2));
    double before = 0.0;
    for (const SeenTones& seen : all)
      before += outlineLength(seen);
    joinTonesWithin(all, before / 5.0);
    double after = 0.0;
    for (const SeenTones& seen : all)
      after += outlineLength(seen);
    QVERIFY2(after <= 1.1 * before / 5.0, qPrintable(QString::number(after / before)));
    QVERIFY(after >= 0.5 * before / 5.0);  // joined no more than needed
  }

  void whatIsHardlySeenHasFewerTones() {
    std::vector<SeenTones> all{stripes(40, 2), stripes(40, 2, 0.25f), stripes(40, 2, 0.0f)};
    joinTonesWithin(all, 1e6);
    QCOMPARE(all[0].colours.size(), std::size_t(40));
    QCOMPARE(all[1].colours.size(), std::size_t(20));
    QCOMPARE(all[2].colours.size(), std::size_t(2));
  }
};

SLINE_TEST(SeenTonesTest)
#include "seen_tones_test.moc"
