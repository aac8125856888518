// SPDX-License-Identifier: Apache-2.0
// Tests five hundred random edits of all kinds, taken back to the first and done again to the last:
// at each step the document is what it was there, whether the session is tested alone or the window
// follows and takes part.
#include <QAction>
#include <QLineEdit>
#include <QtTest>
#include <random>

#include "model/edit/annotations.h"
#include "model/edit/emphasis.h"
#include "model/edit/look.h"
#include "model/edit/sections.h"
#include "model/edit/tree.h"
#include "model/edit/views.h"
#include "model/edit/visibility.h"
#include "model/focus/context.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"
#include "widgets/focus/focus_context.h"

namespace sline::test {

namespace {

using model::NodeId;
using widgets::Document;
using widgets::NodeIds;
using widgets::Session;

/// Returns twenty balls in four groups, one of them within another.
model::Scene body() {
  model::Scene scene;
  const model::MeshPtr ball = sphere(9.0f, 1);
  std::vector<NodeId> groups;
  for (int g = 0; g < 4; ++g)
    groups.push_back(scene.append(
        {.parent = g == 3 ? groups[0] : model::rootId, .name = "group " + std::to_string(g)}));
  for (int i = 0; i < 20; ++i) {
    const glm::vec3 place(20 * (i % 5), 20 * (i / 5 % 2), 20 * (i / 10));
    scene.append({.parent = i == 19 ? model::rootId : groups[std::size_t(i % 4)],
                  .name = "ball " + std::to_string(i),
                  .mesh = moved(*ball, 1.0f, place)});
  }
  return scene;
}

/// Makes random choices; the same seed gives the same ones.
class Chance {
 public:
  explicit Chance(std::uint32_t seed) : m_random(seed) {}
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(m_random); }
  float share() { return std::uniform_real_distribution<float>(0.0f, 1.0f)(m_random); }
  bool rarely() { return below(12) == 0; }
  NodeId node(const model::Scene& scene) {
    return scene.nodes()[std::size_t(below(int(scene.nodes().size())))].id;
  }
  NodeIds some(const model::Scene& scene) {
    NodeIds ids;
    for (int i = 1 + below(3); i > 0; --i)
      ids.push_back(node(scene));
    return ids;
  }
  Colour colour() { return {std::uint8_t(below(256)), std::uint8_t(below(256)), 90}; }

