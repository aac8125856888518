// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/frame_decision.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "model/edit/sides.h"
#include "model/import/naming/laterality.h"
#include "model/import/naming/uprightness.h"
#include "model/import/plan/frame_fit.h"
#include "model/import/plan/shape_parts.h"
#include "model/scene/known_frame.h"

namespace sline::model {

namespace {

/// Holds the frame of surfaces whose files are silent about it.
struct SilentFrame {
  Frame frame = Frame::lps;
  std::string reason{nothingTellsFrame};
  SideEvidence evidence{Evidence::assumed, Evidence::assumed};
  bool fits = false;  ///< guessed by where the others lie
};

/// Returns the frame that differs in left and right alone.
Frame mirroredOf(Frame frame) {
  const FrameAxes& axes = axesOf(frame);
  return frameWith(!axes.left, axes.posterior);
}

/// Returns what to do where names contradict the sides of the frame.
std::string adviceAgainst(Frame frame, const FrontVote& front) {
  const FrameAxes& axes = axesOf(frame);
  const std::string turned = frameName(frameWith(!axes.left, !axes.posterior));
  const std::string mirrored = frameName(mirroredOf(frame));
  const std::optional<bool> back = front.toTheBack();
  if (!back)
    return "if left and right are swapped, choose " + turned +
           " where front and back are swapped too, else " + mirrored;
  return *back == axes.posterior
             ? "front and back are right: if the files are mirrored, choose " + mirrored
             : "front and back are swapped too: choose " + turned;
}

/// Returns the scenes that what comes is put into.
std::vector<const Scene*> scenesAround(const ReadInputs& read, const ImportOptions& options) {
  std::vector<const Scene*> scenes;
  if (read.scenes)
    scenes.push_back(&read.scenes->scene);
  if (options.into)
    scenes.push_back(options.into.get());
  return scenes;
}

/// Returns their structures whose frame was assumed; none where they were read in different ones.
std::vector<const Node*> assumedIn(const std::vector<const Scene*>& scenes) {
  std::vector<const Node*> assumed;
  for (const Scene* scene : scenes)
    for (const Node* node : withAssumedFrame(*scene))
      assumed.push_back(node);
  const auto isOther = [&assumed](const Node* node) {
    return node->provenance.frame != assumed.front()->provenance.frame;
  };
  if (std::any_of(assumed.begin(), assumed.end(), isOther))
    assumed.clear();
  return assumed;
}

class FrameDecision {
 public:
  FrameDecision(std::vector<Part>& parts, const ReadInputs& read, const ImportOptions& options)
      : m_parts(parts),
        m_read(read),
        m_sources(read.sources),
        m_options(options),
        m_around(scenesAround(read, options)),
        m_assumed(assumedIn(m_around)) {}

  void run(ImportReport& report) {
    SilentGroup all{.nodes = m_assumed};
    for (Part& part : m_parts)
      if (!isSilent(part))
        decideKnown(part);
      else
        all.parts.push_back(&part);
    const bool silent = !all.parts.empty();
    const bool asked = silent || (!m_parts.empty() && !m_assumed.empty());
    if (asked)
      m_known = knownSurfaces();
    const SilentFrame decided = asked ? silentFrame(all, report) : SilentFrame();
    if (silent || decided.reason != nothingTellsFrame)
      decideAround(decided, report);
    report.frame = decided.frame;
    report.frameReason = decided.reason;
    give(all, decided);
    decideFolders(all, decided, report);
    if (!silent && !m_parts.empty()) {
      report.frame = m_parts.front().frame;
      report.frameReason = m_parts.front().provenance.frameReason;
    }
    markContradictions(report);
  }

 private:
  const SlicerModel* modelOf(const Part& part) const {
    const SourceFile& file = m_sources.files[part.file];
    return file.model ? &m_sources.sources[file.source].scene->models[*file.model] : nullptr;
  }
  bool isChosen(const Part& part) const { return m_options.frame || part.choice.frame; }
  bool isSilent(const Part& part) const {
    return !isChosen(part) && !part.raw.frame && !modelOf(part) && !m_sources.files[part.file].told;
  }

