// SPDX-License-Identifier: Apache-2.0
#include "model/edit/credits.h"

#include <set>
#include <utility>
#include <vector>

#include "model/base/utf8.h"

namespace sline::model {

namespace {

std::string tidyLine(const std::string& text) {
  std::string line;
  for (const char letter : inUtf8(text)) {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte > ' ' && byte != 0x7f)
      line += letter;
    else if (!line.empty() && line.back() != ' ')
      line += ' ';
  }
  while (!line.empty() && line.back() == ' ')
    line.pop_back();
  return line;
}

}  // namespace

SourceCredit tidied(const SourceCredit& credit) {
  return {.authors = tidyLine(credit.authors),
          .source = tidyLine(credit.source),
          .licence = tidyLine(credit.licence)};
}

Edited withCredit(const Scene& scene, std::span<const NodeId> ids, const CreditChange& change) {
  const std::vector<NodeId> below = scene.structuresBelow(ids);
  const std::set<NodeId> named(below.begin(), below.end());
  std::vector<Node> nodes = scene.nodes();
  bool changed = false;
  for (Node& node : nodes) {
    if (!named.contains(node.id))
      continue;
    SourceCredit& credit = node.provenance.credit;
    const SourceCredit said = tidied({.authors = change.authors.value_or(credit.authors),
                                      .source = change.source.value_or(credit.source),
                                      .licence = change.licence.value_or(credit.licence)});
    changed = changed || said != credit;
    credit = said;
  }
  Edited edited{scene, changed};
  if (changed)
    edited.scene.setNodes(std::move(nodes));
  return edited;
}

}  // namespace sline::model
