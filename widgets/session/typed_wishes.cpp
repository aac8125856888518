// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/typed_wishes.h"

#include "model/anatomy/laterality_words.h"
#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {

/// Tells whether the word is a side; a letter alone begins any word.
bool isSide(const QString& word) {
  return word.size() > 1 && model::sideOfWord(word.toLower().toStdString()) != model::Side::none;
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

void SearchedNames::addWords(const QString& name) {
  for (const std::string& word : model::wordsOf(name.toStdString()))
    words << searchable(QString::fromStdString(word));
}

bool TypedWishes::setText(const QString& text) {
  QString parted = text;
  for (const char16_t sign : {u'|', u','})
    parted.replace(QChar(sign), QStringLiteral(" | "));
  for (const char16_t blank : {u'_', u'-'})
    parted.replace(QChar(blank), u' ');
  const QStringList partings{QStringLiteral("|"), QStringLiteral("or"), searchable(orWord())};
  std::vector<WishedWord> words;
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

bool TypedWishes::satisfied(const std::vector<bool>& found) const {
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

}  // namespace sline::widgets
