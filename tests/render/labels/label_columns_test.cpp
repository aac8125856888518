// SPDX-License-Identifier: Apache-2.0
// Tests the columns of labels, what they go around, and what stands in none.
#include <QtTest>
#include <algorithm>
#include <glm/geometric.hpp>
#include <random>

#include "render/labels/label_room.h"
#include "render/labels/layout.h"
#include "tests/render/labels/layout_promises.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using namespace sline::render;

namespace {

LabelRequest twelve() {
  LabelRequest request = roomy();
  for (int i = 0; i < 4; ++i)
    request.items.push_back({.id = {std::uint64_t(i + 9)},
                             .places = {{136.0f + 23.0f * float(i), 150.0f - 31.0f * float(i)}},
                             .box = {24.0f, 4.5f}});
  return request;
}

/// Counts the labels that a dragged one makes move.
struct Moves {
  int drags = 0;
  int moves = 0;
  int most = 0;           ///< at once
  float farthest = 0.0f;  ///< in heights of the box
  int covered = 0;        ///< those over whose dot the label is

  void add(const LabelLayout& first, const LabelLayout& now, model::AnnotationId dragged) {
    constexpr float near = 3.0f;
    constexpr float gone = 1000.0f;
    int others = 0;
    for (const PlacedLabel& was : first.labels) {
      const PlacedLabel* is = now.find(was.id);
      if (was.id == dragged || (is && is->box == was.box))
        continue;
      if (now.find(dragged)->box.grown(near).contains(was.leader.front())) {
        ++covered;
        continue;
      }
      ++others;
      const float way = is ? glm::distance(is->box.middle(), was.box.middle()) : gone;
      farthest = std::max(farthest, way / was.box.size().y);
    }
    most = std::max(most, others);
    moves += others;
    ++drags;
  }
};

}  // namespace

class LabelColumnsTest : public QObject {
  Q_OBJECT
 private slots:
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

  /// What lies on a side is labelled there, however few the others are, as long as there is room.
  void sidesAreThoseOfPlaces() {
    std::mt19937 random(5);
    for (int run = 0; run < 40; ++run) {
      LabelRequest request = roomy();
      const LabelBox anatomy = *request.obstacles.extent;
      for (LabelItem& item : request.items)
        item.places.front() = {
            anatomy.low.x + anatomy.size().x *
                                float(item.id.value == 1 ? random() % 48 : 53 + random() % 47) /
                                100.0f,
            10.0f + 22.0f * float(item.id.value - 1) + float(random() % 10)};
      const LabelLayout layout = layOutLabels(request);
      QCOMPARE(layout.labels.size(), request.items.size());
      for (const PlacedLabel& label : layout.labels)
        QCOMPARE(label.post, label.id.value == 1 ? LabelPost::left : LabelPost::right);
    }
  }

