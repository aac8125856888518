// SPDX-License-Identifier: Apache-2.0
// Tests label volumes of other programs: an abdominal atlas beside its own surfaces, an automatic
// segmentation, and a collection of NRRD files.
#include <QFileInfo>
#include <QTemporaryDir>
#include <QtTest>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>

#include "model/import/kinds/file_kinds.h"
#include "model/import/naming/names.h"
#include "model/import/plan/import.h"
#include "model/import/volumes/volume_readers.h"
#include "tests/model/import/volumes/written_volumes.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

namespace {

std::filesystem::path data(const char* below) {
  return std::filesystem::path(SLINE_TEST_DATA) / below;
}

bool absent(const char* below) {
  return !std::filesystem::exists(data(below));
}

Result<Imported> import(const std::filesystem::path& input, const ImportOptions& options = {}) {
  return importInputs(std::array{input}, options);
}

float distanceToSegment(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b) {
  const glm::vec3 d = b - a;
  const float square = glm::dot(d, d);
  const float t = square > 0.0f ? glm::clamp(glm::dot(p - a, d) / square, 0.0f, 1.0f) : 0.0f;
  return glm::length(p - a - t * d);
}

float distanceToTriangle(const glm::vec3& p, const std::array<glm::vec3, 3>& t) {
  const glm::vec3 n = glm::cross(t[1] - t[0], t[2] - t[0]);
  bool above = glm::dot(n, n) > 0.0f;
  for (std::size_t i = 0; i < 3; ++i)
    above = above && glm::dot(glm::cross(t[(i + 1) % 3] - t[i], p - t[i]), n) >= 0.0f;
  if (above)
    return std::abs(glm::dot(p - t[0], glm::normalize(n)));
  return std::min({distanceToSegment(p, t[0], t[1]), distanceToSegment(p, t[1], t[2]),
                   distanceToSegment(p, t[2], t[0])});
}

/// Measures distances to a mesh, from its triangles sorted into cubes of 3 mm.
class DistanceTo {
 public:
  explicit DistanceTo(const Mesh& mesh) : m_mesh(mesh) {
    for (std::uint32_t i = 0; i < mesh.triangleCount(); ++i) {
      Box box;
      for (const std::uint32_t v : mesh.triangles()[i])
        box.add(mesh.positions()[v]);
      const glm::ivec3 low = cube(box.low);
      const glm::ivec3 high = cube(box.high);
      for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
          for (int x = low.x; x <= high.x; ++x)
            m_cubes[{x, y, z}].push_back(i);
    }
  }

  float operator()(const glm::vec3& p) const {
    const glm::ivec3 at = cube(p);
    float best = 1e9f;
    for (int reach = 0; reach < 30 && best > float(reach - 1) * side; ++reach)
      for (int z = -reach; z <= reach; ++z)
        for (int y = -reach; y <= reach; ++y)
          for (int x = -reach; x <= reach; ++x)
            if (std::max({std::abs(x), std::abs(y), std::abs(z)}) == reach)
              look({at.x + x, at.y + y, at.z + z}, p, best);
    return best;
  }

 private:
  static constexpr float side = 3.0f;
  static glm::ivec3 cube(const glm::vec3& p) { return glm::ivec3(glm::floor(p / side)); }

  void look(const std::array<int, 3>& cubeAt, const glm::vec3& p, float& best) const {
    const auto found = m_cubes.find(cubeAt);
    if (found == m_cubes.end())
      return;
    for (const std::uint32_t i : found->second) {
      const Triangle& t = m_mesh.triangles()[i];
      const auto& at = m_mesh.positions();
      best = std::min(best, distanceToTriangle(p, {at[t[0]], at[t[1]], at[t[2]]}));
    }
  }

  const Mesh& m_mesh;
  std::map<std::array<int, 3>, std::vector<std::uint32_t>> m_cubes;
};

struct Deviation {
  double mean = 0.0;
  double most = 0.0;
};
Deviation deviation(const Mesh& from, const Mesh& to) {
  const DistanceTo distance(to);
  Deviation result;
  for (const glm::vec3& p : from.positions()) {
    const double d = double(distance(p));
    result.mean += d / double(from.vertexCount());
    result.most = std::max(result.most, d);
  }
  return result;
}

}  // namespace

class RealVolumesTest : public QObject {
  Q_OBJECT
 private slots:
  void atlas();
  void automaticSegmentation();
  void nrrdCollection_data();
  void nrrdCollection();
};

/// There are 95 structures with the colour table's names, closed; the liver is where the atlas's
/// own surface of it is.
void RealVolumesTest::atlas() {
  const char* labels = "labelmap/spl_abdomen/spl_abdomen_labels.nrrd";
  const char* own = "abdomen/Data/Model_3_liver.vtk";
  if (absent(labels) || absent(own))
    SLINE_ABSENT("the folder of real data is absent");
  const Result<Imported> imported = import(data(labels));
  QVERIFY(imported.ok());
  QCOMPARE(imported->scene.structuresBelow(rootId).size(), std::size_t(95));
  QVERIFY(imported->report.warnings.empty());
  const Node& liver = named(imported->scene, "liver");
  QCOMPARE(imported->scene.groupPath(liver.id), std::string("Digestive system"));
  QVERIFY(liver.mesh->bounds().centre().x < named(imported->scene, "spleen").mesh->bounds().low.x);
  ImportOptions asItIs;
  asItIs.frame = Frame::ras;
  asItIs.smoothing.mode = Smoothing::Mode::off;
  const Result<Imported> atlasLiver = import(data(own), asItIs);
  QVERIFY(atlasLiver.ok());
  const Mesh& theirs = *atlasLiver->scene.nodes().front().mesh;
  const Deviation there = deviation(*liver.mesh, theirs);
  const Deviation back = deviation(theirs, *liver.mesh);
  const QString found = QString("mean %1 and %2 mm, most %3 and %4 mm; moved by up to %5 mm")
                            .arg(there.mean)
                            .arg(back.mean)
                            .arg(there.most)
                            .arg(back.most)
                            .arg(double(liver.provenance.displacementMm));
  qInfo("liver: %s", qPrintable(found));
  QVERIFY2(there.mean < 0.5 && back.mean < 0.5, qPrintable(found));
  for (const Node& node : imported->scene.nodes())
    if (node.mesh)
      QVERIFY2(node.provenance.displacementMm < 2.02f, node.name.c_str());
}

