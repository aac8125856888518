// SPDX-License-Identifier: Apache-2.0
// Reads the XML parts of a 3MF file (3MF Consortium, "3D Manufacturing Format, Core Specification"
// 1.3) and its objects by their ids (private to the reader).
#pragma once

#include <glm/mat4x4.hpp>
#include <map>
#include <memory>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "model/disk/zip_archive.h"
#include "model/import/source/source.h"

namespace sline::model {

using XmlNode = pugi::xml_node;

/// Holds one part with a <model>: the root, or one to which the production extension's paths lead.
struct ThreeMfPart {
  std::string text;  ///< parsed in place
  pugi::xml_document document;
  XmlNode model;
  std::map<std::string, XmlNode, std::less<>> objects;  ///< by id
  /// Holds the colours of materials and colour groups, by group and index.
  std::map<std::string, std::vector<std::optional<Colour>>, std::less<>> colours;
};

class ThreeMfDocument {
 public:
  /// Opens the package; refuses a file that is no ZIP or has no model part. The source must outlive
  /// it.
  static Result<ThreeMfDocument> open(const Source& source);

  const Source& source() const { return *m_source; }
  /// Returns the part that the package's relations name as the model.
  ThreeMfPart& root() const { return *m_root; }
  /// Returns a part by its path in the package ("/3D/Objects/a.model"), read on first use.
  Result<ThreeMfPart*> part(std::string_view path);

 private:
  explicit ThreeMfDocument(const Source& source, ZipReader zip)
      : m_source(&source), m_zip(std::move(zip)) {}

  const Source* m_source;
  ZipReader m_zip;
  std::map<std::string, std::unique_ptr<ThreeMfPart>, std::less<>> m_parts;
  ThreeMfPart* m_root = nullptr;
};

/// Returns the node's name without its namespace's prefix.
std::string_view localName(const XmlNode& node);
/// Returns an attribute by its local name.
std::string_view localAttribute(const XmlNode& node, std::string_view name);
/// Returns the first child of that local name.
XmlNode localChild(const XmlNode& node, std::string_view name);

}  // namespace sline::model
