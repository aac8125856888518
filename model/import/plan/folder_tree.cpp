// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/folder_tree.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "model/anatomy/name_words.h"
#include "model/import/kinds/entry_names.h"
#include "model/import/naming/file_marks.h"
#include "model/import/naming/names.h"
#include "model/import/naming/part_of_table.h"

namespace sline::model {

namespace {

using Path = std::vector<std::string>;

/// Describes a group to be made: its members are parts (by index) and groups below it.
struct Branch {
  std::string name;
  Style style;
  std::vector<Branch> groups;
  std::vector<std::size_t> parts;
  /// The source and the group in its scene that this group stands for.
  std::optional<std::pair<std::size_t, std::size_t>> origin = std::nullopt;

  Branch& child(const std::string& childName) {
    const auto found = std::find_if(groups.begin(), groups.end(),
                                    [&](const Branch& b) { return b.name == childName; });
    if (found != groups.end())
      return *found;
    groups.push_back({childName, {}, {}, {}});
    return groups.back();
  }
};

/// Leaves out groups that hold nothing, or nothing but one group.
void prune(Branch& branch) {
  for (Branch& group : branch.groups)
    prune(group);
  std::erase_if(branch.groups, [](const Branch& b) { return b.groups.empty() && b.parts.empty(); });
  for (Branch& group : branch.groups)
    while (group.parts.empty() && group.groups.size() == 1) {
      Branch only = std::move(group.groups.front());
      group = std::move(only);
    }
}

/// Prunes the top as well: one group around everything is no group.
void pruneTop(Branch& top) {
  prune(top);
  while (top.parts.empty() && top.groups.size() == 1) {
    Branch only = std::move(top.groups.front());
    top.groups = std::move(only.groups);
    top.parts = std::move(only.parts);
  }
}

/// Tells whether it is a name for what has none, perhaps with a side.
bool isUnnamed(const std::string& name) {
  return sidedName(name).rest == unnamedStructure;
}

std::size_t groupCount(const Branch& branch) {
  std::size_t count = 0;
  for (const Branch& group : branch.groups)
    count += 1 + groupCount(group);
  return count;
}

std::string folderName(const std::filesystem::path& folder) {
  const std::filesystem::path whole = std::filesystem::absolute(folder).lexically_normal();
  // "pelvis/" has an empty last step.
  const bool slash = whole.filename().empty();
  return (slash ? whole.parent_path() : whole).filename().string();
}

/// Names groups after folders, scenes and what these and files call them, as far as the names may
/// be shown: different ones stay apart.
class GroupNames {
 public:
  explicit GroupNames(bool keepNames) : m_keep(keepNames) {}

  std::string ofFolder(const std::string& folder) { return of(readableName(folder)); }
  /// Names what was given whole, which is a group of several alone.
  std::string ofGiven(const std::string& folder) {
    const std::string given = readableName(folder);
    m_whole.insert(given);
    return of(given);
  }
  /// Names the group of a molecule, which its reader calls after the file and the title in it:
  /// "2SRC – Human tyrosine kinase, assembly 1". Entries of the Protein Data Bank are no one's.
  std::string ofEntry(const std::string& given) {
    if (isOfEntry(given))
      return given;
    const std::size_t assembly = std::min(given.rfind(", assembly "), given.size());
    const std::string entry = given.substr(0, std::min(given.find(" – "), assembly));
    return of(entry, "molecule") + given.substr(assembly);
  }
  /// Names a group in that of a molecule, such as one of its ligands.
  std::string inEntry(const std::string& entry, const std::string& given) const {
    return m_keep || isOfEntry(entry) ? given : shownMoleculePart(given);
  }
  std::string of(const std::string& given, const std::string& other = "group") {
    if (m_keep || mayBeShown(given))
      return given;
    const auto [known, isNew] = m_names.try_emplace(given);
    if (!isNew)
      return known->second;
    const std::string shown = shownFileName(given);
    std::string name = shown.empty() ? other + " 1" : shown;
    for (int number = 2; !m_taken.insert(name).second; ++number)
      name = shown.empty() ? other + ' ' + std::to_string(number) : withCounter(shown, number);
    return known->second = name;
  }
  /// Returns the names that are not whole, beside those of what was given.
  std::vector<std::string> cut() const {
    std::vector<std::string> names;
    for (const auto& [given, name] : m_names)
      if (!m_whole.contains(given))
        names.push_back(given);
    return names;
  }

