// SPDX-License-Identifier: Apache-2.0
// Tests the promises of a layout on random labels, with mathematics of the test's own.
#include <QtTest>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <random>

#include "render/labels/layout.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::render;

namespace {

struct Line {
  glm::dvec2 a;
  glm::dvec2 b;
};

std::vector<Line> linesOf(const Leader& leader) {
  std::vector<Line> lines;
  for (std::size_t i = 1; i < leader.size(); ++i)
    lines.push_back({leader[i - 1], leader[i]});
  return lines;
}

/// Tells whether the lines meet by solving a + s (b − a) = c + t (d − c); parallel lines count as
/// not meeting.
bool meet(const Line& one, const Line& two) {
  const glm::dvec2 r = one.b - one.a;
  const glm::dvec2 q = two.b - two.a;
  const glm::dvec2 w = two.a - one.a;
  const double determinant = r.x * q.y - r.y * q.x;
  if (std::abs(determinant) < 1e-12)
    return false;
  const double s = (w.x * q.y - w.y * q.x) / determinant;
  const double t = (w.x * r.y - w.y * r.x) / determinant;
  constexpr double rim = 1e-6;
  return s > rim && s < 1.0 - rim && t > rim && t < 1.0 - rim;
}

bool meets(const Line& line, const LabelBox& box) {
  for (int i = 0; i <= 400; ++i) {
    const glm::vec2 p(line.a + double(i) / 400.0 * (line.b - line.a));
    if (box.contains(p))
      return true;
  }
  return false;
}

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

/// Returns a label or leader that lies where it must not; empty if there is none.
QString inReserved(const LabelRequest& request, const LabelLayout& layout) {
  for (const PlacedLabel& label : layout.labels)
    for (const LabelBox& mark : request.space.reserved) {
      if (overlap(label.box, mark))
        return QString("%1 covers a mark").arg(label.id.value);
      for (const Line& line : linesOf(label.leader))
        if (label.post != LabelPost::byHand && meets(line, mark))
          return QString("the leader of %1 runs through a mark").arg(label.id.value);
    }
  return {};
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

/// Returns what is wrong between a label and its own place: its leader runs through its text, or
/// the text covers the dot or the measured line.
QString broken(const LabelItem& item, const PlacedLabel& label) {
  constexpr float rounding = 0.01f;  // leaders end at the box's side
  for (const Line& line : linesOf(label.leader))
    if (meets(line, label.box.grown(-rounding)))
      return QString("%1 runs through itself").arg(label.id.value);
  if (label.post == LabelPost::byHand)
    return {};
  constexpr float dot = 0.8f;  // the largest dot, that of a pin
  for (const glm::vec2& place : item.places)
    if (glm::length(place - glm::clamp(place, label.box.low, label.box.high)) < dot)
      return QString("%1 covers its dot").arg(label.id.value);
  for (const Line& line : linesOf(item.places))
    if (meets(line, label.box))
      return QString("%1 covers what it measures").arg(label.id.value);
  return {};
}

/// Returns a promise that does not hold; empty if all do.
QString broken(const LabelRequest& request, const LabelLayout& layout) {
  if (layout.labels.size() + layout.leftOut.size() != request.items.size())
    return "labels are lost";
  for (const LabelItem& item : request.items)
    if (const PlacedLabel* label = layout.find(item.id))
      if (const QString fault = broken(item, *label); !fault.isEmpty())
        return fault;
  const LabelSpace& space = request.space;
  for (const PlacedLabel& one : layout.labels) {
    if (one.box.low.x < -space.sideMargin || one.box.low.y < 0.0f ||
        one.box.high.x > space.size.x + space.sideMargin || one.box.high.y > space.size.y)
      return QString("%1 is outside").arg(one.id.value);
    for (const PlacedLabel& two : layout.labels) {
      if (one.id == two.id)
        continue;
      if (overlap(one.box, two.box))
        return QString("%1 and %2 overlap").arg(one.id.value).arg(two.id.value);
      for (const Line& line : linesOf(one.leader)) {
        if (meets(line, two.box))
          return QString("%1 runs through %2").arg(one.id.value).arg(two.id.value);
        for (const Line& other : linesOf(two.leader))
          if (meet(line, other))
            return QString("%1 and %2 cross").arg(one.id.value).arg(two.id.value);
      }
    }
  }
  return {};
}

/// Returns eight structures' places in the middle of a wide picture.
LabelRequest roomy() {
  LabelRequest request;
  request.space.size = {340.0f, 190.0f};
  for (int i = 0; i < 8; ++i)
    request.items.push_back({.id = {std::uint64_t(i + 1)},
                             .places = {{130.0f + 11.0f * float(i), 40.0f + 13.0f * float(i)}},
                             .box = {30.0f, 4.5f}});
  request.obstacles = {.columns = 1,
                       .rows = 1,
                       .size = request.space.size,
                       .taken = {0},
                       .extent = LabelBox{{110.0f, 10.0f}, {230.0f, 180.0f}}};
  return request;
}

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

  /// Beside a mark in the middle of a column's edge there is room above and below it.
  void columnsGoAroundMarks() {
    LabelRequest request = roomy();
    for (LabelItem& item : request.items)
      item.places.front() = {112.0f, 90.0f + 0.5f * float(item.id.value)};
    request.items.push_back({.id = {9}, .places = {{228.0f, 95.0f}}, .box = {30.0f, 4.5f}});
    request.space.reserved = {{{2.0f, 85.0f}, {108.0f, 105.0f}}};
    const LabelLayout layout = layOutLabels(request);
    QCOMPARE(layout.leftOut.size(), std::size_t(0));
    QCOMPARE(inReserved(request, layout), QString());
    const auto above = std::count_if(layout.labels.begin(), layout.labels.end(), [](const auto& l) {
      return l.post == LabelPost::left && l.box.high.y <= 85.0f;
    });
    const auto below = std::count_if(layout.labels.begin(), layout.labels.end(), [](const auto& l) {
      return l.post == LabelPost::left && l.box.low.y >= 105.0f;
    });
    QVERIFY2(above >= 2 && below >= 2,
             qPrintable(QString("%1 above, %2 below").arg(above).arg(below)));
  }

  void leadersDoNotTurnBack() {
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
      const LabelRequest request = randomRequest(seed, 40);
      for (const PlacedLabel& label : layOutLabels(request).labels)
        QVERIFY2(sharpestTurn(label.leader) > -1e-3,
                 qPrintable(QString("seed %1: %2 turns back").arg(seed).arg(label.id.value)));
    }
  }

