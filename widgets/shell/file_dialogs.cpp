// SPDX-License-Identifier: Apache-2.0
#include "widgets/shell/file_dialogs.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include "model/import/kinds/file_kinds.h"
#include "model/scene_file/scene_file.h"
#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {

/// Returns "*.sline *.mrml *.obj …", for a file dialog.
QString readablePatterns() {
  QStringList patterns{QStringLiteral("*.sline"), QStringLiteral("*.mrml"), QStringLiteral("*.mrb"),
                       QStringLiteral("*.fcsv"), QStringLiteral("*.mrk.json")};
  for (const std::string& ending : model::surfaceEndings())
    patterns << QLatin1Char('*') + QString::fromStdString(ending);
  return patterns.join(QLatin1Char(' '));
}

QFileDialog* fileDialog(QWidget& window, const QString& title, const QString& folder) {
  auto* dialog = new QFileDialog(&window, title, folder);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  return dialog;
}

/// Makes a question in plain text, because names come from files and must not act as markup.
QMessageBox* question(QWidget& window, const char* name, const QString& text) {
  auto* box = new QMessageBox(&window);
  box->setObjectName(QLatin1String(name));
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setTextFormat(Qt::PlainText);
  box->setText(text);
  return box;
}

/// Asks about the name with its ending, because the file dialog has asked about the name as it was
/// typed.
void askAboutOverwriting(QWidget& window, const QString& path, const SceneFileQuestion& asked) {
  QMessageBox* box =
      question(window, "overwriteDialog",
               tr("“%1” is there already. Replace it?").arg(QFileInfo(path).fileName()));
  QPushButton* replace = box->addButton(tr("Replace"), QMessageBox::AcceptRole);
  replace->setObjectName(QStringLiteral("replaceFile"));
  box->setDefaultButton(box->addButton(QMessageBox::Cancel));
  QObject::connect(box, &QDialog::finished, &window, [box, replace, path, asked] {
    box->clickedButton() == replace ? asked.chosen(path) : asked.cancelled();
  });
  box->open();
}

}  // namespace

void chooseFiles(QWidget& window, const QString& folder, const PathsChosen& chosen) {
  QFileDialog* dialog = fileDialog(window, tr("Open Files"), folder);
  dialog->setObjectName(QStringLiteral("openFilesDialog"));
  dialog->setNameFilter(tr("Meshes and scenes (%1);;All files (*)").arg(readablePatterns()));
  dialog->setFileMode(QFileDialog::ExistingFiles);
  QObject::connect(dialog, &QFileDialog::filesSelected, &window, chosen);
  dialog->open();
}

void chooseFolder(QWidget& window, const QString& folder, const PathsChosen& chosen) {
  QFileDialog* dialog = fileDialog(window, tr("Open Folder"), folder);
  dialog->setObjectName(QStringLiteral("openFolderDialog"));
  dialog->setFileMode(QFileDialog::Directory);
  QObject::connect(dialog, &QFileDialog::filesSelected, &window, chosen);
  dialog->open();
}

void chooseSceneFile(QWidget& window, const SceneFileQuestion& asked) {
  const QFileInfo suggestion(asked.suggestion);
  QFileDialog* dialog = fileDialog(window, asked.title, suggestion.path());
  dialog->setObjectName(QStringLiteral("saveDialog"));
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setFileMode(QFileDialog::AnyFile);
  dialog->setNameFilter(tr("Sline scenes (*.sline)"));
  dialog->setDefaultSuffix(QStringLiteral("sline"));
  dialog->selectFile(suggestion.fileName());
  QObject::connect(
      dialog, &QFileDialog::fileSelected, &window, [&window, asked](const QString& path) {
        if (model::isSceneFile(path.toStdString()))
          return asked.chosen(path);
        const QString named = path + QStringLiteral(".sline");
        QFileInfo::exists(named) ? askAboutOverwriting(window, named, asked) : asked.chosen(named);
      });
  QObject::connect(dialog, &QDialog::rejected, &window, asked.cancelled);
  dialog->open();
}

void askAboutUnsaved(QWidget& window, const UnsavedQuestion& asked) {
  QMessageBox* box =
      question(window, "unsavedDialog", tr("Save the changes to “%1”?").arg(asked.title));
  box->setInformativeText(tr("Changes that are not saved will be lost."));
  box->setStandardButtons(QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  box->setDefaultButton(QMessageBox::Save);
  QObject::connect(box, &QDialog::finished, &window, [asked](int answer) {
    if (answer == QMessageBox::Save)
      asked.save();
    else if (answer == QMessageBox::Discard)
      asked.discard();
  });
  box->open();
}

void askAboutReverting(QWidget& window, const QString& title, const std::function<void()>& revert) {
  QMessageBox* box =
      question(window, "revertDialog", tr("Go back to “%1” as it was saved last?").arg(title));
  box->setInformativeText(tr("Undo brings back what was changed since."));
  QPushButton* go = box->addButton(tr("Revert"), QMessageBox::AcceptRole);
  go->setObjectName(QStringLiteral("revertFile"));
  box->setDefaultButton(go);
  box->addButton(QMessageBox::Cancel);
  QObject::connect(box, &QDialog::finished, &window, [box, go, revert] {
    if (box->clickedButton() == go)
      revert();
  });
  box->open();
}

}  // namespace sline::widgets
