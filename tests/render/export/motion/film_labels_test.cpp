// SPDX-License-Identifier: Apache-2.0
// Measures labels over films of 8 seconds as one sees them: which change sides, which are there or
// gone for less than a second, and how often one hops.
#include "render/export/motion/film_labels.h"

#include <QDir>
#include <QElapsedTimer>
#include <QtTest>
#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

#include "model/demo/demo.h"
#include "model/import/plan/import.h"
#include "render/labels/seen_map.h"
#include "render/lettering/typesetting.h"
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
  QElapsedTimer timer;
  timer.start();
  labels.settle(film, {});
  const double settled = double(timer.elapsed());
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
      "%.1f mm at most; %d places go; %.1f %% out, %.1f %% of the seen; settled in %.0f ms",
      sights.size(), all.sides, all.changes, all.blinks, all.hops, all.texts, double(all.farthest),
      all.places, 100.0 * all.out, 100.0 * all.missing, settled);
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
    QTest::newRow("male pelvis") << "pelvis/hra_vh_male";
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

  void touring() {
    ExportOrder order = orderOf(demoScene(model::DemoName::abdomen), Motion::tour);
    const model::Box bounds = order.scene.visibleBounds();
    std::vector<model::View> views;
    for (const auto from : {model::AnatomicalView::anterior, model::AnatomicalView::left,
                            model::AnatomicalView::posterior}) {
      model::View view{.name = "view", .camera = {}};
      view.camera = model::anatomicalCamera(from, bounds, 0.5f * page.x / page.y);
      views.push_back(view);
    }
    order.scene.setViews(views);
    judge(order);
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
