// SPDX-License-Identifier: Apache-2.0
#include "model/import/molecules/ball_and_stick.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>

#include "model/import/molecules/residues.h"

namespace sline::model {

namespace {

constexpr std::size_t mostSmooth = 1500;
constexpr std::size_t mostBonded = 20'000;
constexpr double spacing = 0.13;
constexpr double blend = 0.16;  ///< Å over which ball and stick flow into each other

double ballRadius(const Atom& atom) {
  return double(ballShare) * double(atom.element->vanDerWaals);
}

/// Describes a stick between two points; `flat` ends stop there, others are round.
struct Stick {
  glm::dvec3 from;
  glm::dvec3 to;
  bool flat = false;
};

/// Returns the signed distance, positive inside.
double insideStick(const Stick& stick, const glm::dvec3& p) {
  const glm::dvec3 axis = stick.to - stick.from;
  const double length = glm::length(axis);
  if (!(length > 1e-6))
    return double(stickRadius) - glm::length(p - stick.from);
  const glm::dvec3 n = axis / length;
  const double along = glm::dot(p - stick.from, n);
  const double across = glm::length(p - stick.from - along * n) - double(stickRadius);
  if (!stick.flat)
    return -(glm::length(p - stick.from - std::clamp(along, 0.0, length) * n) -
             double(stickRadius));
  const double beyond = std::max(-along, along - length);
  const double outside = std::hypot(std::max(across, 0.0), std::max(beyond, 0.0));
  return -(outside + std::min(std::max(across, beyond), 0.0));
}

struct DrawnBall {
  glm::dvec3 centre;
  double radius;
};

/// Represents balls and sticks that flow into each other where they meet.
class Skeleton : public ImplicitSolid {
 public:
  std::vector<DrawnBall> balls;
  std::vector<Stick> sticks;

  std::vector<Box> boxes() const override {
    std::vector<Box> boxes;
    for (const DrawnBall& ball : balls)
      boxes.push_back(around(ball.centre, ball.centre, ball.radius));
    for (const Stick& stick : sticks)
      boxes.push_back(around(stick.from, stick.to, double(stickRadius)));
    return boxes;
  }

  std::unique_ptr<LocalField> within(const Box& box, double step) const override;

  static Box around(const glm::dvec3& a, const glm::dvec3& b, double radius) {
    const double margin = radius + blend;
    return {glm::vec3(glm::min(a, b) - margin), glm::vec3(glm::max(a, b) + margin)};
  }
};

class SkeletonField : public LocalField {
 public:
  std::vector<DrawnBall> balls;
  std::vector<Stick> sticks;

  FieldPoint at(const glm::dvec3& p) const override {
    FieldPoint result{value(p), p};
    if (std::abs(result.value) > spacing)
      return result;
    for (int i = 0; i < 2; ++i) {
      const glm::dvec3 slope = gradient(result.onSurface);
      const double squared = glm::dot(slope, slope);
      if (squared < 0.01)
        break;
      result.onSurface -= value(result.onSurface) / squared * slope;
    }
    return result;
  }

 private:
  /// Returns the greatest of the parts, and more than it where the two greatest are alike (the
  /// polynomial smooth maximum).
  double value(const glm::dvec3& p) const {
    double most = -10.0;
    double next = -10.0;
    const auto add = [&](double inside) {
      next = std::max(next, std::min(most, inside));
      most = std::max(most, inside);
    };
    for (const DrawnBall& ball : balls)
      add(ball.radius - glm::length(p - ball.centre));
    for (const Stick& stick : sticks)
      add(insideStick(stick, p));
    const double alike = std::max(blend - (most - next), 0.0) / blend;
    return most + alike * alike * blend / 4.0;
  }

