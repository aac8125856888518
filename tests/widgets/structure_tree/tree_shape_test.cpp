// SPDX-License-Identifier: Apache-2.0
// Tests that steps from one tree to another lead there, and are few if little has changed.
#include <QTest>
#include <algorithm>
#include <random>

#include "model/edit/tree.h"
#include "tests/model/edit/written_tree.h"
#include "tests/support/suite.h"
#include "widgets/structure_tree/tree_shape.h"

namespace sline::widgets {

using test::nodeNamed;
using test::nodesNamed;

class TreeShapeTest : public QObject {
  Q_OBJECT

  static TreeShape after(TreeShape shape, const std::vector<RowStep>& steps) {
    for (const RowStep& step : steps)
      shape.apply(step);
    return shape;
  }

 private slots:
  void followsEdits_data() {
    QTest::addColumn<QString>("edit");
    QTest::addColumn<QString>("ids");
    QTest::addColumn<QString>("group");
    QTest::addColumn<QString>("before");
    QTest::addColumn<int>("steps");
    const auto row = [](const char* name, const char* edit, const char* ids, const char* group,
                        const char* before, int steps) {
      QTest::newRow(name) << QString(edit) << QString(ids) << QString(group) << QString(before)
                          << steps;
    };
    row("nothing", "move", "a", "A", "a", 0);
    row("remove one", "remove", "b1", "", "", 1);
    row("remove a group", "remove", "A", "", "", 1);
    row("remove neighbours", "remove", "d e", "", "", 1);
    row("remove here and there", "remove", "b1 a e", "", "", 3);
    row("first to the end", "move", "A", "root", "", 1);
    row("last to the front", "move", "f", "root", "A", 1);
    row("neighbours into a group", "move", "d e f", "C", "", 1);
    row("from two groups", "move", "b1 d", "C", "", 2);
    row("out of a group", "move", "b1 b2", "root", "A", 1);
    row("a group into another", "move", "B", "C", "", 1);
    row("group neighbours", "group", "d e", "", "", 2);
    row("dissolve", "ungroup", "B", "", "", 2);
    row("dissolve the outer", "ungroup", "A", "", "", 2);
  }
  void followsEdits() {
    QFETCH(QString, edit);
    QFETCH(QString, ids);
    QFETCH(QString, group);
    QFETCH(QString, before);
    QFETCH(int, steps);
    const model::Scene scene = test::readTree("A(B(b1 b2) a) C() d e f");
    const auto named = nodesNamed(scene, ids);
    const model::Scene now =
        edit == "remove"  ? model::removed(scene, named).scene
        : edit == "group" ? model::grouped(scene, named, "N").edited.scene
        : edit == "move"
            ? model::moved(scene, named, nodeNamed(scene, group), nodeNamed(scene, before)).scene
            : model::ungrouped(scene, named).scene;
    const TreeShape from(scene);
    const TreeShape to(now);
    const auto there = stepsBetween(from, to, 10);
    QVERIFY(there);
    QCOMPARE(int(there->size()), steps);
    QVERIFY(after(from, *there).sameAs(to));
    QCOMPARE(from.sameAs(to), steps == 0);
    const auto back = stepsBetween(to, from, 10);  // as undo does
    QVERIFY(back);
    QVERIFY(after(to, *back).sameAs(from));
  }

  void anyOrderToAnyOther() {
    std::mt19937 chance(7);
    model::Scene scene = test::readTree("A(a b c d) B(e f C(g h) i) j k D() l");
    for (int round = 0; round < 200; ++round) {
      model::Scene now = scene;
      for (int i = 0; i < 6; ++i) {
        const auto& nodes = now.nodes();
        if (nodes.empty())
          break;
        const auto any = [&] { return nodes[chance() % nodes.size()].id; };
        const model::NodeId ids[] = {any(), any()};
        switch (chance() % 5) {
          case 0:
            now = model::grouped(now, ids, "N").edited.scene;
            break;
          case 1:
            now = model::ungrouped(now, ids).scene;
            break;
          case 2:
            now = nodes.size() > 8 ? model::removed(now, {ids, 1}).scene : now;
            break;
          default:
            now = model::moved(now, ids, any(), any()).scene;
        }
      }
      const TreeShape from(scene);
      const TreeShape to(now);
      if (const auto steps = stepsBetween(from, to, 1000))
        QVERIFY(after(from, *steps).sameAs(to));
      scene = now.nodes().size() > 8 ? now : test::readTree("A(a b c d) B(e f C(g h) i) j");
    }
  }

  void givesUpWhereItTakesTooMany() {
    const model::Scene scene = test::readTree("a b c d e f g h");
    std::vector<model::Node> nodes = scene.nodes();
    std::reverse(nodes.begin(), nodes.end());
    model::Scene now = scene;
    now.setNodes(nodes);
    QVERIFY(stepsBetween(TreeShape(scene), TreeShape(now), 7));
    QVERIFY(!stepsBetween(TreeShape(scene), TreeShape(now), 6));
  }

  void groupsThatChangePlacesBeginAnew() {
    const model::Scene scene = test::readTree("A(B(b) a)");
    std::vector<model::Node> nodes = scene.nodes();
    nodes[0].parent = nodes[1].id;  // B stands above A
    nodes[1].parent = model::rootId;
    std::swap(nodes[0], nodes[1]);
    model::Scene now = scene;
    now.setNodes(nodes);
    if (const auto steps = stepsBetween(TreeShape(scene), TreeShape(now), 100))
      QVERIFY(after(TreeShape(scene), *steps).sameAs(TreeShape(now)));
  }
};

}  // namespace sline::widgets

SLINE_TEST(sline::widgets::TreeShapeTest)
#include "tree_shape_test.moc"