 private:
  bool m_keep;
  std::set<std::string> m_whole;  ///< names of what was given
  std::map<std::string, std::string> m_names;
  std::set<std::string> m_taken;
};

class Builder {
 public:
  Builder(const std::vector<Part>& parts, const Sources& sources, const AnatomyTable& table,
          bool keepNames)
      : m_parts(parts), m_sources(sources), m_table(table), m_groups(keepNames) {}

  BuiltScene build() {
    nameParts();
    m_built.nodesOfFile.resize(m_sources.files.size());
    std::vector<Branch> tops;
    for (std::size_t i = 0; i < m_sources.sources.size(); ++i)
      if (Branch top = branchOf(i); !top.groups.empty() || !top.parts.empty())
        tops.push_back(std::move(top));
    for (const Branch& top : tops) {
      const bool wrap =
          tops.size() > 1 && !top.name.empty() && (top.groups.size() + top.parts.size() > 1);
      add(top, rootId, wrap);
    }
    m_built.cutNames = m_groups.cut();
    return std::move(m_built);
  }

 private:
  void nameParts() {
    std::vector<bool> cut;
    for (const Part& part : m_parts) {
      m_names.push_back(part.name.empty() ? std::string(unnamedStructure) : part.name);
      cut.push_back(part.nameCut && !isUnnamed(m_names.back()));
    }
    tellApart(m_names, cut);
  }

  const SourceFile& fileOf(std::size_t part) const { return m_sources.files[m_parts[part].file]; }

  Branch branchOf(std::size_t index) {
    const ImportSource& source = m_sources.sources[index];
    std::vector<std::size_t> members;
    std::vector<std::size_t> molecules;
    for (std::size_t i = 0; i < m_parts.size(); ++i)
      if (fileOf(i).source == index)
        (m_parts[i].raw.molecule ? molecules : members).push_back(i);
    if (source.kind == ImportSource::Kind::slicer)
      return slicerBranch(index, members);
    Branch top = source.kind == ImportSource::Kind::folder ? folderBranch(source, members)
                                                           : byFileGroupsOrNames(members);
    if (source.kind == ImportSource::Kind::folder)
      top.name = m_groups.ofGiven(folderName(source.path));
    // Folders of medical images are named after patients; the scene must not know the names.
    if (const auto kept =
            std::find_if(members.begin(), members.end(),
                         [&](std::size_t part) { return !m_parts[part].raw.origin.empty(); });
        kept != members.end())
      top.name = m_parts[*kept].raw.origin;
    addMolecules(molecules, top);
    return top;
  }

  /// Adds molecules: each entry has a group of its own, and in it those that its reader made.
  void addMolecules(const std::vector<std::size_t>& members, Branch& top) {
    std::vector<Branch> entries;
    const Backbone* last = nullptr;
    for (const std::size_t part : members) {
      const RawMesh& raw = m_parts[part].raw;
      if (raw.molecule->backbone.get() != last)
        entries.emplace_back();
      last = raw.molecule->backbone.get();
      Branch* at = &entries.back();
      for (std::size_t i = 0; i < raw.groups.size(); ++i)
        if (i > 0)
          at = &at->child(m_groups.inEntry(raw.groups.front(), raw.groups[i]));
        else
          at->name = m_groups.ofEntry(raw.groups[i]);
      at->parts.push_back(part);
    }
    std::vector<std::string> names;
    names.reserve(entries.size());
    for (const Branch& entry : entries)
      names.push_back(entry.name);
    makeUnique(names);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      entries[i].name = names[i];
      top.groups.push_back(std::move(entries[i]));
    }
  }

