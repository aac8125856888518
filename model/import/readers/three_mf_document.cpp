// SPDX-License-Identifier: Apache-2.0
#include "model/import/readers/three_mf_document.h"
#include "model/base/colour_text.h"

#include <charconv>

namespace sline::model {

namespace {

/// XML of coordinates shrinks to a tenth. A tree of it takes sixteen times the text at worst
/// ("<a/>"), so that a file of 1 MB is granted no more than half a gigabyte.
constexpr ZipLimits packageLimits{
    .members = 20'000, .unpackedBytes = std::uint64_t(4) << 30, .ratio = 30};
constexpr const char* relations = "_rels/.rels";
constexpr const char* usualModel = "3D/3dmodel.model";
constexpr std::size_t largestRelations = std::size_t(1) << 20;

std::string_view withoutPrefix(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::string memberName(std::string_view path) {
  while (!path.empty() && path.front() == '/')
    path.remove_prefix(1);
  return std::string(path);
}

/// Returns where the package says its model is.
std::string modelNamed(const ZipReader& zip) {
  const ZipReader::Entry* entry = zip.find(relations);
  if (!entry || entry->size > largestRelations)
    return usualModel;
  const Result<std::string> text = zip.read(*entry);
  pugi::xml_document document;
  if (!text || !document.load_buffer(text->data(), text->size()))
    return usualModel;
  for (const XmlNode& relation : document.first_child().children())
    if (std::string_view(relation.attribute("Type").value()).ends_with("/3dmodel"))
      return memberName(relation.attribute("Target").value());
  return usualModel;
}

/// Reads "#RRGGBB" or "#RRGGBBAA", sRGB.
std::optional<Colour> colourIn(std::string_view text) {
  return text.size() == 9 ? colourFrom(text.substr(0, 7)) : colourFrom(text);
}

void indexResources(ThreeMfPart& part) {
  for (const XmlNode& resource : localChild(part.model, "resources").children()) {
    const std::string_view kind = localName(resource);
    const std::string id = resource.attribute("id").value();
    if (kind == "object")
      part.objects.emplace(id, resource);
    if (kind != "basematerials" && kind != "colorgroup")
      continue;
    auto& colours = part.colours[id];
    for (const XmlNode& entry : resource.children())
      colours.push_back(
          colourIn(entry.attribute(kind == "colorgroup" ? "color" : "displaycolor").value()));
  }
}

}  // namespace

std::string_view localName(const XmlNode& node) {
  return withoutPrefix(node.name());
}

std::string_view localAttribute(const XmlNode& node, std::string_view name) {
  for (const pugi::xml_attribute& attribute : node.attributes())
    if (withoutPrefix(attribute.name()) == name)
      return attribute.value();
  return {};
}

XmlNode localChild(const XmlNode& node, std::string_view name) {
  for (const XmlNode& child : node.children())
    if (localName(child) == name)
      return child;
  return {};
}

Result<ThreeMfDocument> ThreeMfDocument::open(const Source& source) {
  Result<ZipReader> zip = ZipReader::open(source.text(), packageLimits);
  if (!zip)
    return source.at(zip.error().where, zip.error().reason);
  ThreeMfDocument document(source, std::move(*zip));
  document.m_root = TRY(document.part(modelNamed(document.m_zip)));
  return document;
}

Result<ThreeMfPart*> ThreeMfDocument::part(std::string_view path) {
  const std::string name = memberName(path);
  if (const auto known = m_parts.find(name); known != m_parts.end())
    return known->second.get();
  const ZipReader::Entry* entry = m_zip.find(name);
  if (!entry)
    return m_source->whole("holds no model: there is no part " + inQuotes(name));
  Result<std::string> text = m_zip.read(*entry);
  if (!text)
    return m_source->at(text.error().where, text.error().reason);
  auto part = std::make_unique<ThreeMfPart>();
  part->text = std::move(*text);
  // No entity but XML's own five is known, so no text can blow up.
  const pugi::xml_parse_result parsed =
      part->document.load_buffer_inplace(part->text.data(), part->text.size());
  if (!parsed)
    return m_source->at(name + ", byte " + std::to_string(parsed.offset),
                        std::string("the XML is broken: ") + parsed.description());
  part->model = localChild(part->document, "model");
  if (!part->model)
    return m_source->at(name, "there is no <model> in it");
  indexResources(*part);
  return m_parts.emplace(name, std::move(part)).first->second.get();
}

}  // namespace sline::model
