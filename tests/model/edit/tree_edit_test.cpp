// SPDX-License-Identifier: Apache-2.0
// Tests order, groups and their dissolution.
#include <QTest>

#include "model/edit/look.h"
#include "model/edit/tree.h"
#include "tests/model/edit/written_tree.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::model {

using test::nodeNamed;
using test::nodesNamed;
using test::readTree;
using test::writtenTree;
using Texts = std::map<std::string, std::string>;

class TreeEditTest : public QObject {
  Q_OBJECT

 private slots:
  void movesToAPlace_data() {
    QTest::addColumn<QString>("tree");
    QTest::addColumn<QString>("ids");
    QTest::addColumn<QString>("group");
    QTest::addColumn<QString>("before");
    QTest::addColumn<QString>("result");
    const auto row = [](const char* name, const char* tree, const char* ids, const char* group,
                        const char* before, const char* result) {
      QTest::newRow(name) << QString(tree) << QString(ids) << QString(group) << QString(before)
                          << QString(result);
    };
    const char* tree = "A(B(b1 b2) a) C() d e";
    row("up among siblings", tree, "e", "root", "d", "A(B(b1 b2) a) C() e d");
    row("to the front", tree, "e", "root", "A", "e A(B(b1 b2) a) C() d");
    row("down among siblings", "a b c d", "a", "root", "d", "b c a d");
    row("into a group, in front", tree, "d", "B", "b1", "A(B(d b1 b2) a) C() e");
    row("into a group, between", tree, "d", "B", "b2", "A(B(b1 d b2) a) C() e");
    row("in front of a group", tree, "d", "A", "B", "A(d B(b1 b2) a) C() e");
    row("out of a group", tree, "b1", "root", "A", "b1 A(B(b2) a) C() d e");
    row("a group with all in it", tree, "B", "root", "d", "A(a) C() B(b1 b2) d e");
    row("several keep tree order", tree, "e b2 a", "root", "C", "A(B(b1)) b2 a e C() d");
    row("before one that moves too", "a b c d", "d b", "root", "b", "a b d c");
    row("before itself", "a b c", "b", "root", "b", "a b c");
    row("before the next", "a b c", "a", "root", "b", "a b c");
    row("before a child of another group", tree, "e", "root", "b1", "A(B(b1 b2) a) C() d e");
    row("before the unknown", tree, "d", "root", "x", "A(B(b1 b2) a) C() e d");
    row("into itself", tree, "A", "B", "b1", tree);
    row("into a structure", tree, "d", "e", "", tree);
    row("locked stays", "A(a!) b", "a b", "A", "a", "A(b a!)");
    row("in a locked group stays", "A!(a) b", "a", "root", "", "A!(a) b");
    row("a locked group stays", "A!(a) B()", "A", "B", "", "A!(a) B()");
    row("into a locked group", "A!(a) b", "b", "A", "", "A!(a) b");
    row("into a group in a locked one", "A!(B()) b", "b", "B", "", "A!(B()) b");
    row("locked goes along with its group", "A(a!) B()", "A", "B", "", "B(A(a!))");
  }
  void movesToAPlace() {
    QFETCH(QString, tree);
    QFETCH(QString, ids);
    QFETCH(QString, group);
    QFETCH(QString, before);
    QFETCH(QString, result);
    const Scene scene = readTree(tree);
    const Edited edited =
        moved(scene, nodesNamed(scene, ids), nodeNamed(scene, group), nodeNamed(scene, before));
    QCOMPARE(writtenTree(edited.scene), result);
    QCOMPARE(edited.changed, result != tree);
    QCOMPARE(edited.changed, !(edited.scene == scene));
  }

  void groups_data() {
    QTest::addColumn<QString>("tree");
    QTest::addColumn<QString>("ids");
    QTest::addColumn<QString>("result");
    QTest::newRow("one") << "a b c"
                         << "b"
                         << "a N(b) c";
    QTest::newRow("some, in tree order") << "a b c"
                                         << "c a"
                                         << "N(a c) b";
    QTest::newRow("in their group") << "A(a b c) d"
                                    << "b c"
                                    << "A(a N(b c)) d";
    QTest::newRow("from several groups") << "A(a) B(b) c"
                                         << "c b"
                                         << "A(a) B(N(b c))";
    QTest::newRow("a group") << "A(a) b"
                             << "A b"
                             << "N(A(a) b)";
    QTest::newRow("a group and what is in it") << "A(a) b"
                                               << "A a"
                                               << "N(A(a)) b";
    QTest::newRow("locked stays out") << "a! b c"
                                      << "a b"
                                      << "a! N(b) c";
    QTest::newRow("all locked") << "a! b"
                                << "a"
                                << "a! b";
    QTest::newRow("none") << "a b"
                          << ""
                          << "a b";
    QTest::newRow("the unknown") << "a b"
                                 << "x"
                                 << "a b";
  }
  void groups() {
    QFETCH(QString, tree);
    QFETCH(QString, ids);
    QFETCH(QString, result);
    const Scene scene = readTree(tree);
    const Grouped made = grouped(scene, nodesNamed(scene, ids), "N");
    QCOMPARE(writtenTree(made.edited.scene), result);
    QCOMPARE(made.edited.changed, result != tree);
    QVERIFY(made.group == (result != tree ? nodeNamed(made.edited.scene, "N") : rootId));
  }

