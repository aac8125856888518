// SPDX-License-Identifier: Apache-2.0
#include "model/import/molecules/entry_files.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "model/base/letters.h"
#include "model/import/molecules/residues.h"

namespace sline::model {

namespace {

/// Tells whether the word is one of the short ones that are no abbreviations.
bool isParticle(const std::string& word) {
  static constexpr std::array particles = {"a",  "an", "and", "as",   "at",  "by",   "the", "for",
                                           "in", "is", "its", "with", "not", "of",   "on",  "one",
                                           "or", "to", "two", "via",  "new", "from", "ion", "low"};
  return std::find(particles.begin(), particles.end(), word) != particles.end();
}

/// Returns a word in small letters, unless it is an abbreviation; these are short or hold digits.
std::string readableWord(const std::string& word) {
  const std::string plain = lowerCase(word);
  const bool digits = std::any_of(word.begin(), word.end(), isDigit);
  return isParticle(plain) || (word.size() > 3 && !digits) ? plain : word;
}

}  // namespace

std::string asciiOf(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (const auto byte = static_cast<unsigned char>(c); byte < ' ' || byte > 0x7e)
      c = '?';
  return result;
}

std::string readableCapitals(std::string_view text) {
  std::string squeezed;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte > ' ')
      squeezed += byte < 0x7f ? c : '?';
    else if (!squeezed.empty() && squeezed.back() != ' ')
      squeezed += ' ';
  }
  if (squeezed.ends_with(' '))
    squeezed.pop_back();
  if (std::any_of(squeezed.begin(), squeezed.end(), isLower))
    return squeezed;
  std::string result;
  std::string word;
  bool begins = true;  // a sentence begins, no letter of it has come yet
  for (const char c : squeezed + ' ') {
    if (isUpper(c) || isDigit(c)) {
      word += c;
      continue;
    }
    std::string readable = readableWord(word);
    if (begins && !readable.empty() && isLower(readable.front()))
      readable.front() = char(readable.front() - 'a' + 'A');
    begins = begins ? word.empty() : c == ' ' && word.empty() && result.ends_with('.');
    result += readable + c;
    word.clear();
  }
  result.pop_back();
  return result;
}

namespace {

struct NamedIon {
  std::string_view name;
  std::string_view symbol;
};

/// Lists the ions that a force field (CHARMM) names otherwise than by their symbols.
constexpr NamedIon fieldIons[] = {{"POT", "K"},  {"SOD", "Na"}, {"CLA", "Cl"}, {"CAL", "Ca"},
                                  {"LIT", "Li"}, {"CES", "Cs"}, {"RUB", "Rb"}, {"BAR", "Ba"},
                                  {"CAD", "Cd"}, {"CD2", "Cd"}, {"ZN2", "Zn"}};

/// Returns the element of an ion whose only atom has the name of its residue.
const Element* elementOfIon(std::string_view name, std::string_view residue) {
  const auto* const found =
      std::find_if(std::begin(fieldIons), std::end(fieldIons),
                   [&](const NamedIon& ion) { return ion.name == name && name == residue; });
  return found == std::end(fieldIons) ? nullptr : elementOf(found->symbol);
}

/// Returns the element in an amino acid or nucleotide, which are made of few: "CA" is a carbon
/// wherever it stands. Null for a name that begins with none of them.
const Element* elementInChain(std::string_view letters, std::string_view residue) {
  const bool selenium = residue == "MSE" || residue == "SEC";
  if (selenium && letters.starts_with("SE"))
    return elementOf("SE");
  return std::string_view("CHNOSPD").find(letters.front()) == std::string_view::npos
             ? nullptr
             : elementOf(letters.substr(0, 1));
}

}  // namespace

const Element* elementOfName(std::string_view columns, std::string_view residue) {
  std::string_view name = columns;
  while (name.starts_with(' ') || (!name.empty() && isDigit(name.front())))
    name.remove_prefix(1);
  while (name.ends_with(' '))
    name.remove_suffix(1);
  std::string_view letters = name;
  for (std::size_t i = 0; i < letters.size(); ++i)
    if (!isUpper(letters[i]) && !isLower(letters[i]))
      letters = letters.substr(0, i);
  if (letters.empty())
    return nullptr;
  if (const Element* ion = elementOfIon(name, residue))
    return ion;
  if (letterOf(residue) != 'X')
    if (const Element* element = elementInChain(letters, residue))
      return element;
  // Two letters are one element if they begin in the first column or name the residue itself.
  const bool inFirstColumn = !columns.empty() && columns.front() == letters.front();
  const bool namesResidue = letters.size() == 2 && residue.starts_with(letters);
  const bool hydrogen = letters.front() == 'H' && name.size() == 4;
  if (letters.size() >= 2 && (inFirstColumn || namesResidue) && !hydrogen)
    if (const Element* two = elementOf(letters.substr(0, 2)))
      return two;
  return elementOf(letters.substr(0, 1));
}

Status judgeAtoms(const Source& source, const EntryRecords& records) {
  const std::size_t good = records.atoms.size();
  if (good == 0 && records.unreadable == 0)
    return source.whole("holds no atom", "Give an entry of the Protein Data Bank with coordinates");
  if (10 * records.unreadable > good + records.unreadable)
    return source.whole(std::to_string(records.unreadable) + " of " +
                            std::to_string(good + records.unreadable) +
                            " atoms have no coordinates that can be read",
                        "Get the entry again");
  return Unit{};
}

}  // namespace sline::model
