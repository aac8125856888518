// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/reload.h"

#include <QDir>
#include <QtTest>
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "model/scene/known_frame.h"
#include "model/scene_file/fingerprint.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using Fate = ReloadedFile::Fate;

namespace {

std::filesystem::path path(const QTemporaryDir& folder, const QString& below = {}) {
  return folder.filePath(below).toStdString();
}

/// Returns "a.ply replaced; b.ply unchanged".
QString told(const Reloaded& reloaded) {
  static constexpr std::array<const char*, 4> fates{"replaced", "unchanged", "absent", "failed"};
  QStringList lines;
  for (const ReloadedFile& file : reloaded.files)
    lines << QString::fromStdString(file.file) + " " + fates[std::size_t(file.fate)];
  return lines.join("; ");
}

const ReloadedFile& line(const Reloaded& reloaded, const std::string& file) {
  static const ReloadedFile none;
  for (const ReloadedFile& one : reloaded.files)
    if (one.file == file)
      return one;
  return none;
}

Scene imported(const QTemporaryDir& folder, const ImportOptions& options = {}) {
  const auto result = importInputs(std::array{path(folder)}, options);
  return result.ok() ? result->scene : Scene();
}

const QByteArray twoGroups =
    "o left\nv 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\no right\nv 0 0 5\nv 9 0 5\nv 0 9 5\nf 4 5 6\n";

/// Returns the scene with other fingerprints, as if its files had been different when they were
/// read.
Scene forgotten(Scene scene) {
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes)
    if (node.provenance.fingerprint)
      node.provenance.fingerprint->crc ^= 1;
  scene.setNodes(std::move(nodes));
  return scene;
}

}  // namespace

class ReloadTest : public QObject {
  Q_OBJECT
 private slots:
  void fingerprints_data();
  void fingerprints();
  void onlyWhatHasChanged();
  void allButTheMeshStays();
  void readAsItWasBefore_data();
  void readAsItWasBefore();
  void decimatedAsFar();
  void surfacesByName();
  void annotationsGoToTheNearestPoint();
  void whatIsPaintedIsFoundAgain();
  void whichFileIsMeant();
  void whatIsElsewhereIsTold();
  void whatCannotBeRead();
};

void ReloadTest::fingerprints_data() {
  QTest::addColumn<QByteArray>("bytes");
  QTest::addColumn<quint32>("crc");
  QTest::newRow("nothing") << QByteArray() << quint32(0);
  QTest::newRow("the check value") << QByteArray("123456789") << quint32(0xcbf43926);
  QTest::newRow("zeros") << QByteArray(32, '\0') << quint32(0x190a55ad);
}

void ReloadTest::fingerprints() {
  QFETCH(QByteArray, bytes);
  QFETCH(quint32, crc);
  const Fingerprint expected{std::uint64_t(bytes.size()), crc};
  QVERIFY(fingerprintOf(std::string_view(bytes.data(), std::size_t(bytes.size()))) == expected);
  const QTemporaryDir folder;
  test::writeText(folder.filePath("a"), bytes);
  const auto ofFile = fingerprintOfFile(path(folder, "a"));
  QVERIFY(ofFile.ok() && *ofFile == expected);
  QVERIFY(!fingerprintOfFile(path(folder, "b")).ok());
}

void ReloadTest::onlyWhatHasChanged() {
  const QTemporaryDir folder;
  for (const char* name : {"liver.ply", "spleen.stl", "deep/kidney.obj"})
    test::writeMesh(folder.filePath(name), *test::octahedron({5, 6, 7}, 20));
  const Scene scene = imported(folder);
  QCOMPARE(scene.structuresBelow(rootId).size(), std::size_t(3));
  const Reloaded same = reload(scene, std::array{path(folder)});
  QVERIFY(!same.changed && same.scene == scene);
  QCOMPARE(told(same), QString("kidney.obj unchanged; liver.ply unchanged; spleen.stl unchanged"));
  test::writeMesh(folder.filePath("deep/kidney.obj"), *test::octahedron({5, 6, 7}, 30));
  QFile::remove(folder.filePath("liver.ply"));
  const Reloaded changed = reload(scene, std::array{path(folder)});
  QVERIFY(changed.changed);
  QCOMPARE(told(changed), QString("kidney.obj replaced; liver.ply absent; spleen.stl unchanged"));
  const Node& kidney = test::named(changed.scene, "kidney");
  QCOMPARE(kidney.mesh->bounds().size().x, 60.0f);
  QCOMPARE(line(changed, "kidney.obj").structures, std::vector<NodeId>{kidney.id});
  QVERIFY(test::named(changed.scene, "liver") == test::named(scene, "liver"));
  // The new state is known now.
  QVERIFY(!reload(changed.scene, std::array{path(folder)}).changed);
}

