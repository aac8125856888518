// SPDX-License-Identifier: Apache-2.0
// Tests marks at a picture's edges: they are true.
#include <QTest>
#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "render/export/plate/figure_plate.h"
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

QString textOf(const Marks& marks, const std::string& name) {
  const LetteringItem* item = find(marks, name);
  return item && item->text ? plainText(item->text->lines, QChar('\n')) : QString();
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

/// Returns the direction in LPS in which a letter's side of the body lies.
glm::vec3 wayOf(char letter) {
  switch (letter) {
    case 'L':
      return {1, 0, 0};
    case 'R':
      return {-1, 0, 0};
    case 'P':
      return {0, 1, 0};
    case 'A':
      return {0, -1, 0};
    case 'S':
      return {0, 0, 1};
    default:
      return {0, 0, -1};
  }
}

}  // namespace

class MarksTest : public QObject {
  Q_OBJECT

 private slots:
  /// A legend's rows lie on the page and on nothing else; what finds no room is told.
  void legends_data() {
    QTest::addColumn<int>("structures");
    QTest::addColumn<QSizeF>("page");
    QTest::addColumn<bool>("whole");
    QTest::newRow("three") << 3 << QSizeF(160, 90) << true;
    QTest::newRow("two columns") << 16 << QSizeF(160, 90) << true;
    QTest::newRow("too many") << 200 << QSizeF(160, 90) << false;
    QTest::newRow("a small page") << 5 << QSizeF(40, 20) << false;
  }
  void legends() {
    QFETCH(int, structures);
    QFETCH(QSizeF, page);
    QFETCH(bool, whole);
    ExportOrder order = orderOf(sphereScene());
    for (int i = 1; i < structures; ++i) {
      model::Node node;
      node.name = "Ball " + std::to_string(i);
      node.mesh = sphere(10.0f, 1);
      order.scene.append(std::move(node));
    }
    order.page.sizeMm = {float(page.width()), float(page.height())};
    QVERIFY(!marksOf(order).legend);
    order.legend = LegendList::labelled;
    Marks marks = marksOf(order);
    QVERIFY(!marks.legend);
    QVERIFY(std::any_of(marks.notes.begin(), marks.notes.end(), [](const ExportNote& note) {
      return note.kind == ExportNote::Kind::legendEmpty;
    }));
    order.legend = LegendList::all;
    marks = marksOf(order);
    std::vector<QRectF> boxes;
    std::size_t rows = 0;
    for (const LetteringItem& item : marks.lettering.items) {
      boxes.push_back(boxOf(item));
      rows += item.name.starts_with("legend: ") ? 1 : 0;
    }
    std::size_t left = 0;
    for (const ExportNote& note : marks.notes)
      if (note.kind == ExportNote::Kind::legendWithoutRoom)
        left += note.names.size();
    QCOMPARE(rows + left, std::size_t(structures));
    QCOMPARE(left == 0, whole);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      QVERIFY(QRectF(QPointF(), page).contains(boxes[i]));
      for (std::size_t k = 0; k < i; ++k)
        QVERIFY(!boxes[i].intersects(boxes[k]));
    }
  }

  void initTestCase();
  void lettersAreTrue_data();
  void lettersAreTrue();
  void leftAndRightOfTheSixViews_data();
  void leftAndRightOfTheSixViews();
  void noLettersWithoutDirections();
  void onlyThoseWanted();
  void theScaleIsTrue_data();
  void theScaleIsTrue();
  void sections();
  void sectionsWithoutSides();
  void theBarOfASectionIsTrueOnItsFace();
  void theViewsNameIsTrue_data();
  void theViewsNameIsTrue();
  void words_data();
  void words();
  void whatIsPaintedIsInItsPlace();

 private:
  std::unique_ptr<Typesetting> m_typesetting;
};

void MarksTest::initTestCase() {
  Result<std::unique_ptr<Typesetting>> made = Typesetting::create();
  QVERIFY(made.ok());
  m_typesetting = std::move(*made);
}

void MarksTest::lettersAreTrue_data() {
  QTest::addColumn<int>("seed");
  QTest::addColumn<bool>("parallel");
  for (int seed = 0; seed < 60; ++seed)
    QTest::addRow("camera %d", seed) << seed << (seed % 2 == 1);
}

