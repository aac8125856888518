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

/// Returns the middle of the surface, whatever its triangles' sizes, in the file's coordinates.
glm::vec3 middleOf(const RawMesh& raw) {
  glm::dvec3 sum(0.0);
  double area = 0.0;
  for (const Triangle& t : raw.triangles) {
    const glm::dvec3 a(raw.positions[t[0]]);
    const glm::dvec3 b(raw.positions[t[1]]);
    const glm::dvec3 c(raw.positions[t[2]]);
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
  for (const Part* part : sides.silent)
    addPlace(silent, part->name, middleInPatient(*part, frame, {}));
  std::vector<float> distances;
  for (const auto& [name, place] : silent)
    if (const auto same = known.find(name); place && same != known.end() && same->second)
      distances.push_back(glm::length(*place - *same->second));
  std::sort(distances.begin(), distances.end());
  return distances;
}

/// Returns the box of the surface in the patient, if it is read in the frame.
Box boxIn(const Part& part, Frame frame, const std::optional<glm::dmat4>& toWorld) {
  Box own;
  for (const glm::vec3& p : part.raw.positions)
    own.add(p);
  const Provenance as = readAs(part, frame);
  Box box;
  if (!own.empty())
    for (const glm::vec3& corner : own.corners())
      box.add(placed(corner, as, part.raw, toWorld));
  return box;
}

Box knownBox(const FrameSides& sides, const ReadInputs& read) {
  Box box;
  for (const Part* part : sides.known)
    box.add(boxIn(*part, part->frame, toWorldOf(*part, read.sources)));
  if (read.scenes)
    for (const Node& node : read.scenes->scene.nodes())
      if (!node.isGroup() && node.provenance.frame != fileFrame &&
          node.provenance.evidence.isSure())
        box.add(node.mesh->bounds());
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
  return placed(middleOf(part.raw), readAs(part, frame), part.raw, toWorld);
}

FrameFit laidOverSameNames(const FrameSides& sides, const ReadInputs& read) {
  constexpr float near = 2.0f;  // millimetres
  NamedPlaces known;
  for (const Part* part : sides.known)
    addPlace(known, part->name,
             middleInPatient(*part, part->frame, toWorldOf(*part, read.sources)));
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

FrameFit fittedIn(const FrameSides& sides, const ReadInputs& read) {
  constexpr float fits = 0.9f;
  constexpr float fails = 0.6f;
  FrameFit fit;
  const Box known = knownBox(sides, read);
  if (known.empty() || sides.silent.empty())
    return fit;
  const auto share = [&](Frame frame) {
    Box box;
    for (const Part* part : sides.silent)
      box.add(boxIn(*part, frame, {}));
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
