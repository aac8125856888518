// SPDX-License-Identifier: Apache-2.0
// Tests the panel of labels: list, words, kinds, how they are shown; labels for many at once.
#include <QApplication>
#include <QCheckBox>
#include <QColorDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QStatusBar>
#include <QToolButton>

#include "model/edit/look.h"
#include "tests/gui/labels_panel_fixture.h"
#include "tests/support/suite.h"

namespace sline::test {

class LabelsPanelTest : public QObject {
  Q_OBJECT

 private slots:
  void listSaysWhatThereIs() {
    LabelsPanelFixture f;
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
    LabelsPanelFixture f;
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

  /// What the picture lacks, or shows hidden, is said in the list, below it, and when it is made.
  void saysWhatThePictureLacks() {
    LabelsPanelFixture f;
    f.make(f.liver, QStringLiteral("Left lobe"));
    f.make(f.bladder, {});
    f.open();
    f.choose(0);
    auto& says = f.control<QLabel>("annotationSight");
    const auto tip = [&f](int row) { return f.cell(row, 0).data(Qt::ToolTipRole).toString(); };
    QVERIFY(f.settled());
    QVERIFY(!says.isVisible());
    QCOMPARE(tip(0), QStringLiteral("Shown"));
    QVERIFY(!f.cell(0, 1).data(Qt::ForegroundRole).isValid());
    // From behind the place that was set by hand is hidden; that of a name is found anew.
    f.key(Qt::Key_P);
    QVERIFY(f.settled());
    QTRY_VERIFY(says.isVisible() && says.text().contains("set by hand is hidden"));
    QCOMPARE(tip(0), says.text());
    QCOMPARE(tip(1), QStringLiteral("Shown"));
    QVERIFY(f.cell(0, 1).data(Qt::ForegroundRole).isValid());
    f.key(Qt::Key_A);
    QVERIFY(f.settled());
    QTRY_VERIFY(!says.isVisible());
    // Nothing is drawn there.
    f.session.apply("hide", model::withLook(f.session.scene(), {&f.liver, 1}, {.visible = false}));
    QVERIFY(f.settled());
    QTRY_VERIFY(says.isVisible() && says.text().contains("nothing is drawn"));
    f.undo();
    QVERIFY(f.settled());
    QTRY_VERIFY(!says.isVisible());
    // Beyond the edge.
    f.session.select({f.bladder});
    f.control<QAction>("zoomTo").trigger();
    QVERIFY(f.settled());
    f.choose(0);
    QTRY_VERIFY(says.isVisible() && says.text().contains("beyond the edge"));
  }

  /// Whoever has just typed words that have no room is told so.
  void saysWhatFindsNoRoom() {
    LabelsPanelFixture f;
    f.make(f.liver, QStringLiteral("many words ").repeated(900));
    QTRY_VERIFY(f.window.statusBar()->currentMessage().contains("no room"));
    f.open();
    QVERIFY(f.control<QLabel>("annotationSight").text().contains("no room"));
  }

  void twoLanguagesAtOnce() {
    LabelsPanelFixture f;
    f.make(f.bladder, {});
    f.open();
    f.pick("annotationLanguage",
           int(f.rowsOf("annotationLanguage").indexOf(QStringLiteral("German / Latin"))));
    QCOMPARE(f.shownLines().join(' ').replace('/', ' ').simplified(),
             QStringLiteral("Harnblase vesica urinaria"));
    QCOMPARE(f.list().model()->headerData(1, Qt::Horizontal).toString(),
             QStringLiteral("Says (German)"));
  }

  /// Wherever words are typed stands the language that they are for.
  void fieldsSayTheLanguage() {
    LabelsPanelFixture f;
    f.window.preferences().set("language/structures", "de");
    f.make(f.liver, {});
    f.open();
    f.choose(0);
    const auto* said = f.words().findChild<QLabel*>(QStringLiteral("labelLanguage"));
    const auto heading = [&f] {
      return f.list().model()->headerData(1, Qt::Horizontal).toString();
    };
    QVERIFY(said && said->isVisible());
    QCOMPARE(said->text(), QStringLiteral("German"));
    QCOMPARE(heading(), QStringLiteral("Says (German)"));
    f.words().setFocus();
    f.words().selectAll();
    QTest::keyClicks(&f.words(), QStringLiteral("Leberlein"));
    QCOMPARE(f.only().texts.at("de"), std::string("Leberlein"));
    QCOMPARE(f.only().text, std::string("liver"));
    // No word reaches under it.
    QVERIFY(f.words().viewport()->geometry().right() < said->geometry().left());
    f.window.preferences().set("labels/language", "la");
    QCOMPARE(said->text(), QStringLiteral("Latin"));
    QCOMPARE(heading(), QStringLiteral("Says (Latin)"));
    f.window.preferences().set("labels/language", "scene");
    QCOMPARE(said->text(), QStringLiteral("The scene's own"));
    QCOMPARE(heading(), QStringLiteral("Says (scene’s own)"));
    QTest::keyClicks(&f.words(), QStringLiteral("s"));
    QCOMPARE(f.only().texts.at("de"), std::string("Leberlein"));
    // So it is where the label stands.
    f.window.preferences().set("labels/language", "de");
    QVERIFY(f.settled());
    QTest::mouseDClick(&f.viewport(), Qt::LeftButton, {}, f.textAt(f.only().id));
    QVERIFY(f.typing());
    const auto* there = f.editor().findChild<QLabel*>(QStringLiteral("labelLanguage"));
    QVERIFY(there->isVisible());
    QCOMPARE(there->text(), QStringLiteral("German"));
    QVERIFY(f.editor().viewport()->geometry().right() < there->geometry().left());
    QTest::keyClick(&f.editor(), Qt::Key_Escape);
  }

  void wordsAreWrittenHere() {
    LabelsPanelFixture f;
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
    LabelsPanelFixture f;
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
    LabelsPanelFixture f;
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
    LabelsPanelFixture f;
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
    LabelsPanelFixture f;
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

  void howTheyAreShown() {
    LabelsPanelFixture f;
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
    LabelsPanelFixture f;
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

  /// Where not all find room the message says how many do not, and what one sees most of has its
  /// name.
  void tooManyAreLabelled() {
    WindowFixture f;
    constexpr int count = 80;
    f.session.openMade(QStringLiteral("Many"), [](const auto&, const auto&) {
      model::Scene scene;
      model::Style style;
      style.fill = model::Fill::paper;
      for (int i = 0; i < count; ++i) {
        const float size = i == count - 1 ? 12.0f : 2.0f;
        scene.append({.name = "part " + std::to_string(i),
                      .style = style,
                      .mesh = moved(*sphere(size, 2), 1.0f,
                                    {30.0f * float(i % 4), 0.0f, 5.0f * float(i / 4)})});
      }
      return Result<widgets::LoadedDocument>(
          widgets::LoadedDocument{.scene = std::move(scene), .title = QStringLiteral("Many")});
    });
    QVERIFY(f.settled());
    QTest::keyClick(&f.viewport(), Qt::Key_A);
    QVERIFY(f.settled());
    const widgets::NodeIds all = f.session.scene().structuresBelow(model::rootId);
    f.session.select(all);
    QTest::keyClick(&f.viewport(), Qt::Key_T, Qt::ControlModifier);
    QTRY_COMPARE(f.session.scene().annotations().size(), std::size_t(count));
    QTRY_VERIFY(f.window.statusBar()->currentMessage().contains("no room"));
    const render::LabelLayout& layout = f.viewport().labels().layer().sheet()->plate.layout;
    QVERIFY(!layout.leftOut.empty());
    QVERIFY(f.window.statusBar()->currentMessage().contains(
        QStringLiteral("; %1 ").arg(layout.leftOut.size())));
    QVERIFY2(layout.find(f.session.scene().annotations().back().id),
             "the largest part of all has no label");
  }

  /// Points that a file has in space, and texts of all kinds, are listed.
  void pointsInSpaceAreListed() {
    LabelsPanelFixture f;
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
