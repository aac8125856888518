// SPDX-License-Identifier: Apache-2.0
#include <QAbstractItemModelTester>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>
#include <memory>

#include "model/edit/emphasis.h"
#include "model/edit/locks.h"
#include "model/edit/look.h"
#include "model/edit/tree.h"
#include "model/edit/visibility.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"
#include "widgets/structure_tree/node_mime.h"
#include "widgets/structure_tree/structure_properties.h"
#include "widgets/structure_tree/structure_tree_model.h"

namespace sline::widgets {

using Model = StructureTreeModel;

class StructureTreeModelTest : public QObject {
  Q_OBJECT

  /// Returns Organs ( kidney ureter ) bone.
  static model::Scene body() {
    const model::MeshPtr ball = test::sphere(1.0f, 1);
    model::Scene scene;
    const model::NodeId organs = scene.append({.name = "Organs"});
    scene.append({.parent = organs, .name = "kidney", .mesh = ball});
    scene.append({.parent = organs, .name = "ureter", .mesh = ball});
    scene.append({.name = "bone", .mesh = ball});
    return scene;
  }
  static bool open(Session& session) {
    session.openMade(
        QStringLiteral("body"),
        [](const model::ImportProgress&, const std::stop_token&) -> Result<LoadedDocument> {
          return LoadedDocument{.scene = body(), .title = QStringLiteral("body"), .remarks = {}};
        });
    return QTest::qWaitFor([&] { return !session.busy(); });
  }
  static model::NodeId id(const Session& session, const char* name) {
    return session.scene().named(name).front();
  }

 private slots:
  void followsTheScene() {
    Session session;
    Model tree(session);
    const QAbstractItemModelTester tester(&tree,
                                          QAbstractItemModelTester::FailureReportingMode::Fatal);
    QCOMPARE(tree.rowCount(), 0);
    QVERIFY(open(session));
    QCOMPARE(tree.rowCount(), 2);
    const QModelIndex organs = tree.index(0, 0);
    QCOMPARE(tree.rowCount(organs), 2);
    QCOMPARE(tree.index(1, Model::name, organs).data().toString(), QStringLiteral("ureter"));
    QVERIFY(tree.idOf(tree.indexOf(id(session, "bone"))) == id(session, "bone"));

    const model::NodeId gone[] = {id(session, "kidney")};
    session.apply(QStringLiteral("Remove"), model::removed(session.scene(), gone));
    QCOMPARE(tree.rowCount(tree.index(0, 0)), 1);
    QVERIFY(!tree.indexOf(gone[0]).isValid());
    session.undo();
    QCOMPARE(tree.rowCount(tree.index(0, 0)), 2);
  }

  void onlyRowsThatDifferChange() {
    Session session;
    QVERIFY(open(session));
    Model tree(session);
    QSignalSpy resets(&tree, &QAbstractItemModel::modelReset);
    QSignalSpy changes(&tree, &QAbstractItemModel::dataChanged);
    const auto changed = [&] {
      QStringList names;
      for (const auto& arguments : std::as_const(changes)) {
        const QModelIndex first = arguments[0].toModelIndex();
        for (int row = first.row(); row <= arguments[1].toModelIndex().row(); ++row)
          names << first.sibling(row, Model::name).data().toString();
      }
      changes.clear();
      return names.join(QLatin1Char(' '));
    };
    const model::NodeId kidney[] = {id(session, "kidney")};
    const model::NodeId organs[] = {id(session, "Organs")};
    session.apply({}, model::withLook(session.scene(), kidney, {.gamma = Gamma::clamped(4.0f)}));
    QCOMPARE(changed(), QStringLiteral("Organs kidney"));  // the group's range is another one
    session.apply({}, model::withHidden(session.scene(), organs));
    QCOMPARE(changed(), QStringLiteral("Organs kidney ureter"));
    session.apply({}, model::renamed(session.scene(), kidney[0], "left kidney"));
    QCOMPARE(changed(), QStringLiteral("left kidney"));
    QCOMPARE(resets.count(), 0);
  }

