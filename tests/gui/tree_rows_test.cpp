// SPDX-License-Identifier: Apache-2.0
// Tests the list of structures by hand: eyes, locks, names, groups, keys and the context menu.
#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollBar>
#include <QTimer>
#include <QtTest>

#include "model/edit/visibility.h"
#include "tests/gui/made_body.h"
#include "tests/support/suite.h"
#include "widgets/structure_tree/structure_tree_model.h"

namespace sline::test {

using widgets::NodeIds;
using widgets::StructureTreeModel;

class TreeRowsTest : public QObject {
  Q_OBJECT

  static model::NodeId id(WindowFixture& f, const QString& name) {
    const std::vector<model::NodeId> found = f.session.scene().named(name.toStdString());
    if (found.size() != 1)
      qFatal("%zu nodes are named %s", found.size(), qPrintable(name));
    return found.front();
  }
  static NodeIds ids(WindowFixture& f, const QString& names) {
    NodeIds found;
    for (const QString& name : names.split(',', Qt::SkipEmptyParts))
      found.push_back(id(f, name));
    std::sort(found.begin(), found.end());
    return found;
  }
  static QPoint cell(WindowFixture& f, const QString& name, int column) {
    return f.tree().cellOf(id(f, name), column).center();
  }
  static void click(WindowFixture& f, const QString& name, int column,
                    Qt::KeyboardModifiers keys = {}, Qt::MouseButton button = Qt::LeftButton) {
    QTest::mouseClick(f.tree().viewport(), button, keys, cell(f, name, column));
  }
  static QString shown(WindowFixture& f) {
    QStringList names;
    for (const model::NodeId each : f.session.scene().structuresBelow(model::rootId))
      if (f.session.scene().resolve(each).visible)
        names << QString::fromStdString(f.session.scene().find(each)->name);
    return names.join(',');
  }
  static QString written(WindowFixture& f, model::NodeId parent = model::rootId) {
    QStringList parts;
    for (const model::NodeId each : f.session.scene().children(parent)) {
      const model::Node& node = *f.session.scene().find(each);
      QString part = QString::fromStdString(node.name);
      parts << (node.isGroup() ? part + "(" + written(f, each) + ")" : part);
    }
    return parts.join(',');
  }
  static void press(WindowFixture& f, const QKeySequence& keys) {
    f.tree().setFocus();
    QTest::keySequence(&f.tree(), keys);
  }
  static QLineEdit* editor(WindowFixture& f) {
    return f.tree().findChild<QLineEdit*>("nameEditor");
  }

 private slots:
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

  void renamesInPlace_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<int>("end");
    QTest::addColumn<QString>("name");
    QTest::newRow("another") << "main artery" << int(Qt::Key_Return) << "main artery";
    QTest::newRow("blanks around it") << " artery " << int(Qt::Key_Enter) << "artery";
    QTest::newRow("empty") << "" << int(Qt::Key_Return) << "aorta";
    QTest::newRow("blank") << "  " << int(Qt::Key_Return) << "aorta";
    QTest::newRow("given up") << "main artery" << int(Qt::Key_Escape) << "aorta";
    // Keys that have a meaning elsewhere are letters here.
    QTest::newRow("letters") << "f/A zX" << int(Qt::Key_Return) << "f/A zX";
  }
  void renamesInPlace() {
    QFETCH(QString, typed);
    QFETCH(int, end);
    QFETCH(QString, name);
    for (const bool byKey : {true, false}) {
      WindowFixture f;
      QVERIFY(openScene(f, madeBody()));
      const model::NodeId aorta = id(f, "aorta");
      const model::Scene before = f.session.scene();
      click(f, "aorta", StructureTreeModel::name);
      if (byKey)
        press(f, QKeySequence("F2"));
      else
        QTest::mouseDClick(f.tree().viewport(), Qt::LeftButton, {},
                           cell(f, "aorta", StructureTreeModel::name));
      QVERIFY(editor(f));
      QCOMPARE(editor(f)->text(), "aorta");
      editor(f)->clear();
      QTest::keyClicks(editor(f), typed);
      QTest::keyClick(editor(f), Qt::Key(end));
      QTRY_VERIFY(!editor(f));
      QCOMPARE(QString::fromStdString(f.session.scene().find(aorta)->name), name);
      QCOMPARE(f.session.history().count(), name == "aorta" ? 0 : 1);
      f.session.undo();
      QVERIFY(f.session.scene() == before);
    }
  }

