// SPDX-License-Identifier: Apache-2.0
#include "widgets/sections/section_list.h"

#include <algorithm>

#include "widgets/sections/new_section.h"
#include "widgets/sections/section_position.h"

namespace sline::widgets {

SectionList::SectionList(Session& session, QObject* parent)
    : QAbstractTableModel(parent), m_session(session) {
  connect(&session, &Session::documentChanged, this, &SectionList::documentChange);
  connect(&session.names(), &DisplayNames::changed, this, [this] {
    if (rowCount() > 0)
      emit dataChanged(index(0, scope), index(rowCount() - 1, scope));
  });
}

void SectionList::documentChange(const Document& before, const Document& now) {
  const auto& old = before.scene.sections();
  const auto& sections = now.scene.sections();
  const bool sameRows = std::equal(old.begin(), old.end(), sections.begin(), sections.end(),
                                   [](const auto& a, const auto& b) { return a.id == b.id; });
  if (!sameRows) {
    beginResetModel();
    endResetModel();
    return;
  }
  // The column of what a section cuts shows a node's name, which may have changed.
  for (int row = 0; row < int(sections.size()); ++row)
    if (old[std::size_t(row)] != sections[std::size_t(row)] ||
        before.scene.nodes() != now.scene.nodes())
      emit dataChanged(index(row, 0), index(row, columnCount_ - 1));
}

const model::Section* SectionList::at(int row) const {
  const auto& sections = m_session.scene().sections();
  return row >= 0 && row < int(sections.size()) ? &sections[std::size_t(row)] : nullptr;
}

int SectionList::rowOf(std::optional<model::SectionId> id) const {
  const auto& sections = m_session.scene().sections();
  const auto found = std::find_if(sections.begin(), sections.end(),
                                  [id](const auto& section) { return section.id == id; });
  return found == sections.end() ? -1 : int(found - sections.begin());
}

int SectionList::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(m_session.scene().sections().size());
}

int SectionList::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(columnCount_);
}

QVariant SectionList::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
    return {};
  switch (section) {
    case name:
      return tr("Section");
    case position:
      return tr("Position");
    default:
      return tr("Cuts");
  }
}

QVariant SectionList::data(const QModelIndex& index, int role) const {
  const model::Section* section = at(index.row());
  if (!section)
    return {};
  if (role == Qt::CheckStateRole && index.column() == name)
    return section->enabled ? Qt::Checked : Qt::Unchecked;
  if (role == Qt::TextAlignmentRole && index.column() == position)
    return int(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole && role != Qt::EditRole && role != Qt::ToolTipRole)
    return {};
  const QString text = index.column() == name ? QString::fromStdString(section->name)
                       : index.column() == position
                           ? positionText(section->plane, m_session.scene())
                           : scopeText(m_session, section->scope);
  // What the column has no room for is read as a tip; names may look like markup.
  return role == Qt::ToolTipRole ? QStringLiteral("<p>%1</p>").arg(text.toHtmlEscaped()) : text;
}

Qt::ItemFlags SectionList::flags(const QModelIndex& index) const {
  const Qt::ItemFlags plain = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  return index.column() == name ? plain | Qt::ItemIsEditable | Qt::ItemIsUserCheckable : plain;
}

bool SectionList::setData(const QModelIndex& index, const QVariant& value, int role) {
  const model::Section* there = at(index.row());
  if (!there || index.column() != name)
    return false;
  model::Section section = *there;
  QString step = tr("Rename Section");
  if (role == Qt::CheckStateRole) {
    section.enabled = value.toInt() == Qt::Checked;
    step = section.enabled ? tr("Section On") : tr("Section Off");
  } else if (const QString text = value.toString().trimmed(); !text.isEmpty()) {
    section.name = text.toStdString();
  }
  return m_session.apply(step, model::withSectionChanged(m_session.scene(), section.id, section));
}

}  // namespace sline::widgets

#include "moc_section_list.cpp"
