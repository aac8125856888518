// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/option_form.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <algorithm>
#include <utility>

#include "widgets/export/option_fields.h"
#include "widgets/form/control.h"

namespace sline::widgets {

OptionForm::OptionForm(render::ExportOrder& order, std::vector<const render::ExportOption*> options,
                       const QStringList& languages, QWidget* parent)
    : QWidget(parent), m_order(order), m_options(std::move(options)) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(12);
  grid->setVerticalSpacing(8);
  const bool ticksAlone =
      std::all_of(m_options.begin(), m_options.end(), [](const render::ExportOption* option) {
        return std::holds_alternative<render::SwitchOption>(option->kind);
      });
  grid->setColumnMinimumWidth(0, captionWidth);
  grid->setColumnStretch(0, ticksAlone ? 1 : 0);
  grid->setColumnStretch(1, 1);
  int line = 0;
  int ticks = 0;
  for (const render::ExportOption* option : m_options) {
    const Field field = fieldOf(*option, languages);
    QWidget* control = makeControlOf(*option, field);
    if (std::holds_alternative<SwitchField>(field.kind)) {
      // Check boxes stand two in a row, because they are short.
      grid->addWidget(control, line, ticks % 2);
      line += ticks++ % 2;
      m_widgets.push_back({control});
      continue;
    }
    line += std::exchange(ticks, 0) % 2;
    auto* label = new QLabel(field.text);
    label->setBuddy(control);
    grid->addWidget(label, line, 0);
    grid->addWidget(control, line++, 1);
    m_widgets.push_back({label, control});
  }
  enableWhatApplies();
}

QWidget* OptionForm::makeControlOf(const render::ExportOption& option, const Field& field) {
  QWidget* control = makeControl(field, [this, &option](const QVariant& value) {
    setValue(m_order, option, value);
    enableWhatApplies();
    emit changed();
  });
  // A box that grew with its widest text would push the preview aside.
  if (auto* box = qobject_cast<QComboBox*>(control)) {
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(12);
  }
  showValue(*control, field.kind, valueIn(m_order, option));
  return control;
}

bool OptionForm::showFor(const render::ExportFormat& kind) {
  bool any = false;
  for (std::size_t i = 0; i < m_options.size(); ++i) {
    const bool shown = kind.has(*m_options[i]);
    any = any || shown;
    for (QWidget* widget : m_widgets[i])
      widget->setVisible(shown);
  }
  setVisible(any);
  return any;
}

void OptionForm::enableWhatApplies() {
  for (std::size_t i = 0; i < m_options.size(); ++i)
    for (QWidget* widget : m_widgets[i])
      widget->setEnabled(!m_options[i]->applies || m_options[i]->applies(m_order));
}

}  // namespace sline::widgets

#include "moc_option_form.cpp"
