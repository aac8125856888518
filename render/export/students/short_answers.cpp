// SPDX-License-Identifier: Apache-2.0
#include "render/export/students/short_answers.h"

#include <QString>
#include <QStringList>
#include <array>
#include <utility>

#include "model/anatomy/laterality_words.h"

namespace sline::render {

namespace {

/// The beginnings of adjectives and how they are abbreviated; what follows is an ending of Latin.
constexpr std::array<std::pair<const char*, const char*>, 26> adjectives{{
    {"extern", "ext."},       {"intern", "int."},         {"commun", "comm."},
    {"superior", "sup."},     {"superius", "sup."},       {"inferior", "inf."},
    {"inferius", "inf."},     {"anterior", "ant."},       {"anterius", "ant."},
    {"posterior", "post."},   {"posterius", "post."},     {"lateral", "lat."},
    {"medial", "med."},       {"superficial", "superf."}, {"profund", "prof."},
    {"urinari", "urin."},     {"abdominal", "abd."},      {"thoracic", "thor."},
    {"transvers", "transv."}, {"ascendens", "asc."},      {"descendens", "desc."},
    {"major", "maj."},        {"minor", "min."},          {"mesenteric", "mes."},
    {"pulmonal", "pulm."},    {"coronari", "cor."},
}};
constexpr std::array endings{"", "us", "a", "um", "is", "e", "al", "ales"};

/// Returns the adjective's abbreviation, or the word as it is.
QString shortAdjective(const QString& word) {
  const QString lower = word.toLower();
  for (const auto& [beginning, brief] : adjectives)
    for (const char* ending : endings)
      if (lower == QLatin1String(beginning) + QLatin1String(ending))
        return QLatin1String(brief);
  return word;
}

struct SideWord {
  model::Side side = model::Side::none;
  bool latin = false;
  QStringList brief;  ///< as it is abbreviated in its language
};

SideWord sideIn(const QString& word) {
  const QString lower = word.toLower();
  const model::Side side = model::sideOfWord(lower.toStdString());
  if (side == model::Side::none || lower.size() < 3)
    return {};
  const bool left = side == model::Side::left;
  if (lower.startsWith(QLatin1String("sinist")) || lower.startsWith(QLatin1String("dext")))
    return {side, true, {left ? QStringLiteral("sin.") : QStringLiteral("dext.")}};
  if (lower.startsWith(QLatin1String("link")) || lower.startsWith(QLatin1String("recht")))
    return {side, false, {left ? QStringLiteral("li.") : QStringLiteral("re.")}};
  if (lower == QLatin1String("left") || lower == QLatin1String("right"))
    return {side, false,
            left ? QStringList{QStringLiteral("l."), QStringLiteral("lt.")}
                 : QStringList{QStringLiteral("r."), QStringLiteral("rt.")}};
  return {side, false, {left ? QStringLiteral("ve.") : QString::fromUtf8("h\xC3\xB8.")}};
}

}  // namespace

std::vector<std::string> shortForms(const std::string& name) {
  const QStringList parts = QString::fromStdString(name).simplified().split(u' ');
  std::vector<std::string> forms;
  const auto add = [&forms, &parts](const QStringList& words) {
    if (words != parts)
      forms.push_back(words.join(u' ').toStdString());
  };
  if (parts.size() < 2)
    return forms;
  QStringList brief = parts;
  for (QString& word : brief)
    word = shortAdjective(word);
  add(brief);
  for (qsizetype i = 0; i < parts.size(); ++i) {
    const SideWord side = sideIn(parts[i]);
    for (const QString& word : side.brief)
      for (QStringList words : {parts, brief}) {
        words[i] = word;
        add(words);
      }
    if (!side.latin)
      continue;
    QStringList rest = parts;
    rest.removeAt(i);
    const bool left = side.side == model::Side::left;
    for (const char* spoken : {"left", "linke", "linker", "linkes", "li.", "right", "rechte",
                               "rechter", "rechtes", "re."})
      if ((spoken[0] == 'l') == left)
        add(QStringList{QLatin1String(spoken)} + rest);
  }
  return forms;
}

}  // namespace sline::render
