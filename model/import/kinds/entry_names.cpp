// SPDX-License-Identifier: Apache-2.0
#include "model/import/kinds/entry_names.h"

#include <algorithm>
#include <regex>

#include "model/base/letters.h"
#include "model/import/kinds/file_kinds.h"

namespace sline::model {

bool isEntryFile(const std::filesystem::path& file) {
  const std::string stem = lowerCase(stemOf(file));
  constexpr std::size_t longest = 64;  // titles have any length, and std::regex goes deep with it
  if (stem.size() > longest)
    return false;
  static const std::regex entry(
      "(?:[0-9](?=[a-z0-9]*[a-z])[a-z0-9]{3}|pdb_[0-9]{4}[0-9][a-z0-9]{3})(?:-assembly.*)?"
      // An accession of UniProt, and which part of the protein.
      "|af-(?:[opq][0-9][a-z0-9]{3}[0-9]|[a-nr-z][0-9](?:[a-z][a-z0-9]{2}[0-9]){1,2})"
      "(?:-[0-9]+)?-f[0-9]+(?:-model_v[0-9]+)?");
  return std::regex_match(stem, entry);
}

bool isOfEntry(const std::string& group) {
  return isEntryFile(group.substr(0, std::min(group.find(" – "), group.rfind(", assembly "))));
}

std::string entryCitation(const std::filesystem::path& file) {
  if (!isEntryFile(file))
    return {};
  const std::string stem = lowerCase(stemOf(file));
  const bool predicted = stem.starts_with("af-");
  const std::size_t begin = predicted ? 3 : 0;
  std::string id = stem.substr(begin, stem.find('-', begin) - begin);
  // The longer ids are written in small letters.
  if (!id.starts_with("pdb_"))
    std::transform(id.begin(), id.end(), id.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c; });
  return (predicted ? "AlphaFold DB " : "PDB ID ") + id;
}

}  // namespace sline::model
