// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/gamma_panel.h"

#include <QButtonGroup>
#include <QCoreApplication>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "model/edit/emphasis.h"
#include "model/edit/look.h"
#include "model/scene/resolved_styles.h"
#include "widgets/form/range_box.h"
#include "widgets/gamma/drawing_panel.h"
#include "widgets/gamma/gamma_slider.h"
#include "widgets/gamma/look_drag.h"
#include "widgets/gamma/more_panel.h"
#include "widgets/gamma/preset_panel.h"
#include "widgets/gamma/stage_strip.h"

namespace sline::widgets {

namespace {

QLabel* caption(const QString& text) {
  auto* label = new QLabel(text);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  QFont font = label->font();
  font.setBold(true);
  label->setFont(font);
  return label;
}

/// Returns the Γ of the structures that are shown, or of all where none is shown; a group without
/// structures has its own.
model::GammaRange rangeOf(const model::Scene& scene, const NodeIds& ids) {
  std::optional<model::GammaRange> shown;
  std::optional<model::GammaRange> any;
  const auto add = [](std::optional<model::GammaRange>& range, Gamma gamma) {
    range = range ? model::GammaRange{std::min(range->low, gamma), std::max(range->high, gamma)}
                  : model::GammaRange{gamma, gamma};
  };
  for (const auto& [node, style] : model::resolvedBelow(scene, ids)) {
    add(any, style.gamma);
    if (style.visible)
      add(shown, style.gamma);
  }
  return shown ? *shown : any ? *any : model::gammaRangeOf(scene, ids.front());
}

QString titleOf(Session& session, const NodeIds& ids) {
  if (ids.empty())
    return GammaPanel::tr("Nothing selected");
  if (ids.size() == 1)
    return session.names().shown(session.scene().find(ids.front())->name);
  return GammaPanel::tr("%n items", nullptr, int(ids.size()));
}

/// A scroll area as wide as its surroundings and as high as its content.
class TallArea : public QScrollArea {
 public:
  explicit TallArea(QWidget* content) {
    setObjectName(QStringLiteral("gammaScroll"));
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    setWidget(content);
  }
  QSize minimumSizeHint() const override { return {widget()->minimumSizeHint().width(), 200}; }
};

}  // namespace

GammaPanel::GammaPanel(Session& session, QSettings& settings, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_drag(session, gammaNumber()),
      m_drawings(new DrawingPanel(session, settings)),
      m_presets(new PresetPanel(session, settings)),
      m_more(new MorePanel(session, settings)) {
  m_title = caption({});
  m_title->setObjectName(QStringLiteral("gammaTitle"));
  m_hint = new QLabel(tr("Select a structure in the list or in the picture."));
  m_hint->setWordWrap(true);
  m_fillRow = makeFill();
  layOut();
  connectControls();
  refresh();
}

void GammaPanel::layOut() {
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(12, 10, 10, 12);
  layout->setSpacing(8);
  layout->addWidget(m_title);
  layout->addWidget(m_hint);
  layout->addLayout(makeGamma(), 1);
  layout->addWidget(m_fillRow);
  layout->addSpacing(2);
  layout->addWidget(caption(tr("Presets")));
  layout->addWidget(m_presets);
  layout->addSpacing(2);
  layout->addWidget(m_drawings);
  layout->addWidget(m_more);
  auto* area = new TallArea(content);
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  outer->addWidget(area);
  // Controls that were folded away scroll into view when they open.
  const auto showWhole = [area](QWidget* opened) {
    const auto show = [area, opened] {
      QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
      area->ensureWidgetVisible(opened, 0, 0);
    };
    QMetaObject::invokeMethod(area, show, Qt::QueuedConnection);
  };
  connect(m_more, &MorePanel::opened, area, [this, showWhole] { showWhole(m_more); });
  connect(m_drawings, &DrawingPanel::opened, area, [this, showWhole] { showWhole(m_drawings); });
}

QLayout* GammaPanel::makeGamma() {
  m_slider = new GammaSlider;
  m_slider->setObjectName(QStringLiteral("gammaSlider"));
  m_slider->setAccessibleName(tr("Gamma, from silhouette to surface"));
  m_slider->setToolTip(differencesText());
  m_slider->setMinimumHeight(m_slider->minimumSizeHint().height());
  m_stages = new StageStrip(*m_slider);
  m_stages->setObjectName(QStringLiteral("stages"));
  m_number = new RangeBox;
  m_number->setObjectName(QStringLiteral("gammaNumber"));
  m_number->setAccessibleName(tr("Gamma as a number"));
  m_number->setToolTip(tr("A number that is typed is for all that is selected"));
  m_number->setRange(0.0, 5.0);
  m_number->setDecimals(2);
  m_number->setSingleStep(0.05);
  m_number->setPrefix(tr("Γ  "));
  m_inherit = new QPushButton(tr("Inherit"));
  m_inherit->setObjectName(QStringLiteral("gammaInherit"));
  m_inherit->setToolTip(tr("Take Γ from the group above again"));
  auto* both = new QHBoxLayout;
  both->setSpacing(0);
  both->addWidget(m_slider);
  both->addWidget(m_stages, 1);
  auto* number = new QHBoxLayout;
  number->addWidget(m_number, 1);
  number->addWidget(m_inherit);
  auto* layout = new QVBoxLayout;
  layout->setSpacing(4);
  layout->addLayout(both, 1);
  layout->addLayout(number);
  return layout;
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
  layout->setSpacing(4);
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
  // A sunken button is hardly visible on a dark background.
  row->setStyleSheet(
      QStringLiteral("QPushButton:checked { background: palette(highlight);"
                     " color: palette(highlighted-text); border: 1px solid palette(highlight);"
                     " border-radius: 3px; padding: 3px; }"));
  return row;
}

void GammaPanel::connectControls() {
  connect(m_more, &MorePanel::brushWanted, this, &GammaPanel::brushWanted);
  connect(m_presets, &PresetPanel::focusWanted, this, &GammaPanel::focusWanted);
  connect(m_slider, &DragSlider::dragStarted, this, [this] {
    m_drag.begin({m_session.selection(), m_slider->middle().value(), m_slider->levels()});
  });
  connect(m_slider, &DragSlider::dragged, this,
          [this](int position) { m_drag.moveTo(GammaSlider::gammaOf(position).value()); });
  connect(m_slider, &DragSlider::dragFinished, this, [this] { m_drag.finish(gammaText()); });
  connect(m_slider, &DragSlider::dragCancelled, this, [this] { m_drag.cancel(); });
  connect(m_slider, &DragSlider::stepped, this, [this](int position) {
    step(movedBy(m_slider->middle().value(), GammaSlider::gammaOf(position).value()));
  });
  connect(m_number, &RangeBox::moved, this, [this](double by) { step(movedBy(0.0f, float(by))); });
  connect(m_number, &RangeBox::chosen, this, [this](double value) {
    step(model::withLook(m_session.scene(), m_session.selection(),
                         gammaNumber().look(float(value))));
  });
  connect(m_stages, &StageStrip::chosen, this, [this](Gamma gamma) {
    const NodeIds& ids = m_session.selection();
    m_session.apply(lookStepName(gammaText(), m_session, ids),
                    model::withLook(m_session.scene(), ids, {.gamma = gamma}));
  });
  connect(m_inherit, &QPushButton::clicked, this, [this] {
    m_session.apply(
        tr("Inherit Γ"),
        model::withLookInherited(m_session.scene(), m_session.selection(), {.gamma = Gamma()}));
  });
  connect(m_fill, &QButtonGroup::idClicked, this, [this](int id) {
    m_session.apply(tr("Fill"), model::withLook(m_session.scene(), m_session.selection(),
                                                {.fill = model::Fill(id)}));
    showFill();
  });
  connect(&m_session, &Session::selectionChanged, this, &GammaPanel::refresh);
  connect(&m_session.names(), &DisplayNames::changed, this, &GammaPanel::refresh);
  connect(&m_session, &Session::documentChanged, this, &GammaPanel::refresh);
}

model::Edited GammaPanel::movedBy(float from, float to) const {
  return model::withLookMoved(m_session.scene(), m_session.selection(), gammaNumber(), from, to);
}

void GammaPanel::step(model::Edited edited) {
  const NodeIds& ids = m_session.selection();
  m_session.apply(lookStepName(gammaText(), m_session, ids), std::move(edited),
                  lookSeries(QStringLiteral("gamma"), ids));
  showGamma();
}

void GammaPanel::refresh() {
  const NodeIds& ids = m_session.selection();
  const bool any = !ids.empty() && std::all_of(ids.begin(), ids.end(), [this](model::NodeId id) {
    return m_session.scene().find(id);
  });
  m_hint->setVisible(!any);
  for (QWidget* control :
       std::initializer_list<QWidget*>{m_slider, m_stages, m_number, m_fillRow, m_presets})
    control->setEnabled(any);
  m_more->setUsable(any);
  m_inherit->setEnabled(false);
  m_title->setText(titleOf(m_session, any ? ids : NodeIds()));
  if (!any && !ids.empty())
    return;
  showGamma();
  showFill();
  m_more->showSelection();
}

void GammaPanel::showGamma() {
  const NodeIds& ids = m_session.selection();
  if (ids.empty()) {
    m_stages->setCurrent({});
    return;
  }
  const model::Scene& scene = m_session.scene();
  const bool own = std::any_of(ids.begin(), ids.end(), [&](model::NodeId id) {
    return scene.find(id)->style.gamma.has_value();
  });
  const model::GammaRange range = rangeOf(scene, ids);
  m_slider->showGamma(range, own);
  m_stages->setCurrent(range.low == range.high ? std::optional<Gamma>(range.low) : std::nullopt);
  m_inherit->setEnabled(own);
  m_number->showRange(double(range.low.value()), double(range.high.value()));
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

#include "moc_gamma_panel.cpp"