  void neighboursAreToldTogether() {
    Session session;
    QVERIFY(open(session));
    Model tree(session);
    QSignalSpy changes(&tree, &QAbstractItemModel::dataChanged);
    const model::NodeId organs[] = {id(session, "Organs")};
    session.apply({}, model::withLook(session.scene(), organs, {.gamma = Gamma::clamped(4.0f)}));
    QCOMPARE(changes.count(), 2);  // the group; what is in it
    for (const auto& arguments : std::as_const(changes)) {
      QCOMPARE(arguments[0].toModelIndex().column(), int(Model::gamma));
      QCOMPARE(arguments[1].toModelIndex().column(), int(Model::gamma));
    }
  }

  /// Rows come, go and move one by one, and back again; the rules of Qt's models hold throughout.
  void rowsMoveWithoutReset() {
    Session session;
    QVERIFY(open(session));
    Model tree(session);
    const QAbstractItemModelTester tester(&tree,
                                          QAbstractItemModelTester::FailureReportingMode::Fatal);
    QSignalSpy resets(&tree, &QAbstractItemModel::modelReset);
    const QPersistentModelIndex kidney = tree.indexOf(id(session, "kidney"));
    const auto moved = [&](const char* name, model::NodeId group, model::NodeId before) {
      const model::NodeId one[] = {id(session, name)};
      return session.apply({}, model::moved(session.scene(), one, group, before));
    };
    const model::NodeId organs = id(session, "Organs");
    const model::NodeId bone = id(session, "bone");
    QVERIFY(moved("bone", model::rootId, organs));
    QCOMPARE(tree.indexOf(bone).row(), 0);
    QVERIFY(moved("kidney", model::rootId, model::rootId));
    QCOMPARE(kidney.row(), 2);
    QVERIFY(!kidney.parent().isValid());
    const model::NodeId two[] = {kidney.isValid() ? tree.idOf(kidney) : bone, bone};
    QVERIFY(session.apply({}, model::grouped(session.scene(), two, "Group").edited));
    QCOMPARE(kidney.parent().siblingAtColumn(Model::name).data().toString(),
             QStringLiteral("Group"));
    const model::NodeId group[] = {id(session, "Group")};
    QVERIFY(session.apply({}, model::ungrouped(session.scene(), group)));
    while (session.history().canUndo())
      session.undo();
    QCOMPARE(kidney.row(), 0);
    QVERIFY(tree.idOf(kidney.parent()) == organs);
    QCOMPARE(resets.count(), 0);
  }

  void filterFollowsEdits() {
    Session session;
    QVERIFY(open(session));
    Model tree(session);
    const QAbstractItemModelTester tester(&tree,
                                          QAbstractItemModelTester::FailureReportingMode::Fatal);
    tree.setFilter(QStringLiteral("kid"));
    QCOMPARE(tree.rowCount(), 1);
    QCOMPARE(tree.rowCount(tree.index(0, 0)), 1);
    const model::NodeId bone = id(session, "bone");
    session.apply({}, model::renamed(session.scene(), bone, "kidney bone"));
    QCOMPARE(tree.rowCount(), 2);
    QCOMPARE(tree.matches().size(), std::size_t(2));
    session.undo();
    QCOMPARE(tree.rowCount(), 1);
    tree.setFilter({});
    QCOMPARE(tree.rowCount(), 2);
    QVERIFY(tree.matches().empty());
  }

