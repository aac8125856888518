// SPDX-License-Identifier: Apache-2.0
#include <QTest>
#include <cstdlib>
#include <optional>

#include "model/base/contrast.h"
#include "model/edit/look.h"
#include "model/edit/tree.h"
#include "model/edit/visibility.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::model {
namespace {

using Ids = std::vector<NodeId>;

constexpr Colour heart{176, 58, 58};
constexpr Colour vein{43, 79, 163};

/// Holds groups A ( B ( b1, b2 ), a ), C () and structure d, named by letters.
class Sample {
 public:
  Sample() {
    const MeshPtr ball = test::sphere(1.0f, 0);
    add("A", rootId, nullptr);
    add("B", id("A"), nullptr);
    add("b1", id("B"), ball);
    add("b2", id("B"), ball);
    add("a", id("A"), ball);
    add("C", rootId, nullptr);
    add("d", rootId, ball);
  }
  NodeId id(const QString& name) const {
    for (const Node& node : scene.nodes())
      if (name.toStdString() == node.name)
        return node.id;
    return name == "root" ? rootId : NodeId{12345};
  }
  Ids ids(const QString& names) const {
    Ids found;
    for (const QString& name : names.split(' ', Qt::SkipEmptyParts))
      found.push_back(id(name));
    return found;
  }

  Scene scene;

 private:
  void add(const char* name, NodeId parent, const MeshPtr& mesh) {
    Node node;
    node.name = name;
    node.parent = parent;
    node.mesh = mesh;
    scene.append(node);
  }
};

/// Returns the tree as "A(B(b1 b2) a) C() d".
QString written(const Scene& scene, NodeId parent = rootId) {
  QStringList parts;
  for (const NodeId id : scene.children(parent)) {
    const Node* node = scene.find(id);
    parts << QString::fromStdString(node->name) +
                 (node->isGroup() ? "(" + written(scene, id) + ")" : QString());
  }
  return parts.join(' ');
}

QString visibleNames(const Scene& scene) {
  QStringList names;
  for (const NodeId id : scene.structuresBelow(rootId))
    if (scene.resolve(id).visible)
      names << QString::fromStdString(scene.find(id)->name);
  return names.join(' ');
}

}  // namespace

class EditTest : public QObject {
  Q_OBJECT

 private slots:
  void treeEdits_data();
  void treeEdits();
  void rename();
  void patchesStyle();
  void inksFollowColours_data();
  void inksFollowColours();
  void resetsStyle();
  void showsOnly_data();
  void showsOnly();
  void showsOnlyAfterHiding();
  void inkAlone_data();
  void inkAlone();
  void inkAloneWhereGammaVaries();
};

void EditTest::treeEdits_data() {
  QTest::addColumn<QString>("edit");
  QTest::addColumn<QString>("ids");
  QTest::addColumn<QString>("group");
  QTest::addColumn<QString>("result");
  const QString same = "A(B(b1 b2) a) C() d";
  QTest::newRow("remove a structure") << "remove"
                                      << "b1"
                                      << ""
                                      << "A(B(b2) a) C() d";
  QTest::newRow("remove a group") << "remove"
                                  << "A"
                                  << ""
                                  << "C() d";
  QTest::newRow("remove group and child") << "remove"
                                          << "B b1 d"
                                          << ""
                                          << "A(a) C()";
  QTest::newRow("remove nothing") << "remove"
                                  << ""
                                  << "" << same;
  QTest::newRow("remove the unknown") << "remove"
                                      << "x"
                                      << "" << same;
  QTest::newRow("move to an empty group") << "move"
                                          << "d"
                                          << "C"
                                          << "A(B(b1 b2) a) C(d)";
  QTest::newRow("move behind the last") << "move"
                                        << "d"
                                        << "B"
                                        << "A(B(b1 b2 d) a) C()";
  QTest::newRow("move a group") << "move"
                                << "B"
                                << "C"
                                << "A(a) C(B(b1 b2)) d";
  QTest::newRow("move to the top") << "move"
                                   << "b1"
                                   << "root"
                                   << "A(B(b2) a) C() d b1";
  QTest::newRow("tree order, not the order asked") << "move"
                                                   << "d b1"
                                                   << "C"
                                                   << "A(B(b2) a) C(b1 d)";
  QTest::newRow("a child goes along with its group") << "move"
                                                     << "B b1"
                                                     << "C"
                                                     << "A(a) C(B(b1 b2)) d";
  QTest::newRow("to the end of its own group") << "move"
                                               << "b1"
                                               << "B"
                                               << "A(B(b2 b1) a) C() d";
  QTest::newRow("already the last") << "move"
                                    << "b2"
                                    << "B" << same;
  QTest::newRow("into itself") << "move"
                               << "A"
                               << "A" << same;
  QTest::newRow("into what is below it") << "move"
                                         << "A"
                                         << "B" << same;
  QTest::newRow("into a structure") << "move"
                                    << "d"
                                    << "a" << same;
  QTest::newRow("into the unknown") << "move"
                                    << "d"
                                    << "x" << same;
}

