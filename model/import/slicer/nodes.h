// SPDX-License-Identifier: Apache-2.0
// Holds the nodes of a .mrml file by their ids, and resolves their references to each other
// (private to the reader).
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace sline::model {

using XmlNode = pugi::xml_node;

class SlicerNodes {
 public:
  explicit SlicerNodes(const XmlNode& scene);
  /// Returns the node; an empty one where the id is unknown.
  XmlNode find(std::string_view id) const;
  /// Returns the node to which `node` refers in a role: "displayNodeRef" and the like, or the newer
  /// references="display:ID;storage:ID;". It is empty where there is none.
  XmlNode referred(const XmlNode& node, const char* role) const;
  /// Returns the id in that role, whether or not there is such a node.
  static std::string reference(const XmlNode& node, const char* role);

 private:
  std::unordered_map<std::string, XmlNode> m_byId;
};

/// Returns true for "true" and "1", and `absent` where the attribute is absent.
bool flag(const XmlNode& node, const char* attribute, bool absent);
/// Reads numbers separated by spaces, independently of the locale; all of them must be finite.
std::optional<std::vector<double>> numbers(std::string_view text, std::size_t count);
/// Replaces "%20" by " "; text that is no escape stays.
std::string percentDecoded(std::string_view text);

}  // namespace sline::model
