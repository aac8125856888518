// SPDX-License-Identifier: Apache-2.0
// Tests what a view says among the marks of a picture.
#include <QtTest>
#include <algorithm>

#include "render/export/plate/marks.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

using namespace render;

namespace {

ExportOrder frontOrder() {
  ExportOrder order;
  order.scene.append({.name = "Sphere", .mesh = sphere(50.0f, 3)});
  order.viewName = "Front";
  order.camera = model::anatomicalCamera(model::AnatomicalView::anterior,
                                         order.scene.visibleBounds(), 160.0f / 90.0f);
  return order;
}

const LetteringItem* itemOf(const Marks& marks, const char* name) {
  for (const LetteringItem& item : marks.lettering.items)
    if (item.name == name)
      return &item;
  return nullptr;
}

QString wordsOf(const Marks& marks, const char* name) {
  const LetteringItem* item = itemOf(marks, name);
  return item && item->text ? plainText(item->text->lines, QChar('\n')) : QString();
}

QRectF extentOf(const LetteringItem& item) {
  QRectF box = item.text ? outlineOf(*item.text).boundingRect() : QRectF();
  for (const LetteringShape& shape : item.shapes)
    box |= painterPath(shape.path).boundingRect();
  return box;
}

}  // namespace

class CaptionMarkTest : public QObject {
  Q_OBJECT

 private slots:
  void whatTheViewSays();
};

/// What the view says stands at the foot above other marks, in the picture's language, and its
/// title takes the place of the view's name.
void CaptionMarkTest::whatTheViewSays() {
  ExportOrder order = frontOrder();
  QVERIFY(!itemOf(marksOf(order), "caption"));
  QCOMPARE(wordsOf(marksOf(order), "view"), QString("Front"));
  order.words = {.title = {"The <b>ball</b>", {{"de", "Der Ball"}}},
                 .text = {"Seen *from the front*", {{"de", "Von **vorn**"}}},
                 .notes = {"secret", {}}};
  Marks marks = marksOf(order);
  QCOMPARE(wordsOf(marks, "caption"), QString("The <b>ball</b>\nSeen from the front"));
  QVERIFY(!itemOf(marks, "view"));
  const QRectF box = extentOf(*itemOf(marks, "caption"));
  QVERIFY(qAbs(box.center().x() - 80.0) < 0.5);
  QVERIFY(box.bottom() < extentOf(*itemOf(marks, "scale")).top());
  QVERIFY(qAbs(double(marks.edges.bottom) - (90.0 - box.top())) < 2.0);
  order.labels.language = "de+la";
  QCOMPARE(wordsOf(marksOf(order), "caption"), QString("Der Ball\nVon vorn"));
  order.marks.words = false;
  marks = marksOf(order);
  QVERIFY(!itemOf(marks, "caption"));
  QCOMPARE(wordsOf(marks, "view"), QString("Der Ball"));
  // A legend keeps its corner.
  order.marks.words = true;
  order.legend = LegendList::all;
  marks = marksOf(order);
  QVERIFY(marks.legend && extentOf(*itemOf(marks, "caption")).right() < qreal(marks.legend->low.x));
  // What finds no room is told.
  order.words.text = {QString("many words ").repeated(500).toStdString(), {}};
  order.labels.language.clear();
  marks = marksOf(order);
  QVERIFY(std::any_of(marks.notes.begin(), marks.notes.end(), [](const ExportNote& note) {
    return note.kind == ExportNote::Kind::textShortened;
  }));
  QVERIFY(extentOf(*itemOf(marks, "caption")).height() < 0.42 * 90.0);
}

}  // namespace sline::test

SLINE_TEST_WITH_GUI(sline::test::CaptionMarkTest)
#include "caption_mark_test.moc"
