// SPDX-License-Identifier: Apache-2.0
// Tests the panel beside the picture by mouse and keys on the real window: Γ with its live stages,
// what is folded away, presets.
#include <QCheckBox>
#include <QColorDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <QWheelEvent>
#include <QtTest>
#include <cmath>

#include "model/edit/look.h"
#include "model/edit/visibility.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/suite.h"
#include "widgets/gamma/gamma_slider.h"
#include "widgets/gamma/range_box.h"
#include "widgets/gamma/stage_strip.h"
#include "widgets/gamma/style_rows.h"
#include "widgets/gamma/style_slider.h"

using namespace sline;
using namespace sline::test;

namespace {

constexpr int minute = 60'000;

/// Provides the window with the small body open, and helpers that operate the panel.
struct Panel : WindowFixture {
  QTemporaryDir body;

  Panel() {
    writeBody(body.path());
    if (!drop(body.path()) || !settled())
      qFatal("the body does not open");
  }
  model::NodeId named(const char* name) { return session.scene().named(name).front(); }
  float gammaOf(const char* name) { return session.scene().resolve(named(name)).gamma.value(); }
  int steps() { return session.history().count(); }
  widgets::GammaSlider& slider() { return control<widgets::GammaSlider>("gammaSlider"); }
  widgets::RangeBox& number() { return control<widgets::RangeBox>("gammaNumber"); }
  widgets::StageButton& stage(int gamma) {
    return control<widgets::StageButton>(qPrintable(QStringLiteral("stage%1").arg(gamma)));
  }
  void click(QWidget& widget) {
    QTest::mouseClick(&widget, Qt::LeftButton, {}, widget.rect().center());
  }
  void unfold() {
    click(control<QToolButton>("more"));
    QCoreApplication::processEvents();
  }
  /// Returns the entry of the menu below "My presets" with that text or object name.
  QAction& presetEntry(const QString& which) {
    auto& menu = control<QMenu>("presetMenu");
    emit menu.aboutToShow();
    for (QAction* action : menu.actions())
      if (action->text() == which || action->objectName() == which)
        return *action;
    qFatal("no entry %s", qPrintable(which));
  }
  bool pictured() {
    return QTest::qWaitFor(
        [this] {
          for (const int gamma : {0, 1, 2, 3, 5})
            if (stage(gamma).picture().isNull())
              return false;
          return true;
        },
        minute);
  }
};

double ink(const QImage& picture) {
  double sum = 0.0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      sum += 255.0 - qGray(picture.pixel(x, y));
  return sum / (picture.width() * picture.height());
}

void turnWheel(QWidget& widget, int notches) {
  const QPointF at = widget.rect().center();
  QWheelEvent event(at, widget.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton,
                    Qt::NoModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&widget, &event);
}

}  // namespace

class GammaPanelTest : public QObject {
  Q_OBJECT
 private slots:
  void keysAndWheelStep();
  void escapeTakesADragBack();
  void aStageIsOneClick();
  void stagesAreLive();
  void picturesComeFirst();
  void severalValuesAreARange();
  void aDragDrawsOneLayer();
  void numbersOfTheLook_data();
  void numbersOfTheLook();
  void numbersOfAGroup();
  void coloursOfTheLook();
  void whatIsOpenStaysOpen();
  void ownPresets_data();
  void ownPresets();
  void focusTakesItsTime();
  void presetsOfAPerson();
};

void GammaPanelTest::keysAndWheelStep() {
  Panel f;
  f.session.select({f.named("bladder")});
  f.slider().setFocus();
  const auto press = [&](Qt::Key key, float gamma) {
    QTest::keyClick(&f.slider(), key);
    QVERIFY2(std::abs(f.gammaOf("bladder") - gamma) < 1e-4f,
             qPrintable(QString::number(f.gammaOf("bladder"))));
  };
  press(Qt::Key_End, 5.0f);
  press(Qt::Key_Down, 4.95f);
  press(Qt::Key_Left, 4.9f);
  press(Qt::Key_PageDown, 3.9f);
  press(Qt::Key_Right, 3.95f);
  press(Qt::Key_PageUp, 4.95f);
  press(Qt::Key_Home, 0.0f);
  press(Qt::Key_Up, 0.05f);
  QCOMPARE(f.steps(), 1);  // keys in a row are one step
  f.session.undo();
  const float before = f.gammaOf("bladder");
  turnWheel(f.slider(), 1);
  turnWheel(f.slider(), 2);
  QCOMPARE(f.gammaOf("bladder"), before + 0.15f);
  f.session.undo();
  QCOMPARE(f.gammaOf("bladder"), before);
  // The number is written as the locale does.
  f.number().setFocus();
  f.number().selectAll();
  QTest::keyClicks(&f.number(), QLocale().toString(3.25, 'f', 2));
  QTest::keyClick(&f.number(), Qt::Key_Return);
  QCOMPARE(f.gammaOf("bladder"), 3.25f);
}

