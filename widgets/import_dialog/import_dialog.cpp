// SPDX-License-Identifier: Apache-2.0
#include "widgets/import_dialog/import_dialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/import_dialog/choice_rows.h"
#include "widgets/import_dialog/options_panel.h"
#include "widgets/import_dialog/patients_question.h"
#include "widgets/import_dialog/plan_texts.h"
#include "widgets/import_dialog/plan_tree.h"
#include "widgets/import_dialog/selection_panel.h"
#include "widgets/import_dialog/threshold_panel.h"
#include "widgets/session/document.h"
#include "widgets/session/typed_wishes.h"
#include "widgets/shell/filter_line.h"
#include "widgets/text/told.h"

namespace sline::widgets {

namespace {

QLabel* plainLabel(const char* name) {
  auto* label = new QLabel;
  label->setObjectName(QLatin1String(name));
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

/// Colours the text as the window's messages are: red for failures, amber for what the user should
/// know.
QString messageStyleSheet(const QPalette& palette, bool failed) {
  const bool dark =
      palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
  const char* colours = failed ? (dark ? "background: #54241f; color: #f6d9d5;"
                                       : "background: #f6d9d5; color: #5a1410;")
                               : (dark ? "background: #4a3d12; color: #f7ecc9;"
                                       : "background: #f7ecc9; color: #4d3b05;");
  return QLatin1String(colours) + QStringLiteral(" padding: 6px 10px; border-radius: 4px;");
}

QTableWidgetItem* cell(const QString& text) {
  auto* item = new QTableWidgetItem(text);
  item->setTextAlignment(Qt::AlignLeft | Qt::AlignTop);
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
  return item;
}

}  // namespace

ImportDialog::ImportDialog(const DisplayNames& names, model::ImportPlan plan, bool intoScene,
                           QWidget* parent)
    : QDialog(parent),
      m_names(names),
      m_intoScene(intoScene),
      m_summary(plainLabel("importSummary")),
      m_doubt(plainLabel("importDoubt")),
      m_takeUnit(new QPushButton),
      m_keepUnit(new QPushButton(tr("The Size Is Right"))),
      m_tabs(new QTabWidget) {
  setObjectName(QStringLiteral("importDialog"));
  setWindowTitle(tr("Import %1").arg(titleOf(plan.inputs)));
  QFont bold = m_summary->font();
  bold.setBold(true);
  m_summary->setFont(bold);
  m_tabs->setObjectName(QStringLiteral("importTabs"));
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(10);
  layout->addWidget(m_summary);
  layout->addWidget(m_doubt);
  layout->addWidget(makeUnitButtons());
  layout->addWidget(new OptionsPanel(m_draft));
  m_tabs->addTab(makeStructures(), tr("Structures"));
  m_tabs->addTab(makeLeftOut(), tr("Left out"));
  m_thresholds = new ThresholdPanel(m_draft);
  m_tabs->setTabVisible(m_tabs->addTab(m_thresholds, tr("Scan")), false);
  connect(m_tabs, &QTabWidget::currentChanged, this, &ImportDialog::fitRows);
  layout->addWidget(m_tabs, 1);
  layout->addWidget(makeButtons());
  resize(1060, 720);
  connectDraft();
  m_draft.begin(std::move(plan));
}

ImportDialog::~ImportDialog() = default;

QWidget* ImportDialog::makeStructures() {
  auto* page = new QWidget;
  QLineEdit* filter = makeFilterLine(QStringLiteral("importFilter"), tr("Filter by name or file"),
                                     tr("Filter by name or file"));
  filter->setToolTip(
      tr("Words in any order; “%1” or a comma between them finds either").arg(orWord()));
  m_tree = new PlanTree(m_draft);
  m_selection = new SelectionPanel(m_draft, m_names);
  auto* layout = new QVBoxLayout(page);
  layout->addWidget(filter);
  layout->addWidget(m_tree, 1);
  layout->addWidget(m_selection);
  connect(filter, &QLineEdit::textChanged, m_tree, &PlanTree::setFilter);
  connect(m_tree, &PlanTree::selectedNodesChanged, this, [this] {
    const NodeIds selected = m_tree->selectedNodes();
    m_selection->show(selected, m_tree->tree().structuresOf(selected));
  });
  return page;
}

QWidget* ImportDialog::makeLeftOut() {
  m_leftOut = new QTableWidget(0, 2);
  m_leftOut->setObjectName(QStringLiteral("leftOut"));
  m_leftOut->setAccessibleName(tr("What is left out or mended"));
  m_leftOut->setHorizontalHeaderLabels({tr("File"), tr("What happened, and what to do")});
  m_leftOut->horizontalHeader()->setStretchLastSection(true);
  m_leftOut->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  m_leftOut->verticalHeader()->hide();
  m_leftOut->setColumnWidth(0, 240);
  m_leftOut->setWordWrap(true);
  m_leftOut->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_leftOut->setTabKeyNavigation(false);
  return m_leftOut;
}

QWidget* ImportDialog::makeUnitButtons() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  m_takeUnit->setObjectName(QStringLiteral("takeUnitButton"));
  m_keepUnit->setObjectName(QStringLiteral("keepUnitButton"));
  layout->addWidget(m_takeUnit);
  layout->addWidget(m_keepUnit);
  layout->addStretch(1);
  connect(m_takeUnit, &QPushButton::clicked, this,
          [this] { chooseUnit(m_draft.plan().report.unitDoubts.front().units.front()); });
  connect(m_keepUnit, &QPushButton::clicked, this,
          [this] { chooseUnit(m_draft.plan().report.unitDoubts.front().unit); });
  return row;
}

void ImportDialog::showUnitDoubt() {
  const auto& doubts = m_draft.plan().report.unitDoubts;
  const bool any = m_draft.ready() && !doubts.empty();
  const bool proposed = any && !doubts.front().units.empty();
  m_takeUnit->setVisible(proposed);
  m_keepUnit->setVisible(any);
  m_takeUnit->parentWidget()->setVisible(any);
  if (proposed)
    m_takeUnit->setText(tr("Take %1 as the Unit").arg(unitText(doubts.front().units.front())));
}

void ImportDialog::chooseUnit(float millimetres) {
  const model::ImportPlan& plan = m_draft.plan();
  m_draft.choose(model::structuresOf(plan, plan.report.unitDoubts.front()),
                 [millimetres](model::StructureChoice& choice) { choice.unit = millimetres; });
}

QWidget* ImportDialog::makeButtons() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  m_state = plainLabel("importState");
  m_state->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  m_progress = new QProgressBar;
  m_progress->setObjectName(QStringLiteral("importProgress"));
  m_progress->setAccessibleName(tr("Progress of reading"));
  m_progress->setTextVisible(false);
  m_progress->setFixedWidth(180);
  auto* buttons = new QDialogButtonBox;
  m_import = buttons->addButton(tr("Import"), QDialogButtonBox::AcceptRole);
  m_import->setObjectName(QStringLiteral("importButton"));
  m_import->setToolTip(tr("Opens what is listed as a scene of its own"));
  m_import->setDefault(true);
  m_add = buttons->addButton(tr("Add to Scene"), QDialogButtonBox::ActionRole);
  m_add->setObjectName(QStringLiteral("addButton"));
  m_add->setToolTip(tr("Puts what is listed below the structures of the open scene"));
  QPushButton* cancel = buttons->addButton(tr("Cancel"), QDialogButtonBox::RejectRole);
  cancel->setObjectName(QStringLiteral("cancelImportButton"));
  connect(m_import, &QPushButton::clicked, this, [this] { give(&ImportDialog::importWanted); });
  connect(m_add, &QPushButton::clicked, this, [this] { give(&ImportDialog::addWanted); });
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  layout->addWidget(m_progress);
  layout->addWidget(m_state, 1);
  layout->addWidget(buttons);
  return row;
}

