// SPDX-License-Identifier: Apache-2.0
// Tests volumes of programs for brains: in two files, for which Analyze does not record which side
// is left, and of FreeSurfer; spoiled copies of all.
#include <QtTest>
#include <array>
#include <glm/matrix.hpp>

#include "model/import/plan/import.h"
#include "tests/model/import/readers/mesh_files.h"
#include "tests/model/import/volumes/plain_import.h"
#include "tests/model/import/volumes/written_brain.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/mutator.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

namespace {

namespace fs = std::filesystem;

/// Returns 7 at the patient's left, 9 at the right and in front, in LPS millimetres.
int twoSides(const glm::dvec3& p) {
  if (p.x > 2.0 && p.x < 6.0 && std::abs(p.y) < 3.0 && std::abs(p.z) < 3.0)
    return 7;
  return p.x < -3.0 && p.x > -8.0 && p.y < -2.0 && p.y > -7.0 && std::abs(p.z) < 2.0 ? 9 : 0;
}

/// Returns the labels on a grid of whole millimetres with axes along the columns.
WrittenVolume headAlong(const glm::dmat3& axes) {
  glm::dmat4 grid(axes);
  grid[3] = glm::dvec4(axes * glm::dvec3(-10.0), 1.0);
  return sampled(glm::ivec3(21), grid, twoSides);
}

const glm::dmat3 alongLps(1.0);
const glm::dmat3 alongLas({1, 0, 0}, {0, -1, 0}, {0, 0, 1});
const glm::dmat3 alongRas({-1, 0, 0}, {0, -1, 0}, {0, 0, 1});

/// Returns what is wrong with the places of 7 and 9, or that a surface faces inward.
QString faultOf(const Imported& imported, const std::string& seven, const std::string& nine) {
  const std::array<std::pair<std::string, Box>, 2> wanted = {
      {{seven, {{2.5f, -2.5f, -2.5f}, {5.5f, 2.5f, 2.5f}}},
       {nine, {{-7.5f, -6.5f, -1.5f}, {-3.5f, -2.5f, 1.5f}}}}};
  for (const auto& [name, box] : wanted) {
    const MeshPtr mesh = named(imported.scene, name).mesh;
    if (!mesh)
      return QString::fromStdString("there is no " + name);
    const Box& found = mesh->bounds();
    if (!(glm::length(found.low - box.low) < 0.01f && glm::length(found.high - box.high) < 0.01f))
      return QString::fromStdString(name) + " is elsewhere";
    double volume = 0.0;
    for (const Triangle& t : mesh->triangles())
      volume += double(glm::dot(mesh->positions()[t[0]],
                                glm::cross(mesh->positions()[t[1]], mesh->positions()[t[2]])));
    if (!(volume > 0.0))
      return QString::fromStdString(name) + " faces inward";
  }
  return {};
}

void writePair(const QTemporaryDir& folder, const PairBytes& pair, const QString& stem = "head") {
  writeText(folder.filePath(stem + ".hdr"), pair.header);
  writeText(folder.filePath(stem + ".img"), pair.image);
}

constexpr const char* sidedTable = "7 left_kidney 1 2 3 255\n9 right_kidney 3 2 1 255\n";

}  // namespace

class BrainFilesTest : public QObject {
  Q_OBJECT
 private slots:
  void pairs();
  void pairIsReadOnce();
  void pairsRefused();
  void analyzeSides();
  void analyzePlanes();
  void mghPlaces();
  void mghNames();
  void spoiled_data();
  void spoiled();
};

/// Either file may be named, and either may be packed, in either byte order.
void BrainFilesTest::pairs() {
  for (const std::endian order : {std::endian::little, std::endian::big})
    for (const char* endings : {".hdr .img", ".HDR .IMG", ".hdr.gz .img.gz", ".hdr .img.gz"}) {
      QTemporaryDir folder;
      const PairBytes pair = niftiPair(headAlong(alongRas), order);
      const QStringList both = QString(endings).split(' ');
      const auto write = [&](const QString& ending, const QByteArray& bytes) {
        writeText(folder.filePath("head" + ending),
                  ending.endsWith(".gz") ? gzipped(bytes) : bytes);
      };
      write(both[0], pair.header);
      write(both[1], pair.image);
      for (const QString& ending : both) {
        const Result<Imported> imported =
            importOf({folder.filePath("head" + ending).toStdString()});
        QVERIFY2(imported.ok(), imported.ok() ? endings : imported.error().text().c_str());
        const QString wrong = faultOf(*imported, "label 7", "label 9");
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        QCOMPARE(named(imported->scene, "label 7").provenance.file,
                 ("head" + both[1]).toStdString());
      }
    }
}

