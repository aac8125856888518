// SPDX-License-Identifier: Apache-2.0
// Writes Blender's files: blocks of structures, each with the address that it had in memory, and a
// table ("SDNA") of the structures' fields.
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "tests/model/import/foreign/written_scenes.h"

namespace sline::test {

namespace {

using Address = std::uint64_t;

template <class T>
void putNumber(QByteArray& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

/// Returns a name, with its two letters for the kind, filled up to 66 bytes.
QByteArray blendId(const char* name) {
  return QByteArray(name).leftJustified(66, '\0');
}

struct BlendStructure {
  const char* name;
  std::vector<std::pair<const char*, const char*>> fields;  ///< type and name
};

const std::vector<BlendStructure>& blendStructures() {
  static const std::vector<BlendStructure> table{
      {"ID", {{"char", "name[66]"}}},
      {"ListBase", {{"void", "*first"}, {"void", "*last"}}},
      {"Scene", {{"ID", "id"}, {"ListBase", "base"}}},
      {"Base", {{"Base", "*next"}, {"Base", "*prev"}, {"Object", "*object"}}},
      {"Object",
       {{"ID", "id"},
        {"short", "type"},
        {"float", "obmat[4][4]"},
        {"Object", "*parent"},
        {"void", "*data"},
        {"ListBase", "modifiers"}}},
      {"Mesh",
       {{"ID", "id"},
        {"int", "totface"},
        {"int", "totedge"},
        {"int", "totvert"},
        {"int", "totloop"},
        {"int", "totpoly"},
        {"MFace", "*mface"},
        {"MVert", "*mvert"},
        {"MLoop", "*mloop"},
        {"MPoly", "*mpoly"},
        {"Material", "**mat"}}},
      {"MFace", {{"int", "v1"}, {"int", "v2"}, {"int", "v3"}, {"int", "v4"}, {"short", "mat_nr"}}},
      {"MVert", {{"float", "co[3]"}, {"short", "no[3]"}}},
      {"MLoop", {{"int", "v"}, {"int", "e"}}},
      {"MPoly", {{"int", "loopstart"}, {"int", "totloop"}, {"short", "mat_nr"}}},
      {"Material",
       {{"ID", "id"}, {"float", "r"}, {"float", "g"}, {"float", "b"}, {"float", "alpha"}}}};
  return table;
}

/// Returns the table: names of fields, of types, sizes of types, and which fields each structure
/// has.
QByteArray blendTable() {
  std::vector<std::string> names;
  std::vector<std::string> types;
  const auto numberIn = [](std::vector<std::string>& list, const std::string& text) {
    for (std::size_t i = 0; i < list.size(); ++i)
      if (list[i] == text)
        return std::int16_t(i);
    list.push_back(text);
    return std::int16_t(list.size() - 1);
  };
  std::map<std::string, int> sizes{
      {"char", 1}, {"short", 2}, {"int", 4}, {"float", 4}, {"void", 0}};
  QByteArray structures;
  for (const BlendStructure& structure : blendStructures()) {
    putNumber(structures, numberIn(types, structure.name));
    putNumber(structures, std::int16_t(structure.fields.size()));
    int& size = sizes[structure.name];
    for (const auto& [type, name] : structure.fields) {
      putNumber(structures, numberIn(types, type));
      putNumber(structures, numberIn(names, name));
      const std::string text = name;
      const int times = text.ends_with("[66]")     ? 66
                        : text.ends_with("[4][4]") ? 16
                        : text.ends_with("[3]")    ? 3
                                                   : 1;
      size += text.starts_with("*") ? 8 : times * sizes[type];
    }
  }
  const auto listed = [](const char* mark, const std::vector<std::string>& texts) {
    QByteArray bytes = mark;
    putNumber(bytes, std::int32_t(texts.size()));
    for (const std::string& text : texts)
      bytes.append(text.c_str(), qsizetype(text.size()) + 1);
    return bytes;
  };
  const auto padded = [](QByteArray bytes) {
    return bytes.append((4 - bytes.size() % 4) % 4, '\0');
  };
  QByteArray lengths = "TLEN";
  for (const std::string& type : types)
    putNumber(lengths, std::int16_t(sizes[type]));
  QByteArray table = padded("SDNA" + listed("NAME", names));
  table = padded(table + listed("TYPE", types));
  table = padded(table + lengths) + "STRC";
  putNumber(table, std::int32_t(blendStructures().size()));
  return table + structures;
}

class BlendWriter {
 public:
  /// Appends structures of one kind, which others refer to by `address`.
  void block(const char* structure, Address address, int count, const QByteArray& bytes) {
    int index = 0;
    while (QByteArray(blendStructures()[std::size_t(index)].name) != structure)
      ++index;
    block(QByteArray("DATA"), address, index, count, bytes);
  }

  QByteArray file() {
    // The reader looks for places that are whole multiples of four.
    m_bytes += QByteArray((4 - (m_bytes.size() + 24) % 4) % 4, '\0');
    block("DNA1", 1, 0, 1, blendTable());
    return m_bytes + QByteArray("ENDB").leftJustified(24, '\0');
  }

 private:
  void block(const QByteArray& code, Address address, int index, int count, QByteArray bytes) {
    bytes.append((4 - bytes.size() % 4) % 4, '\0');
    m_bytes += code;
    putNumber(m_bytes, std::int32_t(bytes.size()));
    putNumber(m_bytes, address);
    putNumber(m_bytes, std::int32_t(index));
    putNumber(m_bytes, std::int32_t(count));
    m_bytes += bytes;
  }

  QByteArray m_bytes = "BLENDER-v279";
};

QByteArray addresses(std::initializer_list<Address> list) {
  QByteArray bytes;
  for (const Address address : list)
    putNumber(bytes, address);
  return bytes;
}

/// Returns an object at x, mirrored if `scale` is −1; `mesh` is 0 for an empty one.
QByteArray blendObject(const char* name, float x, float scale, Address parent, Address mesh) {
  QByteArray bytes = blendId(name);
  putNumber(bytes, std::int16_t(mesh == 0 ? 0 : 1));
  for (const float value :
       {scale, 0.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 0.f, 1.f, 0.f, x, 0.f, 0.f, 1.f})
    putNumber(bytes, value);
  return bytes + addresses({parent, mesh, 0, 0});
}

}  // namespace

QByteArray blend() {
  constexpr Address scene = 0x100, group = 0x200, left = 0x300, right = 0x400, mesh = 0x500;
  constexpr Address bases = 0x600, vertices = 0x700, loops = 0x800, faces = 0x900;
  constexpr Address paints = 0xa00, paint = 0xb00;
  BlendWriter file;
  file.block("Scene", scene, 1, blendId("SCScene") + addresses({bases, bases + 2}));
  file.block("Base", bases, 1, addresses({bases + 1, 0, group}));
  file.block("Base", bases + 1, 1, addresses({bases + 2, bases, left}));
  file.block("Base", bases + 2, 1, addresses({0, bases + 1, right}));
  file.block("Object", group, 1, blendObject("OBAbdomen", 0.f, 1.f, 0, 0));
  file.block("Object", left, 1, blendObject("OBleft kidney", 10.f, 1.f, group, mesh));
  file.block("Object", right, 1, blendObject("OBright kidney", -10.f, -1.f, group, mesh));
  QByteArray points;
  for (const glm::vec3& p : kidneyPositions()) {
    for (const float value : {p.x, p.y, p.z})
      putNumber(points, value);
    points += QByteArray(6, '\0');
  }
  QByteArray corners;
  QByteArray polygons;
  for (const model::Triangle& t : kidneyTriangles()) {
    putNumber(polygons, std::int32_t(corners.size() / 8));
    putNumber(polygons, std::int32_t(3));
    putNumber(polygons, std::int16_t(0));
    for (const std::uint32_t v : t) {
      putNumber(corners, std::int32_t(v));
      putNumber(corners, std::int32_t(0));
    }
  }
  QByteArray shape = blendId("MEkidney");
  for (const int count : {0, 0, 4, 12, 4})
    putNumber(shape, std::int32_t(count));
  file.block("Mesh", mesh, 1, shape + addresses({0, vertices, loops, faces, paints}));
  file.block("MVert", vertices, 4, points);
  file.block("MLoop", loops, 12, corners);
  file.block("MPoly", faces, 4, polygons);
  file.block("ID", paints, 1, addresses({paint}));
  QByteArray red = blendId("MAred");
  for (const float value : {1.0f, 0.5f, 0.25f, 1.0f})
    putNumber(red, value);
  file.block("Material", paint, 1, red);
  return file.file();
}

}  // namespace sline::test