void ReloadTest::allButTheMeshStays() {
  const QTemporaryDir folder;
  test::writeMesh(folder.filePath("liver.ply"), *test::octahedron({}, 20));
  Scene scene = imported(folder);
  std::vector<Node> nodes = scene.nodes();
  nodes[0].name = "Hepar";
  nodes[0].style.gamma = Gamma::clamped(4);
  scene.setNodes(nodes);
  scene.appendSection({.name = "half", .scope = nodes[0].id});
  scene.setViews({{.name = "v", .looks = std::vector<Look>{{.node = nodes[0].id}}}});
  test::writeMesh(folder.filePath("liver.ply"), *test::octahedron({}, 25));
  const Reloaded reloaded = reload(scene, std::array{path(folder)});
  QVERIFY(reloaded.changed);
  Node after = reloaded.scene.nodes()[0];
  QVERIFY(*after.mesh != *nodes[0].mesh);
  after.mesh = nodes[0].mesh;
  after.provenance.fingerprint = nodes[0].provenance.fingerprint;
  QVERIFY(after == nodes[0]);
  QVERIFY(reloaded.scene.views() == scene.views());
  QVERIFY(reloaded.scene.sections() == scene.sections());
}

void ReloadTest::readAsItWasBefore_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<int>("frame");
  QTest::addColumn<float>("unit");
  QTest::addColumn<int>("smoothing");  // -1: automatic
  QTest::newRow("as it came") << "liver.ply" << -1 << 0.0f << -1;
  QTest::newRow("RAS") << "liver.ply" << int(Frame::ras) << 0.0f << -1;
  QTest::newRow("as in the file") << "liver.ply" << int(Frame::file) << 0.0f << -1;
  QTest::newRow("inches") << "liver.stl" << -1 << 25.4f << -1;
  QTest::newRow("glTF") << "liver.glb" << -1 << 0.0f << -1;
  QTest::newRow("smoothed") << "liver.ply" << -1 << 0.0f << 7;
  QTest::newRow("left alone") << "liver.obj" << -1 << 0.0f << 0;
}

void ReloadTest::readAsItWasBefore() {
  QFETCH(QString, file);
  QFETCH(int, frame);
  QFETCH(float, unit);
  QFETCH(int, smoothing);
  const QTemporaryDir folder;
  // The mesh is a ball of voxels, with steps that are smoothed unless an option says otherwise.
  const auto ball = [](const glm::vec3& p) { return glm::length(p - glm::vec3(12.0f)) < 9.0f; };
  test::writeMesh(folder.filePath(file), *test::voxelSurface(24, ball));
  ImportOptions options;
  if (frame >= 0)
    options.frame = Frame(frame);
  if (unit > 0.0f)
    options.unit = unit;
  if (smoothing >= 0)
    options.smoothing = {smoothing == 0 ? Smoothing::Mode::off : Smoothing::Mode::steps, smoothing};
  const Scene scene = imported(folder, options);
  QCOMPARE(scene.nodes().size(), std::size_t(1));
  QVERIFY((scene.nodes()[0].provenance.smoothingSteps > 0) == (smoothing != 0));
  const Reloaded again = reload(forgotten(scene), std::array{path(folder)});
  QCOMPARE(told(again), file + " replaced");
  QVERIFY(*again.scene.nodes()[0].mesh == *scene.nodes()[0].mesh);
  QVERIFY(again.scene.nodes()[0].provenance == scene.nodes()[0].provenance);
}

void ReloadTest::decimatedAsFar() {
  const QTemporaryDir folder;
  const auto ball = [](const glm::vec3& p) { return glm::length(p - glm::vec3(12.0f)) < 9.0f; };
  test::writeMesh(folder.filePath("liver.ply"), *test::voxelSurface(24, ball));
  ImportOptions options;
  options.decimateMm = 0.5f;
  const Scene scene = imported(folder, options);
  const Node before = scene.nodes().at(0);
  QVERIFY(before.provenance.decimatedFrom > 0);
  const Reloaded again = reload(forgotten(scene), std::array{path(folder)});
  const Node after = again.scene.nodes().at(0);
  QCOMPARE(after.provenance.decimatedFrom, before.provenance.decimatedFrom);
  QVERIFY(after.provenance.decimationMm > 0.0f &&
          after.provenance.decimationMm <= before.provenance.decimationMm);
  QVERIFY(int(after.mesh->triangleCount()) < before.provenance.decimatedFrom);
}

