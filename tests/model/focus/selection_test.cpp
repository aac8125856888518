// SPDX-License-Identifier: Apache-2.0
#include <QTest>

#include "model/focus/selection.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;

class SelectionTest : public QObject {
  Q_OBJECT

  using Choice = std::vector<model::NodeId> (*)(const model::Scene&,
                                                std::span<const model::NodeId>);

  static model::Scene body() {
    model::Scene scene;
    const model::NodeId bones = scene.append({.name = "Bones"});
    const model::MeshPtr ball = test::sphere(10.0f, 1);
    for (const char* name : {"rib 1 left", "rib 1 right", "rib 2 left", "rib 2 right", "sacrum"})
      scene.append({.parent = bones, .name = name, .mesh = ball});
    for (const char* name : {"kidney_left", "Kidney Right", "bladder", "Niere links", "heart"})
      scene.append({.name = name, .mesh = ball});
    return scene;
  }
  static std::vector<model::NodeId> named(const model::Scene& scene, const QString& names) {
    std::vector<model::NodeId> ids;
    for (const QString& name : names.split(QLatin1Char(','), Qt::SkipEmptyParts))
      for (const model::NodeId id : scene.named(name.toStdString()))
        ids.push_back(id);
    return ids;
  }
  static QString text(const model::Scene& scene, const std::vector<model::NodeId>& ids) {
    QStringList names;
    for (const model::NodeId id : ids)
      names << QString::fromStdString(scene.find(id)->name);
    return names.join(QLatin1Char(','));
  }

 private slots:
  void choices_data() {
    QTest::addColumn<Choice>("choice");
    QTest::addColumn<QString>("selected");
    QTest::addColumn<QString>("expected");
    const Choice kind = model::ofSameKind;
    const Choice side = model::onOtherSide;
    const Choice inverse = model::withoutSelected;
    QTest::newRow("a rib is of the ribs") << kind << "rib 2 left"
                                          << "rib 1 left,rib 1 right,rib 2 left,rib 2 right";
    QTest::newRow("ribs are of the bones")
        << kind << "rib 1 left,rib 1 right,rib 2 left,rib 2 right"
        << "rib 1 left,rib 1 right,rib 2 left,rib 2 right,sacrum";
    QTest::newRow("a kidney is of the pair") << kind << "kidney_left"
                                             << "kidney_left,Kidney Right,Niere links";
    QTest::newRow("nothing is of no kind") << kind << ""
                                           << "";
    QTest::newRow("the other kidney") << side << "kidney_left"
                                      << "Kidney Right";
    QTest::newRow("there and back") << side << "Kidney Right"
                                    << "kidney_left,Niere links";
    QTest::newRow("each its own") << side << "rib 1 left,rib 2 right"
                                  << "rib 1 right,rib 2 left";
    QTest::newRow("none in the middle") << side << "bladder"
                                        << "";
    QTest::newRow("a partner in another language") << side << "Niere links"
                                                   << "Kidney Right";
    QTest::newRow("a group is what is in it") << side << "Bones"
                                              << "rib 1 left,rib 1 right,rib 2 left,rib 2 right";
    QTest::newRow("all but a group") << inverse << "Bones"
                                     << "kidney_left,Kidney Right,bladder,Niere links,heart";
  }
  void choices() {
    QFETCH(Choice, choice);
    QFETCH(QString, selected);
    QFETCH(QString, expected);
    const model::Scene scene = body();
    QCOMPARE(text(scene, choice(scene, named(scene, selected))), expected);
  }

  void hiddenAndLockedAreLeftOut() {
    model::Scene scene = body();
    std::vector<model::Node> nodes = scene.nodes();
    for (model::Node& node : nodes) {
      if (node.name == "Bones")
        node.style.visible = false;
      if (node.name == "heart")
        node.locked = true;
    }
    scene.setNodes(nodes);
    QCOMPARE(text(scene, model::selectable(scene)),
             QStringLiteral("kidney_left,Kidney Right,bladder,Niere links"));
    QCOMPARE(text(scene, model::withoutSelected(scene, named(scene, "bladder"))),
             QStringLiteral("kidney_left,Kidney Right,Niere links"));
    QVERIFY(model::onOtherSide(scene, named(scene, "rib 1 left")).empty());
  }

  /// The number of an atlas' table is another one on the other side; a rib's is not.
  void codesTellNothingOfKin() {
    model::Scene scene;
    const model::MeshPtr ball = test::sphere(10.0f, 1);
    for (const char* name : {"Insula L 3001", "Insula R 3002", "Putamen L 7011", "Putamen R 7012"})
      scene.append({.name = name, .mesh = ball});
    QCOMPARE(text(scene, model::onOtherSide(scene, named(scene, "Insula L 3001"))),
             QStringLiteral("Insula R 3002"));
    QCOMPARE(text(scene, model::onOtherSide(scene, named(scene, "Putamen R 7012"))),
             QStringLiteral("Putamen L 7011"));
  }
};

SLINE_TEST(SelectionTest)
#include "selection_test.moc"
