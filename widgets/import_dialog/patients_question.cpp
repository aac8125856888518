// SPDX-License-Identifier: Apache-2.0
#include "widgets/import_dialog/patients_question.h"

#include <QMessageBox>
#include <QPushButton>

#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {

/// Returns "1: a.dcm, b.dcm and 3 more".
QString filesLine(int number, const model::PatientFiles& of) {
  constexpr std::size_t mostShown = 4;
  QStringList names;
  for (std::size_t i = 0; i < std::min(of.files.size(), mostShown); ++i)
    names << (of.files[i] == model::openSceneName
                  ? tr("what is open")
                  : QString::fromStdString(of.files[i].filename().string()));
  const int more = int(of.files.size()) - int(names.size());
  const QString list = names.join(QStringLiteral(", "));
  return more > 0 ? tr("%1: %2 and %n more", nullptr, more).arg(number).arg(list)
                  : tr("%1: %2").arg(number).arg(list);
}

}  // namespace

void askAboutPatients(QWidget& window, const PatientQuestion& asked,
                      const std::function<void()>& cancelled) {
  using Wanted = model::PatientsWanted;
  const auto count = int(asked.patients.apart.size());
  auto* box = new QMessageBox(&window);
  box->setObjectName(QStringLiteral("patientsDialog"));
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setIcon(QMessageBox::Question);
  // Names of files must not act as markup.
  box->setTextFormat(Qt::PlainText);
  box->setText(asked.patients.byName
                   ? tr("Names tell that these files are of %n bodies. Put them into one scene?",
                        nullptr, count)
               : asked.patients.certain
                   ? tr("These files are of %n patients. Put them into one scene?", nullptr, count)
                   : tr("These files are of %n studies, and nothing says that they are of one "
                        "patient. Put them into one scene?",
                        nullptr, count));
  QStringList lines;
  for (int i = 0; i < count; ++i)
    lines << filesLine(i + 1, asked.patients.apart[std::size_t(i)]);
  box->setInformativeText(lines.join(QLatin1Char('\n')));
  QPushButton* together = box->addButton(tr("Import Together"), QMessageBox::DestructiveRole);
  together->setObjectName(QStringLiteral("patientsTogether"));
  QPushButton* first = nullptr;
  if (asked.firstAlone) {
    first = box->addButton(tr("Only the First"), QMessageBox::AcceptRole);
    first->setObjectName(QStringLiteral("patientsFirst"));
  }
  QPushButton* cancel = box->addButton(QMessageBox::Cancel);
  box->setDefaultButton(first ? first : cancel);
  QObject::connect(box, &QDialog::finished, &window,
                   [box, together, first, goOn = asked.goOn, cancelled] {
                     if (box->clickedButton() == together)
                       goOn(Wanted::together);
                     else if (first && box->clickedButton() == first)
                       goOn(Wanted::first);
                     else
                       cancelled();
                   });
  box->open();
}

}  // namespace sline::widgets
