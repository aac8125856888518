// SPDX-License-Identifier: Apache-2.0
// Tests files of at most a megabyte that are written to demand as much work and memory as they can.
#include <QFile>
#include <QTest>
#include <random>

#include "tests/model/import/dicom/surface_facts.h"
#include "tests/model/import/dicom/written_dicom.h"
#include "tests/model/import/dicom/written_images.h"
#include "tests/model/import/dicom/written_segmentation.h"
#include "tests/model/import/dicom/written_structures.h"
#include "tests/support/process_memory.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;

namespace {

constexpr double mostMiB = 2048;

using Contours = std::vector<std::vector<glm::dvec3>>;

std::vector<glm::dvec3> triangle(double z, double size) {
  return {{0, 0, z}, {size, 0, z}, {0, size, z}};
}

QByteArray contours(const Contours& all) {
  return dicomFile(structureSet({{"Greedy", "ORGAN", {}, all}}), {Syntax::implicitLittle});
}

WrittenSegmentation frames(int columns, int rows, int count) {
  WrittenSegmentation written;
  written.columns = columns;
  written.rows = rows;
  written.segments = {{1, "Greedy", "Organ", {}}};
  for (int z = 0; z < count; ++z)
    written.frames.push_back(
        {1, {0, 0, 2.0 * z}, std::vector<std::uint8_t>(std::size_t(columns) * std::size_t(rows))});
  return written;
}

QByteArray regions() {
  std::vector<WrittenRegion> many;
  for (int i = 0; i < 3000; ++i)
    many.push_back({"R", "ORGAN", {}, {triangle(0, 9), triangle(3, 9)}});
  return dicomFile(structureSet(many), {Syntax::implicitLittle});
}

QByteArray stacks() {
  Contours pairs;
  for (int i = 0; i < 4500; ++i)
    for (const double above : {0.0, 0.2})
      pairs.push_back(triangle(20.0 * i + above, 10));
  return contours(pairs);
}

QByteArray comb() {
  std::vector<glm::dvec3> teeth;
  for (int i = 0; i < 40000; ++i)
    teeth.emplace_back(0.01 * i, i % 2 == 0 ? 0.0 : 400.0, 0.0);
  return contours({teeth});
}

QByteArray tower() {
  Contours slices;
  for (int i = 0; i < 9000; ++i)
    slices.push_back(triangle(0.1 * i, i % 2 == 0 ? 1.0 : 300.0));
  return contours(slices);
}

QByteArray islands() {
  Contours scattered;
  std::mt19937 random(3);
  for (int i = 0; i < 9000; ++i) {
    const auto at = [&] { return double(random() % 20000) / 100.0; };
    const glm::dvec3 p(at(), at(), double(random() % 60));
    scattered.push_back({p, p + glm::dvec3(3, 0, 0), p + glm::dvec3(0, 3, 0)});
  }
  return contours(scattered);
}

QByteArray giants() {
  return contours({triangle(0, 99999), triangle(0.06, 0.01), triangle(90000, 1)});
}

QByteArray noise() {
  WrittenSegmentation written = frames(256, 256, 120);
  std::mt19937 random(3);
  for (WrittenFrame& frame : written.frames)
    for (std::uint8_t& pixel : frame.pixels)
      pixel = random() % 2;
  return dicomFile(segmentation(written));
}

QByteArray runs() {
  WrittenSegmentation written = frames(8192, 8192, 1);
  written.runLength = true;
  written.fractional = true;
  written.bits = 8;
  std::fill(written.frames[0].pixels.begin(), written.frames[0].pixels.end(), 255);
  return dicomFile(segmentation(written), {Syntax::runLength});
}

QByteArray deflatedMasks() {
  WrittenSegmentation written = frames(2048, 2048, 30);
  for (WrittenFrame& frame : written.frames)
    std::fill(frame.pixels.begin(), frame.pixels.end(), 1);
  return dicomFile(segmentation(written), {Syntax::deflated});
}

QByteArray deflatedNothing() {
  WrittenSegmentation written = frames(4096, 4096, 60);
  written.frames[0].pixels[0] = 1;
  return dicomFile(segmentation(written), {Syntax::deflated});
}

QByteArray layers() {
  WrittenSegmentation written = frames(512, 512, 1);
  written.segments.clear();
  std::fill(written.frames[0].pixels.begin(), written.frames[0].pixels.end(), 1);
  for (std::uint16_t number = 1; number <= 400; ++number) {
    written.segments.push_back({number, "L", "Organ", {}});
    written.frames.push_back(written.frames[0]);
    written.frames.back().segment = number;
    written.frames.back().position.z = 2.0 * (number % 300);
  }
  return dicomFile(segmentation(written), {Syntax::deflated});
}

/// Returns frames of a single value, which pack a thousandfold.
QByteArray packedMap(int side, std::size_t count, std::uint8_t value) {
  WrittenSegmentation written = frames(side, side, int(count));
  written.labelMap = true;
  written.bits = 8;
  std::fill(written.frames[0].pixels.begin(), written.frames[0].pixels.end(), value);
  const std::vector<std::uint16_t> pixels(std::size_t(side) * std::size_t(side), value);
  const QByteArray one = jpeg2000(pixels, side, side, 8, false);
  written.pack = [&](const WrittenFrame&) { return one; };
  return dicomFile(segmentation(written), {Syntax::jpeg2000});
}
QByteArray packedNothing() {
  return packedMap(2048, 20, 0);
}
QByteArray packedSolid() {
  return packedMap(1024, 40, 1);
}
QByteArray packedWithoutEnd() {
  return packedMap(256, 3500, 0);
}

/// Returns half a million elements without a value.
QByteArray crumbs() {
  WrittenSet set = identifying("1.2.840.10008.5.1.4.1.1.481.3");
  set.resize(set.size() + 500'000, text({0x0030, 0x1001}, "LO", ""));
  return dicomFile(set, {Syntax::deflated});
}

using Maker = QByteArray (*)();

}  // namespace

Q_DECLARE_METATYPE(Maker)

class TestGreedyDicom : public QObject {
  Q_OBJECT
 private slots:
  void answers_data();
  void answers();
};

void TestGreedyDicom::answers_data() {
  QTest::addColumn<Maker>("make");
  QTest::newRow("thousands of regions") << Maker(regions);
  QTest::newRow("thousands of stacks") << Maker(stacks);
  QTest::newRow("a comb") << Maker(comb);
  QTest::newRow("a tower of slices") << Maker(tower);
  QTest::newRow("scattered islands") << Maker(islands);
  QTest::newRow("giants and specks") << Maker(giants);
  QTest::newRow("noise") << Maker(noise);
  QTest::newRow("long runs") << Maker(runs);
  QTest::newRow("deflated masks") << Maker(deflatedMasks);
  QTest::newRow("deflated nothing") << Maker(deflatedNothing);
  QTest::newRow("many segments") << Maker(layers);
  QTest::newRow("crumbs") << Maker(crumbs);
  QTest::newRow("packed nothing") << Maker(packedNothing);
  QTest::newRow("packed bricks") << Maker(packedSolid);
  QTest::newRow("packed without end") << Maker(packedWithoutEnd);
}

void TestGreedyDicom::answers() {
  QFETCH(Maker, make);
  const QByteArray bytes = make();
  QVERIFY2(bytes.size() < 1'100'000, qPrintable(QString::number(bytes.size())));
  const QTemporaryDir folder;
  resetPeak();
  const auto read = readDicomBytes(folder, bytes);
  const double peak = peakResidentMiB();
  qInfo("%lld kB: peak %.0f MB, %s", qlonglong(bytes.size() / 1024), peak,
        read.ok() ? "read" : read.error().reason.c_str());
  if (sanitized)
    return;
  QVERIFY(peak < mostMiB);
}

SLINE_TEST_WITH_EVENTS(TestGreedyDicom)
#include "test_greedy_dicom.moc"
