// SPDX-License-Identifier: Apache-2.0
// Tests saved views in the window: made, renamed, ordered, updated, deleted, and their small
// pictures.
#include <QMenu>
#include <QScrollBar>

#include "model/edit/look.h"
#include "model/edit/views.h"
#include "tests/gui/views_fixture.h"
#include "tests/support/suite.h"

namespace sline::test {

class ViewsTest : public QObject {
  Q_OBJECT

 private slots:
  void panelComesWithTheFirstView();
  void panelAsSomebodySays();
  void addedByKeyButtonAndMenu();
  void renamed_data();
  void renamed();
  void orderedByDrag_data();
  void orderedByDrag();
  void orderedByKeys();
  void updated();
  void deleted();
  void picturesAreKeptAndDrawnAgain();
  void whatIsGoneIsMarked();
  void twoHundred();
  void hostileNames();
};

void ViewsTest::panelComesWithTheFirstView() {
  Views f;
  QVERIFY(!f.dock().isVisible());
  f.add("A");
  QVERIFY(f.dock().isVisible());
  QVERIFY2(f.dock().height() <= 130, qPrintable(QString::number(f.dock().height())));
  f.undo();
  QVERIFY(!f.dock().isVisible());
  Views withViews({{.name = "V"}});
  QVERIFY(withViews.dock().isVisible());
}

void ViewsTest::panelAsSomebodySays() {
  Views f;
  f.dock().toggleViewAction()->trigger();
  QVERIFY(f.dock().isVisible());
  f.add("A");
  f.undo();
  QVERIFY(f.dock().isVisible());
  f.dock().close();
  f.add("A");
  QVERIFY(!f.dock().isVisible());
}

void ViewsTest::addedByKeyButtonAndMenu() {
  Views f;
  f.add("A");
  QCOMPARE(f.names(), QString("View 1"));
  f.press("viewAdd");
  f.control<QAction>("addView").trigger();
  QCOMPARE(f.names(), QString("View 1|View 2|View 3"));
  QCOMPARE(f.steps(), 3);
  QCOMPARE(f.row().model()->rowCount(), 3);
  QCOMPARE(f.row().currentIndex().row(), 2);
  QVERIFY(f.scene().views()[0].camera == f.viewport().camera());
  QCOMPARE(f.scene().views()[0].looks->size(), f.scene().nodes().size());
  f.undo();
  QCOMPARE(f.names(), QString("View 1|View 2"));
  f.row().setCurrentIndex(f.row().model()->index(0, 0));
  f.press("viewDelete");
  f.press("viewAdd");
  QCOMPARE(f.names(), QString("View 2|View 3"));
  WindowFixture empty;
  QVERIFY(!empty.control<QAction>("addView").isEnabled());
  QVERIFY(!empty.control<QAction>("present").isEnabled());
}

void ViewsTest::renamed_data() {
  QTest::addColumn<bool>("byMouse");
  QTest::addColumn<QString>("typed");
  QTest::addColumn<QString>("names");
  QTest::newRow("by F2") << false << "Front"
                         << "View 1|Front|View 3";
  QTest::newRow("by a double click") << true << "Front"
                                     << "View 1|Front|View 3";
  QTest::newRow("to one there is") << false << "View 1"
                                   << "View 1|View 1 2|View 3";
  QTest::newRow("to nothing") << false << " "
                              << "View 1|View 2|View 3";
}

void ViewsTest::renamed() {
  QFETCH(bool, byMouse);
  QFETCH(QString, typed);
  QFETCH(QString, names);
  Views f;
  f.addThree();
  f.clickCard(1);
  const int steps = f.steps();
  if (byMouse)
    QTest::mouseDClick(f.row().viewport(), Qt::LeftButton, {}, f.card(1).center());
  else
    QTest::keyClick(&f.row(), Qt::Key_F2);
  f.type(typed);
  QCOMPARE(f.names(), names);
  const bool changed = names != "View 1|View 2|View 3";
  QCOMPARE(f.steps(), steps + int(changed));
  if (changed)
    f.undo();
  QCOMPARE(f.names(), QString("View 1|View 2|View 3"));
}

void ViewsTest::orderedByDrag_data() {
  QTest::addColumn<int>("from");
  QTest::addColumn<int>("beside");
  QTest::addColumn<bool>("before");
  QTest::addColumn<QString>("names");
  QTest::newRow("last to the front") << 2 << 0 << true << "View 3|View 1|View 2";
  QTest::newRow("first to the end") << 0 << 2 << false << "View 2|View 3|View 1";
  QTest::newRow("one on") << 0 << 1 << false << "View 2|View 1|View 3";
  QTest::newRow("nowhere else") << 1 << 0 << false << "View 1|View 2|View 3";
}

void ViewsTest::orderedByDrag() {
  QFETCH(int, from);
  QFETCH(int, beside);
  QFETCH(bool, before);
  QFETCH(QString, names);
  Views f;
  f.addThree();
  f.clickCard(from);
  const int steps = f.steps();
  QWidget& canvas = *f.row().viewport();
  const QPoint begin = f.card(from).center();
  const QRect target = f.card(beside);
  const QPoint end(before ? target.left() + 4 : target.right() - 4, target.center().y());
  QVERIFY(dragAndDrop(canvas, begin, end));
  QCOMPARE(f.names(), names);
  const bool moved = names != "View 1|View 2|View 3";
  QCOMPARE(f.steps(), steps + int(moved));
  if (moved)
    QCOMPARE(f.row().currentIndex().data().toString(), QString("View %1").arg(from + 1));
  if (moved)
    f.undo();
  QCOMPARE(f.names(), QString("View 1|View 2|View 3"));
}

void ViewsTest::orderedByKeys() {
  Views f;
  f.addThree();
  f.clickCard(1);
  QTest::keyClick(&f.row(), Qt::Key_Right, Qt::AltModifier);
  QCOMPARE(f.names(), QString("View 1|View 3|View 2"));
  QCOMPARE(f.row().currentIndex().row(), 2);
  QTest::keyClick(&f.row(), Qt::Key_Right, Qt::AltModifier);
  QCOMPARE(f.names(), QString("View 1|View 3|View 2"));
  QTest::keyClick(&f.row(), Qt::Key_Left, Qt::AltModifier);
  QTest::keyClick(&f.row(), Qt::Key_Left, Qt::AltModifier);
  QTest::keyClick(&f.row(), Qt::Key_Left, Qt::AltModifier);
  QCOMPARE(f.names(), QString("View 2|View 1|View 3"));
}

void ViewsTest::updated() {
  Views f;
  f.addThree();
  f.clickCard(0);
  f.setGamma(f.left, 5.0f);
  QTest::keyClick(&f.viewport(), Qt::Key_S);
  const int steps = f.steps();
  f.press("viewUpdate");
  QCOMPARE(f.steps(), steps + 1);
  const model::View& view = f.scene().views()[0];
  QVERIFY(view.camera == f.viewport().camera());
  QCOMPARE(model::withViewApplied(f.scene(), view).scene.resolve(f.left).gamma.value(), 5.0f);
  QCOMPARE(f.names(), QString("View 1|View 2|View 3"));
  f.undo();
  QCOMPARE(
      model::withViewApplied(f.scene(), f.scene().views()[0]).scene.resolve(f.left).gamma.value(),
      2.0f);
}

void ViewsTest::deleted() {
  Views f;
  f.addThree();
  QTest::keyClick(&f.viewport(), Qt::Key_A);
  f.row().setCurrentIndex(f.row().model()->index(1, 0));
  f.press("viewDelete");
  QCOMPARE(f.names(), QString("View 1|View 3"));
  f.session.select({f.left});
  QTest::keyClick(&f.row(), Qt::Key_Delete);
  QCOMPARE(f.scene().views().size(), std::size_t(1));
  QCOMPARE(f.scene().nodes().size(), std::size_t(2));  // Del removes structures elsewhere
  f.undo();
  f.undo();
  QCOMPARE(f.names(), QString("View 1|View 2|View 3"));
  for (int i = 0; i < 3; ++i)
    QTest::keyClick(&f.row(), Qt::Key_Delete);
  QVERIFY(f.scene().views().empty());
  QVERIFY(!f.control<QToolButton>("viewDelete").isEnabled());
}

void ViewsTest::picturesAreKeptAndDrawnAgain() {
  Views f;
  f.addThree();
  QVERIFY(f.pictured(3));
  QCOMPARE(f.pictures().drawn(), 3);
  const QImage first = f.cardPicture(0);
  QCOMPARE(first.size(), QSize(112, 68));
  QVERIFY(first != f.cardPicture(2));
  // Names and order are not part of a picture, nor is a look that the views set themselves.
  f.row().setCurrentIndex(f.row().model()->index(0, 0));
  QTest::keyClick(&f.row(), Qt::Key_Right, Qt::AltModifier);
  QVERIFY(f.cardPicture(1) == first);
  f.setGamma(f.left, 0.0f);
  QVERIFY(f.settled());
  // Only a view that shows something else is drawn again.
  f.session.apply(QStringLiteral("Γ"),
                  model::withLook(f.scene(), std::array{f.left}, {.visible = false}));
  f.press("viewUpdate");
  constexpr int minute = 60'000;
  QVERIFY(QTest::qWaitFor([&] { return f.cardPicture(1) != first; }, minute));
  QCOMPARE(f.pictures().drawn(), 4);
  f.undo();
  QVERIFY(QTest::qWaitFor([&] { return f.cardPicture(1) == first; }, minute));
  QCOMPARE(f.pictures().drawn(), 4);
}

void ViewsTest::whatIsGoneIsMarked() {
  model::View view{.name = "V"};
  view.looks = {{.node = {901}}, {.node = {902}}};
  Views f({view, {.name = "whole"}});
  const QModelIndex index = f.row().model()->index(0, 0);
  QCOMPARE(index.data(widgets::ViewList::absentRole).toInt(), 2);
  QVERIFY2(index.data(Qt::ToolTipRole).toString().contains("2 of the structures"),
           qPrintable(index.data(Qt::ToolTipRole).toString()));
  QCOMPARE(f.row().model()->index(1, 0).data(widgets::ViewList::absentRole).toInt(), 0);
  // One can go to the view, and an update forgets what is gone.
  f.clickCard(0);
  QVERIFY(f.settled());
  f.press("viewUpdate");
  QCOMPARE(f.row().model()->index(0, 0).data(widgets::ViewList::absentRole).toInt(), 0);
}

void ViewsTest::twoHundred() {
  std::vector<model::View> views;
  for (int i = 0; i < 200; ++i) {
    model::View view{.name = "View " + std::to_string(i + 1)};
    view.camera.eye = {500.0f * std::sin(float(i)), -500.0f * std::cos(float(i)), 0.0f};
    views.push_back(view);
  }
  Views f(views);
  QCOMPARE(f.row().model()->rowCount(), 200);
  const int seen = int(f.row().visibleRows().size());
  QVERIFY2(seen >= 2 && seen < 15, qPrintable(QString::number(seen)));
  QVERIFY(f.pictured(seen));
  QVERIFY(f.cardPicture(150).isNull());  // only those on screen are drawn
  QVERIFY(f.pictures().drawn() < 20);
  f.row().scrollTo(f.row().model()->index(199, 0));
  constexpr int minute = 60'000;
  QVERIFY(QTest::qWaitFor([&] { return !f.cardPicture(199).isNull(); }, minute));
  f.clickCard(199);
  QVERIFY(f.viewport().camera() == f.scene().views()[199].camera);
  QTest::keyClick(&f.row(), Qt::Key_Delete);
  QCOMPARE(f.row().model()->rowCount(), 199);
  QVERIFY(f.row().horizontalScrollBar()->value() > 0);
}

void ViewsTest::hostileNames() {
  const std::vector<std::string> names{"<b>bold</b><img src=x>",
                                       "a\nb\tc",
                                       "&File",
                                       std::string(5000, 'x'),
                                       "\xE2\x80\xAE"
                                       "evil",
                                       "\xD8\xB9\xD8\xB1\xD8\xA8\xD9\x8A",
                                       "\xFF\xFE",
                                       "%1 %n"};
  std::vector<model::View> views;
  for (const std::string& name : names)
    views.push_back({.name = name});
  Views f(views);
  const auto shown = [&](int row) { return f.row().model()->index(row, 0).data().toString(); };
  QCOMPARE(shown(0), QString("<b>bold</b><img src=x>"));
  QCOMPARE(shown(1), QString("a b c"));
  QVERIFY(shown(3).size() <= 200);
  QCOMPARE(shown(4), QString("evil"));
  const QString tip = f.row().model()->index(0, 0).data(Qt::ToolTipRole).toString();
  QVERIFY2(!tip.contains("<b>") && tip.contains("&lt;b&gt;"), qPrintable(tip));
  QCOMPARE(f.control<QMenu>("savedViews").actions()[2]->text(), QString("&&File"));
  f.control<QAction>("present").trigger();
  QCOMPARE(f.presented(), QString("1 / 8   <b>bold</b><img src=x>"));
  QCOMPARE(f.control<QLabel>("presentedView").textFormat(), Qt::PlainText);
  for (int i = 1; i < 8; ++i) {
    QTest::keyClick(&f.viewport(), Qt::Key_Right);
    const auto& label = f.control<QLabel>("presentedView");
    QVERIFY(f.viewport().rect().contains(label.geometry()));
  }
  QVERIFY(f.presented().endsWith("%1 %n"));
  QTest::keyClick(&f.viewport(), Qt::Key_Escape);
  // Typing changes only the name that is typed.
  f.clickCard(1);
  QTest::keyClick(&f.row(), Qt::Key_F2);
  auto* editor = f.row().findChild<QLineEdit*>(QStringLiteral("viewName"));
  QVERIFY(editor);
  QTest::keyClick(editor, Qt::Key_Return);
  f.typed();
  QCOMPARE(f.scene().views()[1].name, std::string("a\nb\tc"));
}

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::ViewsTest)
#include "views_test.moc"
