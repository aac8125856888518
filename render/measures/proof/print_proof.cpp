// SPDX-License-Identifier: Apache-2.0
#include "render/measures/proof/print_proof.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <map>
#include <set>

#include "model/edit/look.h"
#include "render/measures/proof/picture_reader.h"

namespace sline::render {

namespace {

/// Predicted differences should exceed the limit by this factor, and by as much more for each
/// change that did not help: it is not predicted how strokes and things shining through dilute a
/// colour.
constexpr double reserve = 1.15;
constexpr double moreReserve = 0.45;
constexpr int mostRounds = 5;
/// After this many colours that did not help, Γ is changed.
constexpr std::size_t mostColours = 3;

ProofPair pairOf(const SeenStructure& a, const SeenStructure& b, const ProofSettings& settings) {
  ProofPair pair{.a = a.id, .b = b.id};
  for (std::size_t i = 0; i < visionCount; ++i)
    pair.difference[i] = colourDifference(labOf(simulateVision(a.light, visions[i])),
                                          labOf(simulateVision(b.light, visions[i])));
  pair.similarGamma = std::abs(a.gamma - b.gamma) < settings.leastGammaStep - 1e-4f;
  return pair;
}

std::vector<ProofPair> pairsOf(const SeenPicture& picture, const ProofSettings& settings) {
  std::vector<ProofPair> pairs;
  for (const SharedBorder& border : picture.borders) {
    pairs.push_back(pairOf(picture.structures[border.a], picture.structures[border.b], settings));
    pairs.back().border = border.length;
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const ProofPair& a, const ProofPair& b) { return a.border > b.border; });
  return pairs;
}

/// Tells which pairs are to be mended. Pairs that look alike on the screen from the start may be
/// intended, and are left alone unless all are wanted.
class Bar {
 public:
  Bar(const std::vector<ProofPair>& pairs, const ProofSettings& settings) : m_settings(settings) {
    for (const ProofPair& pair : pairs)
      (pair.alikeOnScreen(settings) ? m_meant : m_told).insert({pair.a, pair.b});
  }
  bool fails(const ProofPair& pair) const {
    if (!pair.alikeAnywhere(m_settings))
      return false;
    const std::pair<model::NodeId, model::NodeId> ids{pair.a, pair.b};
    const bool meant =
        m_meant.contains(ids) || (!m_told.contains(ids) && pair.alikeOnScreen(m_settings));
    return m_settings.all || !meant;
  }
  bool anyFails(const std::vector<ProofPair>& pairs) const {
    return std::any_of(pairs.begin(), pairs.end(),
                       [this](const ProofPair& pair) { return fails(pair); });
  }
  ProofPair compare(const SeenStructure& a, const SeenStructure& b) const {
    return pairOf(a, b, m_settings);
  }

 private:
  using Ids = std::set<std::pair<model::NodeId, model::NodeId>>;
  const ProofSettings& m_settings;
  Ids m_meant;
  Ids m_told;
};

/// Returns colours to try, those nearest to the old one first: lighter and darker, then of another
/// hue.
std::vector<Colour> otherColours(const Colour& colour) {
  const glm::dvec3 old = labOf(linearLightOf(colour));
  const double chroma = std::max(std::hypot(old.y, old.z), 20.0);
  const double hue = std::atan2(old.z, old.y);
  std::vector<std::pair<double, Colour>> found;
  for (const double turn : {0.0, 0.6, -0.6, 1.2, -1.2, 2.2, -2.2, 3.14})
    for (int step = -8; step <= 8; ++step) {
      const double lightness = old.x + 8.0 * step;
      if (lightness < 12.0 || lightness > 94.0 || (step == 0 && turn == 0.0))
        continue;
      // Chroma is given up until the screen can show the colour.
      for (double share = 1.0; share > 0.2; share -= 0.1) {
        const double c = share * (turn == 0.0 ? std::hypot(old.y, old.z) : chroma);
        const glm::dvec3 lab(lightness, c * std::cos(hue + turn), c * std::sin(hue + turn));
        const glm::vec3 light = lightOf(lab);
        if (std::min({light.r, light.g, light.b}) < -0.002f ||
            std::max({light.r, light.g, light.b}) > 1.002f)
          continue;
        // A hue tells what something is; lightness does so less.
        found.emplace_back(colourDifference(old, lab) + 14.0 * std::abs(turn), colourOf(light));
        break;
      }
    }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Colour> colours;
  colours.reserve(found.size());
  for (const auto& [far, other] : found)
    colours.push_back(other);
  return colours;
}

/// Returns the structure's light with another colour; shading and tints keep their share of the
/// colour's light.
glm::vec3 recoloured(const SeenStructure& structure, const Colour& colour) {
  const glm::vec3 before = glm::max(linearLightOf(structure.colour), glm::vec3(0.01f));
  return glm::min(structure.light * linearLightOf(colour) / before, glm::vec3(1.0f));
}

/// Chooses changes from what was seen and, after each further look, from their results.
class Mender {
 public:
  Mender(const Bar& bar, SeenPicture picture) : m_bar(bar), m_first(std::move(picture)) {}

