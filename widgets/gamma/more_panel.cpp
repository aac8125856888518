// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/more_panel.h"

#include <QSettings>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/gamma/gamma_map_editor.h"
#include "widgets/gamma/style_editors.h"
#include "widgets/gamma/threshold_editor.h"

namespace sline::widgets {

namespace {
constexpr const char* openKey = "gamma/more";
}  // namespace

MorePanel::MorePanel(Session& session, QSettings& settings, QWidget* parent)
    : QWidget(parent), m_settings(settings), m_fold(new QToolButton), m_content(new QWidget) {
  m_fold->setObjectName(QStringLiteral("more"));
  m_fold->setText(tr("More"));
  m_fold->setToolTip(tr("Lines, hatching, opacity and colours"));
  m_fold->setAutoRaise(true);
  m_fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  QFont bold = m_fold->font();
  bold.setBold(true);
  m_fold->setFont(bold);
  auto* rows = new QVBoxLayout(m_content);
  rows->setContentsMargins(4, 2, 0, 0);
  rows->setSpacing(9);
  for (const StyleNumber& row : styleNumbers())
    m_editors.push_back(new StyleNumberEditor(session, row));
  for (const StyleChoice& row : styleChoices())
    m_editors.push_back(new StyleChoiceEditor(session, row));
  m_editors.push_back(new ThresholdEditor(session));
  auto* map = new GammaMapEditor(session);
  connect(map, &GammaMapEditor::brushWanted, this, &MorePanel::brushWanted);
  m_editors.push_back(map);
  for (const StyleColour& row : styleColours())
    m_editors.push_back(new StyleColourEditor(session, row));
  for (StyleEditor* editor : m_editors)
    rows->addWidget(editor);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(m_fold);
  layout->addWidget(m_content);
  connect(m_fold, &QToolButton::clicked, this, [this] { unfold(!m_open); });
  unfold(settings.value(QLatin1String(openKey), false).toBool());
}

void MorePanel::unfold(bool open) {
  m_open = open;
  m_fold->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
  m_fold->setAccessibleDescription(open ? tr("Open") : tr("Folded away"));
  m_content->setVisible(open);
  m_settings.setValue(QLatin1String(openKey), open);
  if (open)
    emit opened();
}

void MorePanel::showSelection() {
  for (StyleEditor* editor : m_editors)
    editor->showSelection();
}

}  // namespace sline::widgets

#include "moc_more_panel.cpp"
