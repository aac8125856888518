// SPDX-License-Identifier: Apache-2.0
// The nodes of a .mrml file by their ids, and how they refer to each other (private to the reader).
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
  /// An empty node where the id is unknown.
  XmlNode find(std::string_view id) const;
  /// The node that `node` refers to in a role: "displayNodeRef" and the like, or the newer
  /// references="display:ID;storage:ID;". Empty where there is none.
  XmlNode referred(const XmlNode& node, const char* role) const;
  /// Its id, whether or not there is such a node.
  static std::string reference(const XmlNode& node, const char* role);

 private:
  std::unordered_map<std::string, XmlNode> m_byId;
};

/// "true", "1" → true; absent: the default.
bool flag(const XmlNode& node, const char* attribute, bool absent);
/// Numbers apart by spaces, read independently of the locale; all of them must be finite.
std::optional<std::vector<double>> numbers(std::string_view text, std::size_t count);
/// "%20" → " "; what is no escape stays.
std::string percentDecoded(std::string_view text);

}  // namespace sline::model
