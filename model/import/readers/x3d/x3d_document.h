// SPDX-License-Identifier: Apache-2.0
// Reads a scene graph of VRML97 (ISO/IEC 14772) or X3D (ISO/IEC 19775) as nodes and the text of
// their fields, from any of the encodings (private to the reader).
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "model/import/source/source.h"

namespace sline::model {

struct X3dNode {
  std::string_view type;        ///< "Transform"
  std::string_view name;        ///< its name by DEF; may be empty
  const char* place = nullptr;  ///< in the file
  std::vector<std::pair<std::string_view, std::string_view>> fields = {};  ///< brackets left off
  std::vector<const X3dNode*> nodes = {};  ///< those of all its fields, in the file's order

  /// Returns the field's text, or an empty one.
  std::string_view field(std::string_view key) const;
};

struct X3dDocument {
  std::unique_ptr<pugi::xml_document> xml;  ///< texts of the XML encoding
  std::deque<X3dNode> nodes;                ///< point to each other, possibly in circles
  std::vector<const X3dNode*> scene;
  std::optional<double> metresPerUnit;  ///< where the file says so (X3D's UNIT)
  bool prototypes = false;              ///< declares prototypes, which are left out
};

/// The greatest depth at which nodes may lie in each other; deeper ones are an error.
inline constexpr std::size_t deepestX3dNode = 256;

/// Parses X3D in XML.
Result<X3dDocument> parseX3dXml(const Source& source);
/// Parses VRML97, and X3D in the classic encoding.
Result<X3dDocument> parseX3dClassic(const Source& source);

}  // namespace sline::model
