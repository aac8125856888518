// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/net_relaxation.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "model/base/parallel.h"
#include "model/import/volumes/cell_cycles.h"

namespace sline::model {

namespace {

constexpr std::size_t grain = 4096;
/// Of a voxel: vertices of neighbouring cells stay apart, so that no face loses its area.
constexpr float mostShift = 0.48f;
constexpr float mostLooseShift = 0.98f;
/// Along the mean of the neighbours; half of the stable range.
constexpr float stepLength = 0.5f;
/// Curvature around is measured anew after that many steps. It is averaged over the neighbours
/// often at first, later once for each step; what was found before keeps most of its weight, so
/// that it comes from ever farther around: six voxels in the end.
constexpr int stepsPerMeasure = 4;
constexpr int firstReach = 30;
constexpr float newShare = 0.05f;

class Relaxer {
 public:
  Relaxer(const SurfaceNet& net, const glm::vec3& spacing, const Relaxation& relaxation)
      : m_net(net), m_spacing(spacing), m_relaxation(relaxation), m_count(net.cells.size()) {
    m_kinds.resize(m_count);
    m_at.resize(m_count);
    parallelFor(m_count, grain, [this](std::size_t i) {
      m_kinds[i] = kindOf(m_net.cells[i]);
      m_at[i] = centre(i);
    });
  }

  bool run(const std::function<bool()>& goesOn) {
    if (m_relaxation.steps + m_relaxation.looseSteps <= 0)
      return true;
    m_normals.resize(m_count);
    m_curvature.resize(m_count);
    m_averaged.resize(m_count);
    m_target.resize(m_count);
    return steps(m_relaxation.steps, {mostShift, m_relaxation.momentum}, goesOn) &&
           steps(m_relaxation.looseSteps, {mostLooseShift, 0.0f}, goesOn);
  }

  std::vector<glm::vec3> take() && { return std::move(m_at); }

 private:
  /// Of a cell: one sheet between two labels, several of them, or more labels.
  enum class Kind : std::uint8_t { sheet, pinched, junction };

  Kind kindOf(const SurfaceNet::Cell& cell) const {
    if (cell.junction)
      return Kind::junction;
    return m_cycles.ring(cell.corners).count > 0 ? Kind::sheet : Kind::pinched;
  }

  glm::vec3 centre(std::size_t i) const {
    const SurfaceNet::Cell& cell = m_net.cells[i];
    return (glm::vec3(cell.x, cell.y, cell.z) - 0.5f) * m_spacing;
  }

  /// Calls visit(j) for the neighbours that pull at i: along a junction only those along it.
  template <class Visit>
  void forNeighbours(std::size_t i, const Visit& visit) const {
    const bool junction = m_kinds[i] == Kind::junction;
    for (const std::uint32_t j : m_net.neighbours[i])
      if (j != SurfaceNet::none && (!junction || m_kinds[j] == Kind::junction))
        visit(j);
  }

  /// From a vertex to the mean of its neighbours.
  glm::vec3 pull(std::size_t i, const std::vector<glm::vec3>& at) const {
    glm::vec3 sum(0.0f);
    int count = 0;
    forNeighbours(i, [&](std::uint32_t j) {
      sum += at[j];
      ++count;
    });
    return count > 0 ? sum / float(count) - at[i] : glm::vec3(0.0f);
  }

  glm::vec3 normal(std::size_t i) const {
    const CellCycles::Ring& ring = m_cycles.ring(m_net.cells[i].corners);
    glm::vec3 area(0.0f);
    glm::vec3 last = m_at[m_net.neighbours[i][ring.faces[ring.count - 1]]] - m_at[i];
    for (unsigned k = 0; k < ring.count; ++k) {
      const glm::vec3 next = m_at[m_net.neighbours[i][ring.faces[k]]] - m_at[i];
      area += glm::cross(last, next);
      last = next;
    }
    const float length = glm::length(area);
    return length > 0.0f ? area / length : glm::vec3(0.0f);
  }

