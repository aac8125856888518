// SPDX-License-Identifier: Apache-2.0
#include "render/lines/lines.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/base/parallel.h"
#include "render/lines/view_fields.h"

namespace sline::render {

using model::Cluster;
using model::Clusters;
using model::Facing;
using model::Surface;

namespace {
constexpr std::size_t clustersPerTask = 48;

/// What a cluster's vertices look like from the eye, with d the vector to the eye (of any length):
/// enough for signs; `Extractor::nvAt` and `radialCurvatureAt` make the true values where a line
/// passes. Reused from cluster to cluster.
struct ClusterFields {
  using Field = std::array<float, Clusters::maximumVertices + 1>;
  Field distanceSquared;  ///< |d|²
  Field facing;           ///< ⟨n, d⟩ = nv·|d|
  Field bending;          ///< dᵀ·S·d = κr·|w|²·|d|²
};

/// Fills the fields of `count` vertices from `first` on. Straight loops over arrays: the compiler
/// turns them into vector instructions.
void computeFields(const model::ClusterVertices& in, std::size_t first, std::size_t count,
                   const model::EyePoint& eye, ClusterFields& out) {
  const float* px = in.position[0].data() + first;
  const float* py = in.position[1].data() + first;
  const float* pz = in.position[2].data() + first;
  const float* nx = in.normal[0].data() + first;
  const float* ny = in.normal[1].data() + first;
  const float* nz = in.normal[2].data() + first;
  std::array<const float*, 6> s{};
  for (std::size_t i = 0; i < 6; ++i)
    s[i] = in.s[i].data() + first;
  // A parallel projection's d is the eye's direction itself.
  const float scale = eye.atInfinity ? 0.0f : 1.0f;
  for (std::size_t i = 0; i < count; ++i) {
    const float x = eye.value.x - scale * px[i];
    const float y = eye.value.y - scale * py[i];
    const float z = eye.value.z - scale * pz[i];
    out.distanceSquared[i] = x * x + y * y + z * z;
    out.facing[i] = nx[i] * x + ny[i] * y + nz[i] * z;
    out.bending[i] = x * (s[0][i] * x + 2.0f * (s[1][i] * y + s[2][i] * z)) +
                     y * (s[3][i] * y + 2.0f * s[4][i] * z) + s[5][i] * z * z;
  }
}

/// A point on a triangle's edge with everything that decides whether a line may pass there.
struct Crossing {
  glm::vec3 position;
  glm::vec3 normal;
  float nv;
  float derivative;  ///< Dκr·F² as seen from outside
};

/// Where along the edge a → b a value that is va at a and vb at b becomes zero.
float zero(float va, float vb) {
  return std::clamp(va / (va - vb), 0.0f, 1.0f);
}

/// The least T_SC whose thresholds (S eq. 9) hold for Dκr·F² and nv.
float entry(float derivative, float nv) {
  constexpr float rightAngle = 1.57079632679f;
  const float byDerivative = 2.0f - derivative / defaultMinimumDerivative;
  const float byAngle =
      (rightAngle - std::acos(std::clamp(nv, 0.0f, 1.0f))) / (rightAngle - defaultMinimumAngle);
  return std::clamp(std::max(byDerivative, byAngle), 0.0f, 1.0f);
}

class Extractor {
 public:
  Extractor(const Surface& surface, const model::EyePoint& eye, const LineRequest& request)
      : m_surface(surface), m_eye(eye), m_request(request) {}

