// SPDX-License-Identifier: Apache-2.0
#include "widgets/brush/brush_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "model/edit/painting.h"
#include "widgets/session/length_texts.h"

namespace sline::widgets {

namespace {

constexpr int steps = 100;
constexpr int widestTarget = 130;  ///< pixels
constexpr int margin = 12;         ///< pixels from the picture's lower edge

/// Sizes are felt as ratios.
float radiusAt(int step) {
  return brushRadii.low * std::pow(brushRadii.high / brushRadii.low, float(step) / float(steps));
}

int stepOf(float radius) {
  return int(std::lround(float(steps) * std::log(radius / brushRadii.low) /
                         std::log(brushRadii.high / brushRadii.low)));
}

}  // namespace

BrushBar::BrushBar(Session& session, BrushTool& tool, QWidget& picture)
    : QFrame(&picture), m_session(session), m_tool(tool), m_picture(picture) {
  setObjectName(QStringLiteral("brushBar"));
  setAccessibleName(tr("Brush"));
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setCursor(Qt::ArrowCursor);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(10, 5, 8, 5);
  layout->setSpacing(6);
  m_target = new QLabel;
  m_target->setObjectName(QStringLiteral("brushTarget"));
  m_target->setTextFormat(Qt::PlainText);
  layout->addWidget(m_target);
  m_size = addSlider("brushSize", tr("Size"), tr("Radius of the brush ([ and ])"));
  m_millimetres = new QLabel;
  m_millimetres->setObjectName(QStringLiteral("brushMillimetres"));
  m_millimetres->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("000.0 mm")));
  layout->addWidget(m_millimetres);
  m_softness = addSlider("brushSoftness", tr("Softness"),
                         tr("How much weaker the brush is towards its rim"));
  m_strength =
      addSlider("brushStrength", tr("Strength"), tr("How much a stroke paints in its middle"));
  m_erase = addButton("brushErase", tr("Erase"), tr("Take away instead (Ctrl while you paint)"));
  m_erase->setCheckable(true);
  m_clear =
      addButton("brushClear", tr("Clear"), tr("Take away all that is painted on the selected"));
  m_done = addButton("brushDone", tr("Done"), tr("Put the brush away (Esc)"));
  connectControls();
  m_picture.installEventFilter(this);
  refresh();
}

QSlider* BrushBar::addSlider(const char* name, const QString& text, const QString& tip) {
  auto* label = new QLabel(text);
  auto* slider = new QSlider(Qt::Horizontal);
  slider->setObjectName(QLatin1String(name));
  slider->setAccessibleName(text);
  slider->setToolTip(tip);
  slider->setRange(0, steps);
  slider->setFixedWidth(58);
  label->setBuddy(slider);
  layout()->addWidget(label);
  layout()->addWidget(slider);
  return slider;
}

QToolButton* BrushBar::addButton(const char* name, const QString& text, const QString& tip) {
  auto* button = new QToolButton;
  button->setObjectName(QLatin1String(name));
  button->setText(text);
  button->setToolTip(tip);
  button->setAutoRaise(true);
  layout()->addWidget(button);
  return button;
}

void BrushBar::connectControls() {
  const auto change = [this](const auto& set) {
    Brush brush = m_tool.brush();
    set(brush);
    m_tool.setBrush(brush);
  };
  connect(m_size, &QSlider::valueChanged, this, [change](int value) {
    change([value](Brush& brush) { brush.radius = radiusAt(value); });
  });
  connect(m_softness, &QSlider::valueChanged, this, [change](int value) {
    change([value](Brush& brush) { brush.softness = float(value) / float(steps); });
  });
  connect(m_strength, &QSlider::valueChanged, this, [change](int value) {
    change([value](Brush& brush) { brush.strength = float(value) / float(steps); });
  });
  connect(m_erase, &QToolButton::toggled, this,
          [change](bool erases) { change([erases](Brush& brush) { brush.erases = erases; }); });
  connect(m_clear, &QToolButton::clicked, this, &BrushBar::clear);
  connect(m_done, &QToolButton::clicked, this, [this] { m_tool.setActive(false); });
  connect(&m_tool, &BrushTool::activeChanged, this, &BrushBar::refresh);
  connect(&m_tool, &BrushTool::brushChanged, this, &BrushBar::refresh);
  connect(&m_session, &Session::selectionChanged, this, &BrushBar::refresh);
  connect(&m_session, &Session::documentChanged, this, &BrushBar::refresh);
}

void BrushBar::clear() {
  model::Edited edited{m_session.scene(), false};
  for (const model::NodeId id : m_tool.targets()) {
    model::Edited cleared = model::withPaint(edited.scene, id, nullptr);
    edited = {std::move(cleared.scene), edited.changed || cleared.changed};
  }
  m_session.apply(tr("Clear Paint"), std::move(edited));
}

void BrushBar::refresh() {
  setVisible(m_tool.active());
  if (!m_tool.active())
    return;
  const Brush& brush = m_tool.brush();
  const auto show = [](QSlider* slider, int value) {
    const QSignalBlocker quiet(slider);
    slider->setValue(value);
  };
  show(m_size, stepOf(brush.radius));
  show(m_softness, int(std::lround(float(steps) * brush.softness)));
  show(m_strength, int(std::lround(float(steps) * brush.strength)));
  const QSignalBlocker quiet(m_erase);
  m_erase->setChecked(brush.erases);
  const float millimetres = brush.radius * m_tool.millimetresPerPixel();
  const model::Scene& scene = m_session.scene();
  m_millimetres->setText(millimetres > 0.0f ? lengthText(scene, double(millimetres)) : QString());
  const NodeIds targets = m_tool.targets();
  const QString target = targets.empty() ? tr("Click on what you want to paint on")
                         : targets.size() == 1
                             ? m_session.names().shown(scene.find(targets[0])->name)
                             : tr("%n structures", nullptr, int(targets.size()));
  m_target->setText(fontMetrics().elidedText(target, Qt::ElideRight, widestTarget));
  m_target->setToolTip(target);
  m_clear->setEnabled(std::any_of(targets.begin(), targets.end(), [&](model::NodeId id) {
    return scene.find(id)->paint != nullptr;
  }));
  place();
}

void BrushBar::place() {
  // Where the picture is narrow, the list says what is selected.
  m_target->setVisible(true);
  adjustSize();
  if (width() > m_picture.width()) {
    m_target->setVisible(false);
    adjustSize();
  }
  move(std::max((m_picture.width() - width()) / 2, 0),
       std::max(m_picture.height() - height() - margin, 0));
  raise();
}

bool BrushBar::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && isVisible())
    place();
  return QFrame::eventFilter(watched, event);
}

}  // namespace sline::widgets

#include "moc_brush_bar.cpp"