void ReloadTest::surfacesByName() {
  const QTemporaryDir folder;
  test::writeText(folder.filePath("pair.obj"), twoGroups);
  const Scene scene = imported(folder, {.smoothing = {Smoothing::Mode::off}});
  QCOMPARE(scene.nodes().size(), std::size_t(2));
  QCOMPARE(scene.nodes()[1].provenance.part, std::string("right"));
  QByteArray turned = twoGroups;
  turned.replace("o left", "o middle").replace("0 9 5", "0 7 5");
  test::writeText(folder.filePath("pair.obj"), turned);
  const Reloaded reloaded = reload(scene, std::array{path(folder)});
  QCOMPARE(told(reloaded), QString("pair.obj failed; pair.obj replaced"));
  QVERIFY(reloaded.files[0].reason.find("no surface \"left\"") != std::string::npos);
  QVERIFY(*reloaded.scene.nodes()[0].mesh == *scene.nodes()[0].mesh);
  QCOMPARE(reloaded.scene.nodes()[1].mesh->bounds().size().y, 7.0f);
  QVERIFY(reloaded.warnings[0].reason.find("middle") != std::string::npos);
}

void ReloadTest::annotationsGoToTheNearestPoint() {
  const QTemporaryDir folder;
  for (const char* name : {"liver.ply", "spleen.ply"})
    test::writeMesh(folder.filePath(name), *test::octahedron({}, 20));
  Scene scene = imported(folder);
  const NodeId liver = test::named(scene, "liver").id;
  const NodeId spleen = test::named(scene, "spleen").id;
  const auto pin = [&](const Anchor& anchor) {
    scene.appendAnnotation({.kind = AnnotationKind::pin, .anchors = {anchor}});
  };
  pin(SurfacePoint{liver, 2, {1.0f / 3, 1.0f / 3}});
  pin(SurfacePoint{spleen, 2, {1.0f / 3, 1.0f / 3}});
  pin(glm::vec3(1, 2, 3));
  test::writeMesh(folder.filePath("liver.ply"), *test::octahedron({}, 26));
  const Reloaded reloaded = reload(scene, std::array{path(folder)});
  QVERIFY(reloaded.changed);
  const auto place = [](const Scene& of, std::size_t i) {
    return *of.placeOf(of.annotations()[i].anchors[0]);
  };
  // The middle of a face goes straight out to the middle of the same face.
  QVERIFY(glm::length(place(reloaded.scene, 0) - 1.3f * place(scene, 0)) < 1e-3f);
  QVERIFY(reloaded.scene.annotations()[1] == scene.annotations()[1]);
  QVERIFY(reloaded.scene.annotations()[2] == scene.annotations()[2]);
}

void ReloadTest::whatIsPaintedIsFoundAgain() {
  const QTemporaryDir folder;
  const MeshPtr mesh = test::octahedron({}, 20);
  const auto turned = [&](std::size_t first) {
    // The vertices in another order.
    std::vector<glm::vec3> positions(mesh->positions().begin(), mesh->positions().end());
    std::rotate(positions.begin(), positions.begin() + std::ptrdiff_t(first), positions.end());
    std::vector<Triangle> triangles(mesh->triangles().begin(), mesh->triangles().end());
    for (Triangle& t : triangles)
      for (std::uint32_t& v : t)
        v = std::uint32_t((v + positions.size() - first) % positions.size());
    return *Mesh::create(std::move(positions), std::move(triangles));
  };
  for (const char* name : {"liver.ply", "spleen.ply"})
    test::writeMesh(folder.filePath(name), *mesh);
  Scene scene = imported(folder);
  std::vector<Node> nodes = scene.nodes();
  const auto at = [](const Node& node, const glm::vec3& place) {
    const auto positions = node.mesh->positions();
    const auto found = std::find_if(positions.begin(), positions.end(), [&](const glm::vec3& p) {
      return glm::distance(p, place) < 1e-3f;
    });
    return std::size_t(found - positions.begin());
  };
  const glm::vec3 tip(0.0f, 0.0f, 20.0f);
  for (Node& node : nodes) {
    Paint paint(node.mesh->vertexCount(), 0);
    paint.at(at(node, tip)) = 200;
    node.paint = std::make_shared<const Paint>(std::move(paint));
  }
  scene.setNodes(std::move(nodes));
  test::writeMesh(folder.filePath("liver.ply"), turned(2));
  test::writeMesh(folder.filePath("spleen.ply"), *test::octahedron({200, 0, 0}, 20));
  const Reloaded reloaded = reload(scene, std::array{path(folder)});
  QCOMPARE(told(reloaded), QString("liver.ply replaced; spleen.ply replaced"));
  const Node& liver = test::named(reloaded.scene, "liver");
  QVERIFY(at(liver, tip) != at(test::named(scene, "liver"), tip));
  QVERIFY(liver.paint);
  for (std::size_t v = 0; v < liver.paint->size(); ++v)
    QCOMPARE(int((*liver.paint)[v]), v == at(liver, tip) ? 200 : 0);
  QVERIFY(!test::named(reloaded.scene, "spleen").paint);
  QCOMPARE(reloaded.warnings.size(), std::size_t(2));
  QVERIFY(reloaded.warnings[0].reason.find("away from where it was") != std::string::npos);
  QCOMPARE(reloaded.warnings[1].file, std::string("spleen.ply"));
  QVERIFY(reloaded.warnings[1].reason.find("100 % of what was painted") != std::string::npos);
  // What was painted while the files were read counts.
  std::vector<Node> repainted = scene.nodes();
  for (Node& node : repainted)
    if (node.name == "liver")
      node.paint = std::make_shared<const Paint>(node.mesh->vertexCount(), std::uint8_t(7));
  Scene meanwhile = scene;
  meanwhile.setNodes(std::move(repainted));
  const Scene both = withNewMeshes(meanwhile, reloaded.meshes);
  const PaintPtr now = test::named(both, "liver").paint;
  QVERIFY(now && *now == Paint(now->size(), 7));
}

