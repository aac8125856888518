// SPDX-License-Identifier: Apache-2.0
#include "widgets/import_dialog/plan_figures.h"

#include <algorithm>
#include <set>

#include "model/import/naming/laterality.h"
#include "model/import/naming/other_sides.h"
#include "model/import/plan/read_inputs.h"
#include "widgets/import_dialog/scan_slices.h"

namespace sline::widgets {

namespace {

void add(StructureFigures& to, const StructureFigures& more) {
  to.triangles += more.triangles;
  to.structures += more.structures;
  to.box.add(more.box);
}

void compareSides(const model::ImportPlan& plan, PlanFigures& figures) {
  std::set<std::string> frames;
  const auto [ids, places] = model::sidedPlaces(plan.scene);
  for (const model::NodeId id : ids)
    if (plan.parts.contains(id))
      frames.insert(plan.scene.find(id)->provenance.frame);
  for (const model::NodeId id : model::onOtherSide(plan.scene))
    if (plan.parts.contains(id)) {
      figures.otherSide.push_back(id);
      figures.nodes[id.value].otherSide = true;
    }
  const model::FrameVote vote = model::voteOnFrame(places);
  figures.sidesAgree = vote.lps;
  if (frames.size() != 1)
    return;
  // The places are in LPS, as the frame at hand makes them.
  const model::FrameAxes& axes = model::axesOf(*frames.begin());
  figures.mirrors = model::voteOnFront(places).toTheBack().value_or(false);
  figures.sidesRight =
      model::frameWith(!axes.left, figures.mirrors ? axes.posterior : !axes.posterior);
}

}  // namespace

PlanFigures figuresOf(const model::ImportPlan& plan, const PlanFigures& before) {
  PlanFigures figures;
  const std::vector<model::Node>& nodes = plan.scene.nodes();
  // Children come first, so that a group is complete when it is added to its parent.
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const model::Node& node = nodes[i];
    StructureFigures& own = figures.nodes[node.id.value];
    if (!node.isGroup())
      own = {.triangles = node.mesh->triangleCount(), .structures = 1, .box = node.mesh->bounds()};
    const StructureFigures whole = own;
    add(node.parent == model::rootId ? figures.all : figures.nodes[node.parent.value], whole);
  }
  compareSides(plan, figures);
  if (!plan.read)
    return figures;
  for (const model::ReadScan& scan : plan.read->scans) {
    const auto known =
        std::find_if(before.scans.begin(), before.scans.end(),
                     [&](const auto& shown) { return shown->volume == scan.raw.volume; });
    figures.scans.push_back(known != before.scans.end()
                                ? *known
                                : std::make_shared<const ScanFigures>(scanFiguresOf(scan)));
  }
  std::set<const void*> entries;
  std::size_t molecules = 0;
  for (const model::Part& part : plan.read->parts)
    if (part.raw.molecule) {
      ++molecules;
      entries.insert(part.raw.molecule->backbone.get());
    }
  figures.molecules = molecules > 0 && molecules == plan.read->parts.size();
  figures.entries = int(entries.size());
  return figures;
}

float extent(const model::Box& box) {
  if (box.empty())
    return 0.0f;
  const glm::vec3 size = box.size();
  return std::max({size.x, size.y, size.z});
}

}  // namespace sline::widgets
