// SPDX-License-Identifier: Apache-2.0
// Tests that marks keep off anatomy, labels and each other.
#include <QTest>
#include <algorithm>
#include <glm/geometric.hpp>
#include <memory>
#include <random>
#include <set>
#include <string>

#include "model/scene/section.h"
#include "model/scene/visible_structures.h"
#include "render/export/plate/figure_plate.h"
#include "render/export/plate/plate_image.h"
#include "render/labels/seen/screen.h"
#include "render/lettering/typesetting.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

using namespace render;

namespace {

model::Scene sphereScene(const char* frame = "LPS") {
  model::Scene scene;
  model::Node node;
  node.name = "Sphere";
  node.mesh = sphere(50.0f, 3);
  node.provenance.frame = frame;
  node.provenance.credit = {.authors = "Who made the ball", .source = {}, .licence = "CC0"};
  scene.append(std::move(node));
  return scene;
}

ExportOrder orderOf(const model::Scene& scene, const char* view = "anterior") {
  ExportOrder order;
  order.scene = scene;
  order.viewName = view;
  if (const auto side = model::anatomicalViewNamed(view))
    order.camera = model::anatomicalCamera(*side, scene.visibleBounds(), 160.0f / 90.0f);
  return order;
}

const LetteringItem* find(const Marks& marks, const std::string& name) {
  for (const LetteringItem& item : marks.lettering.items)
    if (item.name == name)
      return &item;
  return nullptr;
}

QRectF boxOf(const LetteringItem& item) {
  QRectF box = item.text ? outlineOf(*item.text).boundingRect() : QRectF();
  for (const LetteringShape& shape : item.shapes)
    box |= painterPath(shape.path).boundingRect();
  return box;
}

model::Section coronal(float mm) {
  model::Section section;
  section.plane = model::anatomicalPlane(model::AnatomicalView::posterior, mm);
  return section;
}

}  // namespace

class ClearMarksTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    Result<std::unique_ptr<Typesetting>> made = Typesetting::create();
    QVERIFY(made.ok());
    m_typesetting = std::move(*made);
  }

  void marksKeepOffAnatomy_data() {
    QTest::addColumn<int>("seed");
    for (int seed = 0; seed < 40; ++seed)
      QTest::addRow("camera %d", seed) << seed;
  }

  /// Where a ball reaches under the usual place of a mark, the mark stands beside the ball, a
  /// letter at its own edge; what has no such place is left out and told. The ball's outline is
  /// known: a circle.
  void marksKeepOffAnatomy() {
    QFETCH(int, seed);
    constexpr float radius = 50.0f;
    std::mt19937 random(std::uint32_t(seed) + 1);
    std::uniform_real_distribution<float> any(-1.0f, 1.0f);
    ExportOrder order = orderOf(sphereScene());
    order.legend = LegendList::all;
    order.scene.appendSection(coronal(-12.0f));
    order.words.text.text = "What the view says";
    order.sources = SourceCredits::line;
    order.camera.projection = model::Projection::orthographic;
    order.camera.heightMm = 100.0f + 60.0f * any(random);
    order.camera.target += glm::vec3(90.0f * any(random), 0.0f, 60.0f * any(random));
    order.camera.eye = order.camera.target + glm::vec3(0.0f, -400.0f, 0.0f);

    const Marks usual = marksOf(order);
    const FigurePlate plate = figurePlate(order);
    const Screen screen(order.camera, order.page.sizeMm);
    const glm::vec2 middle = *screen.place({0.0f, 0.0f, 0.0f});
    const float outline = radius * order.page.sizeMm.y / order.camera.heightMm;
    const auto touches = [&](const QRectF& box) {
      const glm::vec2 nearest{std::clamp(middle.x, float(box.left()), float(box.right())),
                              std::clamp(middle.y, float(box.top()), float(box.bottom()))};
      // The mesh lies within the ball.
      return glm::distance(nearest, middle) < 0.995f * outline;
    };
    bool inTheWay = false;
    for (const LetteringItem& item : usual.lettering.items)
      inTheWay = inTheWay || touches(boxOf(item));
    std::set<std::string> told;
    for (const ExportNote& note : plate.marks.notes)
      if (note.kind == ExportNote::Kind::marksWithoutRoom)
        told.insert(note.names.begin(), note.names.end());
    for (const LetteringItem& item : plate.marks.lettering.items) {
      const QRectF box = boxOf(item);
      // What the view says and whose work it is are never lost: where they have no room the
      // picture ends above them.
      QRectF seen = box;
      if (plate.marks.cutOff)
        seen.setBottom(std::min(seen.bottom(), qreal(plate.marks.cutOff->low.y)));
      QVERIFY2(seen.height() <= 0.0 || !touches(seen), item.name.c_str());
      QVERIFY(QRectF(0, 0, 160, 90).contains(box));
      if (const LetteringItem* before = find(usual, item.name); item.name == "side R")
        QCOMPARE(box.left(), boxOf(*before).left());
      if (const LetteringItem* before = find(usual, item.name); item.name == "side S")
        QCOMPARE(box.top(), boxOf(*before).top());
    }
    for (const LetteringItem& item : usual.lettering.items)
      if (!find(plate.marks, item.name))
        QVERIFY2(told.contains(item.name) ||
                     (item.name.starts_with("legend") && told.contains("legend")),
                 item.name.c_str());
    QVERIFY(find(plate.marks, "caption") && find(plate.marks, "sources"));
    const bool cut = std::any_of(
        plate.marks.notes.begin(), plate.marks.notes.end(),
        [](const ExportNote& note) { return note.kind == ExportNote::Kind::footCutOff; });
    QCOMPARE(plate.marks.cutOff.has_value(), cut);
    if (!inTheWay && !cut)
      QCOMPARE(plate.marks.lettering.items.size(), usual.lettering.items.size());
  }

  /// A body is not tilted by what is in the way of one letter: those of an axis move together. None
  /// stands so near to other words that they read as one.
  void lettersOfAnAxisMoveTogether() {
    ExportOrder order = orderOf(sphereScene());
    order.camera.projection = model::Projection::orthographic;
    order.camera.heightMm = 130.0f;
    order.camera.target += glm::vec3(0.0f, 0.0f, -20.0f);  // the ball reaches over the upper edge
    order.camera.eye = order.camera.target + glm::vec3(0.0f, -400.0f, 0.0f);
    const Marks marks = figurePlate(order).marks;
    const auto middle = [&marks](const char* name) {
      const LetteringItem* item = find(marks, name);
      return item ? item->text->at : glm::vec2(-1.0f);
    };
    QVERIFY(std::abs(middle("side S").x - 80.0f) > 15.0f);
    QVERIFY(std::abs(middle("side S").x - middle("side I").x) < 0.01f);
    QVERIFY(std::abs(middle("side R").y - middle("side L").y) < 0.01f);
    for (const LetteringItem& one : marks.lettering.items)
      for (const LetteringItem& other : marks.lettering.items)
        if (&one != &other && one.text && other.text)
          QVERIFY2(!boxOf(one).adjusted(-0.5, 0.0, 0.5, 0.0).intersects(boxOf(other)),
                   (one.name + " at " + other.name).c_str());
  }

  /// A camera that is fitted leaves room for what the view says, above whose work it is.
  void fittedCamerasLeaveRoomForWords() {
    ExportOrder order = orderOf(sphereScene());
    order.sources = SourceCredits::line;
    const auto heightLeft = [&] {
      const model::FreeSides sides = sidesOfPlate(order, *m_typesetting);
      return 1.0 - sides.top - sides.bottom;
    };
    const double wordless = heightLeft();
    order.words.text.text = "What the view says.\n\nIt says more than one line of it.";
    QVERIFY2(heightLeft() < wordless - 0.05, qPrintable(QString::number(heightLeft())));
    order.camera = model::fittedToVisible(order.scene, order.camera, 160.0f / 90.0f,
                                          sidesOfPlate(order, *m_typesetting));
    const FigurePlate plate = figurePlate(order);
    QVERIFY(!plate.marks.cutOff);
    QVERIFY(plate.marks.caption);
    // It stands at its usual place.
    QCOMPARE(plate.marks.caption->low.y, marksOf(order).caption->low.y);
  }

  /// Where a ball fills the picture from its head to its foot, what the view says stands in a
  /// corner, in a box that is narrow enough, and the picture stays whole.
  void wordsGoToACorner() {
    ExportOrder order = orderOf(sphereScene());
    order.words.text.text = "What the view says takes some lines where the box is narrow";
    order.marks.scaleBar = false;
    order.camera.projection = model::Projection::orthographic;
    order.camera.heightMm = 95.0f;
    const Screen screen(order.camera, order.page.sizeMm);
    const glm::vec2 middle = *screen.place({0.0f, 0.0f, 0.0f});
    const float outline = 50.0f * order.page.sizeMm.y / order.camera.heightMm;
    const FigurePlate plate = figurePlate(order);
    QVERIFY(plate.marks.caption && !plate.marks.cutOff);
    const LetteringItem& caption = *find(plate.marks, "caption");
    const QRectF box = boxOf(caption);
    QVERIFY(QRectF(0, 0, 160, 90).contains(box));
    for (const QPointF& corner :
         {box.topLeft(), box.topRight(), box.bottomLeft(), box.bottomRight()})
      QVERIFY(glm::distance(glm::vec2(float(corner.x()), float(corner.y())), middle) > outline);
    QCOMPARE(plainText(caption.text->lines, QChar(' ')),
             QString::fromStdString(order.words.text.text));
    for (const ExportNote& note : plate.marks.notes)
      QVERIFY(note.kind != ExportNote::Kind::textShortened &&
              note.kind != ExportNote::Kind::footCutOff);
    // With a ball over all of the page it stands below the picture.
    order.camera.heightMm = 40.0f;
    QVERIFY(figurePlate(order).marks.cutOff);
  }

  void nothingCoversAnything_data() {
    QTest::addColumn<QSizeF>("page");
    QTest::addColumn<double>("points");
    QTest::addColumn<QString>("view");
    QTest::newRow("usual") << QSizeF(160, 90) << 10.0 << "anterior";
    QTest::newRow("upright") << QSizeF(90, 160) << 10.0 << "posterior";
    QTest::newRow("small") << QSizeF(50, 40) << 8.0 << "left";
    QTest::newRow("tiny") << QSizeF(20, 15) << 10.0 << "anterior";
    QTest::newRow("large letters") << QSizeF(160, 120) << 24.0 << "superior";
    QTest::newRow("a long name") << QSizeF(160, 90) << 10.0
                                 << "A view of the sphere in the clinical situation of last week, "
                                    "from somewhere in front and below";
  }

  void nothingCoversAnything() {
    QFETCH(QSizeF, page);
    QFETCH(double, points);
    QFETCH(QString, view);
    model::Scene scene = sphereScene();
    const model::Node& node = scene.nodes().front();
    std::vector<model::Annotation> annotations;
    for (std::uint32_t i = 0; i < 18; ++i) {
      model::Annotation annotation;
      annotation.kind = model::AnnotationKind(i % 3);
      annotation.anchors = {model::SurfacePoint{node.id, 70 * i, {0.3f, 0.3f}}};
      annotation.text = "Structure of that name " + std::to_string(i);
      annotations.push_back(annotation);
    }
    for (const model::Annotation& annotation : annotations)
      scene.appendAnnotation(annotation);
    scene.appendSection(coronal(0.0f));
    ExportOrder order = orderOf(scene, view.toUtf8().constData());
    order.page.sizeMm = {float(page.width()), float(page.height())};
    order.labels = {.mode = LabelMode::on, .points = float(points), .language = {}};
    const FigurePlate plate = figurePlate(order);
    std::vector<QRectF> boxes;
    for (const LetteringItem& item : plate.marks.lettering.items)
      boxes.push_back(boxOf(item));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      QVERIFY(QRectF(QPointF(), page).contains(boxes[i]));
      for (std::size_t k = i + 1; k < boxes.size(); ++k)
        QVERIFY(!boxes[i].intersects(boxes[k]));
      for (const PlacedLabel& label : plate.labels->layout.labels)
        QVERIFY(!boxes[i].intersects(
            QRectF(QPointF(double(label.box.low.x), double(label.box.low.y)),
                   QPointF(double(label.box.high.x), double(label.box.high.y)))));
    }
    if (page.width() > 60.0)
      QVERIFY(!plate.labels->layout.labels.empty());
    if (page.width() > 30.0)
      QVERIFY(boxes.size() >= 5);
  }

 private:
  std::unique_ptr<Typesetting> m_typesetting;
};

}  // namespace sline::test

SLINE_TEST(sline::test::ClearMarksTest)
#include "clear_marks_test.moc"