  void extract(const Cluster& cluster, LineSet& lines) {
    const Facing side = model::facing(cluster, m_eye);
    if (side == Facing::back && !m_request.twoSided)
      return;
    const bool contours = m_request.contours && side == Facing::mixed;
    // Strictly convex or concave everywhere: κr keeps its sign from every eye.
    const bool suggestive = m_request.suggestive && !(cluster.lowestCurvature > 0.0f) &&
                            !(cluster.highestCurvature < 0.0f);
    if (!contours && !suggestive)
      return;
    computeFields(m_surface.clusters.fields, cluster.firstVertex, cluster.vertexCount, m_eye,
                  m_fields);
    std::fill_n(m_derivativeKnown.begin(), cluster.vertexCount, false);
    for (std::uint32_t i = 0; i < cluster.triangleCount; ++i) {
      const std::uint32_t slot = cluster.firstTriangle + i;
      const auto& local = m_surface.clusters.localTriangles[slot];
      if (contours)
        addContour(cluster, slot, local, lines.contours);
      if (suggestive)
        addSuggestive(cluster, slot, local, lines.suggestive);
    }
  }

 private:
  using Local = std::array<std::uint8_t, 3>;
  enum class Field { facing, curvature };

  std::uint32_t global(const Cluster& cluster, std::uint8_t local) const {
    return m_surface.clusters.vertices[cluster.firstVertex + local];
  }

  float nvAt(std::uint8_t local) const {
    return m_fields.facing[local] / std::sqrt(m_fields.distanceSquared[local]);
  }

  float radialCurvatureAt(std::uint8_t local) const {
    const float d2 = m_fields.distanceSquared[local];
    const float w2 = d2 - m_fields.facing[local] * m_fields.facing[local];
    return m_fields.bending[local] / std::max(w2, 1e-12f * d2);
  }

  /// Dκr·F² at a vertex of the cluster; computed where a line comes near, once a cluster.
  float derivativeAt(const Cluster& cluster, std::uint8_t local) {
    if (m_derivativeKnown[local])
      return m_derivative[local];
    m_derivativeKnown[local] = true;
    const std::uint32_t v = global(cluster, local);
    const glm::vec3 toEye = directionTo(m_eye, m_surface.mesh->positions()[v]);
    const glm::vec2 w =
        viewInPrincipalFrame(m_surface.normals[v], m_surface.curvature.e1[v], toEye);
    return m_derivative[local] =
               m_surface.featureSize * m_surface.featureSize *
               radialCurvatureDerivative(m_surface.curvature.k[v],
                                         m_surface.curvature.derivative[v], w, nvAt(local));
  }

  /// Where a line crosses the edge between two vertices of a cluster, always computed from the
  /// lower vertex number, so that both triangles at the edge get the very same point.
  Crossing crossing(const Cluster& cluster, std::uint8_t a, std::uint8_t b, Field field) {
    if (global(cluster, b) < global(cluster, a))
      std::swap(a, b);
    const float nvA = nvAt(a);
    const float nvB = nvAt(b);
    const bool suggestive = field == Field::curvature;
    const float t = suggestive ? zero(radialCurvatureAt(a), radialCurvatureAt(b)) : zero(nvA, nvB);
    const std::uint32_t va = global(cluster, a);
    const std::uint32_t vb = global(cluster, b);
    const auto mix = [t](const auto& x, const auto& y) { return x + t * (y - x); };
    const auto positions = m_surface.mesh->positions();
    return {
        .position = mix(positions[va], positions[vb]),
        .normal = mix(m_surface.normals[va], m_surface.normals[vb]),
        .nv = mix(nvA, nvB),
        .derivative = suggestive ? mix(derivativeAt(cluster, a), derivativeAt(cluster, b)) : 0.0f};
  }

  /// The corner whose sign differs from the two others; 3 where all have the same. Zero counts as
  /// positive, so every line passes from edge to edge.
  static std::size_t oddCorner(const Local& local, const ClusterFields::Field& field) {
    const bool n0 = field[local[0]] < 0.0f;
    const bool n1 = field[local[1]] < 0.0f;
    const bool n2 = field[local[2]] < 0.0f;
    if (n0 == n1 && n1 == n2)
      return 3;
    return n1 == n2 ? 0 : n0 == n2 ? 1 : 2;
  }

