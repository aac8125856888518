// SPDX-License-Identifier: Apache-2.0
// Tests saved views and bundles of 3D Slicer.
#include <QDir>
#include <QtTest>
#include <array>

#include "model/disk/zip_archive.h"
#include "model/edit/views.h"
#include "model/import/plan/import.h"
#include "tests/model/import/slicer/slicer_folder.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

namespace {

QByteArray model(const char* id, const char* name, const char* visible) {
  return QByteArray(
             "<ModelHierarchy id=\"H-%1\" parentNodeRef=\"G\" associatedNodeRef=\"%1\"/>"
             "<Model id=\"%1\" name=\"%2\" storageNodeRef=\"S-%1\" displayNodeRef=\"D-%1\"/>"
             "<ModelStorage id=\"S-%1\" fileName=\"Data/%2.ply\"/>"
             "<ModelDisplay id=\"D-%1\" color=\"1 0 0\" opacity=\"0.5\" visibility=\"%3\"/>")
      .replace("%1", id)
      .replace("%2", name)
      .replace("%3", visible);
}

QByteArray camera(const char* position, const char* more = "") {
  return QByteArray("<Camera id=\"C\" position=\"") + position +
         "\" focalPoint=\"1 2 3\" viewUp=\"0 0 1\" " + more + "/>";
}

QByteArray group(const char* more) {
  return QByteArray("<ModelHierarchy id=\"G\" name=\"Organs\" displayNodeRef=\"DG\" ") + more +
         "/><ModelDisplay id=\"DG\" color=\"0 0 1\" visibility=\"false\"/>";
}

QByteArray wholeScene() {
  return "<MRML version=\"Slicer4.4.0\">" + group("expanded=\"true\"") +
         model("A", "liver", "true") + model("B", "spleen", "true") + fiducial("1") +
         camera("0 500 0") + "<SceneView name=\"Without liver\">" + group("expanded=\"true\"") +
         model("A", "liver", "false") + model("B", "spleen", "true") + fiducial("0") +
         camera("-100 1 2", "parallelProjection=\"true\" parallelScale=\"75\"") +
         "</SceneView><SceneView name=\"Collapsed\">" + group("expanded=\"false\"") +
         model("A", "liver", "true") + camera("0 500 0", "viewAngle=\"12.5\"") + camera("9 9 9") +
         "</SceneView><SceneView name=\"Blind\">" + model("A", "liver", "true") + camera("1 2 3") +
         "</SceneView></MRML>";
}

const View& viewNamed(const Scene& scene, const char* name) {
  static const View none;
  for (const View& view : scene.views())
    if (view.name == name)
      return view;
  return none;
}

QByteArray zip(const std::vector<std::pair<QByteArray, QByteArray>>& files) {
  std::vector<ZipMember> members;
  for (const auto& [name, bytes] : files)
    members.push_back({name.toStdString(), bytes.toStdString()});
  std::vector<const ZipMember*> all;
  for (const ZipMember& member : members)
    all.push_back(&member);
  const auto packed = zipped(all);
  return packed.ok() ? QByteArray::fromStdString(*packed) : QByteArray();
}

}  // namespace

class SlicerViewsTest : public QObject {
  Q_OBJECT
 private slots:
  void views();
  void segmentations();
  void bundle();
  void brokenBundles_data();
  void brokenBundles();
  void abdomenViews();
  void samples();
};

void SlicerViewsTest::views() {
  const SlicerFolder folder;
  folder.write("s.mrml", wholeScene());
  const auto imported = folder.import("s.mrml");
  QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
  const Scene& scene = imported->scene;
  QCOMPARE(scene.views().size(), std::size_t(3));
  QVERIFY(test::warningsOf(*imported).contains("\"Blind\" was left out"));
  const NodeId liver = test::named(scene, "liver").id;
  const NodeId spleen = test::named(scene, "spleen").id;
  QVERIFY(scene.resolve(liver).visible && scene.resolve(spleen).visible);

  const View& without = viewNamed(scene, "Without liver");
  QVERIFY(without.camera.projection == Projection::orthographic);
  QVERIFY(near(without.camera.eye, {100, -1, 2}));
  QVERIFY(near(without.camera.target, {-1, -2, 3}));
  QCOMPARE(without.camera.heightMm, 150.0f);
  Scene seen = withViewApplied(scene, without).scene;
  QVERIFY(!seen.resolve(liver).visible && seen.resolve(spleen).visible);
  QVERIFY(!seen.annotations()[0].visible);
  QCOMPARE(seen.resolve(spleen).colour, (Colour{255, 0, 0}));
  QCOMPARE(seen.resolve(spleen).opacity.value(), 0.5f);

  const View& collapsed = viewNamed(scene, "Collapsed");
  QCOMPARE(collapsed.camera.fovyDegrees, 12.5f);
  QVERIFY(near(collapsed.camera.eye, {0, -500, 0}));
  seen = withViewApplied(scene, collapsed).scene;
  QVERIFY(!seen.resolve(liver).visible);   // hidden by its collapsed group
  QVERIFY(!seen.resolve(spleen).visible);  // it was not there yet
  QCOMPARE(seen.resolve(liver).colour, (Colour{0, 0, 255}));

  const View& own = viewNamed(scene, "3D Slicer's camera");
  QCOMPARE(own.camera.fovyDegrees, 30.0f);
  QVERIFY(near(own.camera.eye, {0, -500, 0}) && !own.looks && !own.annotations);
}

