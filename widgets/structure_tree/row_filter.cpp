// SPDX-License-Identifier: Apache-2.0
#include "widgets/structure_tree/row_filter.h"

#include <algorithm>
#include <unordered_map>

#include "model/anatomy/laterality_words.h"
#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {

/// Tells whether the word is a side; a letter alone begins any word.
bool isSide(const QString& word) {
  return word.size() > 1 && model::sideOfWord(word.toLower().toStdString()) != model::Side::none;
}

/// Returns the words of a name as they are compared, also where capitals alone part them.
QStringList comparedWords(const QString& name) {
  QStringList words;
  for (const std::string& word : model::wordsOf(name.toStdString()))
    words << searchable(QString::fromStdString(word));
  return words;
}

}  // namespace

QString orWord() {
  return tr("or", "between two wishes of the filter");
}

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
  m_known.clear();
}

bool RowFilter::setText(const QString& text) {
  QString parted = text;
  for (const char16_t sign : {u'|', u','})
    parted.replace(QChar(sign), QStringLiteral(" | "));
  for (const char16_t blank : {u'_', u'-'})
    parted.replace(QChar(blank), u' ');
  const QStringList partings{QStringLiteral("|"), QStringLiteral("or"), searchable(orWord())};
  std::vector<Word> words;
  std::size_t wish = 0;
  for (const QString& typed : parted.split(u' ', Qt::SkipEmptyParts)) {
    const QString word = searchable(typed);
    const bool begun = !words.empty() && words.back().wish == wish;
    // "or" may be the beginning of a word where nothing is wished for yet.
    if (begun ? partings.contains(word) : word == partings.front())
      wish += begun ? 1 : 0;
    else
      words.push_back({word, isSide(typed), wish});
  }
  if (words == m_words)
    return false;
  m_words = std::move(words);
  return true;
}

const RowFilter::Names& RowFilter::namesOf(const std::string& name) {
  const QString key = QString::fromStdString(name);
  const auto known = m_known.constFind(key);
  if (known != m_known.cend())
    return *known;
  Names names;
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
    for (const QString& word : comparedWords(shown))
      names.words << word;
  return *m_known.insert(key, std::move(names));
}

bool RowFilter::satisfied(const std::vector<bool>& found) const {
  if (m_words.empty())
    return true;
  for (std::size_t i = 0; i < m_words.size();) {
    const std::size_t wish = m_words[i].wish;
    bool all = true;
    for (; i < m_words.size() && m_words[i].wish == wish; ++i)
      all = all && found[i];
    if (all)
      return true;
  }
  return false;
}

RowFilter::Left RowFilter::apply(const model::Scene& scene) {
  // Words that are found in a group hold for all below it.
  std::unordered_map<std::uint64_t, std::vector<bool>> found;
  const std::size_t count = m_words.size();
  found[model::rootId.value] = std::vector<bool>(count);
  Left left;
  for (const model::Node& node : scene.nodes()) {
    std::vector<bool> words = found.at(node.parent.value);
    const Names& names = namesOf(node.name);
    for (std::size_t i = 0; i < count; ++i)
      words[i] = words[i] || names.have(m_words[i]);
    if (satisfied(words)) {
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