void ImportDialog::connectDraft() {
  connect(&m_draft, &ImportDraft::planningBegan, this, [this] {
    m_failure.clear();
    m_progress->setRange(0, 0);
    m_state->setText(tr("Reading…"));
    showPlan();
    showState();
  });
  connect(&m_draft, &ImportDraft::progressed, this, [this](double done, const QString& what) {
    m_progress->setRange(0, 1000);
    m_progress->setValue(int(1000.0 * done));
    m_state->setText(what);
  });
  connect(&m_draft, &ImportDraft::planned, this, [this] {
    showPlan();
    showLeftOut();
    showScans();
    showState();
  });
  connect(&m_draft, &ImportDraft::chosen, this, [this] {
    showPlan();
    showState();
  });
  connect(&m_draft, &ImportDraft::patientsFound, this, [this](const PatientQuestion& question) {
    m_progress->setVisible(false);
    m_state->clear();
    askAboutPatients(*this, question, [this] { reject(); });
  });
  connect(&m_draft, &ImportDraft::failed, this, [this](const Error& error) {
    m_failure = told(error.text());
    showPlan();
    showState();
  });
}

/// Shows the scans; where there is nothing else, what can be made of them comes first.
void ImportDialog::showScans() {
  const int tab = m_tabs->indexOf(m_thresholds);
  const bool any = !m_draft.figures().scans.empty();
  const bool fresh = any && !m_tabs->isTabVisible(tab);
  m_tabs->setTabVisible(tab, any);
  if (fresh && m_draft.plan().scene.nodes().empty())
    m_tabs->setCurrentIndex(tab);
}

