// SPDX-License-Identifier: Apache-2.0
// Reads 3MF: objects are meshes or put together of other objects; the build says which of them
// there are, and where.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>
#include <new>

#include "model/import/readers/readers.h"
#include "model/import/readers/three_mf_document.h"
#include "model/import/source/surface_assembly.h"
#include "model/import/source/text_cursor.h"
#include "model/import/source/values.h"

namespace sline::model {

namespace {

constexpr std::size_t deepestObject = 64;
constexpr std::size_t mostVisits = 100'000;
/// The bytes that instances may make of a file beyond its own meshes.
constexpr std::uint64_t alwaysAllowed = std::uint64_t(64) << 20;
constexpr std::uint64_t bytesPerByte = 16;

/// Describes an object that is to be put somewhere.
struct ObjectVisit {
  ThreeMfPart* part = nullptr;
  std::string object;
  glm::dmat4 toModel{1.0};
  std::vector<std::string> groups;
};

/// Reads twelve numbers: the rows of a matrix with which row vectors are multiplied (§3.3). Returns
/// the identity where there is no text.
std::optional<glm::dmat4> transformIn(std::string_view text) {
  glm::dmat4 matrix(1.0);
  if (text.empty())
    return matrix;
  TextCursor cursor(text);
  for (int i = 0; i < 12; ++i) {
    double value = 0.0;
    cursor.skipSpace();
    if (!cursor.number(value) || !std::isfinite(value))
      return std::nullopt;
    matrix[i / 3][i % 3] = value;
  }
  cursor.skipSpace();
  if (!cursor.atEnd())
    return std::nullopt;
  return matrix;
}

bool numberIn(const XmlNode& node, const char* attribute, float& value) {
  const std::string_view text = node.attribute(attribute).value();
  TextCursor cursor(text);
  cursor.skipSpace();
  return cursor.number(value);
}

bool indexIn(const XmlNode& node, const char* attribute, std::int64_t& value) {
  const std::string_view text = node.attribute(attribute).value();
  TextCursor cursor(text);
  cursor.skipSpace();
  return cursor.integer(value);
}

struct Unit3mf {
  std::string_view name;
  float millimetres;
};
constexpr std::array<Unit3mf, 6> units{{{"micron", 0.001f},
                                        {"millimeter", 1.0f},
                                        {"centimeter", 10.0f},
                                        {"inch", 25.4f},
                                        {"foot", 304.8f},
                                        {"meter", 1000.0f}}};

class ThreeMfReader {
 public:
  explicit ThreeMfReader(ThreeMfDocument& document)
      : m_document(document),
        m_source(document.source()),
        m_budget(alwaysAllowed + bytesPerByte * m_source.size()) {}

  Result<RawMeshes> read() {
    TRY(readUnit());
    TRY(placeBuild());
    if (m_result.meshes.empty())
      return m_source.whole("holds no object with triangles");
    return std::move(m_result);
  }

 private:
  Status readUnit() {
    const std::string_view text = m_document.root().model.attribute("unit").value();
    const std::string_view name = text.empty() ? "millimeter" : text;
    const auto found = std::find_if(units.begin(), units.end(),
                                    [&](const Unit3mf& unit) { return unit.name == name; });
    if (found == units.end())
      return m_source.whole("its unit " + inQuotes(name) + " is none of 3MF's");
    m_millimetres = found->millimetres;
    m_unitReason = "3MF: " + std::string(name);
    return Unit{};
  }

  /// Places all items of the build; in a file without any, the objects that are no component.
  Status placeBuild() {
    ThreeMfPart& root = m_document.root();
    bool any = false;
    for (const XmlNode& item : localChild(root.model, "build").children()) {
      if (localName(item) != "item")
        continue;
      any = true;
      TRY(place(item, {.part = &root}, 0));
    }
    if (any)
      return Unit{};
    std::map<std::string, bool> isComponent;
    for (const auto& [id, object] : root.objects)
      for (const XmlNode& component : localChild(object, "components").children())
        isComponent[component.attribute("objectid").value()] = true;
    for (const auto& [id, object] : root.objects)
      if (!isComponent[id])
        TRY(visit({.part = &root, .object = id}, 0));
    return Unit{};
  }

  /// Places an <item> or <component>, inside the placement that `above` has.
  Status place(const XmlNode& node, const ObjectVisit& above, std::size_t depth) {
    ObjectVisit visiting = above;
    visiting.object = node.attribute("objectid").value();
    if (const std::string_view path = localAttribute(node, "path"); !path.empty()) {
      visiting.part = TRY(m_document.part(path));
    }
    const auto own = transformIn(node.attribute("transform").value());
    if (!own)
      return m_source.at("object " + inQuotes(visiting.object),
                         "its transform is not twelve numbers");
    visiting.toModel = above.toModel * *own;
    if (!isFinite(visiting.toModel))
      return m_source.at("object " + inQuotes(visiting.object), "its transform is not finite");
    return visit(visiting, depth);
  }

