// SPDX-License-Identifier: Apache-2.0
#include <QDir>
#include <QtTest>
#include <array>
#include <glm/geometric.hpp>

#include "model/import/plan/import.h"
#include "model/import/slicer/mrml_scene.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

QByteArray scene(const QByteArray& nodes, const QByteArray& version = "Slicer4.4.0") {
  return "<MRML version=\"" + version + "\" userTags=\"\">\n" + nodes + "</MRML>\n";
}

/// Returns a model with its storage and display.
QByteArray liver(const QByteArray& more = {}, const QByteArray& storage = {},
                 const QByteArray& file = "liver.ply") {
  return "<Model id=\"M1\" name=\"Model_3_liver\" storageNodeRef=\"S1\" displayNodeRef=\"D1\" " +
         more + "></Model>\n<ModelStorage id=\"S1\" fileName=\"" + file + "\" " + storage +
         "></ModelStorage>\n<ModelDisplay id=\"D1\" color=\"0.5 0.25 1\" opacity=\"0.5\" "
         "visibility=\"true\"></ModelDisplay>\n";
}

/// Holds a scene file beside liver.ply, an octahedron at (−70, 0, 0) of its own coordinates.
class SceneFolder {
 public:
  explicit SceneFolder(const QByteArray& text, std::optional<Frame> header = std::nullopt) {
    test::writeMesh(m_folder.filePath("liver.ply"), *test::octahedron({-70, 5, 10}, 20), header);
    test::writeText(m_folder.filePath("scene.mrml"), text);
  }
  QString filePath(const QString& name) const { return m_folder.filePath(name); }
  Result<Imported> import(const ImportOptions& options = {}) const {
    return importInputs(
        std::array{std::filesystem::path(m_folder.filePath("scene.mrml").toStdString())}, options);
  }

 private:
  QTemporaryDir m_folder;
};

glm::vec3 centre(const Imported& imported) {
  const Node& node = test::named(imported.scene, "liver");
  return node.mesh ? node.mesh->bounds().centre() : glm::vec3(1e9f);
}

}  // namespace

class SlicerSceneTest : public QObject {
  Q_OBJECT
 private slots:
  void styleAndName();
  void frame_data();
  void frame();
  void transforms_data();
  void transforms();
  void mirrorKeepsFacesOutward();
  void hierarchy();
  void collapsedGroupGivesItsStyle();
  void subjectHierarchy();
  void nodesOfSavedViewsAreNoModels();
  void whereFilesAre_data();
  void whereFilesAre();
  void absentFilesAreTold();
  void broken_data();
  void broken();
  void circles();
  void entityBombStaysSmall();
  void formatSamples();
};

void SlicerSceneTest::styleAndName() {
  const SceneFolder folder(scene(liver()));
  const auto imported = folder.import();
  QVERIFY(imported.ok());
  const Node& node = test::named(imported->scene, "liver");
  QCOMPARE(node.style.colour, std::optional(Colour{128, 64, 255}));
  QCOMPARE(node.style.opacity, std::optional(Opacity::clamped(0.5f)));
  QCOMPARE(node.style.visible, std::optional(true));
  QCOMPARE(node.provenance.file, std::string("liver.ply"));
  QVERIFY(imported->report.warnings.empty());
}

void SlicerSceneTest::frame_data() {
  QTest::addColumn<QByteArray>("version");
  QTest::addColumn<QByteArray>("storage");
  QTest::addColumn<int>("header");
  QTest::addColumn<QString>("frame");
  const auto row = [](const char* tag, const char* version, const char* storage, int header,
                      const char* frame) {
    QTest::newRow(tag) << QByteArray(version) << QByteArray(storage) << header << QString(frame);
  };
  row("4.4", "Slicer4.4.0", "", -1, "RAS");
  row("4.10", "Slicer4.10.2", "", -1, "RAS");
  row("4.11", "Slicer4.11.20200930", "", -1, "LPS");
  row("5", "Slicer5.2.2", "", -1, "LPS");
  row("none", "", "", -1, "RAS");
  row("nonsense", "something", "", -1, "RAS");
  row("storage RAS", "Slicer5.2.2", "coordinateSystem=\"RAS\"", -1, "RAS");
  row("storage LPS", "Slicer4.4.0", "coordinateSystem=\"LPS\"", -1, "LPS");
  row("storage 0", "Slicer5.2.2", "coordinateSystem=\"0\"", -1, "RAS");
  row("storage 1", "Slicer4.4.0", "coordinateSystem=\"1\"", -1, "LPS");
  row("the mesh's own header wins, as in Slicer", "Slicer5.2.2", "coordinateSystem=\"LPS\"", 1,
      "RAS");
}