/// Wherever the camera is, and whatever is upwards in the picture, a place farther to the patient's
/// left is nearer to the edge that says L.
void MarksTest::lettersAreTrue() {
  QFETCH(int, seed);
  QFETCH(bool, parallel);
  std::mt19937 random(std::uint32_t(seed) + 1);
  std::uniform_real_distribution<float> any(-1.0f, 1.0f);
  const auto direction = [&] { return glm::vec3(any(random), any(random), any(random)); };
  ExportOrder order = orderOf(sphereScene());
  order.camera.projection =
      parallel ? model::Projection::orthographic : model::Projection::perspective;
  order.camera.target = 10.0f * direction();
  order.camera.eye = order.camera.target + 400.0f * glm::normalize(direction());
  order.camera.up = glm::normalize(direction());
  const Marks marks = marksOf(order);
  const Screen screen(order.camera, order.page.sizeMm);
  const glm::vec2 middle = 0.5f * order.page.sizeMm;
  int letters = 0;
  for (const LetteringItem& item : marks.lettering.items) {
    if (!item.name.starts_with("side "))
      continue;
    const QPointF centre = boxOf(item).center();
    const glm::vec2 edge(float(centre.x()) - middle.x, float(centre.y()) - middle.y);
    const glm::vec2 outwards =
        std::abs(edge.x) > std::abs(edge.y) ? glm::vec2(edge.x, 0.0f) : glm::vec2(0.0f, edge.y);
    const QString side = plainText(item.text->lines.front());
    for (const QChar letter : side) {
      const glm::vec3 way = wayOf(char(letter.toLatin1()));
      const glm::vec2 moved = *screen.place(order.camera.target + 5.0f * way) - middle;
      QVERIFY2(glm::dot(moved, outwards) > 0.0f, qPrintable(side));
      ++letters;
    }
  }
  QVERIFY(letters >= 4);
}

void MarksTest::leftAndRightOfTheSixViews_data() {
  QTest::addColumn<QString>("view");
  QTest::addColumn<QString>("leftEdge");
  QTest::addColumn<QString>("rightEdge");
  QTest::newRow("anterior") << "anterior"
                            << "R"
                            << "L";
  QTest::newRow("posterior") << "posterior"
                             << "L"
                             << "R";
  QTest::newRow("superior") << "superior"
                            << "L"
                            << "R";
  QTest::newRow("inferior") << "inferior"
                            << "R"
                            << "L";
  QTest::newRow("left") << "left"
                        << "A"
                        << "P";
  QTest::newRow("right") << "right"
                         << "P"
                         << "A";
}

void MarksTest::leftAndRightOfTheSixViews() {
  QFETCH(QString, view);
  QFETCH(QString, leftEdge);
  QFETCH(QString, rightEdge);
  const ExportOrder order = orderOf(sphereScene(), view.toUtf8().constData());
  const Marks marks = marksOf(order);
  const LetteringItem* left = find(marks, "side " + leftEdge.toStdString());
  const LetteringItem* right = find(marks, "side " + rightEdge.toStdString());
  QVERIFY(left && right);
  QVERIFY(boxOf(*left).right() < 20.0);
  QVERIFY(boxOf(*right).left() > 140.0);
}

/// R and L beside a molecule would be made up.
void MarksTest::noLettersWithoutDirections() {
  const auto letters = [](const model::Scene& scene) {
    const Marks marks = marksOf(orderOf(scene));
    return std::count_if(marks.lettering.items.begin(), marks.lettering.items.end(),
                         [](const LetteringItem& item) { return item.name.starts_with("side "); });
  };
  QCOMPARE(letters(sphereScene("file")), 0);
  QCOMPARE(letters(sphereScene("RAS")), 4);
  QCOMPARE(letters(sphereScene("")), 4);
}

void MarksTest::onlyThoseWanted() {
  model::Scene scene = sphereScene();
  scene.appendSection(coronal(0.0f));
  ExportOrder order = orderOf(scene);
  QCOMPARE(marksOf(order).lettering.items.size(), std::size_t(7));
  order.marks = ExportMarks::none();
  QVERIFY(marksOf(order).lettering.items.empty());
  QVERIFY(marksOf(order).edges == EdgeRoom());
  for (bool ExportMarks::*one :
       {&ExportMarks::viewName, &ExportMarks::scaleBar, &ExportMarks::sectionState}) {
    order.marks = ExportMarks::none();
    order.marks.*one = true;
    QCOMPARE(marksOf(order).lettering.items.size(), std::size_t(1));
  }
}

void MarksTest::theScaleIsTrue_data() {
  QTest::addColumn<bool>("parallel");
  QTest::addColumn<float>("width");
  QTest::newRow("parallel") << true << 160.0f;
  QTest::newRow("perspective") << false << 160.0f;
  QTest::newRow("parallel, narrow") << true << 60.0f;
  QTest::newRow("perspective, a poster") << false << 600.0f;
}

