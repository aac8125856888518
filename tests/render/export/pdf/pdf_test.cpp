// SPDX-License-Identifier: Apache-2.0
// What PDF files are made of: objects, drawings with groups that are clear as a whole, lists that
// flow through columns and pages.
#include <QTest>
#include <algorithm>

#include "render/export/pdf/pdf_pages.h"
#include "render/export/pdf/sheet.h"
#include "render/export/pdf/sheet_layout.h"
#include "render/export/typesetting.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

Q_DECLARE_METATYPE(std::vector<sline::render::RowKind>)

namespace sline::test {

using namespace render;

class PdfTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void damagedFilesAreRefused();
  void clearGroupsAreGroups();
  void listsFlow_data();
  void listsFlow();
  void stopsWhenToldTo();

 private:
  QByteArray page(float opacity) const;
  std::unique_ptr<Typesetting> m_typesetting;
};

void PdfTest::initTestCase() {
  Result<std::unique_ptr<Typesetting>> made = Typesetting::create();
  QVERIFY(made.ok());
  m_typesetting = std::move(*made);
}

/// Two tones, one over the other, that clear together.
QByteArray PdfTest::page(float opacity) const {
  const auto tone = [](float inset, const Colour& colour) {
    return VectorShape{.path = roundedBox(glm::vec2(10.0f + inset), glm::vec2(40.0f - inset), 1.0f),
                       .colour = colour,
                       .opacity = 1.0f,
                       .penWidth = 0.0f};
  };
  VectorDrawing drawing{.sizeMm = {50.0f, 50.0f}, .background = {}, .structures = {}};
  drawing.structures.push_back({.id = {},
                                .depth = 0.5f,
                                .paintRank = 0,
                                .fills = {tone(0.0f, {255, 0, 0}), tone(5.0f, {120, 0, 0})},
                                .fillOpacity = opacity,
                                .lines = {}});
  PdfPages pages({50.0f, 50.0f}, "en");
  pages.place(drawing, {{}, {{}, {50.0f, 50.0f}}});
  const Result<QByteArray> bytes = pages.finish();
  return bytes.ok() ? *bytes : QByteArray();
}

void PdfTest::damagedFilesAreRefused() {
  const QByteArray whole = page(1.0f);
  QVERIFY(PdfObjects::read(whole));
  for (const QByteArray& bytes :
       {QByteArray(), QByteArray("%PDF-1.4\n"), whole.left(whole.size() / 2),
        QByteArray(whole).replace("startxref\n", "startxref\n9"),
        QByteArray(whole).replace("/Root ", "/Root 99"),
        QByteArray(whole).replace("/Kids", "/Kits")})
    QVERIFY(!PdfObjects::read(bytes));
  for (qsizetype cut = 1; cut < whole.size(); cut += 37)
    PdfObjects::read(whole.left(cut));  // whatever comes of it, it ends
}

void PdfTest::clearGroupsAreGroups() {
  QVERIFY(!page(1.0f).contains("/Transparency"));
  const QByteArray clear = page(0.4f);
  QVERIFY(clear.contains("/Transparency"));
  QVERIFY(clear.contains("/ca 0.4/CA 0.4"));
  QCOMPARE(clear.count("/Subtype/Form"), 1);
}

void PdfTest::listsFlow_data() {
  QTest::addColumn<std::vector<RowKind>>("rows");
  QTest::addColumn<float>("height");
  QTest::addColumn<int>("pages");
  const auto rows = [](std::size_t groups, std::size_t each) {
    std::vector<RowKind> all{RowKind::heading};
    for (std::size_t i = 0; i < groups; ++i) {
      all.push_back(RowKind::group);
      all.insert(all.end(), each, RowKind::legend);
    }
    return all;
  };
  QTest::newRow("none") << std::vector<RowKind>{} << 50.0f << 0;
  QTest::newRow("one") << rows(0, 0) << 50.0f << 1;
  QTest::newRow("few") << rows(2, 3) << 50.0f << 1;
  QTest::newRow("many") << rows(9, 7) << 60.0f << 2;
  QTest::newRow("a great many") << rows(90, 7) << 60.0f << 7;
  QTest::newRow("no room at first") << rows(2, 3) << 2.0f << 2;
}

void PdfTest::listsFlow() {
  QFETCH(std::vector<RowKind>, rows);
  QFETCH(float, height);
  QFETCH(int, pages);
  const ListFrames frames{.first = {{15.0f, 200.0f}, {195.0f, 200.0f + height}},
                          .firstColumns = 3,
                          .next = {{15.0f, 20.0f}, {195.0f, 280.0f}},
                          .nextColumns = 3};
  const std::vector<RowPlace> places = flow(rows, frames);
  QCOMPARE(places.size(), rows.size());
  std::size_t last = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const LabelBox& frame = places[i].page == 0 ? frames.first : frames.next;
    QVERIFY(places[i].at.x >= frame.low.x && places[i].at.x < frame.high.x);
    QVERIFY(places[i].at.y >= frame.low.y);
    QVERIFY(places[i].at.y + rowHeight(rows[i]) <= frame.high.y + 0.1f);
    if (i + 1 == places.size())
      break;
    const bool below = places[i + 1].page == places[i].page && places[i + 1].at.x == places[i].at.x;
    if (below)
      QVERIFY(places[i + 1].at.y >= places[i].at.y + rowHeight(rows[i]) - 1e-3f);
    else
      QVERIFY2(rows[i] == RowKind::legend, "a heading stands alone");
    last = places[i + 1].page;
  }
  QCOMPARE(rows.empty() ? 0 : int(last) + 1, pages);
}

void PdfTest::stopsWhenToldTo() {
  ExportOrder order;
  model::Node node;
  node.mesh = sphere(20.0f, 2);
  order.scene.append(std::move(node));
  order.camera = model::anatomicalCamera(model::AnatomicalView::anterior,
                                         order.scene.visibleBounds(), 16.0f / 9.0f);
  for (const SheetKind kind : {SheetKind::figure, SheetKind::teaching, SheetKind::patient}) {
    order.sheet.kind = kind;
    const auto stop = [](double, std::string_view) { return false; };
    const Result<QByteArray> stopped = sheetDocument(order, "never.pdf", stop);
    QVERIFY(!stopped.ok());
    QCOMPARE(QString::fromStdString(stopped.error().reason), QString("the export was stopped"));
    QVERIFY(sheetDocument(order, "never.pdf", {}).ok());
  }
}

}  // namespace sline::test

SLINE_TEST(sline::test::PdfTest)
#include "pdf_test.moc"
