// SPDX-License-Identifier: Apache-2.0
// Tests the panel of labels: list, words, kinds, views, how they are shown; labels for many at
// once.
#include <QApplication>
#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QMenu>
#include <QStatusBar>
#include <QToolButton>
#include <QTreeView>

#include "model/edit/views.h"
#include "tests/gui/labels_fixture.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

struct Panel : Labels {
  using Labels::Labels;
  void open() {
    control<QDockWidget>("annotationsPanel").raise();
    QCoreApplication::processEvents();
    if (!list().isVisible())
      qFatal("the panel is not there");
  }
  QTreeView& list() { return control<QTreeView>("annotationList"); }
  QModelIndex cell(int row, int column) { return list().model()->index(row, column); }
  QString said(int row, int column) { return cell(row, column).data().toString(); }
  void choose(int row) {
    QTest::mouseClick(list().viewport(), Qt::LeftButton, {},
                      list().visualRect(cell(row, 1)).center());
  }
  QPlainTextEdit& words() { return control<QPlainTextEdit>("annotationText"); }
  QComboBox& box(const char* name) { return control<QComboBox>(name); }
  /// Chooses by keys, as a user would.
  void pick(const char* name, int row) {
    QComboBox& there = box(name);
    there.setFocus();
    while (there.currentIndex() > row)
      QTest::keyClick(&there, Qt::Key_Up);
    while (there.currentIndex() < row)
      QTest::keyClick(&there, Qt::Key_Down);
  }
  /// Makes a label where no other one is in the way of the click.
  void makeBeside(model::NodeId on, const QString& text) {
    key(Qt::Key_T);
    click(middleOf(on) + QPoint(0, areaOf(on).height() / 4));
    if (!typing())
      qFatal("no words can be typed");
    QTest::keyClicks(&editor(), text);
    QTest::keyClick(&editor(), Qt::Key_Return);
    key(Qt::Key_Escape);
    if (!settled())
      qFatal("no picture with the label");
  }
  QStringList rowsOf(const char* name) {
    QStringList all;
    for (int i = 0; i < box(name).count(); ++i)
      all << box(name).itemText(i);
    return all;
  }
  void press(const char* name) { QTest::mouseClick(&control<QToolButton>(name), Qt::LeftButton); }
};

}  // namespace

class LabelsPanelTest : public QObject {
  Q_OBJECT

 private slots:
  void listSaysWhatThereIs() {
    Panel f;
    f.make(f.liver, {});
    f.make(f.bladder, QStringLiteral("<b>x</b>"), Qt::Key_P, Qt::ShiftModifier);
    f.open();
    QCOMPARE(f.list().model()->rowCount(), 2);
    QCOMPARE(f.said(0, 0), QStringLiteral("1"));
    QCOMPARE(f.said(0, 1), QStringLiteral("liver"));
    QCOMPARE(f.said(0, 2), QStringLiteral("Label"));
    QCOMPARE(f.said(1, 1), QStringLiteral("<b>x</b>"));
    QCOMPARE(f.said(1, 2), QStringLiteral("Pin"));
    QCOMPARE(f.said(1, 3), QStringLiteral("bladder"));
    // The active label is the same in the list and in the picture.
    QCOMPARE(f.list().currentIndex().row(), 1);
    f.choose(0);
    QVERIFY(f.session.activeAnnotation() == f.annotations().front().id);
    f.click(f.textAt(f.annotations().back().id));
    QCOMPARE(f.list().currentIndex().row(), 1);
    // Names follow the language.
    f.window.preferences().set("language/structures", "de");
    QCOMPARE(f.said(0, 1), QStringLiteral("Leber"));
    QCOMPARE(f.said(0, 3), QStringLiteral("Leber"));
  }

