// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/sheet_words.h"

#include <array>

namespace sline::render {

const SheetWords& sheetWords(const std::string& language) {
  static constexpr std::array<SheetWords, 5> all{
      {{"en", "Legend", "Hidden outline", "Labels", "continued", "Self-test", "Key", "Name", "Date",
        "Sources"},
       {"de", "Legende", "Verdeckter Umriss", "Beschriftung", "Fortsetzung", "Selbsttest", "Lösung",
        "Name", "Datum", "Quellen"},
       {"nl", "Legenda", "Verborgen omtrek", "Benamingen", "vervolg", "Zelftest", "Antwoorden",
        "Naam", "Datum", "Bronnen"},
       {"nb", "Tegnforklaring", "Skjult omriss", "Betegnelser", "fortsettelse", "Selvtest", "Fasit",
        "Navn", "Dato", "Kilder"},
       {"la", "Index colorum", "Linea occulta", "Nomina", "continuatio", "Examen", "Solutiones",
        "Nomen", "Dies", "Fontes"}}};
  const std::string primary = language.substr(0, language.find_first_of("-_+"));
  for (const SheetWords& words : all)
    if (primary == words.language)
      return words;
  return all.front();
}

}  // namespace sline::render
