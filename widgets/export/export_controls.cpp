// SPDX-License-Identifier: Apache-2.0
// Makes the controls of the export dialog.
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <iterator>
#include <utility>

#include "widgets/export/alt_text_hint.h"
#include "widgets/export/export_dialog.h"
#include "widgets/export/export_preview.h"
#include "widgets/export/export_texts.h"
#include "widgets/export/file_pager.h"
#include "widgets/export/option_form.h"
#include "widgets/export/page_panel.h"
#include "widgets/export/size_gauge.h"

namespace sline::widgets {

QLabel* ExportDialog::heading(const QString& text) {
  auto* label = new QLabel(text);
  QFont bold = label->font();
  bold.setBold(true);
  label->setFont(bold);
  return label;
}

QWidget* ExportDialog::makeKinds() {
  auto* column = new QWidget;
  auto* layout = new QVBoxLayout(column);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(heading(tr("Kind of file")));
  m_kinds->setObjectName(QStringLiteral("exportKinds"));
  m_kinds->setAccessibleName(tr("Kind of file"));
  m_kinds->setWordWrap(true);
  m_kinds->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  for (const render::ExportFormat& format : render::exportFormats()) {
    auto* item = new QListWidgetItem(titleOf(format), m_kinds);
    item->setData(Qt::UserRole, QLatin1String(format.id));
    item->setSizeHint({0, 2 * m_kinds->fontMetrics().lineSpacing()});
    item->setData(Qt::AccessibleDescriptionRole, helpOf(format));
    if (m_draft.kind == QLatin1String(format.id))
      m_kinds->setCurrentItem(item);
  }
  layout->addWidget(m_kinds, 1);
  column->setFixedWidth(210);
  return column;
}

void ExportDialog::addSubject(QVBoxLayout& layout) {
  m_seen->setObjectName(QStringLiteral("exportSeen"));
  m_savedViews->setObjectName(QStringLiteral("exportSavedViews"));
  m_savedViews->setEnabled(!m_source.scene.views().empty());
  m_filled->setObjectName(QStringLiteral("exportFilled"));
  m_filled->setToolTip(tr("Moves the camera to or fro without turning it"));
  m_filled->setChecked(m_draft.filled);
  m_subjectWidgets = {heading(tr("What")), m_seen, m_savedViews, m_filled};
  for (QWidget* widget : m_subjectWidgets)
    layout.addWidget(widget);
}

void ExportDialog::addForms(QVBoxLayout& layout) {
  using render::OptionGroup;
  const std::pair<OptionGroup, QString> parts[] = {
      {OptionGroup::kind, tr("For this kind")},
      {OptionGroup::picture, tr("Picture")},
      {OptionGroup::labels, tr("Labels")},
      {OptionGroup::marks, tr("At the picture's edge")},
      {OptionGroup::credit, tr("In the file's details")}};
  const std::vector<const render::ExportOption*> options = render::exportOptions();
  const QStringList languages = labelLanguages(m_source.scene);
  for (const auto& [part, title] : parts) {
    std::vector<const render::ExportOption*> own;
    std::copy_if(options.begin(), options.end(), std::back_inserter(own),
                 [wanted = part](const render::ExportOption* option) {
                   return option->group == wanted && option->title;
                 });
    if (own.empty())
      continue;
    OptionSection made{.heading = heading(title),
                       .form = new OptionForm(m_draft.order, std::move(own), languages)};
    layout.addSpacing(8);
    layout.addWidget(made.heading);
    layout.addWidget(made.form);
    connect(made.form, &OptionForm::changed, this, &ExportDialog::refresh);
    m_parts.push_back(made);
  }
}

QWidget* ExportDialog::makeOptions() {
  auto* column = new QWidget;
  auto* layout = new QVBoxLayout(column);
  layout->setContentsMargins(0, 0, 8, 0);
  m_help->setMinimumHeight(m_help->fontMetrics().lineSpacing() * 3);
  m_help->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  layout->addWidget(m_help);
  layout->addSpacing(4);
  addSubject(*layout);
  layout->addSpacing(8);
  m_pageHeading = heading(tr("Page"));
  layout->addWidget(m_pageHeading);
  layout->addWidget(m_page);
  addForms(*layout);
  layout->addStretch(1);
  auto* area = new QScrollArea;
  area->setObjectName(QStringLiteral("exportOptions"));
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setWidgetResizable(true);
  area->setFocusPolicy(Qt::NoFocus);
  area->setWidget(column);
  area->setFixedWidth(384);
  return area;
}

QWidget* ExportDialog::makePreviewColumn() {
  auto* column = new QWidget;
  auto* layout = new QVBoxLayout(column);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_preview, 1);
  layout->addWidget(m_pager);
  layout->addSpacing(6);
  layout->addWidget(heading(tr("What the file will contain")));
  m_summary->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_summary->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  m_summary->setMinimumHeight(m_summary->fontMetrics().lineSpacing() * 6);
  layout->addWidget(m_summary);
  return column;
}

