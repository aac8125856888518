// SPDX-License-Identifier: Apache-2.0
// Tests styles on their way from one structure to others, by keys and clicks as a hand makes them.
#include <QAction>
#include <QClipboard>
#include <QColorDialog>
#include <QDockWidget>
#include <QListWidget>
#include <QMenu>
#include <QToolButton>
#include <QtTest>

#include "model/base/contrast.h"
#include "model/edit/look.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/suite.h"
#include "widgets/structure_tree/structure_tree_model.h"

namespace sline::test {

class StylesTravelTest : public QObject {
  Q_OBJECT

  struct Bench {
    WindowFixture f;
    QTemporaryDir body;
    Bench() {
      writeBody(body.path());
      if (!f.drop(body.path()) || !f.settled())
        qFatal("no picture");
    }
    model::NodeId named(const char* name) { return f.session.scene().named(name).front(); }
    model::Style look(const char* name) { return model::lookOf(f.session.scene(), named(name)); }
    int steps() { return f.session.history().index(); }
    /// Gives the aorta a look unlike all others.
    void dressAorta() {
      const model::NodeId id = named("aorta");
      model::Style style{.colour = Colour{9, 120, 30}, .gamma = Gamma::clamped(1.3f)};
      style.penWeight = 2.5f;
      style.fill = model::Fill::veil;
      style.opacity = Opacity::clamped(0.7f);
      f.session.apply("look", model::withLook(f.session.scene(), {&id, 1}, style));
    }
    void press(Qt::Key key, Qt::KeyboardModifiers keys) { QTest::keyClick(&f.window, key, keys); }
    void clickRow(const char* name) {
      f.tree().scrollTo(f.tree().indexOf(named(name)));
      QTest::mouseClick(f.tree().viewport(), Qt::LeftButton, {},
                        f.tree().cellOf(named(name), widgets::StructureTreeModel::name).center());
    }
  };

 private slots:
  void copiedAndPasted() {
    Bench b;
    b.dressAorta();
    const model::NodeId bladder = b.named("bladder");
    model::Style inked{.inkColour = Colour{200, 0, 0}};
    b.f.session.apply("ink", model::withLook(b.f.session.scene(), {&bladder, 1}, inked));
    const model::Style before = b.look("bladder");
    b.clickRow("bladder");
    QVERIFY(!b.f.control<QAction>("pasteStyle").isEnabled() || before == b.look("bladder"));
    b.clickRow("aorta");
    b.press(Qt::Key_C, Qt::ControlModifier | Qt::AltModifier);
    b.clickRow("bladder");
    const int steps = b.steps();
    b.press(Qt::Key_V, Qt::ControlModifier | Qt::AltModifier);
    QVERIFY(b.look("bladder") == b.look("aorta"));
    QVERIFY(!b.look("bladder").inkColour);
    QCOMPARE(b.steps(), steps + 1);
    b.f.session.undo();
    QVERIFY(b.look("bladder") == before);
    // Without colours.
    b.press(Qt::Key_V, Qt::ControlModifier | Qt::AltModifier | Qt::ShiftModifier);
    model::Style expected = b.look("aorta");
    expected.colour = before.colour;
    expected.inkColour = before.inkColour;
    QVERIFY(b.look("bladder") == expected);
    // What else is copied takes the style's place.
    QGuiApplication::clipboard()->setText(QStringLiteral("text"));
    QTRY_VERIFY(!b.f.control<QAction>("pasteStyle").isEnabled());
  }

  /// All in a group follow it; a locked structure keeps its own.
  void pastedToGroups() {
    Bench b;
    b.dressAorta();
    b.clickRow("aorta");
    b.press(Qt::Key_C, Qt::ControlModifier | Qt::AltModifier);
    b.clickRow("right kidney");
    b.press(Qt::Key_L, Qt::ControlModifier);
    const model::Style locked = b.look("right kidney");
    b.clickRow("Organs");
    b.press(Qt::Key_V, Qt::ControlModifier | Qt::AltModifier);
    QVERIFY(b.look("left kidney") == b.look("aorta"));
    QVERIFY(b.look("bladder") == b.look("aorta"));
    QVERIFY(b.look("right kidney") == locked);
  }

