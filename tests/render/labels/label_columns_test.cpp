// SPDX-License-Identifier: Apache-2.0
// Tests the columns of labels, what they go around, and what stands in none.
#include <QtTest>
#include <random>

#include "render/labels/layout.h"
#include "tests/render/labels/layout_promises.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using namespace sline::render;

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
};

SLINE_TEST(LabelColumnsTest)
#include "label_columns_test.moc"