QWidget* ExportDialog::makeTarget() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(10);
  auto* label = new QLabel(tr("F&ile"));
  label->setBuddy(m_target);
  m_target->setObjectName(QStringLiteral("exportTarget"));
  auto* browse = new QPushButton(tr("&Browse…"));
  browse->setObjectName(QStringLiteral("exportBrowse"));
  browse->setAutoDefault(false);
  connect(browse, &QPushButton::clicked, this, &ExportDialog::browse);
  layout->addWidget(label);
  layout->addWidget(m_target, 1);
  layout->addWidget(browse);
  return row;
}

QWidget* ExportDialog::makeButtons() {
  auto* buttons = new QDialogButtonBox;
  buttons->addButton(m_export, QDialogButtonBox::AcceptRole);
  m_export->setObjectName(QStringLiteral("exportButton"));
  m_export->setDefault(true);
  QPushButton* close = buttons->addButton(tr("Cancel"), QDialogButtonBox::RejectRole);
  close->setObjectName(QStringLiteral("exportCancelButton"));
  close->setAutoDefault(false);
  connect(m_export, &QPushButton::clicked, this, &ExportDialog::tryToExport);
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  return buttons;
}

void ExportDialog::connectControls() {
  connect(m_kinds, &QListWidget::currentItemChanged, this, &ExportDialog::chooseKind);
  connect(m_seen, &QRadioButton::clicked, this,
          [this] { chooseSubject(render::ViewSubject::shown); });
  connect(m_savedViews, &QRadioButton::clicked, this,
          [this] { chooseSubject(render::ViewSubject::all); });
  connect(m_filled, &QCheckBox::toggled, this, [this](bool filled) {
    m_draft.filled = filled;
    refresh();
  });
  connect(m_hint, &AltTextHint::told, this, [this](const QString& text) {
    if (auto* words = findChild<QPlainTextEdit*>(QStringLiteral("export-altText")))
      words->setPlaceholderText(text);
  });
  connect(m_preview, &ExportPreview::drawn, this, &ExportDialog::showDoubt);
  connect(m_preview, &ExportPreview::drawn, this, &ExportDialog::showPager);
  connect(m_preview, &ExportPreview::drawn, this, [this] {
    m_gauge->measure(m_draft.kind, measured(), m_preview->picture());
    showSummary();
  });
  connect(m_gauge, &SizeGauge::measured, this, &ExportDialog::showSummary);
  connect(m_pager, &FilePager::turned, this, [this] {
    if (m_pages.size() < 2) {
      m_preview->turnTo(m_pager->index());
      return;
    }
    m_preview->show(shown());
    showDoubt();
  });
  connect(m_page, &PagePanel::changed, this, &ExportDialog::refresh);
  connect(m_target, &QLineEdit::textChanged, this, [this](const QString& text) {
    m_draft.target = QDir::fromNativeSeparators(text.trimmed());
    refresh();
  });
}

}  // namespace sline::widgets
