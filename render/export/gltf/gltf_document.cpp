// SPDX-License-Identifier: Apache-2.0
#include "render/export/gltf/gltf_document.h"

#include <limits>
#include <utility>

#include "model/base/colour_text.h"
#include "model/scene/markup.h"
#include "model/scene/resolved_styles.h"
#include "render/drawn/drawn_structure.h"
#include "render/drawn/gamma_offsets.h"
#include "render/export/description/alt_text.h"
#include "render/export/gltf/gltf_buffer.h"
#include "render/export/gltf/gltf_json.h"
#include "render/export/gltf/gltf_sights.h"

namespace sline::render {

namespace {

class Document {
 public:
  explicit Document(const ExportOrder& order)
      : m_order(order), m_styles(model::resolveAll(order.scene)) {}

  bool write(const ExportProgress& progress) {
    keepShown();
    const auto& nodes = m_order.scene.nodes();
    if (m_shownCount > 0)
      addTop();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (progress && !progress(0.9 * double(i) / double(nodes.size()), "writing surfaces"))
        return false;
      if (m_shown[i])
        addNode(i);
    }
    addAnnotations(progress);
    addCameras();
    return true;
  }

  Result<std::string> bytes() const;

 private:
  /// Keeps structures that are visible and have a surface, and the groups above them.
  void keepShown() {
    const auto& nodes = m_order.scene.nodes();
    m_shown.assign(nodes.size(), false);
    std::map<model::NodeId, std::size_t> places;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      places[nodes[i].id] = i;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i].isGroup() || !m_styles[i].visible || nodes[i].mesh->triangleCount() == 0)
        continue;
      ++m_shownCount;
      m_shown[i] = true;
      m_bounds.add(nodes[i].mesh->bounds());
      for (auto above = places.find(nodes[i].parent); above != places.end();
           above = places.find(nodes[above->second].parent))
        m_shown[above->second] = true;
    }
  }

  std::size_t add(Json node) {
    m_nodes.push_back(std::move(node));
    return m_nodes.size() - 1;
  }
  void addChild(std::size_t parent, std::size_t child) {
    m_nodes[parent]["children"].push_back(child);
  }
  std::size_t placeOf(model::NodeId id) const {
    const auto found = m_places.find(id);
    return found == m_places.end() ? m_top : found->second;
  }

  /// Adds the node above everything in LPS millimetres. It has no name, so that programs that make
  /// groups of named nodes make none of it.
  void addTop() {
    const glm::dmat3 turn = double(metresPerMillimetre) * uprightFromLps();
    Json matrix = Json::array();
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 4; ++row)
        matrix.push_back(column < 3 && row < 3 ? turn[column][row] + 0.0
                                               : (column == row ? 1.0 : 0.0));
    m_top = add({{"matrix", std::move(matrix)}, {"children", Json::array()}});
    m_roots.push_back(m_top);
  }

  void addNode(std::size_t i) {
    const model::Node& node = m_order.scene.nodes()[i];
    Json described{{"name", node.name}};
    if (!node.isGroup()) {
      described["mesh"] = addMesh(i);
      described["extras"] = styleExtras(m_styles[i]);
      if (!node.provenance.credit.empty() && m_order.sources != SourceCredits::off)
        described["extras"]["credit"] = creditExtras(node.provenance.credit);
    }
    const std::size_t place = add(std::move(described));
    addChild(placeOf(node.parent), place);
    m_places[node.id] = place;
  }

  std::size_t addMesh(std::size_t i) {
    const model::Node& node = m_order.scene.nodes()[i];
    const GltfSurface& surface = m_buffer.surfaceOf(node.mesh);
    Json attributes{{"POSITION", surface.positions}, {"NORMAL", surface.normals}};
    if (const std::vector<float> gammas = gammasOf(i); !gammas.empty())
      attributes["_GAMMA"] = m_buffer.numbers(gammas);
    m_meshes.push_back({{"name", node.name},
                        {"primitives", Json::array({{{"attributes", std::move(attributes)},
                                                     {"indices", surface.indices},
                                                     {"material", materialOf(m_styles[i])}}})}});
    return m_meshes.size() - 1;
  }

  /// Returns Γ at each vertex as pictures draw it, where it varies over the surface; else nothing.
  std::vector<float> gammasOf(std::size_t i) const {
    if (!gammaVaries(m_styles[i]))
      return {};
    const model::Node& node = m_order.scene.nodes()[i];
    PreparedSurface prepared;
    prepared.take(node.mesh, node.provenance);
    DrawnStructure shown{
        .id = node.id, .mesh = node.mesh, .style = m_styles[i], .prepared = &prepared};
    findGammaOffsets(m_order.scene, shown);
    if (!shown.gammaOffsets)
      return {};
    std::vector<float> gammas = *shown.gammaOffsets;
    for (float& gamma : gammas)
      gamma = Gamma::clamped(m_styles[i].gamma.value() + gamma).value();
    return gammas;
  }

  /// Returns the material, which structures of one colour and opacity share.
  std::size_t materialOf(const model::ResolvedStyle& style) {
    const float opacity = style.opacity.value();
    const auto key = std::make_pair(style.colour, opacity);
    const auto known = m_materialPlaces.find(key);
    if (known != m_materialPlaces.end())
      return known->second;
    const Colour& c = style.colour;
    Json material{
        {"name", colourText(c)},
        {"pbrMetallicRoughness",
         {{"baseColorFactor",
           {linearLight(c.red), linearLight(c.green), linearLight(c.blue), jsonNumber(opacity)}},
          {"metallicFactor", 0.0},
          {"roughnessFactor", 0.8}}}};
    if (opacity < 1.0f)
      material["alphaMode"] = "BLEND";
    // Sheets and cut structures are seen from both sides in our pictures, too.
    material["doubleSided"] = true;
    m_materials.push_back(std::move(material));
    return m_materialPlaces[key] = m_materials.size() - 1;
  }

  void addAnnotations(const ExportProgress& progress) {
    const model::Scene& scene = m_order.scene;
    ExportNote unseen{.kind = ExportNote::Kind::labelsOfHidden, .names = {}, .detail = {}};
    for (const model::Annotation& annotation : scene.annotations()) {
      bool shown = annotation.visible && m_shownCount > 0;
      for (const model::Anchor& anchor : annotation.anchors) {
        const auto* point = std::get_if<model::SurfacePoint>(&anchor);
        shown = shown && scene.placeOf(anchor) && (!point || m_places.contains(point->structure));
      }
      if (!shown && annotation.visible)
        unseen.names.push_back(model::plainTextIn(annotation, m_order.labels.language));
      if (!shown)
        continue;
      const std::size_t place = add(annotationNode(scene, annotation, m_order.labels.language));
      const auto* on = std::get_if<model::SurfacePoint>(&annotation.anchors.front());
      addChild(on ? m_places.at(on->structure) : m_top, place);
    }
    if (!unseen.names.empty())
      progress.note(std::move(unseen));
  }

  void addCamera(const std::string& name, const model::Camera& camera, Json extras) {
    m_cameras.push_back(gltfCamera(camera, m_bounds));
    Json node{{"name", name}, {"camera", m_cameras.size() - 1}};
    node.update(cameraPlace(camera));
    if (!extras.empty())
      node["extras"] = std::move(extras);
    m_roots.push_back(add(std::move(node)));
  }

  void addCameras() {
    const model::Scene& scene = m_order.scene;
    bool saved = false;
    for (const model::View& view : scene.views())
      saved = saved || view.name == m_order.viewName;
    if (!saved && m_shownCount > 0)
      addCamera(m_order.viewName.empty() ? "Picture" : m_order.viewName, m_order.camera, {});
    for (const model::View& view : scene.views())
      addCamera(view.name, view.camera, viewExtras(scene, view, m_places));
  }

  static Json creditExtras(const model::SourceCredit& credit) {
    Json extras = Json::object();
    for (const auto& [key, text] :
         {std::pair("authors", &credit.authors), std::pair("source", &credit.source),
          std::pair("licence", &credit.licence)})
      if (!text->empty())
        extras[key] = *text;
    return extras;
  }

  /// Returns the credit with those of the surfaces, which are in the file.
  ExportCredit surfacesCredit() const {
    ExportOrder order = m_order;
    if (order.sources == SourceCredits::withSurfaces)
      order.sources = SourceCredits::line;
    return fileCredit(order);
  }

  Json sceneExtras() const {
    Json extras{{"frame", "LPS"}, {"unit", "mm"}};
    for (const model::Section& section : m_order.scene.sections())
      extras["sections"].push_back(sectionExtras(section));
    return extras;
  }

  const ExportOrder& m_order;
  std::vector<model::ResolvedStyle> m_styles;
  std::vector<bool> m_shown;
  std::size_t m_shownCount = 0;
  model::Box m_bounds;
  std::size_t m_top = 0;
  GltfNodes m_places;
  GltfBuffer m_buffer;
  std::map<std::pair<Colour, float>, std::size_t> m_materialPlaces;
  Json m_roots = Json::array();
  Json m_nodes = Json::array();
  Json m_meshes = Json::array();
  Json m_materials = Json::array();
  Json m_cameras = Json::array();
};

