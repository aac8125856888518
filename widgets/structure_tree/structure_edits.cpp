// SPDX-License-Identifier: Apache-2.0
#include "widgets/structure_tree/structure_edits.h"

#include <algorithm>

#include "model/edit/emphasis.h"
#include "model/edit/locks.h"
#include "model/edit/tree.h"
#include "model/edit/visibility.h"
#include "model/focus/selection.h"
#include "model/scene/resolved_styles.h"
#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {

// lupdate does not know where tr() belongs in functions that return a qualified type.
QString groupText() {
  return tr("Group");
}
QString newGroupText() {
  return tr("New Group");
}

model::NodeId take(Session& session, const QString& name, model::Grouped grouped) {
  if (!session.apply(name, std::move(grouped.edited)))
    return model::rootId;
  session.select({grouped.group});
  return grouped.group;
}

}  // namespace

void toggleShown(Session& session, const NodeIds& ids) {
  if (ids.empty())
    return;
  const model::Scene& scene = session.scene();
  const bool all = std::all_of(ids.begin(), ids.end(), [&](model::NodeId id) {
    return model::visibilityOf(scene, id) == model::Visibility::all;
  });
  if (all)
    hide(session, ids);
  else
    session.apply(tr("Show"), model::withShown(scene, ids));
}

void hide(Session& session, const NodeIds& ids) {
  session.apply(tr("Hide"), model::withHidden(session.scene(), ids));
}

void toggleLocked(Session& session, const NodeIds& ids) {
  const model::Scene& scene = session.scene();
  const bool all =
      std::all_of(ids.begin(), ids.end(), [&](model::NodeId id) { return scene.find(id)->locked; });
  session.apply(all ? tr("Unlock") : tr("Lock"), model::withLocked(scene, ids, !all));
}

void isolate(Session& session, const NodeIds& ids) {
  if (!ids.empty() && !session.apply(tr("Isolate"), model::withOnlyVisible(session.scene(), ids)))
    showAll(session);
}

void hideOthers(Session& session, const NodeIds& ids) {
  session.apply(tr("Hide Others"), model::withOthersHidden(session.scene(), ids));
}

void showAll(Session& session) {
  NodeIds all;
  for (const model::Node& node : session.scene().nodes())
    all.push_back(node.id);
  session.apply(tr("Show All"), model::withShown(session.scene(), all));
}

void ghostNodes(Session& session, const NodeIds& ids) {
  session.apply(tr("Ghost"), model::withGhost(session.scene(), ids));
}

void setHiddenLines(Session& session, const NodeIds& ids, model::HiddenLines how) {
  const model::Style look{.hiddenLines = how};
  session.apply(tr("Hidden Outlines"), model::withLook(session.scene(), ids, look));
}

std::optional<model::HiddenLines> hiddenLinesOf(const model::Scene& scene, const NodeIds& ids) {
  const model::NodeSet meant = model::withAllBelow(scene, model::setOf(ids));
  const std::vector<model::ResolvedStyle> styles = model::resolveAll(scene);
  std::optional<model::HiddenLines> common;
  for (std::size_t i = 0; i < styles.size(); ++i) {
    const model::Node& node = scene.nodes()[i];
    if (node.isGroup() || !meant.contains(node.id.value))
      continue;
    if (common && *common != styles[i].hiddenLines)
      return std::nullopt;
    common = styles[i].hiddenLines;
  }
  return common;
}

void inherit(Session& session, const NodeIds& ids, const model::Style& which) {
  QString name = tr("Inherit All");
  if (which == model::Style{.gamma = Gamma()})
    name = tr("Inherit Γ");
  else if (which == model::Style{.colour = Colour()})
    name = tr("Inherit Colour");
  else if (which == model::Style{.opacity = Opacity()})
    name = tr("Inherit Opacity");
  session.apply(name, model::withLookInherited(session.scene(), ids, which));
}

bool saysItself(const model::Scene& scene, const NodeIds& ids, const model::Style& which) {
  const model::NodeSet meant = model::withAllBelow(scene, model::setOf(ids));
  return std::any_of(scene.nodes().begin(), scene.nodes().end(), [&](const model::Node& node) {
    return meant.contains(node.id.value) && model::picked(node.style, which) != model::Style();
  });
}

model::NodeId groupNodes(Session& session, const NodeIds& ids) {
  return take(session, groupText(),
              model::grouped(session.scene(), ids, groupText().toStdString()));
}

model::NodeId addGroup(Session& session, const NodeIds& ids) {
  const model::Node* only = ids.size() == 1 ? session.scene().find(ids.front()) : nullptr;
  const model::NodeId parent = !only ? model::rootId : only->isGroup() ? only->id : only->parent;
  return take(session, newGroupText(),
              model::withGroup(session.scene(), groupText().toStdString(), parent));
}

void ungroupNodes(Session& session, const NodeIds& ids) {
  NodeIds inside;
  for (const model::NodeId id : ids)
    for (const model::NodeId child : session.scene().children(id))
      inside.push_back(child);
  if (session.apply(tr("Ungroup"), model::ungrouped(session.scene(), ids)))
    session.select(std::move(inside));
}

void removeNodes(Session& session, const NodeIds& ids) {
  session.apply(tr("Remove"), model::removed(session.scene(), ids));
}

void moveNodes(Session& session, const NodeIds& ids, model::NodeId group, model::NodeId before) {
  session.apply(tr("Move"), model::moved(session.scene(), ids, group, before));
}

void selectAll(Session& session) {
  session.select(model::selectable(session.scene()));
}

void selectInverse(Session& session) {
  session.select(model::withoutSelected(session.scene(), session.selection()));
}

void selectSameKind(Session& session) {
  session.select(model::ofSameKind(session.scene(), session.selection()));
}

void selectOtherSide(Session& session) {
  if (NodeIds others = model::onOtherSide(session.scene(), session.selection()); !others.empty())
    session.select(std::move(others));
}

}  // namespace sline::widgets
