// SPDX-License-Identifier: Apache-2.0
#include "render/export/packages/accepted_names.h"

#include <QString>
#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "render/export/encoding/xml_text.h"
#include "render/export/students/answer_hash.h"

namespace sline::render {

namespace {

/// The longest name that anybody types, characters.
constexpr qsizetype longestName = 120;

/// Gathers names, each once.
class NameList {
 public:
  void add(const std::string& text) {
    const std::string name = plainLine(text);
    const QString read = QString::fromStdString(name);
    if (name.empty() || read.size() > longestName || normalisedAnswer(name).empty())
      return;
    for (const std::string& form :
         {name, withoutAccents(name), transcribed(read), withoutStops(read)})
      if (m_known.insert(QString::fromStdString(form).toCaseFolded()).second)
        m_names.push_back(form);
  }
  std::vector<std::string> take() { return std::move(m_names); }

 private:
  /// Returns it as people write abbreviations who leave the full stop out: "A iliaca".
  static std::string withoutStops(QString text) { return text.remove(u'.').toStdString(); }

  /// Returns it as German is written without its letters.
  static std::string transcribed(QString text) {
    static const std::array<std::pair<QChar, QLatin1String>, 7> letters{
        {{QChar(0xE4), QLatin1String("ae")},
         {QChar(0xF6), QLatin1String("oe")},
         {QChar(0xFC), QLatin1String("ue")},
         {QChar(0xC4), QLatin1String("Ae")},
         {QChar(0xD6), QLatin1String("Oe")},
         {QChar(0xDC), QLatin1String("Ue")},
         {QChar(0xDF), QLatin1String("ss")}}};
    for (const auto& [letter, two] : letters)
      text.replace(letter, two);
    return text.toStdString();
  }

  std::set<QString> m_known;
  std::vector<std::string> m_names;
};

}  // namespace

std::string withoutAccents(const std::string& text) {
  static const std::array<std::pair<QChar, QLatin1String>, 7> letters{
      {{QChar(0xDF), QLatin1String("ss")},
       {QChar(0xE6), QLatin1String("ae")},
       {QChar(0xC6), QLatin1String("Ae")},
       {QChar(0x153), QLatin1String("oe")},
       {QChar(0x152), QLatin1String("Oe")},
       {QChar(0xF8), QLatin1String("o")},
       {QChar(0xD8), QLatin1String("O")}}};
  QString bare;
  for (const QChar c : QString::fromStdString(text).normalized(QString::NormalizationForm_KD))
    if (!c.isMark())
      bare += c;
  for (const auto& [letter, plain] : letters)
    bare.replace(letter, plain);
  return bare.toStdString();
}

std::vector<std::string> typedNames(const std::string& first,
                                    const std::vector<std::string>& others) {
  NameList names;
  names.add(first);
  for (const std::string& name : others)
    names.add(name);
  return names.take();
}

}  // namespace sline::render