  void namesAreShownAsTheyAreCalled() {
    Session session;
    QVERIFY(open(session));
    Model tree(session);
    tree.setNames({.shown =
                       [](const QString& name) {
                         return name == QLatin1String("kidney") ? QStringLiteral("<b>Niere</b>")
                                                                : name;
                       },
                   .alsoCalled = {}});
    const QModelIndex kidney = tree.indexOf(id(session, "kidney"));
    QCOMPARE(kidney.data().toString(), QStringLiteral("<b>Niere</b>"));
    QCOMPARE(kidney.data(Qt::EditRole).toString(), QStringLiteral("kidney"));
    QVERIFY2(!kidney.data(Qt::ToolTipRole).toString().contains(QStringLiteral("<b>")),
             "names are no markup");
    tree.setFilter(QStringLiteral("niere"));
    QCOMPARE(tree.matches().size(), std::size_t(1));
  }

  /// Where a structure lies on the other side than its name says its row tells it, to who hovers,
  /// listens or opens its properties, until its name is another.
  void saysWhatLiesOnTheOtherSide() {
    Session session;
    session.openMade(
        QStringLiteral("body"),
        [](const model::ImportProgress&, const std::stop_token&) -> Result<LoadedDocument> {
          model::Scene scene;
          const model::NodeId organs = scene.append({.name = "Organs"});
          const auto add = [&](const char* name, float x) {
            scene.append({.parent = organs,
                          .name = name,
                          .mesh = test::moved(*test::sphere(10.0f, 1), 1.0f, {x, 0, 0})});
          };
          add("left kidney", -50);  // +x is the patient's left
          add("right kidney", 50);
          add("left lung", 60);
          add("right lung", -60);
          return LoadedDocument{.scene = scene, .title = QStringLiteral("body"), .remarks = {}};
        });
    QVERIFY(QTest::qWaitFor([&] { return !session.busy(); }));
    Model tree(session);
    const auto says = [&](const char* name) {
      const QModelIndex row = tree.indexOf(id(session, name));
      int said = 0;
      for (const int role : {int(Qt::ToolTipRole), int(Qt::AccessibleTextRole)})
        said += row.data(role).toString().contains(QStringLiteral("other side")) ? 1 : 0;
      for (const Property& each : propertiesOf(session.scene(), {id(session, name)}))
        said += each.id == QLatin1String("side") ? 1 : 0;
      return said;
    };
    for (const char* name : {"left kidney", "right kidney"})
      QCOMPARE(says(name), 3);
    for (const char* name : {"left lung", "right lung", "Organs"})
      QCOMPARE(says(name), 0);
    session.apply({}, model::renamed(session.scene(), id(session, "left kidney"), "kidney one"));
    session.apply({}, model::renamed(session.scene(), id(session, "right kidney"), "kidney two"));
    QCOMPARE(says("kidney one"), 0);
  }

  void lockedRowsStayAndSaySo() {
    Session session;
    QVERIFY(open(session));
    Model tree(session);
    const model::NodeId organs[] = {id(session, "Organs")};
    session.apply({}, model::withLocked(session.scene(), organs, true));
    for (const auto& [name, lock] :
         {std::pair("Organs", RowLock::own), {"kidney", RowLock::above}, {"bone", RowLock::open}}) {
      const QModelIndex row = tree.indexOf(id(session, name));
      const bool free = lock == RowLock::open;
      QCOMPARE(row.data(Model::lockRole).toInt(), int(lock));
      QCOMPARE(row.flags().testFlag(Qt::ItemIsEditable), free);
      QCOMPARE(row.flags().testFlag(Qt::ItemIsDragEnabled), free);
      QCOMPARE(row.siblingAtColumn(Model::lock)
                   .data(Qt::AccessibleTextRole)
                   .toString()
                   .startsWith(QStringLiteral("Locked")),
               !free);
    }
  }

  void nodesTravelWithinTheirSession() {
    Session session;
    Session other;
    QVERIFY(open(session));
    QVERIFY(open(other));
    Model tree(session);
    const QModelIndex kidney = tree.indexOf(id(session, "kidney"));
    const std::unique_ptr<QMimeData> data(tree.mimeData({kidney, kidney.siblingAtColumn(0)}));
    QVERIFY(nodesFromMime(session, *data) == NodeIds{id(session, "kidney")});
    QVERIFY(!nodesFromMime(other, *data));
    QMimeData strange;
    strange.setData(QLatin1String(nodeMimeType), QByteArray("short"));
    QVERIFY(!nodesFromMime(session, strange));
    QVERIFY(!nodesFromMime(session, QMimeData()));
  }

