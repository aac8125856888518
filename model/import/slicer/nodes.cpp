// SPDX-License-Identifier: Apache-2.0
#include "model/import/slicer/nodes.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace sline::model {

SlicerNodes::SlicerNodes(const XmlNode& scene) {
  for (const XmlNode& node : scene.children())
    if (const char* id = node.attribute("id").value(); *id != '\0')
      m_byId.emplace(id, node);
}

XmlNode SlicerNodes::find(std::string_view id) const {
  const auto found = m_byId.find(std::string(id));
  return found == m_byId.end() ? XmlNode() : found->second;
}

std::string SlicerNodes::reference(const XmlNode& node, const char* role) {
  for (const char* ending : {"NodeRef", "NodeID"}) {
    const std::string_view ids = node.attribute((role + std::string(ending)).c_str()).value();
    if (!ids.empty())
      return std::string(ids.substr(0, ids.find(' ')));
  }
  // The attribute reads "display:ID1 ID2;storage:ID3;".
  std::string_view rest = node.attribute("references").value();
  while (!rest.empty()) {
    const std::string_view entry = rest.substr(0, rest.find(';'));
    rest.remove_prefix(std::min(entry.size() + 1, rest.size()));
    const std::size_t colon = entry.find(':');
    if (colon == std::string_view::npos || entry.substr(0, colon) != role)
      continue;
    const std::string_view ids = entry.substr(colon + 1);
    return std::string(ids.substr(0, ids.find(' ')));
  }
  return {};
}

XmlNode SlicerNodes::referred(const XmlNode& node, const char* role) const {
  return find(reference(node, role));
}

bool flag(const XmlNode& node, const char* attribute, bool absent) {
  const std::string_view text = node.attribute(attribute).value();
  if (text.empty())
    return absent;
  return text == "true" || text == "1";
}

std::optional<std::vector<double>> numbers(std::string_view text, std::size_t count) {
  std::vector<double> values;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    while (at != end && static_cast<unsigned char>(*at) <= ' ')
      ++at;
    if (at == end)
      break;
    double value = 0.0;
    const auto [next, fault] = std::from_chars(at, end, value);
    if (fault != std::errc() || !std::isfinite(value) || values.size() == count)
      return std::nullopt;
    values.push_back(value);
    at = next;
  }
  return values.size() == count ? std::optional(values) : std::nullopt;
}

std::string percentDecoded(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned code = 0;
    if (text[i] == '%' && i + 2 < text.size()) {
      const char* const end = text.data() + i + 3;
      const auto [next, fault] = std::from_chars(text.data() + i + 1, end, code, 16);
      if (fault == std::errc() && next == end && code != 0) {
        result += char(code);
        i += 2;
        continue;
      }
    }
    result += text[i];
  }
  return result;
}

}  // namespace sline::model