  void decideKnown(Part& part) const {
    std::string& reason = part.provenance.frameReason;
    const SlicerModel* model = modelOf(part);
    part.provenance.evidence = {};
    if (isChosen(part)) {
      part.frame = part.choice.frame ? *part.choice.frame : *m_options.frame;
      part.provenance.evidence = {Evidence::settled, Evidence::settled};
      reason = chosenReason;
    } else if (part.raw.frame) {
      part.frame = *part.raw.frame;
      reason = (part.raw.molecule || part.raw.yUp ? "" : "header: ") + part.raw.frameReason;
    } else if (model) {
      part.frame = model->frame;
      reason = model->frameReason;
    } else {
      part.frame = m_sources.files[part.file].told->frame;
      reason = m_sources.files[part.file].told->frameReason;
    }
  }

  /// Surfaces that are read in one frame.
  struct SilentGroup {
    std::vector<Part*> parts = {};
    std::vector<const Node*> nodes = {};  ///< of the scenes around
  };

  static void give(const SilentGroup& group, const SilentFrame& decided) {
    for (Part* part : group.parts) {
      part->frame = decided.frame;
      part->provenance.frameReason = decided.reason;
      part->provenance.evidence = decided.evidence;
      if (part->raw.onlySideOpen)
        part->provenance.evidence.front = part->provenance.evidence.up = Evidence::known;
    }
  }

  /// Lets the files of each folder decide for themselves where those of others are in another
  /// frame: most likely each folder is of one program.
  void decideFolders(const SilentGroup& all, const SilentFrame& decided, ImportReport& report) {
    std::map<std::filesystem::path, SilentGroup> folders;
    for (Part* part : all.parts)
      folders[m_sources.files[part->file].file.parent_path()].parts.push_back(part);
    if (folders.size() < 2)
      return;
    const bool sure = isSure(decided.evidence.sides);
    for (const auto& [folder, group] : folders) {
      ImportReport own;
      SilentFrame apart = silentFrame(group, own);
      const bool other = apart.frame != decided.frame;
      // A guess of its own is better than one of all together.
      const bool tells = isSure(apart.evidence.sides) || (apart.fits && !sure);
      if (!tells || (sure && !other))
        continue;
      // Where all together are clear, names of a folder alone may be odd ones: a person decides.
      if (sure && apart.reason.starts_with(votedFrame)) {
        apart = decided;
        apart.evidence = {Evidence::conflict, Evidence::conflict};
      }
      give(group, apart);
      if (other)
        report.warnings.push_back(
            {folder.filename().string(),
             sure && !isSure(apart.evidence.sides)
                 ? "names of sides in this folder contradict the frame of the others, " +
                       frameName(decided.frame) + "; it was taken, and is not certain here"
                 : "the files of this folder are read as " + frameName(apart.frame) +
                       ", unlike others: " + apart.reason});
    }
  }

  /// Decides for what is there already as for what comes, where that was assumed, too.
  void decideAround(const SilentFrame& decided, ImportReport& report) const {
    if (m_assumed.empty() || m_parts.empty())
      return;
    const Provenance& now = m_assumed.front()->provenance;
    const FrameAnew anew{frameName(decided.frame), decided.reason, decided.evidence};
    const std::optional<SideAnswer> answer = answerBetween(now.frame, anew.frame);
    const bool same = answer == SideAnswer::right;
    if (!answer || (same && !isSure(anew.evidence.sides)))
      return;
    report.frameAnew = anew;
    report.notes.push_back(
        same ? "left and right of what was there already are certain now: " + decided.reason
             : "what was there already is read as " + anew.frame + " now: " + decided.reason);
  }

