// SPDX-License-Identifier: Apache-2.0
// Tests a whole body in the list: it is found by a few letters, and only changes are signalled and
// painted.
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QSignalSpy>
#include <QtTest>

#include "model/edit/tree.h"
#include "model/edit/visibility.h"
#include "tests/gui/made_body.h"
#include "tests/support/suite.h"
#include "widgets/structure_tree/structure_tree_model.h"

namespace sline::test {

using widgets::NodeIds;
using widgets::StructureTreeModel;

namespace {

/// Counts what the list paints.
class PaintCount : public QObject {
 public:
  explicit PaintCount(QWidget& widget) { widget.installEventFilter(this); }
  bool eventFilter(QObject*, QEvent* event) override {
    count += event->type() == QEvent::Paint ? 1 : 0;
    return false;
  }
  int count = 0;
};

}  // namespace

class TreeBodyTest : public QObject {
  Q_OBJECT

  model::Scene m_body;

  static QLineEdit& filter(WindowFixture& f) { return f.control<QLineEdit>("structureFilter"); }
  static void type(WindowFixture& f, const QString& text) {
    f.control<QAction>("find").trigger();
    QTest::keyClicks(&filter(f), text);
  }
  static int rowsTold(const QSignalSpy& changes) {
    int rows = 0;
    for (const auto& arguments : changes)
      rows += arguments[1].toModelIndex().row() - arguments[0].toModelIndex().row() + 1;
    return rows;
  }
  /// Returns the structures with names that have the words.
  NodeIds named(const QStringList& words) const {
    NodeIds ids;
    for (const model::NodeId id : m_body.structuresBelow(model::rootId)) {
      QString name = QString::fromStdString(m_body.find(id)->name);
      const model::Node& group = *m_body.find(m_body.find(id)->parent);
      name += ' ' + QString::fromStdString(group.name);
      if (std::all_of(words.begin(), words.end(), [&](const QString& word) {
            return name.contains(word, Qt::CaseInsensitive);
          }))
        ids.push_back(id);
    }
    return ids;
  }

 private slots:
  void initTestCase() {
    m_body = wholeBody();
    QCOMPARE(m_body.structuresBelow(model::rootId).size(), std::size_t(2234));
  }

  void opensAtTheTop() {
    WindowFixture f;
    QVERIFY(openScene(f, m_body));
    for (int row = 0; row < f.tree().model()->rowCount(); ++row)
      QVERIFY(!f.tree().isExpanded(f.tree().model()->index(row, 0)));
  }

  void aFewLettersThenOneSlider() {
    WindowFixture f;
    QVERIFY(openScene(f, m_body));
    type(f, "artery lef");
    const NodeIds wanted = named({"artery", "lef"});
    QVERIFY(f.control<QLabel>("filterCount").isVisible());
    if (wanted.empty()) {  // made-up names
      QVERIFY(f.tree().matches().empty());
      return;
    }
    QCOMPARE(f.tree().matches(), wanted);
    QVERIFY(f.control<QLabel>("filterCount").text().contains(QString::number(wanted.size())));
    QVERIFY2(!f.tree().cellOf(wanted.front(), 0).isEmpty(), "groups of what is found are open");
    QTest::keyClick(&filter(f), Qt::Key_Return);
    NodeIds sorted = wanted;
    std::sort(sorted.begin(), sorted.end());
    QCOMPARE(f.session.selection(), sorted);
    f.pullGamma(wanted.front(), 4.0f);
    f.letGoOfGamma();
    for (const model::NodeId id : wanted)
      QCOMPARE(f.session.scene().resolve(id).gamma.value(), 4.0f);
    QCOMPARE(f.session.history().count(), 1);
    f.control<QAction>("find").trigger();
    QTest::keyClick(&filter(f), Qt::Key_Escape);
    QVERIFY(filter(f).text().isEmpty());
    QVERIFY(!f.control<QLabel>("filterCount").isVisible());
    QCOMPARE(f.session.selection(), sorted);
  }