 private:
  std::mt19937 m_random;
};

model::Edited styleEdit(const model::Scene& scene, Chance& chance) {
  const NodeIds ids = chance.some(scene);
  model::Style style;
  switch (chance.below(9)) {
    case 0:
      return model::withLook(scene, ids, {.gamma = Gamma::clamped(5.0f * chance.share())});
    case 1:
      return model::withLook(scene, ids, {.colour = chance.colour()});
    case 2:
      return model::withLook(scene, ids, {.fill = model::Fill(chance.below(4))});
    case 3:
      return model::withLookInherited(scene, ids, {.gamma = Gamma()});
    case 4:
      return model::withContext(scene, ids);
    case 5:
      return model::withGhost(scene, ids);
    case 6:
      return model::withLookInherited(scene, ids, model::wholeLook());
    case 7:
      return chance.rarely() ? model::withInkAlone(scene) : model::withShown(scene, ids);
    default:
      style.opacity = Opacity::clamped(chance.share());
      style.penWeight = chance.share();
      style.hatchDensity = HatchDensity::clamped(chance.share());
      style.inkColour = chance.colour();
      return model::withLook(scene, ids, style);
  }
}

model::Edited treeEdit(const model::Scene& scene, Chance& chance) {
  const NodeIds ids = chance.some(scene);
  switch (chance.below(6)) {
    case 0:
      return model::renamed(scene, ids.front(), "name " + std::to_string(chance.below(100)));
    case 1:
      return model::moved(scene, ids, chance.node(scene));
    case 2:
      return model::withHidden(scene, ids);
    case 3:
      return model::withShown(scene, ids);
    case 4:
      return model::withOnlyVisible(scene, ids);
    default:
      // Few are removed, so that there is something left to edit.
      return scene.nodes().size() > 12 && chance.rarely() ? model::removed(scene, ids)
                                                          : model::moved(scene, ids, model::rootId);
  }
}

model::Edited sectionEdit(const model::Scene& scene, Chance& chance) {
  const auto side = model::AnatomicalView(chance.below(6));
  if (scene.sections().empty() || chance.below(3) == 0)
    return model::withSection(
        scene, model::anatomicalSection(scene, chance.node(scene), side, 50.0f * chance.share()));
  const std::size_t which = std::size_t(chance.below(int(scene.sections().size())));
  model::Section section = scene.sections()[which];
  if (chance.below(3) == 0) {
    const model::SectionId ids[] = {section.id};
    return model::withoutSections(scene, ids);
  }
  section.plane = model::anatomicalPlane(side, 40.0f * chance.share());
  section.enabled = chance.below(4) != 0;
  section.hatched = chance.below(2) == 0;
  section.faces = model::CutFaces(chance.below(3));
  return model::withSectionChanged(scene, section.id, section);
}

model::Edited wordEdit(const model::Scene& scene, Chance& chance) {
  if (chance.below(4) == 0)
    return model::withKeyLight(scene, model::KeyLight{.shades = chance.below(2) == 0});
  const std::vector<NodeId> structures = scene.structuresBelow(model::rootId);
  model::Annotation word{.text = "word " + std::to_string(chance.below(50))};
  if (structures.empty() || chance.below(3) == 0)
    word.anchors = {glm::vec3(chance.share())};
  else
    word.anchors = {model::SurfacePoint{
        structures[std::size_t(chance.below(int(structures.size())))], 3, {0.2f, 0.3f}}};
  if (scene.annotations().empty() || chance.below(2) == 0)
    return model::withAnnotation(scene, word);
  const model::AnnotationId id =
      scene.annotations()[std::size_t(chance.below(int(scene.annotations().size())))].id;
  const model::AnnotationId ids[] = {id};
  return chance.below(2) == 0 ? model::withAnnotationChanged(scene, id, word)
                              : model::withoutAnnotations(scene, ids);
}

model::Edited focusEdit(const model::Scene& scene, Chance& chance) {
  static model::FormIndex forms;
  const NodeIds targets = chance.some(scene);
  const auto analysis = model::analysed(scene, {targets, std::nullopt}, forms);
  if (!analysis)
    return {scene, false};
  return model::withFocusAndContext(scene, *analysis,
                                    model::ContextAmount::clamped(chance.share()));
}

model::Edited viewEdit(const model::Scene& scene, Chance& chance) {
  // The view has a few looks; structures without one stay as they are.
  std::vector<model::Look> looks = model::looksOf(scene);
  looks.resize(std::min<std::size_t>(looks.size(), 5));
  for (model::Look& look : looks)
    look.style.gamma = Gamma::clamped(5.0f * chance.share());
  model::View view{.name = "view", .looks = std::move(looks)};
  model::Scene shown = model::withViewApplied(scene, view).scene;
  const bool changed = !(shown == scene);
  return {std::move(shown), changed};
}

model::Edited anyEdit(const model::Scene& scene, Chance& chance) {
  switch (chance.below(10)) {
    case 0:
    case 1:
    case 2:
      return styleEdit(scene, chance);
    case 3:
    case 4:
      return treeEdit(scene, chance);
    case 5:
      return sectionEdit(scene, chance);
    case 6:
      return wordEdit(scene, chance);
    case 7:
      return focusEdit(scene, chance);
    case 8:
      return viewEdit(scene, chance);
    default:
      return styleEdit(scene, chance);
  }
}

/// Remembers what the document was at each place of a session's history.
class Walk : public QObject {
 public:
  explicit Walk(Session& session) : m_session(session), m_states{session.document()} {
    connect(&session.history(), &QUndoStack::indexChanged, this, &Walk::note);
  }

  /// Goes to the first step and to the last again; returns the first fault, or nothing.
  QString thereAndBack() {
    while (m_session.history().canUndo()) {
      m_session.undo();
      if (!right())
        return QStringLiteral("undo to step %1").arg(m_session.history().index());
    }
    if (m_session.history().index() != 0)
      return QStringLiteral("the first step is not the first");
    while (m_session.history().canRedo()) {
      m_session.redo();
      if (!right())
        return QStringLiteral("redo to step %1").arg(m_session.history().index());
    }
    return {};
  }

 private:
  void note(int index) {
    const auto place = std::size_t(index);
    if (place < m_states.size() && m_states[place] == m_session.document())
      return;                // a step back or forth
    m_states.resize(place);  // a new step, or a longer one
    m_states.push_back(m_session.document());
  }

  bool right() const {
    return m_session.document() == m_states[std::size_t(m_session.history().index())];
  }

