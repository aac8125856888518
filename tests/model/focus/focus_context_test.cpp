// SPDX-License-Identifier: Apache-2.0
// Tests the way from an analysis and an amount to styles: more is never less, nothing jumps, no
// choice of the user is lost.
#include <QTest>

#include "model/edit/look.h"
#include "model/edit/sections.h"
#include "model/edit/tree.h"
#include "model/edit/views.h"
#include "model/edit/visibility.h"
#include "model/focus/context.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::model {

class FocusContextTest : public QObject {
  Q_OBJECT

  Scene m_scene;
  NodeId m_group;
  NodeId m_target;
  NodeId m_other;
  NodeId m_third;
  FocusAnalysis m_analysis;

  static ContextAmount amount(float value) { return ContextAmount::clamped(value); }
  Scene at(float value, const ContextWishes& wishes = {}) const {
    return withFocusAndContext(m_scene, m_analysis, amount(value), wishes).scene;
  }
  static std::vector<Relation> allSorts() {
    std::vector<Relation> sorts;
    for (const ContextRole role : {ContextRole::target, ContextRole::feeder, ContextRole::neighbour,
                                   ContextRole::shell, ContextRole::backdrop})
      for (const float hides : {0.0f, 0.08f, 0.3f, 1.0f})
        for (const float gap : {0.0f, 0.4f, 6.0f})
          sorts.push_back({.role = role,
                           .gap = gap,
                           .feeding = gap > 0.0f ? 0.5f : 1.0f,
                           .nearness = gap > 1.0f ? 0.0f : 1.0f - gap,
                           .hides = hides});
    return sorts;
  }
  /// Returns how much ink a structure's lines have; none if it is hidden.
  static float pen(const Style& style) { return *style.visible ? *style.penWeight : 0.0f; }

 private slots:
  void init() {
    const MeshPtr ball = test::sphere(1.0f, 1);
    m_scene = {};
    m_group = m_scene.append({.name = "group"});
    m_target = m_scene.append({.parent = m_group, .name = "target", .mesh = ball});
    m_other = m_scene.append({.parent = m_group, .name = "other", .mesh = ball});
    m_third = m_scene.append({.name = "third", .mesh = ball});
    m_analysis = {.asked = {m_target},
                  .targets = {m_target},
                  .relations = {{.structure = m_target, .role = ContextRole::target},
                                {.structure = m_other, .role = ContextRole::neighbour},
                                {.structure = m_third, .role = ContextRole::backdrop}}};
  }

  void manners_data() {
    QTest::addColumn<Relation>("relation");
    QTest::addColumn<ContextManner>("manner");
    const auto row = [](const char* name, const Relation& relation, ContextManner manner) {
      QTest::newRow(name) << relation << manner;
    };
    row("subject", {.role = ContextRole::target}, ContextManner::detail);
    row("protein around a ligand", {.contact = 0.8f, .hides = 0.3f}, ContextManner::host);
    row("closed around it", {.contact = 0.8f, .hides = 0.9f}, ContextManner::byRole);
    row("bone beside it", {.tissue = Tissue::bone, .nearness = 1.0f}, ContextManner::near);
    row("bone far off", {.tissue = Tissue::bone}, ContextManner::far);
    row("muscle before it", {.tissue = Tissue::muscle, .hides = 0.2f}, ContextManner::outline);
    row("its vessel", {.tissue = Tissue::vessel, .role = ContextRole::feeder, .hides = 0.2f},
        ContextManner::feeder);
    row("unknown", {.role = ContextRole::neighbour, .nearness = 1.0f}, ContextManner::byRole);
  }
  /// What is said of a structure and what is drawn come of the same choice.
  void manners() {
    QFETCH(Relation, relation);
    QFETCH(ContextManner, manner);
    QCOMPARE(mannerOf(relation), manner);
    const Style style = contextStyle(relation, amount(1.0f));
    if (manner == ContextManner::outline)
      QVERIFY(style.fill == Fill::none && style.gamma->value() < 0.5f);
    if (manner == ContextManner::host || manner == ContextManner::near)
      QVERIFY(style.fill == Fill::paper);
  }

  void moreIsNeverLessAndNothingJumps() {
    constexpr int steps = 200;
    for (const Relation& relation : allSorts()) {
      std::optional<Style> before;
      for (int i = 0; i <= steps; ++i) {
        const Style style = contextStyle(relation, amount(float(i) / steps));
        QVERIFY(style.gamma && style.fill && style.opacity && style.visible && style.penWeight);
        if (before) {
          QVERIFY(*style.visible || !*before->visible);
          QVERIFY(*style.gamma >= *before->gamma);
          QVERIFY(*style.opacity >= *before->opacity);
          QVERIFY(pen(style) >= pen(*before));
          QVERIFY(*style.fill == *before->fill);
          QVERIFY(style.gamma->value() - before->gamma->value() < 0.05f);
          QVERIFY(style.opacity->value() - before->opacity->value() < 0.05f);
          QVERIFY2(pen(style) - pen(*before) < 0.05f, "a line appears at once");
        }
        before = style;
      }
      QVERIFY2(*before->visible, "at 1 everything is there");
      const bool target = relation.role == ContextRole::target;
      QCOMPARE(*contextStyle(relation, amount(0.0f)).visible, target);
    }
  }

