// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>

#include "model/import/molecules/entry_files.h"
#include "model/import/source/text_cursor.h"

namespace sline::model {

namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t'))
    text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r'))
    text.remove_suffix(1);
  return text;
}

/// Returns columns counted from 1, as the format's description does; those beyond the line are
/// empty.
std::string_view columns(std::string_view line, std::size_t first, std::size_t last) {
  return first > line.size() ? std::string_view() : line.substr(first - 1, last - first + 1);
}
std::string_view field(std::string_view line, std::size_t first, std::size_t last) {
  return trimmed(columns(line, first, last));
}

std::optional<double> number(std::string_view text) {
  TextCursor at(text);
  double value = 0.0;
  if (!at.number(value) || !at.atEnd() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

int digitOf(char c) {
  if (c >= '0' && c <= '9')
    return c - '0';
  if (c >= 'A' && c <= 'Z')
    return c - 'A' + 10;
  if (c >= 'a' && c <= 'z')
    return c - 'a' + 10;
  return -1;
}

/// Reads a whole number in a field of `width` columns, beyond its largest in hybrid-36
/// (Grosse-Kunstleve et al., IUCr Computing Commission Newsletter 8): A000 follows 9999, a000
/// follows ZZZZ.
std::optional<std::int64_t> wholeNumber36(std::string_view text, std::size_t width) {
  std::int64_t value = 0;
  TextCursor at(text);
  if (at.integer(value) && at.atEnd())
    return value;
  if (text.size() != width || digitOf(text.front()) < 10)
    return std::nullopt;
  std::int64_t decimal = 1;
  std::int64_t leading = 1;
  for (std::size_t i = 0; i < width; ++i) {
    const int digit = digitOf(text[i]);
    if (digit < 0)
      return std::nullopt;
    value = 36 * value + digit;
    decimal *= 10;
    leading *= i == 0 ? 1 : 36;
  }
  const bool small = text.front() >= 'a';
  return value + decimal + (small ? 16 : -10) * leading;
}

/// Appends text that goes on over several records: words cut at a hyphen are joined.
void append(std::string& text, std::string_view more) {
  if (!text.empty() && !text.ends_with('-') && !more.empty())
    text += ' ';
  text += more;
}

class PdbReader {
 public:
  explicit PdbReader(const Source& source) : m_source(source) {}

  Result<EntryRecords> read() {
    const std::string_view text = m_source.text();
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
      readLine(text.substr(at, end - at));
      at = end + 1;
    }
    m_records.otherModels = m_models > 1 ? m_models - 1 : 0;
    m_records.assemblies = assembliesOfRemarks(m_assemblies);
    readCompounds();
    m_records.notes.title = readableCapitals(m_title);
    for (auto& [code, name] : m_records.notes.componentNames)
      name = readableCapitals(name);
    TRY(judgeAtoms(m_source, m_records));
    return std::move(m_records);
  }

 private:
  void readLine(std::string_view line) {
    const std::string_view record = field(line, 1, 6);
    if (record == "ATOM" || record == "HETATM")
      readAtom(line, record == "HETATM");
    else if (record == "TER")
      m_ended.insert(std::string(field(line, 22, 22))), ++m_ends;
    else if (record == "MODEL")
      ++m_models;
    else if (record == "ENDMDL")
      m_modelEnded = true;
    else if (record == "CONECT")
      readBonds(line);
    else
      readNote(record, line);
  }

  void readNote(std::string_view record, std::string_view line) {
    EntryNotes& notes = m_records.notes;
    if (record == "HEADER")
      notes.id = asciiOf(field(line, 63, 66));
    else if (record == "TITLE")
      append(m_title, field(line, 11, 80));
    else if (record == "COMPND")
      append(m_compounds, field(line, 11, 80));
    else if (record == "REMARK" && field(line, 8, 10) == "350")
      m_assemblies.append(line).append("\n");
    else if (record == "HETNAM")
      append(notes.componentNames[std::string(field(line, 12, 14))], field(line, 16, 70));
    else if (record == "MODRES")
      notes.parents[std::string(field(line, 13, 15))] = field(line, 25, 27);
  }

  void readAtom(std::string_view line, bool hetero) {
    if (m_modelEnded)
      return;
    const auto x = number(field(line, 31, 38));
    const auto y = number(field(line, 39, 46));
    const auto z = number(field(line, 47, 54));
    // A line that is cut inside z would give another number.
    if (!x || !y || !z || line.size() < 54) {
      ++m_records.unreadable;
      return;
    }
    AtomRecord atom;
    atom.name = field(line, 13, 16);
    atom.residue = asciiOf(field(line, 18, 21));
    atom.chain = chainOf(line, hetero);
    atom.part = atom.chain;
    atom.insertion = asciiOf(field(line, 27, 27));
    atom.number = wholeNumber36(field(line, 23, 26), 4).value_or(0);
    atom.serial = wholeNumber36(field(line, 7, 11), 5).value_or(0);
    atom.alternate = line.size() >= 17 ? line[16] : ' ';
    atom.hetero = hetero;
    atom.afterEnd = m_ended.contains(std::string(field(line, 22, 22)));
    atom.occupancy = float(std::clamp(number(field(line, 55, 60)).value_or(1.0), 0.0, 1.0));
    atom.place = {*x, *y, *z};
    atom.element = elementOf(field(line, 77, 78));
    if (!atom.element)
      atom.element = elementOfName(columns(line, 13, 16), atom.residue);
    if (!atom.element)
      atom.element = &unknownElement();
    m_records.atoms.push_back(std::move(atom));
  }

  /// Returns the chain; programs that name no chain still end each with TER: those are numbered.
  std::string chainOf(std::string_view line, bool hetero) {
    const std::string_view id = field(line, 22, 22);
    if (!id.empty())
      return asciiOf(id);
    if (!hetero)
      m_unnamed = m_ends;
    return std::to_string(m_unnamed + 1);
  }

  void readBonds(std::string_view line) {
    const auto from = wholeNumber36(field(line, 7, 11), 5);
    for (std::size_t column = 12; from && column <= 27; column += 5) {
      const auto to = wholeNumber36(field(line, column, column + 4), 5);
      if (to && *to != *from)
        m_records.notes.bonds.insert(std::minmax(*from, *to));
    }
  }

  /// Reads "MOL_ID: 1; MOLECULE: CRAMBIN; CHAIN: A, B;".
  void readCompounds() {
    std::string_view rest = m_compounds;
    std::string molecule;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(';'), rest.size());
      const std::string_view token = trimmed(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
      const std::size_t colon = token.find(':');
      if (colon == std::string_view::npos)
        continue;
      const std::string_view value = trimmed(token.substr(colon + 1));
      if (token.starts_with("MOLECULE:"))
        molecule = readableCapitals(value);
      else if (token.starts_with("CHAIN:"))
        nameChains(value, molecule);
    }
  }

  void nameChains(std::string_view list, const std::string& molecule) {
    while (!list.empty()) {
      const std::size_t end = std::min(list.find(','), list.size());
      m_records.notes.chainNames[std::string(trimmed(list.substr(0, end)))] = molecule;
      list.remove_prefix(std::min(end + 1, list.size()));
    }
  }

  const Source& m_source;
  EntryRecords m_records;
  std::string m_title;
  std::string m_compounds;
  std::string m_assemblies;  ///< lines of REMARK 350
  std::set<std::string> m_ended;
  std::size_t m_ends = 0;
  std::size_t m_unnamed = 0;
  std::size_t m_models = 0;
  bool m_modelEnded = false;
};

}  // namespace

Result<EntryRecords> readPdbRecords(const Source& source) {
  return PdbReader(source).read();
}

}  // namespace sline::model
