// SPDX-License-Identifier: Apache-2.0
// Makes a scene of parts: lays out the tree of groups, chooses distinct names and colours.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "model/anatomy/body_systems.h"
#include "model/import/plan/parts.h"
#include "model/import/plan/sources.h"

namespace sline::model {

struct BuiltScene {
  Scene scene;
  std::map<std::pair<std::size_t, std::size_t>, NodeId> groups;  ///< by source and index of the
                                                                 ///< group in it
  std::vector<std::vector<NodeId>> nodesOfFile;                  ///< as Sources::files
  std::map<NodeId, std::size_t> numbers;                         ///< Part::number of each structure
  std::vector<std::string> cutNames;  ///< of groups, from which words were left out
};

/// Builds the scene. A scene keeps its own groups. A folder's groups are its sub-folders, else
/// those of a part-of table, else the systems of the body by the structures' names; loose files are
/// grouped by systems too, or by the groups inside them. Groups that hold one group only are left
/// out. Of groups' names only what may be shown is kept (model/anatomy/shown_names.h), unless
/// `keepNames` says so. A structure has the mesh that its part has, if any.
BuiltScene buildScene(const std::vector<Part>& parts, const Sources& sources,
                      const AnatomyTable& table, bool keepNames);

}  // namespace sline::model
