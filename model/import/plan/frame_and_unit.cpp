// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/frame_and_unit.h"

#include <algorithm>
#include <glm/common.hpp>

#include "model/import/naming/laterality.h"

namespace sline::model {

namespace {

Box boxOf(const std::vector<glm::vec3>& positions) {
  Box box;
  for (const glm::vec3& p : positions)
    box.add(p);
  return box;
}

class FrameDecision {
 public:
  FrameDecision(std::vector<Part>& parts, const Sources& sources, const ImportOptions& options)
      : m_parts(parts), m_sources(sources), m_options(options) {}

  void run(ImportReport& report) {
    const FrameVote vote = voteOnFrame(placesOf([&](const Part& part) { return isSilent(part); }));
    const std::optional<Frame> voted = vote.winner();
    report.frame = voted.value_or(Frame::lps);
    report.frameReason = voted ? vote.text() : "no header and no left/right names: LPS assumed";
    bool silent = false;
    for (Part& part : m_parts) {
      silent = silent || isSilent(part);
      decide(part, report);
    }
    if (!silent && !m_parts.empty()) {
      report.frame = m_parts.front().frame;
      report.frameReason = m_parts.front().provenance.frameReason;
    }
    warnOfContradiction(report);
  }

 private:
  const SlicerModel* modelOf(const Part& part) const {
    const SourceFile& file = m_sources.files[part.file];
    return file.model ? &m_sources.sources[file.source].scene->models[*file.model] : nullptr;
  }
  bool isChosen(const Part& part) const { return m_options.frame || part.choice.frame; }
  bool isSilent(const Part& part) const {
    return !isChosen(part) && !part.raw.frame && !modelOf(part);
  }

  void decide(Part& part, const ImportReport& report) const {
    std::string& reason = part.provenance.frameReason;
    const SlicerModel* model = modelOf(part);
    if (part.choice.frame || m_options.frame) {
      part.frame = part.choice.frame ? *part.choice.frame : *m_options.frame;
      reason = "chosen by the user";
    } else if (part.raw.frame) {
      part.frame = *part.raw.frame;
      reason = (part.raw.molecule || part.raw.yUp ? "" : "header: ") + part.raw.frameReason;
    } else if (model) {
      part.frame = model->frame;
      reason = model->frameReason;
    } else {
      part.frame = report.frame;
      reason = report.frameReason;
    }
  }

  template <class Wanted>
  std::vector<NamedPosition> placesOf(const Wanted& wanted) const {
    std::vector<NamedPosition> places;
    for (const Part& part : m_parts)
      if (wanted(part)) {
        const glm::vec3 centre = boxOf(part.raw.positions).centre();
        places.push_back({part.name, centre.x, centre.y});
      }
    return places;
  }

  /// Warns where names contradict the header: left and right must never be swapped silently, so the
  /// user is told where names clearly say otherwise.
  void warnOfContradiction(ImportReport& report) const {
    if (m_options.frame)
      return;
    for (const Frame frame : {Frame::lps, Frame::ras}) {
      const std::vector<NamedPosition> places = placesOf([&](const Part& part) {
        return part.frame == frame && !isSilent(part) && !isChosen(part);
      });
      const FrameVote vote = voteOnFrame(places);
      const int against = frame == Frame::lps ? vote.ras : vote.lps;
      const int agree = frame == Frame::lps ? vote.lps : vote.ras;
      if (against >= 2 && against > 3 * agree)
        report.warnings.push_back(
            {"", std::to_string(against) + " of " + std::to_string(against + agree) +
                     " left/right names contradict the frame " + frameName(frame) +
                     " that the files give; " + advice(frame, voteOnFront(places))});
    }
  }

  /// Returns what to do where names contradict the sides of the frame.
  static std::string advice(Frame frame, const FrontVote& front) {
    const FrameAxes& axes = axesOf(frame);
    const std::string turned = frameName(frameWith(!axes.left, !axes.posterior));
    const std::string mirrored = frameName(frameWith(!axes.left, axes.posterior));
    const std::optional<bool> back = front.toTheBack();
    if (!back)
      return "if left and right are swapped, choose " + turned +
             " where front and back are swapped too, else " + mirrored;
    return *back == axes.posterior
               ? "front and back are right: if the files are mirrored, choose " + mirrored
               : "front and back are swapped too: choose " + turned;
  }

  std::vector<Part>& m_parts;
  const Sources& m_sources;
  const ImportOptions& m_options;
};

}  // namespace

void decideFrames(std::vector<Part>& parts, const Sources& sources, const ImportOptions& options,
                  ImportReport& report) {
  FrameDecision(parts, sources, options).run(report);
  if (options.frame) {
    report.frame = *options.frame;
    report.frameReason = "chosen by the user";
  }
}

}  // namespace sline::model