  void nothingSolidLiesBeforeTheFocus() {
    for (const Relation& relation : allSorts()) {
      const Style style = contextStyle(relation, amount(1.0f));
      if (relation.role == ContextRole::target) {
        QVERIFY(style.fill == Fill::paper && style.gamma->value() > 4.0f);
        continue;
      }
      QVERIFY(relation.hides <= 0.1f || style.fill != Fill::paper);
      if (relation.role == ContextRole::shell)
        QVERIFY(style.fill == Fill::none && style.gamma->value() <= 1.0f);
    }
  }

  void vesselsStayLongest() {
    const float middle = 0.5f;
    float lowest = 5.0f;
    for (const ContextRole role :
         {ContextRole::feeder, ContextRole::neighbour, ContextRole::shell, ContextRole::backdrop}) {
      Relation relation{.role = role, .gap = 0.5f, .feeding = 1.0f, .nearness = 1.0f};
      relation.hides = role == ContextRole::shell ? 1.0f : 0.2f;
      const float gamma = contextStyle(relation, amount(middle)).gamma->value();
      QVERIFY(gamma <= lowest);
      lowest = gamma;
      if (role == ContextRole::feeder)
        QVERIFY(*contextStyle(relation, amount(0.05f)).visible);
      else
        QVERIFY(!*contextStyle(relation, amount(0.05f)).visible);
    }
  }

  void atNothingTheFocusIsAlone() {
    const Scene scene = at(0.0f);
    QVERIFY(scene.resolve(m_target).visible);
    QVERIFY(!scene.resolve(m_other).visible && !scene.resolve(m_third).visible);
    QVERIFY(!withFocusAndContext(scene, m_analysis, amount(0.0f)).changed);
    // The context comes back, though all was hidden.
    const Edited more = withFocusAndContext(scene, m_analysis, amount(1.0f));
    QVERIFY(more.scene.resolve(m_other).visible && more.scene.resolve(m_third).visible);
    QVERIFY(more.scene == at(1.0f));
  }

  void lockedNodesStayAsTheyAre_data() {
    QTest::addColumn<bool>("group");
    QTest::newRow("structure") << false;
    QTest::newRow("group") << true;
  }
  void lockedNodesStayAsTheyAre() {
    QFETCH(bool, group);
    std::vector<Node> nodes = m_scene.nodes();
    for (Node& node : nodes)
      if (node.id == (group ? m_group : m_other))
        node.locked = true;
    m_scene.setNodes(nodes);
    const Scene scene = at(0.5f);
    QVERIFY(*scene.find(m_other) == *m_scene.find(m_other));
    QCOMPARE(*scene.find(m_target) == *m_scene.find(m_target), group);
    QVERIFY(!(*scene.find(m_third) == *m_scene.find(m_third)));
  }

  void whatPeopleHideStaysHidden() {
    const NodeId other[] = {m_other};
    m_scene = withHidden(m_scene, other).scene;
    QVERIFY(!at(1.0f).resolve(m_other).visible);
    QCOMPARE(hiddenByHand(m_scene, m_analysis), std::vector<NodeId>{m_other});
    ContextWishes wishes;
    wishes.hiddenToo = true;
    QVERIFY(at(1.0f, wishes).resolve(m_other).visible);
    // The same holds after focusing, and when the amount changes then.
    m_scene = withShown(m_scene, other).scene;
    m_scene = withHidden(at(0.8f), other).scene;
    QVERIFY(!at(1.0f).resolve(m_other).visible);
  }

  /// Another focus leaves what a person has set since, until she gives it back.
  void whatPeopleSetStays() {
    m_scene = at(0.5f);
    QVERIFY(setByHand(m_scene).empty());
    const NodeId other[] = {m_other};
    const Scene given = m_scene;
    m_scene = withLook(m_scene, other, {.gamma = Gamma::clamped(5.0f)}).scene;
    QCOMPARE(setByHand(m_scene), std::vector<NodeId>{m_other});
    const Scene more = at(1.0f);
    QVERIFY(more.find(m_other)->style == m_scene.find(m_other)->style);
    QVERIFY(more.find(m_third)->style != m_scene.find(m_third)->style);
    QCOMPARE(setByHand(more), std::vector<NodeId>{m_other});
    // Given back it looks as it would without her hand.
    const Edited back = withoutHand(more, other);
    QVERIFY(back.changed && setByHand(back.scene).empty());
    m_scene = given;
    QVERIFY(back.scene == at(1.0f));
    QVERIFY(!withoutHand(back.scene, other).changed);
  }

