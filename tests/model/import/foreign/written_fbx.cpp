// SPDX-License-Identifier: Apache-2.0
// Writes files of FBX, in text and in binary: both have the same nodes.
#include <cstdint>
#include <cstring>
#include <variant>
#include <vector>

#include "tests/model/import/foreign/scene_numbers.h"
#include "tests/model/import/foreign/written_scenes.h"

namespace sline::test {

namespace {

using FbxValue = std::variant<std::int32_t, std::int64_t, double, QByteArray, std::vector<int>,
                              std::vector<double>>;

/// Describes a node of FBX, from which both flavours are written.
struct FbxNode {
  QByteArray name;
  std::vector<FbxValue> values;
  std::vector<FbxNode> nodes = {};
};

/// Writes values as text.
struct FbxTextWriter {
  QByteArray operator()(std::int32_t v) const { return QByteArray::number(v); }
  QByteArray operator()(std::int64_t v) const { return QByteArray::number(qint64(v)); }
  QByteArray operator()(double v) const { return text(v); }
  /// Writes NAME\0\1CLASS as CLASS::NAME.
  QByteArray operator()(const QByteArray& v) const {
    const qsizetype at = v.indexOf(QByteArray("\0\1", 2));
    return '"' + (at < 0 ? v : v.mid(at + 2) + "::" + v.left(at)) + '"';
  }
  template <class T>
  QByteArray operator()(const std::vector<T>& v) const {
    return '*' + QByteArray::number(qsizetype(v.size())) + " {\n a: " + joined(v, ",") + "\n}";
  }
};

QByteArray asText(const FbxValue& value) {
  return std::visit(FbxTextWriter{}, value);
}

QByteArray asText(const FbxNode& node) {
  QByteArray line = node.name + ": ";
  for (std::size_t i = 0; i < node.values.size(); ++i)
    line += (i == 0 ? "" : ", ") + asText(node.values[i]);
  if (!node.nodes.empty() || node.values.empty()) {
    line += " {\n";
    for (const FbxNode& nested : node.nodes)
      line += asText(nested);
    line += "}";
  }
  return line + '\n';
}

/// Writes values in binary, with a letter for the type before each.
struct FbxByteWriter {
  template <class T>
  static QByteArray scalar(char type, T v) {
    QByteArray bytes(1, type);
    put(bytes, v);
    return bytes;
  }
  /// Writes the length, 0 for not packed, the number of bytes and the data.
  template <class T>
  static QByteArray array(char type, const std::vector<T>& v) {
    QByteArray bytes(1, type);
    put(bytes, std::uint32_t(v.size()));
    put(bytes, std::uint32_t(0));
    put(bytes, std::uint32_t(v.size() * sizeof(T)));
    for (const T each : v)
      put(bytes, each);
    return bytes;
  }
  QByteArray operator()(std::int32_t v) const { return scalar('I', v); }
  QByteArray operator()(std::int64_t v) const { return scalar('L', v); }
  QByteArray operator()(double v) const { return scalar('D', v); }
  QByteArray operator()(const QByteArray& v) const {
    return scalar('S', std::uint32_t(v.size())) + v;
  }
  QByteArray operator()(const std::vector<int>& v) const { return array('i', v); }
  QByteArray operator()(const std::vector<double>& v) const { return array('d', v); }
};

QByteArray asBytes(const FbxValue& value) {
  return std::visit(FbxByteWriter{}, value);
}

/// Writes where the node ends, the number of values, their bytes and the name; then values and
/// nested nodes.
void writeNode(QByteArray& file, const FbxNode& node) {
  const qsizetype begin = file.size();
  QByteArray values;
  for (const FbxValue& value : node.values)
    values += asBytes(value);
  put(file, std::uint32_t(0));
  put(file, std::uint32_t(node.values.size()));
  put(file, std::uint32_t(values.size()));
  put(file, std::uint8_t(node.name.size()));
  file += node.name + values;
  for (const FbxNode& nested : node.nodes)
    writeNode(file, nested);
  if (!node.nodes.empty())
    file += QByteArray(13, '\0');
  const auto end = std::uint32_t(file.size());
  std::memcpy(file.data() + begin, &end, sizeof end);
}

FbxNode property(const char* name, const char* type, std::vector<FbxValue> values) {
  FbxNode node{"P", {QByteArray(name), QByteArray(type), QByteArray(), QByteArray()}};
  node.values.insert(node.values.end(), values.begin(), values.end());
  return node;
}

QByteArray called(const char* name, const char* kind) {
  return name + QByteArray("\0\1", 2) + kind;
}

FbxNode model(std::int64_t id, const char* name, const char* kind, std::vector<FbxNode> placed) {
  return {"Model",
          {id, called(name, "Model"), QByteArray(kind)},
          {{"Version", {std::int32_t(232)}}, {"Properties70", {}, std::move(placed)}}};
}

FbxNode fbxGeometry() {
  return {
      "Geometry",
      {std::int64_t(1), called("", "Geometry"), QByteArray("Mesh")},
      {{"Vertices", {kidneyCoordinates()}},
       {"PolygonVertexIndex", {kidneyCorners([](int last) { return -last - 1; })}},
       {"GeometryVersion", {std::int32_t(124)}},
       {"LayerElementMaterial",
        {std::int32_t(0)},
        {{"Version", {std::int32_t(101)}},
         {"Name", {QByteArray()}},
         {"MappingInformationType", {QByteArray("AllSame")}},
         {"ReferenceInformationType", {QByteArray("IndexToDirect")}},
         {"Materials", {std::vector<int>{0}}}}},
       {"Layer",
        {std::int32_t(0)},
        {{"Version", {std::int32_t(100)}},
         {"LayerElement",
          {},
          {{"Type", {QByteArray("LayerElementMaterial")}}, {"TypedIndex", {std::int32_t(0)}}}}}}}};
}

std::vector<FbxNode> fbxNodes(const FbxSettings& settings) {
  const auto axis = [&](const char* name, std::size_t i) {
    return property(name, "int", {std::int32_t(settings.axes[i])});
  };
  const auto sign = [&](const char* name, std::size_t i) {
    return property(name, "int", {std::int32_t(settings.signs[i])});
  };
  const auto link = [](std::int64_t from, std::int64_t to) {
    return FbxNode{"C", {QByteArray("OO"), from, to}};
  };
  const FbxNode global{"GlobalSettings",
                       {},
                       {{"Version", {std::int32_t(1000)}},
                        {"Properties70",
                         {},
                         {axis("UpAxis", 1), sign("UpAxisSign", 1), axis("FrontAxis", 2),
                          sign("FrontAxisSign", 2), axis("CoordAxis", 0), sign("CoordAxisSign", 0),
                          property("UnitScaleFactor", "double", {settings.unitScaleFactor})}}}};
  const FbxNode material{"Material",
                         {std::int64_t(2), called("red", "Material"), QByteArray()},
                         {{"Version", {std::int32_t(102)}},
                          {"ShadingModel", {QByteArray("lambert")}},
                          {"Properties70",
                           {},
                           {property("DiffuseColor", "Color", {1.0, 0.5, 0.25}),
                            property("Opacity", "double", {0.5})}}}};
  const FbxNode objects{"Objects",
                        {},
                        {fbxGeometry(), material, model(3, "Abdomen", "Null", {}),
                         model(4, "left kidney", "Mesh",
                               {property("Lcl Translation", "Lcl Translation", {10., 0., 0.})}),
                         model(5, "right kidney", "Mesh",
                               {property("Lcl Translation", "Lcl Translation", {-10., 0., 0.}),
                                property("Lcl Scaling", "Lcl Scaling", {-1., 1., 1.})})}};
  return {{"FBXHeaderExtension",
           {},
           {{"FBXHeaderVersion", {std::int32_t(1003)}}, {"FBXVersion", {std::int32_t(7400)}}}},
          global,
          {"Definitions", {}, {{"Version", {std::int32_t(100)}}, {"Count", {std::int32_t(0)}}}},
          objects,
          {"Connections",
           {},
           {link(3, 0), link(4, 3), link(5, 3), link(1, 4), link(2, 4), link(1, 5), link(2, 5)}}};
}

}  // namespace

QByteArray fbxText(const FbxSettings& settings) {
  QByteArray file = "; FBX 7.4.0 project file\n";
  for (const FbxNode& node : fbxNodes(settings))
    file += asText(node);
  return file;
}

QByteArray fbxBinary(const FbxSettings& settings) {
  QByteArray file("Kaydara FBX Binary  \0\x1a\0", 23);
  put(file, std::uint32_t(7400));
  for (const FbxNode& node : fbxNodes(settings))
    writeNode(file, node);
  return file + QByteArray(13, '\0');
}

}  // namespace sline::test
