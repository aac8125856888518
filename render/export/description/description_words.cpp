// SPDX-License-Identifier: Apache-2.0
#include "render/export/description/description_words.h"

namespace sline::render {

namespace {

constexpr std::array<DescriptionTable, 5> descriptionTables{
    {{"en",
      "Nothing is visible in the picture.",
      "Drawing of one structure",
      "Drawing of %1 structures",
      {"from the front", "from behind", "from the patient's left", "from the patient's right",
       "from above", "from below"},
      "%1, seen %2",
      "%1; labelled: %2",
      {"The front of the body", "The back of the body", "The patient's left", "The patient's right",
       "The upper end of the body", "The lower end of the body"},
      "%1 is on the left of the picture.",
      "%1 is at the top of the picture.",
      "Which side of the body is which is not certain.",
      {"On the left of the picture: %1.", "In the middle: %1.", "On the right of the picture: %1."},
      "Labelled: %1.",
      "In the picture %1 lies in front of %2.",
      "Shown: %1.",
      "Also shown: %1.",
      "%1 more",
      "and",
      "A film. It begins: %1"},
     {"de",
      "Im Bild ist nichts zu sehen.",
      "Zeichnung einer Struktur",
      "Zeichnung von %1 Strukturen",
      {"von vorn", "von hinten", "von der linken Körperseite", "von der rechten Körperseite",
       "von oben", "von unten"},
      "%1, gesehen %2",
      "%1; beschriftet: %2",
      {"Die Vorderseite des Körpers", "Die Rückseite des Körpers", "Die linke Körperseite",
       "Die rechte Körperseite", "Das obere Körperende", "Das untere Körperende"},
      "%1 ist links im Bild.",
      "%1 ist oben im Bild.",
      "Welche Körperseite welche ist, ist nicht sicher.",
      {"Links im Bild: %1.", "In der Mitte: %1.", "Rechts im Bild: %1."},
      "Beschriftet: %1.",
      "Im Bild vorn: %1; dahinter: %2.",
      "Zu sehen: %1.",
      "Außerdem zu sehen: %1.",
      "%1 weitere",
      "und",
      "Ein Film. Er beginnt so: %1"},
     {"nl",
      "Er is niets te zien in beeld.",
      "Tekening van één structuur",
      "Tekening van %1 structuren",
      {"van voren", "van achteren", "van de linkerzijde van het lichaam",
       "van de rechterzijde van het lichaam", "van boven", "van onderen"},
      "%1, gezien %2",
      "%1; benoemd: %2",
      {"De voorkant van het lichaam", "De achterkant van het lichaam",
       "De linkerzijde van het lichaam", "De rechterzijde van het lichaam",
       "De bovenkant van het lichaam", "De onderkant van het lichaam"},
      "%1 is links in beeld.",
      "%1 is boven in beeld.",
      "Welke zijde van het lichaam welke is, is niet zeker.",
      {"Links in beeld: %1.", "In het midden: %1.", "Rechts in beeld: %1."},
      "Benoemd: %1.",
      "Vooraan in beeld: %1; daarachter: %2.",
      "Te zien: %1.",
      "Ook te zien: %1.",
      "nog %1",
      "en",
      "Een film. Hij begint zo: %1"},
     {"nb",
      "Det er ingenting å se i bildet.",
      "Tegning av én struktur",
      "Tegning av %1 strukturer",
      {"forfra", "bakfra", "fra kroppens venstre side", "fra kroppens høyre side", "ovenfra",
       "nedenfra"},
      "%1, sett %2",
      "%1; med navn: %2",
      {"Kroppens forside", "Kroppens bakside", "Kroppens venstre side", "Kroppens høyre side",
       "Kroppens øvre ende", "Kroppens nedre ende"},
      "%1 er til venstre i bildet.",
      "%1 er øverst i bildet.",
      "Det er ikke sikkert hvilken side av kroppen som er hvilken.",
      {"Til venstre i bildet: %1.", "I midten: %1.", "Til høyre i bildet: %1."},
      "Med navn: %1.",
      "Foran i bildet: %1; bak: %2.",
      "Vises: %1.",
      "Dessuten vises: %1.",
      "%1 til",
      "og",
      "En film. Den begynner slik: %1"},
     {"la",
      "In imagine nihil videtur.",
      "Delineatio unius structurae",
      "Delineatio structurarum %1",
      {"a fronte", "a tergo", "a latere sinistro corporis", "a latere dextro corporis", "desuper",
       "ab inferiore parte"},
      "%1, conspectus %2",
      "%1; inscriptae: %2",
      {"Pars anterior corporis", "Pars posterior corporis", "Latus sinistrum corporis",
       "Latus dextrum corporis", "Pars superior corporis", "Pars inferior corporis"},
      "%1 in imagine a sinistra est.",
      "%1 in imagine supra est.",
      "Utrum latus corporis sit utrum, non constat.",
      {"In imagine a sinistra: %1.", "In medio: %1.", "In imagine a dextra: %1."},
      "Inscriptae: %1.",
      "In imagine ante: %1; post: %2.",
      "Videntur: %1.",
      "Videntur etiam: %1.",
      "aliae %1",
      "et",
      "Pellicula. Initium: %1"}}};

}  // namespace

const DescriptionTable& descriptionTable(const std::string& language) {
  const std::string primary = language.substr(0, language.find_first_of("-_+"));
  for (const DescriptionTable& table : descriptionTables)
    if (primary == table.language || (primary == "no" && std::string(table.language) == "nb"))
      return table;
  return descriptionTables.front();
}

QString listed(const QStringList& names, const DescriptionTable& table) {
  if (names.size() < 2)
    return names.join(QString());
  return names.mid(0, names.size() - 1).join(QStringLiteral(", ")) + QLatin1Char(' ') +
         QString::fromUtf8(table.conjunction) + QLatin1Char(' ') + names.back();
}

std::size_t wordCount(const QString& text) {
  const QString line = text.simplified();
  return line.isEmpty() ? 0 : std::size_t(line.count(QLatin1Char(' ')) + 1);
}

}  // namespace sline::render