  void downGoesToTheList() {
    WindowFixture f;
    QVERIFY(openScene(f, m_body));
    type(f, "left");
    QTest::keyClick(&filter(f), Qt::Key_Down);
    QVERIFY(f.tree().hasFocus());
    QVERIFY(!f.session.selection().empty());
    QVERIFY(f.session.selection().front() == f.tree().matches().front());
    // Ctrl adds to what an earlier filter found.
    const NodeIds first = f.session.selection();
    type(f, "right");
    QVERIFY(!f.tree().indexOf(first.front()).isValid());
    const model::NodeId second = f.tree().matches().front();
    f.tree().scrollTo(f.tree().indexOf(second));
    QTest::mouseClick(f.tree().viewport(), Qt::LeftButton, Qt::ControlModifier,
                      f.tree().cellOf(second, StructureTreeModel::name).center());
    QCOMPARE(f.session.selection().size(), std::size_t(2));
  }

  void aDragTellsOnlyWhatChanges() {
    WindowFixture f;
    QVERIFY(openScene(f, m_body));
    f.tree().expandAll();
    const model::NodeId id = m_body.structuresBelow(model::rootId)[1200];
    f.tree().scrollTo(f.tree().indexOf(id), QAbstractItemView::PositionAtCenter);
    QSignalSpy changes(f.tree().model(), &QAbstractItemModel::dataChanged);
    QSignalSpy resets(f.tree().model(), &QAbstractItemModel::modelReset);
    QSignalSpy layouts(f.tree().model(), &QAbstractItemModel::layoutChanged);
    const int scroll = f.tree().verticalScrollBar()->value();
    QVERIFY(scroll > 0);
    QApplication::processEvents();
    PaintCount paints(*f.tree().viewport());
    f.pullGamma(id, 4.5f);  // a press and five moves
    f.letGoOfGamma();
    QApplication::processEvents();
    QCOMPARE(resets.count() + layouts.count(), 0);
    const int told = rowsTold(changes);
    QVERIFY2(told >= 2 && told <= 2 * 7, qPrintable(QString::number(told)));
    QVERIFY2(paints.count <= 8, qPrintable(QString::number(paints.count)));
    QCOMPARE(f.tree().verticalScrollBar()->value(), scroll);
    changes.clear();
    f.session.undo();
    QCOMPARE(rowsTold(changes), 2);
  }

  void theListStandsStill() {
    WindowFixture f;
    QVERIFY(openScene(f, m_body));
    const NodeIds all = m_body.structuresBelow(model::rootId);
    const model::NodeId id = all[1500];
    f.session.select({id});  // opens its group
    const model::NodeId open = m_body.find(id)->parent;
    f.tree().scrollTo(f.tree().indexOf(id), QAbstractItemView::PositionAtCenter);
    const auto y = [&] { return f.tree().cellOf(id, StructureTreeModel::name).top(); };
    const int before = y();
    const auto still = [&] {
      QApplication::processEvents();
      int opened = 0;
      for (int row = 0; row < f.tree().model()->rowCount(); ++row)
        opened += f.tree().isExpanded(f.tree().model()->index(row, 0)) ? 1 : 0;
      return opened == 1 && std::abs(y() - before) <= 30 &&
             f.tree().isExpanded(f.tree().indexOf(open).siblingAtColumn(0));
    };
    const model::NodeId after[] = {all[1510]};
    const model::NodeId both[] = {all[1505], all[1510]};
    for (const model::Edited& edit :
         {model::removed(f.session.scene(), after), model::withHidden(f.session.scene(), after),
          model::renamed(f.session.scene(), after[0], "new name"),
          model::moved(f.session.scene(), after, open, all[1505]),
          model::grouped(f.session.scene(), both, "Group").edited}) {
      QVERIFY(f.session.apply("edit", edit));
      QVERIFY(f.tree().indexOf(id).isValid());
      f.session.undo();
      QVERIFY2(still(), qPrintable(QString::number(y() - before)));
    }
    // A filter comes and goes.
    type(f, "left");
    QTest::keyClick(&filter(f), Qt::Key_Escape);
    QApplication::processEvents();
    QVERIFY(f.tree().isExpanded(f.tree().indexOf(open).siblingAtColumn(0)));
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::TreeBodyTest)
#include "tree_body_test.moc"