  /// The window closes while a name is being typed.
  void aNameIsTakenOverAtTheEnd() {
    WindowFixture f;
    QVERIFY(openScene(f, madeBody()));
    click(f, "aorta", StructureTreeModel::name);
    press(f, QKeySequence("F2"));
    QVERIFY(editor(f));
    editor(f)->setText("artery");
  }

  void groupsComeAndGo() {
    WindowFixture f;
    QVERIFY(openScene(f, madeBody()));
    const model::Scene before = f.session.scene();
    click(f, "left kidney", StructureTreeModel::name);
    click(f, "right kidney", StructureTreeModel::name, Qt::ShiftModifier);
    QCOMPARE(f.session.selection(), ids(f, "left kidney,right kidney"));
    press(f, QKeySequence("Ctrl+G"));
    QVERIFY2(editor(f), "a new group asks for its name");
    QTest::keyClicks(editor(f), "Kidneys");
    QTest::keyClick(editor(f), Qt::Key_Return);
    QTRY_VERIFY(!editor(f));
    QCOMPARE(written(f),
             "Organs(Kidneys(left kidney,right kidney),bladder),"
             "Vessels(aorta,left renal vein),skin");
    QCOMPARE(f.session.selection(), ids(f, "Kidneys"));
    press(f, QKeySequence("Ctrl+Shift+G"));
    QCOMPARE(written(f),
             "Organs(left kidney,right kidney,bladder),"
             "Vessels(aorta,left renal vein),skin");
    QCOMPARE(f.session.selection(), ids(f, "left kidney,right kidney"));
    press(f, QKeySequence("Ctrl+Shift+N"));
    QVERIFY(editor(f));
    QTest::keyClick(editor(f), Qt::Key_Escape);
    QTRY_VERIFY(!editor(f));
    QCOMPARE(f.session.history().count(), 4);
    while (f.session.history().canUndo())
      f.session.undo();
    QVERIFY(f.session.scene() == before);
  }

  void keys_data() {
    QTest::addColumn<QString>("keys");
    QTest::addColumn<QString>("visible");
    QTest::addColumn<QString>("tree");
    QTest::addColumn<float>("gamma");
    const QString all = "left kidney,right kidney,bladder,aorta,left renal vein,skin";
    const QString tree =
        "Organs(left kidney,right kidney,bladder),Vessels(aorta,left renal vein),skin";
    QTest::newRow("Space") << "Space"
                           << "left kidney,right kidney,bladder,left renal vein,skin" << tree
                           << 2.0f;
    QTest::newRow("isolate") << "/"
                             << "aorta" << tree << 2.0f;
    QTest::newRow("hide others") << "Shift+H"
                                 << "aorta" << tree << 2.0f;
    QTest::newRow("remove") << "Del"
                            << "left kidney,right kidney,bladder,left renal vein,skin"
                            << "Organs(left kidney,right kidney,bladder),Vessels(left renal "
                               "vein),skin"
                            << -1.0f;
    QTest::newRow("context") << "Ctrl+D" << all << tree << 1.0f;
    QTest::newRow("ghost") << "Ctrl+Shift+D" << all << tree << 0.0f;
  }
  void keys() {
    QFETCH(QString, keys);
    QFETCH(QString, visible);
    QFETCH(QString, tree);
    QFETCH(float, gamma);
    WindowFixture f;
    QVERIFY(openScene(f, madeBody()));
    const model::Scene before = f.session.scene();
    const model::NodeId aorta = id(f, "aorta");
    click(f, "aorta", StructureTreeModel::name);
    press(f, QKeySequence(keys));
    QCOMPARE(shown(f), visible);
    QCOMPARE(written(f), tree);
    if (gamma >= 0.0f)
      QCOMPARE(f.session.scene().resolve(aorta).gamma.value(), gamma);
    QCOMPARE(f.session.history().count(), 1);
    f.session.undo();
    QVERIFY(f.session.scene() == before);
  }