void GammaPanelTest::escapeTakesADragBack() {
  Panel f;
  f.session.select({f.named("bladder")});
  const model::Scene before = f.session.scene();
  const int steps = f.steps();
  sendMouse(f.slider(), QEvent::MouseButtonPress, f.slider().pointOf(Gamma::clamped(2.0f)));
  sendMouse(f.slider(), QEvent::MouseMove, f.slider().pointOf(Gamma::clamped(4.0f)));
  QVERIFY(std::abs(f.gammaOf("bladder") - 4.0f) < 0.05f);
  QTest::keyClick(&f.slider(), Qt::Key_Escape);
  QVERIFY(f.session.scene() == before);
  sendMouse(f.slider(), QEvent::MouseMove, f.slider().pointOf(Gamma::clamped(1.0f)));
  sendMouse(f.slider(), QEvent::MouseButtonRelease, f.slider().pointOf(Gamma::clamped(1.0f)));
  QVERIFY(f.session.scene() == before);
  QCOMPARE(f.steps(), steps);
}

void GammaPanelTest::aStageIsOneClick() {
  Panel f;
  f.session.select({f.named("bladder"), f.named("aorta")});
  for (const int gamma : {0, 3, 5, 4, 1}) {
    const int steps = f.steps();
    f.click(f.stage(gamma));
    QCOMPARE(f.gammaOf("bladder"), float(gamma));
    QCOMPARE(f.gammaOf("aorta"), float(gamma));
    QCOMPARE(f.steps(), steps + 1);
  }
  // The keyboard chooses a stage, too.
  f.stage(2).setFocus();
  QTest::keyClick(&f.stage(2), Qt::Key_Space);
  QCOMPARE(f.gammaOf("bladder"), 2.0f);
}

void GammaPanelTest::stagesAreLive() {
  Panel f;
  f.session.select({f.named("aorta")});
  QVERIFY(f.pictured());
  // Each stage shows more than the one before, and the last has most, the surface's colour.
  QVERIFY(ink(f.stage(0).picture()) > 1.0);
  QVERIFY(ink(f.stage(3).picture()) > 1.02 * ink(f.stage(2).picture()));
  QVERIFY(ink(f.stage(5).picture()) > 1.5 * ink(f.stage(3).picture()));
  // A structure that is no longer selected leaves no picture.
  f.session.select({f.named("bladder")});
  QVERIFY(f.stage(5).picture().isNull());
  QVERIFY(f.pictured());
  // A colour changes the stages that show it.
  const QImage before = f.stage(5).picture();
  f.session.apply(
      QStringLiteral("colour"),
      model::withLook(f.session.scene(), f.session.selection(), {.colour = Colour{20, 200, 40}}));
  QVERIFY(QTest::qWaitFor([&] { return f.stage(5).picture() != before; }, minute));
  const QColor middle = f.stage(5).picture().pixelColor(f.stage(5).picture().rect().center());
  QVERIFY(middle.green() > 2 * middle.red());
  // The side it is seen from changes them too, but Γ does not: the stages are what they are.
  f.session.select({f.named("aorta")});
  QVERIFY(f.pictured());
  const QImage seen = f.stage(1).picture();
  f.window.viewport().showFrom(model::AnatomicalView::superior);
  QVERIFY(QTest::qWaitFor([&] { return f.stage(1).picture() != seen; }, minute));
  // A group shows all that is in it.
  f.session.select({f.named("Organs")});
  QVERIFY(f.pictured());
}

