// SPDX-License-Identifier: Apache-2.0
#include "render/drawn/face_patterns.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>
#include <utility>

#include "model/anatomy/cut_patterns.h"
#include "render/drawn/section_caps.h"

namespace sline::render {

namespace {

/// A face of more spacings across is drawn as far as it can be seen, in steps of as many spacings
/// as the second number says, so that a small move of the camera changes nothing.
constexpr double wholeFace = 240.0;
constexpr double windowStep = 32.0;
/// One step of depth: less than between a face and a smaller one within it (section_caps.cpp).
constexpr float patternLift = 1.2e-7f;

/// Returns the unit direction in which the mesh is longest: that of a muscle's fibres, as far as
/// its shape tells. It is the first principal axis of some of its triangles, weighted by area.
glm::vec3 longestAxis(const model::Mesh& mesh) {
  constexpr std::size_t samples = 4096;
  const auto triangles = mesh.triangles();
  const auto positions = mesh.positions();
  const glm::dvec3 origin(mesh.bounds().centre());
  double area = 0.0;
  glm::dvec3 mean(0.0);
  glm::dmat3 spread(0.0);
  for (std::size_t i = 0; i < triangles.size(); i += 1 + triangles.size() / samples) {
    const glm::dvec3 a(positions[triangles[i][0]]);
    const glm::dvec3 b(positions[triangles[i][1]]);
    const glm::dvec3 c(positions[triangles[i][2]]);
    const double weight = glm::length(glm::cross(b - a, c - a));
    const glm::dvec3 middle = (a + b + c) / 3.0 - origin;
    area += weight;
    mean += weight * middle;
    spread += weight * glm::outerProduct(middle, middle);
  }
  if (!(area > 0.0))
    return {0.0f, 0.0f, 1.0f};
  spread -= glm::outerProduct(mean, mean) / area;
  // Power iteration from the row that cannot be at right angles to the axis.
  const std::array<double, 3> own{spread[0][0], spread[1][1], spread[2][2]};
  glm::dvec3 axis = spread[int(std::max_element(own.begin(), own.end()) - own.begin())];
  for (int round = 0; round < 32 && glm::length(axis) > 0.0; ++round)
    axis = spread * glm::normalize(axis);
  const double length = glm::length(axis);
  return length > 0.0 ? glm::vec3(axis / length) : glm::vec3(0.0f, 0.0f, 1.0f);
}

/// Returns the millimetres that λ shows at the camera's target, or at the place of the scene that
/// is nearest to it: turning the camera about its target changes nothing.
double millimetresPerUnit(const PictureView& view) {
  const model::Box& box = view.bounds();
  const glm::vec3 at = glm::clamp(view.camera().target, box.low, box.high);
  return double(view.outputUnit()) * double(view.millimetresPerPixel(at));
}

/// Returns the part of a plane that the picture shows; nothing where the horizon is in sight.
std::optional<PlaneWindow> seenWindow(const model::Plane& plane, const PictureView& view,
                                      double step) {
  const model::PlaneAxes axes = model::axesOf(plane);
  const glm::dmat4 fromClip = glm::inverse(glm::dmat4(view.viewProjection()));
  const auto place = [&fromClip](double x, double y, double z) {
    const glm::dvec4 p = fromClip * glm::dvec4(x, y, z, 1.0);
    return glm::dvec3(p) / p.w;
  };
  PlaneWindow window{glm::dvec2(1e300), glm::dvec2(-1e300)};
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0}) {
      const glm::dvec3 from = place(x, y, -1.0);
      const glm::dvec3 way = place(x, y, 1.0) - from;
      const double slope = glm::dot(glm::dvec3(plane.normal), way);
      const double t = (double(plane.offset) - glm::dot(glm::dvec3(plane.normal), from)) / slope;
      if (!(std::abs(slope) > 1e-9) || !(std::abs(t) < 8.0) || (!view.eye().atInfinity && t < -0.5))
        return std::nullopt;
      const glm::dvec3 p = from + t * way;
      const glm::dvec2 at(glm::dot(axes.u, p), glm::dot(axes.v, p));
      window.low = glm::min(window.low, at);
      window.high = glm::max(window.high, at);
    }
  return PlaneWindow{(glm::floor(window.low / step) - 0.5) * step,
                     (glm::ceil(window.high / step) + 0.5) * step};
}

