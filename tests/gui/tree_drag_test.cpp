// SPDX-License-Identifier: Apache-2.0
// Tests rows dragged by the mouse, through the window system's own drag and drop.
#include <QDropEvent>
#include <QLineEdit>
#include <QMimeData>
#include <QtTest>

#include "model/edit/locks.h"
#include "tests/gui/made_body.h"
#include "tests/support/suite.h"
#include "widgets/structure_tree/structure_tree_model.h"

namespace sline::test {

using widgets::NodeIds;
using widgets::StructureTreeModel;

class TreeDragTest : public QObject {
  Q_OBJECT

  static model::NodeId id(WindowFixture& f, const QString& name) {
    return f.session.scene().named(name.toStdString()).front();
  }
  static QString written(WindowFixture& f, model::NodeId parent = model::rootId) {
    QStringList parts;
    for (const model::NodeId each : f.session.scene().children(parent)) {
      const model::Node& node = *f.session.scene().find(each);
      const QString name = QString::fromStdString(node.name);
      parts << (node.isGroup() ? name + "(" + written(f, each) + ")" : name);
    }
    return parts.join(',');
  }
  /// Returns a place in the row, from its upper edge (0) to its lower one (1); an empty name gives
  /// one below all rows.
  static QPoint place(WindowFixture& f, const QString& name, double part) {
    if (name.isEmpty())
      return f.tree().viewport()->rect().bottomLeft() + QPoint(150, -20);
    const QRect cell = f.tree().cellOf(id(f, name), StructureTreeModel::name);
    return {cell.left() + 40, cell.top() + int(part * (cell.height() - 1))};
  }
  /// Presses, moves and releases while the system's drag runs; returns false if none began or it
  /// hangs.
  static bool dragRow(WindowFixture& f, const QPoint& from, const QPoint& to,
                      QImage* before = nullptr) {
    return dragAndDrop(*f.tree().viewport(), from, to, [&] {
      if (before)
        *before = f.window.grab().toImage();
    });
  }

 private slots:
  void rowsMove_data() {
    QTest::addColumn<QString>("selected");
    QTest::addColumn<QString>("row");
    QTest::addColumn<QString>("onto");
    QTest::addColumn<double>("part");
    QTest::addColumn<QString>("result");
    const auto row = [](const char* name, const char* selected, const char* from, const char* onto,
                        double part, const char* result) {
      QTest::newRow(name) << QString(selected) << QString(from) << QString(onto) << part
                          << QString(result);
    };
    const char* same =
        "Organs(left kidney,right kidney,bladder),Vessels(aorta,left renal vein),"
        "skin";
    row("into a group", "skin", "skin", "Vessels", 0.5,
        "Organs(left kidney,right kidney,bladder),Vessels(aorta,left renal vein,skin)");
    row("above a row", "skin", "skin", "right kidney", 0.1,
        "Organs(left kidney,skin,right kidney,bladder),Vessels(aorta,left renal vein)");
    row("below a row", "skin", "skin", "right kidney", 0.9,
        "Organs(left kidney,right kidney,skin,bladder),Vessels(aorta,left renal vein)");
    row("among its siblings", "bladder", "bladder", "left kidney", 0.1,
        "Organs(bladder,left kidney,right kidney),Vessels(aorta,left renal vein),skin");
    row("to the top level", "aorta", "aorta", "Organs", 0.1,
        "aorta,Organs(left kidney,right kidney,bladder),Vessels(left renal vein),skin");
    row("below all rows", "aorta", "aorta", "", 0.0,
        "Organs(left kidney,right kidney,bladder),Vessels(left renal vein),skin,aorta");
    row("several", "left kidney,bladder", "bladder", "Vessels", 0.5,
        "Organs(right kidney),Vessels(aorta,left renal vein,left kidney,bladder),skin");
    row("not those that are not selected", "left kidney", "bladder", "Vessels", 0.5,
        "Organs(left kidney,right kidney),Vessels(aorta,left renal vein,bladder),skin");
    row("a group", "Vessels", "Vessels", "Organs", 0.1,
        "Vessels(aorta,left renal vein),Organs(left kidney,right kidney,bladder),skin");
    row("into itself", "Organs", "Organs", "Organs", 0.6, same);
    row("into what is in it", "Organs", "Organs", "bladder", 0.9, same);
    row("where it stands", "bladder", "bladder", "bladder", 0.9, same);
  }
  void rowsMove() {
    QFETCH(QString, selected);
    QFETCH(QString, row);
    QFETCH(QString, onto);
    QFETCH(double, part);
    QFETCH(QString, result);
    WindowFixture f;
    QVERIFY(openScene(f, madeBody()));
    const model::Scene before = f.session.scene();
    const QString was = written(f);
    NodeIds ids;
    for (const QString& name : selected.split(','))
      ids.push_back(id(f, name));
    f.session.select(ids);
    QVERIFY(dragRow(f, place(f, row, 0.5), place(f, onto, part)));
    QCOMPARE(written(f), result);
    QCOMPARE(f.session.history().count(), result == was ? 0 : 1);
    f.session.undo();
    QVERIFY(f.session.scene() == before);
    QCOMPARE(f.tree().indexOf(id(f, "aorta")).data().toString(), "aorta");
  }

