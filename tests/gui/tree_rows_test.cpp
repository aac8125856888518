// SPDX-License-Identifier: Apache-2.0
// Tests the list of structures by hand: eyes, locks, values and the context menu.
#include <QApplication>
#include <QClipboard>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QTimer>
#include <QtTest>

#include "model/edit/visibility.h"
#include "tests/gui/made_body.h"
#include "tests/gui/tree_hand.h"
#include "tests/support/suite.h"
#include "widgets/structure_tree/structure_tree_model.h"

namespace sline::test {

using widgets::NodeIds;
using widgets::StructureTreeModel;

class TreeRowsTest : public QObject {
  Q_OBJECT

 private slots:
  /// Names that differ in their middle alone are not shortened to the same words, and the whole
  /// name is told where the mouse rests.
  void alikeNamesAreToldApart() {
    WindowFixture f;
    const QString name("left lower lobe of the lung, %1 segmental bronchus, wall of its branch");
    const QString names[] = {name.arg("superior"), name.arg("anterior"), name.arg("posterior")};
    model::Scene scene = madeBody();
    for (const QString& each : names)
      scene.append({.name = each.toStdString(), .mesh = scene.nodes().back().mesh});
    QVERIFY(openScene(f, scene));
    QVERIFY(f.settled());
    const auto inRow = [&f](const QString& of) {
      const QRect place = f.tree().cellOf(id(f, of), StructureTreeModel::name);
      return f.tree().viewport()->grab(place).toImage();
    };
    QVERIFY(f.tree().cellOf(id(f, names[0]), StructureTreeModel::name).width() <
            f.tree().fontMetrics().horizontalAdvance(names[0]));
    QVERIFY(inRow(names[0]) != inRow(names[1]));
    QVERIFY(inRow(names[0]) != inRow(names[2]));
    QVERIFY(inRow(names[1]) != inRow(names[2]));
    const QModelIndex row = f.tree().indexOf(id(f, names[1]));
    QVERIFY(row.data(Qt::ToolTipRole).toString().contains(names[1]));
  }

  void eyesAreSweptTogether() {
    WindowFixture f;
    QVERIFY(openScene(f, madeBody()));
    const model::Scene before = f.session.scene();
    QWidget& canvas = *f.tree().viewport();
    const QPoint from = cell(f, "left kidney", StructureTreeModel::eye);
    const QPoint to = cell(f, "bladder", StructureTreeModel::eye);
    sendMouse(canvas, QEvent::MouseButtonPress, from);
    QCOMPARE(shown(f), "right kidney,bladder,aorta,left renal vein,skin");
    sendMouse(canvas, QEvent::MouseMove, to);  // a fast mouse skips the rows between
    QCOMPARE(shown(f), "aorta,left renal vein,skin");
    sendMouse(canvas, QEvent::MouseButtonRelease, to);
    QCOMPARE(f.session.history().count(), 1);
    // In the other direction, from a hidden one, they all come back.
    dragMouse(canvas, to, from);
    QCOMPARE(shown(f), "left kidney,right kidney,bladder,aorta,left renal vein,skin");
    f.session.undo();
    f.session.undo();
    QVERIFY(f.session.scene() == before);
    sendMouse(canvas, QEvent::MouseButtonPress, from);
    sendMouse(canvas, QEvent::MouseMove, to);
    QTest::keyClick(&f.tree(), Qt::Key_Escape);
    sendMouse(canvas, QEvent::MouseButtonRelease, to);
    QVERIFY(f.session.scene() == before);
  }

  void groupsEyeHasThreeStates() {
    WindowFixture f;
    QVERIFY(openScene(f, madeBody()));
    const auto state = [&] { return model::visibilityOf(f.session.scene(), id(f, "Organs")); };
    click(f, "bladder", StructureTreeModel::eye);
    QCOMPARE(state(), model::Visibility::some);
    click(f, "Organs", StructureTreeModel::eye);
    QCOMPARE(state(), model::Visibility::all);
    click(f, "Organs", StructureTreeModel::eye);
    QCOMPARE(state(), model::Visibility::none);
    QCOMPARE(f.session.history().count(), 3);
  }

  void altClickOnAnEyeIsolates_data() {
    QTest::addColumn<int>("key");
    QTest::newRow("Alt") << int(Qt::AltModifier);
    QTest::newRow("Ctrl") << int(Qt::ControlModifier);
  }
  void altClickOnAnEyeIsolates() {
    QFETCH(int, key);
    WindowFixture f;
    QVERIFY(openScene(f, madeBody()));
    click(f, "Vessels", StructureTreeModel::eye, Qt::KeyboardModifiers(key));
    QCOMPARE(shown(f), "aorta,left renal vein");
    click(f, "Vessels", StructureTreeModel::eye, Qt::KeyboardModifiers(key));
    QCOMPARE(shown(f), "left kidney,right kidney,bladder,aorta,left renal vein,skin");
  }

