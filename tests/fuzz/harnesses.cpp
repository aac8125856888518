// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/harnesses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/matrix.hpp>

#include "model/base/utf8.h"
#include "model/edit/letter_style.h"
#include "model/figure/figure_file.h"
#include "model/import/credits/source_credit.h"
#include "model/import/dicom/dicom.h"
#include "model/import/kinds/file_kinds.h"
#include "model/import/plan/import.h"
#include "model/import/plan/patients.h"
#include "model/import/slicer/bundle.h"
#include "model/import/slicer/fiducials.h"
#include "model/import/slicer/mrml_scene.h"
#include "model/packed_scene/packed_scene.h"
#include "model/scene_file/journal_content.h"
#include "model/scene_file/mesh_codec.h"
#include "model/scene_file/scan_codec.h"
#include "model/scene_file/scene_file.h"
#include "model/scene_json/scene_json.h"
#include "model/scene_json/scene_migration.h"
#include "tests/fuzz/input_folder.h"

namespace sline::fuzz {

namespace {
using model::MeshPtr;

/// Holds an extension as an argument of a template.
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

Result<model::RawMeshes> readAnyKind(const std::filesystem::path& file,
                                     const model::ReadOptions& options) {
  return model::readSurfaces(file, options);
}

std::string faultOf(const Result<model::RawMeshes>& read) {
  if (!read.ok())
    return read.error().remedy.empty() ? "refused without a remedy" : faultOf(read.error());
  if (read->meshes.empty())
    return "neither a surface nor an error";
  for (const model::RawMesh& mesh : read->meshes)
    if (std::string fault = faultOf(mesh); !fault.empty())
      return fault;
  return {};
}

/// Reads any kind of file in the table of kinds; those that the program reads in a process of their
/// own are read in this one, where faults are seen.
template <Extension extension, auto reader = readAnyKind>
std::string surfaces(std::string_view bytes) {
  static const InputFolder folder;
  const model::ReadOptions options{.thresholds = {{"bone", 10.0, 1000.0}, {"skin", {}, {}}}};
  return faultOf(reader(folder.put(extension.text, bytes), options));
}

/// Reads a volume in two files: the first 352 bytes are the header's.
std::string imagePair(std::string_view bytes) {
  static const InputFolder folder;
  const std::size_t header = std::min<std::size_t>(352, bytes.size());
  folder.put(".hdr", bytes.substr(0, header));
  return faultOf(model::readSurfaces(folder.put(".img", bytes.substr(header))));
}

/// Reads a file of several slices.
std::string dicomSeries(std::string_view bytes) {
  static const InputFolder folder;
  const std::array files{folder.put(".dcm", bytes)};
  model::seriesIn(files, {});
  const Result<model::GreyVolume> read = model::readDicomSeries(files, {});
  if (!read.ok())
    return faultOf(read.error());
  const std::size_t voxels =
      std::size_t(read->size.x) * std::size_t(read->size.y) * std::size_t(read->size.z);
  return read->voxels.size() == voxels && std::abs(glm::determinant(read->toLps)) > 0.0
             ? ""
             : "a volume that is none";
}

/// Reads the first assembly of an entry.
std::string assembly(std::string_view bytes) {
  static const InputFolder folder;
  const Result<model::RawMeshes> read =
      model::readSurfaces(folder.put(".cif", bytes), {.assembly = "1"});
  if (!read.ok())
    return faultOf(read.error());
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

std::string slicerBundle(std::string_view bytes) {
  static const InputFolder folder;
  const Result<model::SlicerBundle> read = model::unpackBundle(folder.put(".mrb", bytes), {});
  return read.ok() ? "" : faultOf(read.error());
}

template <Extension extension>
std::string fiducials(std::string_view bytes) {
  static const InputFolder folder;
  const Result<model::Fiducials> read = model::readFiducials(folder.put(extension.text, bytes), {});
  if (!read.ok())
    return faultOf(read.error());
  for (const model::Fiducial& fiducial : read->items)
    for (const glm::dvec3& p : fiducial.places)
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        return "a coordinate is not finite";
  return {};
}

/// Writes what was read and reads it again: the same bytes must result.
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
  return savedTwice(*document);
}

std::string sceneJson(std::string_view bytes) {
  Result<model::Json> root = model::parseJson(bytes);
  if (!root.ok())
    return faultOf(root.error());
  const Result<int> schema = model::schemaOf(*root);
  if (!schema.ok())
    return faultOf(schema.error());
  if (const Status done = model::migrate(*root); !done.ok())
    return faultOf(done.error());
  static const MeshPtr mesh = std::make_shared<const model::Mesh>(
      std::move(*model::Mesh::create({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}})));
  static const auto paint = std::make_shared<const model::Paint>(3, 200);
  model::SceneParts parts;
  for (const std::string& name : model::meshesCalledFor(*root))
    parts.meshes[name] = mesh;
  for (const std::string& name : model::paintsCalledFor(*root))
    parts.paints[name] = paint;
  std::vector<model::JsonRefusal> leftOut;
  Result<model::Scene> scene = model::sceneFromJson(*root, parts, leftOut);
  if (!scene.ok())
    return faultOf(scene.error());
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

std::string scanCodec(std::string_view bytes) {
  const Result<std::vector<std::int16_t>> voxels = model::decodedVoxels(bytes);
  if (!voxels.ok())
    return faultOf(voxels.error());
  return model::encodedVoxels(*voxels) == bytes ? "" : "encoded again it is another scan";
}

/// Reads a journal's states; what was read is written, and must be read again.
std::string journal(std::string_view bytes) {
  const model::JournalContent content = model::journalContent(bytes);
  if (content.states.empty())
    return {};
  if (content.current < content.first || content.current - content.first >= content.states.size())
    return "it stands where there is no state";
  static const MeshPtr mesh = std::make_shared<const model::Mesh>(
      std::move(*model::Mesh::create({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}})));
  model::Bulk bulk;
  for (const std::string& key : model::keysCalledFor(*content.now().text))
    bulk[key] = mesh;
  std::vector<model::JsonRefusal> leftOut;
  const Result<model::Scene> scene = model::sceneOfState(*content.now().text, bulk, leftOut);
  if (!scene.ok() && scene.error().reason.empty())
    return "refused without a reason";
  model::JournalWriter writer;
  const model::JournalContent again = model::journalContent(model::journalBytes(content, writer));
  if (again.states.size() != content.states.size() || again.current != content.current)
    return "written again it is another journal";
  for (std::size_t i = 0; i < again.states.size(); ++i)
    if (*again.states[i].text != *content.states[i].text)
      return "written again a state is another";
  return {};
}

/// Reads the meshes and voxels beside a journal.
std::string bulkStore(std::string_view bytes) {
  for (const auto& [key, item] : model::bulkFrom(bytes))
    if (std::visit([](const auto& pointer) { return pointer == nullptr; }, item))
      return "an item that is none";
  return {};
}

/// Checks that what is said of authors and terms is one line each. The first byte says what text it
/// is in.
std::string credit(std::string_view bytes) {
  const auto kind = model::CreditText(bytes.empty() ? 0 : std::uint8_t(bytes.front()) % 4);
  const model::SourceCredit said =
      model::creditIn(bytes.substr(std::min<std::size_t>(1, bytes.size())), kind);
  for (const std::string* text : {&said.authors, &said.source, &said.licence})
    if (!isUtf8(*text) || std::any_of(text->begin(), text->end(), [](char letter) {
          return std::uint8_t(letter) < ' ' || letter == 0x7f;
        }))
      return "no line of text";
  return {};
}

/// Checks that the spans of a callout are bytes of its text in order, and that another style for
/// some of them changes no word. The first byte says where the selection is.
std::string markup(std::string_view bytes) {
  const std::string text(bytes.substr(std::min<std::size_t>(1, bytes.size())));
  std::size_t last = 0;
  for (const model::MarkupLine& line : model::parsedMarkup(text))
    for (const model::MarkupSpan& span : line.spans) {
      if (span.begin < last || span.end <= span.begin || span.end > text.size())
        return "a span is out of order";
      last = span.end;
    }
  if (text.empty())
    return {};
  const auto byte = std::size_t(std::uint8_t(bytes.front()));
  const model::TextRange selection{byte % 16 * text.size() / 16,
                                   (byte % 16 + byte / 16 + 1) * text.size() / 16};
  const model::LetterMark mark =
      byte % 2 == 0 ? model::LetterMark::bold : model::LetterMark::italic;
  const model::MarkedText made =
      model::withLetterStyle(text, {selection.begin, std::min(selection.end, text.size())}, mark);
  const auto words = [](const std::string& marked) {
    return model::plainText(model::AnnotationKind::callout, marked);
  };
  // An empty pair of marks is waiting for letters, and may be read as a part of others until then.
  if (selection.begin < selection.end && words(made.text) != words(text))
    return "another style has changed words";
  return made.selection.end > made.text.size() ? "the selection is outside of the text" : "";
}

/// Reads a figure's file; one that is read can be written, and reads back as the same.
std::string figure(std::string_view bytes) {
  const Result<model::Figure> read = model::figureFromText(bytes);
  if (!read.ok())
    return read.error().remedy.empty() ? "refused without a remedy" : faultOf(read.error());
  const Result<model::Figure> again = model::figureFromText(model::figureText(*read));
  if (!again.ok())
    return "what was written is refused: " + again.error().text();
  return *again == *read ? "" : "it changes when it is written";
}

/// Takes a packed scene, as the students' page does; one that is taken can be packed again.
std::string pageScene(std::string_view bytes) {
  model::UnpackedScene unpacked;
  const Status taken = unpacked.take(bytes);
  if (!taken.ok())
    return faultOf(taken.error());
  model::UnpackedScene again;
  const Status retaken = again.take(model::packedScene(unpacked.scene()).first);
  if (!retaken.ok())
    return "what was packed is refused: " + retaken.error().text();
  return again.scene().nodes().size() == unpacked.scene().nodes().size()
             ? ""
             : "it changes when it is packed";
}

/// Takes the whole way in: the reader's result is mended, smoothed and refined, or decimated, and
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

/// Asks whose a file is, under each kind of name that is looked into.
std::string patientMarks(std::string_view bytes) {
  static const InputFolder folder;
  for (const char* ending : {".dcm", ".nrrd", ".mha", ".hdr", ".mnc", ".mrml"})
    for (const model::PatientMarks& marks : model::patientMarks(folder.put(ending, bytes), {}))
      if (!marks.any())
        return "marks that say nothing";
  return {};
}

// A reader that stands in the table of kinds needs its row here and a folder of seeds.
constexpr Harness table[] = {
    {"obj", surfaces<".obj">},
    {"stl", surfaces<".stl">},
    {"ply", surfaces<".ply">},
    {"off", surfaces<".off">},
    {"vtk", surfaces<".vtk">},
    {"vtp", surfaces<".vtp">},
    {"gltf", surfaces<".gltf">},
    {"glb", surfaces<".glb">},
    {"3mf", surfaces<".3mf">},
    {"x3d", surfaces<".x3d">},
    {"wrl", surfaces<".wrl">},
    {"3ds", surfaces<".3ds">},
    {"mnc", surfaces<".mnc">},
    {"nii", surfaces<".nii">},
    {"nii_gz", surfaces<".nii.gz">},
    {"nrrd", surfaces<".nrrd">},
    {"nhdr", surfaces<".nhdr">},
    {"mha", surfaces<".mha">},
    {"img", imagePair},
    {"mgh", surfaces<".mgh">},
    {"mgz", surfaces<".mgz">},
    {"freesurfer", surfaces<".pial">},
    {"gii", surfaces<".gii">},
    {"obj_gz", surfaces<".obj.gz">},
    {"dcm", surfaces<".dcm", model::readDicom>},
    {"dcm_series", dicomSeries},
    {"pdb", surfaces<".pdb">},
    {"cif", surfaces<".cif">},
    {"cif_gz", surfaces<".cif.gz">},
    {"json", surfaces<".json">},
    {"assembly", assembly},
    {"mrml", slicerScene},
    {"mrb", slicerBundle},
    {"fcsv", fiducials<".fcsv">},
    {"markups", fiducials<".mrk.json">},
    {"scene_file", sceneFile},
    {"scene_json", sceneJson},
    {"journal", journal},
    {"bulk_store", bulkStore},
    {"mesh_codec", meshCodec},
    {"scan_codec", scanCodec},
    {"credit", credit},
    {"markup", markup},
    {"figure", figure},
    {"page_scene", pageScene},
    {"import", wholeImport},
    {"patient_marks", patientMarks},
};
}  // namespace

std::span<const Harness> harnesses() {
  return table;
}

const Harness* harnessNamed(std::string_view name) {
  const auto found = std::find_if(std::begin(table), std::end(table),
                                  [&](const Harness& harness) { return harness.name == name; });
  return found == std::end(table) ? nullptr : &*found;
}

}  // namespace sline::fuzz
