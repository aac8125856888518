// SPDX-License-Identifier: Apache-2.0
// Tests the list of structures by keys: names, groups, focus, arrows, and what is selected.
#include <QtTest>

#include "tests/gui/made_body.h"
#include "tests/gui/tree_hand.h"
#include "tests/support/suite.h"
#include "widgets/structure_tree/structure_tree_model.h"

namespace sline::test {

using widgets::NodeIds;
using widgets::StructureTreeModel;

namespace {

QString written(WindowFixture& f, model::NodeId parent = model::rootId) {
  QStringList parts;
  for (const model::NodeId each : f.session.scene().children(parent)) {
    const model::Node& node = *f.session.scene().find(each);
    QString part = QString::fromStdString(node.name);
    parts << (node.isGroup() ? part + "(" + written(f, each) + ")" : part);
  }
  return parts.join(',');
}

}  // namespace

class TreeKeysTest : public QObject {
  Q_OBJECT

 private slots:
  /// What has no other side stays selected alone, and is left out beside what has one.
  void otherSideIsSelected() {
    WindowFixture f;
    QVERIFY(openScene(f, madeBody()));
    const auto otherSide = [&f] {
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_M, Qt::ShiftModifier);
    };
    f.tree().setFocus();
    click(f, "left kidney", StructureTreeModel::name);
    otherSide();
    QCOMPARE(f.session.selection(), ids(f, "right kidney"));
    otherSide();
    QCOMPARE(f.session.selection(), ids(f, "left kidney"));
    click(f, "bladder", StructureTreeModel::name);
    otherSide();
    QCOMPARE(f.session.selection(), ids(f, "bladder"));
    click(f, "right kidney", StructureTreeModel::name);
    click(f, "bladder", StructureTreeModel::name, Qt::ControlModifier);
    otherSide();
    QCOMPARE(f.session.selection(), ids(f, "left kidney"));
  }

  /// H hides and never shows, where Space does both; in the list and in the picture.
  void hHides() {
    WindowFixture f;
    QVERIFY(openScene(f, madeBody()));
    f.session.select(ids(f, "bladder,aorta"));
    press(f, QKeySequence("H"));
    QCOMPARE(shown(f), "left kidney,right kidney,left renal vein,skin");
    press(f, QKeySequence("H"));
    QCOMPARE(shown(f), "left kidney,right kidney,left renal vein,skin");
    QCOMPARE(f.session.history().count(), 1);
    QCOMPARE(f.session.selection(), ids(f, "bladder,aorta"));
    press(f, QKeySequence("Space"));
    QVERIFY(f.session.scene().resolve(id(f, "bladder")).visible);
    f.session.select(ids(f, "skin"));
    f.viewport().setFocus();
    QTest::keyClick(&f.viewport(), Qt::Key_H);
    QVERIFY(!f.session.scene().resolve(id(f, "skin")).visible);
    f.session.select({});
    QVERIFY(!f.control<QAction>("hide").isEnabled());
    // The keys are listed by their own sign.
    QTest::keyClick(&f.viewport(), Qt::Key_Question);
    QVERIFY(f.window.findChild<QWidget*>("controlsDialog"));
  }

  void whatIsInFocusIsSelected() {
    WindowFixture f;
    QVERIFY(openScene(f, madeBody()));
    auto& select = f.control<QAction>("selectInFocus");
    QVERIFY(!select.isEnabled());
    f.session.select(ids(f, "left kidney,aorta"));
    press(f, QKeySequence("F"));
    QTRY_VERIFY_WITH_TIMEOUT(!f.session.scene().focus().targets.empty(), 60'000);
    f.session.select(ids(f, "skin"));
    QVERIFY(select.isEnabled());
    select.trigger();
    QCOMPARE(f.session.selection(), ids(f, "left kidney,aorta"));
    f.session.undo();
    QVERIFY(!select.isEnabled());
  }

  /// Undo in the filter takes back what was typed, and never a step of the scene.
  void undoInTheFilterStaysThere() {
    WindowFixture f;
    QVERIFY(openScene(f, madeBody()));
    f.session.select(ids(f, "aorta"));
    press(f, QKeySequence("Ctrl+D"));
    const int step = f.session.history().index();
    QCOMPARE(step, 1);
    f.control<QAction>("find").trigger();
    auto& filter = f.control<QLineEdit>("structureFilter");
    QTest::keyClicks(&filter, "kid");
    for (int i = 0; i < 5; ++i)
      QTest::keyClick(&filter, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(filter.text(), QString());
    QCOMPARE(f.session.history().index(), step);
    QTest::keyClick(&filter, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(filter.text(), QString("kid"));
    QCOMPARE(f.session.history().index(), step);
    // In the list it is the scene's again.
    QTest::keyClick(&filter, Qt::Key_Escape);
    QTest::keyClick(&f.tree(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(f.session.history().index(), step - 1);
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
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::TreeKeysTest)
#include "tree_keys_test.moc"