void GammaPanelTest::picturesComeFirst() {
  // While new pictures are wanted again and again no small one is drawn, and all come afterwards.
  Panel f;
  f.session.select({f.named("aorta")});
  QVERIFY(f.pictured());
  QSignalSpy small(&f.viewport(), &widgets::Viewport::previewed);
  f.session.select({f.named("bladder")});
  model::Camera camera = f.viewport().camera();
  for (int i = 0; i < 8; ++i) {
    camera.eye.x += 1.0f;
    f.viewport().setCamera(camera);
    QVERIFY(f.settled());
    QCOMPARE(small.count(), 0);
  }
  QVERIFY(f.pictured());
}

void GammaPanelTest::severalValuesAreARange() {
  Panel f;
  const auto set = [&](const char* name, float gamma) {
    f.session.select({f.named(name)});
    f.click(f.stage(int(gamma)));
  };
  set("bladder", 1.0f);
  set("left kidney", 3.0f);
  const int steps = f.steps();
  f.session.select({f.named("bladder"), f.named("left kidney")});
  QVERIFY(f.number().isMixed());
  QVERIFY2(f.number().text().contains(QLocale().toString(1.0, 'f', 2)) &&
               f.number().text().contains(QLocale().toString(3.0, 'f', 2)),
           qPrintable(f.number().text()));
  QCOMPARE(f.steps(), steps);
  // Giving both the value that one of them already has is still a change.
  f.number().setFocus();
  f.number().selectAll();
  QTest::keyClicks(&f.number(), QLocale().toString(3.0, 'f', 2));
  QTest::keyClick(&f.number(), Qt::Key_Return);
  QCOMPARE(f.gammaOf("bladder"), 3.0f);
  QCOMPARE(f.steps(), steps + 1);
  QVERIFY(!f.number().isMixed());
  // Leaving the box as it is changes nothing.
  f.session.undo();
  f.number().setFocus();
  f.slider().setFocus();
  QCOMPARE(f.gammaOf("bladder"), 1.0f);
}

void GammaPanelTest::aDragDrawsOneLayer() {
  Panel f;
  const model::NodeId id = f.named("left kidney");
  f.session.select({id});
  QVERIFY(f.settled());
  QVERIFY(f.pictured());
  const auto& slider = f.slider();
  sendMouse(f.slider(), QEvent::MouseButtonPress,
            slider.pointOf(f.session.scene().resolve(id).gamma));
  for (const float gamma : {1.6f, 1.2f, 2.4f, 2.9f, 3.5f, 4.4f}) {
    sendMouse(f.slider(), QEvent::MouseMove, slider.pointOf(Gamma::clamped(gamma)));
    QVERIFY(f.settled());
    QCOMPARE(f.viewport().lastLayersDrawn(), 1);
  }
  sendMouse(f.slider(), QEvent::MouseButtonRelease, slider.pointOf(Gamma::clamped(4.4f)));
}

void GammaPanelTest::numbersOfTheLook_data() {
  QTest::addColumn<int>("row");
  const auto rows = widgets::styleNumbers();
  for (int i = 0; i < int(rows.size()); ++i)
    QTest::newRow(qPrintable(rows[std::size_t(i)].id)) << i;
}

