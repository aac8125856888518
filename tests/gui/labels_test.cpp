// SPDX-License-Identifier: Apache-2.0
// Tests labels in the picture: made, moved and removed by mouse and keys.
#include <QAbstractItemView>
#include <QApplication>
#include <QStatusBar>
#include <QStatusTipEvent>
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/gui/labels_fixture.h"
#include "tests/support/suite.h"

namespace sline::test {

using model::AnnotationKind;

class LabelsTest : public QObject {
  Q_OBJECT

 private slots:
  void eachKindIsMade_data() {
    QTest::addColumn<int>("key");
    QTest::addColumn<int>("keys");
    QTest::addColumn<int>("kind");
    QTest::addColumn<QString>("step");
    const auto shift = int(Qt::ShiftModifier);
    QTest::newRow("label") << int(Qt::Key_T) << 0 << int(AnnotationKind::label) << "Add Label";
    QTest::newRow("callout") << int(Qt::Key_T) << shift << int(AnnotationKind::callout)
                             << "Add Callout";
    QTest::newRow("pin") << int(Qt::Key_P) << shift << int(AnnotationKind::pin) << "Add Pin";
  }
  void eachKindIsMade() {
    QFETCH(int, key);
    QFETCH(int, keys);
    QFETCH(int, kind);
    QFETCH(QString, step);
    Labels f;
    const int before = f.steps();
    f.key(Qt::Key(key), Qt::KeyboardModifiers(keys));
    f.click(f.middleOf(f.bladder));
    QVERIFY(f.typing());
    // The structure's name is offered, and gone with the first letter.
    QCOMPARE(f.editor().toPlainText(), QStringLiteral("bladder"));
    QCOMPARE(f.editor().textCursor().selectedText(), QStringLiteral("bladder"));
    QVERIFY(f.annotations().empty());
    QVERIFY(f.labels().layer().marks().begun);
    QTest::keyClick(&f.editor(), Qt::Key_Return);
    QVERIFY(!f.editor().isOpen());
    QVERIFY(!f.labels().layer().marks().begun);
    QCOMPARE(int(f.only().kind), kind);
    QVERIFY(f.structureOf(f.only()) == f.bladder);
    QCOMPARE(f.only().text, std::string("bladder"));
    QCOMPARE(f.step(), step);
    QCOMPARE(f.steps(), before + 1);
    QVERIFY(f.session.activeAnnotation() == f.only().id);
    // The label's place is where the click was.
    const QPoint away = f.placeAt(f.only().id) - f.middleOf(f.bladder);
    QVERIFY(away.manhattanLength() <= 3);
    // The next label gets words of its own; the tool is still in hand.
    f.click(f.middleOf(f.liver));
    QVERIFY(f.typing());
    QTest::keyClicks(&f.editor(), QStringLiteral("my own"));
    QTest::keyClick(&f.editor(), Qt::Key_Return);
    QCOMPARE(f.annotations().size(), std::size_t(2));
    QCOMPARE(f.annotations().back().text, std::string("my own"));
    QVERIFY(f.annotations().back().texts.empty());
    f.undo();
    QCOMPARE(f.annotations().size(), std::size_t(1));
    f.redo();
    QCOMPARE(f.annotations().size(), std::size_t(2));
    f.key(Qt::Key_Escape);
    QVERIFY(!f.labels().making());
    f.click(f.middleOf(f.liver));
    QTRY_COMPARE(f.session.selection(), widgets::NodeIds{f.liver});
  }

  /// A key takes the tool up, whatever was in hand; Esc puts it away, and so does the menu.
  /// Through a thin veil one sees, and names, what is behind it.
  void clicksNameWhatOneSees_data() {
    QTest::addColumn<int>("key");
    QTest::addColumn<int>("keys");
    QTest::addColumn<float>("opacity");
    QTest::addColumn<QString>("name");
    const auto shift = int(Qt::ShiftModifier);
    QTest::newRow("label, thin") << int(Qt::Key_T) << 0 << 0.5f << "bladder";
    QTest::newRow("label, solid") << int(Qt::Key_T) << 0 << 1.0f << "skin";
    QTest::newRow("callout, thin") << int(Qt::Key_T) << shift << 0.5f << "bladder";
  }
  void clicksNameWhatOneSees() {
    QFETCH(int, key);
    QFETCH(int, keys);
    QFETCH(float, opacity);
    QFETCH(QString, name);
    Labels f;
    model::Scene scene = f.session.scene();
    const model::Style veil{.gamma = Gamma::clamped(0.0f),
                            .opacity = Opacity::clamped(opacity),
                            .fill = opacity < 1.0f ? model::Fill::veil : model::Fill::paper};
    scene.append({.name = "skin", .style = veil, .mesh = sphere(80, 3)});
    f.session.apply("skin", {scene, true});
    QVERIFY(f.settled());
    f.key(Qt::Key(key), Qt::KeyboardModifiers(keys));
    f.click(f.middleOf(f.bladder) + QPoint(9, 7));
    QVERIFY(f.typing());
    QCOMPARE(f.editor().toPlainText(), name);
    QTest::keyClick(&f.editor(), Qt::Key_Return);
    QCOMPARE(f.session.scene().find(f.structureOf(f.only()))->name, name.toStdString());
  }

