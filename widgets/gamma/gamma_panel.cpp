// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/gamma_panel.h"

#include <QButtonGroup>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "model/edit/emphasis.h"
#include "widgets/gamma/gamma_slider.h"
#include "widgets/gamma/stages.h"

namespace sline::widgets {

namespace {

QLabel* caption(const QString& text) {
  auto* label = new QLabel(text);
  QFont font = label->font();
  font.setBold(true);
  label->setFont(font);
  return label;
}

/// The Γ of all items together.
model::GammaRange rangeOf(const model::Scene& scene, const NodeIds& ids) {
  model::GammaRange all = model::gammaRangeOf(scene, ids.front());
  for (const model::NodeId id : ids) {
    const model::GammaRange one = model::gammaRangeOf(scene, id);
    all = {std::min(all.low, one.low), std::max(all.high, one.high)};
  }
  return all;
}

QString titleOf(Session& session, const NodeIds& ids) {
  if (ids.empty())
    return GammaPanel::tr("Nothing selected");
  if (ids.size() == 1)
    return session.names().shown(session.scene().find(ids.front())->name);
  return GammaPanel::tr("%n items", nullptr, int(ids.size()));
}

}  // namespace

GammaPanel::GammaPanel(Session& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_drag(session) {
  m_title = caption({});
  m_title->setObjectName(QStringLiteral("gammaTitle"));
  m_title->setWordWrap(true);
  m_hint = new QLabel(tr("Select a structure in the list or in the picture."));
  m_hint->setWordWrap(true);
  m_slider = new GammaSlider;
  m_slider->setObjectName(QStringLiteral("gammaSlider"));
  m_slider->setAccessibleName(tr("Gamma, from silhouette to surface"));
  m_number = new QDoubleSpinBox;
  m_number->setObjectName(QStringLiteral("gammaNumber"));
  m_number->setAccessibleName(tr("Gamma as a number"));
  m_number->setRange(0.0, 5.0);
  m_number->setDecimals(2);
  m_number->setSingleStep(0.05);
  m_number->setPrefix(tr("Γ  "));
  m_number->setKeyboardTracking(false);
  m_inherit = new QPushButton(tr("Inherit"));
  m_inherit->setObjectName(QStringLiteral("gammaInherit"));
  m_inherit->setToolTip(tr("Take Γ from the group above again"));

  auto* number = new QHBoxLayout;
  number->addWidget(m_number, 1);
  number->addWidget(m_inherit);
  m_fillRow = makeFill();
  m_emphasisRow = makeEmphasis();

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(14, 12, 14, 14);
  layout->setSpacing(10);
  layout->addWidget(m_title);
  layout->addWidget(m_hint);
  layout->addWidget(m_slider, 1);
  layout->addLayout(number);
  layout->addSpacing(6);
  layout->addWidget(m_fillRow);
  layout->addSpacing(6);
  layout->addWidget(m_emphasisRow);
  layout->addStretch(0);
  connectControls();
  refresh();
}

QWidget* GammaPanel::makeFill() {
  struct Choice {
    model::Fill fill;
    const char* name;
    QString text;
    QString tip;
  };
  const std::vector<Choice> choices{
      {model::Fill::none, "fillNone", tr("Open"), tr("What is behind shows through")},
      {model::Fill::paper, "fillPaper", tr("Solid"), tr("Hides what is behind")},
      {model::Fill::veil, "fillVeil", tr("Veil"),
       tr("What is behind shows faintly, as through tracing paper")},
      {model::Fill::tint, "fillTint", tr("Tint"),
       tr("A thin wash of the structure's colour; what is behind shows through")}};
  auto* row = new QWidget;
  auto* layout = new QVBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(caption(tr("Where only lines are drawn")));
  auto* buttons = new QGridLayout;
  buttons->setSpacing(4);
  m_fill = new QButtonGroup(this);
  for (const Choice& choice : choices) {
    auto* button = new QPushButton(choice.text);
    button->setObjectName(QLatin1String(choice.name));
    button->setToolTip(choice.tip);
    button->setCheckable(true);
    const int place = int(m_fill->buttons().size());
    buttons->addWidget(button, place / 2, place % 2);
    m_fill->addButton(button, int(choice.fill));
  }
  layout->addLayout(buttons);
  return row;
}

QWidget* GammaPanel::makeEmphasis() {
  auto* row = new QWidget;
  auto* layout = new QVBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(caption(tr("Emphasis")));
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(4);
  auto* focus = new QPushButton(tr("Focus"));
  focus->setObjectName(QStringLiteral("focusButton"));
  focus->setToolTip(tr("These in detail, everything else as contours"));
  auto* context = new QPushButton(tr("Context"));
  context->setObjectName(QStringLiteral("contextButton"));
  context->setToolTip(tr("These as contours"));
  buttons->addWidget(focus);
  buttons->addWidget(context);
  layout->addLayout(buttons);
  connect(focus, &QPushButton::clicked, this, &GammaPanel::focusWanted);
  connect(context, &QPushButton::clicked, this, &GammaPanel::contextWanted);
  return row;
}

void GammaPanel::connectControls() {
  connect(m_slider, &GammaSlider::dragStarted, this,
          [this] { m_drag.begin(m_session.selection()); });
  connect(m_slider, &GammaSlider::dragged, this, [this](Gamma gamma) { m_drag.moveTo(gamma); });
  connect(m_slider, &GammaSlider::dragFinished, this, [this] { m_drag.finish(); });
  connect(m_slider, &GammaSlider::dragCancelled, this, [this] { m_drag.cancel(); });
  connect(m_slider, &GammaSlider::stepped, this, &GammaPanel::step);
  connect(m_number, &QDoubleSpinBox::valueChanged, this,
          [this](double value) { step(Gamma::clamped(float(value))); });
  connect(m_inherit, &QPushButton::clicked, this, [this] {
    m_session.apply(tr("Inherit Γ"),
                    model::withGammaInherited(m_session.scene(), m_session.selection()));
  });
  connect(m_fill, &QButtonGroup::idClicked, this, [this](int id) {
    m_session.apply(tr("Fill"),
                    model::withFill(m_session.scene(), m_session.selection(), model::Fill(id)));
    showFill();
  });
  connect(&m_session, &Session::selectionChanged, this, &GammaPanel::refresh);
  connect(&m_session.names(), &ShownNames::changed, this, &GammaPanel::refresh);
  connect(&m_session, &Session::documentChanged, this, &GammaPanel::refresh);
}

void GammaPanel::step(Gamma gamma) {
  const NodeIds& ids = m_session.selection();
  QString series = QStringLiteral("gamma");
  for (const model::NodeId id : ids)
    series += QStringLiteral(" %1").arg(id.value);
  m_session.apply(gammaStepName(m_session.scene(), ids),
                  model::withGamma(m_session.scene(), ids, gamma), series);
  showGamma();
}

void GammaPanel::refresh() {
  const NodeIds& ids = m_session.selection();
  const bool any = !ids.empty() && std::all_of(ids.begin(), ids.end(), [this](model::NodeId id) {
    return m_session.scene().find(id);
  });
  m_hint->setVisible(!any);
  for (QWidget* control :
       {static_cast<QWidget*>(m_slider), static_cast<QWidget*>(m_number), m_fillRow, m_emphasisRow})
    control->setEnabled(any);
  m_inherit->setEnabled(false);
  m_title->setText(titleOf(m_session, any ? ids : NodeIds()));
  if (!any && !ids.empty())
    return;
  showGamma();
  showFill();
}

void GammaPanel::showGamma() {
  const NodeIds& ids = m_session.selection();
  if (ids.empty())
    return;
  const model::Scene& scene = m_session.scene();
  const bool own = std::any_of(ids.begin(), ids.end(), [&](model::NodeId id) {
    return scene.find(id)->style.gamma.has_value();
  });
  const model::GammaRange range = rangeOf(scene, ids);
  m_slider->showGamma(range, own);
  m_inherit->setEnabled(own);
  const QSignalBlocker quiet(m_number);
  m_number->setValue(double(range.high.value()));
}

void GammaPanel::showFill() {
  const NodeIds& ids = m_session.selection();
  if (ids.empty()) {
    m_fill->setExclusive(false);
    for (QAbstractButton* button : m_fill->buttons())
      button->setChecked(false);
    return;
  }
  const model::Fill fill = m_session.scene().resolve(ids.front()).fill;
  const bool same = std::all_of(ids.begin(), ids.end(), [&](model::NodeId id) {
    return m_session.scene().resolve(id).fill == fill;
  });
  m_fill->setExclusive(same);
  for (QAbstractButton* button : m_fill->buttons())
    button->setChecked(same && m_fill->id(button) == int(fill));
}

}  // namespace sline::widgets
