// SPDX-License-Identifier: Apache-2.0
// Tests the look in the panel beside the picture by mouse and keys on the real window: what is
// folded away, presets.
#include <QCheckBox>
#include <QColorDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QToolButton>
#include <QtTest>
#include <cmath>

#include "model/edit/look.h"
#include "tests/gui/gamma_fixture.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/suite.h"
#include "widgets/form/range_box.h"
#include "widgets/gamma/style_rows.h"
#include "widgets/gamma/style_slider.h"

using namespace sline;
using namespace sline::test;

class GammaLooksTest : public QObject {
  Q_OBJECT
 private slots:
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

void GammaLooksTest::numbersOfTheLook_data() {
  QTest::addColumn<int>("row");
  const auto rows = widgets::styleNumbers();
  for (int i = 0; i < int(rows.size()); ++i)
    QTest::newRow(qPrintable(rows[std::size_t(i)].id)) << i;
}

void GammaLooksTest::numbersOfTheLook() {
  QFETCH(int, row);
  const widgets::StyleNumber number = widgets::styleNumbers()[std::size_t(row)];
  GammaPanelFixture f;
  f.unfold();
  const model::NodeId id = f.named("bladder");
  f.session.select({id});
  auto& slider = f.control<widgets::StyleSlider>(qPrintable(number.id + "Slider"));
  auto& box = f.control<widgets::RangeBox>(qPrintable(number.id + "Number"));
  auto& reset = f.control<QToolButton>(qPrintable(number.id + "Reset"));
  const auto value = [&] {
    return double(number.field.value(f.session.scene().resolve(id))) * number.shown;
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
  QVERIFY(!number.field.own(f.session.scene().find(id)->style));
  QVERIFY(!reset.isEnabled());
  while (f.steps() > steps && f.session.history().canUndo() && !(f.session.scene() == before))
    f.session.undo();
  QVERIFY(f.session.scene() == before);
}

void GammaLooksTest::numbersOfAGroup() {
  GammaPanelFixture f;
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

void GammaLooksTest::coloursOfTheLook() {
  GammaPanelFixture f;
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

void GammaLooksTest::whatIsOpenStaysOpen() {
  GammaPanelFixture f;
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

void GammaLooksTest::ownPresets_data() {
  QTest::addColumn<QString>("button");
  QTest::addColumn<bool>("visible");
  QTest::addColumn<float>("gamma");
  QTest::addColumn<float>("others");
  QTest::newRow("context") << "contextButton" << true << 1.0f << 2.0f;
  QTest::newRow("ghost") << "ghostButton" << true << 0.0f << 2.0f;
  QTest::newRow("hidden") << "hiddenButton" << false << 2.0f << 2.0f;
}

void GammaLooksTest::ownPresets() {
  QFETCH(QString, button);
  GammaPanelFixture f;
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

void GammaLooksTest::focusTakesItsTime() {
  GammaPanelFixture f;
  f.session.select({f.named("bladder")});
  const int steps = f.steps();
  f.click(f.control<QPushButton>("focusButton"));
  QVERIFY(QTest::qWaitFor([&] { return f.steps() == steps + 1; }, minute));
  QVERIFY(f.gammaOf("bladder") > f.gammaOf("aorta"));
}

void GammaLooksTest::presetsOfAPerson() {
  GammaPanelFixture f;
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

SLINE_TEST_WITH_WIDGETS(GammaLooksTest)
#include "gamma_looks_test.moc"
