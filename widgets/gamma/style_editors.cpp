// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/style_editors.h"

#include <QColorDialog>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>
#include <algorithm>
#include <limits>

#include "widgets/form/range_box.h"
#include "widgets/gamma/selected_looks.h"
#include "widgets/gamma/style_slider.h"
#include "widgets/session/colour_dialog.h"

namespace sline::widgets {

namespace {

template <class Says>
bool anySays(const model::Scene& scene, const NodeIds& ids, const Says& says) {
  return anyOfSays(scene, model::setOf(ids), says);
}

QIcon swatch(const std::optional<QColor>& colour, const QPalette& palette, bool mixed) {
  constexpr int side = 64;
  QPixmap pixmap(side, side);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor frame = palette.color(QPalette::WindowText);
  frame.setAlpha(110);
  painter.setPen(QPen(frame, 4.0));
  painter.setBrush(colour ? QBrush(*colour) : QBrush(palette.color(QPalette::Base)));
  painter.drawRoundedRect(QRectF(4.0, 4.0, side - 8.0, side - 8.0), 10.0, 10.0);
  if (!colour)
    painter.drawLine(QPointF(12.0, side - 12.0), QPointF(side - 12.0, 12.0));
  if (mixed) {
    // Half of the swatch stays open for several colours.
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette.color(QPalette::Base));
    painter.drawPolygon(QPolygonF{{8.0, side - 8.0}, {side - 8.0, 8.0}, {side - 8.0, side - 8.0}});
  }
  return pixmap;
}

QColor qColour(const Colour& c) {
  return {c.red, c.green, c.blue};
}

}  // namespace

