// SPDX-License-Identifier: Apache-2.0
#include "widgets/structure_tree/structure_tree_model.h"

#include <algorithm>
#include <utility>

#include "model/edit/tree.h"
#include "widgets/session/names_by_language.h"
#include "widgets/structure_tree/node_mime.h"

namespace sline::widgets {

namespace {

/// The number of steps above which a reset is quicker for the views.
constexpr std::size_t mostSteps = 64;

/// The first and last of the columns in which the rows differ; {columns, -1} for none.
struct Columns {
  int first = StructureTreeModel::columns;
  int last = -1;
  void add(int column) {
    first = std::min(first, column);
    last = std::max(last, column);
  }
  bool operator==(const Columns&) const = default;
};

Columns columnsThatDiffer(const RowState& a, const RowState& b) {
  using Model = StructureTreeModel;
  Columns columns;
  if (a.shown != b.shown) {
    columns.add(Model::eye);
    columns.add(Model::name);
  }
  if (a.colours != b.colours || a.opacity != b.opacity || a.ownColour != b.ownColour ||
      a.ownOpacity != b.ownOpacity)
    columns.add(Model::swatch);
  if (a.structures != b.structures)
    columns.add(Model::name);
  if (!(a.gamma == b.gamma) || a.ownGamma != b.ownGamma)
    columns.add(Model::gamma);
  if (a.lock != b.lock) {
    columns.add(Model::gamma);
    columns.add(Model::lock);
  }
  return columns;
}

}  // namespace

StructureTreeModel::StructureTreeModel(Session& session, QObject* parent)
    : QAbstractItemModel(parent),
      m_session(session),
      m_shape(session.scene()),
      m_states(rowStatesOf(session.scene())) {
  connect(&session, &Session::documentChanged, this, &StructureTreeModel::change);
}

void StructureTreeModel::setNames(StructureNames names) {
  m_filter.setNames(std::move(names));
  emit rearranging();
  beginResetModel();
  m_shape = shapeOf(m_session.scene());
  endResetModel();
  emit rearranged(false);
}

void StructureTreeModel::setFilter(const QString& text) {
  if (m_filter.setText(text))
    rearrange(shapeOf(m_session.scene()), false);
}

TreeShape StructureTreeModel::shapeOf(const model::Scene& scene) {
  if (!m_filter.active()) {
    m_matches.clear();
    return TreeShape(scene);
  }
  RowFilter::Left left = m_filter.apply(scene);
  m_matches = std::move(left.structures);
  return TreeShape(scene, &left.rows);
}

const RowState& StructureTreeModel::state(model::NodeId id) const {
  static const RowState unknown;
  const auto found = m_states.find(id.value);
  return found == m_states.end() ? unknown : found->second;
}

void StructureTreeModel::change(const Document& before, const Document& now) {
  const auto alike = [](const model::Node& a, const model::Node& b) {
    return a.id == b.id && a.parent == b.parent && a.name == b.name && a.isGroup() == b.isGroup();
  };
  const auto& was = before.scene.nodes();
  const auto& is = now.scene.nodes();
  const RowStates old = std::exchange(m_states, rowStatesOf(now.scene));
  const bool opened = before.opening != now.opening;
  if (opened || !std::equal(was.begin(), was.end(), is.begin(), is.end(), alike))
    rearrange(shapeOf(now.scene), opened);
  if (!opened)
    changeRows(before.scene, now.scene, old);
}

void StructureTreeModel::changeRows(const model::Scene& before, const model::Scene& now,
                                    const RowStates& old) {
  std::unordered_map<std::uint64_t, const std::string*> names;
  for (const model::Node& node : before.nodes())
    names.emplace(node.id.value, &node.name);
  // Neighbours that differ in the same columns are announced together.
  QModelIndex first;
  QModelIndex last;
  Columns told;
  const auto tell = [&] {
    if (first.isValid())
      emit dataChanged(first.siblingAtColumn(told.first), last.siblingAtColumn(told.last));
    first = QModelIndex();
  };
  std::vector<std::pair<model::NodeId, Columns>> differing;
  for (const model::Node& node : now.nodes()) {
    const auto was = old.find(node.id.value);
    if (was == old.end() || !m_shape.find(node.id))
      continue;
    Columns differs = columnsThatDiffer(was->second, state(node.id));
    if (*names.at(node.id.value) != node.name)
      differs.add(name);
    if (differs.last >= 0)
      differing.emplace_back(node.id, differs);
  }
  std::stable_sort(differing.begin(), differing.end(), [this](const auto& a, const auto& b) {
    return m_shape.find(a.first)->parent < m_shape.find(b.first)->parent;
  });
  for (const auto& [id, differs] : differing) {
    const QModelIndex at = indexOf(id);
    const bool next = first.isValid() && at.row() == last.row() + 1 &&
                      m_shape.find(id)->parent == m_shape.find(idOf(last))->parent;
    if (!next || !(differs == told)) {
      tell();
      first = at;
      told = differs;
    }
    last = at;
  }
  tell();
}

bool StructureTreeModel::take(const RowStep& step) {
  const QModelIndex parent = indexOf(step.parent).siblingAtColumn(0);
  const int last = step.first + int(step.ids.size()) - 1;
  switch (step.kind) {
    case RowStep::Kind::insert:
      beginInsertRows(parent, step.first, last);
      m_shape.apply(step);
      endInsertRows();
      return true;
    case RowStep::Kind::remove:
      beginRemoveRows(parent, step.first, last);
      m_shape.apply(step);
      endRemoveRows();
      return true;
    case RowStep::Kind::move: {
      // Qt counts rows as they are before the move.
      const bool down = step.parent == step.target && step.row > step.first;
      const int row = down ? step.row + int(step.ids.size()) : step.row;
      if (!beginMoveRows(parent, step.first, last, indexOf(step.target).siblingAtColumn(0), row))
        return false;
      m_shape.apply(step);
      endMoveRows();
      return true;
    }
  }
  return false;
}

void StructureTreeModel::rearrange(TreeShape shape, bool opened) {
  if (!opened && shape.sameAs(m_shape))
    return;
  emit rearranging();
  const auto steps = opened ? std::nullopt : stepsBetween(m_shape, shape, mostSteps);
  if (!steps || !std::all_of(steps->begin(), steps->end(),
                             [this](const RowStep& step) { return take(step); })) {
    beginResetModel();
    m_shape = std::move(shape);
    endResetModel();
  }
  emit rearranged(opened);
}

model::NodeId StructureTreeModel::idOf(const QModelIndex& index) const {
  return index.isValid() ? model::NodeId{std::uint64_t(index.internalId())} : model::rootId;
}

QModelIndex StructureTreeModel::indexOf(model::NodeId id) const {
  const TreeShape::Entry* at = id == model::rootId ? nullptr : m_shape.find(id);
  return at ? createIndex(at->row, name, quintptr(id.value)) : QModelIndex();
}

QModelIndex StructureTreeModel::index(int row, int column, const QModelIndex& parent) const {
  const TreeShape::Entry* group = m_shape.find(idOf(parent));
  if (!group || row < 0 || row >= int(group->children.size()) || column < 0 || column >= columns ||
      (parent.isValid() && parent.column() != 0 && parent.column() != name))
    return {};
  return createIndex(row, column, quintptr(group->children[std::size_t(row)].value));
}

QModelIndex StructureTreeModel::parent(const QModelIndex& index) const {
  const TreeShape::Entry* at = index.isValid() ? m_shape.find(idOf(index)) : nullptr;
  if (!at || at->parent == model::rootId)
    return {};
  // Qt's views ask for children of the first column only.
  return createIndex(m_shape.find(at->parent)->row, 0, quintptr(at->parent.value));
}

int StructureTreeModel::rowCount(const QModelIndex& parent) const {
  if (parent.isValid() && parent.column() != 0)
    return 0;
  const TreeShape::Entry* group = m_shape.find(idOf(parent));
  return group ? int(group->children.size()) : 0;
}

int StructureTreeModel::columnCount(const QModelIndex&) const {
  return columns;
}

bool StructureTreeModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || index.column() != name)
    return false;
  const std::string text = value.toString().trimmed().toStdString();
  const auto namesOf = [this](const std::string& of) {
    return namesByLanguage(m_session.names(), of);
  };
  return m_session.apply(tr("Rename"),
                         model::renamed(m_session.scene(), idOf(index), text, namesOf));
}

Qt::ItemFlags StructureTreeModel::flags(const QModelIndex& index) const {
  if (!index.isValid())
    return Qt::ItemIsDropEnabled;  // the top level
  Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDropEnabled;
  if (state(idOf(index)).lock != RowLock::open)
    return flags;
  flags |= Qt::ItemIsDragEnabled;
  return index.column() == name ? flags | Qt::ItemIsEditable : flags;
}

QStringList StructureTreeModel::mimeTypes() const {
  return {QLatin1String(nodeMimeType)};
}

QMimeData* StructureTreeModel::mimeData(const QModelIndexList& indexes) const {
  NodeIds ids;
  for (const QModelIndex& index : indexes)
    if (index.column() == name)
      ids.push_back(idOf(index));
  return nodesAsMime(m_session, ids);
}

}  // namespace sline::widgets

#include "moc_structure_tree_model.cpp"