  /// Where both columns have too many, as many as have room without leaders through dots stand
  /// beside the anatomy on the side of their places, and the widest, which find no room, widen no
  /// column.
  void tooManyStandOnTheirSides() {
    std::mt19937 random(11);
    for (int run = 0; run < 20; ++run) {
      LabelRequest request = roomy();
      const LabelBox anatomy = *request.obstacles.extent;
      request.items.clear();
      for (std::uint64_t i = 0; i < 90; ++i) {
        const float x = (i % 2 == 0 ? 0.02f : 0.55f) + 0.43f * float(random() % 1000) / 1000.0f;
        const float y = float(random() % 1000) / 1000.0f;
        request.items.push_back({.id = {i + 1},
                                 .places = {anatomy.low + anatomy.size() * glm::vec2(x, y)},
                                 .box = {i >= 88 ? 130.0f : 30.0f, 5.0f}});
        request.items.back().hidden = i >= 80;
      }
      const LabelLayout layout = layOutLabels(request);
      const float height = frameOf(request.space).size().y;
      QVERIFY2(float(layout.labels.size()) >= 0.9f * 2.0f * height / (5.0f + columnGap),
               qPrintable(QString::number(layout.labels.size())));
      for (const PlacedLabel& label : layout.labels) {
        QCOMPARE(label.post, label.id.value % 2 == 1 ? LabelPost::left : LabelPost::right);
        QVERIFY(label.box.high.x <= anatomy.low.x || label.box.low.x >= anatomy.high.x);
      }
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

  /// Each of twelve labels is dragged across the picture in eight directions. Wherever it is, at
  /// most two others are anywhere but where they stood, none by more than its own height, and all
  /// go back. Only if it is dragged over another's dot, that one may go.
  void othersHoldStillWhileOneIsDragged() {
    const LabelRequest request = twelve();
    const LabelLayout first = layOutLabels(request);
    QCOMPARE(first.labels.size(), std::size_t(12));
    Moves all;
    for (const LabelItem& dragged : request.items)
      for (const glm::vec2 way : {glm::vec2(0.0f, 9.0f),
                                  {0.0f, -9.0f},
                                  {11.0f, 0.0f},
                                  {-11.0f, 0.0f},
                                  {10.0f, 6.0f},
                                  {-10.0f, -6.0f},
                                  {10.0f, -6.0f},
                                  {-10.0f, 6.0f}}) {
        LabelRequest moved = request;
        LabelLayout layout = first;
        LabelItem& item = moved.items[std::size_t(dragged.id.value - 1)];
        for (int step = 1; step <= 20; ++step) {
          const glm::vec2 to = first.find(dragged.id)->box.middle() + float(step) * way;
          item.offset = to - dragged.places.front();
          layout = layOutLabels(moved, &layout);
          QVERIFY2(broken(moved, layout).isEmpty(), qPrintable(broken(moved, layout)));
          all.add(first, layout, dragged.id);
          // Who opens the scene sees the same.
          const LabelLayout opened = layOutLabels(moved);
          for (const PlacedLabel& label : opened.labels)
            QCOMPARE(layout.find(label.id)->box, label.box);
        }
        item.offset.reset();
        layout = layOutLabels(moved, &layout);
        for (const PlacedLabel& label : first.labels)
          QCOMPARE(layout.find(label.id)->box, label.box);
      }
    qInfo(
        "in %d places of a dragged label %d others move, at most %d at once, by %.2f heights; it "
        "is over the dot of %d",
        all.drags, all.moves, all.most, double(all.farthest), all.covered);
    QVERIFY(all.most <= 2);
    QVERIFY(all.farthest <= 1.0f);
    QVERIFY(all.moves > 50 && all.covered < 100);
  }

  /// In a picture of another size what is moved by hand stays where it was put, and no other
  /// changes sides or passes another.
  void anotherSizeChangesNoOrder() {
    LabelRequest request = twelve();
    request.items[4].offset = glm::vec2(26.0f, -31.0f);
    const LabelLayout first = layOutLabels(request);
    for (const glm::vec2 size : {glm::vec2(300.0f, 190.0f), {440.0f, 190.0f}, {340.0f, 160.0f}}) {
      LabelRequest other = request;
      const float scale = size.y / request.space.size.y;
      const auto moved = [&](const glm::vec2& p) {
        return 0.5f * size + scale * (p - 0.5f * request.space.size);
      };
      other.space.size = size;
      other.obstacles.extent = {moved(request.obstacles.extent->low),
                                moved(request.obstacles.extent->high)};
      for (LabelItem& item : other.items)
        item.places.front() = moved(item.places.front());
      *other.items[4].offset *= scale;
      const LabelLayout before = resized(first, request.space.size, size);
      const LabelLayout layout = layOutLabels(other, &before);
      QCOMPARE(broken(other, layout), QString());
      QCOMPARE(layout.labels.size(), first.labels.size());
      QVERIFY(glm::distance(layout.find({5})->box.middle(), moved(first.find({5})->box.middle())) <
              0.01f);
      for (const PlacedLabel& one : layout.labels) {
        QCOMPARE(one.post, first.find(one.id)->post);
        for (const PlacedLabel& two : layout.labels)
          if (one.post == two.post && one.post != LabelPost::byHand)
            QCOMPARE(one.box.low.y < two.box.low.y,
                     first.find(one.id)->box.low.y < first.find(two.id)->box.low.y);
      }
    }
  }

  /// A box moved by hand stays with the annotation's own place when its leader ends elsewhere.
  void aFoundPlaceMovesNoBox() {
    LabelRequest request = roomy();
    request.items[3].offset = glm::vec2(-20.0f, 5.0f);
    const LabelLayout first = layOutLabels(request);
    request.items[3].base = request.items[3].places.front();
    request.items[3].places.front() += glm::vec2(9.0f, 4.0f);
    const LabelLayout layout = layOutLabels(request, &first);
    QCOMPARE(layout.find({4})->box, first.find({4})->box);
    QCOMPARE(layout.find({4})->leader.front(), request.items[3].places.front());
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
};

SLINE_TEST(LabelColumnsTest)
#include "label_columns_test.moc"
