// SPDX-License-Identifier: Apache-2.0
#include "widgets/import_dialog/plan_tree_model.h"

#include <QColor>
#include <QFont>
#include <QLocale>

#include "widgets/import_dialog/choice_rows.h"
#include "widgets/import_dialog/plan_texts.h"

namespace sline::widgets {

namespace {

QString nameOf(const model::Node& node, const model::StructureChoice& choice) {
  return QString::fromStdString(choice.name.value_or(node.name));
}

}  // namespace

PlanTreeModel::PlanTreeModel(ImportDraft& draft, QObject* parent)
    : QAbstractItemModel(parent), m_draft(draft) {
  connect(&draft, &ImportDraft::planned, this, &PlanTreeModel::reset);
  connect(&draft, &ImportDraft::chosen, this, &PlanTreeModel::showChosen);
  reset();
}

void PlanTreeModel::reset() {
  std::unordered_map<std::uint64_t, Entry> places;
  places[model::rootId.value] = {};
  const std::vector<model::Node>& nodes = m_draft.plan().scene.nodes();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto row = int(places[nodes[i].parent.value].children.size());
    places[nodes[i].id.value] = {nodes[i].parent, row, i};
    places[nodes[i].parent.value].children.push_back(nodes[i].id);
  }
  if (places == m_places) {
    showChosen();
    return;
  }
  beginResetModel();
  m_places = std::move(places);
  countChecks();
  endResetModel();
}

const model::Node* PlanTreeModel::nodeOf(model::NodeId id) const {
  const auto found = m_places.find(id.value);
  return id == model::rootId || found == m_places.end()
             ? nullptr
             : &m_draft.plan().scene.nodes()[found->second.node];
}

void PlanTreeModel::countChecks() {
  m_checks.clear();
  const std::vector<model::Node>& nodes = m_draft.plan().scene.nodes();
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const model::Node& node = nodes[i];
    if (!node.isGroup())
      m_checks[node.id.value] =
          m_draft.plan().choiceOf(node.id).include ? Qt::Checked : Qt::Unchecked;
    const auto own = m_checks.find(node.id.value);
    if (own == m_checks.end())
      continue;  // an empty group
    const auto [above, first] = m_checks.try_emplace(node.parent.value, own->second);
    if (!first && above->second != m_checks.at(node.id.value))
      above->second = Qt::PartiallyChecked;
  }
}

void PlanTreeModel::showChosen() {
  countChecks();
  // The rows may be anywhere, so all are announced together, which views handle quickly.
  for (const auto& [id, place] : m_places)
    if (!place.children.empty()) {
      const QModelIndex parent = indexOf({id});
      emit dataChanged(index(0, 0, parent),
                       index(int(place.children.size()) - 1, columns - 1, parent));
    }
}

model::NodeId PlanTreeModel::idOf(const QModelIndex& index) const {
  return index.isValid() ? model::NodeId{std::uint64_t(index.internalId())} : model::rootId;
}

QModelIndex PlanTreeModel::indexOf(model::NodeId id) const {
  const auto found = m_places.find(id.value);
  return id == model::rootId || found == m_places.end()
             ? QModelIndex()
             : createIndex(found->second.row, name, quintptr(id.value));
}

NodeIds PlanTreeModel::structuresOf(const NodeIds& ids) const {
  return m_draft.plan().scene.structuresBelow(ids);
}

void PlanTreeModel::include(const NodeIds& ids, bool wanted) {
  m_draft.choose(structuresOf(ids),
                 [wanted](model::StructureChoice& choice) { choice.include = wanted; });
}

Qt::CheckState PlanTreeModel::included(model::NodeId id) const {
  const auto found = m_checks.find(id.value);
  return found == m_checks.end() ? Qt::Checked : found->second;
}

QModelIndex PlanTreeModel::index(int row, int column, const QModelIndex& parent) const {
  const auto group = m_places.find(idOf(parent).value);
  if (group == m_places.end() || row < 0 || row >= int(group->second.children.size()) ||
      column < 0 || column >= columns || (parent.isValid() && parent.column() != name))
    return {};
  return createIndex(row, column, quintptr(group->second.children[std::size_t(row)].value));
}

QModelIndex PlanTreeModel::parent(const QModelIndex& index) const {
  const auto at = m_places.find(idOf(index).value);
  return at == m_places.end() || !index.isValid() ? QModelIndex() : indexOf(at->second.parent);
}

int PlanTreeModel::rowCount(const QModelIndex& parent) const {
  const auto group = m_places.find(idOf(parent).value);
  return group == m_places.end() || (parent.isValid() && parent.column() != name)
             ? 0
             : int(group->second.children.size());
}

int PlanTreeModel::columnCount(const QModelIndex&) const {
  return columns;
}