void append(std::string& bytes, std::uint64_t value) {
  for (int i = 0; i < 4; ++i)
    bytes.push_back(char(value >> (8 * i)));
}

/// Appends a chunk by §4.4: its length, type and bytes, filled up to a multiple of 4.
void appendChunk(std::string& glb, const char* type, std::string_view bytes, char filler) {
  const std::size_t length = (bytes.size() + 3) / 4 * 4;
  append(glb, length);
  glb.append(type, 4);
  glb.append(bytes);
  glb.append(length - bytes.size(), filler);
}

/// Returns the asset (§3.2). Its copyright is for programs that show it; it has no other place for
/// a name.
Json assetOf(const ExportCredit& credit) {
  Json asset{{"version", "2.0"}, {"generator", "Sline " SLINE_VERSION}};
  if (const std::string line = credit.line(); !line.empty())
    asset["copyright"] = line;
  if (!credit.author.empty())
    asset["extras"] = {{"author", credit.author}};
  return asset;
}

Result<std::string> Document::bytes() const {
  const ExportCredit credit = surfacesCredit();
  Json root{{"asset", assetOf(credit)}, {"scene", 0}};
  Json scene = Json::object();
  // Lists in glTF are never empty.
  if (!m_roots.empty())
    scene["nodes"] = m_roots;
  scene["extras"] = sceneExtras();
  if (!credit.description.empty())
    scene["extras"]["description"] = {{"text", credit.description},
                                      {"language", credit.descriptionLanguage}};
  root["scenes"] = Json::array({std::move(scene)});
  const std::string& binary = m_buffer.bytes();
  const auto put = [&root](const char* key, const Json& list) {
    if (!list.empty())
      root[key] = list;
  };
  put("nodes", m_nodes);
  put("meshes", m_meshes);
  put("materials", m_materials);
  put("cameras", m_cameras);
  put("accessors", m_buffer.accessors());
  put("bufferViews", m_buffer.views());
  if (!binary.empty())
    root["buffers"] = Json::array({{{"byteLength", binary.size()}}});
  const std::string json = jsonText(root);
  const std::size_t whole = 12 + 8 + json.size() + 3 + (binary.empty() ? 0 : 8 + binary.size());
  if (whole > std::numeric_limits<std::uint32_t>::max())
    return Error{.reason = "the scene needs more than the 4 GB that a GLB file may have",
                 .remedy = "Hide structures, or make them coarser"};
  std::string glb;
  glb.reserve(whole);
  glb.append("glTF");
  append(glb, 2);
  append(glb, 0);
  appendChunk(glb, "JSON", json, ' ');
  if (!binary.empty())
    appendChunk(glb, "BIN\0", binary, '\0');
  std::string length;
  append(length, glb.size());
  glb.replace(8, 4, length);
  return glb;
}

}  // namespace

Result<std::string> glbBytes(const ExportOrder& order, const ExportProgress& progress) {
  Document document(order);
  if (!document.write(progress))
    return givenUp({});
  return document.bytes();
}

}  // namespace sline::render