  template <class Wanted>
  std::vector<NamedPosition> placesOf(const Wanted& wanted) const {
    std::vector<NamedPosition> places;
    for (const Part& part : m_parts)
      if (wanted(part)) {
        Box box;
        for (const glm::vec3& p : part.raw.positions)
          box.add(part.raw.yUp ? uprightToLps(p) : p);
        const glm::vec3 centre = box.centre();
        places.push_back({part.name, centre.x, centre.y, 0.5f * box.size().x, centre.z});
      }
    return places;
  }

  /// Returns the places of the group's surfaces in the coordinates of their files.
  std::vector<NamedPosition> silentPlaces(const SilentGroup& group) const {
    const std::set<const Part*> parts(group.parts.begin(), group.parts.end());
    std::vector<NamedPosition> places =
        placesOf([&parts](const Part& part) { return parts.contains(&part); });
    for (const Node* node : group.nodes) {
      const Box box = node->mesh->bounds();
      const FrameAxes& axes = axesOf(node->provenance.frame);
      const float unit = std::max(node->provenance.mmPerUnit, 1e-6f);
      const glm::vec3 centre = box.centre() / unit;
      places.push_back({node->name, axes.left ? centre.x : -centre.x,
                        axes.posterior ? centre.y : -centre.y, 0.5f * box.size().x / unit,
                        centre.z});
    }
    return places;
  }

  std::vector<LyingSurface> knownSurfaces() const {
    std::vector<LyingSurface> known;
    for (const Part& part : m_parts)
      if (!isSilent(part) && part.frame != Frame::file)
        known.push_back(lyingIn(part, part.frame, toWorldOf(part, m_sources)));
    for (const Scene* scene : m_around)
      for (const Node& node : scene->nodes())
        if (!node.isGroup() && node.provenance.frame != fileFrame &&
            node.provenance.evidence.isSure())
          known.push_back(lyingIn(node));
    return known;
  }

  FrameSides sidesOf(const SilentGroup& group) const {
    FrameSides sides{.known = m_known, .silent = {}};
    for (const Part* part : group.parts)
      sides.silent.push_back(lyingIn(*part, Frame::lps, {}));
    for (const Node* node : group.nodes)
      sides.silent.push_back(
          readAgainAs(lyingIn(*node), axesOf(node->provenance.frame).frame, Frame::lps));
    return sides;
  }

  SilentFrame silentFrame(const SilentGroup& group, ImportReport& report) const {
    const std::vector<NamedPosition> places = silentPlaces(group);
    const FrameVote vote = voteOnFrame(places);
    const FrontVote front = voteOnFront(places);
    const FrameSides sides = sidesOf(group);
    const FrameFit laid = laidOverSameNames(sides, m_read);
    const FrameFit fit = fittedIn(sides);
    SilentFrame decided;
    if (laid.frame)
      decided = {*laid.frame, laid.reason, {Evidence::voted, Evidence::voted}};
    else if (vote.isClear())
      decided = {*vote.winner(), vote.text(), {Evidence::voted, Evidence::assumed}};
    else if (fit.frame)
      decided = {*fit.frame, fit.reason, {Evidence::assumed, Evidence::assumed}, true};
    else
      decided = weakly(vote, front);
    if (front.toTheBack() == axesOf(decided.frame).posterior)
      decided.evidence.front = Evidence::voted;
    compare(decided, vote, fit);
    if (!laid.frame && isSure(decided.evidence.sides) && vote.winner() &&
        axesOf(*vote.winner()).left != axesOf(decided.frame).left)
      decided.evidence.sides = Evidence::assumed;
    compareFront(decided, front, report);
    decided.evidence.up = laid.frame ? Evidence::voted : uprightEvidence(places);
    if (decided.evidence.up == Evidence::conflict) {
      decided.evidence = {Evidence::conflict, Evidence::conflict, Evidence::conflict};
      report.warnings.push_back({"", std::string(notUpright)});
    } else if (fit.frame) {
      decided.evidence.up = Evidence::voted;  // it fits where the others are upright
    }
    if (fit.none && !decided.evidence.isSure())
      report.warnings.push_back(
          {"",
           "surfaces whose files do not say their frame lie beside the others, whether they "
           "are read as LPS or as RAS; " +
               frameName(decided.frame) + " was assumed"});
    return decided;
  }

