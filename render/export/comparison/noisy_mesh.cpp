// SPDX-License-Identifier: Apache-2.0
#include "render/export/comparison/noisy_mesh.h"

#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <vector>

#include "render/export/comparison/sheet_numbers.h"

namespace sline::render {

namespace {

/// How far vertices move to the level of their slice; at 1 steps would be upright.
constexpr float steepness = 0.85f;

/// Returns numbers that look random and are the same everywhere (splitmix64).
class Dice {
 public:
  double uniform() {
    m_state += 0x9e3779b97f4a7c15u;
    std::uint64_t z = m_state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (double((z ^ (z >> 31)) >> 11) + 0.5) / 9007199254740992.0;
  }
  float normal() {
    return float(std::sqrt(-2.0 * std::log(uniform())) *
                 std::cos(2.0 * std::numbers::pi * uniform()));
  }

 private:
  std::uint64_t m_state = 1;
};

}  // namespace

Result<Noise> parseNoise(std::string_view text) {
  const std::size_t sign = text.find('=');
  Noise noise;
  bool known = false;
  for (std::size_t i = 0; i < noiseNames.size(); ++i)
    if (text.substr(0, sign) == noiseNames[i]) {
      noise = {NoiseKind(i), usualNoise[i]};
      known = true;
    }
  if (!known)
    return Error{.reason = "\"" + std::string(text.substr(0, sign)) + "\" is no kind of noise",
                 .remedy = "Write staircase or jitter, as in jitter=0.2"};
  if (sign == std::string_view::npos)
    return noise;
  const std::string_view number = text.substr(sign + 1);
  const auto [end, failure] =
      std::from_chars(number.data(), number.data() + number.size(), noise.amount);
  if (number.empty() || failure != std::errc{} || end != number.data() + number.size() ||
      !noiseLimits.contain(noise.amount))
    return Error{.reason = "\"" + std::string(text) + "\" has no amount of noise",
                 .remedy = "Write a number of mean edges from 0 to 20, as in jitter=0.2"};
  return noise;
}

std::string noiseText(const Noise& noise) {
  return std::string(noiseNames[std::size_t(noise.kind)]) + ", " + shortNumber(noise.amount) +
         " edges";
}

float meanEdge(const model::Mesh& mesh) {
  double sum = 0.0;
  const auto positions = mesh.positions();
  for (const model::Triangle& t : mesh.triangles())
    for (std::size_t i = 0; i < 3; ++i)
      sum += double(glm::distance(positions[t[i]], positions[t[(i + 1) % 3]]));
  return mesh.triangleCount() > 0 ? float(sum / (3.0 * double(mesh.triangleCount()))) : 0.0f;
}

model::MeshPtr withNoise(const model::Mesh& mesh, const Noise& noise) {
  const float size = noise.amount * meanEdge(mesh);
  std::vector<glm::vec3> positions(mesh.positions().begin(), mesh.positions().end());
  Dice dice;
  constexpr float turn = 2.0f * std::numbers::pi_v<float>;
  for (glm::vec3& p : positions) {
    if (noise.kind == NoiseKind::jitter)
      p += size * glm::vec3(dice.normal(), dice.normal(), dice.normal()) / std::sqrt(3.0f);
    else if (size > 0.0f)
      p.z -= steepness * size / turn * std::sin(turn * (p.z - mesh.bounds().low.z) / size);
  }
  Result<model::Mesh> rough =
      model::Mesh::create(std::move(positions), {mesh.triangles().begin(), mesh.triangles().end()});
  if (!rough.ok())
    return std::make_shared<const model::Mesh>(mesh);
  return std::make_shared<const model::Mesh>(std::move(*rough));
}

}  // namespace sline::render
