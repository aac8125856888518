// SPDX-License-Identifier: Apache-2.0
#include "model/import/naming/part_of_table.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <functional>
#include <set>

#include "model/base/letters.h"

namespace sline::model {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t largestTable = 64u << 20;
constexpr std::size_t deepestTree = 3;

using Row = std::vector<std::string>;

std::vector<Row> readTable(const fs::path& file) {
  std::vector<Row> rows;
  std::error_code fault;
  if (!fs::is_regular_file(file, fault) || fs::file_size(file, fault) > largestTable)
    return rows;
  std::ifstream stream(file, std::ios::binary);
  for (std::string line; std::getline(stream, line);) {
    if (line.ends_with('\r'))
      line.pop_back();
    Row row(1);
    for (const char c : line) {
      if (c == '\t')
        row.emplace_back();
      else
        row.back() += c;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string capitalised(std::string text) {
  if (!text.empty())
    text.front() = char(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

GroupPaths fromManifest(const fs::path& folder, std::span<const std::string> files) {
  GroupPaths paths;
  const std::vector<Row> rows = readTable(folder / "MANIFEST.tsv");
  if (rows.empty())
    return paths;
  const auto column = [&](const char* name) {
    const auto found = std::find_if(rows[0].begin(), rows[0].end(), [&](const std::string& cell) {
      return lowerCase(cell) == name;
    });
    return std::size_t(found - rows[0].begin());
  };
  const std::size_t file = column("file");
  const std::size_t system = column("system");
  const std::set<std::string> wanted(files.begin(), files.end());
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (file >= rows[i].size() || system >= rows[i].size() || rows[i][system].empty())
      continue;
    const std::string name = fs::path(rows[i][file]).filename().string();
    if (wanted.contains(name))
      paths.emplace(name, std::vector{capitalised(rows[i][system])});
  }
  return paths;
}

/// Holds the part-of tree of BodyParts3D, cut down to the elements that are there.
class PartOfTree {
 public:
  PartOfTree(const std::vector<Row>& inclusion, const std::vector<Row>& elements) {
    for (std::size_t i = 1; i < inclusion.size(); ++i) {
      const Row& row = inclusion[i];
      if (row.size() < 4 || row[0] == row[2])
        continue;
      m_parent.emplace(row[2], row[0]);
      m_names.emplace(row[0], row[1]);
      m_names.emplace(row[2], row[3]);
    }
    for (std::size_t i = 1; i < elements.size(); ++i)
      if (elements[i].size() >= 3)
        m_concepts[elements[i][2]].push_back(elements[i][0]);
  }

  /// Returns concept ids from the root down to the deepest concept that has the element.
  std::vector<std::string> chain(const std::string& element) const {
    std::vector<std::string> best;
    const auto found = m_concepts.find(element);
    if (found == m_concepts.end())
      return best;
    for (const std::string& concept_ : found->second) {
      std::vector<std::string> ids{concept_};
      // The walk through a circle in a damaged table ends at this depth.
      for (auto up = m_parent.find(concept_); up != m_parent.end() && ids.size() < 64;
           up = m_parent.find(up->second))
        ids.push_back(up->second);
      if (ids.size() > best.size())
        best = std::move(ids);
    }
    std::reverse(best.begin(), best.end());
    return best;
  }

  std::string name(const std::string& id) const {
    const auto found = m_names.find(id);
    return capitalised(found == m_names.end() ? id : found->second);
  }

 private:
  std::map<std::string, std::string> m_parent;
  std::map<std::string, std::string> m_names;
  std::map<std::string, std::vector<std::string>> m_concepts;
};

GroupPaths fromPartOfTree(const fs::path& folder, std::span<const std::string> files) {
  const std::vector<Row> inclusion = readTable(folder / "partof_inclusion_relation_list.txt");
  const std::vector<Row> elements = readTable(folder / "partof_element_parts.txt");
  GroupPaths paths;
  if (inclusion.empty() || elements.empty())
    return paths;
  const PartOfTree tree(inclusion, elements);
  std::map<std::string, std::vector<std::string>> chains;
  // Maps each concept to the concepts or files right below it, which tells how many there are.
  std::map<std::string, std::set<std::string>> children;
  for (const std::string& file : files) {
    std::vector<std::string> chain = tree.chain(file.substr(0, file.find_first_of("_.")));
    if (chain.empty())
      continue;
    for (std::size_t i = 0; i < chain.size(); ++i)
      children[chain[i]].insert(i + 1 < chain.size() ? chain[i + 1] : "file " + file);
    chains.emplace(file, std::move(chain));
  }
  for (const auto& [file, chain] : chains) {
    std::vector<std::string>& path = paths[file];
    // A concept with a single child says nothing; the deepest levels are too fine to work with.
    for (const std::string& id : chain)
      if (children[id].size() > 1 && path.size() < deepestTree + 1)
        path.push_back(tree.name(id));
    if (!path.empty())
      path.erase(path.begin());  // drops the body itself
  }
  return paths;
}

}  // namespace

std::optional<GroupPaths> readPartOfTable(const fs::path& folder,
                                          std::span<const std::string> files) {
  std::error_code fault;
  const fs::path whole = fs::weakly_canonical(folder, fault);
  for (const fs::path& place : {whole, whole.parent_path()})
    for (const auto& table : {fromManifest, fromPartOfTree}) {
      GroupPaths paths = table(place, files);
      if (2 * paths.size() > files.size())
        return paths;
    }
  return std::nullopt;
}

}  // namespace sline::model