void EditTest::treeEdits() {
  QFETCH(QString, edit);
  QFETCH(QString, ids);
  QFETCH(QString, group);
  QFETCH(QString, result);
  const Sample s;
  const QString before = written(s.scene);
  const Edited edited =
      edit == "remove" ? removed(s.scene, s.ids(ids)) : moved(s.scene, s.ids(ids), s.id(group));
  QCOMPARE(written(edited.scene), result);
  QCOMPARE(edited.changed, result != before);
  QCOMPARE(edited.changed, !(edited.scene == s.scene));
  // The original value is untouched.
  QCOMPARE(written(s.scene), before);
}

void EditTest::rename() {
  const Sample s;
  const Edited edited = renamed(s.scene, s.id("a"), "Ureter");
  QVERIFY(edited.changed);
  QCOMPARE(written(edited.scene), QString("A(B(b1 b2) Ureter) C() d"));
  QVERIFY(!renamed(s.scene, s.id("a"), "a").changed);
  QVERIFY(!renamed(s.scene, s.id("a"), "").changed);
  QVERIFY(!renamed(s.scene, NodeId{999}, "x").changed);
}

void EditTest::patchesStyle() {
  const Sample s;
  Style patch;
  patch.gamma = Gamma::clamped(3.0f);
  patch.fill = Fill::tint;
  const Edited edited = withLook(s.scene, s.ids("B d x"), patch);
  QVERIFY(edited.changed);
  QCOMPARE(edited.scene.resolve(s.id("b1")).gamma.value(), 3.0f);  // handed down
  QVERIFY(edited.scene.resolve(s.id("d")).fill == Fill::tint);
  QVERIFY(edited.scene.resolve(s.id("a")) == ResolvedStyle{});
  QVERIFY(!edited.scene.find(s.id("d"))->style.colour.has_value());
  QVERIFY(!withLook(edited.scene, s.ids("B d"), patch).changed);
  QVERIFY(!withLook(s.scene, s.ids("B d"), Style{}).changed);
  QVERIFY(!withLook(s.scene, s.ids("x"), patch).changed);
}

void EditTest::inksFollowColours_data() {
  QTest::addColumn<Colour>("ink");
  QTest::addColumn<Colour>("follows");
  constexpr Colour white{255, 255, 255};
  constexpr Colour night{28, 30, 34};
  const auto row = [](const char* name, const Colour& ground, double contrast) {
    QTest::newRow(name) << legibleOn(ground, heart, contrast) << legibleOn(ground, vein, contrast);
  };
  row("of context on paper", white, 4.5);
  row("of a subject on paper", white, 9.0);
  row("of a subject in the dark", night, 9.0);
  QTest::newRow("the colour itself") << heart << vein;
  QTest::newRow("black") << Colour{0, 0, 0} << Colour{0, 0, 0};
  QTest::newRow("chalk") << white << white;
  QTest::newRow("graphite") << Colour{70, 70, 76} << Colour{70, 70, 76};
  QTest::newRow("chosen") << Colour{20, 90, 20} << Colour{20, 90, 20};
}

