// SPDX-License-Identifier: Apache-2.0
// Makes confident lines of what extraction finds (METHOD §11): pieces are joined, and each line
// gets the smooth curve and the pressure with which a pen would draw it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

#include "render/drawn/picture_view.h"
#include "render/lines/ground/chains.h"
#include "render/strokes/line_joints.h"

namespace sline::render {

/// Tells how lines of one kind become curves. Lengths are in pixels of the picture.
struct CurveSettings {
  float smoothing = 1.0f;  ///< times 3 λ: the deviation of the weights that lines are averaged with
  float variation = 1.0f;  ///< how much the pressure varies, 0 … 1
  float pen = 2.0f;        ///< the width of the pen
  float waver = 0.0f;      ///< how far a hand wavers to either side
  bool outline = false;    ///< the line ends a surface: its ink lies outside, along the normals
  glm::vec3 light{0.0f};   ///< towards the light, in the camera's frame
  JointLimits joints;      ///< within these, pieces of a curve become one; zeros: all stay
  float pixel = 0.0f;      ///< mm, at the structure: for lines that reach behind the eye
};

/// No point of a curve lies farther than this from the line it was made of, in λ.
inline constexpr float curveBound = 1.25f;
/// Of an outline: and no farther outside the surface than this, so that no gap opens to its fill.
inline constexpr float outlineBound = 0.5f;

/// Holds where chains run in the picture: of each chain the beginning of its first link, then the
/// ends of all.
struct ChainPoints {
  struct Point {
    glm::vec2 pixel;
    float w;  ///< ≤ 0 behind the eye
  };
  std::vector<Point> points;
  std::vector<float> lengths;  ///< of each chain, px

  /// Returns the points of a chain.
  std::span<const Point> of(const Chains& chains, std::size_t chain) const {
    return {points.data() + chains.first[chain] + chain,
            points.data() + chains.first[chain + 1] + chain + 1};
  }
};
ChainPoints pointsInPicture(const Chains& chains, const std::vector<Segment>& segments,
                            const PictureView& view);

/// Chains, and where they run.
struct DrawnChains {
  Chains chains;
  ChainPoints points;
};

/// Returns chains that hold every segment once, also across places where several meet and across
/// gaps: an end is joined to the nearest other end within 2 λ in the picture, at about the same
/// depth, that goes on in its direction. Segments that close gaps are added to `segments`.
DrawnChains joinedChains(std::vector<Segment>& segments, const PictureView& view);

/// Leaves out the chains of which `leaves` says so, by their index.
template <class Leaves>
void leaveOut(DrawnChains& drawn, const Leaves& leaves) {
  auto& [chains, drawnPoints] = drawn;
  std::vector<ChainPoints::Point>& points = drawnPoints.points;
  std::size_t kept = 0;
  std::uint32_t link = 0;
  for (std::size_t chain = 0; chain < chains.count(); ++chain) {
    const std::uint32_t first = chains.first[chain];
    const std::uint32_t last = chains.first[chain + 1];
    if (leaves(chain))
      continue;
    if (link != first) {
      std::copy(chains.links.begin() + first, chains.links.begin() + last,
                chains.links.begin() + link);
      std::copy_n(points.begin() + std::ptrdiff_t(first + chain), last - first + 1,
                  points.begin() + std::ptrdiff_t(link + kept));
    }
    chains.first[kept] = link;
    drawnPoints.lengths[kept++] = drawnPoints.lengths[chain];
    link += last - first;
  }
  chains.first[kept] = link;
  chains.first.resize(kept + 1);
  chains.links.resize(link);
  points.resize(link + kept);
  drawnPoints.lengths.resize(kept);
}

/// Returns the same lines through points at even distances of about half a λ, or those of them that
/// the joints leave, each with the move to its curve and the pen's pressure there; order and ends
/// of the chains stay. The curve is the line
/// averaged with a Gaussian's weights, applied twice so that round forms keep their size (J.
/// Tukey's twicing), and held to the bounds. It keeps the line's ends, and its corners, where it
/// turns by more than 60° within 4 λ.
std::vector<Segment> curved(const std::vector<Segment>& segments, const Chains& chains,
                            const PictureView& view, const CurveSettings& settings);
/// Does so where the chains' points are known.
std::vector<Segment> curved(const std::vector<Segment>& segments, const Chains& chains,
                            const ChainPoints& points, const PictureView& view,
                            const CurveSettings& settings);

}  // namespace sline::render