/// Any file with several surfaces stands for a segmentation here.
void SlicerViewsTest::segmentations() {
  const SlicerFolder folder;
  folder.write("Data/seg.obj",
               "o kidney\nv 1 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\no thing\nf 2 3 4\n"
               "f 1 4 3\n");
  const QByteArray segments =
      "<Segmentation id=\"SEG\" name=\"Patient\" storageNodeRef=\"SS\" displayNodeRef=\"SD\"/>"
      "<SegmentationStorage id=\"SS\" fileName=\"Data/seg.obj\"/>"
      "<SegmentationDisplay id=\"SD\" color=\"0.5 0.5 0.5\" opacity3D=\"0.5\" visibility=\"";
  folder.write("s.mrml", "<MRML version=\"Slicer5.2\">" + segments +
                             "true\"/><SceneView name=\"Off\">" + segments + "false\"/>" +
                             camera("0 5 0") + "</SceneView></MRML>");
  const auto imported = folder.import("s.mrml");
  QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
  const Scene& scene = imported->scene;
  QCOMPARE(scene.structuresBelow(rootId).size(), std::size_t(2));
  const Node& kidney = test::named(scene, "kidney");
  QCOMPARE(scene.groupPath(kidney.id), std::string("Patient"));
  QVERIFY(kidney.style.colour && *kidney.style.colour != (Colour{128, 128, 128}));
  QCOMPARE(scene.resolve(kidney.id).opacity.value(), 0.5f);
  QVERIFY(scene.resolve(kidney.id).visible);
  const Scene off = withViewApplied(scene, viewNamed(scene, "Off")).scene;
  QVERIFY(!off.resolve(kidney.id).visible);
  QCOMPARE(off.resolve(kidney.id).colour, scene.resolve(kidney.id).colour);
}

void SlicerViewsTest::bundle() {
  const SlicerFolder folder;
  const QByteArray mesh = folder.read("Data/liver.ply");
  QByteArray scene = wholeScene();
  scene.replace("Data/liver.ply", "Data/my%20liver.ply");
  const QTemporaryDir unpacked;
  const QByteArray usual = qgetenv("TMPDIR");
  qputenv("TMPDIR", unpacked.path().toUtf8());
  folder.write("s.mrb", zip({{"patient/s.mrml", scene},
                             {"patient/Data/my%20liver.ply", mesh},
                             {"patient/Data/spleen.ply", mesh},
                             {"patient/Data/CT.txt", "no mesh"},
                             {"patient/old/older.mrml", "<MRML/>"}}));
  const auto imported = folder.import("s.mrb");
  usual.isNull() ? qunsetenv("TMPDIR") : qputenv("TMPDIR", usual);
  QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
  QVERIFY(QDir(unpacked.path()).isEmpty());
  folder.write("s.mrml", wholeScene());
  const auto loose = folder.import("s.mrml");
  QVERIFY(loose.ok());
  QCOMPARE(imported->scene.nodes().size(), loose->scene.nodes().size());
  for (std::size_t i = 0; i < loose->scene.nodes().size(); ++i) {
    const Node& a = imported->scene.nodes()[i];
    const Node& b = loose->scene.nodes()[i];
    QCOMPARE(a.name, b.name);
    QVERIFY(a.isGroup() == b.isGroup() && (a.isGroup() || *a.mesh == *b.mesh));
    QVERIFY(a.provenance.file.find('/') == std::string::npos);
  }
  QVERIFY(imported->scene.views() == loose->scene.views());
}

