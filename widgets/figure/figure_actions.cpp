// SPDX-License-Identifier: Apache-2.0
#include "widgets/figure/figure_actions.h"

#include <QAction>
#include <algorithm>

#include "widgets/figure/figure_dialog.h"
#include "widgets/shell/window_actions.h"

namespace sline::widgets {

FigureActions::FigureActions(Session& session, const WindowActions& actions, QWidget& window)
    : QObject(&window), m_session(session), m_actions(actions), m_window(window) {
  connect(&m_session, &Session::documentChanged, this, [this] {
    showState();
    if (m_dialog && m_opening == m_session.document().opening)
      m_dialog->sceneChanged(std::make_shared<const model::Scene>(m_session.sceneBeforePreview()));
  });
  controlsRemade();
}

FigureActions::~FigureActions() = default;

void FigureActions::controlsRemade() {
  connect(&m_actions[QStringLiteral("composeFigure")], &QAction::triggered, this,
          &FigureActions::showDialog);
  showState();
}

void FigureActions::showState() {
  const auto& nodes = m_session.scene().nodes();
  m_actions[QStringLiteral("composeFigure")].setEnabled(std::any_of(
      nodes.begin(), nodes.end(), [](const model::Node& node) { return !node.isGroup(); }));
}

void FigureActions::showDialog() {
  if (m_dialog) {
    m_dialog->raise();
    return m_dialog->activateWindow();
  }
  m_dialog = new FigureDialog(
      {std::make_shared<const model::Scene>(m_session.sceneBeforePreview()), m_session.file().path},
      &m_window);
  m_opening = m_session.document().opening;
  m_dialog->setAttribute(Qt::WA_DeleteOnClose);
  m_dialog->open();
}

}  // namespace sline::widgets

#include "moc_figure_actions.cpp"
