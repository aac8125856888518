// SPDX-License-Identifier: Apache-2.0
#include "render/export/pixels/page_bands.h"
#include "render/export/pixels/page_overlay.h"
#include "render/export/pixels/pixel_options.h"

#include <QFile>
#include <QTest>
#include <cmath>

#include "model/edit/look.h"
#include "model/import/plan/import.h"
#include "tests/render/export/pixels/ordered_scene.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

/// Returns the whole picture, collected from its bands; empty if that failed.
render::PixelRows drawn(const render::ExportOrder& order, render::PageBands bands) {
  bands.size = pixelsOf(order.page);
  render::PixelRows all{.width = bands.size.x, .height = 0, .rgba = {}};
  const Status done =
      render::drawBands(order, bands,
                        [&all](render::PixelRows&& rows) -> Status {
                          all.height += rows.height;
                          all.rgba.insert(all.rgba.end(), rows.rgba.begin(), rows.rgba.end());
                          return Unit{};
                        },
                        {});
  if (!done.ok()) {
    qWarning("%s", done.error().text().c_str());
    return {};
  }
  return all;
}

struct Apart {
  double largest = 0.0;  ///< out of 255
  double share = 0.0;    ///< share of pixels that are more than 1/255 apart
  /// Share of those more than 4/255 apart: slanted leaders, which Qt draws in each band anew, are
  /// up to 3/255 off.
  double clearly = 0.0;
  double mean = 0.0;  ///< out of 255
};

Apart apart(const render::PixelRows& a, const render::PixelRows& b) {
  Apart found;
  const std::size_t pixels = a.rgba.size() / 4;
  for (std::size_t p = 0; p < pixels; ++p) {
    double most = 0.0;
    for (std::size_t c = 4 * p; c < 4 * p + 4; ++c) {
      most = std::max(most, std::abs(double(a.rgba[c]) - double(b.rgba[c])) / 257.0);
      found.mean += std::abs(double(a.rgba[c]) - double(b.rgba[c])) / 257.0;
    }
    found.largest = std::max(found.largest, most);
    found.share += most > 1.0;
    found.clearly += most > 4.0;
  }
  found.share /= double(pixels);
  found.clearly /= double(pixels);
  found.mean /= double(4 * pixels);
  return found;
}

/// Returns the rows with every side × side pixels averaged into one.
render::PixelRows averagedRows(const render::PixelRows& rows, int side) {
  render::PicturePiece piece{.left = 0,
                             .top = 0,
                             .width = rows.width / side * side,
                             .height = rows.height / side * side,
                             .rgba = {}};
  for (int y = 0; y < piece.height; ++y)
    piece.rgba.insert(piece.rgba.end(), rows.rgba.begin() + std::ptrdiff_t(y) * rows.width * 4,
                      rows.rgba.begin() + (std::ptrdiff_t(y) * rows.width + piece.width) * 4);
  render::PixelRows result{.width = piece.width / side, .height = piece.height / side, .rgba = {}};
  result.rgba.resize(std::size_t(result.width) * std::size_t(result.height) * 4);
  putAverages(piece, side, 0, result);
  return result;
}

/// Returns an order with every manner of drawing, some of it half clear, cut open, with a label and
/// marks.
render::ExportOrder anatomyOrder(const model::Scene& imported) {
  render::ExportOrder order;
  order.scene = imported;
  std::size_t number = 0;
  std::vector<model::NodeId> ids;
  for (const model::Node& node : imported.nodes())
    if (!node.isGroup())
      ids.push_back(node.id);
  for (const model::NodeId id : ids) {
    model::Style style = gammaStyle(0.4f + 0.55f * float(number % 9));
    style.fill = number % 4 == 0 ? model::Fill::paper : model::Fill::none;
    if (number % 5 == 1)
      style.opacity = Opacity::clamped(0.5f);
    order.scene = model::withLook(order.scene, std::span(&id, 1), style).scene;
    ++number;
  }
  cut(order.scene, model::AnatomicalView::posterior, imported.visibleBounds().centre().y,
      ids[ids.size() / 2]);
  model::Annotation label;
  label.anchors = {model::SurfacePoint{ids.front(), 0, {0.3f, 0.3f}}};
  label.text = "the first of all";
  order.scene.appendAnnotation(label);
  order.page = {.sizeMm = {240.0f, 180.0f}, .dpi = 100.0f};
  order.camera = model::anatomicalCamera(model::AnatomicalView::anterior,
                                         order.scene.visibleBounds(), 240.0f / 180.0f);
  order.labels.mode = render::LabelMode::on;
  return order;
}

}  // namespace

class PageBandsTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void noSeams_data();
  void noSeams();
  void noSeamsInAnatomy_data();
  void noSeamsInAnatomy();
  void printSizeDecides();
  void averagesHoldMore();
  void samplesStayDrawable();
  void failedBandStops();
  void aLegendAloneIsDrawn();
};

void PageBandsTest::initTestCase() {
  if (const Studio studio = openStudio(); !studio.picture)
    QSKIP(studio.absent.c_str());
}

/// A legend is drawn, or told to lack room, with no labels or marks beside it, too.
void PageBandsTest::aLegendAloneIsDrawn() {
  render::ExportOrder order = orderedPicture();
  order.labels.mode = render::LabelMode::off;
  order.marks = render::ExportMarks::none();
  order.legend = render::LegendList::none;
  const render::PageBands bands{.samples = 1, .bandSamples = 1 << 30};
  const render::PixelRows without = drawn(order, bands);
  order.legend = render::LegendList::all;
  QVERIFY(apart(without, drawn(order, bands)).largest > 100.0);
  // A ball from edge to edge.
  order.camera = frontal(12.0f);
  order.camera.eye += glm::vec3(-30.0f, 0.0f, 5.0f);
  order.camera.target += glm::vec3(-30.0f, 0.0f, 5.0f);
  const auto overlay = render::PageOverlay::create(order, pixelsOf(order.page));
  QVERIFY(overlay.ok());
  const render::ExportNotes& notes = (*overlay)->notes();
  QVERIFY(!notes.empty());
  QCOMPARE(notes.front().names, std::vector<std::string>{"legend"});
}

void PageBandsTest::noSeams_data() {
  QTest::addColumn<int>("samples");
  QTest::addColumn<int>("background");
  QTest::newRow("one sample") << 1 << int(render::Background::white);
  QTest::newRow("several samples") << 3 << int(render::Background::dark);
  QTest::newRow("transparent") << 2 << int(render::Background::transparent);
}

void PageBandsTest::noSeams() {
  QFETCH(int, samples);
  QFETCH(int, background);
  render::ExportOrder order = orderedPicture();
  order.environment.background = render::Background(background);
  for (const bool labelled : {false, true}) {
    order.labels.mode = labelled ? render::LabelMode::on : render::LabelMode::off;
    const render::PixelRows whole = drawn(order, {.samples = samples, .bandSamples = 1 << 30});
    QVERIFY(whole.height > 300);
    // Bands of 23 and of a single row of samples' squares have many seams, at odd places.
    for (const int rows : {23, 61}) {
      const render::PixelRows bands =
          drawn(order, {.samples = samples, .bandSamples = rows * samples * samples * whole.width});
      QCOMPARE(bands.height, whole.height);
      const Apart found = apart(whole, bands);
      const double share = labelled ? found.clearly : found.share;
      QVERIFY2(share <= 1e-4,
               qPrintable(QString("%1 of the pixels, up to %2").arg(share).arg(found.largest)));
    }
  }
}

void PageBandsTest::noSeamsInAnatomy_data() {
  QTest::addColumn<QString>("input");
  QTest::newRow("pelvis") << QStringLiteral(SLINE_TEST_DATA "/pelvis/bodyparts3d");
  QTest::newRow("abdomen") << QStringLiteral(
      SLINE_TEST_DATA "/abdomen/AbdominalAtlas-2015Sept-Slicer4-4Version.mrml");
}

