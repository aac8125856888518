// SPDX-License-Identifier: Apache-2.0
// Declares the soft parts of the demo pelvis, by system, and the tools shared by the code that
// models them. Frame LPS in millimetres; modelled in a man's pelvis whose midline is x =
// pelvisMiddle.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/sculpting/demo_structure.h"
#include "model/sculpting/lamina.h"

namespace sline::model {

/// Holds a field and the box that contains its surface.
struct Shape {
  Field field;
  Box box;
};

Shape shapeOf(Tube tube);
Shape shapeOf(Band band);
Shape shapeOf(Lamina lamina);
Shape shapeOf(Blob blob);
/// Returns a thick sheet whose small unevenness is smoothed away, over about that many mm.
Shape smoothed(Lamina lamina, float smoothing);
/// Returns tubes that branch off each other, blended where they meet.
Shape branching(std::vector<Tube> tubes, float blend);
Shape merged(Shape a, Shape b, float blend);
/// Returns the shape without the part beyond the plane through `point`, on the side its normal
/// points to; the edge is rounded over that many mm.
Shape cutOff(Shape shape, const glm::vec3& point, const glm::vec3& normal, float rounding = 0.8f);
/// Returns the region within `reach` mm of the point, beyond the plane there on the side its normal
/// points to.
Field beyondPlane(const glm::vec3& point, const glm::vec3& normal, float reach);
/// Returns the union of the fields.
Field anyOf(std::vector<Field> fields);
/// Returns the shape with its surface raised and lowered by up to `height` mm in waves.
Shape rippled(Shape shape, float wavelength, float height, float phase);
Shape mirrored(const Shape& shape);

/// Says how the structures of one group look by default.
struct Palette {
  const char* group;
  Colour colour;
  float gamma;
  std::optional<Fill> fill;
  float edge;  ///< mm
  float gap;   ///< mm kept clear of the structures it gives way to
  std::optional<Colour> inkColour = std::nullopt;
};
extern const Palette musclePalette;
extern const Palette organPalette;
extern const Palette arteryPalette;
extern const Palette veinPalette;
extern const Palette nervePalette;

DemoStructure structure(const Palette& palette, std::string name, Shape shape);
/// Returns the body with that cavity, which must reach the outside.
DemoStructure withCavity(DemoStructure body, Field cavity);
/// Adds "left NAME" and its mirror image "right NAME".
void addPair(std::vector<DemoStructure>& list, const Palette& palette, const std::string& name,
             const Shape& left);

std::vector<DemoStructure> pelvisMuscles();
/// Models bladder, rectum, sigmoid colon, ureters, and the tumour of the rectum.
std::vector<DemoStructure> pelvisOrgans(Sex sex);
std::vector<DemoStructure> maleOrgans();
std::vector<DemoStructure> femaleOrgans();
std::vector<DemoStructure> pelvisArteries();
std::vector<DemoStructure> pelvisVeins();
std::vector<DemoStructure> pelvisNerves();

}  // namespace sline::model
