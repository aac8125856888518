// SPDX-License-Identifier: Apache-2.0
#include "widgets/import_dialog/selection_panel.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "widgets/import_dialog/choice_rows.h"
#include "widgets/import_dialog/plan_texts.h"
#include "widgets/session/colour_dialog.h"

namespace sline::widgets {

namespace {

/// Holds the value that all structures have in common, if `one` is true.
template <class T>
struct Common {
  bool one = true;
  std::optional<T> value;
};

template <class T>
Common<T> common(const model::ImportPlan& plan, const NodeIds& ids,
                 std::optional<T> model::StructureChoice::*field) {
  Common<T> all{true, plan.choiceOf(ids.front()).*field};
  for (const model::NodeId id : ids)
    all.one = all.one && plan.choiceOf(id).*field == all.value;
  return all;
}

template <class T>
void addChoices(QComboBox& box, const QString& none, const std::vector<ChoiceOf<T>>& choices) {
  for (const Choice& choice : choiceField(none, choices).choices)
    box.addItem(choice.text, choice.id);
}

/// Shows the common value; no entry where the structures differ.
template <class T>
void showCommon(QComboBox& box, const Common<T>& all, const std::vector<ChoiceOf<T>>& choices) {
  const QVariant id = all.one ? idOf(all.value, choices) : QVariant();
  const QSignalBlocker quiet(box);
  box.setCurrentIndex(id.isValid() ? box.findData(id) : -1);
}

}  // namespace

SelectionPanel::SelectionPanel(ImportDraft& draft, const DisplayNames& names, QWidget* parent)
    : QWidget(parent),
      m_draft(draft),
      m_names(names),
      m_title(new QLabel),
      m_include(new QCheckBox(tr("&Import"))),
      m_colour(new QPushButton(tr("&Colour…"))),
      m_details(new QLabel) {
  setObjectName(QStringLiteral("selectionPanel"));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  m_title->setObjectName(QStringLiteral("selectionTitle"));
  m_title->setTextFormat(Qt::PlainText);
  QFont bold = m_title->font();
  bold.setBold(true);
  m_title->setFont(bold);
  m_title->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  m_include->setObjectName(QStringLiteral("selectionInclude"));
  m_colour->setObjectName(QStringLiteral("selectionColour"));
  m_details->setObjectName(QStringLiteral("details"));
  m_details->setTextFormat(Qt::PlainText);
  m_details->setWordWrap(true);
  m_details->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_details->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  m_details->setMinimumHeight(4 * m_details->fontMetrics().lineSpacing());
  grid->addWidget(m_title, 0, 0, 1, 8);
  m_frame = combo("selectionFrame", tr("&Frame"), 24);
  m_unit = combo("selectionUnit", tr("&Unit"), 14);
  m_smoothing = combo("selectionSmoothing", tr("&Smoothing"), 12);
  m_decimation = combo("selectionDecimation", tr("Fewer &triangles"), 12);
  grid->addWidget(m_include, 2, 4);
  grid->addWidget(m_colour, 2, 5);
  grid->setColumnStretch(6, 1);
  grid->addWidget(m_details, 3, 0, 1, 8);
  const QString none = tr("As for all");
  addChoices(*m_frame, none, frameRows());
  addChoices(*m_unit, none, unitRows());
  addChoices(*m_smoothing, none, smoothingRows());
  addChoices(*m_decimation, none, decimationRows());
  connectControls();
  connect(&draft, &ImportDraft::chosen, this, &SelectionPanel::refresh);
  connect(&draft, &ImportDraft::planned, this, &SelectionPanel::refresh);
  refresh();
}

QComboBox* SelectionPanel::combo(const char* name, const QString& label, int letters) {
  auto* box = new QComboBox;
  box->setObjectName(QLatin1String(name));
  box->setPlaceholderText(tr("Different"));
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(letters);
  auto* caption = new QLabel(label);
  caption->setBuddy(box);
  auto* grid = static_cast<QGridLayout*>(layout());
  const int column = int(findChildren<QComboBox*>().size());
  grid->addWidget(caption, 1, column);
  grid->addWidget(box, 2, column);
  return box;
}

void SelectionPanel::connectControls() {
  connect(m_include, &QCheckBox::clicked, this, [this](bool on) {
    m_include->setTristate(false);
    choose([on](model::StructureChoice& choice) { choice.include = on; });
  });
  connect(m_frame, &QComboBox::activated, this, [this](int index) {
    choose(
        [value = meaningOf(m_frame->itemData(index), frameRows())](auto& c) { c.frame = value; });
  });
  connect(m_unit, &QComboBox::activated, this, [this](int index) {
    choose([value = meaningOf(m_unit->itemData(index), unitRows())](auto& c) { c.unit = value; });
  });
  connect(m_smoothing, &QComboBox::activated, this, [this](int index) {
    choose([value = meaningOf(m_smoothing->itemData(index), smoothingRows())](auto& c) {
      c.smoothing = value;
    });
  });
  connect(m_decimation, &QComboBox::activated, this, [this](int index) {
    choose([value = meaningOf(m_decimation->itemData(index), decimationRows())](auto& c) {
      c.decimateMm = value;
    });
  });
  connect(m_colour, &QPushButton::clicked, this, &SelectionPanel::chooseColour);
}

void SelectionPanel::show(const NodeIds& selected, const NodeIds& structures) {
  m_selected = selected;
  m_structures = structures;
  refresh();
}

void SelectionPanel::refresh() {
  const model::ImportPlan& plan = m_draft.plan();
  const auto gone = [&plan](model::NodeId id) { return !plan.scene.find(id); };
  if (std::any_of(m_selected.begin(), m_selected.end(), gone)) {
    m_selected.clear();
    m_structures.clear();
  }
  const bool any = !m_structures.empty();
  const bool read = any && std::all_of(m_structures.begin(), m_structures.end(),
                                       [&](model::NodeId id) { return plan.parts.contains(id); });
  for (QWidget* control : {static_cast<QWidget*>(m_include), static_cast<QWidget*>(m_colour)})
    control->setEnabled(any);
  for (QComboBox* box : {m_frame, m_unit, m_smoothing, m_decimation})
    box->setEnabled(read);
  m_title->setText(titleText());
  m_details->setText(m_selected.size() == 1
                         ? detailsText(plan, m_draft.figures(), m_selected.front())
                         : QString());
  if (!any) {
    for (QComboBox* box : {m_frame, m_unit, m_smoothing, m_decimation})
      box->setCurrentIndex(0);
    m_include->setCheckState(Qt::Unchecked);
    return;
  }
  const auto wanted = std::count_if(m_structures.begin(), m_structures.end(),
                                    [&](auto id) { return plan.choiceOf(id).include; });
  const QSignalBlocker quiet(*m_include);
  m_include->setCheckState(wanted == 0                          ? Qt::Unchecked
                           : wanted == std::ssize(m_structures) ? Qt::Checked
                                                                : Qt::PartiallyChecked);
  using Chosen = model::StructureChoice;
  showCommon(*m_frame, common(plan, m_structures, &Chosen::frame), frameRows());
  showCommon(*m_unit, common(plan, m_structures, &Chosen::unit), unitRows());
  showCommon(*m_smoothing, common(plan, m_structures, &Chosen::smoothing), smoothingRows());
  showCommon(*m_decimation, common(plan, m_structures, &Chosen::decimateMm), decimationRows());
}

QString SelectionPanel::titleText() const {
  if (m_structures.empty())
    return tr("Select structures to treat them unlike the others");
  if (m_structures.size() > 1)
    return tr("For the selected %n structures", nullptr, int(m_structures.size()));
  const model::ImportPlan& plan = m_draft.plan();
  const model::NodeId only = m_structures.front();
  return tr("For “%1”")
      .arg(QString::fromStdString(plan.choiceOf(only).name.value_or(plan.scene.find(only)->name)));
}

void SelectionPanel::chooseColour() {
  auto* dialog = makeColourDialog(m_names, Qt::white, this);
  dialog->setObjectName(QStringLiteral("importColourDialog"));
  connect(dialog, &QColorDialog::colorSelected, this, [this](const QColor& colour) {
    const Colour own{std::uint8_t(colour.red()), std::uint8_t(colour.green()),
                     std::uint8_t(colour.blue())};
    choose([own](model::StructureChoice& choice) { choice.colour = own; });
  });
  dialog->open();
}

}  // namespace sline::widgets

#include "moc_selection_panel.cpp"
