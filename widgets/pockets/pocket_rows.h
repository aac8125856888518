// SPDX-License-Identifier: Apache-2.0
// Shows pockets as rows of a tree.
#pragma once

class QTreeWidget;

namespace sline::model {
struct ScenePockets;
}

namespace sline::widgets {

class Session;

enum PocketColumn { pocketName, pocketVolume, pocketMouth, pocketBurial };

/// Gives the tree its columns.
void addPocketColumns(QTreeWidget& tree);
/// Replaces the rows; each has the residues at its wall below it.
void showPockets(QTreeWidget& tree, Session& session, const model::ScenePockets& found);
/// Returns the index of the pocket in the row, or −1.
int pocketOfRow(const QTreeWidget& tree);

}  // namespace sline::widgets