  void saysWhatIsInherited() {
    Session session;
    QVERIFY(open(session));
    Model tree(session);
    const model::NodeId organs[] = {id(session, "Organs")};
    session.apply({}, model::withLook(session.scene(), organs, {.gamma = Gamma::clamped(3.0f)}));
    const QModelIndex group = tree.indexOf(organs[0]);
    const QModelIndex kidney = tree.indexOf(id(session, "kidney"));
    QVERIFY(group.data(Model::ownGammaRole).toBool());
    QVERIFY(!kidney.data(Model::ownGammaRole).toBool());
    QCOMPARE(kidney.data(Model::lowGammaRole).toFloat(), 3.0f);
    QVERIFY(kidney.siblingAtColumn(Model::gamma)
                .data(Qt::AccessibleTextRole)
                .toString()
                .contains(QStringLiteral("from the group above")));
    QCOMPARE(group.siblingAtColumn(Model::eye).data(Qt::AccessibleTextRole).toString(),
             QStringLiteral("Shown"));
  }

  /// One pass over the scene finds the same as visiting it node by node.
  void rowStatesAgreeWithTheScene() {
    const model::MeshPtr ball = test::sphere(1.0f, 1);
    model::Scene scene;
    std::vector<model::NodeId> groups{model::rootId};
    for (int i = 0; i < 60; ++i) {
      model::Style style;
      if (i % 3 == 0)
        style.gamma = Gamma::clamped(0.1f * float(i % 40));
      if (i % 4 == 1)
        style.colour = Colour{std::uint8_t(i), 0, 0};
      if (i % 5 == 2)
        style.visible = false;
      if (i % 7 == 3)
        style.opacity = Opacity::clamped(0.5f);
      const model::NodeId parent = groups[std::size_t(i * 7) % groups.size()];
      const bool group = i % 6 == 0;
      const model::NodeId id = scene.append({.parent = parent,
                                             .name = "n",
                                             .style = style,
                                             .locked = i % 11 == 4,
                                             .mesh = group ? nullptr : ball});
      if (group)
        groups.push_back(id);
    }
    const RowStates states = rowStatesOf(scene);
    QCOMPARE(states.size(), std::size_t(60));
    for (const model::Node& node : scene.nodes()) {
      const RowState& state = states.at(node.id.value);
      QCOMPARE(int(state.shown), int(model::visibilityOf(scene, node.id)));
      QVERIFY(state.gamma == model::gammaRangeOf(scene, node.id));
      QCOMPARE(state.ownGamma, node.style.gamma.has_value());
      QCOMPARE(state.group, node.isGroup());
      QCOMPARE(state.lock != RowLock::open, scene.isLocked(node.id));
      QCOMPARE(state.structures, scene.structuresBelow(node.id).size());
      if (!node.isGroup())
        QCOMPARE(state.opacity.value(), scene.resolve(node.id).opacity.value());
      if (!node.isGroup())
        QVERIFY(state.colours == std::vector<Colour>{scene.resolve(node.id).colour});
    }
  }

  void renames() {
    Session session;
    QVERIFY(open(session));
    Model tree(session);
    const QModelIndex bone = tree.indexOf(id(session, "bone"));
    QVERIFY(tree.setData(bone, QStringLiteral(" hip bone "), Qt::EditRole));
    QCOMPARE(bone.data().toString(), QStringLiteral("hip bone"));
    QVERIFY(!tree.setData(bone, QStringLiteral("  "), Qt::EditRole));
    QCOMPARE(session.history().count(), 1);
  }
};

}  // namespace sline::widgets

SLINE_TEST_WITH_EVENTS(sline::widgets::StructureTreeModelTest)
#include "structure_tree_model_test.moc"
