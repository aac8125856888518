// SPDX-License-Identifier: Apache-2.0
// Tests the patterns of cut faces in a view: which structures have them, that they stay while the
// camera turns, and their layer in a vector drawing.
#include <QtTest>

#include "model/edit/sections.h"
#include "render/drawn/face_patterns.h"
#include "render/drawn/section_caps.h"
#include "render/vectors/vector_drawing.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using model::CutFaces;
using model::CutPattern;

namespace {

model::Camera seenFrom(const glm::vec3& direction, float distance) {
  return {.eye = distance * glm::normalize(direction), .target = {}, .up = {0.0f, 0.0f, 1.0f}};
}

/// A ball of that name in a group of that name, cut in the middle; its front half is away.
model::Scene half(const char* name, const char* group, CutFaces faces) {
  model::Scene scene;
  const model::NodeId above = scene.append({.name = group});
  scene.append({.parent = above, .name = name, .mesh = test::sphere(20.0f, 4)});
  model::Section section =
      model::anatomicalSection(scene, model::rootId, model::AnatomicalView::posterior, 0.0f);
  section.faces = faces;
  scene.appendSection(section);
  return scene;
}

/// Returns the number of shapes in the drawing's layers of that name.
std::size_t shapesIn(const render::VectorDrawing& drawing, std::string_view layer) {
  std::size_t count = 0;
  for (const render::VectorStructure& structure : drawing.structures)
    for (const render::VectorLines& lines : structure.lines)
      if (lines.kind == layer)
        count += lines.shapes.size();
  return count;
}

/// One structure as a picture prepares it.
struct Prepared {
  render::PreparedSurface surface;
  render::DrawnStructure shown;

  explicit Prepared(const model::Scene& scene) {
    const model::Node& node = scene.nodes().back();
    surface.surface = render::pictureSurface(node.mesh, node.provenance);
    shown = {.id = node.id,
             .mesh = node.mesh,
             .style = scene.resolve(node.id),
             .prepared = &surface,
             .sections = scene.sectionsOf(node.id)};
    shown.cut = std::make_shared<render::SectionedSurface>(
        render::sectioned(surface.surface, model::planesOf(shown.sections)));
    shown.pattern = render::cutPattern(scene, node);
  }
  std::vector<render::FacePattern> patterns(const model::Camera& camera) const {
    return render::facePatterns(shown, {camera, shown.mesh->bounds(), 1280, 720});
  }
};

}  // namespace

class CutTissueTest : public QObject {
  Q_OBJECT
 private slots:
  void structuresHavePatterns_data();
  void structuresHavePatterns();
  void hullsAreBlank();
  void hullsAreFoundOnce();
  void openFacesArePaper_data();
  void openFacesArePaper();
  void layerOfItsOwn_data();
  void layerOfItsOwn();
  void patternsStayWhileTheCameraTurns();
  void densityFollowsScale();
  void windowStaysSmall();
};

void CutTissueTest::structuresHavePatterns_data() {
  QTest::addColumn<QString>("group");
  QTest::addColumn<int>("pattern");
  QTest::newRow("left femur") << "Muscles" << int(CutPattern::spongy);
  QTest::newRow("segment 3") << "Muscles" << int(CutPattern::fibres);
  QTest::newRow("segment 4") << "Group" << int(CutPattern::plain);
  QTest::newRow("skin") << "Skin and fat" << int(CutPattern::rim);
  QTest::newRow("fat") << "Skin and fat" << int(CutPattern::cells);
  // A group of both says of nothing that it is fat.
  QTest::newRow("segment 5") << "Skin and fat" << int(CutPattern::rim);
  QTest::newRow("white matter") << "Brain" << int(CutPattern::plain);
}

void CutTissueTest::structuresHavePatterns() {
  QFETCH(QString, group);
  QFETCH(int, pattern);
  const model::Scene scene =
      half(QTest::currentDataTag(), group.toStdString().c_str(), CutFaces::tissue);
  QCOMPARE(int(render::cutPattern(scene, scene.nodes().back())), pattern);
}

/// A hull whose name says nothing is not filled with what it is not; one that says what it is, is.
void CutTissueTest::hullsAreBlank() {
  for (const auto& [name, pattern] :
       {std::pair("surface 1", CutPattern::blank), std::pair("liver", CutPattern::stipple),
        std::pair("skin", CutPattern::rim)}) {
    model::Scene scene;
    scene.append({.name = "thing", .mesh = test::sphere(5.0f, 3)});
    scene.append({.name = name, .mesh = test::sphere(20.0f, 3)});
    QCOMPARE(int(render::cutPattern(scene, scene.nodes().back())), int(pattern));
    QCOMPARE(int(render::cutPattern(scene, scene.nodes().front())), int(CutPattern::plain));
  }
  // What lies in its box, but outside of it, is not enclosed.
  model::Scene scene;
  scene.append(
      {.name = "thing", .mesh = test::moved(*test::sphere(2.0f, 3), 1.0f, {13.0f, 13.0f, 13.0f})});
  scene.append({.name = "surface 1", .mesh = test::sphere(20.0f, 3)});
  QCOMPARE(int(render::cutPattern(scene, scene.nodes().back())), int(CutPattern::plain));
}

