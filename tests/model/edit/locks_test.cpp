// SPDX-License-Identifier: Apache-2.0
// Tests that locked nodes stay as they are, whichever edit is made.
#include <QTest>
#include <array>
#include <functional>

#include "model/edit/emphasis.h"
#include "model/edit/locks.h"
#include "model/edit/look.h"
#include "model/edit/tree.h"
#include "model/edit/visibility.h"
#include "tests/model/edit/written_tree.h"
#include "tests/support/suite.h"

namespace sline::model {

using test::nodeNamed;
using test::nodesNamed;
using test::readTree;

using Ids = std::span<const NodeId>;
using Edit = std::function<Edited(const Scene&, Ids)>;

class LocksTest : public QObject {
  Q_OBJECT

 private slots:
  void looksStay_data() {
    QTest::addColumn<Edit>("edit");
    const auto row = [](const char* name, const Edit& edit) { QTest::newRow(name) << edit; };
    const Style style{.colour = Colour{1, 1, 1},
                      .gamma = Gamma::clamped(5.0f),
                      .opacity = Opacity::clamped(0.3f),
                      .fill = Fill::tint,
                      .lineThresholds = ThresholdValues{{"ridges.curvature", 3.0f}},
                      .penWeight = 3.0f,
                      .hatchDensity = HatchDensity::clamped(2.0f),
                      .hatchTone = HatchTone::clamped(2.0f),
                      .gammaMap = GammaMap{.scalar = GammaScalar::occlusion,
                                           .curve = usualCurve(GammaScalar::occlusion)}};
    row("gamma",
        [](const Scene& s, Ids ids) { return withLook(s, ids, {.gamma = Gamma::clamped(5.0f)}); });
    row("colour", [](const Scene& s, Ids ids) {
      return withLook(s, ids, {.colour = Colour{1, 2, 3}});
    });
    row("fill", [](const Scene& s, Ids ids) { return withLook(s, ids, {.fill = Fill::veil}); });
    row("style", [style](const Scene& s, Ids ids) { return withLook(s, ids, style); });
    row("context", withContext);
    row("ghost", withGhost);
    row("inherit all",
        [](const Scene& s, Ids ids) { return withLookInherited(s, ids, wholeLook()); });
  }
  /// Locked nodes, named or not, look as before; the others, which looked like them, change.
  void looksStay() {
    QFETCH(Edit, edit);
    Scene scene = readTree("A(a l! L!(m) b) l2! K!(k) c");
    const Style all{.colour = Colour{200, 10, 10}, .gamma = Gamma::clamped(2.5f)};
    scene = withLook(scene, nodesNamed(scene, "A"), all).scene;
    const Style own{.opacity = Opacity::clamped(0.9f)};
    const NodeSet locks = lockedNodes(scene);
    std::vector<Node> nodes = scene.nodes();
    for (Node& node : nodes)
      patch(node.style, node.mesh ? own : Style{});
    scene.setNodes(nodes);
    for (const char* names : {"A", "A l L m b a", "l l2 K k c a", "a b c", "m"}) {
      const Edited edited = edit(scene, nodesNamed(scene, names));
      for (const Node& node : edited.scene.nodes())
        if (locks.contains(node.id.value))
          QVERIFY2(edited.scene.resolve(node.id) == scene.resolve(node.id), node.name.c_str());
      // The unlocked nodes follow the edit.
      if (QLatin1String(names) == QLatin1String("A"))
        QVERIFY(
            !(edited.scene.resolve(nodeNamed(scene, "a")) == scene.resolve(nodeNamed(scene, "a"))));
      QCOMPARE(edited.changed, !(edited.scene == scene));
    }
  }

  void theyCanBeHidden() {
    const Scene scene = readTree("A!(a) b");
    const Scene hidden = withHidden(scene, nodesNamed(scene, "a")).scene;
    QVERIFY(!hidden.resolve(nodeNamed(scene, "a")).visible);
    QVERIFY(withShown(hidden, nodesNamed(scene, "a")).scene.resolve(nodeNamed(scene, "a")).visible);
    const Scene others = withOthersHidden(scene, nodesNamed(scene, "b")).scene;
    QVERIFY(!others.resolve(nodeNamed(scene, "a")).visible);
  }

  void removing_data() {
    QTest::addColumn<QString>("tree");
    QTest::addColumn<QString>("ids");
    QTest::addColumn<QString>("result");
    const auto row = [](const char* name, const char* tree, const char* ids, const char* result) {
      QTest::newRow(name) << QString(tree) << QString(ids) << QString(result);
    };
    row("itself", "a! b", "a b", "a!");
    row("in a group", "A(a! b) c", "A c", "A(a!)");
    row("a group", "A!(a b) c", "A c", "A!(a b)");
    row("below a locked group", "A!(a b) c", "a", "A!(a b) c");
    row("groups within", "A(B(C!(c) b) a)", "A", "A(B(C!(c)))");
  }
  void removing() {
    QFETCH(QString, tree);
    QFETCH(QString, ids);
    QFETCH(QString, result);
    const Scene scene = readTree(tree);
    const Edited edited = removed(scene, nodesNamed(scene, ids));
    QCOMPARE(test::writtenTree(edited.scene), result);
    QCOMPARE(edited.changed, result != tree);
  }

  void names() {
    const Scene scene = readTree("A!(a) b");
    QVERIFY(!renamed(scene, nodeNamed(scene, "a"), "n").changed);
    QVERIFY(!renamed(scene, nodeNamed(scene, "A"), "n").changed);
    QVERIFY(renamed(scene, nodeNamed(scene, "b"), "n").changed);
  }

  void lockingIsAnEdit() {
    const Scene scene = readTree("A(a b) c");
    const Edited locked = withLocked(scene, nodesNamed(scene, "A c"), true);
    QVERIFY(locked.changed);
    QCOMPARE(test::writtenTree(locked.scene), QString("A!(a b) c!"));
    QVERIFY(!withLocked(locked.scene, nodesNamed(scene, "A c"), true).changed);
    QCOMPARE(editable(locked.scene, nodesNamed(scene, "A a c x")).size(), std::size_t(0));
    // A node that a group above locks cannot be unlocked by itself.
    QVERIFY(!withLocked(locked.scene, nodesNamed(scene, "a"), false).changed);
    QVERIFY(withLocked(locked.scene, nodesNamed(scene, "A c"), false).scene == scene);
  }
};

}  // namespace sline::model

SLINE_TEST(sline::model::LocksTest)
#include "locks_test.moc"
