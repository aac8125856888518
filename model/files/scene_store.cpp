// SPDX-License-Identifier: Apache-2.0
// Layout, little-endian: magic, checksum of all that follows, key, nodes in tree order, sections,
// views. Texts and lists are led by their length; what may be absent by a byte 0 or 1.
#include "model/files/scene_store.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <set>
#include <utility>

#include "model/files/whole_file.h"

namespace sline::model {

namespace {
static_assert(std::endian::native == std::endian::little, "floats and indices are copied whole");

constexpr std::string_view magic = "SlineSc1";
constexpr std::size_t largestStore = std::size_t(1) << 30;
constexpr std::uint32_t longestText = 4096;
constexpr std::uint32_t mostNodes = 100'000;

/// Fowler, Noll and Vo's hash over words of eight bytes, the last one filled with zeros: it finds
/// damage, not malice.
std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t hash = 14695981039346656037ull;
  while (!bytes.empty()) {
    std::uint64_t word = 0;
    const std::size_t size = std::min<std::size_t>(8, bytes.size());
    std::memcpy(&word, bytes.data(), size);
    hash = (hash ^ word) * 1099511628211ull;
    hash ^= hash >> 29;
    bytes.remove_prefix(size);
  }
  return hash;
}

class Writer {
 public:
  std::string bytes;

  template <class T>
  void value(T v) {
    static_assert(std::is_arithmetic_v<T>);
    bytes.append(reinterpret_cast<const char*>(&v), sizeof v);
  }
  template <class T>
  void list(std::span<const T> values) {
    value(std::uint32_t(values.size()));
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  }
  void text(std::string_view t) { list(std::span<const char>(t)); }
  void point(const glm::vec3& p) {
    for (int axis = 0; axis < 3; ++axis)
      value(p[axis]);
  }
  template <class T, class Write>
  void maybe(const std::optional<T>& v, const Write& write) {
    value(std::uint8_t(v.has_value()));
    if (v)
      write(*v);
  }
};

/// After the first thing that is wrong it hands out zeros and remembers what it was.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : m_bytes(bytes) {}

  const std::string& fault() const { return m_fault; }
  bool atEnd() const { return m_bytes.empty(); }
  void fail(const std::string& reason) {
    if (m_fault.empty())
      m_fault = reason;
    m_bytes = {};
  }

  template <class T>
  T value() {
    static_assert(std::is_arithmetic_v<T>);
    T v{};
    if (m_bytes.size() < sizeof v) {
      fail("it ends too early");
      return v;
    }
    std::memcpy(&v, m_bytes.data(), sizeof v);
    m_bytes.remove_prefix(sizeof v);
    return v;
  }
  template <class T>
  std::vector<T> list() {
    const std::size_t count = value<std::uint32_t>();
    if (m_bytes.size() / sizeof(T) < count) {
      fail("a list is longer than the file");
      return {};
    }
    std::vector<T> values(count);
    if (count > 0)
      std::memcpy(values.data(), m_bytes.data(), count * sizeof(T));
    m_bytes.remove_prefix(count * sizeof(T));
    return values;
  }
  std::string text() {
    const std::vector<char> characters = list<char>();
    if (characters.size() > longestText)
      fail("a text is too long");
    return {characters.begin(), characters.end()};
  }
  float number() {
    const float v = value<float>();
    if (!std::isfinite(v))
      fail("a number is not finite");
    return v;
  }
  glm::vec3 point() {
    const float x = number();
    const float y = number();
    return {x, y, number()};
  }
  bool flag() {
    const auto v = value<std::uint8_t>();
    if (v > 1)
      fail("a flag is neither 0 nor 1");
    return v == 1;
  }
  template <class Read>
  auto maybe(const Read& read) -> std::optional<decltype(read())> {
    return flag() ? std::optional(read()) : std::nullopt;
  }

 private:
  std::string_view m_bytes;
  std::string m_fault;
};

void write(Writer& out, const Style& style) {
  const auto colour = [&out](const Colour& c) {
    for (const std::uint8_t channel : {c.red, c.green, c.blue})
      out.value(channel);
  };
  out.maybe(style.colour, colour);
  out.maybe(style.inkColour, colour);
  out.maybe(style.gamma, [&](Gamma v) { out.value(v.value()); });
  out.maybe(style.opacity, [&](Opacity v) { out.value(v.value()); });
  out.maybe(style.fill, [&](Fill v) { out.value(std::uint8_t(v)); });
  out.maybe(style.visible, [&](bool v) { out.value(std::uint8_t(v)); });
  out.maybe(style.penWeight, [&](float v) { out.value(v); });
}

