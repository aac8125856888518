// SPDX-License-Identifier: Apache-2.0
// Compares what techniques find on a sheet with ridges and valleys with its lines, which are known.
#include <QtTest>
#include <cmath>

#include "render/lines/techniques/line_technique.h"
#include "tests/support/found_lines.h"
#include "tests/support/suite.h"

using namespace sline;
using render::LineKind;

namespace {

constexpr int sheetCells = 108;

/// A straight ridge, a straight valley and a round ridge, as on the benchmark's sheet.
test::KnownSheet smallSheet() {
  const glm::dvec2 across(std::cos(0.15), std::sin(0.15));
  return {.waves = {{.middle = {-42, 0}, .across = across, .height = 6, .sigma = 3},
                    {.middle = {-10, 0}, .across = across, .height = -5, .sigma = 3},
                    {.middle = {33, 0}, .radius = 12, .height = 6, .sigma = 3}},
          .halfSize = 60};
}

struct Least {
  LineKind kind;
  double recall, precision;
};

}  // namespace

class KnownLinesTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    sheet_ = smallSheet();
    surface_ = model::prepareSurface(sheet_.mesh(sheetCells));
  }

  void techniquesFindWhatIsThere() {
    // Where one looks nearly along a wave κr has two zeros next to each other, which no mesh tells
    // apart, and F is so large here that no highlight is too weak: theirs are bounds of what is.
    for (const Least& least :
         {Least{LineKind::ridge, 0.98, 0.98}, Least{LineKind::valley, 0.98, 0.92},
          Least{LineKind::demarcating, 0.98, 0.98}, Least{LineKind::suggestive, 0.98, 0.9},
          Least{LineKind::apparentRidge, 0.95, 0.97}, Least{LineKind::photic, 0.97, 0.97},
          Least{LineKind::laplacian, 0.97, 0.97}, Least{LineKind::suggestiveHighlight, 0.6, 0.5},
          Least{LineKind::principalHighlight, 0.87, 0.97}}) {
      const test::Agreement found = test::agreementOn(sheet_, sheetCells, *surface_, least.kind);
      check(render::techniqueOf(least.kind).id, found, least);
      QVERIFY2(found.knownMm > 20.0, "nothing is known");
    }
  }

  /// Strokes run across ridges and valleys, and no crest is without them.
  void strokesOfConfisRunAcross() {
    check("confis", test::confisAgreementOn(sheet_, sheetCells, *surface_),
          {LineKind::confis, 0.98, 0.96});
  }

  /// Lines a quarter of a wave away are not near.
  void agreementTellsLinesApart() {
    const auto ridges = test::knownLines(sheet_, {.kind = test::KnownKind::ridge});
    const auto curves = test::knownLines(sheet_, {.kind = test::KnownKind::demarcating});
    const test::AgreementRule rule{.halfSize = 60.0, .rim = 4.0, .tolerance = 1.5};
    const test::Agreement same = test::agreementOf(ridges, ridges, rule);
    QVERIFY(same.recall == 1.0 && same.precision == 1.0 && same.knownMm > 100.0);
    const test::Agreement other = test::agreementOf(ridges, curves, rule);
    QVERIFY(other.recall == 0.0 && other.precision == 0.0 && other.drawnMm > 100.0);
  }

 private:
  static void check(const char* id, const test::Agreement& found, const Least& least) {
    const QString text = QString("%1: recall %2, precision %3, %4 mm known, %5 mm drawn")
                             .arg(id)
                             .arg(found.recall)
                             .arg(found.precision)
                             .arg(found.knownMm)
                             .arg(found.drawnMm);
    QVERIFY2(found.recall >= least.recall && found.precision >= least.precision, qPrintable(text));
  }

  test::KnownSheet sheet_;
  model::SurfacePtr surface_;
};

SLINE_TEST(KnownLinesTest)
#include "known_lines_test.moc"