void BrainFilesTest::pairIsReadOnce() {
  QTemporaryDir folder;
  writePair(folder, niftiPair(headAlong(alongRas)));
  writeText(folder.filePath("radiance.hdr"), "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n");
  writeText(folder.filePath("scene.hdr"), "ENVI\nsamples = 3\n");
  writeText(folder.filePath("scene.img"), "pixels of a satellite");
  writeText(folder.filePath("disk.img"), "of some computer");
  const fs::path both[] = {inFolder(folder, "head.img"), inFolder(folder, "head.hdr")};
  for (const auto& inputs : {std::vector<fs::path>{folder.path().toStdString()},
                             std::vector<fs::path>{both[0], both[1]}}) {
    const Result<Imported> imported = importOf(inputs);
    QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
    QCOMPARE(imported->scene.structuresBelow(rootId).size(), std::size_t(2));
    QVERIFY2(imported->report.warnings.empty(), qPrintable(warningsOf(*imported)));
  }
}

void BrainFilesTest::pairsRefused() {
  QTemporaryDir folder;
  const auto told = [&](const char* name) {
    const Result<Imported> imported = importOf({inFolder(folder, name)});
    return imported.ok() ? QString() : QString::fromStdString(imported.error().text());
  };
  const PairBytes pair = niftiPair(headAlong(alongRas));
  writeText(folder.filePath("a.hdr"), pair.header);
  QVERIFY2(told("a.hdr").contains("a.img, which is not beside it"), qPrintable(told("a.hdr")));
  writeText(folder.filePath("b.img"), pair.image);
  QVERIFY2(told("b.img").contains("b.hdr, which is not beside it"), qPrintable(told("b.img")));
  writePair(folder, {"ENVI\nsamples = 3\n", "pixels"}, "c");
  QVERIFY2(told("c.hdr").contains("header of NIfTI or Analyze"), qPrintable(told("c.hdr")));
  writePair(folder, {pair.header, pair.image.chopped(5)}, "d");
  QVERIFY2(told("d.img").contains("promises"), qPrintable(told("d.img")));
  writePair(folder, {QByteArray(pair.header).replace("ni1", "n+1"), pair.image}, "e");
  QVERIFY2(told("e.img").contains("in the same file"), qPrintable(told("e.img")));
  writeText(folder.filePath("f.nii"), pair.header + pair.image);
  QVERIFY2(told("f.nii").contains("a file of its own"), qPrintable(told("f.nii")));
}

/// Only names can tell on which side the first voxels are; front and head are known, so that the
/// choice of a frame mirrors from side to side and turns nothing.
void BrainFilesTest::analyzeSides() {
  QTemporaryDir named_;
  writeText(named_.filePath("head.ctbl"), sidedTable);
  for (const glm::dmat3& axes : {alongLas, alongRas}) {
    writePair(named_, analyzePair(headAlong(axes), {.origin = glm::ivec3(11)}));
    const Result<Imported> imported = importOf({inFolder(named_, "head.img")});
    QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
    const QString wrong = faultOf(*imported, "left kidney", "right kidney");
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    QVERIFY(QString::fromStdString(imported->report.frameReason).startsWith("vote"));
  }
  QTemporaryDir silent;
  const auto read = [&](const glm::dmat3& axes, std::optional<Frame> frame) {
    writePair(silent, analyzePair(headAlong(axes), {.origin = glm::ivec3(11)}));
    return importOf({inFolder(silent, "head.hdr")}, frame);
  };
  const Result<Imported> assumed = read(alongLas, {});
  QVERIFY2(faultOf(*assumed, "label 7", "label 9").isEmpty(), "not as most programs write");
  QVERIFY2(warningsOf(*assumed).contains("does not say which side is left"),
           qPrintable(warningsOf(*assumed)));
  QVERIFY(faultOf(*read(alongRas, Frame::ras), "label 7", "label 9").isEmpty());
  QVERIFY(!faultOf(*read(alongLas, Frame::ras), "label 7", "label 9").isEmpty());
}