template <class T>
T bounded(Reader& in) {
  const std::optional<T> v = T::from(in.number());
  if (!v)
    in.fail("a value is out of range");
  return v.value_or(T());
}

Style readStyle(Reader& in) {
  const auto colour = [&in] {
    Colour c;
    for (std::uint8_t* channel : {&c.red, &c.green, &c.blue})
      *channel = in.value<std::uint8_t>();
    return c;
  };
  Style style;
  style.colour = in.maybe(colour);
  style.inkColour = in.maybe(colour);
  style.gamma = in.maybe([&] { return bounded<Gamma>(in); });
  style.opacity = in.maybe([&] { return bounded<Opacity>(in); });
  style.fill = in.maybe([&] {
    const auto v = in.value<std::uint8_t>();
    if (v > std::uint8_t(Fill::tint))
      in.fail("a fill is unknown");
    return Fill(v);
  });
  style.visible = in.maybe([&] { return in.flag(); });
  style.penWeight = in.maybe([&] { return in.number(); });
  return style;
}

void write(Writer& out, const Provenance& p) {
  out.text(p.file);
  out.text(p.frame);
  out.text(p.frameReason);
  for (const int count : {p.smoothingSteps, p.refinementSteps, p.repairedFaces})
    out.value(std::int32_t(count));
  out.value(p.displacementMm);
}

Provenance readProvenance(Reader& in) {
  Provenance p;
  p.file = in.text();
  p.frame = in.text();
  p.frameReason = in.text();
  for (int* count : {&p.smoothingSteps, &p.refinementSteps, &p.repairedFaces})
    *count = in.value<std::int32_t>();
  p.displacementMm = in.number();
  return p;
}

void write(Writer& out, const Node& node) {
  out.value(node.id.value);
  out.value(node.parent.value);
  out.text(node.name);
  write(out, node.style);
  write(out, node.provenance);
  out.value(std::uint8_t(!node.isGroup()));
  if (node.isGroup())
    return;
  out.list(node.mesh->positions());
  out.list(node.mesh->triangles());
}

Node readNode(Reader& in) {
  Node node;
  node.id.value = in.value<std::uint64_t>();
  node.parent.value = in.value<std::uint64_t>();
  node.name = in.text();
  node.style = readStyle(in);
  node.provenance = readProvenance(in);
  if (!in.flag())
    return node;
  auto positions = in.list<glm::vec3>();
  auto triangles = in.list<Triangle>();
  Result<Mesh> mesh = Mesh::create(std::move(positions), std::move(triangles));
  if (mesh.ok())
    node.mesh = std::make_shared<const Mesh>(std::move(mesh).value());
  else
    in.fail(mesh.error().reason);
  return node;
}

/// Each node new, and below the node before it or one of that node's groups: tree order.
bool inTreeOrder(const std::vector<Node>& nodes) {
  std::set<NodeId> ids{rootId};
  std::vector<NodeId> open{rootId};
  for (const Node& node : nodes) {
    while (!open.empty() && open.back() != node.parent)
      open.pop_back();
    if (open.empty() || !ids.insert(node.id).second)
      return false;
    if (node.isGroup())
      open.push_back(node.id);
  }
  return true;
}

template <class T, class Read>
std::vector<T> readAll(Reader& in, const Read& read) {
  const auto count = in.value<std::uint32_t>();
  std::vector<T> all;
  if (count > mostNodes)
    in.fail("it promises too many parts");
  for (std::uint32_t i = 0; i < count && in.fault().empty(); ++i)
    all.push_back(read(in));
  return all;
}

void write(Writer& out, const Section& section) {
  out.value(section.id.value);
  out.text(section.name);
  out.point(section.plane.normal);
  out.value(section.plane.offset);
  out.value(section.scope.value);
  out.value(std::uint8_t(section.enabled));
  out.value(std::uint8_t(section.hatched));
}

