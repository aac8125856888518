// SPDX-License-Identifier: Apache-2.0
#include "render/export/order/sheet_words.h"

#include <array>

namespace sline::render {

const SheetWords& sheetWords(const std::string& language) {
  static constexpr std::array<SheetWords, 5> all{
      {{"en", "Legend", "Hidden outline", "Labels", "continued", "Self-test", "Key", "Name", "Date",
        "Contents", "Index of structures", "Words to choose from",
        "Write on each line what has that number in the figure.",
        "Write on each line what has that number in the figure. Choose from the words below.",
        "What is this?", "Which name is covered?", "Which number is it?", "Sources",
        "Other structures"},
       {"de", "Legende", "Verdeckter Umriss", "Beschriftung", "Fortsetzung", "Selbsttest", "Lösung",
        "Name", "Datum", "Inhalt", "Verzeichnis der Strukturen", "Wörter zur Auswahl",
        "Schreiben Sie auf jede Linie, was in der Abbildung diese Nummer hat.",
        "Schreiben Sie auf jede Linie, was in der Abbildung diese Nummer hat. Wählen Sie aus den "
        "Wörtern unten.",
        "Was ist das?", "Welcher Name ist verdeckt?", "Welche Nummer ist es?", "Quellen",
        "Weitere Strukturen"},
       {"nl", "Legenda", "Verborgen omtrek", "Benamingen", "vervolg", "Zelftest", "Antwoorden",
        "Naam", "Datum", "Inhoud", "Register van structuren", "Woorden om uit te kiezen",
        "Schrijf op elke lijn wat in de figuur dat nummer heeft.",
        "Schrijf op elke lijn wat in de figuur dat nummer heeft. Kies uit de woorden hieronder.",
        "Wat is dit?", "Welke naam is bedekt?", "Welk nummer is het?", "Bronnen",
        "Overige structuren"},
       {"nb", "Tegnforklaring", "Skjult omriss", "Betegnelser", "fortsettelse", "Selvtest", "Fasit",
        "Navn", "Dato", "Innhold", "Register over strukturer", "Ord å velge mellom",
        "Skriv på hver linje det som har det nummeret i figuren.",
        "Skriv på hver linje det som har det nummeret i figuren. Velg blant ordene nedenfor.",
        "Hva er dette?", "Hvilket navn er dekket?", "Hvilket nummer er det?", "Kilder",
        "Andre strukturer"},
       {"la", "Index colorum", "Linea occulta", "Nomina", "continuatio", "Examen", "Solutiones",
        "Nomen", "Dies", "Argumentum", "Index structurarum", "Verba eligenda",
        "Scribe in quaque linea quid in figura eum numerum habeat.",
        "Scribe in quaque linea quid in figura eum numerum habeat. Elige ex verbis infra positis.",
        "Quid est hoc?", "Quod nomen tectum est?", "Quem numerum habet?", "Fontes",
        "Structurae ceterae"}}};
  const std::string primary = language.substr(0, language.find_first_of("-_+"));
  for (const SheetWords& words : all)
    if (primary == words.language)
      return words;
  return all.front();
}

}  // namespace sline::render