  void lockedRowsRefuse() {
    WindowFixture f;
    QVERIFY(openScene(f, madeBody()));
    click(f, "Organs", StructureTreeModel::lock);
    QVERIFY(f.session.scene().isLocked(id(f, "left kidney")));
    const model::Scene locked = f.session.scene();
    f.pullGamma(id(f, "left kidney"), 5.0f);
    f.letGoOfGamma();
    f.session.select(ids(f, "Organs,left kidney"));
    for (const char* keys : {"Del", "F2", "Ctrl+G", "Ctrl+Shift+G", "Ctrl+D", "Ctrl+Shift+D"})
      press(f, QKeySequence(keys));
    QVERIFY(!editor(f));
    QVERIFY(f.session.scene() == locked);
    click(f, "left kidney", StructureTreeModel::eye);
    QVERIFY2(!f.session.scene().resolve(id(f, "left kidney")).visible, "eyes are no part of it");
    click(f, "Organs", StructureTreeModel::lock);
    QVERIFY(!f.session.scene().isLocked(id(f, "left kidney")));
  }

  void locksAreSweptTogether() {
    WindowFixture f;
    QVERIFY(openScene(f, madeBody()));
    dragMouse(*f.tree().viewport(), cell(f, "left kidney", StructureTreeModel::lock),
              cell(f, "bladder", StructureTreeModel::lock));
    for (const char* name : {"left kidney", "right kidney", "bladder"})
      QVERIFY(f.session.scene().find(id(f, name))->locked);
    QVERIFY(!f.session.scene().isLocked(id(f, "aorta")));
    QCOMPARE(f.session.history().count(), 1);
  }

  void valuesAreInheritedAgain() {
    WindowFixture f;
    QVERIFY(openScene(f, madeBody()));
    const model::NodeId aorta = id(f, "aorta");
    const model::Scene before = f.session.scene();
    f.pullGamma(aorta, 4.0f);
    f.letGoOfGamma();
    QVERIFY(f.session.scene().find(aorta)->style.gamma);
    click(f, "aorta", StructureTreeModel::gamma, {}, Qt::MiddleButton);
    QVERIFY(!f.session.scene().find(aorta)->style.gamma);
    f.pullGamma(aorta, 4.0f);
    f.letGoOfGamma();
    f.session.select({aorta});
    QAction& inherit = f.control<QAction>("inherit");
    QVERIFY(inherit.isEnabled());
    QVERIFY(!f.control<QAction>("inheritColour").isEnabled());
    press(f, QKeySequence("Backspace"));
    QVERIFY(f.session.scene() == before);
    QVERIFY(!inherit.isEnabled());
    f.session.select({id(f, "Organs")});
    QVERIFY(f.control<QAction>("inheritColour").isEnabled());
    f.control<QAction>("inheritAll").trigger();
    QVERIFY(!f.session.scene().find(id(f, "Organs"))->style.colour);
  }

  void hiddenOutlinesByMenu() {
    WindowFixture f;
    QVERIFY(openScene(f, madeBody()));
    const model::Scene before = f.session.scene();
    const auto how = [&f](const char* name) {
      return f.session.scene().resolve(id(f, name)).hiddenLines;
    };
    const auto checked = [&f](const char* action) {
      return f.control<QAction>(action).isChecked();
    };
    QVERIFY(!f.control<QAction>("hiddenLinesThin").isEnabled());
    f.session.select({id(f, "bladder")});
    QVERIFY(checked("hiddenLinesNone"));
    f.control<QAction>("hiddenLinesThin").trigger();
    QCOMPARE(how("bladder"), model::HiddenLines::thin);
    QVERIFY(checked("hiddenLinesThin") && !checked("hiddenLinesNone"));
    f.session.select({id(f, "Organs")});
    QVERIFY2(!checked("hiddenLinesThin") && !checked("hiddenLinesNone"), "they differ");
    f.control<QAction>("hiddenLinesDashed").trigger();
    for (const char* name : {"left kidney", "right kidney", "bladder"})
      QCOMPARE(how(name), model::HiddenLines::dashed);
    QCOMPARE(how("aorta"), model::HiddenLines::none);
    QVERIFY(checked("hiddenLinesDashed"));
    QVERIFY(!f.session.scene().find(id(f, "bladder"))->style.hiddenLines);
    const int steps = f.session.history().count();
    f.control<QAction>("hiddenLinesDashed").trigger();  // again: nothing changes, nothing unchecks
    QCOMPARE(f.session.history().count(), steps);
    QVERIFY(checked("hiddenLinesDashed"));
    f.session.undo();
    QCOMPARE(how("bladder"), model::HiddenLines::thin);
    QCOMPARE(how("left kidney"), model::HiddenLines::none);
    f.session.undo();
    QVERIFY(f.session.scene() == before);
  }