/// Tells whether the place lies inside the surface: a line along z crosses it an odd number of
/// times below and above.
bool isInside(const model::Mesh& mesh, const glm::dvec3& place) {
  std::array<int, 2> crossings{};
  for (const model::Triangle& triangle : mesh.triangles()) {
    const glm::dvec3 a = glm::dvec3(mesh.positions()[triangle[0]]) - place;
    const glm::dvec3 b = glm::dvec3(mesh.positions()[triangle[1]]) - place;
    const glm::dvec3 c = glm::dvec3(mesh.positions()[triangle[2]]) - place;
    const double u = b.x * c.y - b.y * c.x;
    const double v = c.x * a.y - c.y * a.x;
    const double w = a.x * b.y - a.y * b.x;
    const bool within = (u > 0.0 && v > 0.0 && w > 0.0) || (u < 0.0 && v < 0.0 && w < 0.0);
    if (within)
      ++crossings[(u * a.z + v * b.z + w * c.z) / (u + v + w) > 0.0 ? 1 : 0];
  }
  return crossings[0] % 2 == 1 && crossings[1] % 2 == 1;
}

/// Tells whether the inner surface begins inside the outer one.
bool isWithin(const model::Mesh& inner, const model::Mesh& outer) {
  const model::Box& box = outer.bounds();
  const model::Box& in = inner.bounds();
  if (inner.triangleCount() == 0 || !glm::all(glm::greaterThan(in.low, box.low)) ||
      !glm::all(glm::lessThan(in.high, box.high)))
    return false;
  // Surfaces of one grid have corners above each other: the line passes beside these.
  const glm::dvec3 aside = double(glm::length(box.size())) * glm::dvec3(1.37e-5, 2.11e-5, 0.0);
  return isInside(outer, glm::dvec3(inner.positions().front()) + aside);
}

}  // namespace

void Hulls::take(const model::Scene& scene) {
  std::vector<model::MeshPtr> meshes;
  meshes.reserve(scene.nodes().size());
  for (const model::Node& node : scene.nodes())
    if (!node.isGroup())
      meshes.push_back(node.mesh);
  if (meshes == m_meshes)
    return;
  m_meshes = std::move(meshes);
  m_known.clear();
}

bool Hulls::isAroundOthers(const model::MeshPtr& mesh) {
  const auto [place, fresh] = m_known.try_emplace(mesh);
  if (fresh)
    place->second = std::any_of(
        m_meshes.begin(), m_meshes.end(),
        [&mesh](const model::MeshPtr& other) { return other != mesh && isWithin(*other, *mesh); });
  return place->second;
}

model::CutPattern cutPattern(const model::Scene& scene, const model::Node& node, Hulls* hulls) {
  static const model::CutPatternTable table;
  for (const model::Node* at = &node; at; at = scene.find(at->parent))
    if (const auto pattern = table.match(at->name)) {
      const bool fatOfGroup = at != &node && *pattern == model::CutPattern::cells;
      return fatOfGroup ? model::CutPattern::rim : *pattern;
    }
  Hulls own;
  if (!hulls)
    own.take(scene);
  return (hulls ? *hulls : own).isAroundOthers(node.mesh) ? model::CutPattern::blank
                                                          : model::CutPattern::plain;
}

std::vector<FacePattern> facePatterns(const DrawnStructure& shown, const PictureView& view) {
  std::vector<FacePattern> patterns;
  if (!hasCaps(shown) || shown.pattern == model::CutPattern::plain)
    return patterns;
  const double unit = millimetresPerUnit(view);
  if (!(unit > 0.0))
    return patterns;
  TissuePatternRequest request{.pattern = shown.pattern, .spacing = patternSpacing(unit)};
  if (shown.pattern == model::CutPattern::fibres)
    request.fibres = longestAxis(*shown.mesh);
  for (std::size_t i = 0; i < shown.cut->faces.size(); ++i) {
    const CutFace& face = shown.cut->faces[i];
    const std::optional<PlaneWindow> whole = windowOf(face);
    if (!whole || !showsPattern(shown, i))
      continue;
    const glm::vec3 middle = 0.5f * (face.cap.front() + face.cap.back());
    const float facing = glm::dot(face.plane.normal, model::towardsEye(view.camera(), middle));
    if (!(facing > 0.02f))
      continue;
    const glm::dvec2 across = (whole->high - whole->low) / request.spacing;
    request.window = std::max(across.x, across.y) > wholeFace
                         ? seenWindow(face.plane, view, windowStep * request.spacing)
                         : std::nullopt;
    patterns.push_back(
        {.marks = shown.cut->patterns->at(i, request,
                                          [&] {
                                            const auto others = otherPlanes(*shown.cut->surface,
                                                                            shown.cut->planes, i);
                                            return tissuePattern(face, others, request);
                                          }),
         .depthPlane = capDepth(shown, view, i) - glm::vec3(0.0f, 0.0f, patternLift),
         .millimetresPerPixel = float(unit) / view.outputUnit(),
         .width = std::clamp(1.6f * facing, 0.0f, 1.0f)});
  }
  return patterns;
}

}  // namespace sline::render