  void newGroupsAreEmpty() {
    const Scene scene = readTree("A(a) B!(b) c");
    const auto made = [&](const QString& parent, const char* name = "N") {
      return writtenTree(withGroup(scene, name, nodeNamed(scene, parent)).edited.scene);
    };
    QCOMPARE(made("root"), QString("A(a) B!(b) c N()"));
    QCOMPARE(made("A"), QString("A(a N()) B!(b) c"));
    for (const char* refused : {"c", "B", "x"})
      QCOMPARE(made(refused), writtenTree(scene));
    QVERIFY(!withGroup(scene, "").edited.changed);
  }

  void dissolves_data() {
    QTest::addColumn<QString>("tree");
    QTest::addColumn<QString>("ids");
    QTest::addColumn<QString>("result");
    const auto row = [](const char* name, const char* tree, const char* ids, const char* result) {
      QTest::newRow(name) << QString(tree) << QString(ids) << QString(result);
    };
    row("one", "a B(b c) d", "B", "a b c d");
    row("an inner one", "A(B(b c) a) d", "B", "A(b c a) d");
    row("an outer one", "A(B(b c) a) d", "A", "B(b c) a d");
    row("both", "A(B(b c) a) d", "A B", "b c a d");
    row("an empty one", "a B() c", "B", "a c");
    row("a structure", "a B(b)", "a", "a B(b)");
    row("locked", "a B!(b)", "B", "a B!(b)");
    row("with something locked in it", "a B(b! c)", "B", "a B(b! c)");
    row("with something locked far below", "B(C(b!) c)", "B", "C(b!) c");
    row("the unknown", "a B(b)", "x", "a B(b)");
  }
  void dissolves() {
    QFETCH(QString, tree);
    QFETCH(QString, ids);
    QFETCH(QString, result);
    const Scene scene = readTree(tree);
    const Edited edited = ungrouped(scene, nodesNamed(scene, ids));
    QCOMPARE(writtenTree(edited.scene), result);
    QCOMPARE(edited.changed, result != tree);
  }

  void dissolvedGroupsHandTheirLookDown() {
    Scene scene = readTree("A(B(b) a c) d");
    const auto set = [&](const char* name, const Style& style) {
      scene = withLook(scene, nodesNamed(scene, name), style).scene;
    };
    set("A", {.colour = Colour{9, 8, 7}, .gamma = Gamma::clamped(3.0f)});
    set("B", {.opacity = Opacity::clamped(0.5f), .visible = false});
    set("a", {.gamma = Gamma::clamped(4.0f)});
    const Scene after = ungrouped(scene, nodesNamed(scene, "A B")).scene;
    for (const Node& node : scene.nodes())
      if (!node.isGroup())
        QVERIFY2(after.resolve(node.id) == scene.resolve(node.id), node.name.c_str());
    // Grouping and dissolving restores the tree.
    const Grouped made = grouped(scene, nodesNamed(scene, "a c"), "N");
    QVERIFY(ungrouped(made.edited.scene, std::array{made.group}).scene.nodes() == scene.nodes());
  }

  /// Labels are called as their structure is, until someone calls one otherwise.
  void labelsFollowAName() {
    Scene scene;
    const NodeId lump = scene.append({.name = "Segment 1", .mesh = test::sphere(1.0f, 1)});
    const NodeId other = scene.append({.name = "other", .mesh = test::sphere(1.0f, 1)});
    const auto label = [&scene](NodeId on, const char* text, Texts texts) {
      return scene.appendAnnotation(
          {.anchors = {SurfacePoint{on, 0, {}}}, .text = text, .texts = std::move(texts)});
    };
    label(lump, "Segment 1", {});
    label(lump, "Segment 1", {{"de", "mein Klumpen"}});
    label(lump, "my lump", {});
    label(other, "Segment 1", {});
    const NamesOf names = [](const std::string& name) {
      return name == "liver"    ? Texts{{"de", "Leber"}, {"la", "hepar"}}
             : name == "kidney" ? Texts{{"de", "Niere"}, {"la", "ren"}}
                                : Texts{};
    };
    const auto saidOf = [](const Scene& of, std::size_t i) {
      Texts all = of.annotations()[i].texts;
      all[""] = of.annotations()[i].text;
      return all;
    };
    const Edited liver = renamed(scene, lump, "liver", names);
    QVERIFY(liver.changed);
    QCOMPARE(saidOf(liver.scene, 0), (Texts{{"", "liver"}, {"de", "Leber"}, {"la", "hepar"}}));
    QCOMPARE(saidOf(liver.scene, 1),
             (Texts{{"", "liver"}, {"de", "mein Klumpen"}, {"la", "hepar"}}));
    QCOMPARE(saidOf(liver.scene, 2), (Texts{{"", "my lump"}}));
    QCOMPARE(saidOf(liver.scene, 3), (Texts{{"", "Segment 1"}}));
    const Scene kidney = renamed(liver.scene, lump, "kidney", names).scene;
    QCOMPARE(saidOf(kidney, 0), (Texts{{"", "kidney"}, {"de", "Niere"}, {"la", "ren"}}));
    QCOMPARE(saidOf(kidney, 1), (Texts{{"", "kidney"}, {"de", "mein Klumpen"}, {"la", "ren"}}));
    // A name that nobody knows leaves no wrong one behind.
    const Scene lost = renamed(kidney, lump, "Segment 2", names).scene;
    QCOMPARE(saidOf(lost, 0), (Texts{{"", "Segment 2"}}));
    QCOMPARE(saidOf(lost, 1), (Texts{{"", "Segment 2"}, {"de", "mein Klumpen"}}));
  }
};

}  // namespace sline::model

SLINE_TEST(sline::model::TreeEditTest)
#include "tree_edit_test.moc"