  void keysTakeToolsUp() {
    Labels f;
    f.session.select({f.liver});
    for (int i = 0; i < 3; ++i) {
      f.key(Qt::Key_T);
      QVERIFY(f.labels().making() == AnnotationKind::label);
      QVERIFY(f.control<QAction>("annotateLabel").isChecked());
    }
    f.key(Qt::Key_M);
    QVERIFY(f.labels().making() == AnnotationKind::distance);
    f.key(Qt::Key_M);
    QVERIFY(f.labels().making() == AnnotationKind::distance);
    f.key(Qt::Key_T);
    QVERIFY(f.labels().making() == AnnotationKind::label);
    f.key(Qt::Key_Escape);
    QVERIFY(!f.labels().making());
    f.key(Qt::Key_T);
    f.control<QAction>("annotateLabel").trigger();
    QVERIFY(!f.labels().making());
  }

  /// The hint how to go on is shown as long as the tool is in hand, whatever else is shown
  /// meanwhile.
  void hintsStay() {
    Labels f;
    QStatusBar& bar = *f.window.statusBar();
    f.key(Qt::Key_M);
    const QString hint = bar.currentMessage();
    QVERIFY2(hint.contains("two places"), qPrintable(hint));
    QStatusTipEvent passed{QString()};
    QApplication::sendEvent(&f.window, &passed);
    QCOMPARE(bar.currentMessage(), hint);
    f.click(f.middleOf(f.liver));
    QTRY_VERIFY(f.labels().layer().marks().begun);
    f.click({8, 300});
    QTRY_VERIFY2(bar.currentMessage().contains("Nothing is there"),
                 qPrintable(bar.currentMessage()));
    QVERIFY(f.labels().layer().marks().begun);
    bar.clearMessage();
    QCOMPARE(bar.currentMessage(), hint);
    f.key(Qt::Key_Escape);
    f.key(Qt::Key_Escape);
    QCOMPARE(bar.currentMessage(), QString());
    // Clearing the hint removes no other message.
    f.key(Qt::Key_M);
    bar.showMessage(QStringLiteral("something else"));
    f.key(Qt::Key_Escape);
    QCOMPARE(bar.currentMessage(), QStringLiteral("something else"));
  }

  void distancesHaveTwoPlaces() {
    Labels f;
    f.key(Qt::Key_M);
    f.click(f.middleOf(f.liver));
    QTRY_VERIFY(f.labels().layer().marks().begun);
    QVERIFY(f.annotations().empty());
    f.key(Qt::Key_Escape);  // gives up that place
    QVERIFY(!f.labels().layer().marks().begun);
    QVERIFY(f.labels().making());
    f.click(f.middleOf(f.liver));
    QTRY_VERIFY(f.labels().layer().marks().begun);
    f.click(f.middleOf(f.bladder));
    QTRY_COMPARE(f.annotations().size(), std::size_t(1));
    QCOMPARE(f.step(), QStringLiteral("Add Distance"));
    const auto& list = f.control<QAbstractItemView>("annotationList");
    QVERIFY(list.model()->index(0, 1).data().toString().endsWith(QStringLiteral(" mm")));
    QVERIFY(f.structureOf(f.only(), 0) == f.liver);
    QVERIFY(f.structureOf(f.only(), 1) == f.bladder);
    // The length is that between the places clicked, whatever the view.
    const auto place = [&f](std::size_t i) {
      return *f.session.scene().placeOf(f.only().anchors[i]);
    };
    const float length = glm::length(place(1) - place(0));
    QVERIFY(length > 50.0f && length < 60.0f);
    QCOMPARE(f.shownLines(), QStringList{QStringLiteral("%1\u00a0mm").arg(std::lround(length))});
    QCOMPARE(list.model()->index(0, 1).data().toString(), f.shownLines().front().simplified());
    f.undo();
    QVERIFY(f.annotations().empty());
  }

  void textsAreMovedByHand() {
    Labels f;
    f.make(f.liver, {});
    const model::AnnotationId id = f.only().id;
    const int before = f.steps();
    const QPoint from = f.textAt(id);
    const QPoint to = from + QPoint(40, 90);
    dragMouse(f.viewport(), from, to);
    QCOMPARE(f.step(), QStringLiteral("Move Label"));
    QCOMPARE(f.steps(), before + 1);
    QVERIFY(f.only().offset);
    QVERIFY((f.textAt(id) - to).manhattanLength() <= 2);
    // The text moves along with its place.
    const QPoint beside = f.textAt(id) - f.placeAt(id);
    dragMouse(f.viewport(), {300, 60}, {330, 80}, Qt::MiddleButton);
    QVERIFY(((f.textAt(id) - f.placeAt(id)) - beside).manhattanLength() <= 2);
    f.undo();
    QVERIFY(!f.only().offset);
    f.redo();
    QVERIFY(f.only().offset);
  }

