// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/frame_fit.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <map>

#include "model/anatomy/name_words.h"
#include "model/import/naming/laterality.h"
#include "model/import/plan/shape_parts.h"
#include "model/scene/known_frame.h"

namespace sline::model {

namespace {

Provenance readAs(const Part& part, Frame frame) {
  Provenance as;
  as.frame = frameName(frame);
  as.mmPerUnit = part.unit;
  return as;
}

/// Returns the middle of the surface, whatever its triangles' sizes, in its own coordinates.
glm::vec3 middleOf(std::span<const glm::vec3> positions, std::span<const Triangle> triangles) {
  glm::dvec3 sum(0.0);
  double area = 0.0;
  for (const Triangle& t : triangles) {
    const glm::dvec3 a(positions[t[0]]);
    const glm::dvec3 b(positions[t[1]]);
    const glm::dvec3 c(positions[t[2]]);
    const double own = glm::length(glm::cross(b - a, c - a));
    sum += own * (a + b + c) / 3.0;
    area += own;
  }
  return area > 0.0 ? glm::vec3(sum / area) : glm::vec3(0.0f);
}

/// Places by the words of their names; nothing where several have a name.
using NamedPlaces = std::map<std::string, std::optional<glm::vec3>>;

std::string wordsKey(const std::string& name) {
  std::string key;
  for (const std::string& word : nameWords(name))
    key += word + ' ';
  return key;
}

void addPlace(NamedPlaces& places, const std::string& name, const glm::vec3& place) {
  if (const auto [found, fresh] = places.try_emplace(wordsKey(name), place); !fresh)
    found->second.reset();
}

/// Returns the distances of silent surfaces from known places of their names, in ascending order.
std::vector<float> distancesIn(const FrameSides& sides, const NamedPlaces& known, Frame frame) {
  NamedPlaces silent;
  for (const LyingSurface& surface : sides.silent)
    addPlace(silent, surface.name, readAgainAs(surface, Frame::lps, frame).middle);
  std::vector<float> distances;
  for (const auto& [name, place] : silent)
    if (const auto same = known.find(name); place && same != known.end() && same->second)
      distances.push_back(glm::length(*place - *same->second));
  std::sort(distances.begin(), distances.end());
  return distances;
}

Box knownBox(const FrameSides& sides) {
  Box box;
  for (const LyingSurface& surface : sides.known)
    box.add(surface.box);
  return box;
}

/// Returns how much of the smaller of two boxes lies in the other, 0 to 1.
float sharedPart(const Box& a, const Box& b) {
  constexpr float slack = 5.0f;  // millimetres, so that flat ones have a content
  float shared = 1.0f;
  float first = 1.0f;
  float second = 1.0f;
  for (int axis = 0; axis < 3; ++axis) {
    const float low = std::max(a.low[axis], b.low[axis]) - slack;
    const float high = std::min(a.high[axis], b.high[axis]) + slack;
    shared *= std::max(0.0f, high - low);
    first *= a.size()[axis] + 2.0f * slack;
    second *= b.size()[axis] + 2.0f * slack;
  }
  return shared / std::min(first, second);
}

}  // namespace

glm::vec3 middleInPatient(const Part& part, Frame frame, const std::optional<glm::dmat4>& toWorld) {
  return placed(middleOf(part.raw.positions, part.raw.triangles), readAs(part, frame), part.raw,
                toWorld);
}

LyingSurface lyingIn(const Part& part, Frame frame, const std::optional<glm::dmat4>& toWorld) {
  LyingSurface surface{.name = part.name,
                       .middle = middleInPatient(part, frame, toWorld),
                       .onlySideOpen = part.raw.onlySideOpen};
  Box own;
  for (const glm::vec3& p : part.raw.positions)
    own.add(p);
  const Provenance as = readAs(part, frame);
  if (!own.empty())
    for (const glm::vec3& corner : own.corners())
      surface.box.add(placed(corner, as, part.raw, toWorld));
  return surface;
}

LyingSurface lyingIn(const Node& structure) {
  const Mesh& mesh = *structure.mesh;
  return {.name = structure.name,
          .box = mesh.bounds(),
          .middle = middleOf(mesh.positions(), mesh.triangles())};
}

LyingSurface readAgainAs(LyingSurface surface, Frame from, Frame to) {
  const FrameAxes before = axesIn(from, surface.onlySideOpen);
  const FrameAxes after = axesIn(to, surface.onlySideOpen);
  const glm::vec3 signs(before.left == after.left ? 1.0f : -1.0f,
                        before.posterior == after.posterior ? 1.0f : -1.0f, 1.0f);
  surface.middle *= signs;
  if (surface.box.empty())
    return surface;
  Box box;
  box.add(surface.box.low * signs);
  box.add(surface.box.high * signs);
  surface.box = box;
  return surface;
}

FrameFit laidOverSameNames(const FrameSides& sides, const ReadInputs& read) {
  constexpr float near = 2.0f;  // millimetres
  NamedPlaces known;
  for (const LyingSurface& surface : sides.known)
    addPlace(known, surface.name, surface.middle);
  for (const LeftOutTwin& twin : read.twins)
    addPlace(known, twin.name, twin.middle);
  FrameFit fit;
  // A mirrored frame counts where neither of the usual ones fits.
  for (const auto& some :
       {std::array{Frame::lps, Frame::ras}, std::array{Frame::las, Frame::rps}}) {
    std::vector<Frame> fitting;
    std::size_t count = 0;
    for (const Frame frame : some)
      if (const std::vector<float> distances = distancesIn(sides, known, frame);
          !distances.empty() && distances[distances.size() / 2] <= near) {
        fitting.push_back(frame);
        count = distances.size();
      }
    if (fitting.size() == 1)
      return {fitting.front(),
              "laid over surfaces of the same names: " + std::to_string(count) + " within 2 mm",
              false};
    if (!fitting.empty())
      return fit;
  }
  return fit;
}

FrameFit fittedIn(const FrameSides& sides) {
  constexpr float fits = 0.9f;
  constexpr float fails = 0.6f;
  FrameFit fit;
  const Box known = knownBox(sides);
  if (known.empty() || sides.silent.empty())
    return fit;
  const auto share = [&](Frame frame) {
    Box box;
    for (const LyingSurface& surface : sides.silent)
      box.add(readAgainAs(surface, Frame::lps, frame).box);
    return box.empty() ? 0.0f : sharedPart(box, known);
  };
  const float lps = share(Frame::lps);
  const float ras = share(Frame::ras);
  if (std::max(lps, ras) >= fits && std::min(lps, ras) <= fails) {
    fit.frame = lps > ras ? Frame::lps : Frame::ras;
    fit.reason = "fits in with the other surfaces";
  }
  fit.none = std::max(lps, ras) <= 0.1f;
  return fit;
}

}  // namespace sline::model
