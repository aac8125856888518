// SPDX-License-Identifier: Apache-2.0
#include "render/measures/contact_sheet.h"

#include <QtTest>
#include <array>

#include "tests/render/measures/pictures.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using render::Image;

class ContactSheetTest : public QObject {
  Q_OBJECT
 private slots:
  void picturesLieInRows();
  void labelsAreInk();
  void diagramShowsWhatBreaksALimit();
  void stackedKeepsBoth();
};

namespace {

using Pixel = std::array<int, 4>;

Image plain(int width, int height, int grey) {
  return painted(width, height, [&](int, int) { return Pixel{grey, grey, grey, 255}; });
}

/// Returns the number of pixels of the image with these three channels.
int count(const Image& image, int red, int green, int blue) {
  int found = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    found += image.rgba[i] == red && image.rgba[i + 1] == green && image.rgba[i + 2] == blue;
  return found;
}

render::Ramp evenRamp() {
  render::Ramp ramp;
  ramp.steps.assign(render::rampSteps, 0.01);
  for (std::size_t s = 0; s < ramp.stages.size(); ++s)
    ramp.stages[s] = render::measureStage(
        std::span(ramp.steps).subspan(s * render::stepsPerStage, render::stepsPerStage), double(s),
        0.2);
  for (int i = 0; i <= render::rampSteps; ++i)
    ramp.tone.luminance.push_back(1.0 - 0.005 * i);
  return ramp;
}

int reds(const Image& image) {
  return count(image, 205, 45, 40);
}

}  // namespace

void ContactSheetTest::picturesLieInRows() {
  std::vector<render::SheetPicture> pictures;
  for (int i = 0; i < 5; ++i)
    pictures.push_back({"", plain(40, 30, 40 + 30 * i)});
  const Image sheet = render::contactSheet(pictures, 3);
  QVERIFY(sheet.width >= 3 * 40 && sheet.width < 3 * 50);
  QVERIFY(sheet.height >= 2 * 30 && sheet.height < 2 * 50);
  for (int i = 0; i < 5; ++i)
    QCOMPARE(count(sheet, 40 + 30 * i, 40 + 30 * i, 40 + 30 * i), 40 * 30);
  QCOMPARE(sheet.rgba.size(), std::size_t(sheet.width * sheet.height * 4));
  QVERIFY(render::contactSheet({}, 3).rgba.empty());
}

void ContactSheetTest::labelsAreInk() {
  const std::vector<render::SheetPicture> bare{{"", plain(60, 30, 200)}};
  const std::vector<render::SheetPicture> one{{"1.5", plain(60, 30, 200)}};
  const std::vector<render::SheetPicture> other{{"1.6", plain(60, 30, 200)}};
  QCOMPARE(count(render::contactSheet(bare, 1), 0, 0, 0), 0);
  QVERIFY(count(render::contactSheet(one, 1), 0, 0, 0) >= 15);
  QVERIFY(render::contactSheet(one, 1) != render::contactSheet(other, 1));
}

void ContactSheetTest::diagramShowsWhatBreaksALimit() {
  render::Ramp ramp = evenRamp();
  QCOMPARE(reds(render::rampDiagram(ramp, 400, 120)), 0);
  ramp.steps[30] = 0.2;
  ramp.stages[1] = render::measureStage(std::span(ramp.steps).subspan(20, 20), 1.0, 0.3);
  QVERIFY(ramp.stages[1].jumps());
  QVERIFY(reds(render::rampDiagram(ramp, 400, 120)) > 50);
  ramp = evenRamp();
  ramp.tone.luminance[80] = 0.1;
  QVERIFY(reds(render::rampDiagram(ramp, 400, 120)) > 5);
}

void ContactSheetTest::stackedKeepsBoth() {
  const Image image = render::stacked(plain(10, 4, 50), plain(6, 5, 90));
  QCOMPARE(image.width, 10);
  QCOMPARE(image.height, 9);
  QCOMPARE(count(image, 50, 50, 50), 40);
  QCOMPARE(count(image, 90, 90, 90), 30);
  QCOMPARE(count(image, 255, 255, 255), 20);
}

SLINE_TEST_WITH_EVENTS(ContactSheetTest)
#include "contact_sheet_test.moc"
