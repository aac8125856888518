// SPDX-License-Identifier: Apache-2.0
// Tests pictures that anatomy fills: the drawing ends at a frame, and what is written stands on the
// ground around it.
#include <QTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/export/description/picture_facts.h"
#include "render/export/plate/figure_plate.h"
#include "render/export/plate/plate_image.h"
#include "render/export/svg/svg_file.h"
#include "render/lettering/typesetting.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

using namespace render;

namespace {

constexpr int width = 480;
constexpr int height = 270;

model::NodeId addBall(model::Scene& scene, const char* name, float radius, const glm::vec3& at) {
  model::Node node;
  node.name = name;
  node.mesh = moved(*sphere(radius, 3), 1.0f, at);
  node.style.gamma = Gamma::clamped(5.0f);
  node.provenance.frame = "LPS";
  return scene.append(std::move(node));
}

/// Labels the triangle that lies farthest in that direction.
void addLabel(model::Scene& scene, model::NodeId id, const glm::vec3& way,
              const std::string& text) {
  const model::Mesh& mesh = *scene.find(id)->mesh;
  std::uint32_t best = 0;
  float farthest = -1e9f;
  for (std::uint32_t k = 0; k < mesh.triangleCount(); ++k)
    if (const float along = glm::dot(model::placeOn(mesh, {id, k, {0.3f, 0.3f}}), way);
        along > farthest) {
      farthest = along;
      best = k;
    }
  scene.appendAnnotation({.anchors = {model::SurfacePoint{id, best, {0.3f, 0.3f}}}, .text = text});
}

/// A large ball with labels on its front, and a small one at the edge of a close picture.
ExportOrder closeUp() {
  ExportOrder order;
  const model::NodeId large = addBall(order.scene, "Large", 50.0f, {0.0f, 0.0f, 0.0f});
  const model::NodeId small = addBall(order.scene, "Small", 3.0f, {28.0f, -60.0f, 0.0f});
  for (int i = 0; i < 6; ++i) {
    const float turn = 1.1f * float(i);
    addLabel(order.scene, large, {0.15f * std::sin(turn), -1.0f, 0.15f * std::cos(turn)},
             "Nervus " + std::to_string(i));
  }
  addLabel(order.scene, small, {0.0f, -1.0f, 0.0f}, "Aside");
  order.labels.mode = LabelMode::on;
  order.viewName = "anterior";
  order.camera = {.projection = model::Projection::orthographic,
                  .eye = {0.0f, -500.0f, 0.0f},
                  .target = {0.0f, 0.0f, 0.0f},
                  .up = {0.0f, 0.0f, 1.0f},
                  .heightMm = 36.0f};
  return order;
}

LabelBox boxOf(const LetteringText& text) {
  const QRectF box = outlineOf(text).boundingRect();
  return {{float(box.left()), float(box.top())}, {float(box.right()), float(box.bottom())}};
}

bool has(const ExportNotes& notes, ExportNote::Kind kind) {
  return std::any_of(notes.begin(), notes.end(),
                     [kind](const ExportNote& note) { return note.kind == kind; });
}

bool isWithin(const LabelBox& box, const LabelBox& outer) {
  return box.low.x >= outer.low.x && box.low.y >= outer.low.y && box.high.x <= outer.high.x &&
         box.high.y <= outer.high.y;
}

/// A picture that is one colour all over.
Image plain(const std::array<std::uint8_t, 4>& colour) {
  Image image{.width = width, .height = height, .rgba = {}};
  for (int i = 0; i < width * height; ++i)
    image.rgba.insert(image.rgba.end(), colour.begin(), colour.end());
  return image;
}

}  // namespace

class FramedPlateTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    Result<std::unique_ptr<Typesetting>> made = Typesetting::create();
    QVERIFY(made.ok());
    m_typesetting = std::move(*made);
  }

  void namesStandAroundTheFrame_data() {
    QTest::addColumn<bool>("perspective");
    QTest::newRow("parallel") << false;
    QTest::newRow("perspective") << true;
  }
  void namesStandAroundTheFrame() {
    QFETCH(bool, perspective);
    ExportOrder order = closeUp();
    if (perspective) {
      order.camera.projection = model::Projection::perspective;
      order.camera.fovyDegrees = 2.0f * 57.29578f * std::atan(18.0f / 450.0f);
    }
    model::MeshTrees trees;
    const FigurePlate plate = figurePlate(order, trees);
    QVERIFY(plate.frame);
    const LabelBox page{glm::vec2(0.0f), order.page.sizeMm};
    QVERIFY(isWithin(*plate.frame, page));
    QVERIFY(plate.frame->size().x >= 0.5f * page.size().x);
    QVERIFY(glm::distance(plate.frame->middle(), page.middle()) < 1e-3f);
    QVERIFY(has(plate.notes, ExportNote::Kind::pictureFramed));
    QVERIFY(!has(plate.notes, ExportNote::Kind::labelsOnAnatomy));
    QCOMPARE(plate.labels->layout.labels.size(), std::size_t(6));
    for (const PlacedLabel& label : plate.labels->layout.labels) {
      QVERIFY(!overlap(label.box, *plate.frame));
      QVERIFY(isWithin(label.box, page));
      QVERIFY(!label.leader.empty());
      QVERIFY(plate.frame->contains(label.leader.front()));
    }
    for (const LetteringItem& item : plate.marks.lettering.items)
      if (item.text)
        QVERIFY2(!overlap(boxOf(*item.text), *plate.frame), item.name.c_str());
    for (const char* side : {"side R", "side L"})
      QVERIFY2(std::any_of(plate.marks.lettering.items.begin(), plate.marks.lettering.items.end(),
                           [side](const LetteringItem& item) { return item.name == side; }),
               side);
    // Leaders end where the whole picture shows the label's place.
    const Screen whole = pageScreen(order);
    for (const PlacedLabel& label : plate.labels->layout.labels) {
      const model::Annotation* annotation = nullptr;
      for (const model::Annotation& each : order.scene.annotations())
        if (each.id == label.id)
          annotation = &each;
      QVERIFY(annotation);
      const model::Anchor& anchor = label.found ? *label.found : annotation->anchors.front();
      const auto place = whole.place(*order.scene.placeOf(anchor));
      QVERIFY(place && glm::distance(*place, label.leader.front()) < 0.05f);
    }
  }

  /// Who sees the picture is told of nothing that lies outside its frame.
  void whatIsOutsideIsNotTold() {
    ExportOrder order = closeUp();
    model::MeshTrees trees;
    QVERIFY(has(figurePlate(order, trees).notes, ExportNote::Kind::labelsOffPage));
    const auto tells = [&order](const char* name) {
      const PictureFacts facts = pictureFacts(order);
      return std::any_of(facts.structures.begin(), facts.structures.end(),
                         [name](const SeenStructure& one) { return one.name.contains(name); });
    };
    QVERIFY(!tells("Aside") && !tells("Small"));
    order.labels.mode = LabelMode::off;
    QVERIFY(tells("Aside") || tells("Small"));
  }

  void othersHaveNone() {
    ExportOrder order = closeUp();
    model::MeshTrees trees;
    const FigurePlate whole = figurePlate(order, trees, {.whole = true});
    QVERIFY(!whole.frame && has(whole.notes, ExportNote::Kind::labelsOnAnatomy));
    order.labels.mode = LabelMode::off;
    QVERIFY(!figurePlate(order, trees).frame);
    order.labels.mode = LabelMode::on;
    order.camera.heightMm = 300.0f;
    QVERIFY(!figurePlate(order, trees).frame);
    // On a page as small as this the frame would leave too little.
    order.camera.heightMm = 36.0f;
    order.page.sizeMm = {48.0f, 27.0f};
    QVERIFY(!figurePlate(order, trees).frame);
  }

  /// The drawing ends at the frame, on any ground.
  void drawingEndsThere_data() {
    QTest::addColumn<int>("ground");
    QTest::newRow("white") << int(Background::white);
    QTest::newRow("dark") << int(Background::dark);
    QTest::newRow("transparent") << int(Background::transparent);
  }
  void drawingEndsThere() {
    QFETCH(int, ground);
    ExportOrder order = closeUp();
    order.environment.background = Background(ground);
    order.marks = ExportMarks::none();
    model::MeshTrees trees;
    const FigurePlate plate = figurePlate(order, trees);
    QVERIFY(plate.frame);
    Image image = plain({200, 30, 40, 255});
    drawPlate(image, order, *m_typesetting);
    const float scale = float(height) / order.page.sizeMm.y;
    int anatomy = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const glm::vec2 p = (glm::vec2(x, y) + 0.5f) / scale;
        const std::uint8_t* pixel = &image.rgba[std::size_t(4) * std::size_t(y * width + x)];
        const bool red = pixel[3] == 255 && pixel[0] == 200 && pixel[1] == 30;
        anatomy += red ? 1 : 0;
        if (plate.frame->grown(0.4f).contains(p))
          continue;
        // Nor does it shine through anywhere.
        const bool reddish = pixel[3] > 8 && int(pixel[0]) > int(pixel[1]) + 8;
        QVERIFY2(!red && !reddish, qPrintable(QString("%1, %2").arg(x).arg(y)));
        if (x < 3 || y < 3)  // nothing is written there
          QCOMPARE(int(pixel[3]), Background(ground) == Background::transparent ? 0 : 255);
      }
    QVERIFY(anatomy > width * height / 4);
  }

  /// In a drawing of lines it is a layer below the names; on a transparent ground a gap.
  void drawingsHaveIt() {
    ExportOrder order = closeUp();
    const Result<std::string> white = svgText(order, {}, {});
    QVERIFY(white.ok());
    QVERIFY(white->find("inkscape:label=\"frame\"") < white->find("id=\"labels\""));
    order.environment.background = Background::transparent;
    const Result<std::string> clear = svgText(order, {}, {});
    QVERIFY(clear.ok());
    QVERIFY(clear->find("<mask") != std::string::npos);
    QCOMPARE(clear->find("inkscape:label=\"ground\""), std::string::npos);
  }

 private:
  std::unique_ptr<Typesetting> m_typesetting;
};

}  // namespace sline::test

SLINE_TEST(sline::test::FramedPlateTest)
#include "framed_plate_test.moc"
