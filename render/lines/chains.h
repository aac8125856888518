// SPDX-License-Identifier: Apache-2.0
// Which segments hang together. Neighbouring triangles give a line's segments the very same end
// point, so lines are found without tolerance.
#pragma once

#include <cstdint>
#include <vector>

#include "render/lines/lines.h"

namespace sline::render {

/// Segments in the order a pen would draw them.
struct Chains {
  struct Link {
    std::uint32_t segment;
    bool reversed;  ///< drawn from b to a
  };
  std::vector<Link> links;           ///< chain after chain
  std::vector<std::uint32_t> first;  ///< of each chain in `links`, and one past the last

  std::size_t count() const { return first.size() - 1; }
};

/// Every segment once. A chain ends where a line ends, or where more than two segments meet.
Chains connectedChains(const std::vector<Segment>& segments);

/// Length of each chain, mm.
std::vector<float> chainLengths(const Chains& chains, const std::vector<Segment>& segments);

/// Lowers the opacity of chains shorter than `whole` mm, to nothing at `none` mm: specks that the
/// noise of a surface leaves, which no pen would draw. Fades, so that a line that grows while the
/// scene turns does not pop.
void fadeShortChains(std::vector<Segment>& segments, const Chains& chains, float none, float whole);

/// The same lines with fewer segments: neighbours are joined while no point in between leaves the
/// joint segment by more than `tolerance` mm and it is no longer than `longest` mm. Where a surface
/// has many triangles to a pixel this is most of the drawing.
std::vector<Segment> simplified(const std::vector<Segment>& segments, const Chains& chains,
                                float tolerance, float longest);

}  // namespace sline::render
