// SPDX-License-Identifier: Apache-2.0
#include "widgets/focus/near_row.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <cmath>

#include "widgets/session/length_texts.h"

namespace sline::widgets {

namespace {

constexpr float leastMm = 1.0f;
constexpr float mostMm = 1000.0f;
constexpr int falloffSteps = 200;

float millimetresAt(int step) {
  return leastMm * std::pow(mostMm / leastMm, float(step) / float(falloffSteps));
}

int stepAt(float millimetres) {
  return int(std::lround(float(falloffSteps) * std::log(millimetres / leastMm) /
                         std::log(mostMm / leastMm)));
}

}  // namespace

NearRow::NearRow(Session& session, NearTool& tool, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_tool(tool),
      m_selection(new QPushButton(tr("By Nearness"))),
      m_place(new QPushButton(tr("Near a Place"))),
      m_reach(new QWidget),
      m_falloff(new QSlider(Qt::Horizontal)),
      m_millimetres(new QLabel) {
  m_selection->setObjectName(QStringLiteral("nearSelection"));
  m_selection->setToolTip(
      tr("The selected shaded, everything else the less detailed the farther away it is"));
  m_place->setObjectName(QStringLiteral("nearPlace"));
  m_place->setToolTip(
      tr("Click in the picture to set the place, and drag it; with Shift in depth"));
  m_place->setCheckable(true);
  m_falloff->setObjectName(QStringLiteral("nearFalloff"));
  m_falloff->setAccessibleName(tr("Reach"));
  m_falloff->setToolTip(tr("From what distance on there are only silhouettes"));
  m_falloff->setRange(0, falloffSteps);
  m_millimetres->setObjectName(QStringLiteral("nearMillimetres"));
  m_millimetres->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("0000 mm")));
  m_millimetres->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  auto* ways = new QHBoxLayout;
  ways->setSpacing(4);
  ways->addWidget(m_selection);
  ways->addWidget(m_place);
  auto* reach = new QHBoxLayout(m_reach);
  reach->setContentsMargins(0, 0, 0, 0);
  auto* label = new QLabel(tr("Reach"));
  label->setBuddy(m_falloff);
  reach->addWidget(label);
  reach->addWidget(m_falloff, 1);
  reach->addWidget(m_millimetres);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addLayout(ways);
  layout->addWidget(m_reach);
  connect(m_selection, &QPushButton::clicked, this,
          [this] { m_tool.focusOn(m_session.selection()); });
  connect(m_place, &QPushButton::toggled, &m_tool, &NearTool::setPlacing);
  connect(&m_tool, &NearTool::placingChanged, m_place, &QPushButton::setChecked);
  connect(m_falloff, &QSlider::valueChanged, this, [this](int step) {
    m_tool.dragFalloff(millimetresAt(step));
    // A key or the wheel changes it in one step.
    if (!m_falloff->isSliderDown())
      m_tool.finishFalloff();
  });
  connect(m_falloff, &QSlider::sliderReleased, &m_tool, &NearTool::finishFalloff);
  connect(&m_session, &Session::documentChanged, this, &NearRow::refresh);
  connect(&m_session, &Session::selectionChanged, this, &NearRow::refresh);
  refresh();
}

void NearRow::refresh() {
  m_selection->setEnabled(!m_session.selection().empty());
  m_place->setEnabled(!m_session.scene().nodes().empty());
  m_place->setChecked(m_tool.placing());
  m_reach->setVisible(m_session.scene().focus().nearness.has_value());
  const QSignalBlocker quiet(m_falloff);
  const float falloff = m_tool.falloffMm();
  if (!m_falloff->isSliderDown())
    m_falloff->setValue(stepAt(std::clamp(falloff, leastMm, mostMm)));
  m_millimetres->setText(lengthText(m_session.scene(), double(falloff)));
}

}  // namespace sline::widgets

#include "moc_near_row.cpp"
