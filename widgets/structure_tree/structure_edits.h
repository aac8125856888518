// SPDX-License-Identifier: Apache-2.0
// Carries out what keys, menus and clicks ask for, as undo steps of the session with names that the
// user reads.
#pragma once

#include "model/edit/look.h"
#include "widgets/session/session.h"

namespace sline::widgets {

/// Hides the nodes.
void hide(Session& session, const NodeIds& ids);
/// Hides the nodes if all of them are shown, else shows them.
void toggleShown(Session& session, const NodeIds& ids);
/// Locks the nodes, or unlocks them if each is locked.
void toggleLocked(Session& session, const NodeIds& ids);
/// Shows the nodes and nothing else; if that is already so, shows everything.
void isolate(Session& session, const NodeIds& ids);
void hideOthers(Session& session, const NodeIds& ids);
void showAll(Session& session);
void ghostNodes(Session& session, const NodeIds& ids);
/// Draws the nodes' outlines that way where other structures hide them; what is in a group follows
/// it again.
void setHiddenLines(Session& session, const NodeIds& ids, model::HiddenLines how);
/// Returns how the outlines of all structures among the nodes, and in groups among them, are drawn
/// where they are hidden; nothing where they differ or there are none.
std::optional<model::HiddenLines> hiddenLinesOf(const model::Scene& scene, const NodeIds& ids);
/// Makes the nodes and all below them inherit again what `which` sets: Γ, colour, opacity or the
/// whole look.
void inherit(Session& session, const NodeIds& ids, const model::Style& which);
/// Tells whether one of the nodes, or of those below them, sets any of that itself.
bool saysItself(const model::Scene& scene, const NodeIds& ids, const model::Style& which);

/// Groups and selects the nodes; returns the group, or the root where none was made.
model::NodeId groupNodes(Session& session, const NodeIds& ids);
/// Adds and selects an empty group, beside the selection or, if that is a single group, within it.
model::NodeId addGroup(Session& session, const NodeIds& ids);
/// Dissolves the groups and selects what was in them.
void ungroupNodes(Session& session, const NodeIds& ids);
void removeNodes(Session& session, const NodeIds& ids);
void moveNodes(Session& session, const NodeIds& ids, model::NodeId group, model::NodeId before);

/// Selects all structures that can be clicked: they are shown and not locked.
void selectAll(Session& session);
/// Selects those of them that are not selected.
void selectInverse(Session& session);
/// Selects those of the selected ones' kinds, or where all of these are selected of their systems.
void selectSameKind(Session& session);
/// Selects the selected ones' partners on the other side of the body, if there are any.
void selectOtherSide(Session& session);

}  // namespace sline::widgets