void EditTest::inksFollowColours() {
  QFETCH(Colour, ink);
  QFETCH(Colour, follows);
  const auto near = [](const std::optional<Colour>& a, const Colour& b) {
    constexpr int rounding = 3;
    return a && std::abs(a->red - b.red) <= rounding && std::abs(a->green - b.green) <= rounding &&
           std::abs(a->blue - b.blue) <= rounding;
  };
  const Sample s;
  const Scene inked =
      withLook(s.scene, s.ids("b1 b2 a"), {.colour = heart, .inkColour = ink}).scene;
  const Scene recoloured = withLook(inked, s.ids("b1"), {.colour = vein}).scene;
  QVERIFY(near(recoloured.resolve(s.id("b1")).inkColour, follows));
  QVERIFY(near(recoloured.resolve(s.id("b2")).inkColour, ink));
  // What a group says holds for all in it; an ink that is given is the one that is meant.
  const Scene all = withLook(inked, s.ids("B"), {.colour = vein}).scene;
  for (const char* name : {"b1", "b2"})
    QVERIFY(near(all.resolve(s.id(name)).inkColour, follows));
  QVERIFY(all.find(s.id("a"))->style == inked.find(s.id("a"))->style);
  const Style both{.colour = vein, .inkColour = heart};
  QVERIFY(withLook(inked, s.ids("b1"), both).scene.resolve(s.id("b1")).inkColour == heart);
  // The colour that is inherited again brings its ink.
  const Scene handedDown =
      withLook(withLook(inked, s.ids("B"), {.colour = heart}).scene, s.ids("b1"), {.colour = vein})
          .scene;
  QVERIFY(near(handedDown.resolve(s.id("b1")).inkColour, follows));
  const Style colour{.colour = Colour()};
  QVERIFY(near(
      withLookInherited(handedDown, s.ids("b1"), colour).scene.resolve(s.id("b1")).inkColour, ink));
}

void EditTest::resetsStyle() {
  const Sample s;
  Style patch;
  patch.gamma = Gamma::clamped(3.0f);
  const Scene styled = withLook(s.scene, s.ids("B"), patch).scene;
  const Edited edited = withLookInherited(styled, s.ids("B b1"), wholeLook());
  QVERIFY(edited.changed);
  QVERIFY(edited.scene == s.scene);
  QVERIFY(!withLookInherited(s.scene, s.ids("B b1"), wholeLook()).changed);
}

void EditTest::showsOnly_data() {
  QTest::addColumn<QString>("ids");
  QTest::addColumn<QString>("visible");
  QTest::newRow("one structure") << "b1"
                                 << "b1";
  QTest::newRow("a group") << "B"
                           << "b1 b2";
  QTest::newRow("group and structure") << "B d"
                                       << "b1 b2 d";
  QTest::newRow("all") << "root"
                       << "b1 b2 a d";
  QTest::newRow("an empty group") << "C"
                                  << "";
  QTest::newRow("the unknown") << "x"
                               << "";
}

void EditTest::showsOnly() {
  QFETCH(QString, ids);
  QFETCH(QString, visible);
  const Sample s;
  const Edited edited = withOnlyVisible(s.scene, s.ids(ids));
  QCOMPARE(visibleNames(edited.scene), visible);
  QCOMPARE(edited.changed, visible != visibleNames(s.scene) || !(edited.scene == s.scene));
  QVERIFY(!withOnlyVisible(edited.scene, s.ids(ids)).changed);
}

void EditTest::showsOnlyAfterHiding() {
  const Sample s;
  Style hidden;
  hidden.visible = false;
  const Scene dark = withLook(s.scene, s.ids("A B b1 d"), hidden).scene;
  QCOMPARE(visibleNames(dark), QString());
  QCOMPARE(visibleNames(withOnlyVisible(dark, s.ids("b1")).scene), QString("b1"));
  QCOMPARE(visibleNames(withOnlyVisible(dark, s.ids("root")).scene), QString("b1 b2 a d"));
}