  const std::vector<ProofProposal>& proposals() const { return m_proposals; }

  /// Chooses a change for each pair that counts, until none fails; returns false where nothing is
  /// left to try.
  bool choose(const SeenPicture& now) {
    bool any = false;
    m_now = now;
    std::set<model::NodeId> changed;
    for (const SharedBorder& border : bordersByLength()) {
      const ProofPair pair = m_bar.compare(m_now.structures[border.a], m_now.structures[border.b]);
      if (!m_bar.fails(pair) || changed.contains(pair.a) || changed.contains(pair.b))
        continue;
      // The smaller one: less of the picture changes.
      std::array<std::size_t, 2> both{border.a, border.b};
      if (m_now.structures[both[1]].share < m_now.structures[both[0]].share)
        std::swap(both[0], both[1]);
      for (const std::size_t which : both)
        if (mend(which)) {
          changed.insert(m_now.structures[which].id);
          any = true;
          break;
        }
    }
    return any;
  }

  /// Takes back the proposals for structures that still look like a neighbour; returns false where
  /// there was nothing to take back.
  bool drop(const std::vector<ProofPair>& pairs) {
    std::set<model::NodeId> failed;
    for (const ProofPair& pair : pairs)
      if (m_bar.fails(pair))
        failed.insert({pair.a, pair.b});
    return std::erase_if(m_proposals, [&](const ProofProposal& proposal) {
             return failed.contains(proposal.node);
           }) > 0;
  }

 private:
  std::vector<SharedBorder> bordersByLength() const {
    std::vector<SharedBorder> borders = m_now.borders;
    std::stable_sort(borders.begin(), borders.end(),
                     [](const auto& a, const auto& b) { return a.length > b.length; });
    return borders;
  }

  /// Tells whether `changed` would look like none of the neighbours from which it is to differ.
  bool fits(std::size_t which, const SeenStructure& changed) const {
    const auto tried = m_triedColours.find(changed.id);
    const double failures = tried == m_triedColours.end() ? 0.0 : double(tried->second.size());
    const double caution = reserve + moreReserve * failures;
    for (const SharedBorder& border : m_now.borders) {
      if (border.a != which && border.b != which)
        continue;
      const SeenStructure& other = m_now.structures[border.a == which ? border.b : border.a];
      // In the order of the ids, as the bar knows them.
      ProofPair after =
          border.a == which ? m_bar.compare(changed, other) : m_bar.compare(other, changed);
      for (double& difference : after.difference)
        difference /= caution;
      if (m_bar.fails(after))
        return false;
    }
    return true;
  }