  std::array<Crossing, 2> ends(const Cluster& cluster, const Local& local, std::size_t odd,
                               Field field) {
    return {crossing(cluster, local[odd], local[(odd + 1) % 3], field),
            crossing(cluster, local[odd], local[(odd + 2) % 3], field)};
  }

  void addContour(const Cluster& cluster, std::uint32_t slot, const Local& local,
                  std::vector<Segment>& out) {
    const std::size_t odd = oddCorner(local, m_fields.facing);
    if (odd == 3)
      return;
    const std::array<Crossing, 2> c = ends(cluster, local, odd, Field::facing);
    out.push_back({.a = c[0].position,
                   .b = c[1].position,
                   .normalA = glm::normalize(c[0].normal),
                   .normalB = glm::normalize(c[1].normal),
                   .triangle = m_surface.clusters.triangles[slot],
                   .concave = risesAwayFromEye(cluster, local)});
  }

  /// True where nv falls towards the eye within the triangle: κr < 0 as this very line sees it,
  /// without the noise of the estimated tensor.
  bool risesAwayFromEye(const Cluster& cluster, const Local& local) const {
    const auto positions = m_surface.mesh->positions();
    const glm::vec3 p = positions[global(cluster, local[0])];
    const glm::vec3 e1 = positions[global(cluster, local[1])] - p;
    const glm::vec3 e2 = positions[global(cluster, local[2])] - p;
    const glm::vec3 normal = glm::cross(e1, e2);
    const float nv0 = nvAt(local[0]);
    const float d1 = nvAt(local[1]) - nv0;
    const float d2 = nvAt(local[2]) - nv0;
    // The gradient of a linear function over a triangle, times the (positive) squared normal.
    const glm::vec3 gradient = d1 * glm::cross(e2, normal) + d2 * glm::cross(normal, e1);
    return glm::dot(gradient, directionTo(m_eye, p)) < 0.0f;
  }

  void addSuggestive(const Cluster& cluster, std::uint32_t slot, const Local& local,
                     std::vector<Segment>& out) {
    const std::size_t odd = oddCorner(local, m_fields.bending);
    if (odd == 3)
      return;
    const auto [lowest, highest] = std::minmax(
        {m_fields.facing[local[0]], m_fields.facing[local[1]], m_fields.facing[local[2]]});
    const bool front = highest > 0.0f;
    const bool back = m_request.twoSided && lowest < 0.0f;
    if (!front && !back)
      return;
    // What holds at no corner holds nowhere between them.
    float strongest = -std::numeric_limits<float>::infinity();
    for (const std::uint8_t corner : local) {
      const float d = derivativeAt(cluster, corner);
      strongest = std::max(strongest, m_request.twoSided ? std::abs(d) : d);
    }
    if (!(strongest > m_request.thresholds.minimumDerivative))
      return;
    const std::array<Crossing, 2> c = ends(cluster, local, odd, Field::curvature);
    if (front)
      addClipped(c, 1.0f, slot, out);
    if (back)
      addClipped(c, -1.0f, slot, out);
  }

