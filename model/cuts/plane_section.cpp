// SPDX-License-Identifier: Apache-2.0
#include "model/cuts/plane_section.h"

#include <array>
#include <bit>
#include <unordered_map>

#include "model/base/parallel.h"
#include "model/cuts/odd_even_fill.h"

namespace sline::model {

namespace {

constexpr std::size_t clustersPerTask = 48;
/// A surface with more loose ends than this has no inside worth closing.
constexpr std::size_t mostLooseEnds = 512;

class Cutter {
 public:
  Cutter(const Surface& surface, const Plane& plane) : m_surface(surface), m_plane(plane) {}

  void cut(const Cluster& cluster, std::vector<CutSegment>& out) const {
    const double reach = 1.00001 * double(cluster.bounds.radius);
    if (std::abs(m_plane.distance(cluster.bounds.centre)) > reach)
      return;
    for (std::uint32_t i = 0; i < cluster.triangleCount; ++i)
      cut(m_surface.clusters.triangles[cluster.firstTriangle + i], out);
  }

 private:
  struct Crossing {
    glm::vec3 position;
    glm::vec3 normal;
  };

  /// Returns where the plane crosses the edge between two vertices, always computed from the lower
  /// number, so that both triangles at the edge get exactly the same point.
  Crossing crossing(std::uint32_t a, std::uint32_t b) const {
    if (b < a)
      std::swap(a, b);
    const auto positions = m_surface.mesh->positions();
    const double da = m_plane.distance(positions[a]);
    const double db = m_plane.distance(positions[b]);
    const double t = da / (da - db);
    const glm::dvec3 p(positions[a]);
    const glm::vec3 normal = glm::mix(m_surface.normals[a], m_surface.normals[b], float(t));
    const float length = glm::length(normal);
    return {glm::vec3(p + t * (glm::dvec3(positions[b]) - p)),
            length > 0.0f ? normal / length : m_plane.normal};
  }

  void cut(std::uint32_t triangle, std::vector<CutSegment>& out) const {
    const Triangle& t = m_surface.mesh->triangles()[triangle];
    const auto positions = m_surface.mesh->positions();
    // A vertex on the plane counts as kept, so every line passes from edge to edge.
    const bool k0 = m_plane.keeps(positions[t[0]]);
    const bool k1 = m_plane.keeps(positions[t[1]]);
    const bool k2 = m_plane.keeps(positions[t[2]]);
    if (k0 == k1 && k1 == k2)
      return;
    const std::size_t odd = k1 == k2 ? 0 : k0 == k2 ? 1 : 2;
    const Crossing a = crossing(t[odd], t[(odd + 1) % 3]);
    const Crossing b = crossing(t[odd], t[(odd + 2) % 3]);
    if (a.position != b.position)
      out.push_back({a.position, b.position, a.normal, b.normal, triangle});
  }