  Session& m_session;
  std::vector<Document> m_states;
};

/// Makes one edit through the session: at once, in a series, or as a drag that is kept or given up.
void editSession(Session& session, Chance& chance, int number) {
  const QString name = QStringLiteral("edit %1").arg(number);
  switch (chance.below(8)) {
    case 0:
      session.select(chance.some(session.scene()));
      session.apply(name, anyEdit(session.scene(), chance));
      break;
    case 1:
      for (int i = 0; i < 3; ++i)
        session.apply(name, anyEdit(session.scene(), chance), name);
      break;
    case 2:
    case 3:
      for (int i = 1 + chance.below(4); i > 0; --i)
        session.preview(anyEdit(session.sceneBeforePreview(), chance).scene);
      if (chance.below(3) == 0)
        session.cancelPreview();
      else
        session.commitPreview(name);
      break;
    case 4:
      // An edit, or going back, comes in the midst of a drag.
      session.preview(anyEdit(session.sceneBeforePreview(), chance).scene);
      if (chance.below(2) == 0 || !session.apply(name, anyEdit(session.scene(), chance)))
        session.cancelPreview();
      break;
    default:
      session.apply(name, anyEdit(session.scene(), chance));
  }
}

bool open(Session& session) {
  session.openMade(
      QStringLiteral("balls"),
      [](const model::ImportProgress&, const std::stop_token&) -> Result<widgets::LoadedDocument> {
        return widgets::LoadedDocument{.scene = body(), .title = QStringLiteral("balls")};
      });
  return QTest::qWaitFor([&] { return !session.busy(); });
}

}  // namespace

class UndoWalkTest : public QObject {
  Q_OBJECT

  /// Makes one edit with mouse or keys on the window; it may do nothing.
  static void editByHand(WindowFixture& f, Chance& chance) {
    const auto press = [&f](int key, Qt::KeyboardModifiers keys = {}) {
      QTest::keyClick(&f.window, Qt::Key(key), keys);
    };
    const std::vector<NodeId> all = f.session.scene().structuresBelow(model::rootId);
    if (all.empty())
      return;
    const NodeId id = all[std::size_t(chance.below(int(all.size())))];
    f.session.select({id});
    switch (chance.below(8)) {
      case 0:
        press(Qt::Key_F);
        QVERIFY(QTest::qWaitFor([&f] { return !f.window.focus().busy(); }));
        break;
      case 1:
        press(Qt::Key_D, Qt::ControlModifier);
        break;
      case 2:
        press(Qt::Key_1 + chance.below(3), Qt::ControlModifier);
        break;
      case 3:
        press(Qt::Key_X);
        break;
      case 4:
        press(Qt::Key_K);
        break;
      case 5:
        QTest::keyClick(&f.tree(), Qt::Key_Space);
        break;
      default:
        f.pullGamma(id, 5.0f * chance.share());
        if (chance.below(3) == 0)
          QTest::keyClick(&f.tree(), Qt::Key_Escape);
        f.letGoOfGamma();
    }
  }

  static void goBackSometimes(Session& session, Chance& chance) {
    if (!chance.rarely())
      return;
    const int way = 1 + chance.below(4);
    for (int i = 0; i < way; ++i)
      session.undo();
    for (int i = chance.below(way + 1); i > 0; --i)
      session.redo();
  }

 private slots:
  void theSessionAlone_data() {
    QTest::addColumn<uint>("seed");
    for (const uint seed : {1u, 2u, 3u})
      QTest::addRow("seed %u", seed) << seed;
  }
  void theSessionAlone() {
    QFETCH(uint, seed);
    constexpr int edits = 500;
    Session session;
    QVERIFY(open(session));
    Walk walk(session);
    Chance chance(seed);
    for (int i = 0; i < edits; ++i) {
      editSession(session, chance, i);
      QVERIFY(!session.previewing());
      goBackSometimes(session, chance);
    }
    QVERIFY(session.history().count() > edits / 4);
    const QString wrong = walk.thereAndBack();
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
  }

  /// The window follows, and every fifth edit is by hand.
  void withTheWindow() {
    constexpr int edits = 500;
    WindowFixture f;
    QVERIFY(open(f.session));
    Walk walk(f.session);
    Chance chance(11);
    for (int i = 0; i < edits; ++i) {
      if (i % 5 == 0)
        editByHand(f, chance);
      else
        editSession(f.session, chance, i);
      QVERIFY(!f.session.previewing());
      goBackSometimes(f.session, chance);
    }
    QVERIFY(f.session.history().count() > edits / 4);
    const QString wrong = walk.thereAndBack();
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    // The tree shows the current scene, not an earlier one.
    for (const model::Node& node : f.session.scene().nodes())
      QCOMPARE(f.tree().indexOf(node.id).data().toString(), QString::fromStdString(node.name));
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::UndoWalkTest)
#include "undo_walk_test.moc"