void GammaPanelTest::numbersOfTheLook() {
  QFETCH(int, row);
  const widgets::StyleNumber number = widgets::styleNumbers()[std::size_t(row)];
  Panel f;
  f.unfold();
  const model::NodeId id = f.named("bladder");
  f.session.select({id});
  auto& slider = f.control<widgets::StyleSlider>(qPrintable(number.id + "Slider"));
  auto& box = f.control<widgets::RangeBox>(qPrintable(number.id + "Number"));
  auto& reset = f.control<QToolButton>(qPrintable(number.id + "Reset"));
  const auto value = [&] {
    return double(number.value(f.session.scene().resolve(id))) * number.shown;
  };
  QVERIFY(!reset.isEnabled());
  // A drag is one step, and shown while it goes on.
  const model::Scene before = f.session.scene();
  const int steps = f.steps();
  const double half = 0.5 * number.high;
  sendMouse(slider, QEvent::MouseButtonPress, slider.pointOf(value()));
  sendMouse(slider, QEvent::MouseMove, slider.pointOf(0.25 * number.high));
  QVERIFY(std::abs(value() - 0.25 * number.high) < 0.03 * number.high);
  sendMouse(slider, QEvent::MouseMove, slider.pointOf(half));
  sendMouse(slider, QEvent::MouseButtonRelease, slider.pointOf(half));
  QVERIFY2(std::abs(value() - half) < 0.03 * number.high, qPrintable(QString::number(value())));
  QCOMPARE(f.steps(), steps + 1);
  QVERIFY(reset.isEnabled());
  // Escape takes one back.
  const double set = value();
  sendMouse(slider, QEvent::MouseButtonPress, slider.pointOf(value()));
  sendMouse(slider, QEvent::MouseMove, slider.pointOf(0.0));
  QTest::keyClick(&slider, Qt::Key_Escape);
  QCOMPARE(value(), set);
  // Keys step by the number's own step.
  QTest::keyClick(&slider, Qt::Key_Right);
  QVERIFY(std::abs(value() - set - number.step) < 0.01 * number.step);
  // The number can be typed.
  box.setFocus();
  box.selectAll();
  QTest::keyClicks(&box, QLocale().toString(number.high, 'f', number.decimals));
  QTest::keyClick(&box, Qt::Key_Return);
  QVERIFY(std::abs(value() - number.high) < 1e-4 * number.high);
  // The button resets it to the group's value.
  f.click(reset);
  QVERIFY(!number.own(f.session.scene().find(id)->style));
  QVERIFY(!reset.isEnabled());
  while (f.steps() > steps && f.session.history().canUndo() && !(f.session.scene() == before))
    f.session.undo();
  QVERIFY(f.session.scene() == before);
}

void GammaPanelTest::numbersOfAGroup() {
  Panel f;
  f.unfold();
  auto& box = f.control<widgets::RangeBox>("penWeightNumber");
  const auto type = [&](const QString& text) {
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, text);
    QTest::keyClick(&box, Qt::Key_Return);
  };
  const auto pen = [&](const char* name) {
    return f.session.scene().resolve(f.named(name)).penWeight;
  };
  f.session.select({f.named("bladder")});
  type(QLocale().toString(2.0, 'f', 2));
  f.session.select({f.named("Organs")});
  QVERIFY(box.isMixed());
  QCOMPARE(pen("left kidney"), 1.0f);
  // A group's value holds for all in it.
  type(QLocale().toString(1.5, 'f', 2));
  QCOMPARE(pen("bladder"), 1.5f);
  QCOMPARE(pen("left kidney"), 1.5f);
  QCOMPARE(pen("aorta"), 1.0f);
  QVERIFY(!f.session.scene().find(f.named("bladder"))->style.penWeight);
}

void GammaPanelTest::coloursOfTheLook() {
  Panel f;
  f.unfold();
  const model::NodeId id = f.named("bladder");
  f.session.select({id});
  const auto choose = [&](const char* swatch, const char* dialog, const QColor& colour) {
    f.click(f.control<QToolButton>(swatch));
    auto& asked = f.control<QColorDialog>(dialog);
    asked.setCurrentColor(colour);
    asked.accept();
  };
  choose("inkColourSwatch", "inkColourDialog", QColor(10, 20, 200));
  QCOMPARE(f.session.scene().resolve(id).inkColour, (std::optional<Colour>({10, 20, 200})));
  choose("colourSwatch", "colourDialog", QColor(1, 2, 3));
  QCOMPARE(f.session.scene().resolve(id).colour, (Colour{1, 2, 3}));
  f.click(f.control<QToolButton>("inkColourReset"));
  QVERIFY(!f.session.scene().resolve(id).inkColour);
}

void GammaPanelTest::whatIsOpenStaysOpen() {
  Panel f;
  auto& slider = f.control<widgets::StyleSlider>("hatchToneSlider");
  QVERIFY(!slider.isVisible());
  f.unfold();
  QVERIFY(slider.isVisible());
  QCOMPARE(f.settings.value(QStringLiteral("gamma/more")).toBool(), true);
  widgets::Session session;
  widgets::MainWindow again(session, f.settings);
  again.show();
  QVERIFY(QTest::qWaitForWindowExposed(&again));
  QVERIFY(again.findChild<widgets::StyleSlider*>(QStringLiteral("hatchToneSlider"))->isVisible());
}