  /// What each vertex is pulled by that belongs to the form of its surroundings and is not to be
  /// followed: `m_curvature`, along the normal of a sheet or as it is along a junction.
  void measureCurvature() {
    const bool first = std::exchange(m_first, false);
    const float share = first ? 1.0f : newShare;
    parallelFor(m_count, grain, [this, share](std::size_t i) {
      if (m_kinds[i] == Kind::pinched)
        return;
      const glm::vec3 towards = pull(i, m_at);
      if (m_kinds[i] == Kind::junction) {
        m_curvature[i] += share * (towards - m_curvature[i]);
        return;
      }
      m_normals[i] = normal(i);
      m_curvature[i].x += share * (glm::dot(m_normals[i], towards) - m_curvature[i].x);
    });
    for (int k = 0; k < (first ? firstReach : stepsPerMeasure); ++k) {
      parallelFor(m_count, grain, [this](std::size_t i) { m_averaged[i] = averaged(i); });
      std::swap(m_averaged, m_curvature);
    }
    parallelFor(m_count, grain, [this](std::size_t i) {
      m_target[i] = m_kinds[i] == Kind::sheet ? m_curvature[i].x * m_normals[i] : m_curvature[i];
    });
  }

  /// With the neighbours of the same kind: only there does a sheet's sign mean the same side.
  glm::vec3 averaged(std::size_t i) const {
    glm::vec3 sum = m_curvature[i];
    int count = 1;
    for (const std::uint32_t j : m_net.neighbours[i])
      if (j != SurfaceNet::none && m_kinds[j] == m_kinds[i]) {
        sum += m_curvature[j];
        ++count;
      }
    return sum / float(count);
  }

  struct Stride {
    float mostShift;  ///< from the cell's centre, of a voxel
    float momentum;
  };

  bool steps(int count, const Stride& stride, const std::function<bool()>& goesOn) {
    m_ahead = m_at;
    m_nextAhead.resize(m_count);
    for (int step = 0; step < count; ++step) {
      if (!goesOn())
        return false;
      if (step % stepsPerMeasure == 0)
        measureCurvature();
      move(stride);
    }
    return true;
  }

  /// One step with heavy-ball momentum (B. T. Polyak, USSR Comput. Math. Math. Phys. 4(5), 1964),
  /// without which a step twenty voxels long would take hundreds.
  void move(const Stride& stride) {
    const glm::vec3 most = stride.mostShift * m_spacing;
    parallelFor(m_count, grain, [&](std::size_t i) {
      const glm::vec3 wanted = m_ahead[i] + stepLength * (pull(i, m_ahead) - m_target[i]);
      const glm::vec3 middle = centre(i);
      const glm::vec3 at = glm::clamp(wanted, middle - most, middle + most);
      m_nextAhead[i] = at + stride.momentum * (at - m_at[i]);
      m_at[i] = at;
    });
    std::swap(m_ahead, m_nextAhead);
  }

  const SurfaceNet& m_net;
  glm::vec3 m_spacing;
  Relaxation m_relaxation;
  std::size_t m_count;
  CellCycles m_cycles;
  bool m_first = true;  ///< curvature was not measured yet
  std::vector<Kind> m_kinds;
  std::vector<glm::vec3> m_at;
  std::vector<glm::vec3> m_ahead;  ///< where the momentum leads from m_at
  std::vector<glm::vec3> m_nextAhead;
  std::vector<glm::vec3> m_normals;
  std::vector<glm::vec3> m_curvature;
  std::vector<glm::vec3> m_averaged;
  std::vector<glm::vec3> m_target;
};

}  // namespace

std::vector<glm::vec3> relaxed(const SurfaceNet& net, const glm::vec3& spacing,
                               const Relaxation& relaxation, const std::function<bool()>& goesOn) {
  Relaxer relaxer(net, spacing, relaxation);
  if (!relaxer.run(goesOn))
    return {};
  return std::move(relaxer).take();
}

}  // namespace sline::model
