// SPDX-License-Identifier: Apache-2.0
#include "render/lettering/hyphenation.h"

#include <hyphen.h>

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QStandardPaths>
#include <cstdlib>
#include <map>
#include <mutex>

namespace sline::render {

/// A dictionary of libhyphen, which is only read once it is loaded.
class SyllablePatterns {
 public:
  explicit SyllablePatterns(HyphenDict* dictionary) : m_dictionary(dictionary) {}
  SyllablePatterns(const SyllablePatterns&) = delete;
  SyllablePatterns& operator=(const SyllablePatterns&) = delete;
  ~SyllablePatterns() { hnj_hyphen_free(m_dictionary); }
  HyphenDict* dictionary() const { return m_dictionary; }
  bool isUtf8() const { return m_dictionary->utf8 != 0; }
  bool isLatin1() const { return qstrcmp(m_dictionary->cset, "ISO8859-1") == 0; }

 private:
  HyphenDict* m_dictionary;
};

namespace {
constexpr qsizetype longestWord = 60;
constexpr qsizetype leastBefore = 2;
constexpr qsizetype leastBehind = 3;

using Patterns = std::shared_ptr<const SyllablePatterns>;

/// Returns the files that may hold the language's patterns, the best first: "de-AT" is looked up as
/// de_AT, then as de, as de_DE and as any other region's.
QStringList fileNames(const QString& language) {
  static const QRegularExpression tag(QStringLiteral("^[A-Za-z]{2,3}(-[A-Za-z]{2,4})*$"));
  if (!tag.match(language).hasMatch())
    return {};
  const QStringList parts = language.split(QLatin1Char('-'));
  const QString base = parts.front().toLower();
  QStringList names{base, base + QLatin1Char('_') + base.toUpper()};
  if (parts.size() > 1)
    names.push_front(base + QLatin1Char('_') + parts.back().toUpper());
  if (base == QLatin1String("en"))
    names << QStringLiteral("en_US");
  if (base == QLatin1String("no"))
    names << QStringLiteral("nb_NO");
  names << base + QStringLiteral("_*");
  for (QString& name : names)
    name = QStringLiteral("hyph_%1.dic").arg(name);
  return names;
}

QString fileOf(const QString& language) {
  const QStringList folders =
      QStandardPaths::locateAll(QStandardPaths::GenericDataLocation, QStringLiteral("hyphen"),
                                QStandardPaths::LocateDirectory);
  for (const QString& name : fileNames(language))
    for (const QString& folder : folders) {
      const QStringList found = QDir(folder).entryList({name}, QDir::Files, QDir::Name);
      if (!found.isEmpty())
        return QDir(folder).filePath(found.front());
    }
  return {};
}

Patterns loaded(const QString& file) {
  HyphenDict* dictionary =
      file.isEmpty() ? nullptr : hnj_hyphen_load(QFile::encodeName(file).constData());
  if (!dictionary)
    return nullptr;
  auto patterns = std::make_shared<const SyllablePatterns>(dictionary);
  return patterns->isUtf8() || patterns->isLatin1() ? patterns : nullptr;
}

/// Returns patterns that the whole process shares: reading a dictionary takes some 10 ms.
Patterns patternsOf(const std::string& language) {
  static std::mutex mutex;
  static std::map<std::string, Patterns> known;
  const std::lock_guard lock(mutex);
  const auto found = known.find(language);
  if (found != known.end())
    return found->second;
  return known[language] = loaded(fileOf(QString::fromStdString(language)));
}

/// Adds the ends within a word that begins at `start`.
void addEnds(const SyllablePatterns& patterns, const QString& word, qsizetype start,
             std::vector<qsizetype>& ends) {
  const QString lower = word.toLower();
  if (word.size() > longestWord || lower.size() != word.size())
    return;
  const QByteArray bytes = patterns.isUtf8() ? lower.toUtf8() : lower.toLatin1();
  if (!patterns.isUtf8() && QString::fromLatin1(bytes) != lower)
    return;
  QByteArray places(bytes.size() + 5, '\0');
  char** replaced = nullptr;
  int* at = nullptr;
  int* cut = nullptr;
  const int fault =
      hnj_hyphen_hyphenate2(patterns.dictionary(), bytes.constData(), int(bytes.size()),
                            places.data(), nullptr, &replaced, &at, &cut);
  for (qsizetype i = 0; !fault && i < word.size(); ++i) {
    // A break that changes the spelling ("Zuk-ker") is left to the author.
    const bool spelt = replaced && replaced[i];
    if ((places[i] & 1) != 0 && !spelt && i + 1 >= leastBefore &&
        word.size() - i - 1 >= leastBehind)
      ends.push_back(start + i + 1);
  }
  for (qsizetype i = 0; replaced && i < word.size(); ++i)
    std::free(replaced[i]);
  std::free(replaced);
  std::free(at);
  std::free(cut);
}
}  // namespace

Hyphenation::Hyphenation(const std::string& language)
    : m_patterns(language.empty() ? nullptr : patternsOf(language)) {}

std::vector<qsizetype> Hyphenation::syllableEnds(const QString& text) const {
  std::vector<qsizetype> ends;
  if (!m_patterns)
    return ends;
  qsizetype start = 0;
  for (qsizetype i = 0; i <= text.size(); ++i) {
    if (i < text.size() && text[i].isLetter())
      continue;
    if (i - start >= leastBefore + leastBehind)
      addEnds(*m_patterns, text.mid(start, i - start), start, ends);
    start = i + 1;
  }
  return ends;
}

}  // namespace sline::render
