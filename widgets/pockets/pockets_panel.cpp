// SPDX-License-Identifier: Apache-2.0
#include "widgets/pockets/pockets_panel.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "model/pockets/pocket_focus.h"
#include "widgets/pockets/pocket_rows.h"
#include "widgets/viewport/viewport.h"

namespace sline::widgets {

PocketsPanel::PocketsPanel(Session& session, Viewport& viewport, QWidget* parent)
    : QWidget(parent), m_session(session), m_viewport(viewport), m_search(session) {
  m_hint = new QLabel;
  m_hint->setObjectName(QStringLiteral("pocketsHint"));
  m_hint->setTextFormat(Qt::PlainText);
  m_hint->setWordWrap(true);
  m_cancel = new QPushButton(tr("Cancel"));
  m_cancel->setObjectName(QStringLiteral("pocketsCancel"));
  m_list = new QTreeWidget;
  m_list->setObjectName(QStringLiteral("pocketList"));
  m_list->setAccessibleName(tr("Pockets"));
  m_list->setToolTip(tr("Click a pocket to put it in focus, with what lies in it"));
  m_list->setAllColumnsShowFocus(true);
  m_list->setIndentation(14);
  addPocketColumns(*m_list);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(14, 12, 14, 14);
  layout->setSpacing(8);
  layout->addWidget(m_hint);
  layout->addWidget(m_cancel);
  layout->addWidget(m_list, 1);
  layout->addWidget(makeOptions());
  const auto choose = [this] {
    if (const int pocket = pocketOfRow(*m_list); pocket >= 0)
      m_search.makeRoom(std::size_t(pocket));
  };
  connect(m_list, &QTreeWidget::itemClicked, this, choose);
  connect(m_list, &QTreeWidget::itemActivated, this, choose);
  connect(m_cancel, &QPushButton::clicked, &m_search, &PocketSearch::cancel);
  connect(&m_search, &PocketSearch::changed, this, &PocketsPanel::showState);
  connect(&m_search, &PocketSearch::roomMade, this, &PocketsPanel::focusOn);
  connect(&session.names(), &DisplayNames::changed, this, [this] {
    m_shown.reset();
    showState();
  });
  showState();
}

QWidget* PocketsPanel::makeOptions() {
  const model::PocketOptions& usual = m_search.options();
  m_probe = spin("pocketProbe", model::smallProbes, usual.smallProbe);
  m_probe->setToolTip(tr("Radius of the ball that goes into pockets; water has 1.4 Å"));
  m_largeProbe = spin("pocketLargeProbe", model::largeProbes, usual.largeProbe);
  m_largeProbe->setToolTip(tr(
      "Radius of the ball that stays out: with a larger one, shallower and wider pockets count"));
  m_leastVolume = spin("pocketLeastVolume", model::leastVolumes, usual.leastVolume);
  m_leastVolume->setSuffix(tr(" Å³"));
  m_leastVolume->setDecimals(0);
  m_leastVolume->setSingleStep(10.0);
  m_leastVolume->setToolTip(tr("Smaller pockets are left out"));
  auto* box = new QWidget;
  auto* form = new QFormLayout(box);
  form->setContentsMargins(0, 0, 0, 0);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("&Probe radius"), m_probe);
  form->addRow(tr("&Large probe"), m_largeProbe);
  form->addRow(tr("&Smallest"), m_leastVolume);
  return box;
}

QDoubleSpinBox* PocketsPanel::spin(const char* name, const Limits<float>& limits, float value) {
  auto* made = new QDoubleSpinBox;
  made->setObjectName(QLatin1String(name));
  made->setRange(double(limits.low), double(limits.high));
  made->setDecimals(1);
  made->setSingleStep(0.1);
  made->setSuffix(tr(" Å"));
  made->setValue(double(value));
  made->setKeyboardTracking(false);
  connect(made, &QDoubleSpinBox::valueChanged, this, &PocketsPanel::readOptions);
  return made;
}

void PocketsPanel::readOptions() {
  model::PocketOptions options = m_search.options();
  options.smallProbe = float(m_probe->value());
  options.largeProbe = float(m_largeProbe->value());
  options.leastVolume = float(m_leastVolume->value());
  m_search.setOptions(options);
}

void PocketsPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  m_search.setWanted(true);
}

void PocketsPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  m_search.setWanted(false);
}

void PocketsPanel::showState() {
  const auto& found = m_search.found();
  if (m_search.busy())
    m_hint->setText(tr("Looking for pockets …"));
  else if (!m_search.hasMolecules())
    m_hint->setText(tr("Open a protein from a PDB or mmCIF file to see its pockets here."));
  else if (!m_search.fault().isEmpty())
    m_hint->setText(m_search.fault());
  else if (!found)
    m_hint->setText(tr("Nothing was looked for. Change a radius to start."));
  else
    m_hint->setText(tr("%n pockets", nullptr, int(found->pockets.size())));
  m_cancel->setVisible(m_search.busy());
  if (found == m_shown)
    return;
  m_shown = found;
  m_list->clear();
  if (found)
    showPockets(*m_list, m_session, *found);
}

void PocketsPanel::focusOn(const std::shared_ptr<const model::ScenePockets>& found,
                           std::size_t pocket, const model::MeshPtr& room) {
  const model::ScenePocket& chosen = found->pockets[pocket];
  if (!m_session.apply(tr("Pocket %1 in Focus").arg(chosen.number),
                       model::withPocketInFocus(m_session.scene(), *found, pocket, room)))
    return;
  m_viewport.flyTo(model::viewIntoPocket(chosen, m_viewport.camera()));
  m_viewport.setPivot(glm::vec3(chosen.pocket.centre));
}

}  // namespace sline::widgets

#include "moc_pockets_panel.cpp"
