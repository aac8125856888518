// SPDX-License-Identifier: Apache-2.0
// Tests how PDF files are made: painted pages that no longer tell who made them, drawings with
// groups that are clear as a whole, lists that flow through columns and pages.
#include <QBuffer>
#include <QFile>
#include <QPainter>
#include <QPdfWriter>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <qpdf/Buffer.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFWriter.hh>

#include "render/export/pdf/pdf_document.h"
#include "render/export/pdf/pdf_pages.h"
#include "render/export/pdf/sheet.h"
#include "render/export/pdf/sheet_layout.h"
#include "render/export/pdf/sheet_options.h"
#include "render/lettering/typesetting.h"
#include "tests/support/marker_scan.h"
#include "tests/support/mutator.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

Q_DECLARE_METATYPE(std::vector<sline::render::RowKind>)

namespace sline::test {

using namespace render;

namespace {

using Object = QPDFObjectHandle;

constexpr glm::dvec2 paper(200.0, 100.0);  // in points

/// Returns two pages as QPdfWriter makes them.
QByteArray painted() {
  QBuffer bytes;
  bytes.open(QIODevice::WriteOnly);
  QPdfWriter writer(&bytes);
  writer.setPageSize(QPageSize(QSizeF(paper.x, paper.y), QPageSize::Point));
  QPainter painter(&writer);
  painter.drawLine(10, 10, 90, 90);
  writer.newPage();
  painter.drawRect(10, 10, 90, 90);
  painter.end();
  return bytes.data();
}

Object stream(QPDF& file, const std::string& data, const char* type) {
  Object made = file.newStream(data);
  made.getDict().replaceKey("/Type", Object::newName(type));
  return made;
}

/// Returns the pages as written by a program that records all that PDF can hold about its user, in
/// places where newer versions of Qt do so and others may; `when` tells two such files apart.
QByteArray toldOf(const QByteArray& pages, const std::string& when) {
  QPDF file;
  file.processMemoryFile("test", pages.constData(), std::size_t(pages.size()));
  Object catalog = file.getRoot();
  catalog.replaceKey(
      "/Metadata",
      stream(file, "<x:xmpmeta>QZXPRODUCER uuid:QZXUUID-" + when + "</x:xmpmeta>", "/Metadata"));
  catalog.replaceKey("/OutputIntents", Object::parse("[<</Info (QZXINTENT)>>]"));
  catalog.replaceKey("/PieceInfo", Object::parse("<</Maker <</Private (QZXPIECE)>>>>"));
  Object info = Object::parse("<</Producer (QZXQT) /Creator (QZXCREATOR)>>");
  info.replaceKey("/CreationDate", Object::newString("D:" + when));
  file.getTrailer().replaceKey("/Info", file.makeIndirectObject(info));
  file.getTrailer().replaceKey("/ID", Object::parse("[(QZXID) (QZXID)]"));
  Object page = file.getAllPages().front();
  page.replaceKey("/LastModified", Object::newString("D:" + when));
  page.replaceKey("/Metadata", stream(file, "QZXPAGE", "/Metadata"));
  page.replaceKey("/Annots", Object::parse("[<</Subtype /Link /NM (QZXNAME) /M (D:" + when +
                                           ") /Rect [0 0 9 9]>>]"));
  page.getKey("/Resources").replaceKey("/QZXM", Object::parse("[<</Producer (QZXDEEP)>>]"));
  page.getKey("/Resources").replaceKey("/XObject", [&] {
    Object forms = Object::newDictionary();
    Object form = stream(file, "0 0 5 5 re f", "/XObject");
    form.getDict().replaceKey("/Metadata", stream(file, "QZXIMAGE", "/Metadata"));
    forms.replaceKey("/Own", form);
    return forms;
  }());
  QPDFWriter writer(file);
  writer.setOutputMemory();
  writer.write();
  const auto bytes = writer.getBufferSharedPointer();
  return {reinterpret_cast<const char*>(bytes->getBuffer()), qsizetype(bytes->getSize())};
}

Result<QByteArray> joinedPages(const QByteArray& pages, const ExportCredit& credit = {}) {
  return joinedPdf(pages, {{.operators = "0 0 9 9 re f\n"}, {}},
                   {.pageSize = paper, .language = "nb", .title = {}, .credit = credit});
}

}  // namespace

class PdfTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void makersAreNotTold();
  void filesAreSaidToBeWhatTheyAre();
  void damagedPagesAreRefused();
  void clearGroupsAreGroups();
  void listsFlow_data();
  void listsFlow();
  void legendHeadingsHoldForWhatIsBelow();
  void stopsWhenToldTo();
  void pagesAreTagged();
  void othersReadTags();

