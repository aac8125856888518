// SPDX-License-Identifier: Apache-2.0
// Reads VRML97 and X3D: every shape made of polygons or triangles becomes a surface, where its
// transforms put it. Prototypes, scripts, other files and shapes drawn by lines, points or pictures
// are left out.
#include "model/import/readers/x3d/x3d.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <set>

#include "model/base/letters.h"
#include "model/import/readers/x3d/x3d_document.h"
#include "model/import/readers/x3d/x3d_fields.h"
#include "model/import/readers/x3d/x3d_geometry.h"
#include "model/import/source/surface_assembly.h"

namespace sline::model {

namespace {

constexpr std::size_t mostX3dVisits = 100'000;
/// The bytes that reused shapes may make of a file beyond its own size.
constexpr std::uint64_t freeX3dBytes = std::uint64_t(64) << 20;
constexpr std::uint64_t x3dBytesPerByte = 16;

/// Describes a node that is waiting to be visited and what it inherits.
struct X3dVisit {
  const X3dNode* node = nullptr;
  std::size_t depth = 0;
  std::vector<std::string> groups;
  glm::dmat4 toScene{1.0};
  bool only = false;  ///< the one shape among its group's nodes
};

const X3dNode* childOf(const X3dNode& node, std::initializer_list<std::string_view> types) {
  for (const X3dNode* child : node.nodes)
    if (std::find(types.begin(), types.end(), child->type) != types.end())
      return child;
  return nullptr;
}

bool isFalse(std::string_view text) {
  return equalsIgnoringCase(text, "false");
}

class X3dReader {
 public:
  X3dReader(const Source& source, const X3dDocument& document)
      : m_source(source),
        m_document(document),
        m_budget(freeX3dBytes + x3dBytesPerByte * source.size()) {}

  Result<RawMeshes> read() {
    if (m_document.prototypes)
      warnOnce("prototypes are left out");
    std::vector<X3dVisit> waiting;
    pushAll(m_document.scene, {}, waiting);
    while (!waiting.empty()) {
      const X3dVisit visit = std::move(waiting.back());
      waiting.pop_back();
      TRY(visitNode(visit, waiting));
    }
    if (m_result.meshes.empty())
      return m_source.whole(m_result.warnings.empty()
                                ? "holds no shapes"
                                : "holds no surface: " + m_result.warnings.front().reason,
                            "Export the mesh again, as polygons or triangles");
    return std::move(m_result);
  }

 private:
  /// Pushes all nodes; the first one is visited first.
  void pushAll(std::span<const X3dNode* const> nodes, const X3dVisit& parent,
               std::vector<X3dVisit>& waiting) {
    const auto shapes = std::count_if(nodes.begin(), nodes.end(),
                                      [](const X3dNode* node) { return node->type == "Shape"; });
    for (std::size_t i = nodes.size(); i > 0; --i)
      waiting.push_back(
          {nodes[i - 1], parent.depth + 1, parent.groups, parent.toScene, shapes == 1});
  }

  Status visitNode(const X3dVisit& visit, std::vector<X3dVisit>& waiting) {
    static const std::set<std::string_view> grouping{
        "Transform", "Group",       "StaticGroup",  "Anchor",   "Billboard",
        "Collision", "CADAssembly", "CADPart",      "CADLayer", "CADFace",
        "Switch",    "LOD",         "HAnimHumanoid"};
    const X3dNode& node = *visit.node;
    if (node.type == "Shape")
      return addShape(visit);
    if (node.type == "Inline")
      warnOnce("Inline refers to other files, which are not read");
    if (!grouping.contains(node.type))
      return Unit{};
    std::uint64_t bytes = 128;
    for (const std::string& group : visit.groups)
      bytes += sizeof(std::string) + group.size();
    if (visit.depth > deepestX3dNode || ++m_visits > mostX3dVisits ||
        !granted(bytes * (node.nodes.size() + 1)))
      return tooMany(node);
    X3dVisit inside = visit;
    if (!node.name.empty())
      inside.groups.emplace_back(node.name);
    if (node.type == "Transform")
      inside.toScene *= transformOf(node);
    if (!isFinite(inside.toScene))
      return m_source.atLine(node.place, "its transform is not finite");
    std::span<const X3dNode* const> nodes(node.nodes);
    if (node.type == "Switch") {
      const double choice = fixedNumbers<1>(node, "whichChoice", {-1.0})[0];
      const bool chosen = choice >= 0.0 && choice < double(nodes.size());
      nodes = chosen ? nodes.subspan(std::size_t(choice), 1) : nodes.first(0);
    } else if (node.type == "LOD") {
      nodes = nodes.first(std::min<std::size_t>(1, nodes.size()));
    }
    pushAll(nodes, inside, waiting);
    return Unit{};
  }

  Error tooMany(const X3dNode& node) const {
    return m_source.atLine(node.place,
                           "the scene repeats its parts far beyond the file's size, or in a circle",
                           "Reduce the number of instances");
  }

