// SPDX-License-Identifier: Apache-2.0
// The files of the dialog of figures: which are chosen, read and written.
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QPointer>
#include <QPushButton>

#include "widgets/figure/figure_dialog.h"
#include "widgets/text/path_text.h"
#include "widgets/text/told.h"

namespace sline::widgets {

QString FigureDialog::folder() const {
  const std::filesystem::path& file = m_desk.file().empty() ? m_open.file : m_desk.file();
  return file.empty() ? QDir::homePath() : textOf(file.parent_path());
}

void FigureDialog::chooseOpen() {
  auto* dialog = new QFileDialog(this, tr("Open Figure"), folder());
  dialog->setObjectName(QStringLiteral("figureOpenDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  dialog->setNameFilter(tr("Figures (*.json)"));
  connect(dialog, &QFileDialog::fileSelected, this, &FigureDialog::openFile);
  dialog->open();
}

void FigureDialog::openFile(const QString& path) {
  m_queue.drop();
  m_queue.add(
      [dialog = QPointer(this), open = m_open, file = pathOf(path)](const std::stop_token&) {
        const auto desk = std::make_shared<Result<FigureDesk>>(FigureDesk::read(open, file));
        return BackgroundQueue::Sequel([dialog, desk] {
          if (!dialog)
            return;
          if (!desk->ok())
            return dialog->m_told->setText(told(desk->error().text()));
          dialog->m_desk = **desk;
          dialog->m_list->setCurrentRow(0);
          dialog->showAll();
        });
      });
}

void FigureDialog::chooseScene() {
  auto* dialog = new QFileDialog(this, tr("Add Views of Another Scene"), folder());
  dialog->setObjectName(QStringLiteral("figureSceneDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  dialog->setNameFilter(tr("Scenes (*.sline)"));
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    tell(m_desk.addScene(pathOf(path)), {});
    showAll();
  });
  dialog->open();
}

void FigureDialog::chooseSave(const std::function<void()>& then) {
  auto* dialog = new QFileDialog(this, tr("Save Figure"), folder());
  dialog->setObjectName(QStringLiteral("figureSaveDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setNameFilter(tr("Figures (*.json)"));
  dialog->setDefaultSuffix(QStringLiteral("json"));
  if (!m_desk.file().empty())
    dialog->selectFile(textOf(m_desk.file()));
  connect(dialog, &QFileDialog::fileSelected, this, [this, then](const QString& path) {
    if (saveFile(path) && then)
      then();
  });
  dialog->open();
}

bool FigureDialog::saveFile(const QString& path) {
  const Status saved = m_desk.save(pathOf(path));
  if (saved.ok())
    showAll();
  tell(saved, tr("Saved %1").arg(QFileInfo(path).fileName()));
  return saved.ok();
}

void FigureDialog::chooseExport() {
  auto* dialog = new QFileDialog(this, tr("Export Figure"), folder());
  dialog->setObjectName(QStringLiteral("figureExportDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setNameFilters({tr("PDF (*.pdf)"), tr("SVG drawing (*.svg)"), tr("PNG picture (*.png)"),
                          tr("TIFF picture (*.tiff)")});
  dialog->setDefaultSuffix(QStringLiteral("pdf"));
  connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString& filter) {
    dialog->setDefaultSuffix(filter.section(QLatin1Char('.'), -1).chopped(1));
  });
  connect(dialog, &QFileDialog::fileSelected, this, &FigureDialog::exportFile);
  dialog->open();
}

void FigureDialog::exportFile(const QString& path) {
  const std::filesystem::path target = pathOf(path);
  if (const Status named = render::checkPageName(target, "a figure"); !named.ok())
    return tell(named, {});
  if (m_writing->busy())
    return;
  m_told->setText(tr("Writing the figure…"));
  m_export->setEnabled(false);
  m_writing->begin(work(), target);
}

}  // namespace sline::widgets
