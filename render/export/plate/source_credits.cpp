// SPDX-License-Identifier: Apache-2.0
#include "render/export/plate/source_credits.h"

#include <QString>
#include <algorithm>
#include <utility>

#include "model/scene/visible_structures.h"

namespace sline::render {

namespace {

/// Tells whether the licence asks nothing of who shows the work.
bool isFree(const std::string& licence) {
  const QString said = QString::fromStdString(licence).simplified().toLower();
  return said.isEmpty() || said.startsWith(QLatin1String("cc0")) ||
         said.startsWith(QLatin1String("cc-0")) || said.contains(QLatin1String("public domain"));
}

template <class Wanted>
std::vector<SourceLine> linesOf(const model::Scene& scene, const Wanted& wanted) {
  std::vector<SourceLine> lines;
  for (const model::VisibleStructure& structure : model::visibleStructures(scene)) {
    const std::string text =
        QString::fromStdString(structure.node->provenance.credit.line()).simplified().toStdString();
    if (text.empty() || !wanted(structure.node->provenance.credit))
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

}  // namespace

std::vector<SourceLine> sourceLines(const model::Scene& scene) {
  return linesOf(scene, [](const model::SourceCredit&) { return true; });
}

std::vector<SourceLine> sourcesToName(const model::Scene& scene) {
  return linesOf(scene, [](const model::SourceCredit& credit) { return !isFree(credit.licence); });
}

ExportNotes creditNotes(const ExportOrder& order) {
  ExportNote left{.kind = ExportNote::Kind::creditsLeftOut, .names = {}, .detail = {}};
  if (order.sources == SourceCredits::withSurfaces)
    for (const SourceLine& line : sourcesToName(order.scene))
      left.names.push_back(line.text);
  return left.names.empty() ? ExportNotes{} : ExportNotes{std::move(left)};
}

std::string sourcesInOne(const model::Scene& scene) {
  std::string all;
  for (const SourceLine& line : sourceLines(scene))
    all += (all.empty() ? "" : "; ") + line.text;
  return all;
}

}  // namespace sline::render
