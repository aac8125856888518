// SPDX-License-Identifier: Apache-2.0
#include "render/lines/line_technique.h"

#include <array>

#include "render/lines/confis.h"
#include "render/lines/contours.h"
#include "render/lines/stages.h"
#include "render/lines/suggestive_contours.h"

namespace sline::render {

namespace {

constexpr std::array techniques{
    LineTechnique{.kind = LineKind::suggestive,
                  .id = "suggestive",
                  .layer = "Suggestive contours",
                  .drawnBy = model::Technique::sline,
                  .pen = LinePen::centred,
                  // Specks of a rough surface are not marks that a pen would draw.
                  .specks = {.shortest = 1.0f, .whole = 1.75f},
                  .atScale = true,
                  .thresholds = suggestiveThresholds,
                  .setThresholds = setSuggestiveThresholds,
                  .entered = [](Gamma gamma) { return transitions(gamma).suggestive; },
                  .mayPass = suggestiveContoursMayPass,
                  .extract = extractSuggestiveContours,
                  .rank = rankSuggestiveContours},
    LineTechnique{.kind = LineKind::confis,
                  .id = "confis",
                  .layer = "ConFIS",
                  .drawnBy = model::Technique::confis,
                  .pen = LinePen::centred,
                  .specks = {.shortest = 0.5f, .whole = 1.0f},
                  .joined = false,
                  .thresholds = confisThresholds,
                  .entered = confisEntered,
                  .prepare = prepareConfis,
                  .find = findConfisLines,
                  .rank = rankConfisLines},
    LineTechnique{.kind = LineKind::contour,
                  .id = "contour",
                  .layer = "Contours",
                  .pen = LinePen::outside,
                  .specks = {.shortest = 1.0f, .whole = 1.5f},
                  .bounds = true,
                  .entered = [](Gamma gamma) { return transitions(gamma).contours; },
                  .mayPass = contoursMayPass,
                  .extract = extractContours,
                  .rank = rankContours},
    LineTechnique{.kind = LineKind::section,
                  .id = "section",
                  .layer = "Cut outlines",
                  .pen = LinePen::cutEdge,
                  // Everything but pores is drawn.
                  .specks = {.shortest = 0.4f, .whole = 1.2f},
                  .entered = [](Gamma) { return 1.0f; }}};

static_assert(techniques.size() == lineKindCount);

}  // namespace

std::span<const LineTechnique> lineTechniques() {
  return techniques;
}

LineThresholds thresholdsAt(Gamma gamma) {
  LineThresholds thresholds;
  for (const LineTechnique& technique : techniques)
    if (technique.setThresholds)
      technique.setThresholds(gamma, thresholds);
  return thresholds;
}

}  // namespace sline::render
