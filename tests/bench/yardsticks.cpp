// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/yardsticks.h"

#include <string>
#include <utility>

#include "model/disk/whole_file.h"
#include "model/scene_file/ply_writer.h"
#include "model/scene_file/scene_file.h"
#include "render/gpu/headless/context.h"
#include "render/vectors/vector_drawing.h"
#include "tests/bench/gamma_drag.h"
#include "tests/bench/plain_phong.h"
#include "tests/bench/vtk_phong.h"

namespace sline::bench {

Status measurePhong(const Stage& stage, Report& report) {
  auto plain = PlainPhong::create(stage.settings.width, stage.settings.height);
  if (!plain)
    return plain.error();
  const auto phong = timed(stage.frames, stage.camera, [&](const model::Camera& camera) {
    (*plain)->draw(stage.scene, camera);
    return Status(Unit{});
  });
  if (!phong)
    return phong.error();
  report.phong = spreadOf(*phong);
  return Unit{};
}

Status measureVectors(const Stage& stage, Report& report) {
  const float aspect = float(stage.settings.width) / float(stage.settings.height);
  const Stopwatch watch;
  const auto drawing =
      render::drawVectors(stage.scene, stage.camera, {.sizeMm = {90.0f * aspect, 90.0f}});
  report.vectorsMs = watch.milliseconds();
  return drawing ? Status(Unit{}) : drawing.error();
}

Status measureVtk(const Stage& stage, Report& report) {
  auto context = render::gpu::HeadlessContext::create();
  if (!context)
    return context.error();
  VtkPhong vtk(stage.scene, stage.settings.width, stage.settings.height);
  const auto times = timed(stage.frames, stage.camera, [&](const model::Camera& camera) {
    vtk.draw(camera);
    return Status(Unit{});
  });
  report.vtkPhong = spreadOf(times.value());
  if (vtk.covered() < 0.001)
    return Error{.reason = "VTK's yardstick drew nothing",
                 .remedy = "Check that VTK's OpenGL2 module works with this driver"};
  return Unit{};
}

Status measureDrag(render::Picture& picture, const Stage& stage, Report& report) {
  if (report.structures < 2)
    return Unit{};
  const auto dragged = dragGamma(picture, {.scene = stage.scene,
                                           .camera = stage.camera,
                                           .settings = stage.settings,
                                           .structures = 4,
                                           .step = 0.5f});
  if (!dragged)
    return dragged.error();
  for (const DraggedStructure& one : *dragged)
    report.gammaRatio += one.ratio() / double(dragged->size());
  return Unit{};
}

Status measureReopening(const Stage& stage, Report& report) {
  const Result<std::string> bytes = model::sceneFileBytes({.scene = stage.scene});
  if (!bytes)
    return bytes.error();
  const Stopwatch watch;
  const auto document = model::documentFromBytes(*bytes);
  report.reopenMs = watch.milliseconds();
  return document ? Status(Unit{}) : document.error();
}

Status writeSubdivided(const model::Scene& scene, int times, const std::filesystem::path& file) {
  model::Scene fine = scene;
  for (int i = 0; i < times; ++i)
    fine = subdivided(fine);
  std::vector<glm::vec3> positions;
  std::vector<model::Triangle> triangles;
  for (const model::NodeId id : fine.structuresBelow(model::rootId)) {
    const model::Mesh& mesh = *fine.find(id)->mesh;
    const auto first = std::uint32_t(positions.size());
    for (model::Triangle triangle : mesh.triangles()) {
      for (std::uint32_t& corner : triangle)
        corner += first;
      triangles.push_back(triangle);
    }
    positions.insert(positions.end(), mesh.positions().begin(), mesh.positions().end());
  }
  const auto whole = model::Mesh::create(std::move(positions), std::move(triangles));
  if (!whole)
    return whole.error();
  return model::writeText(file, model::plyText(*whole, "SPACE=LPS"));
}

}  // namespace sline::bench
