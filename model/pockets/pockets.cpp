// SPDX-License-Identifier: Apache-2.0
#include "model/pockets/pockets.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "model/base/parallel.h"

namespace sline::model {

namespace {

constexpr float liningReach = 1.0f;   ///< Å, from a pocket to the atoms of its wall
constexpr double burialReach = 10.0;  ///< Å
constexpr std::size_t burialSamples = 2000;
// Over so many steps the mouth's surface is blurred to measure it.
constexpr double mouthBlur = 3.0;
// The mouth reaches to its rim, where the small ball does not fit in between the large one and the
// atoms: at most so many of its radii from its nearest centre, where that many Å are open.
constexpr float mouthReach = 3.0f;
constexpr float openEnough = 0.15f;
// Lines of sight out of a pocket.
constexpr int sightDirections = 128;
constexpr std::size_t sightSamples = 150;
constexpr double goldenAngle = 2.399963229728653;
constexpr std::size_t mostPockets = 500;
constexpr std::size_t mostAtoms = 1'000'000;
/// No matter has more atoms than this in a cube of 4 Å.
constexpr double crowdSide = 4.0;
constexpr std::size_t crowded = 100;
constexpr std::uint32_t noPocket = 0xffffffffu;

Error unanswered(const std::string& reason, const std::string& remedy) {
  return {.file = {}, .where = {}, .reason = reason, .remedy = remedy};
}

Error stopped() {
  return unanswered("the search for pockets was cancelled", "");
}

bool liesTooClose(std::span<const AtomBall> atoms) {
  std::map<std::tuple<int, int, int>, std::size_t> counts;
  return std::any_of(atoms.begin(), atoms.end(), [&counts](const AtomBall& atom) {
    const glm::ivec3 cell(glm::floor(glm::dvec3(atom.place) / crowdSide));
    return ++counts[{cell.x, cell.y, cell.z}] > crowded;
  });
}

/// The 14 directions along the axes and the diagonals of a cube.
std::array<glm::ivec3, 14> cubeDirections() {
  std::array<glm::ivec3, 14> all{};
  std::size_t count = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const int sign : {-1, 1})
      all[count++][axis] = sign;
  for (int i = 0; i < 8; ++i)
    all[count++] = {i % 2 * 2 - 1, i / 2 % 2 * 2 - 1, i / 4 * 2 - 1};
  return all;
}

class PocketFinder {
 public:
  PocketFinder(std::span<const AtomBall> atoms, const PocketOptions& options, const GoesOn& goesOn)
      : m_atoms(atoms), m_options(options), m_goesOn(goesOn) {}

  Result<Pockets> find() {
    const std::optional<ProbeGrid> grid =
        gridAround(m_atoms, {.margin = double(m_options.largeProbe) + 2.0 * double(m_options.step),
                             .step = double(m_options.step)});
    if (!grid)
      return unanswered("its atoms lie too far apart for a lattice between them",
                        "Find the pockets of fewer chains at a time");
    if (liesTooClose(m_atoms))
      return unanswered("its atoms lie closer together than those of matter do", "Repair the file");
    m_grid = *grid;
    if (!rollBalls())
      return stopped();
    if (!connect() || !fill())
      return stopped();
    measure();
    lining();
    keepLarge();
    return Pockets{m_grid, std::move(m_pockets)};
  }

 private:
  /// Finds where the balls' centres may be: how far each place is from the atoms, and from all that
  /// the large ball reaches.
  bool rollBalls() {
    const float reach = m_options.largeProbe + 2.0f * float(m_grid.step);
    auto toAtoms = atomDistances(m_grid, m_atoms, reach, m_goesOn);
    if (!toAtoms)
      return false;
    m_toAtoms = std::move(*toAtoms);
    const float centre = m_options.largeProbe - 0.25f * float(m_grid.step);
    std::vector<std::uint32_t> nearest(m_grid.count(), noPlace);
    for (std::uint32_t i = 0; i < nearest.size(); ++i)
      if (m_toAtoms[i] >= centre)
        nearest[i] = i;
    if (!spreadToNearest(m_grid, nearest, m_goesOn))
      return false;
    m_toOpen.resize(m_grid.count());
    parallelFor(nearest.size(), 4096, [&](std::size_t i) {
      // The nearest centre lies before or behind the place that stands for it.
      const std::uint32_t at = nearest[i];
      const double away = distanceBetween(m_grid, std::uint32_t(i), at);
      m_toOpen[i] =
          float(away) - std::min(m_toAtoms[at], m_options.largeProbe + float(m_grid.step));
    });
    return true;
  }

  /// Tells whether the small ball's centre may lie there without the ball meeting atoms or places
  /// that the large one reaches.
  bool takesBall(std::size_t i) const {
    return m_toAtoms[i] >= m_options.smallProbe && m_toOpen[i] >= m_options.smallProbe;
  }

