// SPDX-License-Identifier: Apache-2.0
// The XML parts of a 3MF file (3MF Consortium, "3D Manufacturing Format, Core Specification" 1.3)
// and its objects by their ids (private to the reader).
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

/// One part with a <model>: the root, or one that the production extension's paths lead to.
struct ThreeMfPart {
  std::string text;  ///< parsed in place
  pugi::xml_document document;
  XmlNode model;
  std::map<std::string, XmlNode, std::less<>> objects;  ///< by id
  /// Colours of materials and colour groups, by group and index.
  std::map<std::string, std::vector<std::optional<Colour>>, std::less<>> colours;
};

class ThreeMfDocument {
 public:
  /// Refuses what is no ZIP or has no model part; the source must outlive it.
  static Result<ThreeMfDocument> open(const Source& source);

  const Source& source() const { return *m_source; }
  /// The part that the package's relations name as the model.
  ThreeMfPart& root() const { return *m_root; }
  /// A part by its path in the package ("/3D/Objects/a.model"), read on first use.
  Result<ThreeMfPart*> part(std::string_view path);

 private:
  explicit ThreeMfDocument(const Source& source, ZipReader zip)
      : m_source(&source), m_zip(std::move(zip)) {}

  const Source* m_source;
  ZipReader m_zip;
  std::map<std::string, std::unique_ptr<ThreeMfPart>, std::less<>> m_parts;
  ThreeMfPart* m_root = nullptr;
};

/// The node's name without its namespace's prefix.
std::string_view localName(const XmlNode& node);
/// An attribute by its local name.
std::string_view localAttribute(const XmlNode& node, std::string_view name);
/// The first child of that local name.
XmlNode localChild(const XmlNode& node, std::string_view name);

}  // namespace sline::model
