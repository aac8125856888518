// SPDX-License-Identifier: Apache-2.0
#include "render/export/students/accepted_answers.h"

#include <QString>
#include <QStringList>
#include <algorithm>
#include <array>
#include <cstring>
#include <set>

#include "model/anatomy/anatomical_names.h"
#include "model/anatomy/laterality_words.h"
#include "model/anatomy/name_words.h"
#include "render/export/students/answer_hash.h"
#include "render/export/students/short_answers.h"

namespace sline::render {

namespace {

/// A word that says of which kind a structure is.
struct KindWord {
  const char* brief;      ///< as anatomists abbreviate it
  const char* latin;      ///< in full
  const char* spellings;  ///< in all languages, in lower case, with blanks between them
};

constexpr std::array kindWords{
    KindWord{"A.", "Arteria", "artery arteria arterie slagader"},
    KindWord{"Aa.", "Arteriae", "arteries arteriae arterien arterier slagaders"},
    KindWord{"V.", "Vena", "vein vena vene ader"},
    KindWord{"Vv.", "Venae", "veins venae venen vener aders"},
    KindWord{"M.", "Musculus", "muscle musculus muskel spier"},
    KindWord{"Mm.", "Musculi", "muscles musculi muskeln muskler spieren"},
    KindWord{"N.", "Nervus", "nerve nervus nerv zenuw"},
    KindWord{"Nn.", "Nervi", "nerves nervi nerven nerver zenuwen"},
    KindWord{"Lig.", "Ligamentum", "ligament ligamentum"},
    KindWord{"Ligg.", "Ligamenta", "ligaments ligamenta ligamenten ligamenter"}};

const KindWord* kindOf(const QString& word) {
  const QString lower = word.toLower();
  for (const KindWord& kind : kindWords)
    if (QString::fromUtf8(kind.spellings).split(u' ').contains(lower))
      return &kind;
  return nullptr;
}

const KindWord* abbreviated(const QString& word) {
  for (const KindWord& kind : kindWords)
    if (word.compare(QLatin1String(kind.brief), Qt::CaseInsensitive) == 0)
      return &kind;
  return nullptr;
}

const model::AnatomicalNames& anatomicalNames() {
  static const model::AnatomicalNames names;
  return names;
}

QStringList wordsOf(const std::string& name) {
  return QString::fromStdString(name).simplified().split(u' ', Qt::SkipEmptyParts);
}

/// Returns the name in full where it abbreviates its kind, else nothing.
std::string inFull(const std::string& name) {
  QStringList words = wordsOf(name);
  bool any = false;
  for (QString& word : words)
    if (const KindWord* kind = words.size() > 1 ? abbreviated(word) : nullptr) {
      word = QLatin1String(kind->latin);
      any = true;
    }
  return any ? words.join(u' ').toStdString() : std::string();
}

/// Gathers names, each once as answers are compared.
class Names {
 public:
  void add(const std::string& name) {
    if (const std::string normal = normalisedAnswer(name);
        !normal.empty() && m_known.insert(normal).second)
      m_names.push_back(name);
  }
  bool has(const std::string& name) const { return m_known.contains(normalisedAnswer(name)); }
  const std::vector<std::string>& all() const { return m_names; }
  std::vector<std::string> take() { return std::move(m_names); }

