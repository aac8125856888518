// SPDX-License-Identifier: Apache-2.0
// Tests the promises of a layout on random labels, with mathematics of the test's own.
#include <QtTest>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <random>

#include "render/labels/layout.h"
#include "render/labels/seen/seen_map.h"
#include "tests/render/labels/layout_promises.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using namespace sline::render;

namespace {

LabelRequest randomRequest(std::uint32_t seed, int most) {
  std::mt19937 random(seed);
  const auto between = [&](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
  };
  LabelRequest request;
  request.space.size = {between(60.0f, 340.0f), between(50.0f, 250.0f)};
  request.space.sideMargin = seed % 3 == 0 ? 40.0f : 0.0f;
  const int number = 1 + int(random() % std::uint32_t(most));
  const float inset = between(0.0f, 0.35f) * request.space.size.x;
  for (int i = 0; i < number; ++i) {
    LabelItem item{.id = {std::uint64_t(i + 1)}};
    item.kind = model::AnnotationKind(random() % 4);
    const auto place = [&] {
      return glm::vec2(between(inset, request.space.size.x - inset),
                       between(0.0f, request.space.size.y));
    };
    item.places.push_back(random() % 8 == 0 && i > 0 ? request.items.back().places.front()
                                                     : place());
    if (item.kind == model::AnnotationKind::distance)
      item.places.push_back(place());
    item.hidden = random() % 4 == 0;
    item.box = {between(5.0f, 45.0f), between(3.0f, 14.0f)};
    if (random() % 12 == 0)
      item.offset = glm::vec2(between(-80.0f, 80.0f), between(-60.0f, 60.0f));
    request.items.push_back(item);
  }
  return request;
}

/// Returns marks such as a window has: a cube in a corner, a bar in another, letters at the sides.
std::vector<LabelBox> marksOf(const glm::vec2& size) {
  const glm::vec2 middle = 0.5f * size;
  return {{{size.x - 24.0f, 2.0f}, {size.x - 2.0f, 24.0f}},
          {{2.0f, size.y - 9.0f}, {38.0f, size.y - 2.0f}},
          {{2.0f, middle.y - 3.0f}, {8.0f, middle.y + 3.0f}},
          {{size.x - 8.0f, middle.y - 3.0f}, {size.x - 2.0f, middle.y + 3.0f}},
          {{middle.x - 4.0f, 2.0f}, {middle.x + 4.0f, 7.0f}}};
}

/// Returns the cosine of the sharpest turn of the leader: 1 if it goes on straight, negative if it
/// turns back.
double sharpestTurn(const Leader& leader) {
  double sharpest = 1.0;
  for (std::size_t i = 2; i < leader.size(); ++i) {
    const glm::dvec2 a = glm::dvec2(leader[i - 1]) - glm::dvec2(leader[i - 2]);
    const glm::dvec2 b = glm::dvec2(leader[i]) - glm::dvec2(leader[i - 1]);
    const double lengths = std::sqrt((a.x * a.x + a.y * a.y) * (b.x * b.x + b.y * b.y));
    if (lengths > 1e-9)
      sharpest = std::min(sharpest, (a.x * b.x + a.y * b.y) / lengths);
  }
  return sharpest;
}

/// A disc of anatomy.
struct Disc {
  glm::vec2 middle{0.0f};
  float radius = 0.0f;

  bool touches(const LabelBox& box) const {
    return glm::distance(glm::clamp(middle, box.low, box.high), middle) < radius;
  }
  /// Returns what a picture of that size shows.
  SeenArea area(const glm::vec2& size) const {
    SeenArea area;
    area.grid.side = size.y / 360.0f;
    area.grid.rows = 360;
    area.grid.columns = int(std::ceil(size.x / area.grid.side));
    for (int y = 0; y < area.grid.rows; ++y)
      for (int x = 0; x < area.grid.columns; ++x)
        area.cells.push_back(glm::distance(area.grid.middle(x, y), middle) < radius);
    return area;
  }
};

}  // namespace

