// SPDX-License-Identifier: Apache-2.0
// Draws ConFIS, contours with feature-based illustrative streamlines (METHOD §8; Lawonn, Mönch,
// Preim, "Streamlines for Illustrative Real-Time Rendering", EuroVis 2013): short streamlines of
// the stronger curvature that start along the contour and where the mean curvature has an extremum,
// and fade along their way.
//
// ▲ The paper starts a line in every triangle, here they are those of a `StreamlineLayout`, as far
// apart as the picture shows them well; on each of them everything that it passes may start a
// stroke, as the streamlines from there lie on top of it. So the strokes in a picture are as far
// apart as `spacing` says, whatever the mesh, and none jumps while the camera turns: what changes
// is how far each stroke reaches.
//
// ▲ Lengths are measured in F_c, not in F as those of other lines are (METHOD §1): by F the margin
// of a tree of vessels would be the whole tree.
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "render/lines/streamlines/streamline_layout.h"
#include "render/lines/techniques/line_technique.h"

namespace sline::render {

enum ConfisThreshold : std::size_t { contourMargin, leastFeature, lineSpacing };
inline constexpr std::array confisThresholds{
    LineThreshold{.id = "margin",
                  .meaning = "T/F_c, the thickness of the contour's margin",
                  .usual = 0.15f,
                  .limits = {0.0f, 1.0f}},
    LineThreshold{.id = "feature",
                  .meaning = "|H|·F_c must be above where H has an extremum",
                  .usual = usualFeature,
                  .limits = {0.0f, 8.0f}},
    LineThreshold{.id = "spacing",
                  .meaning = "the least distance between lines, 1/720 of the picture's height",
                  .usual = 5.0f,
                  .limits = {1.0f, 100.0f}}};

class ConfisLines : public PreparedLines {
 public:
  explicit ConfisLines(const model::Surface& surface) : m_layout(surface) {}
  std::size_t count() const override { return m_layout.lines().size(); }
  std::size_t bytes() const override { return m_layout.bytes(); }
  const StreamlineLayout& layout() const { return m_layout; }

 private:
  StreamlineLayout m_layout;
};
std::unique_ptr<const PreparedLines> prepareConfis(const model::Surface& surface);

/// Returns the T by which ConFIS has entered: it stands in for suggestive contours and hatching,
/// from Γ = 1 to 3.
float confisEntered(Gamma gamma);

/// Tells how strongly a point belongs to the contour's margin, 0 … 1: to its edge, where
/// nv = √(T·κv·(2 − T·κv)), it fades. `kappa` is the normal curvature in the direction of view on
/// the side that is seen, and T the thickness, in units that cancel; T·κv is held to 0 … 1
/// (Kindlmann et al., "Curvature-Based Transfer Functions", 2003).
float marginStrength(float nv, float kappa, float thickness);

void findConfisLines(const LineSearch& search, std::vector<Segment>& segments);

/// Lets the lines that are farthest apart enter first.
void rankConfisLines(std::vector<Segment>& segments, const model::Surface& surface,
                     const model::Camera& camera, float t);

}  // namespace sline::render