  const Surface& m_surface;
  const Plane& m_plane;
};

struct PointHash {
  std::size_t operator()(const glm::vec3& p) const {
    std::uint64_t h = 0;
    for (const float x : {p.x, p.y, p.z})
      h = (h ^ std::bit_cast<std::uint32_t>(x + 0.0f)) * 0x9e3779b97f4a7c15u;
    return std::size_t(h ^ h >> 32);
  }
};

/// A loose end belongs to an odd number of segments, so a line breaks off there.
struct LooseEnd {
  glm::vec3 position;
  glm::vec3 normal;
  std::uint32_t triangle;
};

std::vector<LooseEnd> looseEnds(const std::vector<CutSegment>& segments) {
  std::unordered_map<glm::vec3, bool, PointHash> odd;
  odd.reserve(2 * segments.size());
  for (const CutSegment& s : segments)
    for (const glm::vec3& p : {s.a, s.b}) {
      bool& here = odd[p];
      here = !here;
    }
  std::vector<LooseEnd> loose;
  const auto collect = [&](const glm::vec3& p, const glm::vec3& normal, std::uint32_t triangle) {
    bool& here = odd[p];
    if (here)
      loose.push_back({p, normal, triangle});
    here = false;
  };
  for (const CutSegment& s : segments) {
    collect(s.a, s.normalA, s.triangle);
    collect(s.b, s.normalB, s.triangle);
  }
  return loose;
}

/// Joins loose ends in pairs, each with the nearest that is left.
void bridgeGaps(std::vector<CutSegment>& segments) {
  std::vector<LooseEnd> loose = looseEnds(segments);
  if (loose.size() > mostLooseEnds)
    return;
  while (loose.size() >= 2) {
    const LooseEnd from = loose.back();
    loose.pop_back();
    const auto distance = [&](const LooseEnd& end) {
      const glm::vec3 d = end.position - from.position;
      return glm::dot(d, d);
    };
    const auto to = std::min_element(
        loose.begin(), loose.end(),
        [&](const LooseEnd& a, const LooseEnd& b) { return distance(a) < distance(b); });
    segments.push_back({from.position, to->position, from.normal, to->normal, from.triangle});
    loose.erase(to);
  }
}

void fillCap(const Plane& plane, PlaneSection& section) {
  const PlaneAxes axes = axesOf(plane);
  const auto flat = [&axes](const glm::vec3& p) {
    return glm::dvec2(glm::dot(axes.u, glm::dvec3(p)), glm::dot(axes.v, glm::dvec3(p)));
  };
  std::vector<std::array<glm::dvec2, 2>> edges;
  edges.reserve(section.segments.size());
  for (const CutSegment& s : section.segments)
    edges.push_back({flat(s.a), flat(s.b)});
  const FlatFill fill = oddEvenFill(edges);
  const glm::dvec3 origin = double(plane.offset) * glm::dvec3(plane.normal);
  section.cap.reserve(3 * fill.triangles.size());
  for (const Triangle& t : fill.triangles)
    for (const std::uint32_t i : t) {
      const glm::dvec2& p = fill.points[i];
      section.cap.emplace_back(origin + p.x * axes.u + p.y * axes.v);
    }
  section.capArea = fill.area;
}

}  // namespace

std::vector<glm::vec3> keptPoints(const Mesh& mesh, std::span<const Plane> planes) {
  const auto positions = mesh.positions();
  if (planes.empty())
    return {positions.begin(), positions.end()};
  std::vector<glm::vec3> points;
  for (const glm::vec3& p : positions)
    if (keptByAll(planes, p))
      points.push_back(p);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    std::vector<Plane> others(planes.begin(), planes.end());
    others.erase(others.begin() + std::ptrdiff_t(i));
    for (const Triangle& t : mesh.triangles())
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::vec3& a = positions[t[k]];
        const glm::vec3& b = positions[t[(k + 1) % 3]];
        const double da = planes[i].distance(a);
        const double db = planes[i].distance(b);
        if ((da > 0.0) == (db > 0.0))
          continue;
        const glm::vec3 p = a + float(da / (da - db)) * (b - a);
        if (keptByAll(others, p))
          points.push_back(p);
      }
  }
  return points;
}

double sectionArea(const Mesh& mesh, const Plane& plane) {
  const auto positions = mesh.positions();
  const glm::dvec3 normal(plane.normal);
  const glm::dvec3 origin = double(plane.offset) * normal;
  double twice = 0.0;
  for (const Triangle& t : mesh.triangles()) {
    const std::array<double, 3> off{plane.distance(positions[t[0]]),
                                    plane.distance(positions[t[1]]),
                                    plane.distance(positions[t[2]])};
    const std::array<bool, 3> kept{off[0] <= 0.0, off[1] <= 0.0, off[2] <= 0.0};
    if (kept[0] == kept[1] && kept[1] == kept[2])
      continue;
    const std::size_t odd = kept[1] == kept[2] ? 0 : kept[0] == kept[2] ? 1 : 2;
    const glm::dvec3 corner = glm::dvec3(positions[t[odd]]) - origin;
    const auto crossing = [&](std::size_t other) {
      const double share = off[odd] / (off[odd] - off[other]);
      return glm::mix(corner, glm::dvec3(positions[t[other]]) - origin, share);
    };
    const glm::dvec3 a = crossing((odd + 1) % 3);
    const glm::dvec3 b = crossing((odd + 2) % 3);
    // Both kinds of triangle, with one corner kept or two, turn the line the same way round.
    twice += (kept[odd] ? 1.0 : -1.0) * glm::dot(normal, glm::cross(a, b));
  }
  return 0.5 * std::abs(twice);
}

PlaneSection planeSection(const Surface& surface, const Plane& plane) {
  const std::vector<Cluster>& clusters = surface.clusters.items;
  std::vector<std::vector<CutSegment>> parts((clusters.size() + clustersPerTask - 1) /
                                             clustersPerTask);
  const Cutter cutter(surface, plane);
  parallelFor(parts.size(), 1, [&](std::size_t part) {
    const std::size_t end = std::min(clusters.size(), (part + 1) * clustersPerTask);
    for (std::size_t i = part * clustersPerTask; i < end; ++i)
      cutter.cut(clusters[i], parts[part]);
  });
  PlaneSection section;
  for (const std::vector<CutSegment>& part : parts)
    section.segments.insert(section.segments.end(), part.begin(), part.end());
  if (surface.solid) {
    bridgeGaps(section.segments);
    fillCap(plane, section);
  }
  return section;
}

}  // namespace sline::model
