// SPDX-License-Identifier: Apache-2.0
#include "app/cli/flags/section_flags.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "app/cli/files/names.h"
#include "app/cli/files/progress.h"
#include "model/edit/sections.h"

namespace sline::cli {

namespace {

using model::AnatomicalView;

struct PlaneName {
  std::string_view name;
  AnatomicalView smaller;  ///< the side where the coordinate is smaller
  AnatomicalView larger;
};
constexpr std::array<PlaneName, 3> planeNames{
    {{"sagittal", AnatomicalView::right, AnatomicalView::left},
     {"coronal", AnatomicalView::anterior, AnatomicalView::posterior},
     {"axial", AnatomicalView::inferior, AnatomicalView::superior}}};

std::string_view nameOf(AnatomicalView view) {
  return model::anatomicalViewNames[std::size_t(view)];
}

Error wrongSection(std::string_view text, const std::string& right) {
  return Error{.reason = "section \"" + std::string(text) + "\" is not understood",
               .remedy = "Give " + right};
}

std::optional<float> number(std::string_view text) {
  float value = 0.0f;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

/// Reads four numbers between commas: the plane nx·x + ny·y + nz·z = d.
std::optional<model::Plane> planeOf(std::string_view text) {
  std::array<double, 4> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t cut = std::min(text.find(','), text.size());
    const auto value = number(text.substr(0, cut));
    if (!value || (cut == text.size()) != (i == 3))
      return std::nullopt;
    values[i] = double(*value);
    text.remove_prefix(std::min(cut + 1, text.size()));
  }
  const glm::dvec3 normal(values[0], values[1], values[2]);
  const double length = glm::length(normal);
  if (!(length > 0.0))
    return std::nullopt;
  return model::Plane{glm::vec3(normal / length), float(values[3] / length)};
}

/// Returns the half away from the camera, which is kept; `middle` is a point of the cut.
AnatomicalView keptSide(int axis, const glm::vec3& middle, const model::Camera& camera) {
  constexpr float edgeOn = 0.2588f;  // sin 15°
  const PlaneName& plane = planeNames[std::size_t(axis)];
  return model::towardsEye(camera, middle)[axis] > edgeOn ? plane.smaller : plane.larger;
}

bool meets(const model::Plane& plane, const model::Box& box) {
  const auto above = glm::greaterThan(plane.normal, glm::vec3(0.0f));
  return !box.empty() && plane.distance(glm::mix(box.low, box.high, above)) > 0.0 &&
         plane.distance(glm::mix(box.high, box.low, above)) < 0.0;
}

bool meetsAny(const model::Scene& scene, const model::Section& section) {
  for (const model::NodeId id : scene.structuresBelow(section.scope))
    if (scene.resolve(id).visible && meets(section.plane, scene.find(id)->mesh->bounds()))
      return true;
  return false;
}

}  // namespace

Result<SectionText> parseSection(std::string_view text) {
  const std::string right =
      "sagittal, coronal or axial, with a place in mm and the side to keep where you like "
      "(sagittal, axial=120, coronal=-30:anterior), or nx,ny,nz,d for what is kept where "
      "nx*x + ny*y + nz*z <= d";
  SectionText section;
  section.text = text;
  section.plane = planeOf(text);
  if (section.plane)
    return section;
  const std::size_t colon = text.rfind(':');
  const std::string_view body = text.substr(0, colon);
  const std::size_t equals = body.find('=');
  const std::string name = model::normalisedName(body.substr(0, equals));
  const auto found = std::find_if(planeNames.begin(), planeNames.end(),
                                  [&name](const PlaneName& p) { return p.name == name; });
  if (found == planeNames.end())
    return wrongSection(text, right);
  section.axis = int(found - planeNames.begin());
  if (equals != std::string_view::npos) {
    section.mm = number(body.substr(equals + 1));
    if (!section.mm)
      return wrongSection(text, right);
  }
  if (colon != std::string_view::npos) {
    const std::string side = model::normalisedName(text.substr(colon + 1));
    section.kept = model::anatomicalViewNamed(side);
    if (!section.kept || model::axisOf(*section.kept) != section.axis)
      return Error{.reason = "a " + name + " section has no side \"" + side + "\"",
                   .remedy = "Keep " + std::string(nameOf(found->smaller)) + " or " +
                             std::string(nameOf(found->larger))};
  }
  return section;
}

Result<SectionsSpec> parseFlags(const SectionFlags& flags) {
  SectionsSpec spec;
  spec.groups = flags.groups;
  spec.hatched = flags.hatched;
  if (!flags.faces.empty()) {
    const auto faces = model::cutFacesNamed(flags.faces);
    if (!faces)
      return Error{.reason = "--section-faces does not know \"" + flags.faces + "\"",
                   .remedy = "Say off, tint or tissue"};
    spec.faces = *faces;
  }
  for (const std::string& text : flags.sections) {
    const SectionText section = TRY(parseSection(text));
    spec.sections.push_back(section);
  }
  if (flags.sections.empty() && (!flags.groups.empty() || flags.hatched || !flags.faces.empty()))
    return Error{.reason = "a section's group, faces or hatching is given without a section",
                 .remedy = "Add --section sagittal, coronal or axial"};
  return spec;
}

Result<model::Scene> sectioned(const model::Scene& scene, const SectionsSpec& spec,
                               const model::Camera& camera) {
  std::vector<model::NodeId> scopes;
  for (const std::string& name : spec.groups) {
    const auto ids = TRY(nodesNamed(scene, name));
    scopes.insert(scopes.end(), ids.begin(), ids.end());
  }
  if (scopes.empty())
    scopes.push_back(model::rootId);
  model::Scene result = scene;
  for (const SectionText& wanted : spec.sections) {
    bool met = false;
    // A place left open is the middle of all that is cut, so that the cut is one plane.
    model::Box bounds;
    for (const model::NodeId scope : scopes)
      bounds.add(scene.visibleBounds(scope));
    glm::vec3 middle = bounds.empty() ? glm::vec3(0.0f) : bounds.centre();
    middle[wanted.axis] = wanted.mm.value_or(middle[wanted.axis]);
    const AnatomicalView kept = wanted.kept.value_or(keptSide(wanted.axis, middle, camera));
    for (const model::NodeId scope : scopes) {
      model::Section section = model::anatomicalSection(scene, scope, kept, middle[wanted.axis]);
      if (wanted.plane)
        section.plane = *wanted.plane;
      section.name = wanted.text;
      section.faces = spec.faces;
      section.hatched = spec.hatched;
      model::Edited edited = model::withSection(result, section);
      if (!edited.changed)
        return Error{.reason = "more than " + std::to_string(model::maximumSections) +
                               " sections would cut one structure",
                     .remedy = "Give fewer sections"};
      met = met || meetsAny(result, section);
      result = std::move(edited.scene);
    }
    if (!met)
      warn("--section " + wanted.text + " meets no structure");
  }
  return result;
}

}  // namespace sline::cli