  /// A colour is no affair of the focus, and who puts a structure in focus wants it as a target.
  void newTargetsAreDrawnAsSuch() {
    m_scene = at(0.5f);
    const NodeId other[] = {m_other};
    QVERIFY(setByHand(withLook(m_scene, other, {.colour = Colour{9, 9, 9}}).scene).empty());
    m_scene = withLook(m_scene, other, {.gamma = Gamma::clamped(1.0f)}).scene;
    m_analysis.asked = m_analysis.targets = {m_other};
    m_analysis.relations[0].role = ContextRole::backdrop;
    m_analysis.relations[1].role = ContextRole::target;
    const Scene scene = at(0.5f);
    QVERIFY(scene.find(m_other)->style.gamma->value() > 4.0f);
    // Once a target, it stays as she sets it then.
    m_scene = withLook(scene, other, {.gamma = Gamma::clamped(1.0f)}).scene;
    QCOMPARE(setByHand(m_scene), std::vector<NodeId>{m_other});
    QCOMPARE(at(1.0f).find(m_other)->style.gamma->value(), 1.0f);
  }

  void aLookForAllIsNoHand() {
    m_scene = at(0.8f);
    const NodeId all[] = {m_target, m_other, m_third};
    m_scene = withLook(m_scene, all, {.gamma = Gamma::clamped(5.0f)}).scene;
    QVERIFY(setByHand(m_scene).empty());
    QVERIFY(at(0.8f).find(m_third)->style.gamma->value() < 5.0f);
  }

  void theSceneSaysWhatIsInFocus() {
    ContextWishes wishes;
    wishes.roles[m_third] = ContextRole::shell;
    const Scene scene = at(0.7f, wishes);
    QCOMPARE(scene.focus().targets, std::vector<NodeId>{m_target});
    QCOMPARE(scene.focus().amount.value(), 0.7f);
    QVERIFY(scene.focus().wishes == wishes && !scene.focus().seenFrom);
    // A view has its own.
    const View view = viewOf(scene, {}, "view");
    QVERIFY(view.focus == scene.focus());
    QVERIFY(withViewApplied(m_scene, view).scene.focus() == scene.focus());
    QVERIFY(withViewApplied(scene, viewOf(m_scene, {}, "before")).scene.focus() == Focus());
    // What has gone is in no focus.
    const NodeId target[] = {m_target};
    Scene saved = scene;
    saved.setViews({view});
    const Scene without = removed(saved, target).scene;
    QVERIFY(without.focus().targets.empty() && without.focus().given.size() == 2);
    QVERIFY(without.views()[0].focus->targets.empty());
  }

  void hiddenTargetsAreShown() {
    const NodeId group[] = {m_group};
    m_scene = withHidden(m_scene, group).scene;
    const Scene scene = at(1.0f);
    QVERIFY(scene.resolve(m_target).visible);
    QVERIFY(!scene.resolve(m_other).visible);
  }

  void peopleKnowBetter() {
    ContextWishes wishes;
    wishes.roles[m_third] = ContextRole::shell;
    wishes.roles[m_other] = ContextRole::target;
    const Scene scene = at(1.0f, wishes);
    QVERIFY(scene.resolve(m_third).fill == Fill::none);
    QVERIFY(scene.resolve(m_other).gamma == scene.resolve(m_target).gamma);
  }

  void allElseIsKept() {
    m_scene.appendSection(anatomicalSection(m_scene, rootId, AnatomicalView::left));
    m_scene.appendAnnotation({.anchors = {glm::vec3(0.0f)}, .text = "here"});
    std::vector<Node> nodes = m_scene.nodes();
    nodes[1].style.colour = Colour{1, 2, 3};
    m_scene.setNodes(nodes);
    const Scene scene = at(0.5f);
    QVERIFY(scene.sections() == m_scene.sections());
    QVERIFY(scene.annotations() == m_scene.annotations());
    QVERIFY((scene.resolve(m_target).colour == Colour{1, 2, 3}));
    // A structure that has gone or come since does no harm.
    Scene other;
    other.append({.name = "new", .mesh = test::sphere(1.0f, 0)});
    m_analysis.relations[0].structure = NodeId{99};
    QVERIFY(withFocusAndContext(other, m_analysis, amount(0.5f)).scene.nodes().size() == 1);
  }
};

}  // namespace sline::model

SLINE_TEST(sline::model::FocusContextTest)
#include "focus_context_test.moc"