  /// The next structure that is clicked gives its style, in the list as in the picture.
  void madeLike() {
    Bench b;
    b.dressAorta();
    const model::Style before = b.look("bladder");
    b.clickRow("bladder");
    const widgets::NodeIds bladder = b.f.session.selection();
    const int steps = b.steps();
    QAction& like = b.f.control<QAction>("makeLike");
    b.press(Qt::Key_L, Qt::ShiftModifier);
    QVERIFY(like.isChecked());
    QVERIFY(QGuiApplication::overrideCursor());
    b.clickRow("aorta");
    model::Style expected = b.look("aorta");
    expected.colour = before.colour;
    QVERIFY(b.look("bladder") == expected);
    QVERIFY(b.f.session.selection() == bladder);
    QCOMPARE(b.steps(), steps + 1);
    QVERIFY(!like.isChecked());
    QVERIFY(!QGuiApplication::overrideCursor());
    b.f.session.undo();
    QVERIFY(b.look("bladder") == before);
    // In the picture.
    b.press(Qt::Key_L, Qt::ShiftModifier);
    QTest::mouseClick(&b.f.viewport(), Qt::LeftButton, {},
                      b.f.areaOf(b.named("left kidney")).center());
    QTRY_VERIFY(!like.isChecked());
    model::Style kidney = b.look("left kidney");
    kidney.colour = before.colour;
    QTRY_VERIFY(b.look("bladder") == kidney);
    QVERIFY(b.f.session.selection() == bladder);
    // Escape leaves it, wherever the keyboard is, and so does a second press of the key.
    for (QWidget* keyboard :
         {static_cast<QWidget*>(&b.f.tree()), static_cast<QWidget*>(&b.f.viewport()),
          &b.f.control<QWidget>("structureFilter")}) {
      b.press(Qt::Key_L, Qt::ShiftModifier);
      QVERIFY(like.isChecked());
      keyboard->setFocus();
      const model::Style as = b.look("bladder");
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
      QVERIFY(!like.isChecked() && !QGuiApplication::overrideCursor());
      QVERIFY(b.f.session.selection() == bladder);
      b.clickRow("aorta");
      QVERIFY(b.look("bladder") == as);
      b.clickRow("bladder");
    }
    b.press(Qt::Key_L, Qt::ShiftModifier);
    b.press(Qt::Key_L, Qt::ShiftModifier);
    const model::Style kept = b.look("bladder");
    b.clickRow("aorta");
    QVERIFY(b.look("bladder") == kept);
  }

  /// What differs within a group is shown as several values, and a reset makes it one again.
  void mixedValuesAreReset() {
    Bench b;
    const model::NodeId kidney = b.named("left kidney");
    const model::Scene before = b.f.session.scene();
    model::Style style{.inkColour = Colour{20, 90, 20}};
    style.penWeight = 3.0f;
    b.f.session.apply("pen", model::withLook(before, {&kidney, 1}, style));
    b.clickRow("bladder");
    QVERIFY(!b.f.control<QAbstractButton>("penWeightReset").isEnabled());
    b.clickRow("Organs");
    for (const char* reset : {"penWeightReset", "inkColourReset"}) {
      auto& button = b.f.control<QAbstractButton>(reset);
      QVERIFY2(button.isEnabled(), reset);
      button.click();
      QVERIFY(!button.isEnabled());
    }
    QVERIFY(b.f.session.scene() == before);
    // What a group says of its lines holds for all in it.
    const model::NodeId group = b.named("Organs");
    b.f.session.apply("pen", model::withLook(before, {&group, 1}, style));
    QCOMPARE(b.f.session.scene().resolve(kidney).penWeight, 3.0f);
    QVERIFY(b.f.session.scene().resolve(kidney).inkColour == style.inkColour);
    QVERIFY(b.f.control<QAbstractButton>("penWeightReset").isEnabled());
  }

  void menusHaveThem() {
    Bench b;
    QAction* style = b.f.control<QMenu>("styleMenu").menuAction();
    QVERIFY(b.f.control<QMenu>("editMenu").actions().contains(style));
    QVERIFY(b.f.control<QMenu>("structureMenu").actions().contains(style));
    QVERIFY(b.f.tree().actions().contains(style));
  }