 private:
  QByteArray page(float opacity) const;
  std::unique_ptr<Typesetting> m_typesetting;
};

/// Returns the elements of that kind below one, as they follow each other.
std::vector<Object> elements(Object below, const std::string& kind) {
  std::vector<Object> found;
  Object children = below.getKey("/K");
  for (int i = 0; children.isArray() && i < children.getArrayNItems(); ++i) {
    Object child = children.getArrayItem(i);
    if (child.getKey("/S").isNameAndEquals(kind))
      found.push_back(child);
    const std::vector<Object> deeper = elements(child, kind);
    found.insert(found.end(), deeper.begin(), deeper.end());
  }
  return found;
}

void PdfTest::initTestCase() {
  Result<std::unique_ptr<Typesetting>> made = Typesetting::create();
  QVERIFY(made.ok());
  m_typesetting = std::move(*made);
}

/// Returns a page of two tones, one over the other, that are clear together.
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

void PdfTest::makersAreNotTold() {
  const QByteArray pages = painted();
  const QByteArray told = toldOf(pages, "20261123034500");
  const QStringList markers{"QZXPRODUCER", "QZXUUID",    "QZXINTENT", "QZXPIECE",
                            "QZXQT",       "QZXCREATOR", "QZXID",     "QZXPAGE",
                            "QZXNAME",     "QZXDEEP",    "QZXIMAGE",  "20261123"};
  QCOMPARE(markersIn(told, markers).size(), markers.size());
  for (const ExportCredit& credit : {ExportCredit{}, ExportCredit{.author = "Ånd & Sons"}}) {
    const Result<QByteArray> bytes = joinedPages(told, credit);
    QVERIFY2(bytes.ok(), bytes.ok() ? "" : bytes.error().text().c_str());
    QCOMPARE(markersIn(*bytes, markers), QStringList());
    QCOMPARE(bytes->contains("/Metadata"), !credit.empty());
    QCOMPARE(bytes->contains("/Info"), !credit.empty());
    // Drawn content is not removed together with the metadata.
    QVERIFY(bytes->contains("/Own") && bytes->contains("/Link"));
    // There is no date and no random number, in the file's identifier either.
    const Result<QByteArray> later = joinedPages(toldOf(pages, "20311224180000"), credit);
    QVERIFY(later.ok());
    QCOMPARE(*later, *bytes);
  }
}

void PdfTest::filesAreSaidToBeWhatTheyAre() {
  const ExportCredit credit{.author = "Ånd & Sons", .copyright = "CC BY 4.0"};
  const Result<QByteArray> bytes =
      joinedPdf(painted(), {{}, {}},
                {.pageSize = paper, .language = "nb", .title = "Nyre (左)", .credit = credit});
  QVERIFY(bytes.ok());
  // Viewers begin to show a linearized file before they have all of it.
  QVERIFY(bytes->left(1024).contains("/Linearized"));
  QPDF file;
  file.processMemoryFile("made", bytes->constData(), std::size_t(bytes->size()));
  QVERIFY(file.checkLinearization());
  Object info = file.getTrailer().getKey("/Info");
  QCOMPARE(info.getKey("/Title").getUTF8Value(), std::string("Nyre (左)"));
  QCOMPARE(info.getKey("/Author").getUTF8Value(), credit.author);
  QCOMPARE(info.getKey("/Copyright").getUTF8Value(), credit.copyright);
  QCOMPARE(info.getKeys().size(), std::size_t(3));
  QCOMPARE(file.getRoot().getKey("/Lang").getUTF8Value(), std::string("nb"));
  QVERIFY(file.getRoot().getKey("/ViewerPreferences").getKey("/DisplayDocTitle").getBoolValue());
  // The credit stands as plain text, for programs that look for it without knowing PDF.
  QVERIFY(bytes->contains("<dc:creator>"));
  for (const Object& page : file.getAllPages()) {
    Object box = Object(page).getKey("/MediaBox");
    QCOMPARE(box.getArrayItem(2).getNumericValue(), paper.x);
    QCOMPARE(box.getArrayItem(3).getNumericValue(), paper.y);
  }
}

void PdfTest::damagedPagesAreRefused() {
  const QByteArray whole = painted();
  QVERIFY(joinedPages(whole).ok());
  // The number of pages differs from that of the drawings.
  QVERIFY(!joinedPdf(whole, {{}}, {.pageSize = paper}).ok());
  for (const QByteArray& bytes :
       {QByteArray(), QByteArray("%PDF-1.4\n"), whole.left(whole.size() / 2),
        QByteArray(whole).replace("startxref\n", "startxref\n9"),
        QByteArray(whole).replace("/Root ", "/Root 99"),
        QByteArray(whole).replace("/Kids", "/Kits")}) {
    const Result<QByteArray> refused = joinedPages(bytes);
    QVERIFY(!refused.ok());
    QVERIFY(!refused.error().reason.empty() && !refused.error().remedy.empty());
  }
  Mutator spoil(18, {});
  int fine = 0;
  for (int i = 0; i < 200; ++i)
    fine += joinedPages(spoil(whole)).ok();  // whatever the result, it ends
  QVERIFY2(fine < 150, qPrintable(QString::number(fine)));
}

