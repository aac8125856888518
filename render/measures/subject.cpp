// SPDX-License-Identifier: Apache-2.0
#include "render/measures/subject.h"

#include <array>
#include <cassert>

#include "model/edit/look.h"

namespace sline::render {

model::Scene isolated(const model::Scene& scene, model::NodeId structure) {
  const model::Node* found = scene.find(structure);
  assert(found && !found->isGroup());
  model::Node node = *found;
  node.parent = model::rootId;
  node.style = model::lookOf(scene, structure);
  node.style.opacity = Opacity::clamped(1.0f);
  node.style.fill = model::Fill::none;
  node.style.visible = true;
  model::Scene result;
  result.append(std::move(node));
  return result;
}

model::Scene Subject::at(Gamma gamma) const {
  return model::withLook(scene, std::array{structure().id}, {.gamma = gamma}).scene;
}

RampPictures rampPictures(const DrawPicture& draw, const Subject& subject,
                          std::function<void(Gamma, const Image&)> onPicture) {
  RampPictures pictures;
  pictures.whole = [draw, &subject, onPicture = std::move(onPicture)](Gamma gamma) {
    Result<Image> image =
        draw(subject.at(gamma), subject.camera, {.width = subject.width, .height = subject.height});
    if (image.ok() && onPicture)
      onPicture(gamma, *image);
    return image;
  };
  pictures.fill = [draw, &subject](Gamma gamma) {
    return draw(subject.at(gamma), subject.camera,
                {.width = subject.width,
                 .height = subject.height,
                 .environment = {.background = Background::transparent},
                 .parts = {.lines = false, .hatching = false, .fills = true}});
  };
  return pictures;
}

Result<Steadiness> measureSteadiness(const DrawPicture& draw, const Subject& subject,
                                     const SteadinessSettings& settings) {
  const std::array<HatchingWay, 2> ways{
      {{hatchingPicture(draw, subject, settings.gamma, HatchingMethod::strokes),
        settings.oversampling},
       {hatchingPicture(draw, subject, settings.gamma, HatchingMethod::asPrinted)}}};
  const auto flickers = measureFlicker({.mesh = subject.structure().mesh,
                                        .camera = subject.camera,
                                        .width = subject.width,
                                        .height = subject.height,
                                        .frames = settings.frames},
                                       ways);
  if (!flickers.ok()) {
    Error error = flickers.error();
    error.where = subject.structure().name;
    return error;
  }
  return Steadiness{.strokes = flickers->front(), .asPrinted = flickers->back()};
}

HatchingPicture hatchingPicture(const DrawPicture& draw, const Subject& subject, Gamma gamma,
                                HatchingMethod method) {
  model::Style patch;
  patch.gamma = gamma;
  patch.inkColour = Colour{0, 0, 0};
  const model::Scene scene =
      model::withLook(subject.scene, std::array{subject.structure().id}, patch).scene;
  return [draw, scene, method](const model::Camera& camera, int width, int height) {
    return draw(scene, camera,
                {.width = width,
                 .height = height,
                 .hatching = method,
                 .parts = {.lines = false, .hatching = true, .fills = false}});
  };
}

}  // namespace sline::render