class LabelLayoutTest : public QObject {
  Q_OBJECT
 private slots:
  void promisesHold() {
    int placed = 0;
    int all = 0;
    for (std::uint32_t seed = 0; seed < 600; ++seed) {
      const LabelRequest request = randomRequest(seed, 60);
      const LabelLayout layout = layOutLabels(request);
      const QString fault = broken(request, layout);
      QVERIFY2(fault.isEmpty(), qPrintable(QString("seed %1: %2").arg(seed).arg(fault)));
      QCOMPARE(layOutLabels(request), layout);
      placed += int(layout.labels.size());
      all += int(request.items.size());
    }
    qInfo("%d of %d random labels found room", placed, all);
  }

  void promisesHoldWhileTurning() {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
      LabelRequest request = randomRequest(seed, 30);
      LabelLayout layout;
      for (int step = 0; step < 40; ++step) {
        request.moving = step % 2 == 1;
        layout = layOutLabels(request, &layout);
        const QString fault = broken(request, layout);
        QVERIFY2(fault.isEmpty(), qPrintable(QString("seed %1: %2").arg(seed).arg(fault)));
        for (LabelItem& item : request.items)
          for (glm::vec2& place : item.places)
            place.x += (0.5f * request.space.size.x - place.x) * 0.05f +
                       (place.y > 0.5f * request.space.size.y ? 1.5f : -1.5f);
      }
    }
  }

  void allFindRoomWhereThereIs() {
    const LabelRequest request = roomy();
    const LabelLayout layout = layOutLabels(request);
    QCOMPARE(layout.leftOut.size(), std::size_t(0));
    for (const PlacedLabel& label : layout.labels)
      QVERIFY2(!overlap(label.box, *request.obstacles.extent), "a label covers the anatomy");
  }

  void saysWhatFindsNone() {
    LabelRequest request = roomy();
    request.space.size = {340.0f, 20.0f};
    request.items[7].hidden = false;
    request.items[0].hidden = true;
    for (LabelItem& item : request.items)
      item.places.front().y = 10.0f;
    const LabelLayout layout = layOutLabels(request);
    QVERIFY(!layout.leftOut.empty());
    QVERIFY2(!layout.find({1}), "a hidden place's label takes the room of one that is seen");
    QVERIFY2(broken(request, layout).isEmpty(), qPrintable(broken(request, layout)));
  }

  void largeThingsKeepTheirNames() {
    LabelRequest request = roomy();
    request.space.size = {340.0f, 20.0f};
    for (LabelItem& item : request.items) {
      item.kind = model::AnnotationKind::label;
      item.hidden = false;
      item.places.front().y = 10.0f;
      item.seen = 3.0f;
    }
    const LabelLayout alike = layOutLabels(request);
    QVERIFY(!alike.leftOut.empty());
    const model::AnnotationId left = alike.leftOut.back();
    const auto named = [&request](model::AnnotationId id) {
      return std::find_if(request.items.begin(), request.items.end(),
                          [id](const LabelItem& item) { return item.id == id; });
    };
    named(left)->seen = 300.0f;
    QVERIFY2(layOutLabels(request).find(left), "what one sees most of has no name");
    // What stands stays, or names would come and go while the camera turns.
    QVERIFY(!layOutLabels(request, &alike).find(left));
    request.still = true;
    request.widths = {60.0f, 60.0f};
    named(left)->seen = 3.0f;
    const LabelLayout film = layOutLabels(request);
    named(left)->seen = 300.0f;
    QVERIFY(layOutLabels(request) == film);
  }

  void nothingMovesWithoutNeed() {
    const LabelRequest request = roomy();
    const LabelLayout first = layOutLabels(request);
    const LabelLayout second = layOutLabels(request, &first);
    for (const PlacedLabel& label : second.labels) {
      QCOMPARE(label.box, first.find(label.id)->box);
    }
  }

  void scalesWithTheOutput() {
    // The same anatomy on paper of twice the size has room for twice the lines of text.
    LabelRequest small = randomRequest(7, 60);
    LabelRequest large = small;
    large.space.size *= 2.0f;
    for (LabelItem& item : large.items)
      for (glm::vec2& place : item.places)
        place *= 2.0f;
    QVERIFY(layOutLabels(large).leftOut.size() <= layOutLabels(small).leftOut.size());
  }

  void movedByHandStaysThere() {
    LabelRequest request = roomy();
    request.items[3].offset = glm::vec2(-20.0f, 5.0f);
    const LabelLayout layout = layOutLabels(request);
    QCOMPARE(layout.find({4})->box.middle(), request.items[3].places.front() + glm::vec2(-20, 5));
    QCOMPARE(layout.find({4})->post, LabelPost::byHand);
  }

  void nothingIsWhereMarksAre() {
    int placed = 0;
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
      LabelRequest request = randomRequest(seed, 40);
      request.space.reserved = marksOf(request.space.size);
      const LabelLayout first = layOutLabels(request);
      for (const LabelLayout& layout : {first, layOutLabels(request, &first)}) {
        const QString fault = broken(request, layout) + inReserved(request, layout);
        QVERIFY2(fault.isEmpty(), qPrintable(QString("seed %1: %2").arg(seed).arg(fault)));
      }
      placed += int(first.labels.size());
    }
    QVERIFY2(placed > 2000, qPrintable(QString("only %1 labels found room").arg(placed)));
  }

  /// A disc that reaches into both columns, and over the picture's edges in some: no label of a
  /// column lies over it, all other promises hold, and above and below it labels have room.
  void nothingIsWhereAnatomyIs() {
    int placed = 0;
    int over = 0;
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
      LabelRequest request = randomRequest(seed, 40);
      request.space.sideMargin = 0.0f;  // there is no picture
      for (LabelItem& item : request.items)
        item.offset.reset();
      const glm::vec2 size = request.space.size;
      const Disc disc{0.5f * size, (0.3f + 0.01f * float(seed % 30)) * size.x};
      request.obstacles.extent = LabelBox{disc.middle - disc.radius, disc.middle + disc.radius};
      const LabelLayout free = layOutLabels(request);
      const SeenArea drawn = disc.area(size);
      request.drawn = &drawn;
      const LabelLayout first = layOutLabels(request);
      for (const LabelLayout& layout : {first, layOutLabels(request, &first)}) {
        const QString fault = broken(request, layout);
        QVERIFY2(fault.isEmpty(), qPrintable(QString("seed %1: %2").arg(seed).arg(fault)));
        for (const PlacedLabel& label : layout.labels)
          QVERIFY2(label.post == LabelPost::beside || !disc.touches(label.box),
                   qPrintable(QString("seed %1: %2 lies over it").arg(seed).arg(label.id.value)));
      }
      for (const PlacedLabel& label : free.labels)
        over += label.post != LabelPost::beside && disc.touches(label.box) ? 1 : 0;
      placed += int(first.labels.size());
    }
    QVERIFY2(over > 300, qPrintable(QString("only %1 would lie over it").arg(over)));
    QVERIFY2(placed > 2000, qPrintable(QString("only %1 labels found room").arg(placed)));
  }

  void leadersDoNotTurnBack() {
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
      const LabelRequest request = randomRequest(seed, 40);
      for (const PlacedLabel& label : layOutLabels(request).labels)
        QVERIFY2(sharpestTurn(label.leader) > -1e-3,
                 qPrintable(QString("seed %1: %2 turns back").arg(seed).arg(label.id.value)));
    }
  }

  /// Dragged around its place, a text is never crossed out by its own leader.
  void leadersToTheHandEndOutside() {
    for (float x = -40.0f; x <= 40.0f; x += 0.7f)
      for (float y = -20.0f; y <= 20.0f; y += 0.7f) {
        LabelRequest request = roomy();
        request.items.resize(1);
        request.items[0].offset = glm::vec2(x, y);
        const LabelLayout layout = layOutLabels(request);
        QVERIFY2(broken(request, layout).isEmpty(), qPrintable(QString("%1, %2").arg(x).arg(y)));
      }
  }

  void pinsStandBeside() {
    LabelRequest request = roomy();
    request.items[2].kind = model::AnnotationKind::pin;
    const PlacedLabel pin = *layOutLabels(request).find({3});
    QCOMPARE(pin.post, LabelPost::beside);
    QVERIFY(pin.leader.empty());
    QVERIFY(glm::length(pin.box.middle() - request.items[2].places.front()) < 25.0f);
  }
};

SLINE_TEST(LabelLayoutTest)
#include "label_layout_test.moc"
