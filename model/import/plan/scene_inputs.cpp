// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/scene_inputs.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "model/scene/scene_limits.h"
#include "model/scene_file/scene_file.h"

namespace sline::model {

namespace {

/// Returns what decided the frame when the scene's first structure was imported.
std::string frameReasonOf(const Scene& scene) {
  const auto& nodes = scene.nodes();
  const auto found = std::find_if(nodes.begin(), nodes.end(), [](const Node& node) {
    return !node.provenance.frameReason.empty();
  });
  return found == nodes.end() ? "scene file" : found->provenance.frameReason;
}

/// Returns the section with its scope mapped. Sections get fresh ids in the scene; those of a view
/// keep theirs, which are its own.
Section moved(Section section, const NewIds& ids) {
  const auto scope = ids.find(section.scope);
  section.scope = scope == ids.end() ? rootId : scope->second;
  return section;
}

/// Returns the new id; nothing for a node that is not in the scene, as with a scope.
NodeId movedId(NodeId id, const NewIds& ids) {
  const auto found = ids.find(id);
  return found == ids.end() ? NodeId{} : found->second;
}

/// Maps the targets of what Γ follows; a map that has none in the scene goes.
void move(Style& style, const NewIds& ids) {
  if (!style.gammaMap || style.gammaMap->targets.empty())
    return;
  for (NodeId& id : style.gammaMap->targets)
    id = movedId(id, ids);
  std::erase(style.gammaMap->targets, rootId);
  if (style.gammaMap->targets.empty() && !style.gammaMap->place)
    style.gammaMap.reset();
}

void moveIn(std::vector<Look>& looks, const NewIds& ids) {
  for (Look& look : looks) {
    look.node = movedId(look.node, ids);
    move(look.style, ids);
  }
  std::erase_if(looks, [](const Look& look) { return look.node == rootId; });
}

Annotation moved(Annotation annotation, const NewIds& ids) {
  for (Anchor& anchor : annotation.anchors)
    if (auto* point = std::get_if<SurfacePoint>(&anchor))
      point->structure = movedId(point->structure, ids);
  return annotation;
}

Focus moved(Focus focus, const NewIds& ids) {
  const auto isNowhere = [](NodeId id) { return id == rootId; };
  for (NodeId& id : focus.targets)
    id = movedId(id, ids);
  std::erase_if(focus.targets, isNowhere);
  std::map<NodeId, ContextRole> roles;
  for (const auto& [id, role] : focus.wishes.roles)
    if (const NodeId now = movedId(id, ids); !isNowhere(now))
      roles[now] = role;
  focus.wishes.roles = std::move(roles);
  moveIn(focus.given, ids);
  return focus;
}

View moved(View view, const NewIds& ids, const std::map<AnnotationId, AnnotationId>& noteIds) {
  if (view.sections)
    for (Section& section : *view.sections)
      section = moved(section, ids);
  if (view.looks)
    moveIn(*view.looks, ids);
  if (view.annotations) {
    std::vector<AnnotationId> shown;
    for (const AnnotationId old : *view.annotations)
      if (const auto found = noteIds.find(old); found != noteIds.end())
        shown.push_back(found->second);
    view.annotations = std::move(shown);
  }
  if (view.focus)
    view.focus = moved(std::move(*view.focus), ids);
  return view;
}

}  // namespace

namespace {

/// Gives out ids that no node of the scene has: those after its last, as long as they can be kept.
class FreshIds {
 public:
  explicit FreshIds(Scene scene) {
    for (const Node& node : scene.nodes())
      m_taken.insert(node.id.value);
    m_next = scene.append({}).value;
  }
  NodeId next() {
    while (m_next > largestId || !m_taken.insert(m_next).second)
      m_next = m_next >= largestId ? 1 : m_next + 1;
    return NodeId{m_next};
  }

