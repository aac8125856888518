// SPDX-License-Identifier: Apache-2.0
#include "widgets/pockets/pocket_rows.h"

#include <QHeaderView>
#include <QLocale>
#include <QTreeWidget>
#include <cmath>

#include "model/pockets/scene_pockets.h"
#include "widgets/pockets/pockets_panel.h"

namespace sline::widgets {

namespace {

constexpr int pocketRole = Qt::UserRole;

QString guestNames(Session& session, const model::ScenePocket& pocket) {
  QStringList names;
  for (const model::NodeId id : pocket.guests)
    if (const model::Node* node = session.scene().find(id))
      names << session.names().shown(node->name);
  return names.join(QStringLiteral(", "));
}

QTreeWidgetItem* rowOf(Session& session, const model::ScenePockets& found, std::size_t index) {
  const model::ScenePocket& pocket = found.pockets[index];
  const QLocale locale;
  auto* item = new QTreeWidgetItem;
  const QString molecule = QString::fromStdString(found.molecules[pocket.molecule].name);
  QString name = locale.toString(pocket.number);
  if (found.molecules.size() > 1)
    name = PocketsPanel::tr("%1 of %2").arg(name, molecule.section(QLatin1Char(' '), 0, 0));
  if (!pocket.guests.empty())
    name += QStringLiteral(" – ") + guestNames(session, pocket);
  item->setText(pocketName, name);
  item->setToolTip(pocketName, (name + QLatin1Char('\n') + molecule).toHtmlEscaped());
  item->setText(pocketVolume, locale.toString(std::lround(pocket.pocket.volume)));
  item->setText(pocketMouth, locale.toString(std::lround(pocket.pocket.mouth)));
  item->setText(pocketBurial, PocketsPanel::tr("%1 %").arg(locale.toString(
                                  std::lround(100.0 * double(pocket.pocket.burial)))));
  for (const int column : {pocketVolume, pocketMouth, pocketBurial})
    item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  QStringList residues;
  for (const std::string& residue : found.lining(pocket))
    residues << QString::fromStdString(residue);
  auto* lining = new QTreeWidgetItem(
      item, {PocketsPanel::tr("%n residues at its wall: %1", nullptr, int(residues.size()))
                 .arg(residues.join(QStringLiteral(", ")))});
  lining->setFirstColumnSpanned(true);
  lining->setToolTip(pocketName, lining->text(pocketName).toHtmlEscaped());
  for (QTreeWidgetItem* row : {item, lining})
    row->setData(pocketName, pocketRole, int(index));
  return item;
}

}  // namespace

void addPocketColumns(QTreeWidget& tree) {
  tree.setHeaderLabels({PocketsPanel::tr("Pocket"), PocketsPanel::tr("Volume Å³"),
                        PocketsPanel::tr("Mouth Å²"), PocketsPanel::tr("Burial")});
  QTreeWidgetItem* header = tree.headerItem();
  header->setToolTip(pocketVolume, PocketsPanel::tr("The room that the small probe can fill"));
  header->setToolTip(
      pocketMouth,
      PocketsPanel::tr("The surface across which the pocket is open; 0: it is closed"));
  header->setToolTip(pocketBurial,
                     PocketsPanel::tr("The share of directions in which atoms lie within 10 Å"));
  header->setToolTip(pocketName, PocketsPanel::tr("Its number, and what lies in it"));
  for (const int column : {pocketVolume, pocketMouth, pocketBurial})
    header->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  tree.header()->setStretchLastSection(false);
  tree.header()->setSectionResizeMode(QHeaderView::ResizeToContents);
}

void showPockets(QTreeWidget& tree, Session& session, const model::ScenePockets& found) {
  tree.clear();
  QList<QTreeWidgetItem*> rows;
  for (std::size_t i = 0; i < found.pockets.size(); ++i)
    rows << rowOf(session, found, i);
  tree.addTopLevelItems(rows);
  for (QTreeWidgetItem* row : rows)
    row->child(0)->setFirstColumnSpanned(true);
}

int pocketOfRow(const QTreeWidget& tree) {
  const QTreeWidgetItem* item = tree.currentItem();
  return item ? item->data(pocketName, pocketRole).toInt() : -1;
}

}  // namespace sline::widgets