  void ticksShowAndHide() {
    Panel f;
    f.make(f.liver, {});
    f.make(f.bladder, {});
    f.open();
    QVERIFY(f.list().model()->setData(f.cell(0, 0), Qt::Unchecked, Qt::CheckStateRole));
    QCOMPARE(f.step(), QStringLiteral("Hide Label"));
    QCOMPARE(f.shownLines(), QStringList{"bladder"});
    QCOMPARE(f.said(0, 0), QString());
    QCOMPARE(f.said(1, 0), QStringLiteral("1"));
    f.undo();
    QCOMPARE(f.shownLines(), QStringList({"liver", "bladder"}));
  }

  void wordsAreWrittenHere() {
    Panel f;
    f.make(f.liver, {});
    f.open();
    f.choose(0);
    const int before = f.steps();
    QCOMPARE(f.words().toPlainText(), QStringLiteral("liver"));
    f.words().setFocus();
    f.words().selectAll();
    QTest::keyClicks(&f.words(), QStringLiteral("right "));
    QTest::keyClicks(&f.words(), QStringLiteral("lobe"));
    QCOMPARE(f.only().text, std::string("right lobe"));
    QCOMPARE(f.words().toPlainText(), QStringLiteral("right lobe"));
    QCOMPARE(f.shownLines(), QStringList{"right lobe"});
    QTest::keyClick(&f.words(), Qt::Key_Return);  // a label is one line
    QCOMPARE(f.only().text, std::string("right lobe"));
    f.session.undo();
    QCOMPARE(f.only().text, std::string("liver"));
    QCOMPARE(f.steps(), before);
    QCOMPARE(f.words().toPlainText(), QStringLiteral("liver"));
    // The text in another language stands beside the original; a hint shows what it lacks.
    f.window.preferences().set("labels/language", "de");
    QCOMPARE(f.words().toPlainText(), QStringLiteral("Leber"));
    f.words().selectAll();
    QTest::keyClick(&f.words(), Qt::Key_Delete);
    QVERIFY(!f.only().texts.contains("de"));
    QCOMPARE(f.words().placeholderText(), QStringLiteral("liver"));
    QTest::keyClicks(&f.words(), QStringLiteral("Lappen"));
    QCOMPARE(f.only().texts.at("de"), std::string("Lappen"));
    QCOMPARE(f.only().text, std::string("liver"));
  }

  /// The list, its tips and the field's hint for another language show the words alone.
  void calloutsAreMarkedUpHere() {
    Panel f;
    f.make(f.liver, {}, Qt::Key_T, Qt::ShiftModifier);
    f.open();
    f.choose(0);
    QVERIFY(f.words().toolTip().contains("*italic* (Ctrl+I)"));
    f.words().setFocus();
    f.words().selectAll();
    QTest::keyClicks(&f.words(), QStringLiteral("right lobe"));
    const int before = f.steps();
    f.words().selectAll();
    QTest::keyClick(&f.words(), Qt::Key_I, Qt::ControlModifier);
    QVERIFY(!QApplication::activeModalWidget());
    QCOMPARE(f.only().text, std::string("*right lobe*"));
    QCOMPARE(f.words().textCursor().selectedText(), QStringLiteral("right lobe"));
    QTest::keyClick(&f.words(), Qt::Key_B, Qt::ControlModifier);
    QCOMPARE(f.words().toPlainText(), QStringLiteral("***right lobe***"));
    QCOMPARE(f.said(0, 1), QStringLiteral("right lobe"));
    QCOMPARE(f.cell(0, 1).data(Qt::ToolTipRole).toString(), QStringLiteral("<p>right lobe</p>"));
    QCOMPARE(f.cell(0, 1).data(Qt::EditRole).toString(), QStringLiteral("***right lobe***"));
    QCOMPARE(f.shownLines(), QStringList{"right lobe"});
    // It forms one step with the typing before it.
    QCOMPARE(f.steps(), before);
    f.session.undo();
    QCOMPARE(f.only().text, std::string("liver"));
    QCOMPARE(f.words().toPlainText(), QStringLiteral("liver"));
    f.session.redo();
    f.window.preferences().set("labels/language", "la");
    f.words().clear();
    QCOMPARE(f.words().placeholderText(), QStringLiteral("right lobe"));
    // As a label it shows the text as written.
    f.pick("annotationKind", 0);
    QCOMPARE(f.said(0, 1), QStringLiteral("***right lobe***"));
    QVERIFY(f.words().toolTip().isEmpty());
  }