  Branch slicerBranch(std::size_t index, const std::vector<std::size_t>& members) {
    const ImportSource& source = m_sources.sources[index];
    const std::vector<SlicerGroup>& groups = source.scene->groups;
    std::vector<Branch> branches;
    branches.reserve(groups.size());
    for (const SlicerGroup& group : groups)
      branches.push_back(
          {m_groups.of(group.name), group.style, {}, {}, std::pair(index, branches.size())});
    Branch top;
    top.name = m_groups.ofGiven(source.path.stem().string());
    for (const std::size_t part : members) {
      const auto group = source.scene->models[*fileOf(part).model].group;
      (group ? branches[*group] : top).parts.push_back(part);
    }
    // Parents come first, so that going backwards every group is complete when it is handed up.
    for (std::size_t i = groups.size(); i-- > 0;) {
      if (branches[i].groups.empty() && branches[i].parts.empty())
        continue;
      Branch& parent = groups[i].parent ? branches[*groups[i].parent] : top;
      parent.groups.insert(parent.groups.begin(), std::move(branches[i]));
    }
    return top;
  }

  template <class PathOf>
  Branch byPaths(const std::vector<std::size_t>& members, const PathOf& pathOf) const {
    Branch top;
    for (const std::size_t part : members) {
      Branch* at = &top;
      for (const std::string& step : pathOf(part))
        at = &at->child(step);
      at->parts.push_back(part);
    }
    return top;
  }

  Branch folderBranch(const ImportSource& source, const std::vector<std::size_t>& members) {
    Branch byFolders = byPaths(members, [&](std::size_t part) {
      Path path;
      for (const std::string& folder : fileOf(part).folders)
        path.push_back(m_groups.ofFolder(folder));
      return path;
    });
    pruneTop(byFolders);
    if (!byFolders.groups.empty())
      return byFolders;
    std::vector<std::string> files;
    files.reserve(members.size());
    for (const std::size_t part : members)
      files.push_back(fileOf(part).file.filename().string());
    const std::filesystem::path folder =
        members.empty() ? source.path : fileOf(members.front()).file.parent_path();
    if (const auto paths = readPartOfTable(folder, files)) {
      Branch byTable = byPaths(members, [&](std::size_t part) {
        const auto found = paths->find(fileOf(part).file.filename().string());
        Path path = found == paths->end() ? Path() : found->second;
        for (std::string& step : path)
          step = m_groups.of(step);
        return path;
      });
      for (Branch& group : byTable.groups)
        if (const auto match = m_table.match(group.name))
          group.style.colour = match->colour;
      pruneTop(byTable);
      dissolveSmall(byTable);
      if (!byTable.groups.empty())
        return byTable;
    }
    return byFileGroupsOrNames(members);
  }

  Branch byFileGroupsOrNames(const std::vector<std::size_t>& members) {
    Branch inFile = byPaths(members, [&](std::size_t part) {
      Path path;
      for (const std::string& group : m_parts[part].raw.groups)
        path.push_back(m_groups.of(nameInFile(group)));
      return path;
    });
    pruneTop(inFile);
    dissolveSmall(inFile);
    if (groupCount(inFile) >= 2 && 5 * inFile.parts.size() <= members.size())
      return inFile;
    return byNames(members);
  }

  /// Dissolves groups of one structure, which are no help where they were not asked for.
  void dissolveSmall(Branch& top) const {
    for (Branch& group : top.groups) {
      dissolveSmall(group);
      if (group.groups.empty() && group.parts.size() == 1) {
        top.parts.push_back(group.parts.front());
        group.parts.clear();
      }
    }
    std::erase_if(top.groups, [](const Branch& b) { return b.groups.empty() && b.parts.empty(); });
    std::sort(top.parts.begin(), top.parts.end());
  }

