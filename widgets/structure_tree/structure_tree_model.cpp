// SPDX-License-Identifier: Apache-2.0
#include "widgets/structure_tree/structure_tree_model.h"

#include <QColor>
#include <algorithm>
#include <utility>

#include "model/edit/tree.h"
#include "widgets/gamma/stages.h"

namespace sline::widgets {

namespace {

QString textOf(const model::GammaRange& range) {
  return range.low == range.high
             ? gammaText(range.low)
             : StructureTreeModel::tr("%1 to %2").arg(gammaText(range.low), gammaText(range.high));
}

bool sameShape(const model::Scene& a, const model::Scene& b) {
  return std::equal(a.nodes().begin(), a.nodes().end(), b.nodes().begin(), b.nodes().end(),
                    [](const model::Node& x, const model::Node& y) {
                      return x.id == y.id && x.parent == y.parent && x.mesh == y.mesh;
                    });
}

}  // namespace

StructureTreeModel::StructureTreeModel(Session& session, QObject* parent)
    : QAbstractItemModel(parent),
      m_session(session),
      m_shape(shapeOf(session.scene())),
      m_states(rowStatesOf(session.scene())) {
  connect(&session, &Session::documentChanged, this,
          [this](const Document& before, const Document& now) { change(before.scene, now.scene); });
}

StructureTreeModel::Shape StructureTreeModel::shapeOf(const model::Scene& scene) {
  Shape shape;
  shape[model::rootId.value] = {};
  for (const model::Node& node : scene.nodes()) {
    std::vector<model::NodeId>& siblings = shape[node.parent.value].children;
    shape[node.id.value] = {node.parent, int(siblings.size()), {}};
    shape[node.parent.value].children.push_back(node.id);
  }
  return shape;
}

const StructureTreeModel::Place* StructureTreeModel::place(model::NodeId id) const {
  const auto found = m_shape.find(id.value);
  return found == m_shape.end() ? nullptr : &found->second;
}

const RowState& StructureTreeModel::state(model::NodeId id) const {
  static const RowState unknown;
  const auto found = m_states.find(id.value);
  return found == m_states.end() ? unknown : found->second;
}

void StructureTreeModel::change(const model::Scene& before, const model::Scene& now) {
  if (!sameShape(before, now)) {
    beginResetModel();
    m_shape = shapeOf(now);
    m_states = rowStatesOf(now);
    endResetModel();
    return;
  }
  const RowStates old = std::exchange(m_states, rowStatesOf(now));
  for (std::size_t i = 0; i < now.nodes().size(); ++i) {
    const model::Node& node = now.nodes()[i];
    if (node.name == before.nodes()[i].name && old.at(node.id.value) == state(node.id))
      continue;
    const QModelIndex at = indexOf(node.id);
    emit dataChanged(at.siblingAtColumn(eye), at.siblingAtColumn(gamma));
  }
}

model::NodeId StructureTreeModel::idOf(const QModelIndex& index) const {
  return index.isValid() ? model::NodeId{std::uint64_t(index.internalId())} : model::rootId;
}

QModelIndex StructureTreeModel::indexOf(model::NodeId id) const {
  const Place* at = id == model::rootId ? nullptr : place(id);
  return at ? createIndex(at->row, name, quintptr(id.value)) : QModelIndex();
}

QModelIndex StructureTreeModel::index(int row, int column, const QModelIndex& parent) const {
  const Place* group = place(idOf(parent));
  if (!group || row < 0 || row >= int(group->children.size()) || column < 0 || column >= columns ||
      (parent.isValid() && parent.column() != 0 && parent.column() != name))
    return {};
  return createIndex(row, column, quintptr(group->children[std::size_t(row)].value));
}

QModelIndex StructureTreeModel::parent(const QModelIndex& index) const {
  const Place* at = index.isValid() ? place(idOf(index)) : nullptr;
  if (!at || at->parent == model::rootId)
    return {};
  // Qt's views ask for children of the first column only.
  return createIndex(place(at->parent)->row, 0, quintptr(at->parent.value));
}

int StructureTreeModel::rowCount(const QModelIndex& parent) const {
  if (parent.isValid() && parent.column() != 0)
    return 0;
  const Place* group = place(idOf(parent));
  return group ? int(group->children.size()) : 0;
}

int StructureTreeModel::columnCount(const QModelIndex&) const {
  return columns;
}

QVariant StructureTreeModel::data(const QModelIndex& index, int role) const {
  const model::Scene& scene = m_session.scene();
  const model::NodeId id = idOf(index);
  const model::Node* node = scene.find(id);
  if (!node)
    return {};
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return index.column() == name ? QString::fromStdString(node->name) : QVariant();
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
      return describe(index);
    case shownRole:
      return int(state(id).shown);
    case coloursRole: {
      QVariantList colours;
      for (const Colour& c : state(id).colours)
        colours << QColor(c.red, c.green, c.blue);
      return colours;
    }
    case lowGammaRole:
      return state(id).gamma.low.value();
    case highGammaRole:
      return state(id).gamma.high.value();
    case ownGammaRole:
      return state(id).ownGamma;
    default:
      return {};
  }
}

QVariant StructureTreeModel::describe(const QModelIndex& index) const {
  const model::Scene& scene = m_session.scene();
  const model::Node& node = *scene.find(idOf(index));
  switch (index.column()) {
    case eye:
      switch (state(node.id).shown) {
        case model::Shown::none:
          return tr("Hidden");
        case model::Shown::some:
          return tr("Partly shown");
        case model::Shown::all:
          return tr("Shown");
      }
      return {};
    case swatch:
      return tr("Colour");
    case gamma: {
      const QString text = tr("Γ %1").arg(textOf(state(node.id).gamma));
      if (node.style.gamma)
        return text;
      return node.isGroup() ? text : tr("%1, from the group above").arg(text);
    }
    default:
      return node.isGroup() ? tr("%1, structures: %2")
                                  .arg(QString::fromStdString(node.name))
                                  .arg(state(node.id).structures)
                            : QString::fromStdString(node.name);
  }
}

bool StructureTreeModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || index.column() != name)
    return false;
  const std::string text = value.toString().trimmed().toStdString();
  return m_session.apply(tr("Rename"), model::renamed(m_session.scene(), idOf(index), text));
}

QVariant StructureTreeModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
    return {};
  if (section == name)
    return tr("Structure");
  return section == gamma ? tr("Γ") : QVariant();
}

Qt::ItemFlags StructureTreeModel::flags(const QModelIndex& index) const {
  if (!index.isValid())
    return Qt::NoItemFlags;
  const Qt::ItemFlags usual = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  return index.column() == name ? usual | Qt::ItemIsEditable : usual;
}

}  // namespace sline::widgets