void EditTest::inkAloneWhereGammaVaries() {
  Sample s;
  for (const float gamma : {1.0f, 4.0f}) {
    const Scene scene =
        withLook(s.scene, s.ids("A"),
                 {.gamma = Gamma::clamped(gamma),
                  .gammaMap = GammaMap{.scalar = GammaScalar::occlusion,
                                       .curve = {{0.0f, -1.0f}, {0.5f, 1.0f}, {1.0f, 4.0f}}}})
            .scene;
    const Edited edited = withInkAlone(scene);
    const ResolvedStyle drawn = edited.scene.resolve(s.id("b1"));
    for (int i = 0; i <= 10; ++i)
      QVERIFY(drawn.gamma.value() + drawn.gammaMap.offsetAt(0.1f * float(i)) <= 3.0f);
    QCOMPARE(drawn.gammaMap.offsetAt(0.0f), -1.0f);
    QVERIFY(!withInkAlone(edited.scene).changed);
  }
}

void EditTest::inkAlone_data() {
  QTest::addColumn<float>("gamma");
  QTest::addColumn<int>("fill");
  QTest::addColumn<float>("opacity");
  QTest::addColumn<float>("newGamma");
  QTest::addColumn<int>("newFill");
  const int none = int(Fill::none);
  const int paper = int(Fill::paper);
  const int tint = int(Fill::tint);
  QTest::newRow("lines stay") << 1.5f << none << 1.0f << 1.5f << none;
  QTest::newRow("hatching stays") << 3.0f << none << 1.0f << 3.0f << none;
  QTest::newRow("paper stays") << 1.0f << paper << 1.0f << 1.0f << paper;
  QTest::newRow("a wash hides nothing") << 1.0f << tint << 1.0f << 1.0f << none;
  QTest::newRow("a veil stays a veil") << 1.0f << int(Fill::veil) << 1.0f << 1.0f << none;
  QTest::newRow("paper that is half there") << 1.0f << paper << 0.5f << 1.0f << paper;
  QTest::newRow("shading hides") << 5.0f << none << 1.0f << 3.0f << paper;
  QTest::newRow("half of the shading hides") << 3.5f << tint << 0.6f << 3.0f << paper;
  QTest::newRow("some shading hides nothing") << 3.2f << tint << 0.6f << 3.0f << none;
  QTest::newRow("what is transparent hides nothing") << 5.0f << tint << 0.3f << 3.0f << none;
}

void EditTest::inkAlone() {
  QFETCH(float, gamma);
  QFETCH(int, fill);
  QFETCH(float, opacity);
  QFETCH(float, newGamma);
  QFETCH(int, newFill);
  Sample s;
  Style style;
  style.gamma = Gamma::clamped(gamma);
  style.fill = Fill(fill);
  style.opacity = Opacity::clamped(opacity);
  style.inkColour = Colour{10, 20, 200};
  // A group's style holds for the nodes in it.
  const Scene scene = withLook(s.scene, s.ids("A"), style).scene;
  const Edited edited = withInkAlone(scene);
  QVERIFY(edited.changed);
  for (const NodeId id : s.ids("b1 a")) {
    const ResolvedStyle drawn = edited.scene.resolve(id);
    QCOMPARE(drawn.gamma.value(), newGamma);
    QCOMPARE(int(drawn.fill), newFill);
    QCOMPARE(*drawn.inkColour, (Colour{0, 0, 0}));
    if (newFill != int(Fill::none))
      QCOMPARE(drawn.opacity.value(), 1.0f);
    // A structure that was shaded more is hatched darker.
    QCOMPARE(drawn.hatchTone.value(), 1.0f + 0.4f * std::max(gamma - 3.0f, 0.0f));
  }
  QCOMPARE(edited.scene.resolve(s.id("d")).gamma, scene.resolve(s.id("d")).gamma);
  QVERIFY(!withInkAlone(edited.scene).changed);
}

}  // namespace sline::model

SLINE_TEST(sline::model::EditTest)
#include "edit_test.moc"
