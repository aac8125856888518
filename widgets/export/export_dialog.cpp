// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/export_dialog.h"

#include <QCheckBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>

#include "render/export/order/view_orders.h"
#include "widgets/export/alt_text_hint.h"
#include "widgets/export/export_preview.h"
#include "widgets/export/export_texts.h"
#include "widgets/export/file_pager.h"
#include "widgets/export/option_form.h"
#include "widgets/export/page_panel.h"
#include "widgets/export/size_gauge.h"
#include "widgets/export/target_problems.h"
#include "widgets/session/names_by_language.h"
#include "widgets/text/path_text.h"

namespace sline::widgets {

namespace {

QLabel* plainLabel(const char* name) {
  auto* label = new QLabel;
  label->setObjectName(QLatin1String(name));
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  return label;
}

/// Colours the text as the window's messages are: amber for what the user should know.
QString messageStyleSheet(const QPalette& palette) {
  const bool dark =
      palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
  return QLatin1String(dark ? "background: #4a3d12; color: #f7ecc9;"
                            : "background: #f7ecc9; color: #4d3b05;") +
         QStringLiteral(" padding: 6px 10px; border-radius: 4px;");
}

std::vector<std::filesystem::path> targetsOf(const std::vector<render::ExportPiece>& files) {
  std::vector<std::filesystem::path> targets;
  for (const render::ExportPiece& file : files)
    targets.push_back(file.target);
  return targets;
}

}  // namespace

ExportDialog::ExportDialog(ExportDraft& draft, ExportSource source, Viewport& viewport,
                           QWidget* parent)
    : QDialog(parent),
      m_draft(draft),
      m_source(std::move(source)),
      m_kinds(new QListWidget),
      m_help(plainLabel("exportHelp")),
      m_seen(new QRadioButton(tr("&What the window shows"))),
      m_savedViews(new QRadioButton),
      m_filled(new QCheckBox(tr("&Fill the page with what is shown"))),
      m_page(new PagePanel(draft)),
      m_preview(new ExportPreview(viewport)),
      m_gauge(new SizeGauge(parent)),
      m_hint(new AltTextHint(this)),
      m_pager(new FilePager),
      m_summary(plainLabel("exportSummary")),
      m_doubt(plainLabel("exportDoubt")),
      m_target(new QLineEdit(QDir::toNativeSeparators(draft.target))),
      m_export(new QPushButton(tr("Export"))) {
  setObjectName(QStringLiteral("exportDialog"));
  setWindowTitle(tr("Export %1").arg(m_source.title));
  auto* columns = new QHBoxLayout;
  columns->setSpacing(18);
  columns->addWidget(makeKinds());
  columns->addWidget(makeOptions());
  columns->addWidget(makePreviewColumn(), 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(16, 16, 16, 14);
  layout->setSpacing(12);
  layout->addLayout(columns, 1);
  layout->addWidget(makeTarget());
  layout->addWidget(m_doubt);
  layout->addWidget(makeButtons());
  connectControls();
  chooseKind();
  m_kinds->setFocus();
  resize(1120, 720);
}

ExportDialog::~ExportDialog() {
  // Hiding takes the focus from a field, which accepts its text then; afterwards that would be too
  // late.
  hide();
  m_gauge->disconnect(this);
  m_gauge->retire();
}

void ExportDialog::chooseKind() {
  if (const QListWidgetItem* item = m_kinds->currentItem())
    m_draft.kind = item->data(Qt::UserRole).toString();
  m_help->setText(helpOf(*formatOf(m_draft.kind)));
  m_page->refresh();
  const bool page = pageUseOf(m_draft.kind) != render::PageUse::none;
  m_pageHeading->setVisible(page);
  m_page->setVisible(page);
  showSubject();
  for (const OptionSection& part : m_parts)
    part.heading->setVisible(part.form->showFor(*formatOf(m_draft.kind)));
  m_target->setText(QDir::toNativeSeparators(withEndingOf(m_draft.target, m_draft.kind)));
  refresh();
}

void ExportDialog::chooseSubject(render::ViewSubject subject) {
  m_draft.subject = subject;
  showSubject();
  refresh();
}

void ExportDialog::showSubject() {
  const auto views = int(m_source.scene.views().size());
  for (QWidget* widget : m_subjectWidgets)
    widget->setVisible(hasViews(m_draft.kind));
  const bool one = holdsViews(m_draft.kind);
  m_savedViews->setText(one ? tr("All %n sa&ved views, in one file", nullptr, views)
                            : tr("Each sa&ved view, %n files", nullptr, views));
  m_savedViews->setToolTip(
      one ? tr("Each view has a page, a slide or a deck of its own")
          : tr("A file for each view, with its number and name behind the file's own"));
  const bool all = views > 0 && wantsViews(m_draft);
  (all ? m_savedViews : m_seen)->setChecked(true);
  m_filled->setEnabled(!(one && all));
  m_draft.order.of<render::ViewsOptions>().subject =
      all ? render::ViewSubject::all : render::ViewSubject::shown;
  for (const OptionSection& part : m_parts)
    part.form->enableWhatApplies();
}

QString ExportDialog::target() const {
  const QFileInfo typed(m_draft.target);
  // A device or a pipe keeps its name.
  const bool special = typed.exists() && !typed.isFile() && !typed.isDir();
  const QString named = typed.fileName().isEmpty() || typed.isDir() || special
                            ? m_draft.target
                            : withEndingOf(m_draft.target, m_draft.kind);
  return typed.isAbsolute() || named.isEmpty() ? named : QDir::home().filePath(named);
}

const render::ExportPiece& ExportDialog::shown() const {
  return m_pages[m_pages.size() > 1 ? m_pager->index() : 0];
}

const render::ExportPiece& ExportDialog::measured() const {
  return m_files.size() > 1 ? shown() : m_files.front();
}

void ExportDialog::refresh() {
  ExportDraft whole = m_draft;
  whole.target = target();
  m_files = exportFiles(whole, m_source);
  m_pages = previewedFiles(whole, m_files);
  m_page->setEnabled(!hasOwnPage(m_draft));
  showPager();
  m_preview->show(shown());
  m_hint->ask(shown());
  sayLanguage();
  showSummary();
  showDoubt();
}

void ExportDialog::showSummary() {
  m_summary->setText(
      exportSummary(m_draft, m_files, m_pages, m_gauge->bytes(m_draft.kind, measured()))
          .join(QLatin1Char('\n')));
}

void ExportDialog::showPager() {
  QStringList names;
  if (m_pages.size() > 1)
    for (const render::ExportPiece& page : m_pages)
      names << (m_files.size() > 1 ? textOf(page.target.filename())
                                   : QString::fromStdString(page.order.viewName).simplified());
  else if (isSheet(m_draft))
    names.fill(tr("Page"), qsizetype(m_preview->pages()));
  m_pager->setNames(names);
  m_preview->turnTo(m_pages.size() > 1 ? 0 : m_pager->index());
}

void ExportDialog::sayLanguage() {
  const QString language = languageName(QString::fromStdString(m_draft.order.labels.language));
  const QString text = tr("Language: %1").arg(language);
  if (auto* title = findChild<QLineEdit*>(QStringLiteral("export-sheetTitle")))
    title->setPlaceholderText(text);
  if (auto* words = findChild<QPlainTextEdit*>(QStringLiteral("export-sheetText")))
    words->setPlaceholderText(text);
}

void ExportDialog::showDoubt() {
  const QString problem = targetProblem(targetsOf(m_files));
  QString doubt = problem.isEmpty() ? exportDoubt(m_pages) : problem;
  if (doubt.isEmpty()) {
    // With several files the remarks are about the one that is shown; films are long, and surfaces
    // have no page. Until the next page is drawn the last one's remarks stay, as its picture does,
    // so that nothing jumps.
    const bool paged = pageIsAsPreviewed(m_draft.kind);
    doubt =
        exportRemarks(m_draft, shown().order, paged ? m_preview->notes() : render::ExportNotes());
  }
  m_doubt->setStyleSheet(messageStyleSheet(palette()));
  m_doubt->setText(doubt);
  m_doubt->setVisible(!doubt.isEmpty());
  m_export->setEnabled(problem.isEmpty());
}

void ExportDialog::browse() {
  const QFileInfo now(target());
  auto* dialog = new QFileDialog(this, tr("Export To"), now.absolutePath());
  dialog->setObjectName(QStringLiteral("exportFileDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setFileMode(QFileDialog::AnyFile);
  // Overwriting is confirmed once, for all files and with their endings.
  dialog->setOption(QFileDialog::DontConfirmOverwrite);
  const render::ExportFormat& format = *formatOf(m_draft.kind);
  if (*format.extension != '\0')
    dialog->setNameFilter(
        QStringLiteral("%1 (*.%2)")
            .arg(titleOf(format).remove(QLatin1Char('(')).remove(QLatin1Char(')')),
                 QLatin1String(format.extension)));
  dialog->selectFile(now.fileName());
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    m_target->setText(QDir::toNativeSeparators(withEndingOf(path, m_draft.kind)));
  });
  dialog->open();
}

void ExportDialog::tryToExport() {
  refresh();  // the folder may have been deleted meanwhile
  if (!m_export->isEnabled())
    return;
  const QStringList there = existingFiles(targetsOf(m_files));
  if (there.isEmpty())
    return give();
  auto* box = new QMessageBox(this);
  box->setObjectName(QStringLiteral("exportReplaceDialog"));
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setTextFormat(Qt::PlainText);
  box->setText(there.size() == 1 ? tr("“%1” is there already. Replace it?").arg(there.front())
                                 : tr("%n of the files are there already. Replace them?", nullptr,
                                      int(there.size())));
  if (there.size() > 1)
    box->setDetailedText(there.join(QLatin1Char('\n')));
  QPushButton* replace = box->addButton(tr("Replace"), QMessageBox::AcceptRole);
  replace->setObjectName(QStringLiteral("exportReplace"));
  box->setDefaultButton(box->addButton(QMessageBox::Cancel));
  connect(box, &QDialog::finished, this, [this, box, replace] {
    if (box->clickedButton() == replace)
      give();
  });
  box->open();
}

void ExportDialog::give() {
  const std::vector<render::ExportPiece> files = m_files;
  const QString kind = m_draft.kind;
  m_draft.target = target();
  m_draft.order.altText.clear();  // it is about this picture
  accept();
  emit exportWanted(kind, files);
}

}  // namespace sline::widgets

#include "moc_export_dialog.cpp"