void MarksTest::theScaleIsTrue() {
  QFETCH(bool, parallel);
  QFETCH(float, width);
  ExportOrder order = orderOf(sphereScene());
  order.page.sizeMm = {width, 0.6f * width};
  order.camera.projection =
      parallel ? model::Projection::orthographic : model::Projection::perspective;
  order.camera.target = {0.0f, -30.0f, 0.0f};  // the bar holds in the middle of the visible part
  const Marks marks = marksOf(order);
  const LetteringItem* item = find(marks, "scale");
  QVERIFY(item);
  const QRectF bar = painterPath(item->shapes.front().path).boundingRect();
  const QString text = plainText(item->text->lines.front());
  QCOMPARE(text.endsWith("at mid-depth"), !parallel);
  const QStringList parts = text.split(QChar(' '));
  const float length = parts[0].toFloat() * (parts[1] == "cm" ? 10.0f : 1.0f);
  const Screen screen(order.camera, order.page.sizeMm);
  const glm::vec2 ends =
      *screen.place(length * model::cameraFrame(order.camera).right) - *screen.place({0, 0, 0});
  QVERIFY(std::abs(ends.x - float(bar.width())) < 1e-3f * width);
  QVERIFY(bar.width() <= 0.22 * double(width) + 1e-3);
}

void MarksTest::sections() {
  model::Scene scene = sphereScene();
  const model::NodeId id = scene.nodes().front().id;
  scene.appendSection(coronal(-12.0f));
  Marks marks = marksOf(orderOf(scene));
  QCOMPARE(textOf(marks, "section 1"),
           QString("Coronal section at A\u00a012.0\u00a0mm, posterior part kept"));
  model::Section off = coronal(5.0f);
  off.enabled = false;
  scene.appendSection(off);
  scene.appendSection(coronal(-80.0f));  // lies before the sphere and takes nothing away
  marks = marksOf(orderOf(scene));
  QVERIFY(!find(marks, "section 2"));
  model::Section scoped = coronal(5.0f);
  scoped.scope = id;
  scoped.plane = {glm::normalize(glm::vec3(1.0f, 1.0f, 0.0f)), 0.0f};
  scene.appendSection(scoped);
  marks = marksOf(orderOf(scene));
  QCOMPARE(textOf(marks, "section 2"), QString("Sphere: Oblique section"));
  scene.appendSection(coronal(1.0f));
  scene.appendSection(coronal(2.0f));
  marks = marksOf(orderOf(scene));
  QVERIFY(!find(marks, "section 1"));
  QCOMPARE(textOf(marks, "sections"), QString("4 sections"));
}

/// What has no sides has no axial section either.
void MarksTest::sectionsWithoutSides() {
  model::Scene scene = sphereScene("file");
  scene.appendSection(coronal(-12.0f));
  scene.appendSection({.plane = model::anatomicalPlane(model::AnatomicalView::inferior, 6.5f)});
  const Marks marks = marksOf(orderOf(scene));
  QCOMPARE(textOf(marks, "section 1"), QString("Section at y = -12.0\u00a0mm, larger y kept"));
  QCOMPARE(textOf(marks, "section 2"), QString("Section at z = 6.5\u00a0mm, smaller z kept"));
}

/// In perspective the bar of a section is true on the face that one sees, and says so.
void MarksTest::theBarOfASectionIsTrueOnItsFace() {
  model::Scene scene = sphereScene();
  scene.appendSection(coronal(30.0f));
  ExportOrder order = orderOf(scene);
  order.camera.projection = model::Projection::perspective;
  order.camera.eye = {0.0f, -200.0f, 0.0f};
  order.camera.target = {0.0f, 0.0f, 0.0f};
  const auto barOf = [&] {
    const Marks marks = marksOf(order);
    const LetteringItem* bar = find(marks, "scale");
    return std::pair(textOf(marks, "scale"),
                     bar ? painterPath(bar->shapes.front().path).boundingRect().width() : 0.0);
  };
  const auto [text, width] = barOf();
  QVERIFY2(text.endsWith("at the cut face"), qPrintable(text));
  const float length = text.startsWith("1 cm")   ? 10.0f
                       : text.startsWith("2 cm") ? 20.0f
                       : text.startsWith("5 cm") ? 50.0f
                                                 : 5.0f;
  const Screen screen(order.camera, order.page.sizeMm);
  const float drawn = screen.place({length, 30.0f, 0.0f})->x - screen.place({0.0f, 30.0f, 0.0f})->x;
  QVERIFY2(std::abs(drawn - float(width)) < 0.01f * drawn, qPrintable(text));
  // From behind one sees no face.
  order.camera.eye = {0.0f, 300.0f, 0.0f};
  QVERIFY(barOf().first.endsWith("at mid-depth"));
}