  /// Decides where nothing is clear: by what there is.
  static SilentFrame weakly(const FrameVote& vote, const FrontVote& front) {
    SilentFrame decided;
    if (const std::optional<Frame> winner = vote.winner()) {
      decided.frame = *winner;
      decided.reason = vote.text();
    } else if (const std::optional<bool> back = front.toTheBack()) {
      decided.frame = *back ? Frame::lps : Frame::ras;
      decided.reason = "names of front and back alone";
    }
    return decided;
  }

  /// Lets the evidence fall where others speak against what has decided.
  static void compare(SilentFrame& decided, const FrameVote& vote, const FrameFit& fit) {
    const bool left = axesOf(decided.frame).left;
    const bool names = vote.isClear() && axesOf(*vote.winner()).left != left;
    const bool place = fit.frame && *fit.frame != decided.frame;
    if (names || place)
      decided.evidence = {Evidence::conflict, Evidence::conflict};
  }

  static void compareFront(SilentFrame& decided, const FrontVote& front, ImportReport& report) {
    const std::optional<bool> back = front.toTheBack();
    if (!back || *back == axesOf(decided.frame).posterior)
      return;
    decided.evidence = {Evidence::conflict, Evidence::conflict};
    const FrameAxes& axes = axesOf(decided.frame);
    report.warnings.push_back({"", "names of front and back contradict the frame " +
                                       frameName(decided.frame) +
                                       "; if the files are mirrored, choose " +
                                       frameName(frameWith(axes.left, !axes.posterior))});
  }

  /// Marks files whose frame pairs of names contradict, and warns: left and right must never be
  /// swapped silently. What lies on one side by nature, or alone on its side, is too little against
  /// a file that states its frame.
  void markContradictions(ImportReport& report) {
    for (const FrameAxes& axes : frames) {
      const auto stated = [&](const Part& part) {
        return part.frame == axes.frame && axes.frame != Frame::file && !isSilent(part) &&
               !isChosen(part);
      };
      const std::vector<NamedPosition> places = placesOf(stated);
      const FrameVote vote = voteOnFrame(places);
      if (!vote.refutes(axes.left))
        continue;
      const FrontVote front = voteOnFront(places);
      const std::optional<bool> back = front.toTheBack();
      for (Part& part : m_parts)
        if (stated(part)) {
          part.provenance.evidence.sides = Evidence::conflict;
          if (!part.raw.onlySideOpen && !(back && *back == axes.posterior))
            part.provenance.evidence.front = Evidence::conflict;
        }
      const int against = std::max(vote.lps, vote.ras);
      report.warnings.push_back(
          {"", std::to_string(against) + " of " + std::to_string(vote.lps + vote.ras) +
                   " left/right names contradict the frame " + frameName(axes.frame) +
                   " that the files give; " + adviceAgainst(axes.frame, front)});
    }
  }

  std::vector<Part>& m_parts;
  const ReadInputs& m_read;
  const Sources& m_sources;
  const ImportOptions& m_options;
  std::vector<const Scene*> m_around;
  std::vector<const Node*> m_assumed;  ///< structures of these
  std::vector<LyingSurface> m_known;
};

}  // namespace

void decideFrames(std::vector<Part>& parts, const ReadInputs& read, const ImportOptions& options,
                  ImportReport& report) {
  // Where surfaces fit depends on how large they are: a unit that was chosen counts.
  for (Part& part : parts)
    part.unit = part.choice.unit.value_or(options.unit.value_or(part.raw.millimetresPerUnit));
  FrameDecision(parts, read, options).run(report);
  if (options.frame) {
    report.frame = *options.frame;
    report.frameReason = chosenReason;
  }
}

}  // namespace sline::model
