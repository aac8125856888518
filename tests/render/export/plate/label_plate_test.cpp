// SPDX-License-Identifier: Apache-2.0
// Tests plates: columns no wider than they must be, the anatomy as large as it can be beside them.
#include <QTest>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/export/plate/figure_plate.h"
#include "render/export/plate/plate_image.h"
#include "render/labels/label_room.h"
#include "render/lettering/column_widths.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

using namespace render;

namespace {

const char* const longText =
    "Musculus iliacus sinister cum fascia iliaca et nervo femorali, qui inter iliacum et psoam "
    "descendit";

const char* const longWord = "Hypogastricoretroperitoneoprostaticovesicalfascia";
const char* const chineseText =
    "骶骨是由五块融合的椎骨组成的三角形骨骼与两侧髋骨相关节位于脊柱下端骨盆后壁的正中部位";

/// Returns a ball as wide as high with labels all around its front.
model::Scene labelled(const std::vector<std::string>& texts) {
  model::Scene scene;
  model::Node node;
  node.name = "Ball";
  node.mesh = sphere(50.0f, 4);
  node.style.gamma = Gamma::clamped(5.0f);
  const model::NodeId id = scene.append(std::move(node));
  const model::Mesh& mesh = *scene.find(id)->mesh;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const float turn = 2.4f * float(i);
    const glm::vec3 way(0.7f * std::sin(turn), -0.6f, 0.75f * std::cos(turn));
    std::uint32_t best = 0;
    float farthest = -1e9f;
    for (std::uint32_t k = 0; k < mesh.triangleCount(); ++k)
      if (const float along = glm::dot(model::placeOn(mesh, {id, k, {0.3f, 0.3f}}), way);
          along > farthest) {
        farthest = along;
        best = k;
      }
    scene.appendAnnotation(
        {.anchors = {model::SurfacePoint{id, best, {0.3f, 0.3f}}}, .text = texts[i]});
  }
  return scene;
}

std::vector<std::string> shortTexts(std::size_t number) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < number; ++i)
    texts.push_back("Nervus " + std::to_string(i));
  return texts;
}

ExportOrder orderOf(const model::Scene& scene, const glm::vec2& page) {
  ExportOrder order;
  order.scene = scene;
  order.page.sizeMm = page;
  order.labels.mode = LabelMode::on;
  order.viewName = "anterior";
  order.camera = model::anatomicalCamera(model::AnatomicalView::anterior, scene.visibleBounds(),
                                         page.x / page.y);
  return order;
}

void fit(ExportOrder& order, const Typesetting& typesetting) {
  const model::Mesh& mesh = *order.scene.nodes().back().mesh;
  const glm::vec2 page = order.page.sizeMm;
  order.camera = model::fitted(order.camera, mesh.positions(), page.x / page.y,
                               sidesOfPlate(order, typesetting));
}

LabelBox anatomyOf(const ExportOrder& order) {
  return *obstaclesOf(order.scene, Screen(order.camera, order.page.sizeMm)).extent;
}

}  // namespace

class LabelPlateTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    Result<std::unique_ptr<Typesetting>> made = Typesetting::create();
    QVERIFY(made.ok());
    m_typesetting = std::move(*made);
  }

  /// Text measured by its words is as large as the text when set.
  void measuredAsSet_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("kind");
    QTest::newRow("word") << "Os" << 0;
    QTest::newRow("long") << longText << 0;
    QTest::newRow("joined") << "Sacrum-L5-IntervertebralDisc with left_kidney" << 0;
    QTest::newRow("callout") << "One line\n\nand another that is much longer than the first" << 1;
    QTest::newRow("marked callout")
        << "**Urinary bladder** (*vesica urinaria*)\n- the ***detrusor muscle*** of its wall\n- "
           "Trigone-of-Lieutaud\n- \nand **more words that are bold** than fit"
        << 1;
    QTest::newRow("none") << "" << 2;
    QTest::newRow("Chinese") << QString::fromUtf8(chineseText) << 0;
    QTest::newRow("parted") << QString("of ") + longWord << 0;
    QTest::newRow("parted list") << QString("- ") + longWord + "\n- left_" + longWord << 1;
  }
  void measuredAsSet() {
    QFETCH(QString, text);
    QFETCH(int, kind);
    ShownLabel label;
    label.text = text.toStdString();
    label.item.kind = model::AnnotationKind(kind);
    for (const LabelMode mode : {LabelMode::on, LabelMode::numbers, LabelMode::blank}) {
      const LabelStyle style{.mode = mode, .language = {}};
      constexpr WordRoom words{.whole = 70.0f, .part = 60.0f};
      const MeasuredText measured(label, style, words);
      for (float width = 12.0f; width < 60.0f; width += 1.7f) {
        const glm::vec2 set = textOf(label, style, width, words).box;
        const glm::vec2 box = measured.boxAt(width);
        QVERIFY2(std::abs(box.x - set.x) < 0.4f && std::abs(box.y - set.y) < 1e-3f,
                 qPrintable(QString("at %1: %2 × %3, set %4 × %5")
                                .arg(width)
                                .arg(box.x)
                                .arg(box.y)
                                .arg(set.x)
                                .arg(set.y)));
      }
    }
  }

  /// One long label among short ones is broken: the anatomy is nearly as large as without it.
  void oneLongLabelDoesNotMakeTheAnatomySmall() {
    for (const glm::vec2 page : {glm::vec2(210, 297), glm::vec2(160, 120)}) {
      std::vector<std::string> texts = shortTexts(10);
      ExportOrder plain = orderOf(labelled(texts), page);
      fit(plain, *m_typesetting);
      texts[4] = longText;
      ExportOrder with = orderOf(labelled(texts), page);
      fit(with, *m_typesetting);
      const float share = anatomyOf(with).size().x / anatomyOf(plain).size().x;
      QVERIFY2(share > 0.9f, qPrintable(QString::number(double(share))));
    }
  }

  /// Texts without spaces are broken, too, and a text that no page has room for takes none.
  void unbrokenTextsDoNotMakeTheAnatomySmall_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("leftOut");
    QTest::newRow("Chinese") << QString::fromUtf8(chineseText) << 0;
    QTest::newRow("word") << longWord << 0;
    QTest::newRow("both") << QString::fromUtf8(chineseText) + ' ' + longWord << 0;
    QTest::newRow("150 letters") << QString(150, 'x') << 0;
    QTest::newRow("5000 letters") << QString(5000, 'x') << 1;
  }
  void unbrokenTextsDoNotMakeTheAnatomySmall() {
    QFETCH(QString, text);
    QFETCH(int, leftOut);
    for (const glm::vec2 page : {glm::vec2(210, 297), glm::vec2(160, 120)}) {
      std::vector<std::string> texts = shortTexts(10);
      texts[4] = longText;
      ExportOrder plain = orderOf(labelled(texts), page);
      fit(plain, *m_typesetting);
      texts[4] = text.toStdString();
      ExportOrder with = orderOf(labelled(texts), page);
      fit(with, *m_typesetting);
      const LabelBox anatomy = anatomyOf(with);
      const float share = anatomy.size().x / anatomyOf(plain).size().x;
      QVERIFY2(share > 0.85f, qPrintable(QString::number(double(share))));
      const LabelPlate plate = *figurePlate(with).labels;
      QCOMPARE(int(plate.layout.leftOut.size()), leftOut);
      QVERIFY(plate.layout.edges[0] < anatomy.low.x && plate.layout.edges[1] > anatomy.high.x);
      for (const PlacedLabel& label : plate.layout.labels)
        QVERIFY2(!overlap(label.box, anatomy), "a label covers the anatomy");
    }
  }

  /// However large the letters, each column has half of the page.
  void columnsNeverMeet() {
    std::vector<std::string> texts = shortTexts(6);
    texts[1] = texts[2] = longWord;
    texts[3] = chineseText;
    ExportOrder order = orderOf(labelled(texts), {80, 60});
    for (const float points : {4.0f, 10.0f, 24.0f, 48.0f}) {
      order.labels.points = points;
      const LabelPlate plate = *figurePlate(order).labels;
      const auto in = [&](LabelPost post) {
        return std::any_of(plate.layout.labels.begin(), plate.layout.labels.end(),
                           [post](const PlacedLabel& label) { return label.post == post; });
      };
      QVERIFY2(plate.layout.edges[0] <= plate.layout.edges[1] ||
                   !(in(LabelPost::left) && in(LabelPost::right)),
               qPrintable(QString::number(double(points))));
    }
  }

  void anatomyFillsWhatColumnsLeave_data() {
    QTest::addColumn<QSizeF>("page");
    QTest::addColumn<int>("labels");
    for (const int labels : {3, 8, 17, 30}) {
      QTest::addRow("A4, %d labels", labels) << QSizeF(210, 297) << labels;
      QTest::addRow("A4 on its side, %d labels", labels) << QSizeF(297, 210) << labels;
      QTest::addRow("a screen, %d labels", labels) << QSizeF(254, 159) << labels;
    }
  }
  void anatomyFillsWhatColumnsLeave() {
    QFETCH(QSizeF, page);
    QFETCH(int, labels);
    std::vector<std::string> texts = shortTexts(std::size_t(labels));
    texts[1] = "Musculus obturatorius internus sinister";
    ExportOrder order = orderOf(labelled(texts), {float(page.width()), float(page.height())});
    fit(order, *m_typesetting);
    const LabelPlate plate = *figurePlate(order).labels;
    QCOMPARE(plate.layout.leftOut.size(), std::size_t(0));
    const LabelBox anatomy = anatomyOf(order);
    float left = edgePadding;
    float right = edgePadding;
    for (const PlacedLabel& label : plate.layout.labels) {
      QVERIFY2(!overlap(label.box, anatomy), "a label covers the anatomy");
      float& side = label.post == LabelPost::left ? left : right;
      side = std::max(side, label.box.size().x + besideColumnMm());
    }
    const glm::vec2 room(order.page.sizeMm.x - left - right, order.page.sizeMm.y - 22.0f);
    const float filled = std::max(anatomy.size().x / room.x, anatomy.size().y / room.y);
    QVERIFY2(filled > 0.93f, qPrintable(QString::number(double(filled))));
  }

  void labelsKeepOffAnatomy_data() {
    QTest::addColumn<QSizeF>("page");
    QTest::addColumn<float>("nearer");
    QTest::addColumn<bool>("most");
    const auto row = [](const char* name, const QSizeF& page, float nearer, bool most) {
      QTest::newRow(name) << page << nearer << most;
    };
    row("usual", {160, 120}, 1.0f, true);
    row("a narrow panel", {55, 70}, 1.0f, true);
    row("a small panel", {60, 45}, 1.0f, false);
    row("tiny", {30, 40}, 1.0f, false);
    row("nearer", {160, 120}, 1.5f, true);
    row("into both columns", {120, 120}, 1.9f, false);
  }
  /// Whatever room a page has beside a ball, whose outline is a circle: no label lies over the
  /// ball, and what finds no room is told.
  void labelsKeepOffAnatomy() {
    QFETCH(QSizeF, page);
    QFETCH(float, nearer);
    QFETCH(bool, most);
    std::vector<std::string> texts = shortTexts(12);
    texts[1] = "Musculus obturatorius internus sinister";
    texts[4] = longWord;
    ExportOrder order = orderOf(labelled(texts), {float(page.width()), float(page.height())});
    order.labels.points = 8.0f;
    order.camera.projection = model::Projection::orthographic;
    fit(order, *m_typesetting);
    order.camera.heightMm /= nearer;
    const FigurePlate plate = figurePlate(order);
    const glm::vec2 middle = *Screen(order.camera, order.page.sizeMm).place({0.0f, 0.0f, 0.0f});
    // The mesh lies within the ball.
    const float outline = 0.995f * 50.0f * order.page.sizeMm.y / order.camera.heightMm;
    for (const PlacedLabel& label : plate.labels->layout.labels) {
      const glm::vec2 nearest = glm::clamp(middle, label.box.low, label.box.high);
      QVERIFY2(glm::distance(nearest, middle) > outline, "a label covers the anatomy");
    }
    std::size_t told = 0;
    for (const ExportNote& note : plate.notes)
      told += note.kind == ExportNote::Kind::labelsWithoutRoom ? note.names.size() : 0;
    QCOMPARE(told, plate.labels->layout.leftOut.size());
    if (most)
      QVERIFY2(told <= 2, qPrintable(QString("%1 labels found no room").arg(told)));
  }

  /// Pictures that follow each other break lines as the first did.
  void linesStayWhileTheCameraTurns() {
    std::vector<std::string> texts = shortTexts(8);
    texts[2] = longText;
    ExportOrder order = orderOf(labelled(texts), {160, 120});
    fit(order, *m_typesetting);
    model::MeshTrees trees;
    const auto at = [&](float away, const LabelTurn& turn) {
      model::Camera camera = order.camera;
      camera.eye = camera.target + away * (camera.eye - camera.target);
      return labelPlate(order.scene, Screen(camera, order.page.sizeMm), order.labels, trees, turn);
    };
    const LabelPlate first = at(1.0f, {});
    const LabelPlate far = at(1.6f, {.before = &first.layout, .moving = true});
    QCOMPARE(far.texts.size(), first.texts.size());
    for (std::size_t i = 0; i < far.texts.size(); ++i)
      QCOMPARE(far.texts[i].lines, first.texts[i].lines);
    QVERIFY2(at(1.6f, {}).texts[2].lines != first.texts[2].lines,
             "there is no room for longer lines");
  }

  /// The room beside labels depends on the camera's direction alone: not on how near it is, nor on
  /// which labels lie behind it.
  void sidesDependOnTheDirection() {
    ExportOrder order = orderOf(labelled(shortTexts(9)), {160, 120});
    const model::FreeSides wanted = sidesOfPlate(order, *m_typesetting);
    const glm::vec3 way = order.camera.target - order.camera.eye;
    for (const glm::vec3& by : {0.99f * way, -2.0f * way, glm::vec3(300.0f, 0.0f, 80.0f)}) {
      ExportOrder moved = order;
      moved.camera.eye += by;
      moved.camera.target += by;
      const model::FreeSides sides = sidesOfPlate(moved, *m_typesetting);
      QVERIFY(std::abs(sides.left - wanted.left) < 1e-3 &&
              std::abs(sides.right - wanted.right) < 1e-3);
    }
  }

  /// Labels take room at the sides where they stand and nowhere else.
  void sidesWithoutColumnStay() {
    model::Scene scene = labelled({"Nervus", "Musculus", "Arteria"});
    ExportOrder order = orderOf(scene, {160, 120});
    for (const ExportMarks& marks : {ExportMarks(), ExportMarks::none()}) {
      order.marks = marks;
      order.labels.mode = LabelMode::off;
      const model::FreeSides bare = sidesOfPlate(order, *m_typesetting);
      if (marks == ExportMarks::none())
        QCOMPARE(bare, model::FreeSides());
      order.labels.mode = LabelMode::on;
      const model::FreeSides sides = sidesOfPlate(order, *m_typesetting);
      QVERIFY(sides.left > bare.left && sides.right > bare.right);
      QVERIFY(sides.top == bare.top && sides.bottom == bare.bottom);
      // All at the patient's right, which is the picture's left.
      std::vector<model::Annotation> left = scene.annotations();
      std::erase_if(left, [&](const model::Annotation& label) {
        return scene.placeOf(label.anchors.front())->x > -10.0f;
      });
      QCOMPARE(left.size(), std::size_t(1));
      ExportOrder half = order;
      half.scene.setAnnotations(left);
      const model::FreeSides one = sidesOfPlate(half, *m_typesetting);
      QVERIFY(one.left > bare.left + 0.05);
      QCOMPARE(one.right, bare.right);
    }
  }

 private:
  std::unique_ptr<Typesetting> m_typesetting;
};

}  // namespace sline::test

SLINE_TEST(sline::test::LabelPlateTest)
#include "label_plate_test.moc"