 private:
  std::set<std::string> m_known;
  std::vector<std::string> m_names;
};

/// Tells whether that is another structure's name than the whole, or none at all: "left", "heart"
/// of the muscle.
bool namesAnother(const QStringList& rest, const std::string& whole) {
  const auto english = [](const std::string& name) {
    return normalisedAnswer(anatomicalNames().displayName(name, model::NameLanguage::english));
  };
  const std::string name = rest.join(u' ').toStdString();
  const bool side = std::all_of(rest.begin(), rest.end(), [](const QString& word) {
    return model::sideOfWord(word.toLower().toStdString()) != model::Side::none;
  });
  return side || (anatomicalNames().knows(name) && english(name) != english(whole));
}

/// Returns the side that the name says.
model::Side sideOf(const std::string& name) {
  for (const QString& word : wordsOf(name))
    if (const model::Side side = model::sideOfWord(word.toLower().toStdString());
        side != model::Side::none)
      return side;
  return model::Side::none;
}

/// Returns the name with the side, where each language puts it and in all its forms, as nothing
/// says of which language a synonym is.
std::vector<std::string> withSideOf(const std::string& name, model::Side side) {
  std::vector<std::string> all;
  for (std::size_t language = 0; language < model::nameLanguages; ++language)
    for (const model::Gender gender :
         {model::Gender::masculine, model::Gender::feminine, model::Gender::neuter})
      all.push_back(model::withSide(name, side, model::NameLanguage(language), {gender, false}));
  return all;
}

/// Tells whether there are two of it, so that its side belongs to every answer: without the side it
/// has a name of its own. Of the "left gastric artery" there is one.
bool isOneOfTwo(const std::string& name) {
  QStringList words = wordsOf(anatomicalNames().displayName(name, model::NameLanguage::english));
  const auto sides = words.removeIf([](const QString& word) {
    return model::sideOfWord(word.toLower().toStdString()) != model::Side::none;
  });
  return sides > 0 && anatomicalNames().knows(words.join(u' ').toStdString());
}

/// Adds the kind to those of the names that do not say it: "psoas major muscle", "M. psoas major".
void addKind(Names& names, const std::vector<std::string>& whole, const KindWord& kind) {
  const std::string spelled(kind.spellings, std::strcspn(kind.spellings, " "));
  for (const std::string& name : whole) {
    const QStringList parts = wordsOf(name);
    if (std::none_of(parts.begin(), parts.end(),
                     [](const QString& word) { return kindOf(word) || abbreviated(word); })) {
      std::string full = name;
      full += ' ';
      full += spelled;
      names.add(full);
      names.add(std::string(kind.brief) + ' ' + name);
    }
  }
}

}  // namespace

AcceptedAnswers acceptedAnswers(const WordsByLanguage& words) {
  Names names;
  const auto addAll = [&names](const std::string& text) {
    names.add(std::string(model::withoutCounter(text)));
    if (!anatomicalNames().knows(text))
      return;
    const bool sided = isOneOfTwo(text);
    for (const std::string& other : anatomicalNames().searchWords(text))
      if (!sided || sideOf(other) != model::Side::none)
        names.add(other);
      else
        for (const std::string& one : withSideOf(other, sideOf(text)))
          names.add(one);
  };
  for (const auto& [tag, text] : words) {
    addAll(text);
    if (const std::string full = inFull(text); !full.empty())
      addAll(full);
  }
  const std::vector<std::string> whole = names.all();
  const KindWord* common = nullptr;  // what any of the names says they are
  Names brief;
  for (const std::string& name : whole) {
    const QStringList parts = wordsOf(name);
    for (qsizetype i = 0; parts.size() > 1 && i < parts.size(); ++i) {
      const KindWord* kind = kindOf(parts[i]);
      if (!kind && !abbreviated(parts[i]))
        continue;
      common = kind ? kind : common;
      QStringList rest = parts;
      if (kind) {
        rest[i] = QLatin1String(kind->brief);
        names.add(rest.join(u' ').toStdString());
      }
      rest.removeAt(i);
      if (!namesAnother(rest, name))
        brief.add(rest.join(u' ').toStdString());
    }
  }
  if (common)
    addKind(names, whole, *common);
  return {names.take(), brief.take()};
}

std::vector<std::string> ownAnswers(const WordsByLanguage& words,
                                    const std::vector<AcceptedAnswers>& others) {
  AcceptedAnswers own = acceptedAnswers(words);
  Names names;
  for (const std::string& name : own.names)
    names.add(name);
  Names foreign;
  for (const AcceptedAnswers& other : others) {
    // What has a name in common is called the same, and is no other.
    const bool same = std::any_of(other.names.begin(), other.names.end(),
                                  [&names](const std::string& name) { return names.has(name); });
    for (const auto* list : {&other.names, &other.brief})
      for (const std::string& name : *list)
        if (!same)
          foreign.add(name);
  }
  for (const std::string& name : own.brief)
    if (!foreign.has(name))
      names.add(name);
  const std::vector<std::string> spelled = names.all();
  for (const std::string& name : spelled)
    for (const std::string& brief : shortForms(name))
      if (!foreign.has(brief))
        names.add(brief);
  return names.take();
}

}  // namespace sline::render