  bool granted(std::uint64_t bytes) {
    if (bytes > m_budget)
      return false;
    m_budget -= bytes;
    return true;
  }

  void warnOnce(const std::string& reason) {
    if (m_said.insert(reason).second)
      m_result.warnings.push_back(m_source.warning(reason));
  }

  Status addShape(const X3dVisit& visit) {
    const X3dNode& shape = *visit.node;
    for (const X3dNode* child : shape.nodes) {
      if (child->type == "Appearance" || child->type.starts_with("Metadata"))
        continue;
      const auto kind =
          std::find_if(x3dGeometries.begin(), x3dGeometries.end(),
                       [&](const X3dGeometry& known) { return known.type == child->type; });
      if (kind == x3dGeometries.end())
        warnOnce("shapes of kind " + inQuotes(child->type) + " are left out");
      else
        TRY(addGeometry(*child, *kind, visit));
    }
    return Unit{};
  }

  Status addGeometry(const X3dNode& node, const X3dGeometry& kind, const X3dVisit& visit) {
    const X3dNode* coordinates = childOf(node, {"Coordinate", "CoordinateDouble"});
    const std::string_view text = coordinates ? coordinates->field("point") : std::string_view();
    if (!granted(8 * std::uint64_t(text.size()) + 512))
      return tooMany(node);
    const std::vector<double> numbers = numbersIn(text);
    std::vector<glm::vec3> positions(numbers.size() / 3);
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const glm::dvec4 p =
          visit.toScene * glm::dvec4(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2], 1.0);
      positions[i] = {narrowed(p.x), narrowed(p.y), narrowed(p.z)};
    }
    RawMesh mesh = opened(visit);
    const FaceList faces = facesIn(node, kind, positions.size());
    CutTally tally;
    cutFaces({faces, 0, faces.size()}, positions, mesh.triangles, tally);
    TRY(judge(m_source, faces, tally, BadFaces::areErrors, m_result.warnings));
    std::vector<std::uint32_t> scratch;
    keepUsed(positions, scratch, mesh);
    // A mirroring transform turns surfaces inside out, so the triangles are turned as well.
    if (isFalse(node.field("ccw")) != (glm::determinant(glm::dmat3(visit.toScene)) < 0.0))
      for (Triangle& t : mesh.triangles)
        std::swap(t[1], t[2]);
    return finish(m_source, std::move(mesh), m_result);
  }

  /// Opens a surface, named like its group where it is the only shape there.
  RawMesh opened(const X3dVisit& visit) const {
    RawMesh mesh;
    mesh.groups = visit.groups;
    const bool likeGroup = !mesh.groups.empty() && (visit.only || visit.node->name.empty());
    mesh.name = likeGroup ? mesh.groups.back() : std::string(visit.node->name);
    if (likeGroup && visit.only)
      mesh.groups.pop_back();
    mesh.yUp = true;
    if (m_document.metresPerUnit && *m_document.metresPerUnit > 0.0 &&
        *m_document.metresPerUnit < 1e9) {
      mesh.millimetresPerUnit = float(1000.0 * *m_document.metresPerUnit);
      mesh.unitReason = "X3D: unit of length";
    }
    const X3dNode* appearance = childOf(*visit.node, {"Appearance"});
    const X3dNode* material =
        appearance ? childOf(*appearance, {"Material", "TwoSidedMaterial"}) : nullptr;
    if (!material)
      return mesh;
    const auto colour = fixedNumbers<3>(*material, "diffuseColor", {0.8, 0.8, 0.8});
    const auto channel = [&](std::size_t i) {
      return std::uint8_t(std::lround(255.0 * (colour[i] > 0.0 ? std::min(colour[i], 1.0) : 0.0)));
    };
    mesh.colour = Colour{channel(0), channel(1), channel(2)};
    const double opacity = 1.0 - fixedNumbers<1>(*material, "transparency", {0.0})[0];
    if (opacity > 0.0 && opacity < 1.0)
      mesh.opacity = Opacity::clamped(float(opacity));
    return mesh;
  }

  const Source& m_source;
  const X3dDocument& m_document;
  std::uint64_t m_budget;
  std::size_t m_visits = 0;
  RawMeshes m_result;
  std::set<std::string> m_said;
};

}  // namespace

Result<RawMeshes> readX3d(const std::filesystem::path& file, const ReadLimits& limits) {
  const Source source = TRY(Source::read(file, limits));
  const std::string_view text = source.text();
  if (text.starts_with("#VRML V1"))
    return source.whole("is VRML 1.0, of which only 2.0 (VRML97) is read",
                        "Export it as VRML97 or X3D");
  const bool classic = text.starts_with("#VRML") || text.starts_with("#X3D");
  const std::size_t first = text.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  if (!classic && (first == std::string_view::npos || text[first] != '<'))
    return source.whole("begins neither with #VRML V2.0 nor with #X3D nor as XML");
  const X3dDocument document = TRY(classic ? parseX3dClassic(source) : parseX3dXml(source));
  return X3dReader(source, document).read();
}

}  // namespace sline::model
