// SPDX-License-Identifier: Apache-2.0
// Tests that a hand changes nothing by the way: the wheel, Ctrl+Z and clicks beside a handle, with
// events that take the way of a real mouse and keyboard.
#include <QtTest/qtestspontaneevent.h>
#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QCursor>
#include <QDialog>
#include <QDockWidget>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QToolTip>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <QtTest>
#include <cmath>

#include "model/edit/look.h"
#include "tests/gui/gamma_fixture.h"
#include "tests/support/suite.h"
#include "widgets/form/control.h"
#include "widgets/gamma/style_slider.h"
#include "widgets/structure_tree/cell_painting.h"
#include "widgets/structure_tree/structure_tree_model.h"

namespace sline::test {

namespace {

/// Turns the wheel as the window system does: the window passes it on to what lies under the mouse.
void turnWheel(QWidget& widget, int notches) {
  QWidget* window = widget.window();
  const QPoint at = widget.mapTo(window, widget.rect().center());
  QWheelEvent event(at, window->mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton,
                    Qt::NoModifier, Qt::NoScrollPhase, false);
  QSpontaneKeyEvent::setSpontaneous(&event);
  qApp->notify(window->windowHandle(), &event);
}

void clickOn(QWidget& widget, const QPoint& at, Qt::KeyboardModifiers keys = {}) {
  QWidget* window = widget.window();
  QTest::mouseClick(window->windowHandle(), Qt::LeftButton, keys, widget.mapTo(window, at));
}

void pressKey(Qt::Key key, Qt::KeyboardModifiers keys = {}) {
  QTest::keyClick(QApplication::focusWidget(), key, keys);
}

void setKidneysAndBladder(GammaPanelFixture& f, float left, float right, float bladder) {
  for (const auto& [name, gamma] :
       {std::pair("left kidney", left), {"right kidney", right}, {"bladder", bladder}}) {
    const model::NodeId id = f.named(name);
    f.session.apply("set",
                    model::withLook(f.session.scene(), {&id, 1}, {.gamma = Gamma::clamped(gamma)}));
  }
}

QString kidneysAndBladder(GammaPanelFixture& f) {
  QStringList values;
  for (const char* name : {"left kidney", "right kidney", "bladder"})
    values << QString::number(double(f.gammaOf(name)), 'f', 2);
  return values.join(' ');
}

/// A dialog with each kind of control in a scroll area.
struct Form {
  QDialog dialog;
  QScrollArea* area = new QScrollArea;
  QList<QWidget*> controls;
  explicit Form(QWidget& parent) : dialog(&parent) {
    auto* content = new QWidget;
    auto* rows = new QVBoxLayout(content);
    auto* box = new QComboBox;
    box->addItems({"a", "b", "c", "d", "e"});
    box->setCurrentIndex(2);
    auto* spin = new QDoubleSpinBox;
    spin->setValue(20.0);
    auto* slider = new QSlider(Qt::Horizontal);
    slider->setValue(20);
    controls = {box, spin, slider};
    for (QWidget* control : controls)
      rows->addWidget(control);
    for (int i = 0; i < 30; ++i)
      rows->addWidget(new QPushButton(QString::number(i)));
    area->setWidget(content);
    area->verticalScrollBar()->setSingleStep(1);  // so that all stays under the mouse
    auto* layout = new QVBoxLayout(&dialog);
    layout->addWidget(area);
    dialog.resize(300, 240);
    dialog.open();
    if (!QTest::qWaitForWindowExposed(&dialog))
      qFatal("the dialog does not show");
    QApplication::setActiveWindow(&dialog);
  }
  static double valueOf(const QWidget* control) {
    if (const auto* box = qobject_cast<const QComboBox*>(control))
      return box->currentIndex();
    if (const auto* spin = qobject_cast<const QDoubleSpinBox*>(control))
      return spin->value();
    return qobject_cast<const QSlider*>(control)->value();
  }
  int scrolled() const { return area->verticalScrollBar()->value(); }
};

}  // namespace

class SafeHandsTest : public QObject {
  Q_OBJECT