  /// Places lie one below the other, and their labels stand in that order.
  void orderAlongColumnsIsThatOfPlaces() {
    LabelRequest request = roomy();
    std::mt19937 random(3);
    std::vector<float> heights;
    for (LabelItem& item : request.items) {
      item.places.front() = {item.id.value % 2 == 0 ? 125.0f : 215.0f,
                             float(random() % 1700) / 10.0f + 10.0f};
      item.box.y = item.id.value % 3 == 0 ? 13.0f : 4.5f;
    }
    const LabelLayout layout = layOutLabels(request);
    QCOMPARE(layout.labels.size(), request.items.size());
    for (const PlacedLabel& one : layout.labels)
      for (const PlacedLabel& two : layout.labels)
        if (one.post == two.post && one.leader.front().y < two.leader.front().y)
          QVERIFY(one.box.middle().y < two.box.middle().y);
  }

  /// A long label takes none of the other column's room.
  void columnsAreAsWideAsWhatStandsInThem() {
    LabelRequest request = roomy();
    request.space.size.x = 210.0f;
    for (LabelItem& item : request.items)
      item.places.front().x -= 70.0f;
    request.obstacles.size = request.space.size;
    request.obstacles.extent = LabelBox{{37.0f, 10.0f}, {158.0f, 180.0f}};
    request.items.back().box.x = 45.0f;  // belongs to the rightmost place
    const LabelLayout layout = layOutLabels(request);
    QCOMPARE(layout.leftOut.size(), std::size_t(0));
    QCOMPARE(layout.find({8})->post, LabelPost::right);
    for (const PlacedLabel& label : layout.labels)
      QVERIFY2(!overlap(label.box, *request.obstacles.extent), "a label covers the anatomy");
  }

  /// A label that has no room in a column widens none, and the labels beside it stay where they
  /// were.
  void tooWideForColumnsIsLeftOut() {
    const LabelRequest request = roomy();
    const LabelLayout first = layOutLabels(request);
    for (const glm::vec2 box : {glm::vec2(200.0f, 4.5f), glm::vec2(30.0f, 400.0f)})
      for (const LabelLayout* before : {static_cast<const LabelLayout*>(nullptr), &first}) {
        LabelRequest with = request;
        with.items.insert(with.items.begin() + 3,
                          {.id = {9}, .places = {{180.0f, 100.0f}}, .box = box});
        const LabelLayout layout = layOutLabels(with, before);
        QCOMPARE(layout.leftOut, std::vector{model::AnnotationId{9}});
        QCOMPARE(layout.edges, first.edges);
        for (const PlacedLabel& label : layout.labels)
          QCOMPARE(label.post, first.find(label.id)->post);
      }
  }

