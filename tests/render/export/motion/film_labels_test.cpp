// SPDX-License-Identifier: Apache-2.0
// Measures labels over films of 8 seconds as one sees them: which change sides, which are there or
// gone for less than a second, how often one hops, and whether they end on what they name.
#include "render/export/motion/film_labels.h"

#include <QDir>
#include <QtTest>
#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "model/demo/demo.h"
#include "model/edit/views.h"
#include "model/import/plan/import.h"
#include "render/export/order/view_orders.h"
#include "render/labels/seen/seen_map.h"
#include "render/lettering/typesetting.h"
#include "render/measures/leader_truth.h"
#include "render/picture/headless/headless_picture.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::render;

namespace {

constexpr glm::vec2 page{338.7f, 190.5f};
constexpr int rate = 10;

/// Adds that many labels, on the largest structures.
void label(ExportOrder& order, std::size_t number) {
  model::Scene& scene = order.scene;
  std::vector<std::pair<float, model::NodeId>> sizes;
  for (const model::NodeId id : scene.structuresBelow(model::rootId))
    if (scene.resolve(id).visible)
      sizes.emplace_back(-glm::length(scene.find(id)->mesh->bounds().size()), id);
  std::sort(sizes.begin(), sizes.end());
  const SeenMap map(scene, Screen(order.camera, page));
  for (std::size_t i = 0; i < sizes.size() && scene.annotations().size() < number; ++i)
    if (auto label = map.labelFor(sizes[i].second))
      scene.appendAnnotation(*label);
}

ExportOrder orderOf(const model::Scene& scene, Motion motion, std::size_t labels = 20) {
  ExportOrder order;
  order.scene = scene;
  order.page.sizeMm = page;
  order.labels.mode = LabelMode::on;
  order.camera = model::anatomicalCamera(model::AnatomicalView::anterior, scene.visibleBounds(),
                                         0.5f * page.x / page.y);
  label(order, labels);
  order.of<FilmOptions>() = {.motion = motion, .seconds = 8.0, .framesPerSecond = rate};
  return order;
}

/// Adds three views, each with labels of its own besides those of all.
ExportOrder tourOrder(ExportOrder order) {
  const model::Box bounds = order.scene.visibleBounds();
  std::vector<model::View> views;
  for (const auto from : {model::AnatomicalView::anterior, model::AnatomicalView::left,
                          model::AnatomicalView::posterior}) {
    const model::Camera camera = model::anatomicalCamera(from, bounds, 0.5f * page.x / page.y);
    model::View view = model::viewOf(order.scene, camera, "view");
    std::size_t each = 0;
    std::erase_if(*view.annotations,
                  [&](model::AnnotationId) { return each++ % 3 == views.size(); });
    views.push_back(view);
  }
  order.scene.setViews(views);
  return order;
}

/// Returns in words where each label of the plate stands and what it points at.
QStringList placesOf(const FigurePlate& plate) {
  QStringList places;
  for (const ShownLabel& label : plate.labels->labels)
    if (const PlacedLabel* placed = plate.labels->layout.find(label.item.id)) {
      const glm::vec2 place = label.item.places.front();
      places << QString("%1 %2: %3 %4, %5 %6%7")
                    .arg(label.item.id.value)
                    .arg(QString::fromStdString(label.text))
                    .arg(placed->box.low.x)
                    .arg(placed->box.low.y)
                    .arg(place.x)
                    .arg(place.y)
                    .arg(placed->hidden ? "?" : "");
    }
  return places;
}

model::NodeId structureOf(const model::Scene& scene, model::AnnotationId id) {
  for (const model::Annotation& annotation : scene.annotations())
    if (annotation.id == id)
      return std::get<model::SurfacePoint>(annotation.anchors.front()).structure;
  return {};
}

/// Holds what one sees of a label in a frame.
struct Sight {
  bool there = false;
  bool left = false;
  glm::vec2 box{0.0f};  ///< its middle
  float height = 0.0f;  ///< that of the text
  glm::vec2 place{0.0f};
};
using Sights = std::map<model::AnnotationId, std::vector<Sight>>;

struct Steadiness {
  int sides = 0;    ///< the most changes of side of any label
  int changes = 0;  ///< of all labels
  int blinks = 0;   ///< times that one is there or gone for less than a second
  int hops = 0;     ///< times that a box goes farther in a frame than its place and half a line
  int texts = 0;    ///< times that a text goes farther in a frame than it is high
  int places = 0;   ///< times that a place goes farther in a frame than 3 mm
  float farthest = 0.0f;  ///< that a text goes in a frame, millimetres
  double out = 0.0;
  double missing = 0.0;  ///< of the frames in which one sees what a label names
};

/// Counts runs of frames, shorter than a second, in which the label is there or gone; the runs at a
/// film's ends count where it loops.
int blinksOf(const std::vector<Sight>& frames, bool loops) {
  std::vector<int> ends;
  const int count = int(frames.size());
  for (int i = loops ? 0 : 1; i < count; ++i)
    if (frames[std::size_t(i)].there != frames[std::size_t((i + count - 1) % count)].there)
      ends.push_back(i);
  int blinks = 0;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k)
    blinks += ends[k + 1] - ends[k] < rate ? 1 : 0;
  if (loops && !ends.empty())
    blinks += ends.front() + count - ends.back() < rate ? 1 : 0;
  return blinks;
}

