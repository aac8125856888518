// SPDX-License-Identifier: Apache-2.0
// The soft parts of the demo pelvis, by system, and what their makers share. Frame LPS in
// millimetres; modelled in a man's pelvis whose midline is x = pelvisMiddle.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/sculpting/demo_structure.h"
#include "model/sculpting/lamina.h"

namespace sline::model {

/// A field and the box that holds its surface.
struct Shape {
  Field field;
  Box box;
};

Shape shapeOf(Tube tube);
Shape shapeOf(Band band);
Shape shapeOf(Lamina lamina);
Shape shapeOf(Blob blob);
/// A thick sheet whose small unevenness is smoothed away, over about that many mm.
Shape smoothed(Lamina lamina, float smoothing);
/// Tubes that branch off each other, blended where they meet.
Shape branching(std::vector<Tube> tubes, float blend);
Shape merged(Shape a, Shape b, float blend);
/// The body less what lies beyond the plane through `point`, on the side its normal points to; the
/// edge is rounded over that many mm.
Shape cutOff(Shape shape, const glm::vec3& point, const glm::vec3& normal, float rounding = 0.8f);
/// What lies within `reach` mm of the point, beyond the plane there on the side its normal points
/// to.
Field beyondPlane(const glm::vec3& point, const glm::vec3& normal, float reach);
/// In any of the fields.
Field anyOf(std::vector<Field> fields);
/// The surface raised and lowered by up to `height` mm in waves.
Shape rippled(Shape shape, float wavelength, float height, float phase);
Shape mirrored(const Shape& shape);

/// How one group of structures looks unless told otherwise.
struct Palette {
  const char* group;
  Colour colour;
  float gamma;
  std::optional<Fill> fill;
  float edge;  ///< mm
  float gap;   ///< mm kept clear of what it gives way to
  std::optional<Colour> inkColour = std::nullopt;
};
extern const Palette musclePalette;
extern const Palette organPalette;
extern const Palette arteryPalette;
extern const Palette veinPalette;
extern const Palette nervePalette;

DemoStructure structure(const Palette& palette, std::string name, Shape shape);
/// The body with that cavity, which must reach the outside.
DemoStructure withCavity(DemoStructure body, Field cavity);
/// "left NAME" and its mirror image "right NAME".
void addPair(std::vector<DemoStructure>& list, const Palette& palette, const std::string& name,
             const Shape& left);

std::vector<DemoStructure> pelvisMuscles();
/// Bladder, rectum, sigmoid colon, ureters; the tumour of the rectum.
std::vector<DemoStructure> pelvisOrgans(Sex sex);
std::vector<DemoStructure> maleOrgans();
std::vector<DemoStructure> femaleOrgans();
std::vector<DemoStructure> pelvisArteries();
std::vector<DemoStructure> pelvisVeins();
std::vector<DemoStructure> pelvisNerves();

}  // namespace sline::model