  void kindLockAndPlaceAreChanged() {
    Panel f;
    f.make(f.liver, {});
    f.open();
    f.choose(0);
    QCOMPARE(f.rowsOf("annotationKind"), QStringList({"Label", "Callout", "Pin"}));
    f.pick("annotationKind", 1);
    QVERIFY(f.only().kind == model::AnnotationKind::callout);
    f.session.undo();
    QVERIFY(f.only().kind == model::AnnotationKind::label);
    QTest::mouseClick(&f.control<QCheckBox>("annotationLocked"), Qt::LeftButton, {}, {8, 8});
    QVERIFY(f.only().locked);
    QCOMPARE(f.step(), QStringLiteral("Lock Label"));
    f.session.undo();
    QVERIFY(!f.only().locked);
    QVERIFY(!f.control<QToolButton>("annotationRelease").isEnabled());
    dragMouse(f.viewport(), f.textAt(f.only().id), f.textAt(f.only().id) + QPoint(30, 60));
    QVERIFY(f.only().offset);
    f.press("annotationRelease");
    QVERIFY(!f.only().offset);
  }

  void colourIsChosen() {
    Panel f;
    f.make(f.liver, {});
    f.open();
    f.choose(0);
    QMenu& menu = *f.control<QToolButton>("annotationColour").menu();
    menu.actions().at(1)->trigger();
    auto* dialog = f.window.findChild<QColorDialog*>("annotationColourDialog");
    QVERIFY(dialog);
    dialog->setCurrentColor(QColor(200, 30, 40));
    QVERIFY(f.session.previewing());
    dialog->accept();
    QVERIFY(f.only().colour == (Colour{200, 30, 40}));
    QCOMPARE(f.step(), QStringLiteral("Colour of a Label"));
    menu.actions().at(0)->trigger();
    QVERIFY(!f.only().colour);
  }

  void delTakesAway() {
    Panel f;
    f.make(f.liver, {});
    f.make(f.bladder, {});
    f.open();
    f.session.select({f.liver});
    f.choose(0);
    f.list().setFocus();
    QTest::keyClick(&f.list(), Qt::Key_Delete);
    QCOMPARE(f.annotations().size(), std::size_t(1));
    QCOMPARE(f.session.scene().nodes().size(), std::size_t(2));
    QVERIFY(f.session.activeAnnotation() == f.only().id);
    f.press("annotationDelete");
    QVERIFY(f.annotations().empty());
    QVERIFY(!f.words().isEnabled());
    f.session.undo();
    f.session.undo();
    QCOMPARE(f.annotations().size(), std::size_t(2));
  }

