// SPDX-License-Identifier: Apache-2.0
#include "render/lines/techniques/line_technique.h"

#include <array>

#include "render/lines/ground/line_clip.h"
#include "render/lines/ground/stages.h"
#include "render/lines/techniques/apparent_ridges.h"
#include "render/lines/techniques/confis.h"
#include "render/lines/techniques/contours.h"
#include "render/lines/techniques/demarcating_curves.h"
#include "render/lines/techniques/highlight_lines.h"
#include "render/lines/techniques/laplacian_lines.h"
#include "render/lines/techniques/photic_extrema.h"
#include "render/lines/techniques/ridges.h"
#include "render/lines/techniques/rims.h"
#include "render/lines/techniques/streamline_hatching.h"
#include "render/lines/techniques/suggestive_contours.h"

namespace sline::render {

namespace {

/// The lines that suggestive contours are compared with enter as these do.
float linesEntered(Gamma gamma) {
  return transitions(gamma).suggestive;
}

bool everywhere(const model::Cluster&, model::Facing, const model::EyePoint&) {
  return true;
}

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
                  .entered = linesEntered,
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
    LineTechnique{.kind = LineKind::hatchingStreamline,
                  .id = "streamline_hatching",
                  .layer = "Streamline hatching",
                  .drawnBy = model::Technique::streamlineHatching,
                  .pen = LinePen::centred,
                  .specks = {.shortest = 0.5f, .whole = 1.0f},
                  .joined = false,
                  .thresholds = streamlineHatchingThresholds,
                  .entered = confisEntered,
                  .prepare = prepareStreamlineHatching,
                  .find = findStreamlineHatching,
                  .rank = rankConfisLines},
    LineTechnique{.kind = LineKind::apparentRidge,
                  .id = "apparent_ridge",
                  .layer = "Apparent ridges",
                  .drawnBy = model::Technique::apparentRidges,
                  .pen = LinePen::centred,
                  .specks = {.shortest = 1.0f, .whole = 1.75f},
                  .atScale = true,
                  .thresholds = apparentRidgeThresholds,
                  .entered = linesEntered,
                  .find = findApparentRidges,
                  .rank = rankByStrength},
    LineTechnique{.kind = LineKind::ridge,
                  .id = "ridge",
                  .layer = "Ridges",
                  .drawnBy = model::Technique::ridges,
                  .pen = LinePen::centred,
                  .specks = {.shortest = 1.0f, .whole = 1.75f},
                  .thresholds = ridgeThresholds,
                  .entered = linesEntered,
                  .prepare = prepareRidges,
                  .find = findRidges,
                  .rank = rankByStrength},
    LineTechnique{.kind = LineKind::valley,
                  .id = "valley",
                  .layer = "Valleys",
                  .drawnBy = model::Technique::ridges,
                  .pen = LinePen::centred,
                  .specks = {.shortest = 1.0f, .whole = 1.75f},
                  .thresholds = ridgeThresholds,
                  .entered = linesEntered,
                  .prepare = prepareValleys,
                  .find = findValleys,
                  .rank = rankByStrength},
    LineTechnique{.kind = LineKind::photic,
                  .id = "photic",
                  .layer = "Photic extremum lines",
                  .drawnBy = model::Technique::photic,
                  .pen = LinePen::centred,
                  .specks = {.shortest = 1.0f, .whole = 1.75f},
                  .atScale = true,
                  .thresholds = photicThresholds,
                  .entered = linesEntered,
                  .mayPass = everywhere,
                  .extract = extractPhoticExtrema,
                  .rank = rankByStrength},
    LineTechnique{.kind = LineKind::laplacian,
                  .id = "laplacian",
                  .layer = "Laplacian lines",
                  .drawnBy = model::Technique::laplacian,
                  .pen = LinePen::centred,
                  .specks = {.shortest = 1.0f, .whole = 1.75f},
                  .atScale = true,
                  .thresholds = laplacianThresholds,
                  .entered = linesEntered,
                  .mayPass = everywhere,
                  .extract = extractLaplacianLines,
                  .rank = rankByStrength},
    LineTechnique{.kind = LineKind::demarcating,
                  .id = "demarcating",
                  .layer = "Demarcating curves",
                  .drawnBy = model::Technique::demarcating,
                  .pen = LinePen::centred,
                  .specks = {.shortest = 1.0f, .whole = 1.75f},
                  .thresholds = demarcatingThresholds,
                  .entered = linesEntered,
                  .prepare = prepareDemarcatingCurves,
                  .find = findDemarcatingCurves,
                  .rank = rankByStrength},
    LineTechnique{.kind = LineKind::suggestiveHighlight,
                  .id = "suggestive_highlight",
                  .layer = "Suggestive highlights",
                  .drawnBy = model::Technique::highlights,
                  .pen = LinePen::centred,
                  .specks = {.shortest = 1.0f, .whole = 1.75f},
                  .atScale = true,
                  .thresholds = suggestiveHighlightThresholds,
                  .entered = linesEntered,
                  .mayPass = everywhere,
                  .extract = extractSuggestiveHighlights,
                  .rank = rankByStrength},
    LineTechnique{.kind = LineKind::principalHighlight,
                  .id = "principal_highlight",
                  .layer = "Principal highlights",
                  .drawnBy = model::Technique::highlights,
                  .pen = LinePen::centred,
                  .specks = {.shortest = 1.0f, .whole = 1.75f},
                  .atScale = true,
                  .thresholds = principalHighlightThresholds,
                  .entered = linesEntered,
                  .mayPass = everywhere,
                  .extract = extractPrincipalHighlights,
                  .rank = rankByStrength},
    LineTechnique{.kind = LineKind::contour,
                  .id = "contour",
                  .layer = "Contours",
                  .pen = LinePen::outside,
                  .specks = {.shortest = 1.0f, .whole = 1.5f},
                  .bounds = true,
                  .entered = [](Gamma gamma) { return transitions(gamma).contours; },
                  .mayPass = contoursMayPass,
                  .extract = extractContours,
                  .prepare = prepareRims,
                  .find = findRims,
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