  /// Numbers the sets of connected places for centres.
  bool connect() {
    m_pocketAt.assign(m_grid.count(), noPocket);
    std::uint32_t count = 0;
    std::vector<std::uint32_t> open;
    for (std::uint32_t i = 0; i < m_pocketAt.size(); ++i) {
      if (m_pocketAt[i] != noPocket || !takesBall(i))
        continue;
      if (!m_goesOn())
        return false;
      m_pocketAt[i] = count;
      open.assign(1, i);
      while (!open.empty()) {
        const glm::ivec3 cell = m_grid.cell(open.back());
        open.pop_back();
        for (int axis = 0; axis < 3; ++axis)
          for (const int sign : {-1, 1}) {
            glm::ivec3 next = cell;
            next[axis] += sign;
            if (!m_grid.holds(next))
              continue;
            const std::uint32_t at = m_grid.index(next);
            if (m_pocketAt[at] == noPocket && takesBall(at)) {
              m_pocketAt[at] = count;
              open.push_back(at);
            }
          }
      }
      ++count;
    }
    m_pockets.resize(count);
    return true;
  }

  /// Gives each pocket all that the small ball covers, and measures it on the way.
  bool fill() {
    std::vector<std::uint32_t> nearest(m_grid.count(), noPlace);
    for (std::uint32_t i = 0; i < nearest.size(); ++i)
      if (m_pocketAt[i] != noPocket)
        nearest[i] = i;
    if (m_pockets.empty())
      return true;
    if (!spreadToNearest(m_grid, nearest, m_goesOn))
      return false;
    const auto half = float(0.5 * mouthBlur * m_grid.step);
    const float covered = m_options.smallProbe + 0.5f * float(m_grid.step);
    const double cellVolume = m_grid.step * m_grid.step * m_grid.step;
    std::vector<std::uint32_t> owner(m_grid.count(), noPocket);
    for (std::uint32_t i = 0; i < owner.size(); ++i) {
      if (!(m_toAtoms[i] > 0.0f) || !(m_toOpen[i] > -half))
        continue;
      const auto away = float(distanceBetween(m_grid, i, nearest[i]));
      const bool within = m_toOpen[i] > 0.0f && away <= covered;
      const bool atMouth =
          m_toOpen[i] <= half && (away <= covered || (m_toAtoms[i] >= openEnough &&
                                                      away <= mouthReach * m_options.smallProbe));
      Pocket& pocket = m_pockets[m_pocketAt[nearest[i]]];
      const glm::dvec3 place = m_grid.place(m_grid.cell(i));
      if (within) {
        owner[i] = m_pocketAt[nearest[i]];
        pocket.cells.push_back(i);
        pocket.volume += cellVolume;
        pocket.centre += place;
      }
      if (atMouth) {
        pocket.mouth += cellVolume / (2.0 * double(half));
        pocket.outwards += place;
        ++m_mouthPlaces[&pocket];
      }
    }
    m_pocketAt = std::move(owner);
    return true;
  }

  void measure() {
    parallelFor(m_pockets.size(), 1, [&](std::size_t i) {
      Pocket& pocket = m_pockets[i];
      if (pocket.cells.empty())
        return;
      pocket.centre /= double(pocket.cells.size());
      const auto places = m_mouthPlaces.find(&pocket);
      const glm::dvec3 out = places == m_mouthPlaces.end()
                                 ? glm::dvec3(0.0)
                                 : pocket.outwards / double(places->second) - pocket.centre;
      const double length = glm::length(out);
      pocket.outwards = length > 1e-6 ? openest(pocket, out / length) : glm::dvec3(0.0);
      pocket.burial = burial(pocket);
    });
  }

  /// Returns the direction in which most of the pocket's places have nothing before them: the one
  /// through the middle of its mouth, unless another is better. A pocket may have several mouths.
  glm::dvec3 openest(const Pocket& pocket, const glm::dvec3& throughMouth) const {
    glm::dvec3 best = throughMouth;
    std::size_t most = openPlaces(pocket, throughMouth);
    for (int i = 0; i < sightDirections; ++i) {
      const double z = 1.0 - 2.0 * (i + 0.5) / sightDirections;
      const double across = std::sqrt(1.0 - z * z);
      const glm::dvec3 direction(across * std::cos(goldenAngle * i),
                                 across * std::sin(goldenAngle * i), z);
      if (const std::size_t open = openPlaces(pocket, direction); open > most) {
        most = open;
        best = direction;
      }
    }
    return best;
  }

