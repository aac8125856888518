// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/anatomy_palette.h"

#include <QPixmap>

#include "model/anatomy/body_systems.h"

namespace sline::widgets {

AnatomyPalette::AnatomyPalette(const std::function<QString(const std::string&)>& shown,
                               QWidget* parent)
    : QListWidget(parent) {
  setObjectName(QStringLiteral("anatomyPalette"));
  setAccessibleName(tr("Anatomical colours"));
  setUniformItemSizes(true);
  constexpr int side = 32;  // pixels, enough for screens of twice the usual resolution
  for (const model::NamedColour& named : model::AnatomyTable().colours()) {
    const QColor colour(named.colour.red, named.colour.green, named.colour.blue);
    QPixmap swatch(side, side);
    swatch.fill(colour);
    QString name = shown(named.name);
    name[0] = name[0].toUpper();
    auto* item = new QListWidgetItem(QIcon(swatch), name, this);
    item->setData(Qt::UserRole, colour);
    if (named.system) {
      QFont font = item->font();
      font.setBold(true);
      item->setFont(font);
    }
  }
  setMinimumWidth(sizeHintForColumn(0) + 40);
  connect(this, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
    if (item)
      emit chosen(item->data(Qt::UserRole).value<QColor>());
  });
}

}  // namespace sline::widgets

#include "moc_anatomy_palette.cpp"