void SlicerViewsTest::brokenBundles_data() {
  QTest::addColumn<QByteArray>("bytes");
  QTest::addColumn<QString>("reason");
  QTest::newRow("nothing") << QByteArray() << "empty";
  QTest::newRow("text") << QByteArray("<MRML/>") << "no whole ZIP file";
  QTest::newRow("no scene") << zip({{"a/b.ply", "ply"}}) << "holds no 3D Slicer scene";
  QTest::newRow("broken scene") << zip({{"a/b.mrml", "<MRML"}}) << "b.mrml, line 1: the XML";
  QTest::newRow("empty scene") << zip({{"a/b.mrml", "<MRML/>"}}) << "holds no model";
  QTest::newRow("more nodes than any scene has")
      << zip({{"b.mrml", "<MRML>" + QByteArray("<a/>").repeated(100'001) + "</MRML>"},
              {"pad", QByteArray(20'000, 'x')}})
      << "more than 100000 nodes";
  QTest::newRow("a bomb") << zip({{"a/b.mrml", "<MRML/>"}, {"a/b.ply", QByteArray(100 << 20, ' ')}})
                          << "";
  QByteArray escaping = zip({{"ab/b.mrml", "<MRML/>"}});
  escaping.replace("ab/b.mrml", "../b.mrml");
  QTest::newRow("out of it") << escaping << "\"..\"";
  QByteArray damaged = zip({{"b.mrml", wholeScene()}});
  damaged.replace(60, 20, QByteArray(20, '\xff'));
  QTest::newRow("damaged") << damaged << "";
}

void SlicerViewsTest::brokenBundles() {
  QFETCH(QByteArray, bytes);
  QFETCH(QString, reason);
  const SlicerFolder folder;
  folder.write("s.mrb", bytes);
  const auto imported = folder.import("s.mrb");
  QVERIFY(!imported.ok());
  const QString text = QString::fromStdString(imported.error().text());
  QVERIFY2(text.contains(reason) && text.contains("s.mrb") && !text.contains("sline-"),
           qPrintable(text));
}

void SlicerViewsTest::abdomenViews() {
  const QString file =
      QString(SLINE_TEST_DATA) + "/abdomen/AbdominalAtlas-2015Sept-Slicer4-4Version.mrml";
  if (!QFileInfo::exists(file))
    SLINE_ABSENT("the folder of real data is absent");
  ImportOptions options;
  options.smoothing.mode = Smoothing::Mode::off;
  const auto imported =
      importInputs(std::array{std::filesystem::path(file.toStdString())}, options);
  QVERIFY(imported.ok());
  const Scene& scene = imported->scene;
  QStringList names;
  for (const View& view : scene.views())
    names << QString::fromStdString(view.name);
  QCOMPARE(names, QStringList({"General View", "Upper Tract", "Urinary System",
                               "Hepatic and Portal Circulation", "Bone Structures",
                               "Slicer Data Bundle Scene View", "Slicer Data Bundle Scene View_1",
                               "3D Slicer's camera"}));
  const auto visible = [&scene](const char* view, const char* structure) {
    const Scene seen = withViewApplied(scene, viewNamed(scene, view)).scene;
    return seen.resolve(test::named(scene, structure).id).visible;
  };
  QVERIFY(visible("General View", "liver") && visible("General View", "Rib12"));
  QVERIFY(!visible("Bone Structures", "liver") && visible("Bone Structures", "Rib12"));
  QVERIFY(!visible("Urinary System", "liver") && visible("Urinary System", "right kidney"));
  QVERIFY(visible("Hepatic and Portal Circulation", "liver"));
  QVERIFY(!visible("Hepatic and Portal Circulation", "right kidney"));
  const Camera& hepatic = viewNamed(scene, "Hepatic and Portal Circulation").camera;
  QVERIFY(near(hepatic.eye, {187.129f, -306.158f, -185.218f}));
  QVERIFY(near(hepatic.up, {0.166677f, -0.433803f, 0.885457f}));
  QVERIFY(hepatic.projection == Projection::perspective && hepatic.fovyDegrees == 30.0f);
}

void SlicerViewsTest::samples() {
  const QDir folder(QString(SLINE_TEST_DATA) + "/formats/slicer");
  if (!folder.exists())
    SLINE_ABSENT("the folder of real data is absent");
  const auto import = [&](const char* name) {
    return importInputs(std::array{std::filesystem::path(folder.filePath(name).toStdString())}, {});
  };
  const auto bundled = import("cube_made_by_zipping.mrb");
  QVERIFY(bundled.ok());
  QVERIFY(*bundled->scene.nodes()[0].mesh == *import("cube.mrml")->scene.nodes()[0].mesh);
  const auto list = import("slicer3.fcsv");
  QVERIFY(list.ok());
  QCOMPARE(list->scene.annotations().size(), std::size_t(56));
  QVERIFY(
      near(std::get<glm::vec3>(list->scene.annotations()[0].anchors[0]), {-12.5f, 93.5f, 7.5f}));
  const auto old = import("AnnotationFiducialsTest.mrml");
  QVERIFY(old.ok());
  QCOMPARE(old->scene.annotations().size(), std::size_t(7));
  QCOMPARE(old->scene.annotations()[5].text, std::string("M"));
}

SLINE_TEST(SlicerViewsTest)
#include "test_slicer_views.moc"
