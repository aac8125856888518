// SPDX-License-Identifier: Apache-2.0
// Tests lessons as PDF readers open them: bookmarks, links and pages, and figures that fit.
#include <QTest>
#include <qpdf/JSON.hh>
#include <qpdf/QPDF.hh>

#include "model/scene/visible_structures.h"
#include "render/export/order/test_options.h"
#include "render/export/order/view_orders.h"
#include "render/export/pdf/lesson.h"
#include "render/export/pdf/sheet_figure.h"
#include "render/export/pdf/sheet_options.h"
#include "render/labels/seen/screen.h"
#include "render/lettering/typesetting.h"
#include "tests/render/export/slides/lesson.h"
#include "tests/support/suite.h"

namespace sline::test {

using namespace render;

namespace {

using Object = QPDFObjectHandle;

ExportOrder threeViews(SheetKind kind) {
  ExportOrder order = lessonOf({"liver", "spleen", "left kidney", "right kidney"});
  std::vector<model::View> views;
  addView(order, views, "First").words.title.text = "Eins <b>&</b>";
  addView(order, views, "Second").annotations = {order.scene.annotations()[1].id};
  addView(order, views, "Third");
  order.scene.setViews(views);
  order.of<ViewsOptions>().subject = ViewSubject::all;
  order.of<SheetOptions>().kind = kind;
  return order;
}

/// Reads where links and bookmarks of a file lead.
class Opened {
 public:
  explicit Opened(const QByteArray& bytes) : m_bytes(bytes) {
    m_file.processMemoryFile("lesson", m_bytes.constData(), std::size_t(m_bytes.size()));
  }

  int pages() { return int(m_file.getAllPages().size()); }
  bool fine() { return m_file.getWarnings().empty(); }

  /// Returns the page, counted from 1, to which a destination leads.
  int pageOf(Object destination) {
    for (int i = 0; i < pages(); ++i) {
      Object page = m_file.getAllPages()[std::size_t(i)];
      if (page.getObjGen() == destination.getArrayItem(0).getObjGen())
        return i + 1;
    }
    return 0;
  }

  /// Returns bookmarks as "Title 3", those within others with a dash before them.
  QStringList bookmarks() { return below(m_file.getRoot().getKey("/Outlines"), {}); }

  /// Returns the pages to which links of that page, counted from 1, lead.
  QList<int> links(int page) {
    QList<int> targets;
    Object holder = m_file.getAllPages()[std::size_t(page - 1)];
    Object notes = holder.getKey("/Annots");
    for (int i = 0; notes.isArray() && i < notes.getArrayNItems(); ++i)
      targets << pageOf(notes.getArrayItem(i).getKey("/Dest"));
    return targets;
  }

 private:
  QStringList below(Object parent, const QString& before) {
    QStringList all;
    Object last;
    for (Object item = parent.getKey("/First"); item.isDictionary(); item = item.getKey("/Next")) {
      all << before + QString::fromStdString(item.getKey("/Title").getUTF8Value()) + ' ' +
                 QString::number(pageOf(item.getKey("/Dest")));
      all += below(item, before + "- ");
      last = item;
    }
    if (last.isInitialized() && last.getObjGen() != parent.getKey("/Last").getObjGen())
      all << "the last one is another";
    return all;
  }

  QByteArray m_bytes;
  QPDF m_file;
};

Opened opened(const ExportOrder& order) {
  const Result<QByteArray> document = lessonDocument(order, {}, {});
  if (!document.ok())
    qFatal("%s", document.error().text().c_str());
  return Opened(*document);
}

}  // namespace

class LessonTest : public QObject {
  Q_OBJECT
  std::unique_ptr<Typesetting> m_typesetting;

 private slots:
  /// The words are all there, always in the same order, and not in that of the answers.
  void wordBanks() {
    for (int count = 0; count < 40; ++count) {
      std::vector<std::string> answers;
      for (int i = 0; i < count; ++i)
        answers.push_back("structure " + std::to_string(i * 7 % 40));
      const std::vector<std::string> bank = shuffledWords(answers);
      QVERIFY(bank == shuffledWords(answers));
      QVERIFY(count < 2 || bank != answers);
      // Whoever knows the bank does not know the order of the answers.
      std::vector<std::string> turned(answers.rbegin(), answers.rend());
      QVERIFY(count < 3 || shuffledWords(turned) == bank || bank == turned);
      std::vector<std::string> sorted = bank;
      std::sort(sorted.begin(), sorted.end());
      std::sort(answers.begin(), answers.end());
      QVERIFY(sorted == answers);
    }
    QVERIFY(shuffledWords({"same", "same"}) == (std::vector<std::string>{"same", "same"}));
  }

  /// One name is enough for two mirror images, but the chambers of a heart have one each.
  void namesOfPairs() {
    ExportOrder order;
    addBall(order.scene, {45, 0, 0}, 10.0f, "left kidney");
    addBall(order.scene, {-45, 0, 4}, 10.0f, "right kidney");
    addBall(order.scene, {16, 16, 60}, 10.0f, "left ventricle");
    addBall(order.scene, {-16, -16, 60}, 10.0f, "right ventricle");
    order.scene.setAnnotations({});
    fitCamera(order);
    order.of<SheetOptions>().kind = SheetKind::teaching;
    const ExportOrder figure = sheetFigure(order);
    QStringList named;
    for (const model::Annotation& label : figure.scene.annotations())
      named << QString::fromStdString(label.text);
    QCOMPARE(named.filter("kidney").size(), 1);
    QCOMPARE(named.filter("ventricle").size(), 2);
  }