  void escapePutsItBack() {
    Labels f;
    f.make(f.liver, {});
    const model::Annotation was = f.only();
    const int before = f.steps();
    for (const QPoint from : {f.textAt(was.id), f.placeAt(was.id)}) {
      sendMouse(f.viewport(), QEvent::MouseButtonPress, from);
      for (const int step : {8, 20, 40})
        sendMouse(f.viewport(), QEvent::MouseMove, from + QPoint(step, step));
      QTRY_VERIFY(f.session.previewing());
      f.key(Qt::Key_Escape);
      QVERIFY(!f.session.previewing());
      sendMouse(f.viewport(), QEvent::MouseButtonRelease, from + QPoint(40, 40));
      QVERIFY(f.settled());
      QVERIFY(f.only() == was);
      QCOMPARE(f.steps(), before);
    }
  }

  void placesAreMovedOverSurfaces() {
    Labels f;
    f.make(f.liver, {});
    const model::AnnotationId id = f.only().id;
    const int before = f.steps();
    dragMouse(f.viewport(), f.placeAt(id), f.middleOf(f.bladder));
    QTRY_VERIFY(f.structureOf(f.only()) == f.bladder);
    QTRY_COMPARE(f.steps(), before + 1);
    QVERIFY((f.placeAt(id) - f.middleOf(f.bladder)).manhattanLength() <= 3);
    QCOMPARE(f.only().text, std::string("liver"));
    f.undo();
    QVERIFY(f.structureOf(f.only()) == f.liver);
    // Beside all surfaces the place stays on the last one.
    dragMouse(f.viewport(), f.placeAt(id), {8, 300});
    QVERIFY(f.settled());
    QTRY_VERIFY(!f.session.previewing());
    QVERIFY(f.structureOf(f.only()) == f.liver);
  }

  void lockedOnesStay() {
    Labels f;
    f.make(f.liver, {});
    f.change([](model::Annotation& annotation) { annotation.locked = true; });
    const model::Annotation was = f.only();
    const model::Camera camera = f.viewport().camera();
    const int before = f.steps();
    dragMouse(f.viewport(), f.textAt(was.id), f.textAt(was.id) + QPoint(50, 50));
    dragMouse(f.viewport(), f.placeAt(was.id), f.middleOf(f.bladder));
    QVERIFY(f.settled());
    QVERIFY(f.only() == was);
    QCOMPARE(f.steps(), before);
    QVERIFY(f.viewport().camera() == camera);
  }

  /// Del removes what was chosen last.
  void delTakesTheChosenAway() {
    Labels f;
    f.click(f.middleOf(f.bladder));
    QTRY_COMPARE(f.session.selection(), widgets::NodeIds{f.bladder});
    f.make(f.liver, {});
    const model::AnnotationId id = f.only().id;
    f.click({8, 300});
    QTRY_VERIFY(!f.session.activeAnnotation());
    f.click(f.textAt(id));
    QVERIFY(f.session.activeAnnotation() == id);
    f.key(Qt::Key_Delete);
    QVERIFY(f.annotations().empty());
    QCOMPARE(f.session.scene().nodes().size(), std::size_t(2));
    QCOMPARE(f.step(), QStringLiteral("Delete Label"));
    f.undo();
    QCOMPARE(f.annotations().size(), std::size_t(1));
    f.click(f.middleOf(f.bladder));
    QTRY_COMPARE(f.session.selection(), widgets::NodeIds{f.bladder});
    QVERIFY(!f.session.activeAnnotation());
    f.key(Qt::Key_Delete);
    QCOMPARE(f.session.scene().nodes().size(), std::size_t(1));
  }

  void hoverShowsWhatCanBeTaken() {
    Labels f;
    f.make(f.liver, {});
    const model::AnnotationId id = f.only().id;
    const QPoint at = f.textAt(id);
    sendMouse(f.viewport(), QEvent::MouseMove, {8, 300}, Qt::NoButton);
    QVERIFY(!f.labels().layer().marks().hovered);
    QCOMPARE(f.viewport().cursor().shape(), Qt::ArrowCursor);
    sendMouse(f.viewport(), QEvent::MouseMove, at, Qt::NoButton);
    QVERIFY(f.labels().layer().marks().hovered == id);
    QCOMPARE(f.viewport().cursor().shape(), Qt::OpenHandCursor);
  }

  /// Another scene in the document's place shows its labels, but they cannot be edited.
  void shutWhileSomethingElseIsShown() {
    Labels f;
    f.make(f.liver, {});
    const QPoint at = f.textAt(f.only().id);
    f.session.activateAnnotation(std::nullopt);
    f.viewport().showInstead(f.session.scene());
    QVERIFY(f.settled());
    QVERIFY(f.labels().layer().sheet());
    f.click(at);
    QVERIFY(!f.session.activeAnnotation());
    QTest::mouseDClick(&f.viewport(), Qt::LeftButton, {}, at);
    QVERIFY(!f.editor().isOpen());
    f.viewport().showInstead({});
    QVERIFY(f.settled());
    f.click(at);
    QVERIFY(f.session.activeAnnotation());
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::LabelsTest)
#include "labels_test.moc"