void MarksTest::theViewsNameIsTrue_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<glm::vec3>("eye");
  QTest::addColumn<QString>("said");
  QTest::newRow("from before") << "anterior" << glm::vec3(0, -500, 0) << "Anterior view";
  QTest::newRow("from behind") << "anterior" << glm::vec3(0, 500, 0) << "Posterior view";
  QTest::newRow("left is right") << "Left" << glm::vec3(-500, 0, 0) << "Right lateral view";
  QTest::newRow("nearly") << "Left" << glm::vec3(500, 200, 0) << "Left lateral view";
  QTest::newRow("along no axis") << "Left" << glm::vec3(-500, 200, 0) << "";
  QTest::newRow("own words") << "Seen by the surgeon" << glm::vec3(0, 500, 0)
                             << "Seen by the surgeon";
}

void MarksTest::theViewsNameIsTrue() {
  QFETCH(QString, name);
  QFETCH(glm::vec3, eye);
  QFETCH(QString, said);
  ExportOrder order = orderOf(sphereScene());
  order.camera.eye = eye;
  order.camera.target = {};
  order.camera.up = {0, 0, 1};
  order.viewName = name.toStdString();
  QCOMPARE(textOf(marksOf(order), "view"), said);
}

void MarksTest::words_data() {
  QTest::addColumn<QString>("language");
  QTest::addColumn<QString>("view");
  QTest::addColumn<QString>("section");
  QTest::newRow("none") << ""
                        << "Anterior view"
                        << "Coronal section at P\u00a01.5\u00a0mm, posterior part kept";
  QTest::newRow("en") << "en-GB"
                      << "Anterior view"
                      << "Coronal section at P\u00a01.5\u00a0mm, posterior part kept";
  QTest::newRow("de") << "de"
                      << "Ansicht von vorn"
                      << "Koronalschnitt bei P\u00a01,5\u00a0mm, hinterer Teil erhalten";
  QTest::newRow("nl") << "nl"
                      << "Vooraanzicht"
                      << "Coronale doorsnede bij P\u00a01,5\u00a0mm, achterste deel behouden";
  QTest::newRow("nb") << "nb"
                      << "Sett forfra"
                      << "Koronalt snitt ved P\u00a01,5\u00a0mm, bakre del beholdt";
  QTest::newRow("la") << "la"
                      << "Aspectus anterior"
                      << "Sectio coronalis ad P\u00a01.5\u00a0mm, parte posteriore servata";
  QTest::newRow("unknown") << "xx"
                           << "Anterior view"
                           << "Coronal section at P\u00a01.5\u00a0mm, posterior part kept";
}

void MarksTest::words() {
  QFETCH(QString, language);
  QFETCH(QString, view);
  QFETCH(QString, section);
  model::Scene scene = sphereScene();
  scene.appendSection(coronal(1.5f));
  ExportOrder order = orderOf(scene);
  order.labels.language = language.toStdString();
  Marks marks = marksOf(order);
  QCOMPARE(textOf(marks, "view"), view);
  QCOMPARE(textOf(marks, "section 1"), section);
  order.viewName = "<b>Liver</b> & bile";
  marks = marksOf(order);
  QCOMPARE(textOf(marks, "view"), QString("<b>Liver</b> & bile"));
}

void MarksTest::whatIsPaintedIsInItsPlace() {
  const ExportOrder order = orderOf(sphereScene());
  constexpr int scale = 10;
  QImage image(160 * scale, 90 * scale, QImage::Format_RGB32);
  image.fill(Qt::white);
  {
    QPainter painter(&image);
    painter.scale(scale, scale);
    paintPlate(painter, figurePlate(order));
  }
  const Marks marks = marksOf(order);
  for (const LetteringItem& item : marks.lettering.items) {
    const QRectF box = boxOf(item);
    int ink = 0;
    for (int y = int(scale * box.top()); y < int(scale * box.bottom()); ++y)
      for (int x = int(scale * box.left()); x < int(scale * box.right()); ++x)
        ink += qGray(image.pixel(x, y)) < 100;
    QVERIFY2(ink > 20, item.name.c_str());
  }
}

}  // namespace sline::test

SLINE_TEST(sline::test::MarksTest)
#include "marks_test.moc"
