// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/colour_dialog.h"

#include <QColorDialog>
#include <QHBoxLayout>

#include "widgets/session/anatomy_palette.h"

namespace sline::widgets {

QColorDialog* makeColourDialog(const DisplayNames& names, const QColor& now, QWidget* parent) {
  auto* dialog = new QColorDialog(now, parent);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  // A dialog of the system has no room for more colours.
  dialog->setOption(QColorDialog::DontUseNativeDialog);
  auto* palette =
      new AnatomyPalette([&names](const std::string& name) { return names.shown(name); }, dialog);
  // The dialog's first row has its own colours at the left and the field of all at the right.
  if (auto* rows = dialog->layout())
    if (auto* first = qobject_cast<QHBoxLayout*>(rows->itemAt(0)->layout()))
      first->insertWidget(0, palette);
  QObject::connect(palette, &AnatomyPalette::chosen, dialog, &QColorDialog::setCurrentColor);
  return dialog;
}

}  // namespace sline::widgets
