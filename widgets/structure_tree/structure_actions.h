// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "model/edit/emphasis.h"
#include "widgets/session/session.h"
#include "widgets/shell/window_actions.h"

namespace sline::widgets {

class StructureTree;
class Viewport;

/// Runs the actions on the selected structures: emphasis, visibility, groups, locks, removal.
class StructureActions : public QObject {
  Q_OBJECT
 public:
  StructureActions(Session& session, StructureTree& tree, Viewport& viewport,
                   const WindowActions& actions, QObject* parent);

 private:
  using Edit = model::Edited (*)(const model::Scene&, std::span<const model::NodeId>);
  void connectLooks();
  void connectSelection();
  void connectTree();
  void editSelection(const QString& name, Edit made);
  /// Opens the name editor for a group that was just made.
  void nameGroup(model::NodeId group);
  void showState();

  Session& m_session;
  StructureTree& m_tree;
  Viewport& m_viewport;
  const WindowActions& m_actions;
};

}  // namespace sline::widgets
