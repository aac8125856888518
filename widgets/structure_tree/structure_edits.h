// SPDX-License-Identifier: Apache-2.0
// What keys, menus and clicks ask for, as undo steps of the session with names that people read.
#pragma once

#include "model/edit/look.h"
#include "widgets/session/session.h"

namespace sline::widgets {

/// Hides the nodes where all of them is shown, else shows them.
void toggleShown(Session& session, const NodeIds& ids);
/// Locks the nodes, or unlocks them where each is locked.
void toggleLocked(Session& session, const NodeIds& ids);
/// Shows the nodes and nothing else; where that is so, everything.
void isolate(Session& session, const NodeIds& ids);
void hideOthers(Session& session, const NodeIds& ids);
void showAll(Session& session);
void ghostNodes(Session& session, const NodeIds& ids);
/// The nodes and all below them inherit again what `which` answers: Γ, colour, opacity or the whole
/// look.
void inherit(Session& session, const NodeIds& ids, const model::Style& which);
/// True where one of the nodes, or of those below them, says any of that itself.
bool saysItself(const model::Scene& scene, const NodeIds& ids, const model::Style& which);

/// A group of the nodes, selected; the root where there is none.
model::NodeId groupNodes(Session& session, const NodeIds& ids);
/// An empty group beside or, where the only node is a group, within what is selected; selected.
model::NodeId addGroup(Session& session, const NodeIds& ids);
/// Dissolves the groups; what was in them is selected.
void ungroupNodes(Session& session, const NodeIds& ids);
void removeNodes(Session& session, const NodeIds& ids);
void moveNodes(Session& session, const NodeIds& ids, model::NodeId group, model::NodeId before);

}  // namespace sline::widgets