 private slots:
  void wheelScrollsWhatWasNotClicked_data() {
    QTest::addColumn<int>("which");
    QTest::newRow("choices") << 0;
    QTest::newRow("number") << 1;
    QTest::newRow("slider") << 2;
  }
  void wheelScrollsWhatWasNotClicked() {
    QFETCH(int, which);
    WindowFixture f;
    Form form(f.window);
    QWidget& control = *form.controls[which];
    const double before = Form::valueOf(&control);
    turnWheel(control, -1);
    QCOMPARE(Form::valueOf(&control), before);
    QVERIFY(form.scrolled() > 0);
    QVERIFY2(!control.hasFocus(), "the wheel takes no keyboard");
    form.area->verticalScrollBar()->setValue(0);
    // The keyboard alone is no wish to turn it either.
    control.setFocus(Qt::TabFocusReason);
    turnWheel(control, -1);
    QCOMPARE(Form::valueOf(&control), before);
    QVERIFY(form.scrolled() > 0);
    form.area->verticalScrollBar()->setValue(0);
    // Once it is clicked the wheel is its own, until the keyboard goes elsewhere.
    clickOn(control, {8, control.height() / 2});
    if (QWidget* list = QApplication::activePopupWidget())
      list->close();
    QVERIFY(control.hasFocus());
    const double clicked = Form::valueOf(&control);
    turnWheel(control, -1);
    QVERIFY(Form::valueOf(&control) != clicked);
    QCOMPARE(form.scrolled(), 0);
    const double turned = Form::valueOf(&control);
    // A wheel that scrolls does so until it rests, whatever comes under the mouse.
    turnWheel(*form.area->findChild<QPushButton*>(), -1);
    const int there = form.scrolled();
    turnWheel(control, -1);
    QVERIFY(form.scrolled() > there);
    QCOMPARE(Form::valueOf(&control), turned);
    QTest::qWait(600);
    turnWheel(control, 1);
    QVERIFY(Form::valueOf(&control) != turned);
    const double last = Form::valueOf(&control);
    form.controls[(which + 1) % 3]->setFocus(Qt::TabFocusReason);
    control.setFocus(Qt::BacktabFocusReason);
    form.area->verticalScrollBar()->setValue(0);
    turnWheel(control, -1);
    QCOMPARE(Form::valueOf(&control), last);
    QVERIFY(form.scrolled() > 0);
  }

  void wheelInThePanel() {
    GammaPanelFixture f;
    f.session.select({f.named("bladder")});
    f.unfold();
    const model::Scene before = f.session.scene();
    auto& area = f.control<QScrollArea>("gammaScroll");
    for (const char* name : {"gammaSlider", "gammaNumber", "penWeightSlider", "penWeightNumber",
                             "hiddenLinesChoice"}) {
      auto& control = f.control<QWidget>(name);
      area.ensureWidgetVisible(&control);
      QScrollBar& bar = *area.verticalScrollBar();
      const int there = bar.value();
      turnWheel(control, there > bar.maximum() / 2 ? 1 : -1);
      QVERIFY2(bar.value() != there, name);
      QVERIFY2(f.session.scene() == before, name);
    }
  }

