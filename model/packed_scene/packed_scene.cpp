// SPDX-License-Identifier: Apache-2.0
#include "model/packed_scene/packed_scene.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "model/packed_scene/byte_stream.h"
#include "model/packed_scene/packed_mesh.h"

namespace sline::model {

namespace {

using packing::ByteReader;
using packing::ByteWriter;

constexpr std::string_view sceneMagic = "SlPS";
constexpr std::uint32_t packedSchema = 1;
/// More than any mesh or scene that a browser could show.
constexpr std::size_t largestPart = std::size_t(1) << 30;

/// Keeps each mesh's packed form, so that it is made once.
class Packings {
 public:
  struct Entry {
    PackedMesh packed;
    MeshPtr mesh;  ///< as it will be unpacked
  };
  const Entry& of(const MeshPtr& mesh) {
    Entry& entry = m_entries[mesh];
    if (!entry.mesh) {
      entry.packed = packedMesh(*mesh);
      Result<Mesh> again = unpackedMesh(entry.packed.bytes);
      entry.mesh = std::make_shared<const Mesh>(std::move(*again));
      m_bytes[entry.mesh] = entry.packed.bytes;
    }
    return entry;
  }
  /// Returns the bytes of an unpacked mesh.
  const std::string& bytesOf(const MeshPtr& mesh) const { return m_bytes.at(mesh); }

 private:
  std::map<MeshPtr, Entry> m_entries;
  std::map<MeshPtr, std::string> m_bytes;
};

PaintPtr packedPaint(const Paint& paint, const PackedMesh& packed) {
  Paint moved;
  moved.reserve(packed.vertices.size());
  for (const std::uint32_t vertex : packed.vertices)
    moved.push_back(paint[vertex]);
  return std::make_shared<const Paint>(std::move(moved));
}

/// Returns the place on the packed mesh.
SurfacePoint packedPoint(SurfacePoint point, const PackedMesh& packed) {
  const PackedMesh::Place& place = packed.places[point.triangle];
  const std::array<float, 3> weights{1.0f - point.weights[0] - point.weights[1], point.weights[0],
                                     point.weights[1]};
  const auto at = [&](std::size_t corner) {
    return std::clamp(weights[(place.first + corner) % 3], 0.0f, 1.0f);
  };
  point.triangle = place.triangle;
  point.weights = {at(1), std::min(at(2), 1.0f - at(1))};
  return point;
}

ViewWords withoutWords(const ViewWords& words) {
  return {.title = {}, .text = {}, .notes = {}, .description = {}, .seconds = words.seconds};
}

/// Takes away what no page shows.
Node published(Node node, bool names) {
  Provenance kept;
  // These decide how smooth the surface is drawn (render/drawn/prepared_surface.h).
  kept.smoothingSteps = node.provenance.smoothingSteps;
  kept.refinementSteps = node.provenance.refinementSteps;
  kept.sliceMm = node.provenance.sliceMm;
  kept.evidence = node.provenance.evidence;
  kept.nameEvidence = node.provenance.nameEvidence;
  kept.unitEvidence = node.provenance.unitEvidence;
  node.provenance = kept;
  node.atoms = {};
  node.unread.clear();
  if (!names)
    node.name = std::to_string(node.id.value);
  return node;
}

class ScenePacker {
 public:
  ScenePacker(const Scene& scene, const PackingChoice& choice) : m_scene(scene), m_choice(choice) {}

  PackedScene pack() {
    PackedScene packed;
    const Scene whole = published({});
    if (m_choice.later.empty()) {
      packed.first = part(whole);
      return packed;
    }
    packed.first = part(published(m_choice.later));
    packed.rest = part(whole);
    return packed;
  }

 private:
  /// Returns the scene with packed meshes; structures that are left out have a mesh of nothing.
  Scene published(const std::set<NodeId>& left) {
    Scene scene = m_scene;
    std::vector<Node> nodes;
    for (const Node& node : m_scene.nodes()) {
      nodes.push_back(model::published(node, m_choice.names));
      Node& out = nodes.back();
      if (!node.mesh)
        continue;
      if (left.contains(node.id)) {
        out.mesh = m_packings.of(m_nothing).mesh;
        out.paint.reset();
        continue;
      }
      const Packings::Entry& entry = m_packings.of(node.mesh);
      out.mesh = entry.mesh;
      if (node.paint)
        out.paint = packedPaint(*node.paint, entry.packed);
    }
    scene.setAnnotations({});
    scene.setNodes(std::move(nodes));
    scene.setAnnotations(annotations(left));
    scene.setViews(views(scene));
    scene.setScans({});
    scene.setTraces({});
    scene.setUnread({});
    return scene;
  }

