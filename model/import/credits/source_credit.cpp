// SPDX-License-Identifier: Apache-2.0
#include "model/import/credits/source_credit.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "model/base/letters.h"
#include "model/base/utf8.h"
#include "model/edit/credits.h"
#include "model/scene_json/json_value.h"

namespace sline::model {

namespace {

constexpr std::size_t mostBytes = 16'384;
constexpr std::size_t mostLines = 80;
/// What is longer is no line that a person wrote to say whose work it is.
constexpr std::size_t longestLine = 1000;

/// Tells whether any of the words is in the text, and begins where a word does.
template <std::size_t n>
bool hasAny(std::string_view text, const std::array<const char*, n>& words) {
  return std::any_of(words.begin(), words.end(), [text](const char* word) {
    for (std::size_t at = text.find(word); at != std::string_view::npos;
         at = text.find(word, at + 1))
      if (at == 0 || !isLetter(text[at - 1]) || !isLetter(*word))
        return true;
    return false;
  });
}

/// Tells whether a person may have written the line: UTF-8 without control characters, and not too
/// long.
bool isText(std::string_view line) {
  if (line.size() > longestLine || !isUtf8(line))
    return false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const auto byte = static_cast<unsigned char>(line[i]);
    const bool high = byte == 0xc2 && static_cast<unsigned char>(line[i + 1]) < 0xa0;
    if ((byte < ' ' && byte != '\t' && byte != '\r') || byte == 0x7f || high)
      return false;
  }
  return true;
}

/// Tells whether a line may speak of a patient or of a computer's folders.
bool mayTell(std::string_view lower) {
  static constexpr std::array words{"patient",  "birth",      "mrn",     "case id",
                                    "subject:", "subject id", "/home/",  "/users/",
                                    ":\\",      "\\\\",       "file://", "accession"};
  return hasAny(lower, words);
}

/// Returns how surely a line names the terms of use; 0: it does not.
int licenceRank(std::string_view lower) {
  static constexpr std::array known{"cc by",
                                    "cc-by",
                                    "cc0",
                                    "creative commons",
                                    "cc attribution",
                                    "mit license",
                                    "apache license",
                                    "public domain",
                                    "bsd",
                                    "gnu ",
                                    "gpl",
                                    "etalab"};
  static constexpr std::array copyright{"copyright", "(c) ", "\xc2\xa9"};
  static constexpr std::array some{"licence", "license"};
  return hasAny(lower, known) ? 3 : hasAny(lower, copyright) ? 2 : hasAny(lower, some) ? 1 : 0;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r*=-");
  if (begin == std::string_view::npos)
    return {};
  return text.substr(begin, text.find_last_not_of(" \t\r*=-") - begin + 1);
}

std::vector<std::string_view> linesOf(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty() && lines.size() < mostLines) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// Returns what follows one of the words and a colon or an equals sign at a line's beginning.
template <std::size_t n>
std::optional<std::string_view> after(std::string_view line,
                                      const std::array<const char*, n>& words) {
  const std::string lower = lowerCase(line);
  for (const char* word : words) {
    if (!lower.starts_with(word))
      continue;
    const std::string_view rest = trimmed(line.substr(std::string_view(word).size()));
    if (!rest.empty() && (rest.front() == ':' || rest.front() == '='))
      return trimmed(rest.substr(1));
  }
  return std::nullopt;
}

constexpr std::array authorWords{"authors", "author", "creators", "creator"};
constexpr std::array licenceWords{"license", "licence", "copyright", "rights"};

/// Keeps the line as the licence where it names one better than what is known.
void takeLicence(SourceCredit& credit, int& rank, std::string_view line) {
  const std::string lower = lowerCase(line);
  if (const int own = licenceRank(lower); own > rank && !mayTell(lower)) {
    rank = own;
    credit.licence = std::string(line);
  }
}

void takeAuthors(SourceCredit& credit, std::string_view line) {
  if (const auto authors = after(line, authorWords);
      authors && credit.authors.empty() && !mayTell(lowerCase(line)))
    credit.authors = std::string(*authors);
}

/// Returns the lines that are text.
std::vector<std::string_view> textLinesOf(std::string_view text) {
  std::vector<std::string_view> lines = linesOf(text);
  std::erase_if(lines, [](std::string_view line) { return !isText(line); });
  return lines;
}

/// Tells whether what a mesh file has to say of itself ends with the line: it begins the data, or
/// says that they begin.
bool endsHeader(std::string_view line) {
  line = trimmed(line);
  for (const std::string_view word : {"end_header", "ElementDataFile", "DATASET", "POINTS", "facet",
                                      "v ", "vn ", "vt ", "f ", "<", "{"})
    if (line.starts_with(word))
      return true;
  return !line.empty() && (isDigit(line.front()) || line.front() == '.');
}

/// Returns the lines of a mesh file's header: those up to its data, to a line that is no text, or,
/// of VTK's legacy files, the first three, after which anything may come.
std::vector<std::string_view> headerOf(std::string_view text) {
  constexpr std::size_t linesOfVtk = 3;
  constexpr std::size_t bytesOfBinaryStl = 80;
  // The header of a binary STL file is filled up with zeros or blanks, and no line ends it.
  const std::string_view first = cutUtf8(text.substr(0, text.find('\n')), longestLine);
  if (text.size() > bytesOfBinaryStl && !isText(first))
    text = text.substr(0, bytesOfBinaryStl);
  while (!text.empty() && text.back() == '\0')
    text.remove_suffix(1);
  std::vector<std::string_view> lines = linesOf(text);
  if (text.starts_with("NRRD"))
    lines.erase(std::find(lines.begin(), lines.end(), std::string_view()), lines.end());
  if (text.starts_with("# vtk DataFile"))
    lines.resize(std::min(lines.size(), linesOfVtk));
  lines.erase(std::find_if(lines.begin(), lines.end(),
                           [](std::string_view line) { return !isText(line) || endsHeader(line); }),
              lines.end());
  return lines;
}

/// Returns the text of a comment; nothing for lines that are data.
std::optional<std::string_view> commentIn(std::string_view line) {
  for (const std::string_view mark : {"#", "comment ", "//", "solid "})
    if (line.starts_with(mark))
      return trimmed(line.substr(mark.size()));
  return std::nullopt;
}

/// Returns the JSON of a glTF file; of a binary one, as much of its first chunk as is there.
std::string_view gltfJson(std::string_view text) {
  constexpr std::size_t headBytes = 20;
  if (!text.starts_with("glTF") || text.size() < headBytes)
    return text;
  std::size_t length = 0;
  for (std::size_t i = 0; i < 4; ++i)
    length |= std::size_t(static_cast<unsigned char>(text[12 + i])) << (8 * i);
  return text.substr(headBytes, length);
}

/// Returns the copyright of a glTF file's asset, whose other texts name programs.
std::string assetCopyright(std::string_view text) {
  constexpr std::string_view key = "\"copyright\"";
  const std::size_t asset = text.find("\"asset\"");
  const std::size_t at = asset == std::string_view::npos ? asset : text.find(key, asset);
  if (at == std::string_view::npos)
    return {};
  const std::size_t begin = text.find('"', at + key.size());
  std::size_t end = begin == std::string_view::npos ? begin : begin + 1;
  while (end < text.size() && text[end] != '"')
    end += text[end] == '\\' ? 2 : 1;
  if (begin == std::string_view::npos || end >= text.size())
    return {};
  const Result<Json> value = parseJson(text.substr(begin, end + 1 - begin));
  std::string said = value.ok() && value->is_string() ? value->get<std::string>() : std::string();
  return isText(said) ? said : std::string();
}

SourceCredit creditInMesh(std::string_view text) {
  SourceCredit credit;
  if (text.starts_with("glTF") || text.starts_with("{")) {
    credit.licence = assetCopyright(gltfJson(text));
    return mayTell(lowerCase(credit.licence)) ? SourceCredit() : credit;
  }
  int rank = 0;
  for (const std::string_view line : headerOf(text))
    if (const auto comment = commentIn(line)) {
      takeLicence(credit, rank, *comment);
      takeAuthors(credit, *comment);
    }
  return credit;
}

SourceCredit creditInCitation(std::string_view text) {
  SourceCredit credit;
  static constexpr std::array title{"title"};
  static constexpr std::array family{"family-names", "name"};
  static constexpr std::array given{"given-names"};
  const auto plain = [](std::string_view value) {
    const std::size_t begin = value.find_first_not_of("\"'");
    return begin == std::string_view::npos
               ? std::string()
               : std::string(value.substr(begin, value.find_last_not_of("\"'") - begin + 1));
  };
  std::vector<std::string> authors;
  for (const std::string_view line : textLinesOf(text)) {
    const std::string_view said = trimmed(line);
    if (mayTell(lowerCase(said)))
      continue;
    if (const auto value = after(said, title); value && credit.source.empty())
      credit.source = plain(*value);
    else if (const auto licence = after(said, licenceWords); licence && credit.licence.empty())
      credit.licence = plain(*licence);
    else if (const auto last = after(said, family))
      authors.push_back(plain(*last));
    else if (const auto first = after(said, given); first && !authors.empty())
      authors.back() = plain(*first) + " " + authors.back();
  }
  for (const std::string& author : authors)
    credit.authors += (credit.authors.empty() ? "" : ", ") + author;
  return credit;
}

SourceCredit creditInReadme(std::string_view text) {
  SourceCredit credit;
  int rank = -1;
  for (const std::string_view line : textLinesOf(text)) {
    const std::string_view said = trimmed(line);
    if (const auto licence = after(said, licenceWords); licence && rank < 0)
      if (const std::string lower = lowerCase(said); !mayTell(lower)) {
        rank = licenceRank(lower);
        credit.licence = std::string(*licence);
      }
    takeAuthors(credit, said);
  }
  return credit;
}

/// Tells whether the line is part of a sentence about some terms of use rather than their name: it
/// goes on in the next line, or from the one before, or says nothing that is known.
bool isOfSentence(std::string_view line, std::string_view next) {
  const std::string lower = ' ' + lowerCase(line) + ' ';
  static constexpr std::array verbs{" is ", " are ", " may ", " shall ", " must ", " this "};
  const bool sentence = std::any_of(verbs.begin(), verbs.end(), [&lower](const char* verb) {
    return lower.find(verb) != std::string::npos;
  });
  const bool goesOn = !line.ends_with('.') && !next.empty() && isLower(next.front());
  const bool begun = !line.empty() && isLower(line.front()) && licenceRank(lower) < 3;
  return begun || (sentence && (goesOn || licenceRank(lower) < 2));
}

SourceCredit creditInLicence(std::string_view text) {
  SourceCredit credit;
  int rank = 0;
  const std::vector<std::string_view> lines = textLinesOf(text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string_view line = trimmed(lines[i]);
    const std::string_view next = i + 1 < lines.size() ? trimmed(lines[i + 1]) : std::string_view();
    if (!isOfSentence(line, next))
      takeLicence(credit, rank, line);
  }
  return credit;
}

/// Fills in what is open.
void complete(SourceCredit& credit, const SourceCredit& other) {
  for (std::string SourceCredit::*const field :
       {&SourceCredit::authors, &SourceCredit::source, &SourceCredit::licence})
    if ((credit.*field).empty())
      credit.*field = other.*field;
}

std::string beginningOf(const std::filesystem::path& file) {
  std::error_code failure;
  if (!std::filesystem::is_regular_file(file, failure))
    return {};
  std::ifstream stream(file, std::ios::binary);
  std::string text(mostBytes, '\0');
  stream.read(text.data(), std::streamsize(text.size()));
  text.resize(std::size_t(std::max<std::streamsize>(stream.gcount(), 0)));
  return text;
}

struct NamedText {
  const char* name;
  CreditText kind;
};
constexpr std::array<NamedText, 13> namedTexts{{{"CITATION.cff", CreditText::citation},
                                                {"LICENSE", CreditText::licence},
                                                {"LICENSE.txt", CreditText::licence},
                                                {"LICENSE.md", CreditText::licence},
                                                {"LICENCE", CreditText::licence},
                                                {"LICENCE.txt", CreditText::licence},
                                                {"LICENCE.md", CreditText::licence},
                                                {"COPYING", CreditText::licence},
                                                {"COPYING.txt", CreditText::licence},
                                                {"license.txt", CreditText::licence},
                                                {"README", CreditText::readme},
                                                {"README.txt", CreditText::readme},
                                                {"README.md", CreditText::readme}}};

}  // namespace

SourceCredit creditIn(std::string_view text, CreditText kind) {
  text = text.substr(0, mostBytes);
  switch (kind) {
    case CreditText::mesh:
      return tidied(creditInMesh(text));
    case CreditText::citation:
      return tidied(creditInCitation(text));
    case CreditText::readme:
      return tidied(creditInReadme(text));
    case CreditText::licence:
      break;
  }
  return tidied(creditInLicence(text));
}

SourceCredit creditOf(const std::filesystem::path& file) {
  SourceCredit credit = creditIn(beginningOf(file), CreditText::mesh);
  const std::filesystem::path folder = file.parent_path();
  for (const NamedText& text : namedTexts)
    complete(credit, creditIn(beginningOf(folder / text.name), text.kind));
  for (const NamedText& text : namedTexts)
    if (text.kind != CreditText::readme)
      complete(credit, creditIn(beginningOf(folder / ".." / text.name), text.kind));
  return credit;
}

}  // namespace sline::model
