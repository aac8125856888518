// SPDX-License-Identifier: Apache-2.0
// Finds which segments belong together. Neighbouring triangles give a line's segments exactly the
// same end point, so lines are found without tolerance.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/lines/ground/segments.h"

namespace sline::render {

/// Holds segments in the order in which a pen would draw them.
struct Chains {
  struct Link {
    std::uint32_t segment;
    bool reversed;  ///< drawn from b to a
  };
  std::vector<Link> links;           ///< chain after chain
  std::vector<std::uint32_t> first;  ///< start of each chain in `links`, and one past the last

  std::size_t count() const { return first.size() - 1; }
};

/// Marks shorter than `shortest` fade away; from `whole` on they are drawn in full. Zeros: no mark
/// fades.
struct Specks {
  float shortest = 0.0f;
  float whole = 0.0f;
};

/// Returns chains that hold every segment once. A chain ends where a line ends, or where more than
/// two segments meet.
Chains connectedChains(const std::vector<Segment>& segments);

/// Returns the length of each chain, mm.
std::vector<float> chainLengths(const Chains& chains, const std::vector<Segment>& segments);

/// Lowers the opacity of chains that are shorter than `specks.whole`, in the unit of `lengths`,
/// which has one for each chain: these are specks that the noise of a surface leaves and no pen
/// would draw. They fade, so that a line that grows while the scene turns does not pop.
void fadeShortChains(std::vector<Segment>& segments, const Chains& chains,
                     std::span<const float> lengths, const Specks& specks);

/// Returns the same lines with fewer segments: neighbours are joined while no point in between, of
/// the line or of its curve, leaves the joint segment by more than `tolerance` mm and it is no
/// longer than `longest` mm. Where a surface has many triangles to a pixel this removes most
/// segments of the drawing.
std::vector<Segment> simplified(const std::vector<Segment>& segments, const Chains& chains,
                                float tolerance, float longest);

}  // namespace sline::render
