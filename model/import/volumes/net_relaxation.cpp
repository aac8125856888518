// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/net_relaxation.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <span>
#include <utility>

#include "model/base/parallel.h"

namespace sline::model {

namespace {

constexpr std::size_t pointGrain = 4096;
/// A vertex moves by at most this share of a voxel: vertices of neighbouring cells stay apart, so
/// that no face loses its area.
constexpr float mostShift = 0.48f;
constexpr float mostLooseShift = 0.98f;
/// A step towards the mean of the neighbours has this length, half of the stable range.
constexpr float stepLength = 0.5f;
/// Curvature around is measured anew after so many steps, when the earlier result keeps most of its
/// weight and is averaged over the neighbours once for each step; and now and then afresh, so that
/// a step of the voxels that is gone does not live on in it. It comes from six voxels around.
constexpr int stepsPerMeasure = 4;
constexpr float newShare = 0.05f;
constexpr int stepsPerFreshMeasure = 20;
constexpr int freshReach = 40;

class Relaxer {
 public:
  Relaxer(const SurfaceNet& net, const LabelSheets& sheets, const glm::vec3& spacing)
      : m_net(net), m_sheets(sheets), m_spacing(spacing) {}

  bool run(const Relaxation& relaxation, const std::function<bool()>& goesOn) {
    m_at = relaxation.from;
    if (m_at.empty()) {
      m_at.resize(m_sheets.cellOf.size());
      parallelFor(m_at.size(), pointGrain, [this](std::size_t i) { m_at[i] = centre(i); });
    }
    if (relaxation.steps + relaxation.looseSteps <= 0)
      return true;
    gatherNodes();
    gatherPulls();
    const std::size_t nodes = m_sheets.pointOf.size();
    m_normals.resize(nodes);
    m_curvature.resize(nodes);
    m_averaged.resize(nodes);
    m_squares.resize(nodes);
    m_target.resize(m_at.size());
    return steps(relaxation.steps, {mostShift, relaxation.momentum}, goesOn) &&
           steps(relaxation.looseSteps, {mostLooseShift, 0.0f}, goesOn);
  }

  std::vector<glm::vec3> take() && { return std::move(m_at); }

 private:
  struct Stride {
    float mostShift;  ///< from the cell's centre, as a share of a voxel
    float momentum;
  };

  glm::vec3 centre(std::size_t point) const {
    const SurfaceNet::Cell& cell = m_net.cells[m_sheets.cellOf[point]];
    return (glm::vec3(cell.x, cell.y, cell.z) - 0.5f) * m_spacing;
  }
  bool isJunction(std::size_t point) const { return m_net.cells[m_sheets.cellOf[point]].junction; }
  const glm::vec3& place(std::uint32_t node) const { return m_at[m_sheets.pointOf[node]]; }

  void gatherNodes() {
    m_firstNode.assign(m_at.size() + 2, 0);
    for (const std::uint32_t point : m_sheets.pointOf)
      ++m_firstNode[point + 2];
    for (std::size_t i = 2; i < m_firstNode.size(); ++i)
      m_firstNode[i] += m_firstNode[i - 1];
    m_nodes.resize(m_sheets.pointOf.size());
    for (std::uint32_t node = 0; node < m_nodes.size(); ++node)
      m_nodes[m_firstNode[m_sheets.pointOf[node] + 1]++] = node;
    m_firstNode.pop_back();
  }

  /// Gathers the points that pull at each one: its neighbours on every structure's surface. Two
  /// structures that meet in one sheet have the same.
  void gatherPulls() {
    m_firstPull.assign(m_at.size() + 1, 0);
    const auto pulling = [this](std::size_t point) {
      const std::uint32_t begin = m_firstNode[point];
      const std::uint32_t count = isJunction(point) ? m_firstNode[point + 1] - begin : 1u;
      return std::span(m_nodes.data() + begin, count);
    };
    for (std::size_t point = 0; point < m_at.size(); ++point) {
      m_firstPull[point + 1] = m_firstPull[point];
      for (const std::uint32_t node : pulling(point))
        m_firstPull[point + 1] += std::uint32_t(m_sheets.sidesOf(node).size());
    }
    m_pulls.resize(m_firstPull.back());
    parallelFor(m_at.size(), pointGrain, [&](std::size_t point) {
      std::uint32_t to = m_firstPull[point];
      for (const std::uint32_t node : pulling(point))
        for (const LabelSheets::Side& side : m_sheets.sidesOf(node))
          m_pulls[to++] = m_sheets.pointOf[side.next];
    });
  }

  bool steps(int count, const Stride& stride, const std::function<bool()>& goesOn) {
    m_ahead = m_at;
    m_nextAhead.resize(m_at.size());
    for (int step = 0; step < count; ++step) {
      if (!goesOn())
        return false;
      if (step % stepsPerMeasure == 0)
        measureCurvature(step % stepsPerFreshMeasure == 0);
      move(stride);
    }
    return true;
  }