void SlicerSceneTest::frame() {
  QFETCH(QByteArray, version);
  QFETCH(QByteArray, storage);
  QFETCH(int, header);
  QFETCH(QString, frame);
  const SceneFolder folder(scene(liver({}, storage), version),
                           header < 0 ? std::nullopt : std::optional(Frame::ras));
  const auto imported = folder.import();
  QVERIFY(imported.ok());
  QCOMPARE(QString::fromStdString(test::named(imported->scene, "liver").provenance.frame), frame);
  const glm::vec3 expected = frame == "RAS" ? glm::vec3(70, -5, 10) : glm::vec3(-70, 5, 10);
  QVERIFY(glm::distance(centre(*imported), expected) < 1e-3f);
}

void SlicerSceneTest::transforms_data() {
  QTest::addColumn<QByteArray>("nodes");
  QTest::addColumn<QList<double>>("place");  // in LPS, the file being RAS
  QTest::addColumn<QString>("warning");
  const QByteArray a = "<LinearTransform id=\"T1\" name=\"move\" matrixTransformToParent=\"";
  const auto row = [](const char* tag, const QByteArray& nodes, const QList<double>& place,
                      const char* warning) { QTest::newRow(tag) << nodes << place << warning; };
  row("move in RAS", a + "1 0 0 10  0 1 0 20  0 0 1 30  0 0 0 1\"/>", {60, -25, 40}, "");
  row("parents too",
      a + "1 0 0 10  0 1 0 0  0 0 1 0  0 0 0 1\" transformNodeRef=\"T2\"/>"
          "<LinearTransform id=\"T2\" matrixTransformToParent=\"2 0 0 0 0 2 0 0 0 0 2 0 0 0 0 "
          "1\"/>",
      {120, -10, 20}, "");
  row("from the parent",
      "<LinearTransform id=\"T1\" matrixTransformFromParent=\"1 0 0 10 0 1 0 0 0 0 1 0 0 0 0 1\"/>",
      {80, -5, 10}, "");
  row("singular", a + "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1\"/>", {70, -5, 10}, "singular");
  row("too short", a + "1 0 0\"/>", {70, -5, 10}, "16 numbers");
  row("no numbers", a + "a b c d e f g h i j k l m n o p\"/>", {70, -5, 10}, "16 numbers");
  row("not finite", a + "inf 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\"/>", {70, -5, 10}, "16 numbers");
  row("projective", a + "1 0 0 0 0 1 0 0 0 0 1 0 1 0 0 1\"/>", {70, -5, 10}, "affine");
  row("absent", "", {70, -5, 10}, "absent");
  row("bent", "<BSplineTransform id=\"T1\" name=\"bend\"/>", {70, -5, 10}, "not a matrix");
  row("circle", a + "1 0 0 10 0 1 0 0 0 0 1 0 0 0 0 1\" transformNodeRef=\"T1\"/>", {70, -5, 10},
      "circle");
}

void SlicerSceneTest::transforms() {
  QFETCH(QByteArray, nodes);
  QFETCH(QList<double>, place);
  QFETCH(QString, warning);
  for (const char* reference : {"transformNodeRef=\"T1\"", "references=\"transform:T1;\""}) {
    const SceneFolder folder(scene(liver(reference) + nodes));
    const auto imported = folder.import();
    QVERIFY(imported.ok());
    QVERIFY(glm::distance(centre(*imported), glm::vec3(place[0], place[1], place[2])) < 1e-3f);
    if (warning.isEmpty())
      QVERIFY2(imported->report.warnings.empty(), qPrintable(test::warningsOf(*imported)));
    else
      QVERIFY2(test::warningsOf(*imported).contains(warning),
               qPrintable(test::warningsOf(*imported)));
  }
}

void SlicerSceneTest::mirrorKeepsFacesOutward() {
  const SceneFolder folder(scene(
      liver("transformNodeRef=\"T1\"") +
      "<LinearTransform id=\"T1\" matrixTransformToParent=\"-1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\"/>"));
  const auto imported = folder.import();
  QVERIFY(imported.ok());
  const MeshPtr mesh = test::named(imported->scene, "liver").mesh;
  for (const Triangle& t : mesh->triangles()) {
    const auto p = [&](int k) { return mesh->positions()[t[std::size_t(k)]]; };
    QVERIFY(glm::dot(glm::cross(p(1) - p(0), p(2) - p(0)), p(0) - mesh->bounds().centre()) > 0.0f);
  }
}

