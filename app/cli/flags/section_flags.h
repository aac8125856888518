// SPDX-License-Identifier: Apache-2.0
// Declares the flags that cut a scene open, shared by `render`, `demo` and `lines`.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"
#include "model/scene/scene.h"

namespace sline::cli {

/// Holds the flags as typed.
struct SectionFlags {
  std::vector<std::string> sections;
  std::vector<std::string> groups;
  std::string faces;  ///< empty: as sections are by default
  bool hatched = false;
};

/// Holds an anatomical plane with its place or kept side possibly left open, or any plane.
struct SectionText {
  std::string text;
  int axis = 0;  ///< in LPS
  std::optional<float> mm;
  std::optional<model::AnatomicalView> kept;
  std::optional<model::Plane> plane;  ///< where present, it says everything
};

struct SectionsSpec {
  std::vector<SectionText> sections;
  std::vector<std::string> groups;  ///< empty: the whole scene
  model::CutFaces faces = model::Section().faces;
  bool hatched = false;
};

/// Reads "sagittal", "axial=12", "coronal=-30:anterior" or "nx,ny,nz,d". A side names what is kept.
Result<SectionText> parseSection(std::string_view text);
/// Reads the flags. An error counts as wrong use, here and in `sectioned`.
Result<SectionsSpec> parseFlags(const SectionFlags& flags);

/// Returns the scene with the sections added. A section without a named side keeps the side away
/// from the camera, so that the cut face is seen; seen within 15° of edge-on it keeps left,
/// posterior or superior. Warns of sections that meet nothing.
Result<model::Scene> sectioned(const model::Scene& scene, const SectionsSpec& spec,
                               const model::Camera& camera);

}  // namespace sline::cli
