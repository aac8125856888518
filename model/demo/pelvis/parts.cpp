// SPDX-License-Identifier: Apache-2.0
#include "model/demo/pelvis/parts.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <utility>

#include "model/demo/pelvis/bones.h"
#include "model/sculpting/sampled_field.h"

namespace sline::model {

// Structures in focus are shaded, vessels and nerves are hatched in the ink of their kind, muscles
// are contours over a wash of their colour.
const Palette musclePalette{"Muscles", {158, 70, 58}, 1.4f, Fill::tint, 2.6f, 0.8f, muscleInk};
const Palette organPalette{"Organs", {214, 160, 128}, 4.5f, Fill::paper, 2, 0.6f};
const Palette arteryPalette{"Arteries", {207, 40, 28},      3, Fill::paper, 1.4f,
                            0.25f,      Colour{168, 28, 20}};
const Palette veinPalette{"Veins", {52, 92, 176}, 3, Fill::paper, 1.3f, 0.3f, Colour{31, 70, 143}};
const Palette nervePalette{"Nerves", {240, 208, 60},      3, Fill::paper, 1.3f,
                           0.25f,    Colour{140, 108, 12}};

namespace {
template <class Part>
Shape shapeAround(Part part) {
  const Box box = part.bounds();
  return {[part = std::move(part)](const glm::vec3& p) { return part.distance(p); }, box};
}
}  // namespace

Shape shapeOf(Tube tube) {
  return shapeAround(std::move(tube));
}
Shape shapeOf(Band band) {
  return shapeAround(std::move(band));
}
Shape shapeOf(Lamina lamina) {
  return shapeAround(std::move(lamina));
}
Shape shapeOf(Blob blob) {
  return shapeAround(blob);
}

Shape smoothed(Lamina lamina, float smoothing) {
  const Box box = grown(lamina.bounds(), 2.0f * smoothing + 4.0f);
  const auto sheet = std::make_shared<const Lamina>(std::move(lamina));
  const auto everywhere = [sheet](const glm::vec3&, float) -> Field {
    return [sheet](const glm::vec3& p) { return sheet->distance(p); };
  };
  const auto samples = std::make_shared<const SampledField>(
      everywhere, box, SampledField::Fineness{0.7f * smoothing, smoothing});
  return {[samples](const glm::vec3& p) { return samples->distance(p); },
          grown(sheet->bounds(), 1)};
}

Shape branching(std::vector<Tube> tubes, float blend) {
  const Box box = boundsOf(std::span<const Tube>(tubes));
  return {[tubes = std::move(tubes), blend](const glm::vec3& p) {
            return blended(std::span<const Tube>(tubes), p, blend);
          },
          box};
}

Shape merged(Shape a, Shape b, float blend) {
  Box box = a.box;
  box.add(b.box);
  return {[a = std::move(a.field), b = std::move(b.field), blend](const glm::vec3& p) {
            return blendedUnion(a(p), b(p), blend);
          },
          box};
}

Shape cutOff(Shape shape, const glm::vec3& point, const glm::vec3& normal, float rounding) {
  const glm::vec3 n = glm::normalize(normal);
  return {[field = std::move(shape.field), point, n, rounding](const glm::vec3& p) {
            return blendedDifference(field(p), glm::dot(point - p, n), rounding);
          },
          shape.box};
}

Field beyondPlane(const glm::vec3& point, const glm::vec3& normal, float reach) {
  return [point, n = glm::normalize(normal), reach](const glm::vec3& p) {
    return std::max(glm::dot(point - p, n), glm::distance(point, p) - reach);
  };
}

Field anyOf(std::vector<Field> fields) {
  return [fields = std::move(fields)](const glm::vec3& p) {
    float d = fields.front()(p);
    for (std::size_t i = 1; i < fields.size(); ++i)
      d = std::min(d, fields[i](p));
    return d;
  };
}

Shape rippled(Shape shape, float wavelength, float height, float phase) {
  return {[field = std::move(shape.field), wavelength, height, phase](const glm::vec3& p) {
            const float d = field(p);
            // Far from the surface a wave is not worth its cost.
            return std::abs(d) > 4.0f * height + 4.0f ? d : d - height * wave(p, wavelength, phase);
          },
          grown(shape.box, height)};
}

Shape mirrored(const Shape& shape) {
  return {mirrored(shape.field, pelvisMiddle), mirrored(shape.box, pelvisMiddle)};
}

DemoStructure structure(const Palette& palette, std::string name, Shape shape) {
  return {.name = std::move(name),
          .groups = {palette.group},
          .colour = palette.colour,
          .gamma = Gamma::clamped(palette.gamma),
          .fill = palette.fill,
          .inkColour = palette.inkColour,
          .field = std::move(shape.field),
          .box = grown(shape.box, 2.5f * palette.edge),
          .edge = palette.edge,
          .gap = palette.gap,
          .rounding = palette.gap + 0.5f};
}

DemoStructure withCavity(DemoStructure body, Field cavity) {
  body.opening = std::move(cavity);
  return body;
}

void addPair(std::vector<DemoStructure>& list, const Palette& palette, const std::string& name,
             const Shape& left) {
  list.push_back(structure(palette, "left " + name, left));
  list.push_back(structure(palette, "right " + name, mirrored(left)));
}

}  // namespace sline::model