void SlicerSceneTest::hierarchy() {
  const SceneFolder folder(scene(
      liver() +
      "<ModelHierarchy id=\"H1\" name=\"Organs\" displayNodeID=\"D2\" expanded=\"true\"/>"
      "<ModelHierarchy id=\"H2\" name=\"GI\" parentNodeRef=\"H1\" expanded=\"true\"/>"
      "<ModelHierarchy id=\"H3\" parentNodeRef=\"H2\" associatedNodeRef=\"M1\" expanded=\"true\"/>"
      "<ModelHierarchy id=\"H4\" name=\"Empty\"/>"
      "<ModelDisplay id=\"D2\" color=\"1 0 0\" visibility=\"false\"/>"));
  const auto imported = folder.import();
  QVERIFY(imported.ok());
  const Node& node = test::named(imported->scene, "liver");
  QCOMPARE(imported->scene.groupPath(node.id), std::string("Organs / GI"));
  QVERIFY(test::named(imported->scene, "Empty").name.empty());
  QCOMPARE(test::named(imported->scene, "Organs").style.colour, std::optional(Colour{255, 0, 0}));
  // An expanded group does not hide what is in it.
  QVERIFY(imported->scene.resolve(node.id).visible);
}

void SlicerSceneTest::collapsedGroupGivesItsStyle() {
  const SceneFolder folder(
      scene(liver() +
            "<ModelHierarchy id=\"H1\" name=\"Organs\" displayNodeRef=\"D2\" expanded=\"false\"/>"
            "<ModelHierarchy id=\"H3\" parentNodeRef=\"H1\" modelNodeRef=\"M1\"/>"
            "<ModelDisplay id=\"D2\" color=\"1 0 0\" visibility=\"true\"/>"));
  const auto imported = folder.import();
  QVERIFY(imported.ok());
  const NodeId id = test::named(imported->scene, "liver").id;
  QCOMPARE(imported->scene.resolve(id).colour, (Colour{255, 0, 0}));
}

void SlicerSceneTest::subjectHierarchy() {
  const SceneFolder folder(scene(
      liver() + "<SubjectHierarchy id=\"SH\" name=\"SubjectHierarchy\">"
                "<SubjectHierarchyItem id=\"3\" name=\"Scene\" parent=\"0\">"
                "<SubjectHierarchyItem id=\"8\" name=\"Digestive\" parent=\"3\" type=\"Folder\">"
                "<SubjectHierarchyItem id=\"9\" dataNode=\"M1\" parent=\"8\" type=\"Models\"/>"
                "</SubjectHierarchyItem></SubjectHierarchyItem></SubjectHierarchy>",
      "Slicer5.2.2"));
  const auto imported = folder.import();
  QVERIFY(imported.ok());
  const Node& node = test::named(imported->scene, "liver");
  QCOMPARE(imported->scene.groupPath(node.id), std::string("Digestive"));
}

void SlicerSceneTest::nodesOfSavedViewsAreNoModels() {
  const SceneFolder folder(
      scene(liver() + "<SceneView id=\"V1\" name=\"view\">" + liver() + liver() + "</SceneView>"));
  const auto imported = folder.import();
  QVERIFY(imported.ok());
  QCOMPARE(imported->scene.nodes().size(), std::size_t(1));
}

void SlicerSceneTest::whereFilesAre_data() {
  QTest::addColumn<QByteArray>("written");
  QTest::addColumn<QString>("lies");
  QTest::addColumn<bool>("found");
  QTest::newRow("beside") << QByteArray("a.ply") << "a.ply" << true;
  QTest::newRow("dot") << QByteArray("./Data/a.ply") << "Data/a.ply" << true;
  QTest::newRow("escaped") << QByteArray("Data/my%20liver.ply") << "Data/my liver.ply" << true;
  QTest::newRow("percent in the name") << QByteArray("a%20b.ply") << "a%20b.ply" << true;
  QTest::newRow("Windows") << QByteArray("Data\\a.ply") << "Data/a.ply" << true;
  QTest::newRow("absolute, beside") << QByteArray("/home/somebody/a.ply") << "a.ply" << true;
  QTest::newRow("absolute, in Data") << QByteArray("C:/Users/x/a.ply") << "Data/a.ply" << true;
  QTest::newRow("up and away") << QByteArray("../a.ply") << "../a.ply" << false;
  QTest::newRow("hidden way up") << QByteArray("Data/../../a.ply") << "../a.ply" << false;
  QTest::newRow("absent") << QByteArray("b.ply") << "a.ply" << false;
}

void SlicerSceneTest::whereFilesAre() {
  QFETCH(QByteArray, written);
  QFETCH(QString, lies);
  QFETCH(bool, found);
  const QTemporaryDir folder;
  const QDir inner(folder.filePath("scene"));
  test::writeText(inner.filePath("scene.mrml"), scene(liver({}, {}, written)));
  test::writeMesh(QDir::cleanPath(inner.filePath(lies)), *test::octahedron({}, 20));
  const auto imported = importInputs(
      std::array{std::filesystem::path(inner.filePath("scene.mrml").toStdString())}, {});
  QCOMPARE(imported.ok(), found);
}

