// SPDX-License-Identifier: Apache-2.0
// Hatches with streamlines of the stronger curvature that are spaced evenly over the surface; light
// and shade decide how close they lie and how strong they are (Zander, Isenberg, Schlechtweg,
// Strothotte, "High Quality Hatching", Eurographics 2004).
//
// ▲ The paper lays its lines once at one distance and tells tone by their width. Here they are
// those of a `StreamlineLayout`, which has lines for every distance: a view takes those that its
// scale shows well, so that hatching is as dense at any size, and lets every other one end where it
// gets lighter. Lines that stay are the ones that are farthest apart; none moves while the camera
// turns.
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "render/lines/streamlines/streamline_layout.h"
#include "render/lines/techniques/line_technique.h"

namespace sline::render {

enum StreamlineHatchingThreshold : std::size_t { hatchingDistance, leastShade };
inline constexpr std::array streamlineHatchingThresholds{
    LineThreshold{.id = "spacing",
                  .meaning = "the distance between lines in full shade, 1/720 of the picture's "
                             "height",
                  .usual = 4.0f,
                  .limits = {1.0f, 100.0f}},
    LineThreshold{.id = "shade",
                  .meaning = "the shade must be above, 0 in the light to 1",
                  .usual = 0.2f,
                  .limits = {0.0f, 1.0f}}};

class HatchingStreamlines : public PreparedLines {
 public:
  explicit HatchingStreamlines(const model::Surface& surface);
  std::size_t count() const override { return m_layout.lines().size(); }
  std::size_t bytes() const override { return m_layout.bytes(); }
  const StreamlineLayout& layout() const { return m_layout; }

 private:
  StreamlineLayout m_layout;
};
std::unique_ptr<const PreparedLines> prepareStreamlineHatching(const model::Surface& surface);

/// Returns the shade of a surface, 0 in the light to 1: of a matt one, with a little of the light
/// that comes from the eye. Both vectors and the normal are of unit length.
float hatchingShade(const glm::vec3& normal, const glm::vec3& toEye, const glm::vec3& toLight);

void findStreamlineHatching(const LineSearch& search, std::vector<Segment>& segments);

}  // namespace sline::render
