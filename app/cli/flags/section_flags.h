// SPDX-License-Identifier: Apache-2.0
// The flags that cut a scene open, shared by `render`, `demo` and `lines`.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"
#include "model/scene/scene.h"

namespace sline::cli {

/// As typed.
struct SectionFlags {
  std::vector<std::string> sections;
  std::vector<std::string> groups;
  bool hatched = false;
};

/// An anatomical plane whose place or kept side may be left open, or any plane.
struct SectionText {
  std::string text;
  int axis = 0;  ///< of LPS
  std::optional<float> mm;
  std::optional<model::AnatomicalView> kept;
  std::optional<model::Plane> plane;  ///< where present, all there is to say
};

struct SectionsOrder {
  std::vector<SectionText> sections;
  std::vector<std::string> groups;  ///< none: the whole scene
  bool hatched = false;
};

/// "sagittal", "axial=12", "coronal=-30:anterior" or "nx,ny,nz,d". A side names what is kept.
Result<SectionText> parseSection(std::string_view text);
/// An error is a wrong use, here and in the next.
Result<SectionsOrder> understood(const SectionFlags& flags);

/// The scene with the sections added. Where none of its sides is named, a section keeps the side
/// away from the camera, so that the cut face is seen; seen within 15° of edge-on it keeps left,
/// posterior or superior. Warns of sections that meet nothing.
Result<model::Scene> sectioned(const model::Scene& scene, const SectionsOrder& order,
                               const model::Camera& camera);

}  // namespace sline::cli