  /// Beside the dialog's own colours stand those of anatomy, by name; a click shows one at once.
  void coloursByName() {
    Bench b;
    // The ink is of the colour, as where a look has chosen it.
    const model::NodeId bladder = b.named("bladder");
    constexpr Colour white{255, 255, 255};
    const Colour ink = legibleOn(white, b.f.session.scene().resolve(bladder).colour, 9.0);
    b.f.session.apply("ink",
                      model::withLook(b.f.session.scene(), {&bladder, 1}, {.inkColour = ink}));
    const int steps = b.steps();
    b.f.tree().scrollTo(b.f.tree().indexOf(bladder));
    QTest::mouseClick(
        b.f.tree().viewport(), Qt::LeftButton, {},
        b.f.tree().cellOf(b.named("bladder"), widgets::StructureTreeModel::swatch).center());
    auto& dialog = b.f.control<QColorDialog>("colourDialog");
    QTRY_VERIFY(dialog.isVisible());
    QCOMPARE(dialog.windowTitle(), QStringLiteral("Colour of bladder"));
    auto& palette = b.f.control<QListWidget>("anatomyPalette");
    QVERIFY(palette.isVisible() && dialog.rect().contains(palette.geometry()));
    const QList<QListWidgetItem*> found = palette.findItems("Arteries", Qt::MatchExactly);
    QCOMPARE(found.size(), 1);
    palette.scrollToItem(found.front());
    QTest::mouseClick(palette.viewport(), Qt::LeftButton, {},
                      palette.visualItemRect(found.front()).center());
    QCOMPARE(b.f.session.scene().resolve(b.named("bladder")).colour, (Colour{0xcf, 0x22, 0x14}));
    QCOMPARE(b.steps(), steps);
    dialog.accept();
    QCOMPARE(b.f.session.scene().resolve(b.named("bladder")).colour, (Colour{0xcf, 0x22, 0x14}));
    QCOMPARE(b.steps(), steps + 1);
    const Colour now = b.f.session.scene().resolve(bladder).inkColour.value();
    QVERIFY(now.red > 100 && now.green < 40 && now.blue < 40);  // dark red
    QVERIFY(contrastBetween(white, now) >= 8.9);
  }

  /// Wherever else a colour is chosen the same ones are offered.
  void coloursByNameEverywhere_data() {
    QTest::addColumn<QByteArray>("button");
    QTest::addColumn<QByteArray>("dialog");
    QTest::newRow("colour") << QByteArray("colourSwatch") << QByteArray("colourDialog");
    QTest::newRow("ink") << QByteArray("inkColourSwatch") << QByteArray("inkColourDialog");
    QTest::newRow("label") << QByteArray("annotationColour")
                           << QByteArray("annotationColourDialog");
  }
  void coloursByNameEverywhere() {
    QFETCH(QByteArray, button);
    QFETCH(QByteArray, dialog);
    Bench b;
    b.clickRow("bladder");
    b.press(Qt::Key_T, Qt::ControlModifier);  // a label
    QTRY_VERIFY(!b.f.session.scene().annotations().empty());
    for (QDockWidget* dock : b.f.window.findChildren<QDockWidget*>())
      dock->show();
    b.f.session.activateAnnotation(b.f.session.scene().annotations().front().id);
    b.f.control<QAbstractButton>("more").click();
    auto& chosen = b.f.control<QToolButton>(button.constData());
    if (chosen.menu())
      chosen.menu()->actions().back()->trigger();
    else
      chosen.click();
    auto& opened = b.f.control<QColorDialog>(dialog.constData());
    QTRY_VERIFY(opened.isVisible());
    auto* palette = opened.findChild<QListWidget*>("anatomyPalette");
    QVERIFY(palette && palette->isVisible());
    QListWidgetItem* veins = palette->findItems("Veins", Qt::MatchExactly).value(0);
    QVERIFY(veins);
    palette->scrollToItem(veins);
    QTest::mouseClick(palette->viewport(), Qt::LeftButton, {},
                      palette->visualItemRect(veins).center());
    QCOMPARE(opened.currentColor(), veins->data(Qt::UserRole).value<QColor>());
    opened.accept();
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::StylesTravelTest)
#include "styles_travel_test.moc"