/// The slices run from the front and from the side, upside down too.
void BrainFilesTest::analyzePlanes() {
  const glm::dvec3 left(1, 0, 0);
  const glm::dvec3 front(0, -1, 0);
  const glm::dvec3 head(0, 0, 1);
  const glm::dmat3 planes[] = {{left, front, head},  {left, head, front},  {front, head, left},
                               {left, -front, head}, {left, -head, front}, {front, -head, left}};
  for (std::size_t i = 0; i < std::size(planes); ++i) {
    QTemporaryDir folder;
    writePair(folder, analyzePair(headAlong(planes[i]),
                                  {.orientation = char(i), .origin = glm::ivec3(11)}));
    const QString wrong = faultOf(*importOf({inFolder(folder, "head.img")}), "label 7", "label 9");
    QVERIFY2(wrong.isEmpty(), qPrintable(QString::number(i) + ' ' + wrong));
  }
}

void BrainFilesTest::mghPlaces() {
  for (const glm::dmat3& axes : {alongLps, alongLas, alongRas})
    for (const Number type :
         {Number::uint8, Number::int32, Number::float32, Number::int16, Number::uint16}) {
      QTemporaryDir folder;
      const QByteArray bytes = mghFile(headAlong(axes), type);
      writeText(folder.filePath("head.mgz"), gzipped(bytes));
      writeText(folder.filePath("plain.mgh"), bytes);
      for (const char* name : {"head.mgz", "plain.mgh"}) {
        const Result<Imported> imported = importOf({inFolder(folder, name)});
        QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
        const QString wrong = faultOf(*imported, "label 7", "label 9");
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
      }
    }
  QTemporaryDir folder;
  for (const int no : {0, -1}) {
    writeText(folder.filePath("head.mgh"),
              mghFile(headAlong(alongLas), Number::uint8, {.placeKnown = std::int16_t(no)}));
    const Result<Imported> imported = importOf({inFolder(folder, "head.mgh")});
    QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
    QVERIFY(warningsOf(*imported).contains("which side is left"));
  }
}

void BrainFilesTest::mghNames() {
  QTemporaryDir folder;
  writeText(folder.filePath("head.mgz"),
            gzipped(mghFile(headAlong(alongRas), Number::int32, {.footer = mghColourTable()})));
  const Result<Imported> imported = importOf({inFolder(folder, "head.mgz")});
  QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
  QVERIFY(named(imported->scene, "left kidney").mesh);
  QCOMPARE(named(imported->scene, "strange thing").style.colour, std::optional(Colour{12, 240, 7}));
}

void BrainFilesTest::spoiled_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QByteArray>("bytes");
  QTest::addColumn<QByteArray>("beside");
  const WrittenVolume head = headAlong(alongRas);
  const PairBytes nifti = niftiPair(head);
  const PairBytes analyze = analyzePair(head);
  const QByteArray mgh = mghFile(head, Number::int32, {.footer = mghColourTable()});
  QTest::newRow("NIfTI header") << "s.hdr" << nifti.header << nifti.image;
  QTest::newRow("Analyze header") << "s.hdr" << analyze.header << analyze.image;
  QTest::newRow("MGH") << "s.mgh" << mgh << QByteArray();
  QTest::newRow("MGZ") << "s.mgz" << gzipped(mgh) << QByteArray();
  QTest::newRow("FreeSurfer surface")
      << "s.pial" << freeSurferCube(freeSurferGeometry(glm::dmat3(1.0), {})) << QByteArray();
  for (const char* encoding : {"ASCII", "Base64Binary", "GZipBase64Binary"})
    QTest::addRow("GIFTI %s", encoding)
        << "s.gii" << giftiCube({.encoding = encoding}) << QByteArray();
  QTest::newRow("packed mesh") << "s.obj.gz" << gzipped(cubeFile("obj")) << QByteArray();
}

/// 200 copies of each give a sound surface or an error with a remedy.
void BrainFilesTest::spoiled() {
  QFETCH(QString, name);
  QFETCH(QByteArray, bytes);
  QFETCH(QByteArray, beside);
  QTemporaryDir folder;
  if (!beside.isEmpty())
    writeText(folder.filePath("s.img"), beside);
  Mutator mutate(20260417, {[](Mutator& random, QByteArray& all, qsizetype at) {
                   // A change matters most in headers.
                   at %= std::min<qsizetype>(all.size(), 100);
                   all[at] = char(random.below(256));
                 }});
  int refused = 0;
  for (int i = 0; i < 200; ++i) {
    const Result<RawMeshes> read = readBytes(folder, name, mutate(bytes));
    if (read)
      QVERIFY2(isSound(*read), qPrintable(QString("copy %1").arg(i)));
    else
      QVERIFY(!read.error().reason.empty() && !read.error().remedy.empty());
    refused += !read.ok();
  }
  qInfo("%d of 200 refused", refused);
  QVERIFY(refused > 10);
}

SLINE_TEST(BrainFilesTest)
#include "test_brain_files.moc"