  /// Cuts the line to where all conditions of METHOD §5 hold on one side of the surface: `side` 1
  /// seen from outside, −1 from within (n and the derivative change sign).
  void addClipped(const std::array<Crossing, 2>& c, float side, std::uint32_t slot,
                  std::vector<Segment>& out) const {
    const float cosine = std::cos(m_request.thresholds.minimumAngle);
    const auto excess = [&](const Crossing& x) {
      return side * x.derivative - m_request.thresholds.minimumDerivative;
    };
    float low = 0.0f;
    float high = 1.0f;
    const auto keepPositive = [&](float atA, float atB) {
      if (atA <= 0.0f && atB <= 0.0f)
        high = -1.0f;
      else if (atA <= 0.0f)
        low = std::max(low, zero(atA, atB));
      else if (atB <= 0.0f)
        high = std::min(high, zero(atA, atB));
    };
    keepPositive(side * c[0].nv, side * c[1].nv);
    keepPositive(cosine - side * c[0].nv, cosine - side * c[1].nv);
    keepPositive(excess(c[0]), excess(c[1]));
    if (!(low < high))
      return;
    // At t = 1 exactly y, so that a line's segments share their ends to the last bit.
    const auto mix = [](const auto& x, const auto& y, float t) {
      return t >= 1.0f ? y : x + t * (y - x);
    };
    const auto opacity = [&](float t) {
      // From 0 at the threshold to 1 at twice it: the ends fade out instead of popping (METHOD §5).
      const float t_d = std::max(m_request.thresholds.minimumDerivative, 1e-6f);
      return std::clamp(mix(excess(c[0]), excess(c[1]), t) / t_d, 0.0f, 1.0f);
    };
    out.push_back({.a = mix(c[0].position, c[1].position, low),
                   .b = mix(c[0].position, c[1].position, high),
                   .normalA = side * glm::normalize(mix(c[0].normal, c[1].normal, low)),
                   .normalB = side * glm::normalize(mix(c[0].normal, c[1].normal, high)),
                   .opacityA = opacity(low),
                   .opacityB = opacity(high),
                   .entryA = entry(side * mix(c[0].derivative, c[1].derivative, low),
                                   side * mix(c[0].nv, c[1].nv, low)),
                   .entryB = entry(side * mix(c[0].derivative, c[1].derivative, high),
                                   side * mix(c[0].nv, c[1].nv, high)),
                   .triangle = m_surface.clusters.triangles[slot]});
  }

  const Surface& m_surface;
  const model::EyePoint& m_eye;
  const LineRequest& m_request;
  ClusterFields m_fields;
  ClusterFields::Field m_derivative;
  std::array<bool, Clusters::maximumVertices + 1> m_derivativeKnown;
};

void append(std::vector<Segment>& to, const std::vector<Segment>& from) {
  to.insert(to.end(), from.begin(), from.end());
}
}  // namespace

LineThresholds suggestiveThresholds(Gamma gamma) {
  const float t = std::clamp(gamma.value() - 1.0f, 0.0f, 1.0f);
  constexpr float rightAngle = 1.57079632679f;
  return {.minimumDerivative = (1.0f - t) * defaultMinimumDerivative + defaultMinimumDerivative,
          .minimumAngle = rightAngle - (rightAngle - defaultMinimumAngle) * t};
}

LineSet extractLines(const Surface& surface, const model::Camera& camera,
                     const LineRequest& request) {
  const model::EyePoint eye = eyeOf(camera);
  const std::vector<Cluster>& clusters = surface.clusters.items;
  std::vector<LineSet> parts((clusters.size() + clustersPerTask - 1) / clustersPerTask);
  parallelFor(parts.size(), 1, [&](std::size_t part) {
    Extractor extractor(surface, eye, request);
    const std::size_t end = std::min(clusters.size(), (part + 1) * clustersPerTask);
    for (std::size_t i = part * clustersPerTask; i < end; ++i)
      extractor.extract(clusters[i], parts[part]);
  });
  LineSet lines;
  std::size_t contours = 0;
  std::size_t suggestive = 0;
  for (const LineSet& part : parts) {
    contours += part.contours.size();
    suggestive += part.suggestive.size();
  }
  lines.contours.reserve(contours);
  lines.suggestive.reserve(suggestive);
  for (const LineSet& part : parts) {
    append(lines.contours, part.contours);
    append(lines.suggestive, part.suggestive);
  }
  return lines;
}

bool needsTwoSides(const Surface& surface, const model::Camera& camera) {
  if (!surface.closed)
    return true;
  if (camera.projection == model::Projection::orthographic)
    return false;
  const model::Box& box = surface.mesh->bounds();
  return glm::all(glm::greaterThanEqual(camera.eye, box.low)) &&
         glm::all(glm::lessThanEqual(camera.eye, box.high));
}

}  // namespace sline::render