  std::size_t openPlaces(const Pocket& pocket, const glm::dvec3& direction) const {
    const std::size_t stride = 1 + pocket.cells.size() / sightSamples;
    std::size_t open = 0;
    for (std::size_t i = 0; i < pocket.cells.size(); i += stride) {
      glm::dvec3 place = m_grid.place(m_grid.cell(pocket.cells[i]));
      glm::ivec3 cell = m_grid.cellAt(place);
      while (m_grid.holds(cell) && m_toAtoms[m_grid.index(cell)] > 0.0f) {
        place += 1.5 * m_grid.step * direction;
        cell = m_grid.cellAt(place);
      }
      open += m_grid.holds(cell) ? 0 : 1;
    }
    return open;
  }

  float burial(const Pocket& pocket) const {
    static const std::array<glm::ivec3, 14> directions = cubeDirections();
    const std::size_t stride = 1 + pocket.cells.size() / burialSamples;
    std::size_t met = 0;
    std::size_t all = 0;
    for (std::size_t i = 0; i < pocket.cells.size(); i += stride)
      for (const glm::ivec3& direction : directions) {
        met += meetsAtoms(m_grid.cell(pocket.cells[i]), direction) ? 1 : 0;
        ++all;
      }
    return float(met) / float(all);
  }

  bool meetsAtoms(glm::ivec3 cell, const glm::ivec3& direction) const {
    const double length = m_grid.step * glm::length(glm::dvec3(direction));
    for (double way = length; way <= burialReach; way += length) {
      cell += direction;
      if (!m_grid.holds(cell))
        return false;
      if (m_toAtoms[m_grid.index(cell)] <= 0.0f)
        return true;
    }
    return false;
  }

  void lining() {
    for (const AtomBall& atom : m_atoms) {
      const double reach = double(atom.radius + liningReach);
      const glm::dvec3 own(atom.place);
      const glm::ivec3 low = glm::max(m_grid.cellAt(own - reach), glm::ivec3(0));
      const glm::ivec3 high = glm::min(m_grid.cellAt(own + reach), m_grid.size - 1);
      for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
          for (int x = low.x; x <= high.x; ++x) {
            const std::uint32_t pocket = m_pocketAt[m_grid.index({x, y, z})];
            if (pocket == noPocket || glm::distance(m_grid.place({x, y, z}), own) > reach)
              continue;
            std::vector<std::uint32_t>& residues = m_pockets[pocket].residues;
            if (residues.empty() || residues.back() != atom.residue)
              residues.push_back(atom.residue);
          }
    }
  }

  void keepLarge() {
    std::erase_if(m_pockets, [this](const Pocket& pocket) {
      return pocket.volume < double(m_options.leastVolume);
    });
    std::stable_sort(m_pockets.begin(), m_pockets.end(),
                     [](const Pocket& a, const Pocket& b) { return a.volume > b.volume; });
    m_pockets.resize(std::min(m_pockets.size(), mostPockets));
    for (Pocket& pocket : m_pockets) {
      std::sort(pocket.residues.begin(), pocket.residues.end());
      pocket.residues.erase(std::unique(pocket.residues.begin(), pocket.residues.end()),
                            pocket.residues.end());
    }
  }

  std::span<const AtomBall> m_atoms;
  const PocketOptions& m_options;
  const GoesOn& m_goesOn;
  ProbeGrid m_grid;
  std::vector<float> m_toAtoms;           ///< mm, from the atoms' surface
  std::vector<float> m_toOpen;            ///< mm, from what the large ball reaches
  std::vector<std::uint32_t> m_pocketAt;  ///< of centres, then of all places
  std::map<const Pocket*, std::size_t> m_mouthPlaces;
  std::vector<Pocket> m_pockets;
};

}  // namespace

std::string pocketOptionsFault(const PocketOptions& options) {
  if (!smallProbes.contain(options.smallProbe))
    return "the small probe's radius is 0.8 to 5 Å";
  if (!largeProbes.contain(options.largeProbe))
    return "the large probe's radius is 2 to 20 Å";
  if (!(options.largeProbe > options.smallProbe))
    return "the large probe must be larger than the small one";
  if (!leastVolumes.contain(options.leastVolume))
    return "the least volume is 1 to 10,000 Å³";
  if (!latticeSteps.contain(options.step))
    return "the lattice's step is 0.25 to 1.5 Å";
  return {};
}

Result<Pockets> findPockets(std::span<const AtomBall> atoms, const PocketOptions& options,
                            const GoesOn& goesOn) {
  if (const std::string fault = pocketOptionsFault(options); !fault.empty())
    return unanswered(fault, "");
  if (atoms.empty())
    return Pockets{};
  if (atoms.size() > mostAtoms)
    return unanswered("it has more than " + std::to_string(mostAtoms) + " atoms",
                      "Find the pockets of fewer chains at a time");
  return PocketFinder(atoms, options, goesOn).find();
}

}  // namespace sline::model