Section readSection(Reader& in) {
  Section section;
  section.id.value = in.value<std::uint64_t>();
  section.name = in.text();
  section.plane.normal = in.point();
  section.plane.offset = in.number();
  section.scope.value = in.value<std::uint64_t>();
  section.enabled = in.flag();
  section.hatched = in.flag();
  if (const auto fault = planeFault(section.plane); fault && in.fault().empty())
    in.fail("a plane cannot be used: " + std::string(*fault));
  return section;
}

void write(Writer& out, const std::vector<Section>& sections) {
  out.value(std::uint32_t(sections.size()));
  for (const Section& section : sections)
    write(out, section);
}

/// Each under an id of its own.
std::vector<Section> readSections(Reader& in) {
  std::vector<Section> sections = readAll<Section>(in, readSection);
  std::set<SectionId> ids;
  for (const Section& section : sections)
    if (!ids.insert(section.id).second)
      in.fail("two sections have one id");
  return sections;
}

void write(Writer& out, const View& view) {
  const Camera& camera = view.camera;
  out.text(view.name);
  out.value(std::uint8_t(camera.projection == Projection::orthographic));
  for (const glm::vec3& p : {camera.eye, camera.target, camera.up})
    out.point(p);
  out.value(camera.fovyDegrees);
  out.value(camera.heightMm);
  out.maybe(view.sections, [&](const std::vector<Section>& sections) { write(out, sections); });
}

View readView(Reader& in) {
  View view;
  view.name = in.text();
  Camera& camera = view.camera;
  camera.projection = in.flag() ? Projection::orthographic : Projection::perspective;
  for (glm::vec3* p : {&camera.eye, &camera.target, &camera.up})
    *p = in.point();
  camera.fovyDegrees = in.number();
  camera.heightMm = in.number();
  if (const auto fault = cameraFault(camera); fault && in.fault().empty())
    in.fail("a camera cannot be used: " + std::string(*fault));
  view.sections = in.maybe([&] { return readSections(in); });
  return view;
}

Error unreadable(const std::string& reason) {
  return {.reason = reason, .remedy = "Remove the file; it is made again"};
}
}  // namespace

std::string storedScene(const Scene& scene, std::string_view key) {
  Writer body;
  body.text(key);
  body.value(std::uint32_t(scene.nodes().size()));
  for (const Node& node : scene.nodes())
    write(body, node);
  write(body, scene.sections());
  body.value(std::uint32_t(scene.views().size()));
  for (const View& view : scene.views())
    write(body, view);
  Writer whole;
  whole.bytes = magic;
  whole.value(checksum(body.bytes));
  return whole.bytes + body.bytes;
}

Result<Scene> sceneFromStore(std::string_view bytes, std::string_view key) {
  if (!bytes.starts_with(magic))
    return unreadable("it is no stored scene of this version");
  Reader head(bytes.substr(magic.size()));
  const auto promised = head.value<std::uint64_t>();
  if (!head.fault().empty())
    return unreadable(head.fault());
  const std::string_view body = bytes.substr(magic.size() + sizeof promised);
  if (checksum(body) != promised)
    return unreadable("its checksum is wrong: it was cut or changed");
  Reader in(body);
  if (in.text() != key)
    return unreadable("it holds another scene");
  std::vector<Node> nodes = readAll<Node>(in, readNode);
  std::vector<Section> sections = readSections(in);
  std::vector<View> views = readAll<View>(in, readView);
  if (in.fault().empty() && !in.atEnd())
    in.fail("something follows its end");
  if (in.fault().empty() && !inTreeOrder(nodes))
    in.fail("its tree is out of order");
  if (!in.fault().empty())
    return unreadable(in.fault());
  Scene scene;
  scene.setNodes(std::move(nodes));
  scene.setSections(std::move(sections));
  scene.setViews(std::move(views));
  return scene;
}

Status writeSceneStore(const std::filesystem::path& file, const Scene& scene,
                       std::string_view key) {
  std::error_code ignored;  // a folder that is missing after all is the write's error
  std::filesystem::create_directories(file.parent_path(), ignored);
  return writeText(file, storedScene(scene, key));
}

Result<Scene> readSceneStore(const std::filesystem::path& file, std::string_view key) {
  const Result<std::string> bytes = readText(file, largestStore);
  if (!bytes.ok())
    return bytes.error();
  Result<Scene> scene = sceneFromStore(*bytes, key);
  if (scene.ok())
    return scene;
  Error error = scene.error();
  error.file = file.string();
  return error;
}

}  // namespace sline::model