void SlicerSceneTest::absentFilesAreTold() {
  const SceneFolder folder(
      scene(liver() +
            "<Model id=\"M2\" name=\"gone\" storageNodeRef=\"S2\"/><ModelStorage id=\"S2\" "
            "fileName=\"gone.vtk\"/><Model id=\"M3\" name=\"loose\" storageNodeRef=\"S9\"/>"
            "<Model id=\"M4\" name=\"Red Volume Slice\" hideFromEditors=\"true\"/>"
            "<VolumeArchetypeStorage id=\"V1\" fileName=\"ct.nrrd\"/>"));
  const auto imported = folder.import();
  QVERIFY(imported.ok());
  QCOMPARE(imported->scene.nodes().size(), std::size_t(1));
  const QString warnings = test::warningsOf(*imported);
  QVERIFY(warnings.contains("gone.vtk: the file is absent"));
  QVERIFY(warnings.contains("\"loose\" refers to no file"));
  QVERIFY(warnings.contains("absent volumes") && warnings.contains("ct.nrrd"));
  QCOMPARE(imported->report.warnings.size(), std::size_t(3));
}

void SlicerSceneTest::broken_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("reason");
  QTest::newRow("empty") << QByteArray() << "XML";
  QTest::newRow("no XML") << QByteArray("solid liver\n") << "";
  QTest::newRow("cut off") << scene(liver()).left(150) << "line 3";
  QTest::newRow("another XML") << QByteArray("<VTKFile/>") << "no 3D Slicer scene";
  QTest::newRow("no models") << scene("<Camera id=\"c\"/>") << "holds no model";
  QTest::newRow("bundles of fibres")
      << scene("<FiberBundle id=\"f\"/><FiberBundle id=\"g\"/>") << "2 bundles of fibres";
  QTest::newRow("only absent models") << scene(liver({}, {}, "gone.vtk")) << "can be found";
  QTest::newRow("zeros") << QByteArray(1000, '\0') << "";
}

void SlicerSceneTest::broken() {
  QFETCH(QByteArray, text);
  QFETCH(QString, reason);
  const SceneFolder folder(text);
  const auto imported = folder.import();
  QVERIFY(!imported.ok());
  const QString message = QString::fromStdString(imported.error().text());
  QVERIFY2(message.contains("scene.mrml") && message.contains(reason), qPrintable(message));
}

void SlicerSceneTest::circles() {
  const SceneFolder folder(
      scene(liver() +
            "<ModelHierarchy id=\"H1\" name=\"A\" parentNodeRef=\"H2\"/>"
            "<ModelHierarchy id=\"H2\" name=\"B\" parentNodeRef=\"H1\"/>"
            "<ModelHierarchy id=\"H3\" parentNodeRef=\"H1\" associatedNodeRef=\"M1\"/>"
            "<ModelHierarchy id=\"H4\" parentNodeRef=\"H4\" associatedNodeRef=\"nothing\"/>"));
  const auto imported = folder.import();
  QVERIFY(imported.ok());
  QVERIFY(test::warningsOf(*imported).contains("circle"));
  QCOMPARE(imported->scene.groupPath(test::named(imported->scene, "liver").id), std::string());
}

void SlicerSceneTest::entityBombStaysSmall() {
  QByteArray bomb = "<?xml version=\"1.0\"?>\n<!DOCTYPE MRML [<!ENTITY a \"ha\">";
  for (char c = 'b'; c <= 'z'; ++c)
    bomb += QByteArray("<!ENTITY ") + c + " \"" +
            QByteArray("&" + QByteArray(1, char(c - 1)) + ";").repeated(10) + "\">";
  const SceneFolder folder(bomb + "]>\n" + scene(liver("userTags=\"&z;\"")));
  QVERIFY(folder.import().ok());
}

void SlicerSceneTest::formatSamples() {
  const QDir folder(QString(SLINE_TEST_DATA) + "/formats/slicer");
  if (!folder.exists())
    SLINE_ABSENT("the folder of real data is absent");
  const auto import = [&](const char* name) {
    return importInputs(std::array{std::filesystem::path(folder.filePath(name).toStdString())}, {});
  };
  const auto cube = import("clipCube.mrml");
  QVERIFY(cube.ok());
  const glm::vec3 size = cube->scene.nodes().front().mesh->bounds().size();
  QVERIFY(glm::distance(size, glm::vec3(100.0f)) < 1e-3f);
  const auto two = import("modelHierarchy.mrml");
  QVERIFY(two.ok());
  QCOMPARE(two->scene.nodes().size(), std::size_t(2));
  for (const char* name : {"cube-utf8.mrml", "volumetric_mesh.mrml"})
    QVERIFY2(!import(name).ok(), name);
}

SLINE_TEST(SlicerSceneTest)
#include "test_slicer_scene.moc"