void PageBandsTest::noSeamsInAnatomy() {
  QFETCH(QString, input);
  if (!QFile::exists(input))
    SLINE_ABSENT("no anatomy to draw");
  const std::array<std::filesystem::path, 1> inputs{input.toStdString()};
  const Result<model::Imported> imported = model::importInputs(inputs, {}, {});
  QVERIFY(imported.ok());
  const render::ExportOrder order = anatomyOrder(imported->scene);
  const render::PixelRows whole = drawn(order, {.samples = 1, .bandSamples = 1 << 30});
  const render::PixelRows bands = drawn(order, {.samples = 1, .bandSamples = 57 * whole.width});
  const Apart found = apart(whole, bands);
  QVERIFY2(found.share <= 1e-4,
           qPrintable(QString("%1 of the pixels, up to %2").arg(found.share).arg(found.largest)));
}

void PageBandsTest::printSizeDecides() {
  render::ExportOrder order = orderedPicture();
  const render::PixelRows coarse = drawn(order, {.samples = 3, .deep = true});
  order.page.dpi = 300.0f;
  const render::PixelRows fine = averagedRows(drawn(order, {.samples = 1, .deep = true}), 3);
  // 120 mm are 472 pixels at 100 per inch and 1417 at 300.
  QCOMPARE(coarse.width, fine.width);
  render::PixelRows cut = coarse;
  cut.height = std::min(coarse.height, fine.height);
  cut.rgba.resize(std::size_t(cut.width) * std::size_t(cut.height) * 4);
  render::PixelRows other = fine;
  other.rgba.resize(cut.rgba.size());
  const Apart found = apart(cut, other);
  double ink = 0.0;
  double otherInk = 0.0;
  for (std::size_t i = 0; i < cut.rgba.size(); i += 4) {
    ink += 65535.0 - cut.rgba[i];
    otherInk += 65535.0 - other.rgba[i];
  }
  QVERIFY2(std::abs(ink / otherInk - 1.0) < 0.02, qPrintable(QString::number(ink / otherInk)));
  QVERIFY2(found.mean < 2.0, qPrintable(QString::number(found.mean)));
}

void PageBandsTest::averagesHoldMore() {
  // Two samples are grey and two a step brighter: half a step between, which 8 bits cannot hold.
  const std::uint16_t low = 257 * 100;
  const std::uint16_t high = 257 * 101;
  render::PicturePiece piece{
      .left = 0, .top = 0, .width = 2, .height = 2, .rgba = std::vector<std::uint16_t>(16, low)};
  std::fill_n(piece.rgba.begin() + 4, 8, high);
  render::PixelRows rows{.width = 1, .height = 1, .rgba = std::vector<std::uint16_t>(4)};
  putAverages(piece, 2, 0, rows);
  QCOMPARE(int(rows.rgba[0]), (low + high + 1) / 2);
}

void PageBandsTest::samplesStayDrawable() {
  const auto samples = [](glm::ivec2 size, const render::PixelOptions& pixels,
                          bool pureInk = false) {
    render::ExportOrder order;
    order.of<render::PixelOptions>() = pixels;
    order.pureInk = pureInk;
    return render::usualSamples(size, order);
  };
  QCOMPARE(samples({1000, 1000}, {}), 2);
  QCOMPARE(samples({1000, 1000}, {.bits = 16}), 4);
  QCOMPARE(samples({7016, 9933}, {}), 1);
  QCOMPARE(samples({7016, 9933}, {}, true), 2);
  QCOMPARE(samples({7016, 9933}, {.samples = 3}), 3);
  // There are no more samples than a picture can have.
  for (const int asked : {0, 4})
    QVERIFY(20000 * samples({20000, 100}, {.bits = 16, .samples = asked}) <= 65535);
}

void PageBandsTest::failedBandStops() {
  const render::ExportOrder order = orderedPicture();
  int asked = 0;
  const Status done = render::drawBands(
      order, {.size = pixelsOf(order.page), .samples = 1, .bandSamples = 20 * 472},
      [&asked](render::PixelRows&&) -> Status {
        ++asked;
        return Error{.reason = "no paper"};
      },
      {});
  QVERIFY(!done.ok());
  QCOMPARE(done.error().reason, std::string("no paper"));
  QCOMPARE(asked, 1);
}

}  // namespace sline::test

SLINE_TEST(sline::test::PageBandsTest)
#include "page_bands_test.moc"
