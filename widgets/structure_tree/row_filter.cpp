// SPDX-License-Identifier: Apache-2.0
#include "widgets/structure_tree/row_filter.h"

#include <algorithm>
#include <unordered_map>

namespace sline::widgets {

QString searchable(const QString& text) {
  QString plain;
  plain.reserve(text.size());
  for (const QChar c : text.toCaseFolded().normalized(QString::NormalizationForm_KD)) {
    if (c.category() == QChar::Mark_NonSpacing)
      continue;
    switch (c.unicode()) {
      case u'_':
      case u'-':
        plain += u' ';
        break;
      case u'ø':
        plain += u'o';
        break;
      case u'æ':
        plain += QLatin1String("ae");
        break;
      case u'œ':
        plain += QLatin1String("oe");
        break;
      default:
        plain += c;
    }
  }
  return plain;
}

void RowFilter::setNames(StructureNames names) {
  m_names = std::move(names);
  m_texts.clear();
}

bool RowFilter::setText(const QString& text) {
  QStringList words = searchable(text).split(u' ', Qt::SkipEmptyParts);
  if (words == m_words)
    return false;
  m_words = std::move(words);
  return true;
}

const QString& RowFilter::textOf(const std::string& name) {
  const QString key = QString::fromStdString(name);
  const auto known = m_texts.constFind(key);
  if (known != m_texts.cend())
    return *known;
  QStringList called{key};
  if (m_names.shown)
    called << m_names.shown(key);
  if (m_names.alsoCalled)
    called << m_names.alsoCalled(key);
  return *m_texts.insert(key, searchable(called.join(u'\n')));
}

RowFilter::Left RowFilter::apply(const model::Scene& scene) {
  // Words that are found in a group hold for all below it.
  std::unordered_map<std::uint64_t, std::vector<bool>> found;
  const auto count = std::size_t(m_words.size());
  found[model::rootId.value] = std::vector<bool>(count);
  Left left;
  for (const model::Node& node : scene.nodes()) {
    std::vector<bool> words = found.at(node.parent.value);
    const QString& text = textOf(node.name);
    for (std::size_t i = 0; i < count; ++i)
      words[i] = words[i] || text.contains(m_words[qsizetype(i)]);
    if (std::all_of(words.begin(), words.end(), [](bool there) { return there; })) {
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
