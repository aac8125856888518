// SPDX-License-Identifier: Apache-2.0
#include "render/export/packages/package_words.h"

#include <array>

namespace sline::render {

const PackageWords& packageWords(const std::string& language) {
  static constexpr std::array<PackageWords, 5> all{
      {{"en", "Anatomy", "Click in the picture on: %1", "Drag the marker onto: %1",
        "What is marked in the picture? Type its name.", "What is marked in the picture?",
        "Which number in the picture has: %1?", "Right.", "Not right.",
        "Nothing is there. Try again.", "Check", "Try again", "Show the answer"},
       {"de", "Anatomie", "Klicken Sie im Bild auf: %1", "Ziehen Sie die Marke auf: %1",
        "Was ist im Bild markiert? Tippen Sie den Namen.", "Was ist im Bild markiert?",
        "Welche Nummer im Bild hat: %1?", "Richtig.", "Nicht richtig.",
        "Dort ist nichts. Versuchen Sie es noch einmal.", "Prüfen", "Noch einmal",
        "Antwort zeigen"},
       {"nl", "Anatomie", "Klik in de afbeelding op: %1", "Sleep de markering naar: %1",
        "Wat is in de afbeelding gemarkeerd? Typ de naam.", "Wat is in de afbeelding gemarkeerd?",
        "Welk nummer in de afbeelding heeft: %1?", "Goed.", "Niet goed.",
        "Daar is niets. Probeer het nog eens.", "Controleren", "Nog eens", "Antwoord tonen"},
       {"nb", "Anatomi", "Klikk i bildet på: %1", "Dra merket til: %1",
        "Hva er merket i bildet? Skriv navnet.", "Hva er merket i bildet?",
        "Hvilket nummer i bildet har: %1?", "Riktig.", "Ikke riktig.",
        "Der er det ingenting. Prøv igjen.", "Sjekk", "Prøv igjen", "Vis svaret"},
       {"la", "Anatomia", "Preme in imagine: %1", "Trahe notam ad: %1",
        "Quid in imagine notatum est? Scribe nomen.", "Quid in imagine notatum est?",
        "Quem numerum in imagine habet: %1?", "Recte.", "Non recte.",
        "Ibi nihil est. Iterum tempta.", "Proba", "Iterum", "Ostende responsum"}}};
  const std::string primary = language.substr(0, language.find_first_of("-_+"));
  for (const PackageWords& words : all)
    if (primary == words.language)
      return words;
  return all.front();
}

std::string withName(const char* words, const std::string& name) {
  std::string text = words;
  if (const std::size_t at = text.find("%1"); at != std::string::npos)
    text.replace(at, 2, name);
  return text;
}

}  // namespace sline::render