void ReloadTest::whichFileIsMeant() {
  const QTemporaryDir folder;
  test::writeMesh(folder.filePath("a/liver.ply"), *test::octahedron({}, 20));
  test::writeMesh(folder.filePath("b/liver.ply"), *test::octahedron({}, 21));
  const auto one = importInputs(std::array{path(folder, "a/liver.ply")}, {});
  QVERIFY(one.ok());
  const Reloaded kept = reload(one->scene, std::array{path(folder)});
  QCOMPARE(told(kept), QString("liver.ply unchanged"));
  QVERIFY(kept.files[0].reason.starts_with("another file of this name"));
  QVERIFY(reload(one->scene, std::array{path(folder, "a")}).files[0].reason.empty());
  test::writeMesh(folder.filePath("a/liver.ply"), *test::octahedron({}, 22));
  const Reloaded unclear = reload(one->scene, std::array{path(folder)});
  QCOMPARE(told(unclear), QString("liver.ply failed"));
  QVERIFY(unclear.files[0].reason.find("2 files of this name") != std::string::npos);
  for (const char* const place : {"a", "a/liver.ply"})
    QCOMPARE(told(reload(one->scene, std::array{path(folder, place)})),
             QString("liver.ply replaced"));
  QCOMPARE(told(reload(one->scene, std::array{path(folder, "nowhere")})),
           QString("liver.ply absent"));
}

/// A file that has become another unit's, body's or organ's is told, and its lengths are doubted.
void ReloadTest::whatIsElsewhereIsTold() {
  const auto after = [](float radius, const glm::vec3& at) {
    const QTemporaryDir folder;
    test::writeMesh(folder.filePath("liver.ply"), *test::octahedron({}, 20));
    const Scene scene = imported(folder);
    test::writeMesh(folder.filePath("liver.ply"), *test::octahedron(at, radius));
    return reload(scene, std::array{path(folder)});
  };
  const Reloaded alike = after(24, {5, 0, 0});
  QVERIFY(alike.changed && alike.warnings.empty());
  const Reloaded small = after(2, {});
  QCOMPARE(small.warnings.size(), std::size_t(1));
  QVERIFY2(small.warnings[0].reason.ends_with(": its file may have another unit"),
           small.warnings[0].reason.c_str());
  QVERIFY(isUnitDoubted(test::named(small.scene, "liver").provenance));
  const Reloaded away = after(20, {100, 0, 0});
  QCOMPARE(away.warnings.size(), std::size_t(1));
  QVERIFY2(away.warnings[0].reason.find("lies 60") != std::string::npos,
           away.warnings[0].reason.c_str());
  QVERIFY(!isUnitDoubted(test::named(away.scene, "liver").provenance));
}

void ReloadTest::whatCannotBeRead() {
  const QTemporaryDir folder;
  test::writeMesh(folder.filePath("liver.ply"), *test::octahedron({}, 20));
  const Scene scene = imported(folder);
  test::writeText(folder.filePath("liver.ply"), "ply\nformat ascii 1.0\n");
  const Reloaded reloaded = reload(scene, std::array{path(folder)});
  QVERIFY(!reloaded.changed && reloaded.scene == scene);
  QCOMPARE(told(reloaded), QString("liver.ply failed"));
  QVERIFY(!reloaded.files[0].reason.empty());
  Scene made;
  made.append({.name = "made here", .mesh = test::octahedron({}, 5)});
  QVERIFY(reload(made, std::array{path(folder)}).files.empty());
}

SLINE_TEST(ReloadTest)
#include "test_reload.moc"
