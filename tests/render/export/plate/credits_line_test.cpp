// SPDX-License-Identifier: Apache-2.0
// Tests what pictures say of whose work their surfaces are.
#include <QTest>
#include <algorithm>
#include <memory>

#include "render/export/plate/figure_plate.h"
#include "render/export/plate/plate_image.h"
#include "render/lettering/typesetting.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

using namespace render;

class CreditsLineTest : public QObject {
  Q_OBJECT

  static ExportOrder creditedOrder(const QString& authors) {
    ExportOrder order;
    model::Node node;
    node.name = "Sphere";
    node.mesh = sphere(50.0f, 3);
    node.provenance.frame = "LPS";
    node.provenance.credit.authors = authors.toStdString();
    order.scene.append(std::move(node));
    order.camera = model::anatomicalCamera(model::AnatomicalView::anterior,
                                           order.scene.visibleBounds(), 100.0f / 80.0f);
    order.page.sizeMm = {100.0f, 80.0f};
    order.sources = SourceCredits::line;
    return order;
  }

  std::unique_ptr<Typesetting> m_typesetting;

 private slots:
  void initTestCase() {
    auto made = Typesetting::create();
    QVERIFY(made.ok());
    m_typesetting = std::move(*made);
  }
  void cleanupTestCase() { m_typesetting.reset(); }

  /// They take as many lines as they need, at the page's foot and below all other marks, in smaller
  /// letters where these are many; what does not fit into half of the page is told.
  void areWhole_data() {
    QTest::addColumn<int>("people");
    QTest::addColumn<int>("lines");
    QTest::addColumn<bool>("whole");
    QTest::newRow("one") << 1 << 1 << true;
    QTest::newRow("fifteen") << 15 << 3 << true;
    QTest::newRow("a hundred") << 100 << 0 << true;
    QTest::newRow("a thousand") << 1000 << 0 << false;
  }
  void areWhole() {
    QFETCH(int, people);
    QFETCH(int, lines);
    QFETCH(bool, whole);
    QString authors = "A. Anatomist";
    for (int i = 1; i < people; ++i)
      authors += ", B. Anatomist";
    const Marks marks = marksOf(creditedOrder(authors));
    const std::vector<LetteringItem>& items = marks.lettering.items;
    const auto sources = std::find_if(items.begin(), items.end(), [](const LetteringItem& item) {
      return item.name == "sources";
    });
    QVERIFY(sources != items.end());
    QVERIFY(lines == 0 || int(sources->text->lines.size()) == lines);
    QCOMPARE(plainText(sources->text->lines) == authors, whole);
    const bool told = std::any_of(
        marks.notes.begin(), marks.notes.end(),
        [](const ExportNote& note) { return note.kind == ExportNote::Kind::textShortened; });
    QCOMPARE(told, !whole);
    const QRectF box = outlineOf(*sources->text).boundingRect();
    QVERIFY(QRectF(0.0, 0.0, 100.0, 80.0).contains(box));
    QVERIFY(80.0 - box.top() <= double(marks.foot) + 3.0);
    for (const LetteringItem& item : items)
      if (item.name != "sources" && item.text)
        QVERIFY2(outlineOf(*item.text).boundingRect().bottom() < box.top(), item.name.c_str());
  }

  /// A fitted picture leaves them their room, also where nothing else is written.
  void haveRoom() {
    ExportOrder order = creditedOrder("A. Anatomist");
    order.marks = ExportMarks::none();
    QVERIFY(!order.bare());
    const double one = sidesOfPlate(order, *m_typesetting).bottom;
    QVERIFY(one > sidesOfPlate(order, *m_typesetting).top);
    QString authors = "A. Anatomist";
    for (int i = 1; i < 15; ++i)
      authors += ", B. Anatomist";
    ExportOrder longer = creditedOrder(authors);
    longer.marks = ExportMarks::none();
    QVERIFY(sidesOfPlate(longer, *m_typesetting).bottom > one + 0.03);
    order.sources = SourceCredits::off;
    QVERIFY(order.bare());
    QCOMPARE(sidesOfPlate(order, *m_typesetting).bottom, sidesOfPlate(order, *m_typesetting).top);
  }
};

}  // namespace sline::test

SLINE_TEST(sline::test::CreditsLineTest)
#include "credits_line_test.moc"
