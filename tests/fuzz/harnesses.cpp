// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/harnesses.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/files/mesh_codec.h"
#include "model/files/scene_file.h"
#include "model/files/scene_json.h"
#include "model/files/scene_migration.h"
#include "model/import/fiducials.h"
#include "model/import/file_kinds.h"
#include "model/import/import.h"
#include "model/import/slicer_scene.h"
#include "tests/fuzz/input_folder.h"

namespace sline::fuzz {

namespace {
using model::MeshPtr;

/// An extension as an argument of a template.
struct Extension {
  char text[16] = {};
  template <std::size_t n>
  constexpr Extension(const char (&literal)[n]) {  // NOLINT(google-explicit-constructor)
    std::copy_n(literal, n, text);
  }
};

std::string faultOf(const Error& error) {
  return error.reason.empty() ? "refused without a reason" : "";
}

std::string faultOf(const model::RawMesh& mesh) {
  for (const glm::vec3& p : mesh.positions)
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return "a coordinate is not finite";
  for (const model::Triangle& t : mesh.triangles)
    if (std::max({t[0], t[1], t[2]}) >= mesh.positions.size())
      return "an index is out of range";
  return mesh.triangles.empty() ? "a surface without triangles" : "";
}

/// Any kind of file in the table of kinds.
template <Extension extension>
std::string surfaces(std::string_view bytes) {
  static const InputFolder folder;
  const Result<model::RawMeshes> read = model::readSurfaces(folder.put(extension.text, bytes));
  if (!read.ok())
    return read.error().remedy.empty() ? "refused without a remedy" : faultOf(read.error());
  if (read->meshes.empty())
    return "neither a surface nor an error";
  for (const model::RawMesh& mesh : read->meshes)
    if (std::string fault = faultOf(mesh); !fault.empty())
      return fault;
  return {};
}

std::string slicerScene(std::string_view bytes) {
  static const InputFolder folder;
  const Result<model::SlicerScene> read = model::readSlicerScene(folder.put(".mrml", bytes), {});
  if (!read.ok())
    return faultOf(read.error());
  for (std::size_t i = 0; i < read->groups.size(); ++i)
    if (read->groups[i].parent && *read->groups[i].parent >= i)
      return "a group's parent comes after it";
  for (const model::SlicerModel& scene : read->models)
    if (scene.group && *scene.group >= read->groups.size())
      return "a model's group is out of range";
  return {};
}

/// What is read is written and read again: the same bytes must come of it.
std::string savedTwice(const model::SceneDocument& document) {
  const Result<std::string> once = model::sceneFileBytes(document);
  if (!once.ok())
    return "what was read cannot be written: " + once.error().text();
  const Result<model::SceneDocument> again = model::documentFromBytes(*once);
  if (!again.ok())
    return "what was written cannot be read: " + again.error().text();
  const Result<std::string> twice = model::sceneFileBytes(*again);
  return twice.ok() && *twice == *once ? "" : "saved again it is another file";
}

std::string sceneFile(std::string_view bytes) {
  const Result<model::SceneDocument> document = model::documentFromBytes(bytes);
  if (!document.ok())
    return faultOf(document.error());
  return document->isNewer() ? "" : savedTwice(*document);
}

std::string sceneJson(std::string_view bytes) {
  Result<model::Json> root = model::parseJson(bytes);
  if (!root.ok())
    return faultOf(root.error());
  const Result<int> schema = model::schemaOf(*root);
  if (!schema.ok())
    return faultOf(schema.error());
  if (const Status done = model::migrate(*root, model::sceneMigrations(), model::sceneSchema);
      !done.ok())
    return faultOf(done.error());
  static const MeshPtr mesh = std::make_shared<const model::Mesh>(
      std::move(*model::Mesh::create({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}})));
  model::MeshesByName meshes;
  for (const std::string& name : model::meshesCalledFor(*root))
    meshes[name] = mesh;
  Result<model::Scene> scene = model::sceneFromJson(*root, meshes);
  if (!scene.ok())
    return faultOf(scene.error());
  if (*schema > model::sceneSchema)
    return {};
  return savedTwice({.scene = std::move(*scene)});
}

std::string meshCodec(std::string_view bytes) {
  const Result<model::Mesh> mesh = model::decodedMesh(bytes);
  if (!mesh.ok())
    return faultOf(mesh.error());
  const std::string once = model::encodedMesh(*mesh);
  const Result<model::Mesh> again = model::decodedMesh(once);
  return again.ok() && model::encodedMesh(*again) == once ? "" : "decoded again it is another mesh";
}

/// The whole way in: what a reader hands on is mended, smoothed and refined, or decimated, and
/// saved. Refinement makes much of little by design, so the input is kept small.
std::string wholeImport(std::string_view bytes) {
  if (bytes.size() > 8192)
    return {};
  static const InputFolder folder;
  const std::filesystem::path inputs[] = {folder.put(".off", bytes)};
  model::ImportOptions fewer;
  fewer.smoothing.mode = model::Smoothing::Mode::off;
  fewer.decimateMm = 0.25f;
  for (const model::ImportOptions& options : {model::ImportOptions(), fewer}) {
    Result<model::Imported> imported = model::importInputs(inputs, options);
    if (!imported.ok())
      return faultOf(imported.error());
    if (std::string fault = savedTwice({.scene = std::move(imported->scene)}); !fault.empty())
      return fault;
  }
  return {};
}

/// Points and lines of 3D Slicer, by their file's ending.
template <Extension extension>
std::string fiducials(std::string_view bytes) {
  static const InputFolder folder;
  const Result<model::Fiducials> read =
      model::readFiducials(folder.put(extension.text, bytes), model::ReadLimits{});
  if (!read.ok())
    return faultOf(read.error());
  for (const model::Fiducial& item : read->items)
    if (item.places.size() != model::anchorCount(item.kind))
      return "as many places as its kind has not";
  return {};
}

/// A bundle is unpacked, its scene read, and what it refers to as well.
std::string slicerBundle(std::string_view bytes) {
  static const InputFolder folder;
  const std::filesystem::path inputs[] = {folder.put(".mrb", bytes)};
  Result<model::Imported> imported = model::importInputs(inputs, {});
  if (!imported.ok())
    return faultOf(imported.error());
  return savedTwice({.scene = std::move(imported->scene)});
}

// A reader that stands in the table of kinds needs its row here and a folder of seeds.
constexpr std::array table = {
    Harness{"obj", surfaces<".obj">},       Harness{"stl", surfaces<".stl">},
    Harness{"ply", surfaces<".ply">},       Harness{"off", surfaces<".off">},
    Harness{"vtk", surfaces<".vtk">},       Harness{"vtp", surfaces<".vtp">},
    Harness{"gltf", surfaces<".gltf">},     Harness{"glb", surfaces<".glb">},
    Harness{"3mf", surfaces<".3mf">},       Harness{"nii", surfaces<".nii">},
    Harness{"nii_gz", surfaces<".nii.gz">}, Harness{"nrrd", surfaces<".nrrd">},
    Harness{"mha", surfaces<".mha">},       Harness{"dcm", surfaces<".dcm">},
    Harness{"pdb", surfaces<".pdb">},       Harness{"cif", surfaces<".cif">},
    Harness{"mrml", slicerScene},           Harness{"mrb", slicerBundle},
    Harness{"fcsv", fiducials<".fcsv">},    Harness{"mrk_json", fiducials<".mrk.json">},
    Harness{"scene_file", sceneFile},       Harness{"scene_json", sceneJson},
    Harness{"mesh_codec", meshCodec},       Harness{"import", wholeImport},
};
}  // namespace

std::span<const Harness> harnesses() {
  return table;
}

const Harness* harnessNamed(std::string_view name) {
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const Harness& harness) { return harness.name == name; });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace sline::fuzz