  bool mend(std::size_t which) {
    SeenStructure& structure = m_now.structures[which];
    if (structure.locked)
      return false;
    std::set<Colour>& tried = m_triedColours[structure.id];
    if (structure.coloured && tried.size() < mostColours)
      for (const Colour& colour : otherColours(firstColourOf(structure))) {
        SeenStructure changed = structure;
        changed.light = recoloured(structure, colour);
        changed.colour = colour;
        if (tried.contains(colour) || !fits(which, changed))
          continue;
        tried.insert(colour);
        propose({.node = structure.id, .colour = colour, .gamma = {}});
        structure = changed;
        return true;
      }
    std::set<float>& triedGammas = m_triedGammas[structure.id];
    for (const float step : {-1.0f, 1.0f, -1.5f, 1.5f, -2.0f, 2.0f}) {
      SeenStructure changed = structure;
      changed.gamma = structure.gamma + step;
      if (changed.gamma < 0.0f || changed.gamma > 5.0f || triedGammas.contains(changed.gamma) ||
          !fits(which, changed))
        continue;
      triedGammas.insert(changed.gamma);
      propose({.node = structure.id, .colour = {}, .gamma = Gamma::from(changed.gamma)});
      structure = changed;
      return true;
    }
    return false;
  }

  /// Returns the scene's own colour, as steps count from it and not from the last attempt's.
  Colour firstColourOf(const SeenStructure& structure) const {
    for (const SeenStructure& first : m_first.structures)
      if (first.id == structure.id)
        return first.colour;
    return structure.colour;
  }

  void propose(const ProofProposal& proposal) {
    for (ProofProposal& old : m_proposals)
      if (old.node == proposal.node) {
        old = proposal;
        return;
      }
    m_proposals.push_back(proposal);
  }

  const Bar& m_bar;
  SeenPicture m_first;
  SeenPicture m_now;
  std::vector<ProofProposal> m_proposals;
  std::map<model::NodeId, std::set<Colour>> m_triedColours;
  std::map<model::NodeId, std::set<float>> m_triedGammas;
};

}  // namespace

bool ProofPair::alikeAnywhere(const ProofSettings& settings) const {
  return std::any_of(visions.begin(), visions.end(),
                     [&](Vision vision) { return alike(vision, settings); });
}

model::Style ProofProposal::style() const {
  model::Style style;
  style.colour = colour;
  style.gamma = gamma;
  return style;
}

model::Scene withProposals(const model::Scene& scene, const std::vector<ProofProposal>& proposals) {
  model::Scene changed = scene;
  for (const ProofProposal& proposal : proposals) {
    const std::array<model::NodeId, 1> one{proposal.node};
    changed = model::withLook(changed, one, proposal.style()).scene;
  }
  return changed;
}

Result<PrintProof> printProof(const ExportOrder& order, const ProofSettings& settings,
                              const ExportProgress& progress) {
  const auto wanted = [&](double share, std::string_view what) {
    return !progress || progress(share, what);
  };
  if (!wanted(0.0, "looking at the picture"))
    return givenUp({});
  const std::unique_ptr<PictureReader> reader = TRY(PictureReader::create());
  const SeenPicture first = TRY(reader->read(order, order.scene));
  PrintProof proof{.neighbours = pairsOf(first, settings),
                   .proposals = {},
                   .proposed = order.scene,
                   .afterwards = {}};
  proof.afterwards = proof.neighbours;
  const Bar bar(proof.neighbours, settings);
  Mender mender(bar, first);
  SeenPicture now = first;
  // The chosen changes are looked at; where they do not help, something else is tried. In the end
  // changes that never helped are taken back, and the rest must do without them.
  for (int round = 0; bar.anyFails(proof.afterwards); ++round) {
    if (!wanted(1.0 - 1.0 / double(round + 1), "trying changes"))
      return givenUp({});
    const bool chosen = round < mostRounds && mender.choose(now);
    if (!chosen && !mender.drop(proof.afterwards))
      break;
    proof.proposed = withProposals(order.scene, mender.proposals());
    now = TRY(reader->read(order, proof.proposed));
    proof.afterwards = pairsOf(now, settings);
  }
  proof.proposals = mender.proposals();
  return proof;
}

}  // namespace sline::render