  std::vector<Annotation> annotations(const std::set<NodeId>& left) {
    std::vector<Annotation> kept;
    for (Annotation annotation : m_scene.annotations()) {
      bool there = true;
      for (Anchor& anchor : annotation.anchors)
        if (auto* point = std::get_if<SurfacePoint>(&anchor)) {
          const Node* node = m_scene.find(point->structure);
          there = there && node && node->mesh && !left.contains(node->id);
          if (there)
            *point = packedPoint(*point, m_packings.of(node->mesh).packed);
        }
      annotation.unread.clear();
      if (!m_choice.names) {
        annotation.text = std::to_string(annotation.id.value);
        annotation.texts.clear();
      }
      if (there)
        kept.push_back(std::move(annotation));
    }
    return kept;
  }

  std::vector<View> views(const Scene& scene) const {
    std::vector<View> views = m_scene.views();
    for (View& view : views) {
      view.words.notes = {};
      view.unread.clear();
      if (!m_choice.names) {
        view.words = withoutWords(view.words);
        view.name = std::to_string(&view - views.data() + 1);
      }
      if (view.annotations)
        std::erase_if(*view.annotations, [&](AnnotationId id) {
          const auto& all = scene.annotations();
          return std::none_of(all.begin(), all.end(),
                              [id](const Annotation& a) { return a.id == id; });
        });
    }
    return views;
  }

  /// Writes scene.json and the meshes that no part before has had.
  std::string part(const Scene& scene) {
    ByteWriter out;
    out.raw(sceneMagic);
    out.word(packedSchema);
    out.block(sceneJson(scene));
    const auto names = meshNames(scene);
    for (const Node& node : scene.nodes()) {  // in the tree's order, which is the same each time
      const std::string name = node.mesh ? names.at(node.mesh) : std::string();
      if (node.mesh &&
          m_written.insert(name + (node.mesh->triangleCount() == 0 ? " (nothing)" : "")).second) {
        out.block(name);
        out.block(m_packings.bytesOf(node.mesh));
      }
    }
    for (const Node& node : scene.nodes())
      if (const std::string name = paintName(node.id);
          node.paint && m_written.insert(name).second) {
        out.block(name);
        out.block(std::string(node.paint->begin(), node.paint->end()));
      }
    return out.take();
  }

  const Scene& m_scene;
  const PackingChoice& m_choice;
  Packings m_packings;
  std::set<std::string> m_written;
  MeshPtr m_nothing = std::make_shared<const Mesh>(std::move(Mesh::create({}, {}).value()));
};

}  // namespace

PackedScene packedScene(const Scene& scene, const PackingChoice& choice) {
  return ScenePacker(scene, choice).pack();
}

Status UnpackedScene::take(std::string_view bytes) {
  ByteReader in(bytes);
  if (bytes.size() > largestPart || in.raw(sceneMagic.size()) != sceneMagic ||
      in.word() != packedSchema)
    return Error{.reason = "these bytes hold no packed scene of this version"};
  Result<Json> root = parseJson(in.block(), sceneJsonLimits);
  if (in.failed() || !root.ok())
    return in.failed() ? Error{.reason = "the packed scene is cut short"} : root.error();
  SceneParts parts{m_meshes, m_paints, {}};
  const std::vector<std::string> paints = paintsCalledFor(*root);
  while (!in.atEnd()) {
    const std::string name(in.block());
    const std::string_view content = in.block();
    if (in.failed())
      return Error{.reason = "the packed scene is cut short"};
    if (std::find(paints.begin(), paints.end(), name) != paints.end()) {
      parts.paints[name] = std::make_shared<const Paint>(content.begin(), content.end());
      continue;
    }
    Mesh mesh = TRY(unpackedMesh(content));
    parts.meshes[name] = std::make_shared<const Mesh>(std::move(mesh));
  }
  m_scene = TRY(sceneFromJson(*root, parts));
  m_meshes = std::move(parts.meshes);
  m_paints = std::move(parts.paints);
  return Unit{};
}

}  // namespace sline::model