  void undoIsTheScenesOwn_data() {
    QTest::addColumn<QByteArray>("control");
    for (const char* name : {"gammaNumber", "gammaSlider", "structureTree", "hiddenLinesChoice",
                             "penWeightNumber", "historyPanel"})
      QTest::newRow(name) << QByteArray(name);
  }
  void undoIsTheScenesOwn() {
    QFETCH(QByteArray, control);
    GammaPanelFixture f;
    f.session.select({f.named("bladder")});
    f.unfold();
    f.control<QDockWidget>("historyPanel").show();
    const model::Scene before = f.session.scene();
    f.click(f.stage(4));
    QVERIFY(!(f.session.scene() == before));
    auto* widget = &f.control<QWidget>(control.constData());
    if (auto* dock = qobject_cast<QDockWidget*>(widget))
      widget = dock->findChild<QAbstractItemView*>();
    widget->setFocus(Qt::MouseFocusReason);
    QVERIFY(widget->hasFocus());
    pressKey(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(f.session.scene() == before);
    pressKey(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(!(f.session.scene() == before));
  }

  /// What is being typed is taken back first, and nothing else with it.
  void typedTextIsTakenBackFirst() {
    GammaPanelFixture f;
    f.session.select({f.named("bladder")});
    f.click(f.stage(4));
    const model::Scene four = f.session.scene();
    auto& filter = f.control<QLineEdit>("structureFilter");
    filter.setFocus();
    QTest::keyClicks(&filter, "kid");
    pressKey(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(filter.text().isEmpty());
    QVERIFY(f.session.scene() == four);
    // A number that is half typed comes back, and is no choice when the box is left.
    f.session.select({f.named("bladder"), f.named("aorta")});
    QVERIFY(f.number().isMixed());
    f.number().setFocus();
    f.number().selectAll();
    QTest::keyClicks(&f.number(), "3");
    pressKey(Qt::Key_Z, Qt::ControlModifier);
    f.slider().setFocus();
    QVERIFY(f.session.scene() == four);
    QVERIFY(f.number().isMixed());
    // One that was entered is the scene's.
    f.number().setFocus();
    f.number().selectAll();
    QTest::keyClicks(&f.number(), QLocale().toString(3.25, 'f', 2));
    pressKey(Qt::Key_Return);
    QCOMPARE(f.gammaOf("aorta"), 3.25f);
    pressKey(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(f.session.scene() == four);
  }

  /// From a window beside, too; one that asks keeps its keys.
  void undoFromOtherWindows() {
    GammaPanelFixture f;
    f.session.select({f.named("bladder")});
    const model::Scene before = f.session.scene();
    f.click(f.stage(4));
    QDialog beside(&f.window);
    auto* line = new QLineEdit(&beside);
    beside.show();
    QVERIFY(QTest::qWaitForWindowExposed(&beside));
    QApplication::setActiveWindow(&beside);
    line->setFocus();
    pressKey(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(f.session.scene() == before);
    beside.hide();
    f.session.redo();
    const model::Scene four = f.session.scene();
    Form asks(f.window);
    asks.controls[1]->setFocus();
    pressKey(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(f.session.scene() == four);
  }

  void undoSaysWhat() {
    GammaPanelFixture f;
    f.session.select({f.named("bladder")});
    f.click(f.stage(4));
    const auto& undo = f.control<QAction>("undo");
    const auto& redo = f.control<QAction>("redo");
    QVERIFY(undo.text().contains("Γ of bladder") && undo.toolTip().contains("Γ of bladder"));
    f.session.undo();
    QVERIFY(!undo.toolTip().contains("bladder"));
    QVERIFY(redo.text().contains("Γ of bladder") && redo.toolTip().contains("Γ of bladder"));
  }

  /// Beside a group's handle, in the list: what is in it keeps its differences.
  void besideAGroupsHandle() {
    GammaPanelFixture f;
    setKidneysAndBladder(f, 1.0f, 2.0f, 3.0f);
    const model::Scene before = f.session.scene();
    const model::NodeId group = f.named("Organs");
    const auto click = [&](float gamma, Qt::KeyboardModifiers keys) {
      f.tree().scrollTo(f.tree().indexOf(group));
      const widgets::GammaCell cell{
          QRectF(f.tree().cellOf(group, widgets::StructureTreeModel::gamma))};
      const double x = cell.xOf(Gamma::clamped(gamma));
      clickOn(*f.tree().viewport(), QPointF(x, cell.groove().center().y()).toPoint(), keys);
    };
    click(3.0f, {});
    QCOMPARE(kidneysAndBladder(f), "2.00 3.00 4.00");
    f.session.undo();
    click(4.9f, {});  // no further than the first of them can go
    QCOMPARE(kidneysAndBladder(f), "3.00 4.00 5.00");
    QTRY_VERIFY(QToolTip::text().contains("Shift"));
    f.session.undo();
    click(3.0f, Qt::ShiftModifier);
    QCOMPARE(kidneysAndBladder(f), "3.00 3.00 3.00");
    f.session.undo();
    QVERIFY(f.session.scene() == before);
  }

  /// The same in the panel, by keys and by the box's arrows, too.
  void besideTheLargeHandle() {
    GammaPanelFixture f;
    setKidneysAndBladder(f, 1.0f, 2.0f, 3.0f);
    const model::Scene before = f.session.scene();
    f.session.select({f.named("Organs")});
    const auto click = [&](Qt::KeyboardModifiers keys) {
      clickOn(f.slider(), f.slider().pointOf(Gamma::clamped(1.5f)).toPoint(), keys);
    };
    const auto apart = [&] {
      return std::abs(f.gammaOf("bladder") - f.gammaOf("right kidney") - 1.0f) < 1e-3f &&
             std::abs(f.gammaOf("right kidney") - f.gammaOf("left kidney") - 1.0f) < 1e-3f;
    };
    click({});
    QVERIFY(std::abs(f.gammaOf("right kidney") - 1.5f) < 0.03f && apart());
    f.session.undo();
    click(Qt::ShiftModifier);
    QVERIFY(std::abs(f.gammaOf("bladder") - 1.5f) < 0.03f);
    QCOMPARE(f.gammaOf("bladder"), f.gammaOf("left kidney"));
    f.session.undo();
    f.slider().setFocus();
    pressKey(Qt::Key_Up);
    QCOMPARE(kidneysAndBladder(f), "1.05 2.05 3.05");
    f.session.undo();
    f.number().setFocus();
    pressKey(Qt::Key_Down);
    pressKey(Qt::Key_Down);
    QCOMPARE(kidneysAndBladder(f), "0.90 1.90 2.90");
    f.session.undo();
    QVERIFY(f.session.scene() == before);
  }

  /// The other numbers of a style follow the same rule.
  void besideAWidthsHandle() {
    GammaPanelFixture f;
    const model::NodeId bladder = f.named("bladder");
    f.session.apply("set", model::withLook(f.session.scene(), {&bladder, 1}, {.penWeight = 2.0f}));
    f.session.select({f.named("Organs")});
    f.unfold();
    auto& slider = f.control<widgets::StyleSlider>("penWeightSlider");
    f.control<QScrollArea>("gammaScroll").ensureWidgetVisible(&slider);
    QCOMPARE(slider.middle(), 1.5);
    const auto width = [&](const char* name) {
      return f.session.scene().resolve(f.named(name)).penWeight;
    };
    clickOn(slider, slider.pointOf(2.5).toPoint());
    QVERIFY(std::abs(width("bladder") - width("left kidney") - 1.0f) < 1e-3f);
    QVERIFY(std::abs(width("bladder") - 3.0f) < 0.2f);
    f.session.undo();
    clickOn(slider, slider.pointOf(2.5).toPoint(), Qt::ShiftModifier);
    QCOMPARE(width("bladder"), width("left kidney"));
  }

  /// A line that is full says so, wherever what it refuses comes from; so does a box of lines.
  void refusedTextIsSaid() {
    GammaPanelFixture f;
    const auto said = [] { return QToolTip::isVisible() ? QToolTip::text() : QString(); };
    QDialog dialog(&f.window);
    auto* layout = new QVBoxLayout(&dialog);
    auto* line = new QLineEdit;
    line->setMaxLength(5);
    const widgets::Field lines{QStringLiteral("lines"), QStringLiteral("Lines"), QString(),
                               widgets::TextField{.longest = 7, .lines = 3}};
    auto* box = qobject_cast<QPlainTextEdit*>(widgets::makeControl(lines, [](const QVariant&) {}));
    layout->addWidget(line);
    layout->addWidget(box);
    dialog.show();
    QVERIFY(QTest::qWaitForWindowActive(&dialog));
    QCursor::setPos(dialog.mapToGlobal(dialog.rect().center()));
    line->setFocus();
    QTest::keyClicks(line, "abcde");
    QCoreApplication::processEvents();
    QVERIFY2(said().isEmpty(), "what has room needs no word");
    QTest::keyClicks(line, "f");
    QCOMPARE(line->text(), QString("abcde"));
    QTRY_VERIFY2(said().contains("5"), qPrintable(said()));
    QToolTip::hideText();
    QTRY_VERIFY(said().isEmpty());
    line->clear();
    QGuiApplication::clipboard()->setText("a long text");
    QTest::keySequence(line, QKeySequence::Paste);
    QCOMPARE(line->text(), QString("a lon"));
    QTRY_VERIFY2(said().contains("5"), qPrintable(said()));
    QToolTip::hideText();
    QTRY_VERIFY(said().isEmpty());
    box->setFocus();
    box->paste();
    QCOMPARE(box->toPlainText(), QString("a long "));
    QTRY_VERIFY2(said().contains("7"), qPrintable(said()));
    // What was there before stays.
    box->moveCursor(QTextCursor::Start);
    QTest::keyClicks(box, "xy");
    QCOMPARE(box->toPlainText(), QString("a long "));
  }

  void refusedNumbersAreSaid() {
    GammaPanelFixture f;
    f.session.select({f.named("bladder")});
    const float before = f.gammaOf("bladder");
    const auto said = [] { return QToolTip::isVisible() ? QToolTip::text() : QString(); };
    f.number().setFocus();
    f.number().selectAll();
    QTest::keyClicks(&f.number(), "7");
    QTRY_VERIFY(said().contains("0.00") && said().contains("5.00"));
    QCOMPARE(f.gammaOf("bladder"), before);
    QToolTip::hideText();
    QTRY_VERIFY(said().isEmpty());
    QTest::keyClicks(&f.number(), "4");
    pressKey(Qt::Key_Return);
    QCOMPARE(f.gammaOf("bladder"), 4.0f);
    QCoreApplication::processEvents();
    QVERIFY2(said().isEmpty(), "a number that is taken needs no word");
    // One that the box corrects when it is left, in any dialog.
    Form form(f.window);
    auto& spin = *qobject_cast<QDoubleSpinBox*>(form.controls[1]);
    spin.setRange(10.0, 50.0);
    // A window that becomes the active one hides what is said, and so does a mouse beside it.
    QVERIFY(QTest::qWaitForWindowActive(&form.dialog));
    QCursor::setPos(spin.mapToGlobal(spin.rect().center()));
    QTest::qWait(50);
    spin.setFocus();
    QTRY_VERIFY(spin.hasFocus());
    spin.selectAll();
    QTest::keyClicks(&spin, "3");
    form.controls[2]->setFocus();
    QTRY_VERIFY(said().contains("10.00") && said().contains("50.00"));
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::SafeHandsTest)
#include "safe_hands_test.moc"