  void labelsAreBoundToViews() {
    Panel f;
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

  /// A label made after views were saved is shown by the chosen view and by those that show all
  /// there is.
  void labelsMadeLaterAreInTheViews() {
    Panel f;
    f.make(f.bladder, {});
    for (const Qt::Key side : {Qt::Key_A, Qt::Key_P}) {
      f.key(side);
      f.key(Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
    }
    QVERIFY(f.settled());
    const auto goTo = [&f](int view) {
      f.control<QMenu>("savedViews").actions().at(view)->trigger();
      return f.settled();
    };
    QVERIFY(goTo(0));
    const auto last = [&] {
      return model::viewsShowing(f.session.scene(), f.annotations().back().id);
    };
    const std::vector<std::size_t> both{0, 1};
    const int before = f.steps();
    f.make(f.liver, {});
    QCOMPARE(f.steps(), before + 1);
    QCOMPARE(last(), both);
    QVERIFY(f.window.statusBar()->currentMessage().isEmpty());
    f.open();
    QCOMPARE(f.box("annotationViews").currentText(), QStringLiteral("In all views"));
    QVERIFY(goTo(1));
    QCOMPARE(f.shownLines().size(), qsizetype(2));
    QVERIFY(goTo(0));
    // A view that leaves out a label gets no others, unless it is the chosen one.
    f.choose(0);
    f.pick("annotationViews", 1);
    f.makeBeside(f.liver, QStringLiteral("second"));
    QCOMPARE(last(), std::vector<std::size_t>{0});
    QVERIFY2(f.window.statusBar()->currentMessage().contains("1 of 2"),
             qPrintable(f.window.statusBar()->currentMessage()));
    f.session.apply(
        "delete", model::withoutAnnotations(
                      f.session.scene(), std::array{f.annotations()[1].id, f.annotations()[2].id}));
    QVERIFY(goTo(1));
    f.session.select({f.liver});
    f.key(Qt::Key_T, Qt::ControlModifier);
    QTRY_COMPARE(f.annotations().size(), std::size_t(2));
    QCOMPARE(last(), both);
    f.session.undo();
    QCOMPARE(f.session.scene().views()[1].annotations->size(), std::size_t(0));
  }

  void severalAreTickedAtOnce() {
    Panel f;
    f.make(f.liver, {});
    f.make(f.bladder, {});
    f.makeBeside(f.liver, QStringLiteral("third"));
    for (const Qt::Key side : {Qt::Key_A, Qt::Key_P}) {
      f.key(side);
      f.key(Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
    }
    QVERIFY(f.settled());
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

  void howTheyAreShown() {
    Panel f;
    f.make(f.liver, {});
    f.open();
    f.pick("annotationMode", 1);
    QCOMPARE(f.shownLines(), QStringList{"1"});
    QVERIFY(f.control<QAction>("labels-numbers").isChecked());
    f.pick("annotationMode", 0);
    f.pick("annotationLanguage", 4);
    QCOMPARE(f.shownLines(), QStringList{"hepar"});
    f.control<QDoubleSpinBox>("annotationPoints").setValue(16);
    QCOMPARE(f.window.preferences().number("labels/points"), 16);
    QCOMPARE(f.sheet().wish.style.points, 16.0f);
  }

  /// The keyboard makes labels, too.
  void selectedAreLabelled() {
    Panel f;
    f.make(f.liver, QStringLiteral("mine"));
    f.session.select({f.liver, f.bladder});
    f.key(Qt::Key_T, Qt::ControlModifier);
    QTRY_COMPARE(f.annotations().size(), std::size_t(2));
    QCOMPARE(f.annotations().back().text, std::string("bladder"));
    QCOMPARE(f.annotations().back().texts.at("de"), std::string("Harnblase"));
    QCOMPARE(f.step(), QStringLiteral("Add 1 labels"));
    QCOMPARE(f.shownLines(), QStringList({"mine", "bladder"}));
    f.undo();
    QCOMPARE(f.annotations().size(), std::size_t(1));
    f.session.select({f.liver});
    f.key(Qt::Key_T, Qt::ControlModifier);
    QTRY_VERIFY(f.window.statusBar()->currentMessage().contains("already"));
    QCOMPARE(f.annotations().size(), std::size_t(1));
  }

  /// Points that a file has in space, and texts of all kinds, are listed.
  void pointsInSpaceAreListed() {
    Panel f;
    f.session.apply("pin", model::withAnnotation(f.session.scene(),
                                                 {.kind = model::AnnotationKind::pin,
                                                  .anchors = {glm::vec3(0.0f, -5.0f, 0.0f)}}));
    f.open();
    QCOMPARE(f.said(0, 1), QStringLiteral("Pin"));
    QCOMPARE(f.said(0, 3), QStringLiteral("a place"));
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::LabelsPanelTest)
#include "labels_panel_test.moc"