 private:
  std::unordered_set<std::uint64_t> m_taken;
  std::uint64_t m_next = 0;
};

}  // namespace

void warnOfOptions(const ImportOptions& options, std::vector<ImportWarning>& warnings) {
  if (options.frame || options.unit)
    warnings.push_back({"",
                        "a scene file is in millimetres of the patient's frame; the frame and "
                        "the unit that were chosen do not apply to it"});
  if (options.decimateMm > 0.0f)
    warnings.push_back({"",
                        "surfaces of a scene file keep their triangles; only what is imported "
                        "is decimated"});
}

NewIds append(Scene& to, const Scene& added) {
  NewIds ids{{rootId, rootId}};
  // The nodes are added all at once: appending them one by one would look through the whole scene
  // for each.
  std::vector<Node> nodes = to.nodes();
  FreshIds fresh(to);
  for (Node node : added.nodes()) {
    const NodeId old = node.id;
    node.parent = ids.at(node.parent);
    node.id = fresh.next();
    ids[old] = node.id;
    nodes.push_back(std::move(node));
  }
  for (std::size_t i = nodes.size() - added.nodes().size(); i < nodes.size(); ++i)
    move(nodes[i].style, ids);
  to.setNodes(std::move(nodes));
  for (const Section& section : added.sections())
    to.appendSection(moved(section, ids));
  std::map<AnnotationId, AnnotationId> noteIds;
  for (const Annotation& annotation : added.annotations())
    noteIds[annotation.id] = to.appendAnnotation(moved(annotation, ids));
  std::vector<View> views = to.views();
  for (const View& view : added.views())
    views.push_back(moved(view, ids, noteIds));
  to.setViews(std::move(views));
  std::vector<Scan> scans = to.scans();
  scans.insert(scans.end(), added.scans().begin(), added.scans().end());
  to.setScans(std::move(scans));
  std::vector<SourceTrace> traces = to.traces();
  addTraces(traces, added.traces());
  to.setTraces(std::move(traces));
  if (to.focus() == Focus())
    to.setFocus(moved(added.focus(), ids));
  if (!to.keyLight())
    to.setKeyLight(added.keyLight());
  if (to.unread().empty())
    to.setUnread(added.unread());
  return ids;
}

NewIds append(Imported& to, Imported added) {
  NewIds ids = append(to.scene, added.scene);
  const auto take = [](auto& all, auto& more) {
    std::move(more.begin(), more.end(), std::back_inserter(all));
  };
  take(to.report.warnings, added.report.warnings);
  take(to.report.notes, added.report.notes);
  take(to.report.unitDoubts, added.report.unitDoubts);
  take(to.report.repairs.surfaces, added.report.repairs.surfaces);
  // Scene files come first and repair nothing, so at most one has something to say.
  to.report.repairs.summary += added.report.repairs.summary;
  take(to.others, added.others);
  return ids;
}

Result<OpenedScenes> openScenes(std::span<const std::filesystem::path> files,
                                const ImportOptions& options) {
  OpenedScenes opened;
  Imported& all = opened.all;
  PatientSorter sorter;
  if (options.into)
    sorter.add({openSceneName, options.into->traces()});
  for (const std::filesystem::path& file : files) {
    SceneDocument document = TRY(readSceneFile(file));
    PatientSorter with = sorter;
    with.add({file, document.scene.traces()});
    const Patients patients = with.patients();
    if (patients.several() && options.patients == PatientsWanted::one)
      return patients.error();
    if (patients.several() && options.patients == PatientsWanted::first) {
      all.report.warnings.push_back({file.string(), otherPatient});
      continue;
    }
    sorter = std::move(with);
    opened.traced.push_back({file, document.scene.traces()});
    Imported one{.scene = std::move(document.scene), .others = std::move(document.others)};
    if (const std::string warning = document.warning(); !warning.empty())
      one.report.warnings.push_back({file.string(), warning});
    if (&file == &files.front())
      all = std::move(one);  // alone it keeps its ids
    else
      append(all, std::move(one));
  }
  all.report.frameReason = frameReasonOf(all.scene);
  warnOfOptions(options, all.report.warnings);
  return opened;
}

}  // namespace sline::model