  void focusHasAKey_data() {
    QTest::addColumn<bool>("inPicture");
    QTest::newRow("in the list") << false;
    QTest::newRow("in the picture") << true;
  }
  void focusHasAKey() {
    QFETCH(bool, inPicture);
    WindowFixture f;
    QVERIFY(openScene(f, madeBody()));
    const model::NodeId aorta = id(f, "aorta");
    f.session.select({aorta});
    QWidget& where = inPicture ? static_cast<QWidget&>(f.viewport()) : f.tree();
    where.setFocus();
    QTest::keyClick(&where, Qt::Key_F);
    QTRY_VERIFY(f.session.scene().resolve(aorta).gamma.value() > 4.0f);
    QCOMPARE(f.session.history().count(), 1);
  }

  void enterZoomsAndHomeFits() {
    WindowFixture f;
    QVERIFY(openScene(f, madeBody()));
    QVERIFY(f.settled());
    const auto height = [&] { return f.areaOf(id(f, "aorta")).height(); };
    const int before = height();
    click(f, "aorta", StructureTreeModel::name);
    press(f, QKeySequence("Return"));
    QTRY_VERIFY2(height() > 3 * before, "the ball fills the picture");
    press(f, QKeySequence("Home"));
    QTRY_VERIFY(height() < 2 * before);
    QCOMPARE(f.session.history().count(), 0);
  }

  void arrowsOpenAndClose() {
    WindowFixture f;
    QVERIFY(openScene(f, madeBody()));
    click(f, "Organs", StructureTreeModel::name);
    const QModelIndex organs = f.tree().indexOf(id(f, "Organs")).siblingAtColumn(0);
    QVERIFY(f.tree().isExpanded(organs));
    press(f, QKeySequence("Left"));
    QVERIFY(!f.tree().isExpanded(organs));
    press(f, QKeySequence("Down"));
    QCOMPARE(f.session.selection(), ids(f, "Vessels"));
    press(f, QKeySequence("Up"));
    press(f, QKeySequence("Right"));
    QVERIFY(f.tree().isExpanded(organs));
    // A closed group stays closed through edits and undo.
    press(f, QKeySequence("Left"));
    f.session.select(ids(f, "Vessels"));
    press(f, QKeySequence("Del"));
    f.session.undo();
    QVERIFY(!f.tree().isExpanded(f.tree().indexOf(id(f, "Organs")).siblingAtColumn(0)));
    QVERIFY(f.tree().isExpanded(f.tree().indexOf(id(f, "Vessels")).siblingAtColumn(0)));
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

  void selectionGoesBothWays() {
    WindowFixture f;
    QVERIFY(openScene(f, madeBody()));
    click(f, "left kidney", StructureTreeModel::name);
    click(f, "aorta", StructureTreeModel::name, Qt::ControlModifier);
    QCOMPARE(f.session.selection(), ids(f, "left kidney,aorta"));
    f.session.select(ids(f, "skin,bladder"));
    QCOMPARE(f.tree().selectionModel()->selectedRows().size(), 2);
    QVERIFY2(f.tree().selectionModel()->isSelected(f.tree().currentIndex()),
             "keys begin at what is selected");
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
         {"focus", "context", "ghost", "colour", "inheritMenu", "toggle", "isolate", "hideOthers",
          "showAll", "zoomTo", "rename", "newGroup", "group", "lock", "properties", "remove"})
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
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::TreeRowsTest)
#include "tree_rows_test.moc"
