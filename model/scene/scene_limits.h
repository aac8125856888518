// SPDX-License-Identifier: Apache-2.0
// Says what a scene may hold, in one place for all: readers of files bring what they make within
// these limits and say what they had to mend, edits beyond them are refused, and the reader of
// scene files asks for no more. So a scene that is within them is read again as it was written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/scene/scene.h"

namespace sline::model {

inline constexpr std::size_t mostSceneNodes = 100'000;
inline constexpr std::size_t mostSceneLabels = 100'000;
inline constexpr std::size_t mostSceneSections = 10'000;
inline constexpr std::size_t mostSceneViews = 10'000;
inline constexpr std::size_t mostSceneScans = 64;
/// So many groups may lie in each other.
inline constexpr std::size_t deepestSceneGroup = 256;
/// A scan's voxels along an axis.
inline constexpr int longestScanSide = 65'535;
/// The most bytes of a name or of any other text of one line, and of what is written to be read.
inline constexpr std::size_t longestSceneName = 1000;
inline constexpr std::size_t longestSceneText = 100'000;
/// A text may be there in so many languages besides the scene's own.
inline constexpr std::size_t mostTextLanguages = 200;
inline constexpr std::size_t longestLanguageTag = 64;
/// Ids up to this one stay exact in programs whose only numbers are doubles.
inline constexpr std::uint64_t largestId = std::uint64_t(1) << 53;
/// Atoms lie within this distance of the origin on each axis, in mm, and are no larger.
inline constexpr float farthestAtom = 1e6f;
inline constexpr float largestAtom = 100.0f;

/// Says what a scene may not hold, and what was done about it.
struct SceneMending {
  std::string where;  ///< "structure \"Liver\""; empty for the scene as a whole
  std::string fault;  ///< "the name is longer than 1000 bytes"
  std::string done;   ///< "it was cut there"

  /// Returns it as one line.
  std::string text() const;
  bool operator==(const SceneMending&) const = default;
};

/// Brings the scene within the limits and adds what was mended: texts are cut or become UTF-8,
/// numbers that cannot be are left out, and so is what makes no sense without them. An error where
/// there is more of something than a scene may hold, which no one but a person can choose from.
Status bringWithinLimits(Scene& scene, std::vector<SceneMending>& mended);

/// Returns why the scene cannot be kept as it is, to refuse an edit; absent where it can. What is
/// as in a scene that is known to be within the limits is not looked at again.
std::optional<Error> limitFault(const Scene& scene, const Scene& kept = {});

}  // namespace sline::model
