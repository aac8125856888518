// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "model/import/molecules/residues.h"

namespace sline::model {

namespace {

constexpr double tolerance = 0.45;
constexpr double cell = 5.5;  ///< above twice the largest covalent radius
/// An atom with more atoms around it than this lies in a heap, not in a molecule.
constexpr int mostAround = 24;

using Cell = std::array<std::int64_t, 3>;
using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

class BondFinder {
 public:
  explicit BondFinder(std::span<const Atom> atoms) : m_atoms(atoms), m_around(atoms.size(), 0) {
    for (std::uint32_t i = 0; i < atoms.size(); ++i)
      m_cells.emplace_back(cellOf(atoms[i].place), i);
    std::sort(m_cells.begin(), m_cells.end());
  }

  Pairs find() {
    for (std::uint32_t i = 0; i < m_atoms.size(); ++i) {
      const Cell home = cellOf(m_atoms[i].place);
      for (std::int64_t x = home[0] - 1; x <= home[0] + 1; ++x)
        for (std::int64_t y = home[1] - 1; y <= home[1] + 1; ++y)
          findIn({x, y, home[2] - 1}, {x, y, home[2] + 1}, i);
    }
    return std::move(m_pairs);
  }

 private:
  static Cell cellOf(const glm::dvec3& p) {
    return {std::int64_t(std::floor(p.x / cell)), std::int64_t(std::floor(p.y / cell)),
            std::int64_t(std::floor(p.z / cell))};
  }

  void findIn(const Cell& first, const Cell& last, std::uint32_t i) {
    const auto begin =
        std::lower_bound(m_cells.begin(), m_cells.end(), std::pair(first, std::uint32_t(0)));
    int seen = 0;
    for (auto at = begin; at != m_cells.end() && at->first <= last; ++at) {
      if (m_around[i] >= mostAround || ++seen > 40 * mostAround)
        return;
      const std::uint32_t k = at->second;
      if (k <= i || m_around[k] >= mostAround)
        continue;
      const double apart = glm::length(m_atoms[i].place - m_atoms[k].place);
      const Element& one = *m_atoms[i].element;
      const Element& two = *m_atoms[k].element;
      if (apart >= double(one.covalent + two.covalent) + tolerance)
        continue;
      ++m_around[i];
      ++m_around[k];
      const bool hydrogens = one.symbol == "H" && two.symbol == "H";
      if (apart > 0.4 && !hydrogens)
        m_pairs.emplace_back(i, k);
    }
  }

  std::span<const Atom> m_atoms;
  std::vector<std::pair<Cell, std::uint32_t>> m_cells;
  std::vector<int> m_around;
  Pairs m_pairs;
};

}  // namespace

Pairs bondsBetween(std::span<const Atom> atoms,
                   const std::set<std::pair<std::int64_t, std::int64_t>>& known) {
  Pairs pairs = BondFinder(atoms).find();
  // Serials that have wrapped around name two atoms; such bonds are left to the distances.
  std::unordered_map<std::int64_t, std::int64_t> atomOf;
  for (std::size_t i = 0; i < atoms.size(); ++i)
    if (const auto [entry, isNew] = atomOf.try_emplace(atoms[i].serial, std::int64_t(i)); !isNew)
      entry->second = -1;
  for (const auto& [serial, i] : atomOf)
    for (auto bond = known.lower_bound({serial, INT64_MIN});
         i >= 0 && bond != known.end() && bond->first == serial; ++bond) {
      const auto other = atomOf.find(bond->second);
      if (other == atomOf.end() || other->second < 0)
        continue;
      const auto [low, high] = std::minmax({std::uint32_t(i), std::uint32_t(other->second)});
      // Listed bonds count within reason: salt bridges and hydrogen bonds are listed too.
      if (glm::length(atoms[low].place - atoms[high].place) < 2.4)
        pairs.emplace_back(low, high);
    }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace sline::model
