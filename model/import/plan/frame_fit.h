// SPDX-License-Identifier: Apache-2.0
// Finds the frame in which surfaces whose files are silent about it lie where others show that they
// belong.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/import/plan/read_inputs.h"

namespace sline::model {

/// Says where a surface lies, in LPS, millimetres; one whose frame is open, as if its file were in
/// LPS.
struct LyingSurface {
  std::string name;
  Box box;
  glm::vec3 middle{0.0f};  ///< of its area, whatever its triangles' sizes
  bool onlySideOpen = false;
};

/// Returns where the part lies if its file is read in the frame.
LyingSurface lyingIn(const Part& part, Frame frame, const std::optional<glm::dmat4>& toWorld);
/// Returns where a structure of a scene lies.
LyingSurface lyingIn(const Node& structure);
/// Returns where a surface that lies so in one frame lies in the other.
LyingSurface readAgainAs(LyingSurface surface, Frame from, Frame to);

/// Holds surfaces whose frames are known, and those that are silent.
struct FrameSides {
  std::vector<LyingSurface> known;
  std::vector<LyingSurface> silent;  ///< read as LPS
};

/// Returns the middle of the part's surface, whatever its triangles' sizes, in LPS, millimetres, if
/// its file is read in the frame.
glm::vec3 middleInPatient(const Part& part, Frame frame, const std::optional<glm::dmat4>& toWorld);

struct FrameFit {
  std::optional<Frame> frame;  ///< the only one that fits
  std::string reason;
  bool none = false;  ///< there is something to fit in with, and neither LPS nor RAS does
};

/// Lays silent surfaces over known ones of the same names, such as the label volume from which
/// models were cut: a frame, mirrored ones included, that brings their middles within 2 mm of each
/// other decides where no other does.
FrameFit laidOverSameNames(const FrameSides& sides, const ReadInputs& read);

/// Finds out whether silent surfaces lie within what is known, or around it, if read as LPS and as
/// RAS: the known surfaces, those of scenes that they come into, too. That is a guess: boxes
/// overlap by chance, too. Scans say nothing, as they are kept or not, and are larger than a body.
FrameFit fittedIn(const FrameSides& sides);

}  // namespace sline::model
