// SPDX-License-Identifier: Apache-2.0
// Tells what the rows of the tree show, and describes it in words.
#include <QColor>
#include <QLocale>

#include "widgets/gamma/look_drag.h"
#include "widgets/gamma/stages.h"
#include "widgets/structure_tree/structure_tree_model.h"

namespace sline::widgets {

namespace {

QString textOf(const model::GammaRange& range) {
  return range.low == range.high
             ? gammaText(range.low)
             : StructureTreeModel::tr("%1 to %2").arg(gammaText(range.low), gammaText(range.high));
}

}  // namespace

QString StructureTreeModel::nameOf(const model::Node& node) const {
  const QString own = QString::fromStdString(node.name);
  const auto& shown = m_filter.names().shown;
  return shown ? shown(own) : own;
}

QVariant StructureTreeModel::data(const QModelIndex& index, int role) const {
  const model::NodeId id = idOf(index);
  switch (role) {
    case shownRole:
      return int(state(id).shown);
    case coloursRole: {
      QVariantList colours;
      for (const Colour& c : state(id).colours)
        colours << QColor(c.red, c.green, c.blue);
      return colours;
    }
    case opacityRole:
      return state(id).opacity.value();
    case lowGammaRole:
      return state(id).gamma.low.value();
    case highGammaRole:
      return state(id).gamma.high.value();
    case ownGammaRole:
      return state(id).ownGamma;
    case ownColourRole:
      return state(id).ownColour || state(id).ownOpacity;
    case lockRole:
      return int(state(id).lock);
    default:
      break;
  }
  const model::Node* node = m_session.scene().find(id);
  if (!node)
    return {};
  switch (role) {
    case Qt::DisplayRole:
      return index.column() == name ? nameOf(*node) : QVariant();
    case Qt::EditRole:
      return index.column() == name ? QString::fromStdString(node->name) : QVariant();
    case Qt::ToolTipRole:
      // Names come from files and may look like markup.
      return QStringLiteral("<p>%1</p>").arg(tipOf(index).toHtmlEscaped());
    case Qt::AccessibleTextRole:
      return describe(index);
    default:
      return {};
  }
}

QString StructureTreeModel::describeGamma(const model::Node& node) const {
  const QString text = tr("Γ %1").arg(textOf(state(node.id).gamma));
  if (node.style.gamma)
    return tr("%1, its own").arg(text);
  return node.isGroup() ? text : tr("%1, from the group above").arg(text);
}

QString StructureTreeModel::describeColour(const model::Node& node) const {
  const RowState& row = state(node.id);
  QString text = row.ownColour    ? tr("Colour, its own")
                 : node.isGroup() ? tr("Colours of what is in it")
                                  : tr("Colour, from the group above");
  if (row.opacity.value() < 1.0f || row.ownOpacity) {
    const QString percent = QLocale().toString(int(100.0f * row.opacity.value() + 0.5f));
    text += QStringLiteral("; ") + (row.ownOpacity ? tr("opacity %1 %, its own").arg(percent)
                                                   : tr("opacity %1 %").arg(percent));
  }
  return text;
}

QString StructureTreeModel::tipOf(const QModelIndex& index) const {
  const model::GammaRange& range = state(idOf(index)).gamma;
  const bool several = index.column() == gamma && range.low != range.high;
  return several ? describe(index) + QStringLiteral(". ") + differencesText() : describe(index);
}

QString StructureTreeModel::describe(const QModelIndex& index) const {
  const model::Node& node = *m_session.scene().find(idOf(index));
  switch (index.column()) {
    case eye:
      switch (state(node.id).shown) {
        case model::Visibility::none:
          return tr("Hidden");
        case model::Visibility::some:
          return tr("Partly shown");
        case model::Visibility::all:
          return tr("Shown");
      }
      return {};
    case swatch:
      return describeColour(node);
    case gamma:
      return describeGamma(node);
    case lock:
      switch (state(node.id).lock) {
        case RowLock::open:
          return tr("Not locked");
        case RowLock::above:
          return tr(
              "Locked by the group above: keeps its look, name and place and cannot be "
              "clicked in the picture");
        case RowLock::own:
          return tr("Locked: keeps its look, name and place and cannot be clicked in the picture");
      }
      return {};
    default:
      return describeName(node);
  }
}

QString StructureTreeModel::describeName(const model::Node& node) const {
  const QString text = nameOf(node);
  if (node.isGroup())
    return tr("%1, structures: %2")
        .arg(text, QLocale().toString(qulonglong(state(node.id).structures)));
  const QString own = QString::fromStdString(node.name);
  const QString names = text == own ? text : QStringLiteral("%1 (%2)").arg(text, own);
  return m_otherSides.has(m_session.scene(), node.id)
             ? tr("%1: lies on the other side than its name says").arg(names)
             : names;
}

QVariant StructureTreeModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
    return {};
  if (section == name)
    return tr("Structure");
  return section == gamma ? tr("Γ") : QVariant();
}

}  // namespace sline::widgets
