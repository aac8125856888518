// SPDX-License-Identifier: Apache-2.0
#include "widgets/structure_tree/structure_actions.h"

#include <QAction>
#include <algorithm>
#include <array>

#include "model/edit/emphasis.h"
#include "model/edit/locks.h"
#include "widgets/structure_tree/structure_edits.h"
#include "widgets/structure_tree/structure_tree.h"
#include "widgets/structure_tree/structure_tree_view.h"
#include "widgets/viewport/viewport.h"

namespace sline::widgets {

namespace {

/// Pairs an action with the fields that it makes the nodes, and all below them, inherit.
struct InheritRow {
  const char* action;
  model::Style which;
};
std::array<InheritRow, 4> inheritRows() {
  return {{{"inherit", {.gamma = Gamma()}},
           {"inheritColour", {.colour = Colour()}},
           {"inheritOpacity", {.opacity = Opacity()}},
           {"inheritAll", model::wholeLook()}}};
}

/// The actions of hidden outlines, in the order of model::HiddenLines.
constexpr std::array<const char*, model::hiddenLinesNames.size()> hiddenLinesActions{
    "hiddenLinesNone", "hiddenLinesThin", "hiddenLinesDashed"};

}  // namespace

StructureActions::StructureActions(Session& session, StructureTree& tree, Viewport& viewport,
                                   const WindowActions& actions, QObject* parent)
    : QObject(parent), m_session(session), m_tree(tree), m_viewport(viewport), m_actions(actions) {
  connectLooks();
  connectSelection();
  connectTree();
  connect(&m_session, &Session::documentChanged, this, &StructureActions::showState);
  connect(&m_session, &Session::selectionChanged, this, &StructureActions::showState);
  connect(&m_tree.view(), &StructureTreeView::zoomWanted, &m_actions[QStringLiteral("zoomTo")],
          &QAction::trigger);
  m_actions[QStringLiteral("lock")].setCheckable(true);
  for (const char* id : hiddenLinesActions)
    m_actions[QLatin1String(id)].setCheckable(true);
  showState();
}

void StructureActions::editSelection(const QString& name, Edit made) {
  if (!m_session.selection().empty())
    m_session.apply(name, made(m_session.scene(), m_session.selection()));
}

void StructureActions::connectLooks() {
  const auto on = [this](const char* id, auto function) {
    connect(&m_actions[QLatin1String(id)], &QAction::triggered, this, function);
  };
  on("context", [this] { editSelection(tr("Context"), model::withContext); });
  on("ghost", [this] { ghostNodes(m_session, m_session.selection()); });
  for (std::size_t i = 0; i < hiddenLinesActions.size(); ++i)
    on(hiddenLinesActions[i], [this, how = model::HiddenLines(i)] {
      setHiddenLines(m_session, m_session.selection(), how);
      showState();  // the action has checked itself, whatever the result
    });
  for (const InheritRow& row : inheritRows())
    on(row.action, [this, row] { inherit(m_session, m_session.selection(), row.which); });
  on("toggle", [this] { toggleShown(m_session, m_session.selection()); });
  on("hide", [this] { hide(m_session, m_session.selection()); });
  on("isolate", [this] { isolate(m_session, m_session.selection()); });
  on("hideOthers", [this] { hideOthers(m_session, m_session.selection()); });
  on("showAll", [this] { showAll(m_session); });
  on("zoomTo", [this] { m_viewport.fitTo(m_session.selection()); });
  on("colour", [this] { m_tree.chooseColour(m_session.selection()); });
}

void StructureActions::connectSelection() {
  const auto on = [this](const char* id, auto function) {
    connect(&m_actions[QLatin1String(id)], &QAction::triggered, this, function);
  };
  on("selectAll", [this] { selectAll(m_session); });
  on("selectInverse", [this] { selectInverse(m_session); });
  on("selectSameKind", [this] { selectSameKind(m_session); });
  on("selectOtherSide", [this] { selectOtherSide(m_session); });
  on("selectInFocus", [this] { m_session.select(m_session.scene().focus().targets); });
  on("selectBox", [this] { m_viewport.drawBox(); });
}

void StructureActions::connectTree() {
  const auto on = [this](const char* id, auto function) {
    connect(&m_actions[QLatin1String(id)], &QAction::triggered, this, function);
  };
  on("rename", [this] { m_tree.view().renameCurrent(); });
  on("newGroup", [this] { nameGroup(addGroup(m_session, m_session.selection())); });
  on("group", [this] { nameGroup(groupNodes(m_session, m_session.selection())); });
  on("ungroup", [this] { ungroupNodes(m_session, m_session.selection()); });
  on("lock", [this] {
    toggleLocked(m_session, m_session.selection());
    showState();  // the action has checked itself, whatever the result
  });
  on("properties", [this] { m_tree.showProperties(m_session.selection()); });
  on("remove", [this] { removeNodes(m_session, m_session.selection()); });
}

void StructureActions::nameGroup(model::NodeId group) {
  if (group != model::rootId)
    m_tree.view().rename(group);
}

void StructureActions::showState() {
  const model::Scene& scene = m_session.scene();
  const NodeIds& ids = m_session.selection();
  // The session removes deleted nodes from the selection only after the document has changed.
  const bool any = !ids.empty() && std::all_of(ids.begin(), ids.end(), [&](model::NodeId id) {
    return scene.find(id) != nullptr;
  });
  const bool free = any && !model::editable(scene, ids).empty();
  for (const char* id : {"toggle", "hide", "isolate", "hideOthers", "zoomTo", "lock", "properties",
                         "focus", "selectSameKind", "selectOtherSide"})
    m_actions[QLatin1String(id)].setEnabled(any);
  for (const char* id : {"context", "ghost", "colour", "rename", "group", "remove"})
    m_actions[QLatin1String(id)].setEnabled(free);
  for (const InheritRow& row : inheritRows())
    m_actions[QLatin1String(row.action)].setEnabled(free && saysItself(scene, ids, row.which));
  const std::optional<model::HiddenLines> hidden = any ? hiddenLinesOf(scene, ids) : std::nullopt;
  for (std::size_t i = 0; i < hiddenLinesActions.size(); ++i) {
    m_actions[QLatin1String(hiddenLinesActions[i])].setEnabled(free);
    m_actions[QLatin1String(hiddenLinesActions[i])].setChecked(hidden == model::HiddenLines(i));
  }
  m_actions[QStringLiteral("ungroup")].setEnabled(
      free && std::any_of(ids.begin(), ids.end(),
                          [&](model::NodeId id) { return scene.find(id)->isGroup(); }));
  for (const char* id : {"newGroup", "selectAll", "selectInverse", "selectBox"})
    m_actions[QLatin1String(id)].setEnabled(!scene.nodes().empty());
  m_actions[QStringLiteral("selectInFocus")].setEnabled(!scene.focus().targets.empty());
  m_actions[QStringLiteral("lock")].setChecked(
      any && std::all_of(ids.begin(), ids.end(),
                         [&](model::NodeId id) { return scene.find(id)->locked; }));
}

}  // namespace sline::widgets

#include "moc_structure_actions.cpp"
