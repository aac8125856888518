// SPDX-License-Identifier: Apache-2.0
#include "app/cli/flags/measure_flags.h"

#include <algorithm>

#include "app/cli/files/names.h"

namespace sline::cli {

namespace {

Result<std::vector<model::NodeId>> chosen(const model::Scene& scene, const MeasureFlags& flags) {
  const std::vector<model::NodeId> everything = scene.structuresBelow(model::rootId);
  if (flags.all || (flags.structures.empty() && everything.size() == 1))
    return everything;
  if (flags.structures.empty())
    return Error{.reason = "the scene has " + std::to_string(everything.size()) + " structures",
                 .remedy = "Name one with --structure, or measure each with --all"};
  std::vector<model::NodeId> found;
  for (const std::string& name : flags.structures) {
    const auto nodes = TRY(nodesNamed(scene, name));
    for (const model::NodeId node : nodes)
      for (const model::NodeId id : scene.structuresBelow(node))
        if (std::find(found.begin(), found.end(), id) == found.end())
          found.push_back(id);
  }
  return found;
}

Result<PictureSpec> pictureSpecOf(const MeasureFlags& flags) {
  PictureSpec spec;
  spec.view = flags.view;
  spec.size = TRY(parseSize(flags.size));
  TRY(takeCamera(flags.cameraFile, spec));
  return spec;
}

}  // namespace

Result<MeasureSpec> readMeasureSpec(const MeasureFlags& flags, Progress& progress, bool& wrongUse) {
  wrongUse = true;
  const model::ImportOptions options = TRY(importOptions(flags.input));
  const PictureSpec picture = TRY(pictureSpecOf(flags));
  wrongUse = false;
  model::Imported imported = TRY(readInputs(flags.input, options, progress));
  wrongUse = true;
  const auto structures = TRY(chosen(imported.scene, flags));
  return MeasureSpec{
      .scene = std::move(imported.scene), .structures = structures, .picture = picture};
}

Result<render::Subject> subjectOf(const MeasureSpec& spec, model::NodeId structure) {
  render::Subject subject{.scene = render::isolated(spec.scene, structure),
                          .width = spec.picture.size.width,
                          .height = spec.picture.size.height};
  subject.scene.setViews(spec.scene.views());
  subject.camera = TRY(cameraFor(subject.scene, spec.picture));
  return subject;
}

}  // namespace sline::cli