void PdfTest::clearGroupsAreGroups() {
  QVERIFY(!page(1.0f).contains("/Transparency"));
  const QByteArray clear = page(0.4f);
  QPDF file;
  file.processMemoryFile("made", clear.constData(), std::size_t(clear.size()));
  Object first = file.getAllPages().front();
  Object resources = first.getKey("/Resources");
  Object form = resources.getKey("/XObject").getKey(pdfFormName(0)).getDict();
  QCOMPARE(form.getKey("/Group").getKey("/S").getName(), std::string("/Transparency"));
  Object state = resources.getKey("/ExtGState").getKey(pdfStateName(40));
  for (const char* name : {"/ca", "/CA"})
    QCOMPARE(state.getKey(name).getNumericValue(), 0.4);
  QCOMPARE(clear.count("/Transparency"), 1);
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
  const std::vector<RowPosition> places = flowIntoColumns(rows, frames);
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

/// What is in no group never stands under the heading of one, nor do ways of drawing.
void PdfTest::legendHeadingsHoldForWhatIsBelow() {
  model::Scene scene;
  const auto add = [&scene](const char* name, model::NodeId parent, bool surface) {
    model::Node node;
    node.name = name;
    node.parent = parent;
    if (surface)
      node.mesh = sphere(20.0f, 1);
    if (!surface)
      node.style.hiddenLines = model::HiddenLines::dashed;
    return scene.append(std::move(node));
  };
  const model::NodeId bone = add("bones", model::rootId, false);
  for (const char* name : {"tibia", "fibula", "talus"})
    add(name, bone, true);
  add("prostate", model::rootId, true);
  const model::NodeId vessel = add("vessels", model::rootId, false);
  for (const char* name : {"aorta", "vena cava"})
    add(name, vessel, true);
  add("bladder", model::rootId, true);
  const auto written = [&scene] {
    QStringList all;
    for (const LegendRow& row : legendRows(scene, LegendList::all)) {
      const model::Node* group = scene.find(row.node->parent);
      if (row.newGroup)
        all << (group ? "[" + QString::fromStdString(group->name) + "]" : "[]");
      all << QString::fromStdString(row.node->name);
    }
    return all.join(' ');
  };
  QCOMPARE(written(),
           QString("[bones] tibia fibula talus [vessels] aorta vena cava [] prostate bladder"));
  const std::vector<LegendRow> legend = legendRows(scene, LegendList::all);
  ExportOrder order;
  order.scene = scene;
  order.of<SheetOptions>().kind = SheetKind::figure;
  const std::vector<RowKind> rows = sheetRows(order, {}, legend).first;
  QVERIFY(rows.size() > 2 && rows[0] == RowKind::heading && rows[1] == RowKind::hidden);
  QVERIFY(rows.back() == RowKind::legend);
}

void PdfTest::stopsWhenToldTo() {
  ExportOrder order;
  model::Node node;
  node.mesh = sphere(20.0f, 2);
  order.scene.append(std::move(node));
  order.camera = model::anatomicalCamera(model::AnatomicalView::anterior,
                                         order.scene.visibleBounds(), 16.0f / 9.0f);
  for (const SheetKind kind : {SheetKind::figure, SheetKind::teaching, SheetKind::patient}) {
    order.of<render::SheetOptions>().kind = kind;
    const auto stop = [](double, std::string_view) { return false; };
    const Result<QByteArray> stopped = sheetDocument(order, "never.pdf", stop);
    QVERIFY(!stopped.ok());
    QCOMPARE(QString::fromStdString(stopped.error().reason), QString("the export was stopped"));
    QVERIFY(sheetDocument(order, "never.pdf", {}).ok());
  }
}

/// Two labelled balls on a sheet with a self-test and its key.
ExportOrder sheetOrder() {
  ExportOrder order;
  for (const float x : {-30.0f, 30.0f}) {
    model::Node node{.name = x < 0.0f ? "QZX(right" : "QZXleft"};
    node.mesh = moved(*sphere(1.0f, 3), 20.0f, {x, 0.0f, 0.0f});
    node.provenance.frame = "LPS";
    model::Annotation label{.kind = model::AnnotationKind::label};
    label.text = node.name;
    label.anchors = {model::SurfacePoint{.structure = order.scene.append(node), .triangle = 0}};
    label.found = true;
    order.scene.appendAnnotation(label);
  }
  order.camera =
      model::anatomicalCamera(model::AnatomicalView::anterior, order.scene.visibleBounds(), 1.5f);
  order.labels = {.mode = LabelMode::on, .language = "nb"};
  order.of<SheetOptions>().kind = SheetKind::teaching;
  return order;
}

/// Each page has its figure, with what it shows, and its texts; marks and tree agree.
void PdfTest::pagesAreTagged() {
  const Result<QByteArray> sheet = sheetDocument(sheetOrder(), {}, {});
  QVERIFY(sheet.ok());
  QPDF file;
  file.processMemoryFile("sheet", sheet->constData(), std::size_t(sheet->size()));
  Object catalog = file.getRoot();
  QCOMPARE(catalog.getKey("/Lang").getUTF8Value(), std::string("nb"));
  QVERIFY(catalog.getKey("/MarkInfo").getKey("/Marked").getBoolValue());
  Object tree = catalog.getKey("/StructTreeRoot");
  const std::vector<Object> figures = elements(tree, "/Figure");
  std::vector<Object> pages = file.getAllPages();
  QCOMPARE(pages.size(), std::size_t(3));
  QCOMPARE(figures.size(), std::size_t(3));
  QCOMPARE(elements(tree, "/Sect").size(), std::size_t(3));
  const auto alt = [&](std::size_t i) {
    Object figure = figures[i];
    return QString::fromStdString(figure.getKey("/Alt").getUTF8Value());
  };
  QVERIFY2(alt(0).contains("QZX(right") && alt(0).contains("sett forfra"), qPrintable(alt(0)));
  for (const std::size_t test : {1, 2})
    QCOMPARE(alt(test), QString("Tegning av 2 strukturer, sett forfra. Kroppens høyre side er til "
                                "venstre i bildet."));
  Object places = tree.getKey("/ParentTree").getKey("/Nums");
  for (std::size_t i = 0; i < pages.size(); ++i) {
    QCOMPARE(pages[i].getKey("/StructParents").getIntValue(), std::int64_t(i));
    Object marks = places.getArrayItem(int(2 * i + 1));
    std::string content;
    for (Object part : pages[i].getPageContents()) {
      const auto bytes = part.getStreamData();
      content.append(reinterpret_cast<const char*>(bytes->getBuffer()), bytes->getSize());
    }
    const QByteArray text = QByteArray::fromStdString(content);
    QCOMPARE(int(text.count("/MCID ")), marks.getArrayNItems());
    QCOMPARE(text.count(" BDC") + text.count(" BMC"), text.count("EMC"));
    for (int mark = 0; mark < marks.getArrayNItems(); ++mark) {
      QCOMPARE(text.count(QByteArray("/MCID " + QByteArray::number(mark) + ">>")), 1);
      QVERIFY(marks.getArrayItem(mark).isDictionary());
    }
  }
  ExportOrder silent = sheetOrder();
  silent.altText = "off";
  silent.of<SheetOptions>().kind = SheetKind::none;
  const Result<QByteArray> figure = figureDocument(silent, {}, {});
  QVERIFY(figure.ok());
  QPDF other;
  other.processMemoryFile("figure", figure->constData(), std::size_t(figure->size()));
  QVERIFY(elements(other.getRoot().getKey("/StructTreeRoot"), "/Figure").empty());
}

void PdfTest::othersReadTags() {
  const QString program = QStandardPaths::findExecutable("pdfinfo");
  if (program.isEmpty())
    SLINE_ABSENT("pdfinfo is not installed");
  QTemporaryDir folder;
  const Result<QByteArray> sheet = sheetDocument(sheetOrder(), {}, {});
  QFile file(folder.filePath("sheet.pdf"));
  QVERIFY(sheet.ok() && file.open(QIODevice::WriteOnly) && file.write(*sheet) == sheet->size());
  file.close();
  const auto told = [&](const QStringList& arguments) {
    QProcess process;
    process.start(program, arguments + QStringList{file.fileName()});
    return process.waitForFinished() ? QString::fromUtf8(process.readAll()) : QString();
  };
  const QString info = told({});
  QVERIFY2(info.contains(QRegularExpression("Tagged: +yes")), qPrintable(info));
  const QString tree = told({"-struct-text"});
  QCOMPARE(int(tree.count("Figure")), 3);
  QCOMPARE(int(tree.count("Sect")), 3);
  QVERIFY2(tree.contains("P (block)\n      \"QZXleft\""), qPrintable(tree));
}

}  // namespace sline::test

SLINE_TEST(sline::test::PdfTest)
#include "pdf_test.moc"