  /// Measures `m_target`, the part of each point's pull that belongs to the form of its
  /// surroundings and is not to be followed.
  void measureCurvature(bool afresh) {
    const float share = afresh ? 1.0f : newShare;
    parallelFor(m_normals.size(), pointGrain, [this, share](std::size_t i) {
      m_curvature[i] += share * (curvature(i) - m_curvature[i]);
    });
    for (int k = 0; k < (afresh ? freshReach : stepsPerMeasure); ++k) {
      parallelFor(m_curvature.size(), pointGrain,
                  [this](std::size_t i) { m_averaged[i] = averaged(i); });
      std::swap(m_averaged, m_curvature);
    }
    parallelFor(m_at.size(), pointGrain, [this](std::size_t point) {
      glm::vec3 sum(0.0f);
      for (std::uint32_t k = m_firstNode[point]; k < m_firstNode[point + 1]; ++k)
        sum += wanted(m_nodes[k]) * m_normals[m_nodes[k]];
      m_target[point] = sum / float(m_firstNode[point + 1] - m_firstNode[point]);
    });
  }

  /// Returns how far the mean of a node's neighbours lies outside its surface, and the mean square
  /// of their distances; the ratio is half the mean curvature where they lie evenly, however
  /// densely that is. Sets the normal.
  glm::vec2 curvature(std::size_t node) {
    const glm::vec3& at = place(std::uint32_t(node));
    const std::span<const LabelSheets::Side> sides = m_sheets.sidesOf(node);
    glm::vec3 area(0.0f);
    glm::vec3 sum(0.0f);
    float squares = 0.0f;
    for (const LabelSheets::Side& side : sides) {
      const glm::vec3 next = place(side.next) - at;
      squares += glm::dot(next, next);
      area += glm::cross(next, place(side.last) - at);
      sum += next;
    }
    const float length = glm::length(area);
    m_normals[node] = length > 0.0f ? area / length : glm::vec3(0.0f);
    m_squares[node] = squares / float(sides.size());
    return {glm::dot(m_normals[node], sum) / float(sides.size()), m_squares[node]};
  }

  /// Returns the share of the pull that belongs to the form. Averaging pull and square apart rather
  /// than their ratio keeps the volume: crowded nodes would have too much weight.
  float wanted(std::uint32_t node) const {
    const glm::vec2& around = m_curvature[node];
    return around.y > 0.0f ? around.x / around.y * m_squares[node] : 0.0f;
  }

  glm::vec2 averaged(std::size_t node) const {
    const std::span<const LabelSheets::Side> sides = m_sheets.sidesOf(node);
    glm::vec2 sum = m_curvature[node];
    for (const LabelSheets::Side& side : sides)
      sum += m_curvature[side.next];
    return sum / float(sides.size() + 1);
  }

  /// Makes one step with heavy-ball momentum (B. T. Polyak, USSR Comput. Math. Math. Phys. 4(5),
  /// 1964), without which a step twenty voxels long would take hundreds.
  void move(const Stride& stride) {
    const glm::vec3 most = stride.mostShift * m_spacing;
    parallelFor(m_at.size(), pointGrain, [&](std::size_t i) {
      glm::vec3 mean(0.0f);
      for (std::uint32_t k = m_firstPull[i]; k < m_firstPull[i + 1]; ++k)
        mean += m_ahead[m_pulls[k]];
      mean /= float(m_firstPull[i + 1] - m_firstPull[i]);
      const glm::vec3 wanted = m_ahead[i] + stepLength * (mean - m_ahead[i] - m_target[i]);
      const glm::vec3 middle = centre(i);
      const glm::vec3 at = glm::clamp(wanted, middle - most, middle + most);
      m_nextAhead[i] = at + stride.momentum * (at - m_at[i]);
      m_at[i] = at;
    });
    std::swap(m_ahead, m_nextAhead);
  }

  const SurfaceNet& m_net;
  const LabelSheets& m_sheets;
  glm::vec3 m_spacing;
  std::vector<std::uint32_t> m_firstNode;  ///< start of each point's nodes in m_nodes, and one more
  std::vector<std::uint32_t> m_nodes;
  std::vector<std::uint32_t> m_firstPull;  ///< likewise in m_pulls
  std::vector<std::uint32_t> m_pulls;
  std::vector<glm::vec3> m_at;
  std::vector<glm::vec3> m_ahead;  ///< where the momentum leads, starting from m_at
  std::vector<glm::vec3> m_nextAhead;
  std::vector<glm::vec3> m_target;
  std::vector<glm::vec3> m_normals;    ///< one for each node
  std::vector<glm::vec2> m_curvature;  ///< likewise
  std::vector<glm::vec2> m_averaged;
  std::vector<float> m_squares;  ///< mean square of the distances to a node's neighbours
};

}  // namespace

std::vector<glm::vec3> relaxed(const SurfaceNet& net, const LabelSheets& sheets,
                               const glm::vec3& spacing, const Relaxation& relaxation,
                               const std::function<bool()>& goesOn) {
  Relaxer relaxer(net, sheets, spacing);
  if (!relaxer.run(relaxation, goesOn))
    return {};
  return std::move(relaxer).take();
}

}  // namespace sline::model