void ImportDialog::showState() {
  const bool planning = m_draft.planning();
  const Status checked = model::checkChoices(m_draft.plan());
  m_progress->setVisible(planning);
  if (!planning)
    m_state->setText(model::isRead(m_draft.plan()) && !checked.ok() ? told(checked.error().text())
                                                                    : QString());
  const bool able = m_draft.ready() && checked.ok() && m_failure.isEmpty();
  m_import->setEnabled(able);
  m_add->setEnabled(able && m_intoScene);
}

void ImportDialog::showPlan() {
  const model::ImportPlan& plan = m_draft.plan();
  QStringList doubts;
  if (!m_failure.isEmpty())
    doubts << m_failure;
  if (!model::isRead(plan)) {
    m_summary->setText(m_failure.isEmpty() ? tr("Reading…") : tr("Nothing can be imported"));
  } else {
    m_summary->setText(summaryText(plan, m_draft.figures()));
    doubts << sideDoubt(plan, m_draft.figures()) << sizeDoubt(plan, m_draft.figures());
    for (const model::UnitDoubt& doubt : plan.report.unitDoubts)
      doubts << told(doubt.text());
    doubts.removeAll(QString());
  }
  m_doubt->setStyleSheet(messageStyleSheet(palette(), !m_failure.isEmpty()));
  m_doubt->setText(doubts.join(QLatin1Char('\n')));
  m_doubt->setVisible(!doubts.isEmpty());
  showUnitDoubt();
}

void ImportDialog::showLeftOut() {
  const model::ImportReport& report = m_draft.plan().report;
  m_leftOut->setRowCount(0);
  m_leftOut->setRowCount(
      int(report.warnings.size() + report.notes.size() + report.repairs.surfaces.size()));
  int row = 0;
  for (const model::ImportWarning& warning : report.warnings) {
    m_leftOut->setItem(row, 0, cell(QString::fromStdString(warning.file)));
    m_leftOut->setItem(row++, 1, cell(told(warning.reason)));
  }
  for (const std::vector<std::string>* notes : {&report.notes, &report.repairs.surfaces})
    for (const std::string& note : *notes)
      m_leftOut->setItem(row++, 1, cell(told(note)));
  fitRows();
  m_tabs->setTabText(1, row == 0 ? tr("Left out or mended")
                                 : tr("Left out or mended (%1)").arg(QLocale().toString(row)));
}

void ImportDialog::fitRows() {
  constexpr int fewEnough = 200;  // because the height of each is measured
  if (m_leftOut->isVisible() && m_leftOut->rowCount() <= fewEnough)
    m_leftOut->resizeRowsToContents();
}

void ImportDialog::give(void (ImportDialog::*wanted)(const model::ImportPlan&)) {
  const model::ImportPlan plan = m_draft.plan();
  accept();
  emit(this->*wanted)(plan);
}

}  // namespace sline::widgets

#include "moc_import_dialog.cpp"
