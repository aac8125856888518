// SPDX-License-Identifier: Apache-2.0
#include "render/export/plate/source_credits.h"

#include <QString>
#include <algorithm>

#include "model/scene/visible_structures.h"

namespace sline::render {

std::vector<SourceLine> sourceLines(const model::Scene& scene) {
  std::vector<SourceLine> lines;
  for (const model::VisibleStructure& structure : model::visibleStructures(scene)) {
    const std::string text =
        QString::fromStdString(structure.node->provenance.credit.line()).simplified().toStdString();
    if (text.empty())
      continue;
    auto known = std::find_if(lines.begin(), lines.end(),
                              [&text](const SourceLine& line) { return line.text == text; });
    if (known == lines.end())
      known = lines.insert(known, {text, 0});
    ++known->structures;
  }
  std::stable_sort(lines.begin(), lines.end(), [](const SourceLine& a, const SourceLine& b) {
    return a.structures > b.structures;
  });
  return lines;
}

std::string sourcesInOne(const model::Scene& scene) {
  std::string all;
  for (const SourceLine& line : sourceLines(scene))
    all += (all.empty() ? "" : "; ") + line.text;
  return all;
}

}  // namespace sline::render