  void initTestCase() {
    Result<std::unique_ptr<Typesetting>> made = Typesetting::create();
    QVERIFY(made.ok());
    m_typesetting = std::move(*made);
  }

  void goesFromPageToPage_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("key");
    QTest::addColumn<QStringList>("bookmarks");
    QTest::addColumn<QList<int>>("contents");
    QTest::newRow("figures") << int(SheetKind::none) << int(KeyPlace::next)
                             << QStringList{"Contents 1", "Eins <b>&</b> 2", "Second 3", "Third 4",
                                            "Index of structures 5"}
                             << QList<int>{2, 2, 3, 3, 4, 4, 5, 5};
    QTest::newRow("keys after tests") << int(SheetKind::teaching) << int(KeyPlace::next)
                                      << QStringList{"Contents 1",
                                                     "Eins <b>&</b> 2",
                                                     "- Self-test 3",
                                                     "- Key 4",
                                                     "Second 5",
                                                     "- Self-test 6",
                                                     "- Key 7",
                                                     "Third 8",
                                                     "- Self-test 9",
                                                     "- Key 10",
                                                     "Index of structures 11"}
                                      << QList<int>{2, 2, 5, 5, 8, 8, 11, 11};
    QTest::newRow("keys at the end")
        << int(SheetKind::teaching) << int(KeyPlace::end)
        << QStringList{"Contents 1",    "Eins <b>&</b> 2", "- Self-test 3",
                       "Second 4",      "- Self-test 5",   "Third 6",
                       "- Self-test 7", "Key 8",           "- Eins <b>&</b> 8",
                       "- Second 9",    "- Third 10",      "Index of structures 11"}
        << QList<int>{2, 2, 4, 4, 6, 6, 8, 8, 11, 11};
  }
  void goesFromPageToPage() {
    QFETCH(int, kind);
    QFETCH(int, key);
    QFETCH(QStringList, bookmarks);
    QFETCH(QList<int>, contents);
    ExportOrder order = threeViews(SheetKind(kind));
    order.of<TestOptions>().key = KeyPlace(key);
    Opened file = opened(order);
    QVERIFY(file.fine());
    QCOMPARE(file.bookmarks(), bookmarks);
    QCOMPARE(file.links(1), contents);
    // The index leads to the pages with labels; the second view has one.
    std::map<int, int> leads;
    for (const int page : file.links(file.pages()))
      ++leads[page];
    const int second = bookmarks.filter("Second").first().section(' ', 1).toInt();
    QCOMPARE(int(leads.size()), 3);
    QCOMPARE(leads[second], 1);
    QCOMPARE(leads[2], 4);
    // What the dialog tells beforehand.
    QCOMPARE(int(lessonPages(order)), file.pages());
  }

  void aScheduleOfManyViews() {
    ExportOrder order = lessonOf({"one"});
    std::vector<model::View> views;
    for (int i = 0; i < 40; ++i)
      addView(order, views, "View " + std::to_string(i));
    order.scene.setViews(views);
    order.of<ViewsOptions>().subject = ViewSubject::all;
    Opened file = opened(order);
    QCOMPARE(file.pages(), 2 + 40 + 1);
    QCOMPARE(file.links(1).size() + file.links(2).size(), 2 * 41);
    QCOMPARE(int(lessonPages(order)), file.pages());
  }

  void oddNamesStayText() {
    ExportOrder order = lessonOf(oddNames());
    std::vector<model::View> views;
    for (const std::string& name : oddNames())
      addView(order, views, name).words.text.text = name;
    order.scene.setViews(views);
    order.of<ViewsOptions>().subject = ViewSubject::all;
    order.of<SheetOptions>().kind = SheetKind::teaching;
    order.of<TestOptions>().wordBank = true;
    order.of<SheetOptions>().title = oddNames()[1];
    Opened file = opened(order);
    QVERIFY(file.fine());
    QStringList outer;
    for (const QString& bookmark : file.bookmarks())
      if (!bookmark.startsWith("- "))
        outer << bookmark.section(' ', 0, -2);
    QCOMPARE(outer.size(), qsizetype(oddNames().size()) + 2);
    for (std::size_t i = 0; i < oddNames().size(); ++i)
      QCOMPARE(outer[qsizetype(i) + 1], QString::fromStdString(oddNames()[i]).simplified());
  }

  /// A view of a wide window shows on tall paper all that it showed there, with room for labels.
  void figuresFitTheirPaper() {
    ExportOrder order = lessonOf({"a", "b"});
    const ExportOrder sheet =
        lessonSheet(threeViews(SheetKind::none), threeViews(SheetKind::none).scene.views().front());
    const float aspect = sheet.page.sizeMm.x / sheet.page.sizeMm.y;
    QVERIFY(aspect < 1.0f);
    for (const glm::vec3& point : model::visiblePoints(sheet.scene)) {
      const Screen screen(sheet.camera, sheet.page.sizeMm);
      const auto at = screen.place(point);
      QVERIFY(at && at->x > 0.0f && at->x < sheet.page.sizeMm.x);
    }
    // A wide page needs no other camera.
    QVERIFY(fittedToPage(order.scene, order.camera, 16.0f / 9.0f) == order.camera);
  }

  void stops() {
    const ExportOrder order = threeViews(SheetKind::teaching);
    for (const int calls : {0, 1, 4}) {
      int asked = 0;
      const auto stopped =
          lessonDocument(order, "x.pdf", [&](double, std::string_view) { return asked++ < calls; });
      QVERIFY(!stopped.ok());
      QCOMPARE(stopped.error().file, std::string("x.pdf"));
    }
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_GUI(sline::test::LessonTest)
#include "lesson_test.moc"