/// There are 61 structures with the header's names, and the same from a folder with one file for
/// each.
void RealVolumesTest::automaticSegmentation() {
  const char* labels = "labelmap/totalsegmentator/ct_total_labels_3mm.nii.gz";
  if (absent(labels))
    SLINE_ABSENT("the folder of real data is absent");
  // The file lies away from its table, so that the names are the header's.
  QTemporaryDir alone;
  const QString copy = alone.filePath("labels.nii.gz");
  QVERIFY(QFile::copy(QString::fromStdString(data(labels).string()), copy));
  const Result<Imported> whole = import(copy.toStdString());
  QVERIFY(whole.ok());
  QCOMPARE(whole->scene.structuresBelow(rootId).size(), std::size_t(61));
  for (const char* name : {"liver", "kidney right", "vertebrae L3", "urinary bladder"})
    QVERIFY2(named(whole->scene, name).mesh != nullptr, name);
  QCOMPARE(whole->scene.groupPath(named(whole->scene, "vertebrae L3").id), std::string("Bones"));
  QVERIFY(named(whole->scene, "kidney right").mesh->bounds().centre().x <
          named(whole->scene, "kidney left").mesh->bounds().centre().x);

  const Result<VolumeRead> read = readVolume(copy.toStdString(), {});
  QVERIFY(read.ok());
  const LabelVolume& volume = read->labels.volumes.front();
  QTemporaryDir folder;
  for (std::size_t i = 0; i < volume.labels.size(); ++i) {
    WrittenVolume mask{volume.size, volume.toLps, {}};
    for (const std::uint16_t voxel : volume.voxels)
      mask.values.push_back(voxel == i + 1);
    writeText(folder.filePath(QString::fromStdString(volume.labels[i].name) + ".nii.gz"),
              gzipped(niftiFile(mask)));
  }
  const Result<Imported> parts = import(folder.path().toStdString());
  QVERIFY(parts.ok());
  QCOMPARE(parts->scene.structuresBelow(rootId).size(), std::size_t(61));
  for (const Node& node : whole->scene.nodes()) {
    if (!node.mesh)
      continue;
    const Node& same = named(parts->scene, node.name);
    QVERIFY2(same.mesh != nullptr, node.name.c_str());
    // The order of the labels only decides where diagonal neighbours are separated.
    QVERIFY(std::abs(double(same.mesh->triangleCount()) / double(node.mesh->triangleCount()) -
                     1.0) < 0.01);
    QVERIFY(glm::length(same.mesh->bounds().low - node.mesh->bounds().low) < 1.0f);
    QCOMPARE(parts->scene.groupPath(same.id), whole->scene.groupPath(node.id));
  }
}

void RealVolumesTest::nrrdCollection_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<QString>("refusal");
  for (const char* ending :
       {".nhdr", ".nii.gz", ".nrrd", "_byteskip_minus_one.nhdr", "_byteskip_minus_one_nifti.nhdr",
        "_bz2.nrrd", "_gz.nrrd", "_gz_byteskip_minus_one.nrrd", "_gz_lineskip.nrrd", "_nifti.nhdr"})
    QTest::newRow(ending) << QString("BallBinary30x30x30") + ending << QString();
  const auto refused = [](const char* file, const char* reason) {
    QTest::newRow(file) << QString(file) << QString(reason);
  };
  refused("BallBinary30x30x30_byteskip_minus_five.nhdr", "neither a number of bytes nor -1");
  refused("test1d_ascii.nrrd", "has 1 axis");
  refused("test2d_ascii.nrrd", "has 2 axes");
  refused("test_customFields.nrrd", "has 1 axis");
  refused("test_simple4d_raw.nrrd", "not whole numbers");
}

/// Each file that holds the ball gives the same one.
void RealVolumesTest::nrrdCollection() {
  QFETCH(QString, file);
  QFETCH(QString, refusal);
  const std::string below = "formats/nrrd/" + file.toStdString();
  if (absent(below.c_str()))
    SLINE_ABSENT("the folder of real data is absent");
  ReadOptions options;
  options.smoothing.mode = Smoothing::Mode::off;
  const Result<RawMeshes> read = readSurfaces(data(below.c_str()), options);
  if (!refusal.isEmpty()) {
    QVERIFY(!read.ok());
    QVERIFY2(QString::fromStdString(read.error().text()).contains(refusal),
             read.error().text().c_str());
    return;
  }
  QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
  QCOMPARE(read->meshes.size(), std::size_t(1));
  const RawMesh& ball = read->meshes.front();
  const Result<RawMeshes> plain =
      readSurfaces(data("formats/nrrd/BallBinary30x30x30.nrrd"), options);
  QCOMPARE(ball.triangles.size(), plain->meshes.front().triangles.size());
  if (file.endsWith(".nhdr") || file.endsWith(".nrrd"))
    QCOMPARE(ball.positions, plain->meshes.front().positions);
}

SLINE_TEST(RealVolumesTest)
#include "test_real_volumes.moc"
