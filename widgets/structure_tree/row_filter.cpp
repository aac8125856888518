// SPDX-License-Identifier: Apache-2.0
#include "widgets/structure_tree/row_filter.h"

#include <unordered_map>

#include "model/anatomy/laterality_words.h"

namespace sline::widgets {

void RowFilter::setNames(StructureNames names) {
  m_names = std::move(names);
  m_known.clear();
}

const SearchedNames& RowFilter::namesOf(const std::string& name) {
  const QString key = QString::fromStdString(name);
  const auto known = m_known.constFind(key);
  if (known != m_known.cend())
    return *known;
  SearchedNames names;
  QStringList called{key};
  if (m_names.shown)
    called << m_names.shown(key);
  for (const QString& other : m_names.alsoCalled ? m_names.alsoCalled(key) : QStringList()) {
    QStringList words = other.split(u' ');
    words.removeIf([&names](const QString& word) {
      const bool side = model::sideOfWord(word.toLower().toStdString()) != model::Side::none;
      if (side)
        names.sides << searchable(word);
      return side;
    });
    called << words.join(u' ');
  }
  names.text = searchable(called.join(u'\n'));
  for (const QString& shown : {key, m_names.shown ? m_names.shown(key) : QString()})
    names.addWords(shown);
  return *m_known.insert(key, std::move(names));
}

RowFilter::Left RowFilter::apply(const model::Scene& scene) {
  // Words that are found in a group hold for all below it.
  std::unordered_map<std::uint64_t, std::vector<bool>> found;
  const std::size_t count = m_wishes.words().size();
  found[model::rootId.value] = std::vector<bool>(count);
  Left left;
  for (const model::Node& node : scene.nodes()) {
    std::vector<bool> words = found.at(node.parent.value);
    const SearchedNames& names = namesOf(node.name);
    for (std::size_t i = 0; i < count; ++i)
      words[i] = words[i] || names.have(m_wishes.words()[i]);
    if (m_wishes.satisfied(words)) {
      left.rows.insert(node.id.value);
      if (!node.isGroup())
        left.structures.push_back(node.id);
    }
    if (node.isGroup())
      found.emplace(node.id.value, std::move(words));
  }
  left.rows = model::withAllAbove(scene, std::move(left.rows));
  return left;
}

}  // namespace sline::widgets
