// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>

#include "model/import/readers/x3d/x3d_document.h"
#include "model/import/source/text_cursor.h"

namespace sline::model {

std::string_view X3dNode::field(std::string_view key) const {
  const auto found =
      std::find_if(fields.begin(), fields.end(), [&](const auto& f) { return f.first == key; });
  return found == fields.end() ? std::string_view() : found->second;
}

namespace {

/// Describes an element that is waiting for its nodes to be made, and the node to which they
/// belong.
struct ElementVisit {
  pugi::xml_node element;
  X3dNode* parent = nullptr;
  std::size_t depth = 0;
};

class X3dXmlParser {
 public:
  explicit X3dXmlParser(const Source& source) : m_source(source) {}

  Result<X3dDocument> parse() {
    m_document.xml = std::make_unique<pugi::xml_document>();
    const pugi::xml_parse_result parsed =
        m_document.xml->load_buffer(m_source.begin(), m_source.size());
    if (!parsed)
      return m_source.atLine(m_source.begin() + parsed.offset,
                             std::string("is not valid XML: ") + parsed.description());
    const pugi::xml_node root = m_document.xml->child("X3D");
    if (!root)
      return m_source.whole("is XML but not X3D");
    for (const pugi::xml_node& unit : root.child("head").children("unit"))
      if (std::string_view(unit.attribute("category").value()) == "length") {
        double metres = 0.0;
        TextCursor cursor(std::string_view(unit.attribute("conversionFactor").value()));
        if (cursor.number(metres))
          m_document.metresPerUnit = metres;
      }
    TRY(build(root.child("Scene")));
    return std::move(m_document);
  }

 private:
  Status build(const pugi::xml_node& scene) {
    std::vector<ElementVisit> waiting;
    push({scene, nullptr, 0}, waiting);
    while (!waiting.empty()) {
      const ElementVisit visit = waiting.back();
      waiting.pop_back();
      if (visit.depth > deepestX3dNode)
        return m_source.atLine(m_source.begin() + visit.element.offset_debug(),
                               "its nodes lie more than 256 levels deep in each other");
      if (std::string_view(visit.element.name()).ends_with("ProtoDeclare")) {
        m_document.prototypes = true;
        continue;
      }
      if (const X3dNode* used = usedBy(visit.element))
        adopt(visit.parent, used);
      else
        push({visit.element, &make(visit), visit.depth}, waiting);
    }
    return Unit{};
  }

  /// Pushes the children; the first one is visited first.
  static void push(const ElementVisit& parent, std::vector<ElementVisit>& waiting) {
    const auto first = std::ptrdiff_t(waiting.size());
    for (const pugi::xml_node& child : parent.element.children())
      if (child.type() == pugi::node_element)
        waiting.push_back({child, parent.parent, parent.depth + 1});
    std::reverse(waiting.begin() + first, waiting.end());
  }

  const X3dNode* usedBy(const pugi::xml_node& element) const {
    const auto found = m_named.find(std::string_view(element.attribute("USE").value()));
    return found == m_named.end() ? nullptr : found->second;
  }

  X3dNode& make(const ElementVisit& visit) {
    X3dNode& node = m_document.nodes.emplace_back();
    node.type = visit.element.name();
    node.place = m_source.begin() + visit.element.offset_debug();
    for (const pugi::xml_attribute& attribute : visit.element.attributes())
      node.fields.emplace_back(attribute.name(), attribute.value());
    node.name = node.field("DEF");
    if (!node.name.empty())
      m_named[node.name] = &node;
    adopt(visit.parent, &node);
    return node;
  }

  void adopt(X3dNode* parent, const X3dNode* node) {
    (parent ? parent->nodes : m_document.scene).push_back(node);
  }

  const Source& m_source;
  X3dDocument m_document;
  std::map<std::string_view, const X3dNode*> m_named;
};

}  // namespace

Result<X3dDocument> parseX3dXml(const Source& source) {
  return X3dXmlParser(source).parse();
}

}  // namespace sline::model