void addMotion(Steadiness& all, const std::vector<Sight>& frames, bool loops) {
  int sides = 0;
  std::optional<Sight> seen;
  const std::size_t count = frames.size();
  for (std::size_t i = 0; i < count + (loops ? 1 : 0); ++i) {
    const Sight& now = frames[i % count];
    all.out += now.there ? 0.0 : 1.0;
    if (!now.there)
      continue;
    sides += seen && seen->left != now.left ? 1 : 0;
    const bool follows = frames[(i + count - 1) % count].there;
    if (seen && follows) {
      const float way = glm::distance(seen->place, now.place);
      all.places += way > 3.0f ? 1 : 0;
      const float far = glm::distance(seen->box, now.box);
      all.farthest = std::max(all.farthest, far);
      all.texts += far > now.height ? 1 : 0;
      all.hops += glm::distance(seen->box, now.box) > way + 2.5f ? 1 : 0;
    }
    seen = now;
  }
  all.sides = std::max(all.sides, sides);
  all.changes += sides;
}

Steadiness steadinessOf(const ExportOrder& order) {
  const Film film = std::move(Film::create(order, glm::vec2(0.6f, 1.0f))).value();
  FilmLabels labels(order);
  labels.settle(film, {});
  Sights sights;
  for (const model::Annotation& annotation : order.scene.annotations())
    sights[annotation.id].resize(std::size_t(film.frames()));
  int seen = 0;
  int missing = 0;
  for (int i = 0; i < film.frames(); ++i) {
    const FigurePlate plate = labels.plateOf(film, i);
    for (const ShownLabel& label : plate.labels->labels) {
      const PlacedLabel* placed = plate.labels->layout.find(label.item.id);
      seen += label.item.hidden ? 0 : 1;
      missing += label.item.hidden || placed ? 0 : 1;
      if (placed)
        sights[label.item.id][std::size_t(i)] = {true, placed->box.middle().x < 0.5f * page.x,
                                                 placed->box.middle(), placed->box.size().y,
                                                 label.item.places.front()};
    }
  }
  Steadiness all;
  all.missing = double(missing) / double(std::max(seen, 1));
  for (const auto& [id, frames] : sights) {
    all.blinks += blinksOf(frames, film.loops());
    addMotion(all, frames, film.loops());
  }
  all.out /= double(sights.size()) * double(film.frames());
  qInfo(
      "%zu labels: at most %d changes of side, %d in all; %d blinks, %d hops, %d of texts, "
      "%.1f mm at most; %d places go; %.1f %% out, %.1f %% of the seen",
      sights.size(), all.sides, all.changes, all.blinks, all.hops, all.texts, double(all.farthest),
      all.places, 100.0 * all.out, 100.0 * all.missing);
  return all;
}

}  // namespace

class FilmLabelsTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    Result<std::unique_ptr<Typesetting>> made = Typesetting::create();
    QVERIFY(made.ok());
    m_typesetting = std::move(*made);
  }

  void turning_data() {
    QTest::addColumn<int>("demo");
    QTest::newRow("abdomen") << int(model::DemoName::abdomen);
    QTest::newRow("kidney") << int(model::DemoName::kidney);
  }
  void turning() {
    QFETCH(int, demo);
    judge(orderOf(demoScene(model::DemoName(demo)), Motion::turntable));
  }

  void turningAtlas_data() {
    QTest::addColumn<QString>("file");
    QTest::newRow("abdomen") << "abdomen/AbdominalAtlas-2015Sept-Slicer4-4Version.mrml";
    QTest::newRow("pelvis") << "pelvis/bodyparts3d";
  }
  void turningAtlas() {
    QFETCH(QString, file);
    const QString path = QStringLiteral(SLINE_TEST_DATA "/") + file;
    if (!QFile::exists(path))
      SLINE_ABSENT("no atlas here");
    const std::vector<std::filesystem::path> inputs{path.toStdString()};
    auto imported = model::importInputs(inputs, {.smoothing = model::Smoothing{}},
                                        [](double, const std::string&) { return true; });
    QVERIFY(imported.ok());
    judge(orderOf(imported->scene, Motion::turntable));
  }

  /// Where a tour rests it has the labels of the view's still, each in its place, and on its way
  /// none.
  void touring() {
    const ExportOrder order = tourOrder(orderOf(demoScene(model::DemoName::abdomen), Motion::tour));
    const Film film = std::move(Film::create(order, glm::vec2(0.6f, 1.0f))).value();
    FilmLabels labels(order);
    QVERIFY(labels.settle(film, {}));
    std::set<std::size_t> rested;
    std::size_t shown = 0;
    for (int i = 0; i < film.frames(); ++i) {
      const FilmFrame frame = film.at(i);
      const FigurePlate plate = labels.plateOf(film, i);
      QCOMPARE(plate.labels.has_value(), !frame.moving);
      QCOMPARE(plate.labels.has_value(), labels.alone(film, i).labels.has_value());
      if (frame.moving)
        continue;
      QVERIFY(frame.rest);
      const FigurePlate still = figurePlate(pictureOfView(order, order.scene.views()[*frame.rest]));
      QCOMPARE(placesOf(plate), placesOf(still));
      if (rested.insert(*frame.rest).second)
        shown += plate.labels->layout.labels.size();
    }
    QCOMPARE(rested.size(), order.scene.views().size());
    QVERIFY2(shown > 30, qPrintable(QString::number(shown)));
  }

  /// A tour that rests nowhere would have labels for one frame.
  void toursWithoutRests() {
    ExportOrder order = tourOrder(orderOf(demoScene(model::DemoName::kidney), Motion::tour));
    order.of<FilmOptions>().hold = 0.0;
    const Film film = std::move(Film::create(order)).value();
    FilmLabels labels(order);
    QVERIFY(labels.settle(film, {}));
    for (int i = 0; i < film.frames(); ++i)
      QVERIFY(!labels.plateOf(film, i).labels);
  }

  /// Marks stay where they are through a film, clear of what any frame shows; on the way of a tour
  /// there is nothing but what is said and whose work it is.
  void marksStay_data() {
    QTest::addColumn<int>("motion");
    QTest::newRow("turntable") << int(Motion::turntable);
    QTest::newRow("tour") << int(Motion::tour);
    QTest::newRow("sweep") << int(Motion::gammaSweep);
  }
  void marksStay() {
    QFETCH(int, motion);
    ExportOrder order = tourOrder(orderOf(demoScene(model::DemoName::kidney), Motion(motion), 4));
    order.sources = SourceCredits::line;
    order.words.text.text = "What the view says";
    std::vector<model::Node> nodes = order.scene.nodes();
    for (model::Node& node : nodes)
      node.provenance.credit = {.authors = "Who made it", .source = {}, .licence = "CC0"};
    order.scene.setNodes(std::move(nodes));
    // Nearer than marks leave room for.
    order.camera.eye = order.camera.target + 0.6f * (order.camera.eye - order.camera.target);
    const Film film = std::move(Film::create(order)).value();
    FilmLabels labels(order);
    QVERIFY(labels.settle(film, {}));
    std::map<std::string, glm::vec2> places;
    model::MeshTrees trees;
    for (int i = 0; i < film.frames(); ++i) {
      const FilmFrame frame = film.at(i);
      const FigurePlate plate = labels.plateOf(film, i);
      std::optional<SeenArea> drawn;
      if (i % 8 == 0)
        drawn = SeenMap(frame.scene, Screen(frame.camera, page), &trees).drawnArea();
      for (const LetteringItem& mark : plate.marks.lettering.items) {
        if (film.tours() && frame.moving)
          QVERIFY2(mark.name == "sources" || mark.name == "caption" || mark.name == groundName,
                   mark.name.c_str());
        if (!mark.text || (film.tours() && mark.name != "sources"))
          continue;
        const TextAnchor anchor = mark.text->anchor;
        const std::string edge = anchor == TextAnchor::start       ? "left"
                                 : anchor == TextAnchor::end       ? "right"
                                 : mark.text->at.y < 0.5f * page.y ? "top"
                                                                   : "bottom";
        const bool letter = mark.name.starts_with("side ");
        const auto known = places.emplace(letter ? edge : mark.name, mark.text->at).first;
        // The bar begins in one place, and its text is where it ends.
        glm::vec2 way = known->second - mark.text->at;
        if (mark.name == "scale")
          way.x = 0.0f;
        QVERIFY2(glm::length(way) < 0.01f, mark.name.c_str());
        if (!drawn)
          continue;
        const QRectF box = outlineOf(*mark.text).boundingRect();
        const LabelBox there{{float(box.left()), float(box.top())},
                             {float(box.right()), float(box.bottom())}};
        const bool below = plate.marks.cutOff && there.low.y >= plate.marks.cutOff->low.y;
        QVERIFY2(below || !drawn->anyIn(there), mark.name.c_str());
      }
    }
    QVERIFY(places.contains("sources"));
  }

  /// Leaders end on what they name, judged by the frames' pictures alone.
  void leadersEndOnWhatTheyName_data() {
    QTest::addColumn<int>("motion");
    QTest::addColumn<int>("demo");
    for (const auto& [name, demo] :
         {std::pair("kidney", model::DemoName::kidney), {"abdomen", model::DemoName::abdomen}}) {
      QTest::addRow("tour, %s", name) << int(Motion::tour) << int(demo);
      QTest::addRow("sweep, %s", name) << int(Motion::gammaSweep) << int(demo);
    }
    QTest::newRow("turntable, kidney") << int(Motion::turntable) << int(model::DemoName::kidney);
  }
  void leadersEndOnWhatTheyName() {
    QFETCH(int, motion);
    QFETCH(int, demo);
    const ExportOrder order = tourOrder(orderOf(demoScene(model::DemoName(demo)), Motion(motion)));
    const Film film = std::move(Film::create(order, glm::vec2(0.6f, 1.0f))).value();
    FilmLabels labels(order);
    QVERIFY(labels.settle(film, {}));
    auto picture = HeadlessPicture::create();
    QVERIFY(picture.ok());
    const DrawPicture draw = [&](const model::Scene& scene, const model::Camera& camera,
                                 const PictureSettings& settings) {
      return (*picture)->render(scene, camera, settings);
    };
    constexpr int frames = 5;
    std::size_t judged = 0;
    for (int k = 0; k < frames; ++k) {
      const int at = k * (film.frames() - 1) / (frames - 1);
      const FigurePlate plate = labels.plateOf(film, at);
      if (!plate.labels)
        continue;
      const FilmFrame frame = film.at(at);
      constexpr glm::ivec2 size{960, 540};
      std::vector<LeaderEnd> ends;
      for (const ShownLabel& label : plate.labels->labels)
        if (plate.labels->layout.find(label.item.id))
          ends.push_back({structureOf(frame.scene, label.item.id),
                          label.item.places.front() * float(size.x) / page.x, label.item.hidden});
      const auto verdicts = judgeLeaders(
          draw,
          {frame.scene, frame.camera, {.width = size.x, .height = size.y}, float(size.x) / 480.0f},
          ends);
      QVERIFY(verdicts.ok());
      for (std::size_t i = 0; i < ends.size(); ++i) {
        const LeaderVerdict& verdict = (*verdicts)[i];
        const auto nameOf = [&](model::NodeId id) {
          return QString::fromStdString(frame.scene.find(id)->name);
        };
        QVERIFY2(verdict.fault != LeaderFault::onAnother && verdict.fault != LeaderFault::besideIt,
                 qPrintable(QString("frame %1: %2 at %3, %4, %5 its own, %6 another's, one sees %7")
                                .arg(at)
                                .arg(nameOf(ends[i].structure))
                                .arg(ends[i].place.x)
                                .arg(ends[i].place.y)
                                .arg(verdict.own)
                                .arg(verdict.another)
                                .arg(verdict.seen ? nameOf(*verdict.seen) : QString())));
      }
      judged += ends.size();
    }
    QVERIFY2(judged > 5, qPrintable(QString::number(judged)));
  }

 private:
  static model::Scene demoScene(model::DemoName name) {
    return model::demo(name, model::Sex::female, QDir::tempPath().toStdString());
  }

  static void judge(const ExportOrder& order) {
    const Steadiness steady = steadinessOf(order);
    QVERIFY(steady.sides <= 1);
    QCOMPARE(steady.blinks, 0);
    QCOMPARE(steady.texts, 0);
    QVERIFY(steady.farthest <= 4.5f);
    QVERIFY(double(steady.hops) <= 0.25 * double(order.scene.annotations().size()));
    QVERIFY(steady.out <= 0.4);
  }

  std::unique_ptr<Typesetting> m_typesetting;
};

SLINE_TEST_WITH_GUI(FilmLabelsTest)
#include "film_labels_test.moc"