/// A picture in which no surface is another asks again for nothing: to look each time would not
/// come to an end.
void CutTissueTest::hullsAreFoundOnce() {
  model::Scene scene;
  const model::NodeId hull = scene.append({.name = "hull", .mesh = test::sphere(20.0f, 6)});
  for (int i = 0; i < 20; ++i)
    scene.append({.name = "beside",
                  .mesh = test::moved(*test::sphere(2.0f, 2), 1.0f, {13.0f, 13.0f, 13.0f})});
  render::Hulls hulls;
  const auto isAround = [&] {
    hulls.take(scene);
    return hulls.isAroundOthers(scene.find(hull)->mesh);
  };
  for (int i = 0; i < 100'000; ++i)
    QVERIFY(!isAround());
  scene.append({.name = "within", .mesh = test::sphere(2.0f, 2)});
  QVERIFY(isAround());
}

void CutTissueTest::openFacesArePaper_data() {
  QTest::addColumn<int>("faces");
  QTest::addColumn<bool>("paper");
  const auto row = [](const char* name, CutFaces faces, bool paper) {
    QTest::addRow("%s %d", name, int(faces)) << int(faces) << paper;
  };
  for (const char* name : {"skin", "body"}) {
    row(name, CutFaces::tissue, true);
    row(name, CutFaces::tint, true);
  }
  for (const char* name : {"aorta", "colon"}) {
    row(name, CutFaces::tissue, true);
    row(name, CutFaces::tint, false);
  }
  for (const char* name : {"femur", "liver", "subcutaneous fat", "thing"})
    row(name, CutFaces::tissue, false);
}

/// Skin is no filling of a body, nor is a vessel's wall one of its lumen.
void CutTissueTest::openFacesArePaper() {
  QFETCH(int, faces);
  QFETCH(bool, paper);
  const QByteArray name = QByteArray(QTest::currentDataTag()).chopped(2);
  const model::Scene scene = half(name.constData(), "", CutFaces(faces));
  const Prepared prepared(scene);
  const render::PictureView view(seenFrom({0.0f, -1.0f, 0.0f}, 200.0f),
                                 prepared.shown.mesh->bounds(), 1280, 720);
  const glm::vec4 colour =
      render::capPaint(prepared.shown, view, render::Background::white, 0).colour;
  QCOMPARE(colour == glm::vec4(1.0f), paper);
}

void CutTissueTest::layerOfItsOwn_data() {
  QTest::addColumn<int>("faces");
  QTest::addColumn<QString>("name");
  QTest::addColumn<bool>("drawn");
  QTest::newRow("tissue") << int(CutFaces::tissue) << "femur" << true;
  QTest::newRow("tint") << int(CutFaces::tint) << "femur" << false;
  QTest::newRow("off") << int(CutFaces::off) << "femur" << false;
  QTest::newRow("unknown") << int(CutFaces::tissue) << "thing" << false;
}

void CutTissueTest::layerOfItsOwn() {
  QFETCH(int, faces);
  QFETCH(QString, name);
  QFETCH(bool, drawn);
  const model::Scene scene = half(name.toStdString().c_str(), "", CutFaces(faces));
  const auto front = render::drawVectors(scene, seenFrom({0.1f, -1.0f, 0.2f}, 100.0f), {});
  QVERIFY(front.ok());
  QCOMPARE(shapesIn(*front, "Cut tissue") > 0, drawn);
  QVERIFY(shapesIn(*front, "Cut outlines") > 0);
  // From behind, nothing of the face is seen.
  const auto back = render::drawVectors(scene, seenFrom({0.1f, 1.0f, 0.2f}, 100.0f), {});
  QVERIFY(back.ok());
  QCOMPARE(shapesIn(*back, "Cut tissue"), std::size_t(0));
}

void CutTissueTest::patternsStayWhileTheCameraTurns() {
  const Prepared bone(half("femur", "", CutFaces::tissue));
  const auto first = bone.patterns(seenFrom({0.0f, -1.0f, 0.0f}, 100.0f));
  QCOMPARE(first.size(), std::size_t(1));
  QVERIFY(!first[0].marks->strokes.empty());
  for (const glm::vec3 direction : {glm::vec3(0.4f, -1.0f, 0.2f), glm::vec3(-1.0f, -1.0f, -0.7f)}) {
    const auto turned = bone.patterns(seenFrom(direction, 100.0f));
    QCOMPARE(turned.size(), std::size_t(1));
    QCOMPARE(turned[0].marks, first[0].marks);  // not made again
    QVERIFY(turned[0].width <= first[0].width);
  }
  QVERIFY(bone.patterns(seenFrom({0.0f, 1.0f, 0.0f}, 100.0f)).empty());
  // Seen nearly along the face, its strokes are thin.
  QVERIFY(bone.patterns(seenFrom({1.0f, -0.1f, 0.0f}, 100.0f))[0].width < 0.3f);
}

void CutTissueTest::densityFollowsScale() {
  const Prepared bone(half("femur", "", CutFaces::tissue));
  const auto marks = [&](float distance) {
    return double(bone.patterns(seenFrom({0.0f, -1.0f, 0.0f}, distance))[0].marks->strokes.size());
  };
  QVERIFY(marks(100.0f) > 2.8 * marks(200.0f));
  QVERIFY(marks(400.0f) < 0.4 * marks(200.0f));
}

/// However near the camera is, the number of marks stays within what a picture can hold.
void CutTissueTest::windowStaysSmall() {
  const Prepared fat(half("fat", "", CutFaces::tissue));
  model::Camera camera = seenFrom({0.1f, -1.0f, 0.1f}, 100.0f);
  camera.projection = model::Projection::orthographic;
  for (float height = 50.0f; height > 0.05f; height *= 0.5f) {
    camera.heightMm = height;
    const auto patterns = fat.patterns(camera);
    QCOMPARE(patterns.size(), std::size_t(1));
    const std::size_t count = patterns[0].marks->strokes.size();
    QVERIFY2(count > 1000 && count < 40'000, qPrintable(QString::number(count)));
  }
}

SLINE_TEST(CutTissueTest)
#include "cut_tissue_test.moc"