  Status visit(const ObjectVisit& visiting, std::size_t depth) {
    const std::string where = "object " + inQuotes(visiting.object);
    const auto found = visiting.part->objects.find(visiting.object);
    if (found == visiting.part->objects.end())
      return m_source.at(where, "does not exist");
    if (depth > deepestObject)
      return m_source.at(where, "objects lie more than " + std::to_string(deepestObject) +
                                    " levels deep in each other, or in a circle");
    if (++m_visits > mostVisits)
      return tooMany(where);
    const XmlNode& object = found->second;
    const std::string_view type = object.attribute("type").value();
    if (type == "support" || type == "solidsupport") {
      m_result.warnings.push_back(m_source.warning(where + " only supports the print; left out"));
      return Unit{};
    }
    if (const XmlNode mesh = localChild(object, "mesh"))
      return addMesh(object, mesh, visiting);
    std::uint64_t names = visiting.object.size();
    for (const std::string& group : visiting.groups)
      names += group.size();
    if (!granted(names))
      return tooMany(where);
    ObjectVisit inside = visiting;
    if (const std::string name = object.attribute("name").value(); !name.empty())
      inside.groups.push_back(name);
    for (const XmlNode& component : localChild(object, "components").children())
      if (localName(component) == "component")
        TRY(place(component, inside, depth + 1));
    return Unit{};
  }

  bool granted(std::uint64_t bytes) {
    if (bytes > m_budget)
      return false;
    m_budget -= bytes;
    return true;
  }

  Error tooMany(const std::string& where) const {
    return m_source.at(where, "the file repeats its objects far beyond its own size",
                       "Reduce the number of instances");
  }

  Status addMesh(const XmlNode& object, const XmlNode& mesh, const ObjectVisit& visiting) {
    const std::string where = "object " + inQuotes(visiting.object);
    auto& known = m_meshes[object.internal_object()];
    if (!known) {
      RawMesh read = TRY(readMesh(object, mesh, *visiting.part, where));
      known = std::make_unique<RawMesh>(std::move(read));
    }
    if (!granted(12 * std::uint64_t(known->positions.size()) +
                 12 * std::uint64_t(known->triangles.size()) + known->name.size() + 256))
      return tooMany(where);
    RawMesh placed = *known;
    placed.groups = visiting.groups;
    for (glm::vec3& p : placed.positions) {
      const glm::dvec4 moved = visiting.toModel * glm::dvec4(p, 1.0);
      p = {narrowed(moved.x), narrowed(moved.y), narrowed(moved.z)};
    }
    if (glm::determinant(glm::dmat3(visiting.toModel)) < 0.0)
      for (Triangle& t : placed.triangles)
        std::swap(t[1], t[2]);
    return finish(m_source, std::move(placed), m_result);
  }

  Result<RawMesh> readMesh(const XmlNode& object, const XmlNode& node, const ThreeMfPart& part,
                           const std::string& where) const {
    RawMesh mesh;
    mesh.name = object.attribute("name").value();
    mesh.millimetresPerUnit = m_millimetres;
    mesh.unitReason = m_unitReason;
    for (const XmlNode& vertex : localChild(node, "vertices").children()) {
      glm::vec3 p(0.0f);
      if (!numberIn(vertex, "x", p.x) || !numberIn(vertex, "y", p.y) || !numberIn(vertex, "z", p.z))
        return m_source.at(where + ", vertex " + std::to_string(mesh.positions.size()),
                           "its x, y and z are not three numbers");
      mesh.positions.push_back(p);
    }
    std::map<std::pair<std::string_view, std::int64_t>, std::size_t> painted;
    for (const XmlNode& triangle : localChild(node, "triangles").children()) {
      Triangle corners{};
      constexpr std::array<const char*, 3> names{"v1", "v2", "v3"};
      for (std::size_t i = 0; i < names.size(); ++i) {
        std::int64_t index = -1;
        if (!indexIn(triangle, names[i], index) || index < 0 ||
            std::uint64_t(index) >= mesh.positions.size())
          return m_source.at(where + ", triangle " + std::to_string(mesh.triangles.size()),
                             std::string(names[i]) + " is no index of its " +
                                 std::to_string(mesh.positions.size()) + " vertices");
        corners[i] = std::uint32_t(index);
      }
      mesh.triangles.push_back(corners);
      if (std::int64_t colour = 0; indexIn(triangle, "p1", colour))
        ++painted[{triangle.attribute("pid").value(), colour}];
    }
    mesh.colour = colourOf(object, painted, part);
    return mesh;
  }

  /// Returns the colour with which most of an object's triangles are painted, else the object's
  /// own.
  static std::optional<Colour> colourOf(
      const XmlNode& object,
      const std::map<std::pair<std::string_view, std::int64_t>, std::size_t>& painted,
      const ThreeMfPart& part) {
    std::string_view group = object.attribute("pid").value();
    std::int64_t index = 0;
    indexIn(object, "pindex", index);
    std::size_t most = 0;
    for (const auto& [paint, count] : painted)
      if (count > most) {
        most = count;
        group = paint.first.empty() ? group : paint.first;
        index = paint.second;
      }
    const auto colours = part.colours.find(group);
    if (colours == part.colours.end() || index < 0 ||
        std::uint64_t(index) >= colours->second.size())
      return std::nullopt;
    return colours->second[std::size_t(index)];
  }

  ThreeMfDocument& m_document;
  const Source& m_source;
  std::uint64_t m_budget;
  std::size_t m_visits = 0;
  float m_millimetres = 1.0f;
  std::string m_unitReason;
  RawMeshes m_result;
  /// Holds meshes that are read once, however often they are placed.
  std::map<const void*, std::unique_ptr<RawMesh>> m_meshes;
};

}  // namespace

Result<RawMeshes> readThreeMf(const std::filesystem::path& file, const ReadLimits& limits) {
  const Source source = TRY(Source::read(file, limits));
  try {
    ThreeMfDocument document = TRY(ThreeMfDocument::open(source));
    return ThreeMfReader(document).read();
  } catch (const std::bad_alloc&) {
    return source.whole("there is not enough memory for it", "Reduce it or close other programs");
  }
}

}  // namespace sline::model