  void aMarkShowsWhere() {
    WindowFixture f;
    QVERIFY(openScene(f, madeBody()));
    QImage lineUp;
    QVERIFY(dragRow(f, place(f, "skin", 0.5), place(f, "right kidney", 0.9), &lineUp));
    f.session.undo();
    QImage into;
    QVERIFY(dragRow(f, place(f, "skin", 0.5), place(f, "Vessels", 0.5), &into));
    f.session.undo();
    f.session.select({id(f, "skin")});
    const QImage without = f.window.grab().toImage();
    const auto strip = [&](const QImage& image, const QString& name) {
      const QRect cell = f.tree().cellOf(id(f, name), StructureTreeModel::gamma);
      const QRect there(f.tree().viewport()->mapTo(&f.window, cell.topLeft()), cell.size());
      return image.copy(there.adjusted(0, -2, 0, 4));
    };
    QVERIFY(strip(lineUp, "right kidney") != strip(without, "right kidney"));
    QVERIFY(strip(lineUp, "Vessels") == strip(without, "Vessels"));
    QVERIFY(strip(into, "Vessels") != strip(without, "Vessels"));
  }

  void lockedRowsStay() {
    WindowFixture f;
    model::Scene scene = madeBody();
    const model::NodeId vessels[] = {scene.named("Vessels").front()};
    scene = model::withLocked(scene, vessels, true).scene;
    QVERIFY(openScene(f, scene));
    const model::Scene before = f.session.scene();
    dragRow(f, place(f, "aorta", 0.5), place(f, "Organs", 0.5));
    QVERIFY(f.session.scene() == before);
    QVERIFY(dragRow(f, place(f, "skin", 0.5), place(f, "Vessels", 0.5)));
    QVERIFY(f.session.scene() == before);
    QVERIFY(dragRow(f, place(f, "skin", 0.5), place(f, "aorta", 0.1)));
    QVERIFY(f.session.scene() == before);
  }

  void rowsOfAnotherProgramAreRefused() {
    WindowFixture f;
    QVERIFY(openScene(f, madeBody()));
    WindowFixture other;
    QVERIFY(openScene(other, madeBody()));
    auto* rows = other.tree().model();
    const std::unique_ptr<QMimeData> data(
        rows->mimeData({other.tree().indexOf(id(other, "skin"))}));
    const model::Scene before = f.session.scene();
    QWidget& canvas = *f.tree().viewport();
    const QPoint at = place(f, "Vessels", 0.5);
    QDragEnterEvent enter(at, Qt::MoveAction, data.get(), Qt::LeftButton, {});
    QApplication::sendEvent(&canvas, &enter);
    QDragMoveEvent move(at, Qt::MoveAction, data.get(), Qt::LeftButton, {});
    QApplication::sendEvent(&canvas, &move);
    QVERIFY(!move.isAccepted());
    QDropEvent drop(at, Qt::MoveAction, data.get(), Qt::LeftButton, {});
    QApplication::sendEvent(&canvas, &drop);
    QVERIFY(f.session.scene() == before);
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::TreeDragTest)
#include "tree_drag_test.moc"