  Branch byNames(const std::vector<std::size_t>& members) const {
    Branch top;
    for (const AnatomySystem& system : m_table.systems())
      top.groups.push_back({system.title, {.colour = system.colour}, {}, {}});
    top.groups.push_back({"Other structures", {}, {}, {}});
    for (const std::size_t part : members) {
      const auto match = m_table.match(m_names[part]);
      top.groups[match ? match->system : m_table.systems().size()].parts.push_back(part);
    }
    dissolveSmall(top);
    if (members.size() < 4 || top.groups.size() + top.parts.size() < 2 ||
        (top.groups.size() == 1 && top.groups.front().style.colour == std::nullopt)) {
      top.groups.clear();
      top.parts = members;
    }
    return top;
  }

  void add(const Branch& branch, NodeId parent, bool asGroup) {
    if (asGroup)
      parent = m_built.scene.append({.parent = parent, .name = branch.name, .style = branch.style});
    if (branch.origin)
      m_built.groups[*branch.origin] = parent;
    for (const Branch& group : branch.groups)
      add(group, parent, true);
    for (const std::size_t part : branch.parts)
      addPart(part, parent);
  }

  void addPart(std::size_t index, NodeId parent) {
    const Part& part = m_parts[index];
    const SourceFile& file = m_sources.files[part.file];
    Node node;
    node.parent = parent;
    node.name = m_names[index];
    node.provenance = part.provenance;
    node.mesh = part.mesh;
    if (file.model) {
      const SlicerModel& model = m_sources.sources[file.source].scene->models[*file.model];
      node.style = model.style;
      if (model.segments)
        node.style.colour = part.raw.colour ? part.raw.colour : colourOf(index);
    } else {
      node.style.colour = colourOf(index);
      const Node* group = m_built.scene.find(parent);
      if (group && group->style.colour && node.style.colour == group->style.colour)
        node.style.colour.reset();
      if (part.raw.opacity && part.raw.opacity->value() < 1.0f)
        node.style.opacity = part.raw.opacity;
      node.style.visible = part.raw.visible;
    }
    const NodeId id = m_built.scene.append(std::move(node));
    m_built.nodesOfFile[part.file].push_back(id);
    m_built.numbers[id] = part.number;
  }

  /// Returns the structure's colour. The table takes precedence; a colour in the file counts where
  /// the name is unknown, or several of its file would look alike (`tellsApart`), and the colour
  /// was chosen by a person rather than a program's grey.
  std::optional<Colour> colourOf(std::size_t index) const {
    const Part& part = m_parts[index];
    if (part.raw.molecule)
      return part.raw.colour;
    const auto match = m_table.match(m_names[index]);
    if (match && !(isColourful(part) && tellsApart(index, *match)))
      return match->colour;
    return isColourful(part) ? part.raw.colour : std::nullopt;
  }

  static bool isColourful(const Part& part) {
    if (!part.raw.colour)
      return false;
    const Colour c = *part.raw.colour;
    return std::max({c.red, c.green, c.blue}) - std::min({c.red, c.green, c.blue}) > 24;
  }

  /// Tells whether the file's colour tells the structure from another one of its file that has the
  /// same in the table: parcels of the brain and volumes of a plan of treatment, for which anatomy
  /// has no colours of their own.
  bool tellsApart(std::size_t index, const AnatomyMatch& match) const {
    const std::string& system = m_table.systems()[match.system].id;
    if (system != "brain" && system != "lesion")
      return false;
    const Part& part = m_parts[index];
    for (std::size_t i = 0; i < m_parts.size(); ++i) {
      const Part& other = m_parts[i];
      if (i == index || other.file != part.file || !isColourful(other) ||
          other.raw.colour == part.raw.colour)
        continue;
      const auto same = m_table.match(m_names[i]);
      if (same && same->colour == match.colour)
        return true;
    }
    return false;
  }

  const std::vector<Part>& m_parts;
  std::vector<std::string> m_names;  ///< names of the parts; all different
  const Sources& m_sources;
  const AnatomyTable& m_table;
  GroupNames m_groups;
  BuiltScene m_built;
};

}  // namespace

BuiltScene buildScene(const std::vector<Part>& parts, const Sources& sources,
                      const AnatomyTable& table, bool keepNames) {
  return Builder(parts, sources, table, keepNames).build();
}

}  // namespace sline::model
