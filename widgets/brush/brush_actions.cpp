// SPDX-License-Identifier: Apache-2.0
#include "widgets/brush/brush_actions.h"

#include <QAction>
#include <QKeyEvent>

namespace sline::widgets {

BrushActions::BrushActions(Session& session, BrushTool& tool, QWidget& picture,
                           const WindowActions& actions, QObject* parent)
    : QObject(parent),
      m_tool(tool),
      m_actions(actions),
      m_bar(new BrushBar(session, tool, picture)) {
  constexpr float larger = 1.15f;
  QAction& brush = m_actions[QStringLiteral("brush")];
  brush.setCheckable(true);
  connect(&brush, &QAction::triggered, &tool, &BrushTool::setActive);
  connect(&m_actions[QStringLiteral("brushSmaller")], &QAction::triggered, this,
          [this] { resize(1.0f / larger); });
  connect(&m_actions[QStringLiteral("brushLarger")], &QAction::triggered, this,
          [this] { resize(larger); });
  connect(&m_actions[QStringLiteral("brushErase")], &QAction::triggered, this, [this] {
    Brush other = m_tool.brush();
    other.erases = !other.erases;
    m_tool.setBrush(other);
  });
  m_actions[QStringLiteral("brushErase")].setCheckable(true);
  // Whoever takes up another tool puts this one away.
  for (const char* other : {"selectBox", "annotateLabel", "annotateCallout", "annotatePin",
                            "annotateDistance", "makeLike"})
    connect(&m_actions[QLatin1String(other)], &QAction::triggered, this,
            [this] { m_tool.setActive(false); });
  connect(&tool, &BrushTool::activeChanged, this, &BrushActions::showState);
  connect(&tool, &BrushTool::brushChanged, this, &BrushActions::showState);
  picture.installEventFilter(this);
  showState();
}

BrushActions::~BrushActions() {
  delete m_bar;
}

void BrushActions::resize(float factor) {
  Brush brush = m_tool.brush();
  brush.radius *= factor;
  m_tool.setBrush(brush);
}

void BrushActions::showState() {
  m_actions[QStringLiteral("brush")].setChecked(m_tool.active());
  for (const char* id : {"brushSmaller", "brushLarger", "brushErase"})
    m_actions[QLatin1String(id)].setEnabled(m_tool.active());
  m_actions[QStringLiteral("brushErase")].setChecked(m_tool.brush().erases);
}

bool BrushActions::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress && m_tool.active() && !m_tool.painting() &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    m_tool.setActive(false);
    return true;
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace sline::widgets

#include "moc_brush_actions.cpp"