StyleEditor::StyleEditor(Session& session, const QString& id, const QString& text, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_id(id),
      m_text(text),
      m_label(new QLabel(text)),
      m_reset(new QToolButton) {
  setObjectName(id);
  m_label->setTextFormat(Qt::PlainText);
  m_label->setWordWrap(true);
  m_reset->setObjectName(id + QStringLiteral("Reset"));
  m_reset->setText(tr("Reset"));
  m_reset->setAutoRaise(true);
  m_reset->setToolTip(tr("As the group above, or the usual, says"));
  m_reset->setAccessibleName(tr("Reset %1").arg(text));
}

void StyleEditor::apply(const model::Style& look) {
  apply(model::withLook(m_session.scene(), m_session.selection(), look));
}

void StyleEditor::apply(model::Edited edited) {
  const NodeIds& ids = m_session.selection();
  m_session.apply(lookStepName(m_text, m_session, ids), std::move(edited), lookSeries(m_id, ids));
  showSelection();
}

void StyleEditor::inherit(const model::Style& which) {
  m_session.apply(tr("Reset %1").arg(m_text),
                  model::withLookInherited(m_session.scene(), m_session.selection(), which));
}

StyleNumberEditor::StyleNumberEditor(Session& session, StyleNumber row, QWidget* parent)
    : StyleEditor(session, row.id, row.text, parent),
      m_row(std::move(row)),
      m_drag(session, m_row.field),
      m_slider(new StyleSlider(m_row.high, m_row.step, m_row.power)),
      m_number(new RangeBox) {
  setToolTip(m_row.tip);
  m_slider->setObjectName(m_row.id + QStringLiteral("Slider"));
  m_slider->setAccessibleName(m_row.text);
  m_slider->setAccessibleDescription(m_row.tip);
  m_number->setObjectName(m_row.id + QStringLiteral("Number"));
  m_number->setAccessibleName(m_row.text);
  m_number->setRange(0.0, m_row.high);
  m_number->setDecimals(m_row.decimals);
  m_number->setSingleStep(m_row.step);
  m_number->setSuffix(m_row.unit);
  label().setBuddy(m_number);
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setHorizontalSpacing(8);
  layout->setVerticalSpacing(1);
  layout->addWidget(&label(), 0, 0);
  layout->addWidget(&resetButton(), 0, 1, Qt::AlignRight);
  layout->addWidget(m_slider, 1, 0);
  layout->addWidget(m_number, 1, 1);
  layout->setColumnStretch(0, 1);
  m_slider->setToolTip(differencesText());
  connectValues();
  connect(&resetButton(), &QToolButton::clicked, this, [this] { inherit(m_row.field.look(0.0f)); });
}

void StyleNumberEditor::connectValues() {
  connect(m_slider, &DragSlider::dragStarted, this, [this] {
    m_drag.begin({session().selection(), styled(m_slider->middle()), m_slider->levels()});
  });
  connect(m_slider, &DragSlider::dragged, this,
          [this](int position) { m_drag.moveTo(styled(m_slider->valueOf(position))); });
  connect(m_slider, &DragSlider::dragFinished, this, [this] { m_drag.finish(text()); });
  connect(m_slider, &DragSlider::dragCancelled, this, [this] { m_drag.cancel(); });
  const auto move = [this](double from, double to) {
    apply(model::withLookMoved(session().scene(), session().selection(), m_row.field, styled(from),
                               styled(to)));
  };
  connect(m_slider, &DragSlider::stepped, this,
          [this, move](int position) { move(m_slider->middle(), m_slider->valueOf(position)); });
  connect(m_number, &RangeBox::moved, this, [move](double by) { move(0.0, by); });
  connect(m_number, &RangeBox::chosen, this,
          [this](double value) { apply(m_row.field.look(styled(value))); });
}

void StyleNumberEditor::showSelection() {
  const model::Scene& scene = session().scene();
  const NodeIds& ids = session().selection();
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const model::ResolvedStyle& look : looksOf(scene, ids)) {
    const double value = double(m_row.field.value(look)) * m_row.shown;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (low > high)
    return;
  const auto says = [this](const model::Style& style) { return m_row.field.own(style); };
  m_slider->showRange(low, high, anySays(scene, ids, says));
  m_number->showRange(low, high);
  resetButton().setEnabled(anyBelowSays(scene, ids, says));
}

StyleChoiceEditor::StyleChoiceEditor(Session& session, StyleChoice row, QWidget* parent)
    : StyleEditor(session, row.id, row.text, parent),
      m_row(std::move(row)),
      m_values(new QComboBox) {
  setToolTip(m_row.tip);
  m_values->setObjectName(m_row.id + QStringLiteral("Choice"));
  m_values->setAccessibleName(m_row.text);
  m_values->setAccessibleDescription(m_row.tip);
  for (const QString& name : m_row.names)
    m_values->addItem(name);
  label().setBuddy(m_values);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(&label(), 1);
  layout->addWidget(m_values);
  layout->addWidget(&resetButton());
  connect(m_values, &QComboBox::activated, this, [this](int place) { apply(m_row.look(place)); });
  connect(&resetButton(), &QToolButton::clicked, this, [this] { inherit(m_row.look(0)); });
}

void StyleChoiceEditor::showSelection() {
  const model::Scene& scene = session().scene();
  const std::vector<model::ResolvedStyle> looks = looksOf(scene, session().selection());
  if (looks.empty())
    return;
  const int first = m_row.value(looks.front());
  const bool mixed = std::any_of(looks.begin(), looks.end(),
                                 [&](const auto& look) { return m_row.value(look) != first; });
  m_values->setPlaceholderText(tr("Several"));
  m_values->setCurrentIndex(mixed ? -1 : first);
  resetButton().setEnabled(anyBelowSays(scene, session().selection(), m_row.own));
}

StyleColourEditor::StyleColourEditor(Session& session, StyleColour row, QWidget* parent)
    : StyleEditor(session, row.id, row.text, parent),
      m_row(std::move(row)),
      m_swatch(new QToolButton) {
  setToolTip(m_row.tip);
  m_swatch->setObjectName(m_row.id + QStringLiteral("Swatch"));
  m_swatch->setAccessibleName(m_row.text);
  m_swatch->setAutoRaise(true);
  m_swatch->setIconSize({20, 20});
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(m_swatch);
  layout->addWidget(&label(), 1);
  layout->addWidget(&resetButton());
  connect(m_swatch, &QToolButton::clicked, this, &StyleColourEditor::choose);
  connect(&resetButton(), &QToolButton::clicked, this, [this] {
    model::Style which;
    which.*m_row.field = Colour();
    inherit(which);
  });
}

void StyleColourEditor::showSelection() {
  const model::Scene& scene = session().scene();
  const std::vector<model::ResolvedStyle> looks = looksOf(scene, session().selection());
  if (looks.empty())
    return;
  const auto first = m_row.value(looks.front());
  const bool mixed = std::any_of(looks.begin(), looks.end(),
                                 [&](const auto& look) { return m_row.value(look) != first; });
  m_swatch->setIcon(
      swatch(first ? std::optional<QColor>(qColour(*first)) : std::nullopt, palette(), mixed));
  m_swatch->setToolTip(mixed   ? tr("Several")
                       : first ? qColour(*first).name()
                               : tr("With the background"));
  resetButton().setEnabled(
      anyBelowSays(scene, session().selection(),
                   [this](const model::Style& style) { return (style.*m_row.field).has_value(); }));
}

void StyleColourEditor::choose() {
  const model::Scene& scene = session().scene();
  const std::vector<model::ResolvedStyle> looks = looksOf(scene, session().selection());
  if (looks.empty())
    return;
  const auto before = m_row.value(looks.front());
  auto* dialog =
      makeColourDialog(session().names(), before ? qColour(*before) : QColor(Qt::black), this);
  dialog->setObjectName(m_row.id + QStringLiteral("Dialog"));
  dialog->setWindowTitle(m_row.text);
  connect(dialog, &QColorDialog::colorSelected, this, [this](const QColor& chosen) {
    model::Style look;
    look.*m_row.field = Colour{std::uint8_t(chosen.red()), std::uint8_t(chosen.green()),
                               std::uint8_t(chosen.blue())};
    apply(look);
  });
  dialog->open();
}

}  // namespace sline::widgets

#include "moc_style_editors.cpp"
