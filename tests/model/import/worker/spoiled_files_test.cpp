// SPDX-License-Identifier: Apache-2.0
// Tests spoiled files of the kinds that libraries read: whatever the libraries make of them, a
// message comes.
#include <QtTest>

#include "tests/model/import/dicom/surface_facts.h"
#include "tests/model/import/dicom/written_images.h"
#include "tests/model/import/dicom/written_segmentation.h"
#include "tests/model/import/dicom/written_structures.h"
#include "tests/model/import/foreign/written_scenes.h"
#include "tests/model/import/worker/spoiled_copies.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

QByteArray regions() {
  return dicomFile(structureSet({{"Ball", "ORGAN", Colour{1, 2, 3}, ball({0, 0, 0}, 10, -8, 4)}}));
}

QByteArray masks(bool labelMap) {
  WrittenSegmentation written;
  written.segments = {{1, "Spleen", "Organ", {}}};
  written.labelMap = labelMap;
  if (labelMap)
    written.bits = 8;
  for (int z = 0; z < 4; ++z)
    written.frames.push_back({1, {0, 0, 2.0 * z}, std::vector<std::uint8_t>(64, 1)});
  return dicomFile(segmentation(written));
}

}  // namespace

class SpoiledFilesTest : public QObject {
  Q_OBJECT
 private slots:
  void aMessageEach_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("text.fbx") << fbxText();
    QTest::newRow("binary.fbx") << fbxBinary();
    QTest::newRow("kidneys.dae") << collada();
    QTest::newRow("kidneys.blend") << blend();
    QTest::newRow("kidney.vtu") << vtuText();
    QTest::newRow("regions.dcm") << regions();
    QTest::newRow("masks.dcm") << masks(false);
    QTest::newRow("labels.dcm") << masks(true);
    QTest::newRow("kidneys.x3d") << x3dXml();
    QTest::newRow("kidneys.wrl") << vrml();
    QTest::newRow("kidneys.3ds") << threeDs();
  }
  void aMessageEach() {
    QFETCH(QByteArray, bytes);
    judgeSpoiledCopies(QString::fromLatin1(QTest::currentDataTag()), bytes);
  }
};

}  // namespace sline::test

SLINE_TEST(sline::test::SpoiledFilesTest)
#include "spoiled_files_test.moc"