  /// If letters are so large that no label is as narrow as a column may be, one is shown.
  void oneThatIsTooWideStandsAlone() {
    LabelRequest request = roomy();
    for (LabelItem& item : request.items)
      item.box = {200.0f, 40.0f};
    const LabelLayout layout = layOutLabels(request);
    QCOMPARE(layout.labels.size(), std::size_t(1));
    QCOMPARE(layout.labels.front().id, model::AnnotationId{1});
    QCOMPARE(broken(request, layout), QString());
    QVERIFY(layOutLabels(request, &layout).find({1}));
  }

  /// When a label is put into a column, those there make room in their column, and none is lost.
  void othersGiveWayToTheHand() {
    const LabelRequest before = roomy();
    const LabelLayout first = layOutLabels(before);
    int changedSides = 0;
    for (std::size_t moved = 0; moved < before.items.size(); ++moved)
      for (std::size_t onto = 0; onto < before.items.size(); ++onto) {
        if (moved == onto)
          continue;
        LabelRequest request = before;
        const glm::vec2 there = first.find(request.items[onto].id)->box.middle();
        request.items[moved].offset = there - request.items[moved].places.front();
        const LabelLayout layout = layOutLabels(request, &first);
        QCOMPARE(layout.leftOut.size(), std::size_t(0));
        QCOMPARE(layout.find(request.items[moved].id)->box.middle(), there);
        QVERIFY2(broken(request, layout).isEmpty(), qPrintable(broken(request, layout)));
        for (const PlacedLabel& label : layout.labels)
          changedSides +=
              label.id != request.items[moved].id && label.post != first.find(label.id)->post;
      }
    // Of 392 labels, these have leaders that would cross that of the one that was moved. They were
    // 120 when labels did not make room in their column.
    QVERIFY2(changedSides < 95, qPrintable(QString("%1 change sides").arg(changedSides)));
  }

  /// The camera is so near that there is anatomy behind the columns: a label that points there
  /// stands above or below its place, not on it.
  void placesBehindColumns() {
    LabelRequest request = roomy();
    request.space.size = {180.0f, 160.0f};
    request.obstacles.size = request.space.size;
    request.obstacles.extent = LabelBox{{3.0f, 3.0f}, {177.0f, 157.0f}};
    for (std::size_t i = 0; i < request.items.size(); ++i)
      request.items[i].places.front() = {i % 2 == 0 ? 10.0f : 168.0f, 25.0f + 14.0f * float(i)};
    const LabelLayout layout = layOutLabels(request);
    QCOMPARE(layout.leftOut.size(), std::size_t(0));
    QCOMPARE(broken(request, layout), QString());
    for (std::size_t i = 0; i < request.items.size(); ++i) {
      const PlacedLabel label = *layout.find(request.items[i].id);
      const glm::vec2 place = request.items[i].places.front();
      QCOMPARE(label.post, i % 2 == 0 ? LabelPost::left : LabelPost::right);
      QVERIFY(std::abs(label.box.middle().y - place.y) < 8.0f);
      QCOMPARE(label.leader.front(), place);
      QVERIFY2(!label.box.grown(0.01f).contains(place) &&
                   label.box.grown(0.01f).contains(label.leader.back()),
               "a leader does not end at its text");
    }
  }

  /// Text stands beside the line that it measures, in whichever direction that goes.
  void measuresAreNotCovered() {
    for (int turn = 0; turn < 12; ++turn) {
      LabelRequest request = roomy();
      request.items.resize(1);
      const float angle = float(turn) * 0.2618f;
      const glm::vec2 way = 40.0f * glm::vec2(std::cos(angle), std::sin(angle));
      const glm::vec2 middle(170.0f, 95.0f);
      request.items[0].kind = model::AnnotationKind::distance;
      request.items[0].places = {middle - way, middle + way};
      const LabelLayout layout = layOutLabels(request);
      QCOMPARE(layout.labels.size(), std::size_t(1));
      QCOMPARE(layout.labels[0].post, LabelPost::beside);
      QCOMPARE(broken(request, layout), QString());
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
