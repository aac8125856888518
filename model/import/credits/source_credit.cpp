// SPDX-License-Identifier: Apache-2.0
#include "model/import/credits/source_credit.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "model/edit/credits.h"
#include "model/scene_json/json_value.h"

namespace sline::model {

namespace {

constexpr std::size_t mostBytes = 16'384;
constexpr std::size_t mostLines = 80;

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (char& letter : lower)
    if (letter >= 'A' && letter <= 'Z')
      letter = char(letter - 'A' + 'a');
  return lower;
}

template <std::size_t n>
bool hasAny(std::string_view text, const std::array<const char*, n>& words) {
  return std::any_of(words.begin(), words.end(), [text](const char* word) {
    return text.find(word) != std::string_view::npos;
  });
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

/// Returns the text of a comment; nothing for lines that are data.
std::optional<std::string_view> commentIn(std::string_view line) {
  for (const std::string_view mark : {"#", "comment ", "//", "solid "})
    if (line.starts_with(mark))
      return trimmed(line.substr(mark.size()));
  return std::nullopt;
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
  return value.ok() && value->is_string() ? value->get<std::string>() : std::string();
}

SourceCredit creditInMesh(std::string_view text) {
  SourceCredit credit;
  if (text.starts_with("glTF") || text.starts_with("{")) {
    credit.licence = assetCopyright(text);
    return mayTell(lowerCase(credit.licence)) ? SourceCredit() : credit;
  }
  int rank = 0;
  for (const std::string_view line : linesOf(text))
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
  for (const std::string_view line : linesOf(text)) {
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
  for (const std::string_view line : linesOf(text)) {
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
  SourceCredit credit;
  int rank = 0;
  for (const std::string_view line : linesOf(text))
    takeLicence(credit, rank, trimmed(line));
  return tidied(credit);
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
