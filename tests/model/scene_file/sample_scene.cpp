// SPDX-License-Identifier: Apache-2.0
#include "tests/model/scene_file/sample_scene.h"

#include <cstring>

#include "tests/support/shapes.h"

namespace sline::test {

using namespace model;

namespace {

Style sampleStyle() {
  return {.colour = Colour{1, 2, 3},
          .inkColour = Colour{250, 251, 252},
          .gamma = Gamma::clamped(3.3f),
          .opacity = Opacity::clamped(0.7f),
          .fill = Fill::tint,
          .visible = false,
          .technique = Technique::confis,
          .lineThresholds = ThresholdValues{{"confis.margin", 0.25f}, {"laplacian.slope", 0.3f}},
          .penWeight = 1.7f,
          .lineVariation = 0.25f,
          .lineSmoothing = 0.5f,
          .shortestLine = 5.0f,
          .lineScale = 1.5f,
          .hiddenLines = HiddenLines::dashed,
          .halo = 1.5f,
          .grain = 0.5f,
          .hatchDensity = HatchDensity::clamped(0.6f),
          .hatchTone = HatchTone::clamped(1.3f),
          .gammaMap = GammaMap{.scalar = GammaScalar::distance,
                               .targets = {{5}, {1}},
                               .place = glm::vec3(0.1f, 2.0f, -3.5f),
                               .curve = {{0.0f, 3.0f}, {12.5f, 0.1f}, {40.0f, -1.0f}}}};
}

Provenance sampleProvenance() {
  Provenance p{.file = "a.ply",
               .frame = "LPS",
               .frameReason = "said so",
               .evidence = {Evidence::conflict, Evidence::voted},
               .nameEvidence = Evidence::conflict,
               .smoothingSteps = 3,
               .refinementSteps = 2,
               .repairedFaces = 1,
               .displacementMm = 0.25f,
               .sliceMm = 1.5f,
               .mmPerUnit = 1000.0f,
               .unitReason = "glTF: metres",
               .unitEvidence = Evidence::settled,
               .decimatedFrom = 4321,
               .decimationMm = 0.125f};
  p.part = "artery";
  p.fingerprint = Fingerprint{12'345'678'901, 0xfedcba98u};
  p.transform = {1, 0, 0, 0.1f, 0, -1, 0, 0, 0, 0, 1, -7};
  p.credit = {.authors = "Jane Doe", .source = "An atlas", .licence = "CC BY 4.0"};
  p.asRead = ReadExtent{12.5f, 30.25f};
  return p;
}

KeptAtoms sampleAtoms() {
  AtomSet set{{"LYS A 295", "none", "?? B -3A"}, {}};
  set.atoms.push_back({{1.5f, 0.1f, -3e-7f}, 1.7f, 0});
  set.atoms.push_back({{-2.25f, 0.0f, 9.0f}, 1.55f, 0});
  set.atoms.push_back({{4, 5, 6}, 1.2f, 2});
  return {std::make_shared<const AtomSet>(std::move(set))};
}

PaintPtr samplePaint(const Mesh& mesh) {
  Paint paint(mesh.vertexCount(), 0);
  paint[3] = 255;
  paint[5] = 17;
  return std::make_shared<const Paint>(std::move(paint));
}

ViewWords sampleWords() {
  return {.title = {"The pelvis", {{"de", "Das Becken"}}},
          .text = {"Seen *from the front*", {{"de", "Von *vorn*"}}},
          .notes = {"Begin with the bones", {}},
          .description = {"An artery & more", {{"de", "Eine Arterie"}}},
          .seconds = 7.5f};
}

}  // namespace

Scene sampleScene() {
  Scene scene;
  const NodeId vessels = scene.append({.name = "Vessels"});
  const NodeId arteries = scene.append({.parent = vessels, .name = "Arteries"});
  Node artery{.parent = arteries, .name = "Ärterie \"a\"", .mesh = sphere(7.3f, 2)};
  artery.style = sampleStyle();
  artery.locked = true;
  artery.paint = samplePaint(*artery.mesh);
  artery.provenance = sampleProvenance();
  artery.atoms = sampleAtoms();
  const NodeId one = scene.append(artery);
  scene.append({.name = "its twin", .style = {.visible = true}, .mesh = artery.mesh});
  scene.append({.name = "loose", .style = {.fill = Fill::veil}, .mesh = torus(9, 2, 12, 8)});
  const Section half{.id = {5},
                     .name = "half",
                     .plane = {.normal = {0, 1, 0}, .offset = 2.5f},
                     .scope = vessels,
                     .enabled = false,
                     .faces = CutFaces::tint,
                     .hatched = true};
  scene.setSections({half});
  const Camera camera{.projection = Projection::orthographic,
                      .eye = {1, -500, 0.1f},
                      .target = {0.3f, 0, 2},
                      .up = {-0.0f, 0.1f, 1},
                      .fovyDegrees = 21.5f,
                      .heightMm = 333.25f};
  Focus focus;
  focus.targets = {one, arteries};
  focus.amount = ContextAmount::clamped(0.3f);
  focus.seenFrom = camera;
  focus.wishes.roles[vessels] = ContextRole::shell;
  focus.wishes.roles[one] = ContextRole::feeder;
  focus.wishes.hiddenToo = true;
  focus.nearness = FocusNearness{.place = glm::vec3(1.5f, -2.0f, 0.1f), .falloffMm = 45.5f};
  focus.given.push_back({.node = one, .style = {.gamma = Gamma::clamped(4.5f)}});
  scene.setFocus(focus);
  scene.setViews({{.name = "Overview", .camera = camera, .words = sampleWords()},
                  {.name = "Cut", .sections = std::vector<Section>{half}},
                  {.name = "Whole", .sections = std::vector<Section>{}},
                  {.name = "Bare",
                   .looks = std::vector<Look>{{.node = one, .style = {.visible = true}},
                                              {.node = vessels, .style = {.fill = Fill::paper}}},
                   .annotations = std::vector<AnnotationId>{AnnotationId{4}},
                   .focus = Focus()}});
  scene.setAnnotations({{.id = {4},
                         .kind = AnnotationKind::callout,
                         .anchors = {SurfacePoint{one, 17, {0.25f, 0.5f}}},
                         .text = "Artery",
                         .texts = {{"de", "Schlagader"}, {"la", "Arteria"}},
                         .colour = Colour{9, 99, 199},
                         .offset = glm::vec2(0.25f, -0.125f)},
                        {.id = {2},
                         .kind = AnnotationKind::distance,
                         .anchors = {glm::vec3(1, 2.5f, -3), SurfacePoint{one, 0, {0, 1}}},
                         .visible = false,
                         .locked = true}});
  scene.setKeyLight(KeyLight{.towards = {0, 0.6f, 0.8f}, .shades = true});
  return scene;
}

namespace {
bool sameBits(const Mesh& a, const Mesh& b) {
  return a.vertexCount() == b.vertexCount() && a.triangleCount() == b.triangleCount() &&
         std::memcmp(a.positions().data(), b.positions().data(), a.positions().size_bytes()) == 0 &&
         std::memcmp(a.triangles().data(), b.triangles().data(), a.triangles().size_bytes()) == 0;
}
}  // namespace

std::string difference(const Scene& a, const Scene& b) {
  if (a.views() != b.views())
    return "views";
  if (a.sections() != b.sections())
    return "sections";
  if (a.annotations() != b.annotations())
    return "annotations";
  if (a.focus() != b.focus())
    return "focus";
  if (a.keyLight() != b.keyLight())
    return "key light";
  if (a.traces() != b.traces())
    return "traces";
  if (a.unread() != b.unread())
    return "unread: " + a.unread() + " / " + b.unread();
  if (a.nodes().size() != b.nodes().size())
    return "count of nodes";
  for (std::size_t i = 0; i < a.nodes().size(); ++i) {
    Node x = a.nodes()[i];
    Node y = b.nodes()[i];
    if (x.isGroup() != y.isGroup() || (!x.isGroup() && !sameBits(*x.mesh, *y.mesh)))
      return "mesh of " + x.name;
    if (!x.paint != !y.paint || (x.paint && *x.paint != *y.paint))
      return "paint of " + x.name;
    x.mesh = y.mesh = nullptr;
    x.paint = y.paint = nullptr;
    if (x != y)
      return x.name + " / " + y.name + ", " + x.unread + " / " + y.unread;
  }
  return {};
}

std::string withMember(const std::string& file, const std::string& name, const std::string& bytes) {
  const auto zip = ZipReader::open(file);
  std::vector<ZipMember> members;
  if (zip.ok())
    for (const ZipReader::Entry& entry : zip->entries())
      if (auto unpacked = zip->read(entry); entry.name != name && unpacked.ok())
        members.push_back({entry.name, std::move(*unpacked)});
  members.push_back({name, bytes});
  std::vector<const ZipMember*> all;
  all.reserve(members.size());
  for (const ZipMember& member : members)
    all.push_back(&member);
  auto packed = zipped(all);
  return packed.ok() ? std::move(*packed) : std::string();
}

std::string memberOf(const std::string& file, const std::string& name) {
  const auto zip = ZipReader::open(file);
  const ZipReader::Entry* entry = zip.ok() ? zip->find(name) : nullptr;
  if (!entry)
    return {};
  auto unpacked = zip->read(*entry);
  return unpacked.ok() ? std::move(*unpacked) : std::string();
}

}  // namespace sline::test
