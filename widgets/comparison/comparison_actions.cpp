// SPDX-License-Identifier: Apache-2.0
#include "widgets/comparison/comparison_actions.h"

#include <QAction>
#include <QDir>
#include <QFileInfo>
#include <algorithm>

#include "model/scene/resolved_styles.h"
#include "model/scene/visible_structures.h"
#include "widgets/comparison/comparison_dialog.h"
#include "widgets/shell/window_actions.h"
#include "widgets/text/path_text.h"
#include "widgets/viewport/viewport.h"

namespace sline::widgets {

namespace {

/// Returns the visible structures at or below the ids.
model::Scene comparedPart(const model::Scene& scene, const NodeIds& ids) {
  model::Scene part;
  for (const model::VisibleStructure& structure : model::visibleStructures(scene))
    if (std::any_of(ids.begin(), ids.end(),
                    [&](model::NodeId id) { return scene.isBelow(structure.node->id, id); }))
      part.append({.name = structure.node->name,
                   .mesh = structure.node->mesh,
                   .provenance = structure.node->provenance});
  return part;
}

/// Returns what of the selection is seen, each with all below it, as rows; none where that is one
/// or too many.
std::vector<ComparisonRows::Model> apart(const model::Scene& scene, const NodeIds& ids,
                                         const DisplayNames& names) {
  std::vector<ComparisonRows::Model> rows;
  for (const model::NodeId id : ids) {
    const bool within = std::any_of(ids.begin(), ids.end(), [&](model::NodeId other) {
      return other != id && scene.isBelow(id, other);
    });
    if (within)
      continue;
    model::Scene part = comparedPart(scene, {id});
    if (!part.nodes().empty())
      rows.push_back({names.shown(scene.find(id)->name).toStdString(), std::move(part)});
  }
  return rows.size() > 1 && rows.size() <= ComparisonRows::most
             ? rows
             : std::vector<ComparisonRows::Model>{};
}

}  // namespace

ComparisonActions::ComparisonActions(const Context& context, QWidget& window)
    : QObject(&window),
      m_session(context.session),
      m_actions(context.actions),
      m_viewport(context.viewport),
      m_window(window) {
  connect(&m_session, &Session::documentChanged, this, &ComparisonActions::showState);
  controlsRemade();
}

ComparisonActions::~ComparisonActions() {
  m_queue.drop();
}

void ComparisonActions::controlsRemade() {
  connect(&m_actions[QStringLiteral("compareTechniques")], &QAction::triggered, this,
          &ComparisonActions::showDialog);
  showState();
}

void ComparisonActions::showState() {
  const auto& nodes = m_session.scene().nodes();
  m_actions[QStringLiteral("compareTechniques")].setEnabled(std::any_of(
      nodes.begin(), nodes.end(), [](const model::Node& node) { return !node.isGroup(); }));
}

void ComparisonActions::showDialog() {
  if (m_dialog) {
    m_dialog->raise();
    return m_dialog->activateWindow();
  }
  const model::Scene scene = m_session.sceneBeforePreview();
  model::Scene part = comparedPart(scene, m_session.selection());
  if (part.nodes().empty())
    part = comparedPart(scene, {model::rootId});
  if (part.nodes().empty())
    return;
  const QString name = part.nodes().size() == 1 ? m_session.names().shown(part.nodes().front().name)
                                                : m_session.publicTitle();
  const std::filesystem::path& file = m_session.file().path;
  m_dialog =
      new ComparisonDialog({.whole = {name.toStdString(), std::move(part)},
                            .apart = apart(scene, m_session.selection(), m_session.names()),
                            .camera = m_viewport.camera(),
                            .folder = file.empty() ? QDir::homePath() : textOf(file.parent_path())},
                           m_viewport, m_queue, &m_window);
  m_dialog->setAttribute(Qt::WA_DeleteOnClose);
  m_dialog->open();
}

}  // namespace sline::widgets

#include "moc_comparison_actions.cpp"