  glm::dvec3 gradient(const glm::dvec3& p) const {
    constexpr double step = 1e-4;
    glm::dvec3 slope(0.0);
    for (int a = 0; a < 3; ++a) {
      glm::dvec3 forth = p;
      glm::dvec3 back = p;
      forth[a] += step;
      back[a] -= step;
      slope[a] = (value(forth) - value(back)) / (2.0 * step);
    }
    return slope;
  }
};

std::unique_ptr<LocalField> Skeleton::within(const Box& box, double step) const {
  const auto meets = [&](const Box& other) {
    const auto margin = float(step + blend);
    for (int a = 0; a < 3; ++a)
      if (other.low[a] - margin > box.high[a] || other.high[a] + margin < box.low[a])
        return false;
    return true;
  };
  auto field = std::make_unique<SkeletonField>();
  for (const DrawnBall& ball : balls)
    if (meets(around(ball.centre, ball.centre, ball.radius)))
      field->balls.push_back(ball);
  for (const Stick& stick : sticks)
    if (meets(around(stick.from, stick.to, double(stickRadius))))
      field->sticks.push_back(stick);
  if (field->balls.empty() && field->sticks.empty())
    return nullptr;
  return field;
}

void append(TriangleMesh& mesh, const TriangleMesh& more) {
  const auto first = std::uint32_t(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
  for (const Triangle& t : more.triangles)
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

/// Returns an octahedron on the unit sphere, its triangles divided `times` times.
TriangleMesh unitBall(int times) {
  TriangleMesh mesh{
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  for (; times > 0; --times) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [entry, isNew] =
          middles.try_emplace(std::minmax({a, b}), std::uint32_t(mesh.positions.size()));
      if (isNew)
        mesh.positions.push_back(glm::normalize(mesh.positions[a] + mesh.positions[b]));
      return entry->second;
    };
    std::vector<Triangle> finer;
    for (const Triangle& t : mesh.triangles) {
      const std::uint32_t ab = middle(t[0], t[1]);
      const std::uint32_t bc = middle(t[1], t[2]);
      const std::uint32_t ca = middle(t[2], t[0]);
      for (const Triangle& part : {Triangle{t[0], ab, ca}, Triangle{ab, t[1], bc},
                                   Triangle{ca, bc, t[2]}, Triangle{ab, bc, ca}})
        finer.push_back(part);
    }
    mesh.triangles = std::move(finer);
  }
  return mesh;
}

/// Returns how often to divide; the more balls there are, the fewer triangles a ball has.
int divisionsFor(std::size_t count) {
  return count <= 60 ? 4 : count <= 1500 ? 3 : count <= 10'000 ? 2 : 1;
}

/// Returns a closed prism of twelve sides.
TriangleMesh tube(const Stick& stick) {
  constexpr std::uint32_t sides = 12;
  const glm::dvec3 axis = glm::normalize(stick.to - stick.from);
  const glm::dvec3 other =
      std::abs(axis.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 u = glm::normalize(glm::cross(axis, other));
  const glm::dvec3 v = glm::cross(axis, u);
  TriangleMesh mesh;
  for (const glm::dvec3& end : {stick.from, stick.to})
    for (std::uint32_t i = 0; i < sides; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / sides;
      mesh.positions.emplace_back(end + double(stickRadius) *
                                            (std::cos(angle) * u + std::sin(angle) * v));
    }
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t k = (i + 1) % sides;
    mesh.triangles.push_back({i, k, sides + i});
    mesh.triangles.push_back({k, sides + k, sides + i});
    if (i > 1) {
      mesh.triangles.push_back({0, i, i - 1});
      mesh.triangles.push_back({sides, sides + i - 1, sides + i});
    }
  }
  return mesh;
}

TriangleMesh roughMesh(const Skeleton& skeleton) {
  TriangleMesh mesh;
  const TriangleMesh unit = unitBall(divisionsFor(skeleton.balls.size()));
  for (const DrawnBall& ball : skeleton.balls) {
    TriangleMesh placed = unit;
    for (glm::vec3& p : placed.positions)
      p = glm::vec3(ball.centre + ball.radius * glm::dvec3(p));
    append(mesh, placed);
  }
  for (const Stick& stick : skeleton.sticks)
    append(mesh, tube(stick));
  return mesh;
}

const Element* mainElement(std::span<const Atom> atoms) {
  std::map<const Element*, std::size_t> counts;
  for (const Atom& atom : atoms)
    ++counts[atom.element];
  const Element* carbon = elementOf("C");
  if (counts.contains(carbon))
    return carbon;
  const Element* best = atoms.front().element;
  for (const Atom& atom : atoms)
    if (counts[atom.element] > counts[best])
      best = atom.element;
  return best;
}

/// Returns the stick of a bond: it reaches into balls of the main element, and to the surface of
/// others.
std::optional<Stick> stickOf(const Atom& a, const Atom& b, const Element* main) {
  const double apart = glm::length(b.place - a.place);
  const glm::dvec3 axis = (b.place - a.place) / apart;
  const auto cut = [&](const Atom& atom) {
    if (atom.element == main)
      return 0.0;
    const double r = ballRadius(atom);
    // The stick ends a little inside the circle where the ball's surface meets the stick's.
    return std::sqrt(std::max(r * r - double(stickRadius * stickRadius), 0.0)) - 0.04;
  };
  const double first = cut(a);
  const double last = cut(b);
  if (first + last >= apart)
    return std::nullopt;
  return Stick{a.place + first * axis, b.place - last * axis, first > 0.0 || last > 0.0};
}

}  // namespace

std::vector<ElementSurface> ballAndStick(
    std::span<const Atom> atoms, const std::set<std::pair<std::int64_t, std::int64_t>>& bonds,
    const std::function<bool()>& goesOn) {
  if (atoms.empty())
    return {};
  const Element* main = mainElement(atoms);
  Skeleton skeleton;
  std::map<const Element*, std::vector<Atom>> others;
  for (const Atom& atom : atoms)
    if (atom.element == main)
      skeleton.balls.push_back({atom.place, ballRadius(atom)});
    else
      others[atom.element].push_back(atom);
  for (const auto& [a, b] : bondsBetween(atoms.first(std::min(atoms.size(), mostBonded)), bonds))
    if (const auto stick = stickOf(atoms[a], atoms[b], main))
      skeleton.sticks.push_back(*stick);
  std::vector<ElementSurface> surfaces;
  const bool smooth = atoms.size() <= mostSmooth;
  surfaces.push_back({main, !skeleton.sticks.empty(),
                      smooth ? latticeMesh(skeleton, spacing, goesOn) : roughMesh(skeleton)});
  for (const Atom& atom : atoms)
    if (const auto found = others.find(atom.element); found != others.end()) {
      surfaces.push_back({atom.element, false, balls(found->second, ballShare)});
      others.erase(found);
    }
  return surfaces;
}

TriangleMesh balls(std::span<const Atom> atoms, float shareOfRadius) {
  Skeleton skeleton;
  for (const Atom& atom : atoms)
    skeleton.balls.push_back(
        {atom.place, double(shareOfRadius) * double(atom.element->vanDerWaals)});
  return roughMesh(skeleton);
}

}  // namespace sline::model