  void contextMenuHasWhatCanBeDone() {
    WindowFixture f;
    QVERIFY(openScene(f, madeBody()));
    click(f, "aorta", StructureTreeModel::name);
    QStringList seen;
    QTimer::singleShot(0, &f.window, [&] {
      auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
      if (!menu)
        return;
      for (const QAction* action : menu->actions())
        if (!action->isSeparator() && action->isEnabled())
          seen << (action->menu() ? action->menu()->objectName() : action->objectName());
      for (QAction* action : menu->actions())
        if (action->objectName() == "ghost")
          menu->setActiveAction(action);
      QTest::keyClick(menu, Qt::Key_Return);
    });
    const QPoint at = cell(f, "aorta", StructureTreeModel::name);
    QContextMenuEvent event(QContextMenuEvent::Mouse, at, f.tree().viewport()->mapToGlobal(at));
    QApplication::sendEvent(f.tree().viewport(), &event);
    for (const char* wanted :
         {"focus", "context", "ghost", "colour", "hiddenLinesMenu", "inheritMenu", "toggle",
          "isolate", "hideOthers", "showAll", "zoomTo", "rename", "newGroup", "group", "lock",
          "properties", "remove"})
      QVERIFY2(seen.contains(wanted), wanted);
    QVERIFY2(!seen.contains("ungroup"), "no group is selected");
    QCOMPARE(f.session.scene().resolve(id(f, "aorta")).gamma.value(), 0.0f);
  }

  void propertiesSayWhatIsKnown() {
    WindowFixture f;
    model::Scene scene = madeBody();
    std::vector<model::Node> nodes = scene.nodes();
    nodes[1].provenance = {.file = "<b>kidney</b>.stl",
                           .frame = "RAS",
                           .frameReason = "header",
                           .smoothingSteps = 3,
                           .mmPerUnit = 10.0f,
                           .unitReason = "size of a body"};
    scene.setNodes(nodes);
    QVERIFY(openScene(f, scene));
    click(f, "left kidney", StructureTreeModel::name);
    press(f, QKeySequence("Alt+Return"));
    const auto text = [&](const char* property) {
      return f.control<QLabel>(qPrintable(QStringLiteral("property-%1").arg(property))).text();
    };
    QCOMPARE(text("name"), "left kidney");
    QCOMPARE(text("file"), "<b>kidney</b>.stl");
    QCOMPARE(f.control<QLabel>("property-file").textFormat(), Qt::PlainText);
    QCOMPARE(text("frame"), "RAS (header)");
    QCOMPARE(text("unit"), "10 mm (size of a body)");
    QVERIFY(text("import").contains("3"));
    QVERIFY(text("colour").contains("inherited"));
    QTRY_VERIFY(f.window.findChild<QLabel*>("property-volume"));
    // 4/3 π 20³ mm³ = 33.5 ml, less what the faces cut off.
    const double ml = text("volume").section(' ', 0, 0).toDouble();
    QVERIFY2(ml > 32.5 && ml < 33.6, qPrintable(text("volume")));
    QTest::mouseClick(&f.control<QWidget>("propertiesCopy"), Qt::LeftButton);
    QVERIFY(QGuiApplication::clipboard()->text().contains("RAS (header)"));
    QTest::mouseClick(&f.control<QWidget>("propertiesClose"), Qt::LeftButton);
    QTRY_VERIFY(!f.window.findChild<QWidget*>("propertiesDialog"));
  }

  void propertiesSayWhoseWorkItIs() {
    WindowFixture f;
    QVERIFY(openScene(f, madeBody()));
    click(f, "left kidney", StructureTreeModel::name);
    press(f, QKeySequence("Alt+Return"));
    // There is no window manager to activate it.
    QApplication::setActiveWindow(&f.control<QDialog>("propertiesDialog"));
    const auto type = [&](const char* name, const char* text) {
      auto& edit = f.control<QLineEdit>(name);
      edit.setFocus();
      QTest::keyClicks(&edit, text);
      QTest::keyClick(&edit, Qt::Key_Tab);
    };
    const auto credit = [&] {
      for (const model::Node& node : f.session.scene().nodes())
        if (node.name == "left kidney")
          return node.provenance.credit;
      return model::SourceCredit();
    };
    type("property-authors", "Jane <Doe>");
    type("property-licence", "CC BY 4.0");
    QCOMPARE(credit().line(), std::string("Jane <Doe>, CC BY 4.0"));
    f.session.undo();
    QCOMPARE(credit().line(), std::string("Jane <Doe>"));
    QTest::mouseClick(&f.control<QWidget>("propertiesClose"), Qt::LeftButton);
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::TreeRowsTest)
#include "tree_rows_test.moc"