QString PlanTreeModel::text(const model::Node& node, int column) const {
  const model::ImportPlan& plan = m_draft.plan();
  const model::StructureChoice choice = plan.choiceOf(node.id);
  const StructureFigures& figures = m_draft.figures().nodes.at(node.id.value);
  switch (column) {
    case name:
      return nameOf(node, choice);
    case triangles:
      return QLocale().toString(qulonglong(figures.triangles));
    case size:
      return millimetresText(extent(figures.box));
    default:
      break;
  }
  if (node.isGroup())
    return {};
  if (column == file)
    return QString::fromStdString(node.provenance.file);
  if (!plan.parts.contains(node.id))
    return {};  // structures of a scene file stay as they are
  switch (column) {
    case frame:
      return QString::fromStdString(node.provenance.frame) +
             (node.provenance.evidence.isSure() ? QString() : QStringLiteral("?"));
    case unit:
      return m_draft.figures().molecules ? tr("Å") : unitText(node.provenance.mmPerUnit);
    case smoothing:
      return smoothingText(choice.smoothing.value_or(plan.options.smoothing));
    default:
      return decimationText(choice.decimateMm.value_or(plan.options.decimateMm));
  }
}

QVariant PlanTreeModel::sortKey(const model::Node& node, int column) const {
  const StructureFigures& figures = m_draft.figures().nodes.at(node.id.value);
  if (column == triangles)
    return qulonglong(figures.triangles);
  return column == size ? QVariant(extent(figures.box)) : QVariant(text(node, column));
}

QVariant PlanTreeModel::decoration(const model::Node& node) const {
  const model::StructureChoice choice = m_draft.plan().choiceOf(node.id);
  const std::optional<Colour> own = choice.colour ? choice.colour : node.style.colour;
  if (!own && node.isGroup())
    return {};  // its structures differ
  const Colour c = own ? *own : m_draft.plan().scene.resolve(node.id).colour;
  return QColor(c.red, c.green, c.blue);
}

QVariant PlanTreeModel::data(const QModelIndex& index, int role) const {
  const model::Node* node = nodeOf(idOf(index));
  if (!node)
    return {};
  const model::StructureChoice choice = m_draft.plan().choiceOf(node->id);
  const int column = index.column();
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return text(*node, column);
    case Qt::ToolTipRole:
      // Names come from files and may look like markup.
      return column == name || column == file
                 ? QStringLiteral("<p>%1</p>").arg(text(*node, column).toHtmlEscaped())
                 : QVariant();
    case sortRole:
      return sortKey(*node, column);
    case Qt::CheckStateRole:
      return column == name ? QVariant(included(node->id)) : QVariant();
    case Qt::DecorationRole:
      return column == name ? decoration(*node) : QVariant();
    case Qt::ForegroundRole:
      if (m_draft.figures().nodes.at(node->id.value).otherSide && column == frame)
        return QColor(0xc0, 0x39, 0x2b);
      return {};
    case Qt::FontRole: {
      const bool own = (column == name && choice.name) || (column == frame && choice.frame) ||
                       (column == unit && choice.unit) ||
                       (column == smoothing && choice.smoothing) ||
                       (column == decimation && choice.decimateMm);
      QFont font;
      font.setBold(own);
      return own ? QVariant(font) : QVariant();
    }
    case Qt::TextAlignmentRole:
      return column == triangles || column == size ? QVariant(Qt::AlignRight | Qt::AlignVCenter)
                                                   : QVariant();
    default:
      return {};
  }
}

bool PlanTreeModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const model::Node* node = nodeOf(idOf(index));
  if (!node || index.column() != name)
    return false;
  if (role == Qt::CheckStateRole) {
    include({node->id}, value.toInt() == Qt::Checked);
    return true;
  }
  const std::string text = value.toString().simplified().toStdString();
  if (role != Qt::EditRole || text.empty())
    return false;
  const bool own = text != node->name;
  m_draft.choose({node->id}, [&](model::StructureChoice& choice) {
    choice.name = own ? std::optional(text) : std::nullopt;
  });
  return true;
}

QVariant PlanTreeModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal)
    return {};
  if (role == Qt::TextAlignmentRole && (section == triangles || section == size))
    return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole)
    return {};
  const QString titles[columns] = {tr("Structure"), tr("Triangles"),      tr("Size, mm"),
                                   tr("File"),      tr("Frame"),          tr("Unit"),
                                   tr("Smoothing"), tr("Fewer triangles")};
  return titles[section];
}

Qt::ItemFlags PlanTreeModel::flags(const QModelIndex& index) const {
  if (!index.isValid())
    return Qt::NoItemFlags;
  const Qt::ItemFlags usual = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  return index.column() == name ? usual | Qt::ItemIsEditable | Qt::ItemIsUserCheckable : usual;
}

}  // namespace sline::widgets

#include "moc_plan_tree_model.cpp"
