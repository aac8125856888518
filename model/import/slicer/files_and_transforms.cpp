// SPDX-License-Identifier: Apache-2.0
#include "model/import/slicer/files_and_transforms.h"

#include <algorithm>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <set>

namespace sline::model {

namespace fs = std::filesystem;

bool staysInside(const fs::path& relative) {
  const fs::path tidy = relative.lexically_normal();
  return !tidy.empty() && !tidy.is_absolute() && *tidy.begin() != "..";
}

std::optional<fs::path> fileOfSlicer(const fs::path& scene, const std::string& written,
                                     std::vector<ImportWarning>& warnings) {
  const fs::path folder = scene.parent_path();
  std::string slashes = written;
  std::replace(slashes.begin(), slashes.end(), '\\', '/');
  const std::string decoded = percentDecoded(slashes);
  std::error_code fault;
  for (const std::string& name : {slashes, decoded})
    if (staysInside(name) && fs::is_regular_file(folder / name, fault))
      return folder / fs::path(name).lexically_normal();
  const bool escapes = !staysInside(decoded) || (decoded.size() > 1 && decoded[1] == ':');
  for (const std::string& name : {slashes, decoded}) {
    const fs::path base = fs::path(name).filename();
    if (!escapes || base.empty() || base == "..")
      continue;
    for (const fs::path& place : {folder / base, folder / "Data" / base})
      if (fs::is_regular_file(place, fault))
        return place;
  }
  warnings.push_back(
      {written, escapes ? "the scene refers to a place outside its folder; it was left out"
                        : "the file is absent; it was left out"});
  return std::nullopt;
}

std::optional<glm::dmat4> SlicerTransforms::ownMatrix(const XmlNode& transform) const {
  const std::string name = transform.attribute("name").value();
  const std::string kind = transform.name();
  const char* const toParent = transform.attribute("matrixTransformToParent").value();
  const char* const fromParent = transform.attribute("matrixTransformFromParent").value();
  const bool inverse = *toParent == '\0' && *fromParent != '\0';
  if (*toParent == '\0' && *fromParent == '\0') {
    warn("transform \"" + name + "\" is not a matrix in the scene (" + kind +
         "); what hangs on it stays untransformed");
    return std::nullopt;
  }
  const auto values = numbers(inverse ? fromParent : toParent, 16);
  glm::dmat4 matrix(1.0);
  for (int row = 0; values && row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      matrix[column][row] = (*values)[std::size_t(row) * 4 + std::size_t(column)];
  const double size = glm::determinant(glm::dmat3(matrix));
  const bool affine =
      matrix[0][3] == 0.0 && matrix[1][3] == 0.0 && matrix[2][3] == 0.0 && matrix[3][3] == 1.0;
  if (!values || !affine || !(std::abs(size) > 1e-12)) {
    warn("the matrix of transform \"" + name +
         (values ? "\" is singular or not affine" : "\" is not 16 numbers") +
         "; what hangs on it stays untransformed");
    return std::nullopt;
  }
  return inverse ? glm::inverse(matrix) : matrix;
}

const SlicerTransforms::World& SlicerTransforms::worldOf(const std::string& id) {
  std::vector<std::string> unknown;
  std::set<std::string> seen;
  World world{glm::dmat4(1.0), {}};
  for (std::string at = id; !at.empty();
       at = SlicerNodes::reference(m_nodes.find(at), "transform")) {
    if (const auto known = m_worlds.find(at); known != m_worlds.end()) {
      world = known->second;
      break;
    }
    const bool circle = !seen.insert(at).second;
    if (circle || !m_nodes.find(at)) {
      world = {std::nullopt, circle ? "transforms refer to each other in a circle (" + at + ")"
                                    : "transform " + at + " is absent"};
      break;
    }
    unknown.push_back(at);
  }
  std::reverse(unknown.begin(), unknown.end());
  for (const std::string& at : unknown) {
    if (world.matrix) {
      const std::optional<glm::dmat4> own = ownMatrix(m_nodes.find(at));
      world.matrix = own ? std::optional(*world.matrix * *own) : std::nullopt;
    }
    m_worlds[at] = world;
  }
  return m_worlds.try_emplace(id, world).first->second;
}

std::optional<glm::dmat4> SlicerTransforms::above(const XmlNode& node, const std::string& name) {
  const std::string id = SlicerNodes::reference(node, "transform");
  if (id.empty())
    return std::nullopt;
  const World& world = worldOf(id);
  if (!world.fault.empty())
    warn(world.fault + "; \"" + name + "\" stays untransformed");
  return world.matrix;
}

}  // namespace sline::model