void GammaPanelTest::ownPresets_data() {
  QTest::addColumn<QString>("button");
  QTest::addColumn<bool>("visible");
  QTest::addColumn<float>("gamma");
  QTest::addColumn<float>("others");
  QTest::newRow("context") << "contextButton" << true << 1.0f << 2.0f;
  QTest::newRow("ghost") << "ghostButton" << true << 0.0f << 2.0f;
  QTest::newRow("hidden") << "hiddenButton" << false << 2.0f << 2.0f;
}

void GammaPanelTest::ownPresets() {
  QFETCH(QString, button);
  Panel f;
  f.session.select({f.named("bladder")});
  const model::Scene before = f.session.scene();
  const int steps = f.steps();
  f.click(f.control<QPushButton>(qPrintable(button)));
  QTEST(f.gammaOf("bladder"), "gamma");
  QTEST(f.gammaOf("aorta"), "others");
  QTEST(f.session.scene().resolve(f.named("bladder")).visible, "visible");
  QCOMPARE(f.steps(), steps + 1);
  f.session.undo();
  QVERIFY(f.session.scene() == before);
}

void GammaPanelTest::focusTakesItsTime() {
  Panel f;
  f.session.select({f.named("bladder")});
  const int steps = f.steps();
  f.click(f.control<QPushButton>("focusButton"));
  QVERIFY(QTest::qWaitFor([&] { return f.steps() == steps + 1; }, minute));
  QVERIFY(f.gammaOf("bladder") > f.gammaOf("aorta"));
}

void GammaPanelTest::presetsOfAPerson() {
  Panel f;
  f.session.select({f.named("bladder")});
  f.session.apply(QStringLiteral("look"),
                  model::withLook(f.session.scene(), f.session.selection(),
                                  {.gamma = Gamma::clamped(3.5f),
                                   .penWeight = 2.0f,
                                   .hatchDensity = HatchDensity::clamped(0.5f)}));
  QVERIFY(!f.presetEntry("managePresets").isEnabled());
  f.presetEntry("savePreset").trigger();
  auto& name = f.control<QLineEdit>("presetName");
  auto& save = f.control<QPushButton>("savePresetButton");
  QVERIFY(!save.isEnabled());
  QVERIFY(!f.control<QCheckBox>("keep-colour").isChecked());
  QTest::keyClicks(&name, QStringLiteral("Bold & bare"));
  f.click(save);
  // The preset changes all but the colour of other structures, as one step.
  const model::NodeId aorta = f.named("aorta");
  const Colour colour = f.session.scene().resolve(aorta).colour;
  f.session.select({aorta, f.named("left kidney")});
  const int steps = f.steps();
  f.presetEntry(QStringLiteral("Bold && bare")).trigger();
  const model::ResolvedStyle style = f.session.scene().resolve(aorta);
  QCOMPARE(style.gamma.value(), 3.5f);
  QCOMPARE(style.penWeight, 2.0f);
  QCOMPARE(style.hatchDensity.value(), 0.5f);
  QCOMPARE(style.colour, colour);
  QCOMPARE(f.gammaOf("left kidney"), 3.5f);
  QCOMPARE(f.steps(), steps + 1);
  // The preset is renamed and deleted.
  f.presetEntry("managePresets").trigger();
  auto& list = f.control<QListWidget>("presetList");
  QCOMPARE(list.count(), 1);
  f.click(f.control<QPushButton>("renamePreset"));
  auto* editor = list.findChild<QLineEdit*>();
  QVERIFY(editor);
  editor->selectAll();
  QTest::keyClicks(editor, QStringLiteral("Bold"));
  QTest::keyClick(editor, Qt::Key_Return);
  QTRY_COMPARE(list.item(0)->data(Qt::UserRole).toString(), QStringLiteral("Bold"));
  QCOMPARE(f.presetEntry(QStringLiteral("Bold")).text(), QStringLiteral("Bold"));
  f.click(f.control<QPushButton>("deletePreset"));
  QCOMPARE(list.count(), 0);
  QVERIFY(!f.presetEntry("managePresets").isEnabled());
}

SLINE_TEST_WITH_WIDGETS(GammaPanelTest)
#include "gamma_panel_test.moc"
