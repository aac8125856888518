// SPDX-License-Identifier: Apache-2.0
// Tests labels in views, and several labels at once, in the panel of labels.
#include <QMenu>
#include <QStatusBar>

#include "tests/gui/labels_panel_fixture.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

/// Makes all views show all labels, and goes to the second.
void showEverywhere(LabelsPanelFixture& f) {
  model::Scene scene = f.session.scene();
  for (const model::Annotation& annotation : f.annotations())
    scene = model::withAnnotationShownIn(scene, annotation.id, std::nullopt).scene;
  f.session.apply("all", {std::move(scene), true});
  f.control<QMenu>("savedViews").actions().at(1)->trigger();
  QVERIFY(f.settled());
}

}  // namespace

class LabelsViewsTest : public QObject {
  Q_OBJECT

 private slots:
  void labelsAreBoundToViews() {
    LabelsPanelFixture f;
    f.make(f.liver, {});
    f.make(f.bladder, {});
    f.open();
    f.choose(0);
    QVERIFY(!f.box("annotationViews").isEnabled());
    for (const Qt::Key side : {Qt::Key_A, Qt::Key_P}) {
      f.key(side);
      f.key(Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
    }
    QVERIFY(f.settled());
    showEverywhere(f);
    f.choose(0);
    QCOMPARE(f.rowsOf("annotationViews"),
             QStringList({"In all views", "Only in View 1", "Only in View 2"}));
    QCOMPARE(f.box("annotationViews").currentIndex(), 0);
    f.pick("annotationViews", 2);
    const model::AnnotationId id = f.annotations().front().id;
    QCOMPARE(model::viewsShowing(f.session.scene(), id), std::vector<std::size_t>{1});
    QCOMPARE(f.step(), QStringLiteral("Views of a Label"));
    // The current picture stays; a view shows the labels it has.
    QCOMPARE(f.shownLines(), QStringList({"liver", "bladder"}));
    const QList<QAction*> views = f.control<QMenu>("savedViews").actions();
    views.at(0)->trigger();
    QCOMPARE(f.shownLines(), QStringList{"bladder"});
    views.at(1)->trigger();
    QCOMPARE(f.shownLines(), QStringList({"liver", "bladder"}));
    f.choose(0);
    f.pick("annotationViews", 0);
    QCOMPARE(model::viewsShowing(f.session.scene(), id).size(), std::size_t(2));
    // The keys passed the other view on their way.
    f.session.undo();
    f.session.undo();
    QCOMPARE(model::viewsShowing(f.session.scene(), id), std::vector<std::size_t>{1});
  }

  /// A label belongs to the view that it is made in. Once that one is left it belongs to the view
  /// that is saved next, which takes no others.
  void labelsBelongToTheirView() {
    LabelsPanelFixture f;
    // Where nothing is to be shown there is no sheet.
    const auto lines = [&f] {
      return f.settled() && f.labels().layer().sheet() ? f.shownLines() : QStringList();
    };
    f.make(f.bladder, {});
    for (const Qt::Key side : {Qt::Key_A, Qt::Key_P}) {
      f.key(side);
      f.key(Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
      QVERIFY(f.settled());
      // The second view has no label, and its picture neither.
      QCOMPARE(lines().size(), qsizetype(side == Qt::Key_A ? 1 : 0));
    }
    const auto goTo = [&f](int view) {
      f.control<QMenu>("savedViews").actions().at(view)->trigger();
      return f.settled();
    };
    const auto last = [&] {
      return model::viewsShowing(f.session.scene(), f.annotations().back().id);
    };
    using Places = std::vector<std::size_t>;
    QCOMPARE(last(), Places{0});
    QVERIFY(goTo(0));
    const int before = f.steps();
    f.make(f.liver, {});
    QCOMPARE(f.steps(), before + 1);
    QCOMPARE(last(), Places{0});
    QVERIFY2(f.window.statusBar()->currentMessage().contains("1 of 2"),
             qPrintable(f.window.statusBar()->currentMessage()));
    QVERIFY(goTo(1));
    QCOMPARE(lines().size(), qsizetype(0));
    QVERIFY(goTo(0));
    QCOMPARE(lines().size(), qsizetype(2));
    // The view is left: what is made now is the next one's.
    f.key(Qt::Key_L);
    QVERIFY(f.settled());
    f.makeBeside(f.liver, QStringLiteral("second"));
    QCOMPARE(last(), Places{});
    f.key(Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(f.settled());
    QCOMPARE(last(), Places{2});
    QCOMPARE(lines(), QStringList{"second"});
    QVERIFY(goTo(0));
    QCOMPARE(lines().size(), qsizetype(2));
  }

  void severalAreTickedAtOnce() {
    LabelsPanelFixture f;
    f.make(f.liver, {});
    f.make(f.bladder, {});
    f.makeBeside(f.liver, QStringLiteral("third"));
    for (const Qt::Key side : {Qt::Key_A, Qt::Key_P}) {
      f.key(side);
      f.key(Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
    }
    QVERIFY(f.settled());
    showEverywhere(f);
    f.open();
    f.choose(0);
    QTest::mouseClick(f.list().viewport(), Qt::LeftButton, Qt::ControlModifier,
                      f.list().visualRect(f.cell(2, 1)).center());
    QCOMPARE(f.list().selectionModel()->selectedRows().size(), qsizetype(2));
    const auto ticks = [&] {
      QMenu& menu = f.control<QMenu>("annotationViewMenu");
      emit menu.aboutToShow();
      return menu.actions();
    };
    const auto showing = [&](std::size_t row) {
      return model::viewsShowing(f.session.scene(), f.annotations()[row].id);
    };
    using Places = std::vector<std::size_t>;
    QCOMPARE(ticks().at(0)->text(), QStringLiteral("View 1"));
    QVERIFY(ticks().at(0)->isCheckable() && ticks().at(0)->isChecked());
    const int before = f.steps();
    ticks().at(0)->trigger();
    QCOMPARE(f.steps(), before + 1);
    QCOMPARE(showing(0), Places{1});
    QCOMPARE(showing(1), (Places{0, 1}));
    QCOMPARE(showing(2), Places{1});
    QVERIFY(!ticks().at(0)->isChecked());
    QCOMPARE(f.list().selectionModel()->selectedRows().size(), qsizetype(2));
    QCOMPARE(f.box("annotationViews").currentText(), QStringLiteral("Only in View 2"));
    // The list changes both, too.
    f.pick("annotationViews", 1);
    QCOMPARE(showing(0), Places{0});
    QCOMPARE(showing(2), Places{0});
    QTest::mouseClick(f.list().viewport(), Qt::LeftButton, Qt::ShiftModifier,
                      f.list().visualRect(f.cell(0, 1)).center());
    QCOMPARE(f.list().selectionModel()->selectedRows().size(), qsizetype(3));
    QCOMPARE(f.box("annotationViews").currentText(), QStringLiteral("In different views"));
    QVERIFY(!ticks().at(1)->isChecked());
    QVERIFY(ticks().at(1)->text().contains("some"));
    ticks().at(4)->trigger();  // below a separator
    QVERIFY(showing(0).empty() && showing(1).empty() && showing(2).empty());
    ticks().at(3)->trigger();
    QCOMPARE(showing(1), (Places{0, 1}));
    f.list().setFocus();
    QTest::keyClick(&f.list(), Qt::Key_Delete);
    QVERIFY(f.annotations().empty());
    QCOMPARE(f.step(), QStringLiteral("Delete Labels"));
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::LabelsViewsTest)
#include "labels_views_test.moc"
