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
    const auto nodes = nodesNamed(scene, name);
    if (!nodes.ok())
      return nodes.error();
    for (const model::NodeId node : *nodes)
      for (const model::NodeId id : scene.structuresBelow(node))
        if (std::find(found.begin(), found.end(), id) == found.end())
          found.push_back(id);
  }
  return found;
}

Result<PictureSpec> pictureSpecOf(const MeasureFlags& flags) {
  PictureSpec spec;
  spec.view = flags.view;
  const Result<Size> size = parseSize(flags.size);
  if (!size.ok())
    return size.error();
  spec.size = *size;
  if (const Status taken = takeCamera(flags.cameraFile, spec); !taken.ok())
    return taken.error();
  return spec;
}

}  // namespace

Result<MeasureSpec> readMeasureSpec(const MeasureFlags& flags, Progress& progress, bool& wrongUse) {
  wrongUse = true;
  const Result<model::ImportOptions> options = importOptions(flags.input);
  if (!options.ok())
    return options.error();
  const Result<PictureSpec> picture = pictureSpecOf(flags);
  if (!picture.ok())
    return picture.error();
  wrongUse = false;
  Result<model::Imported> imported = readInputs(flags.input, *options, progress);
  if (!imported.ok())
    return imported.error();
  wrongUse = true;
  const auto structures = chosen(imported->scene, flags);
  if (!structures.ok())
    return structures.error();
  return MeasureSpec{
      .scene = std::move(imported->scene), .structures = *structures, .picture = *picture};
}

Result<render::Subject> subjectOf(const MeasureSpec& spec, model::NodeId structure) {
  render::Subject subject{.scene = render::isolated(spec.scene, structure),
                          .width = spec.picture.size.width,
                          .height = spec.picture.size.height};
  subject.scene.setViews(spec.scene.views());
  const Result<model::Camera> camera = cameraFor(subject.scene, spec.picture);
  if (!camera.ok())
    return camera.error();
  subject.camera = *camera;
  return subject;
}

}  // namespace sline::cli
