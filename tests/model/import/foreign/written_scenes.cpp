// SPDX-License-Identifier: Apache-2.0
#include "tests/model/import/foreign/written_scenes.h"

#include <QtGlobal>
#include <cstdint>
#include <cstring>
#include <string>
#include <variant>
#include <vector>

namespace sline::test {

namespace {

QByteArray text(double value) {
  return QByteArray::number(value, 'g', 9);
}

template <class T>
QByteArray joined(const std::vector<T>& values, const char* between) {
  QByteArray line;
  for (const T& value : values)
    line += (line.isEmpty() ? "" : between) + text(double(value));
  return line;
}

std::vector<double> kidneyCoordinates() {
  std::vector<double> numbers;
  for (const glm::vec3& p : kidneyPositions())
    numbers.insert(numbers.end(), {double(p.x), double(p.y), double(p.z)});
  return numbers;
}

/// Returns the corners face by face; the last one of each face is passed through `last`.
template <class Last>
std::vector<int> kidneyCorners(const Last& last) {
  std::vector<int> corners;
  for (const model::Triangle& t : kidneyTriangles())
    corners.insert(corners.end(), {int(t[0]), int(t[1]), last(int(t[2]))});
  return corners;
}

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

template <class T>
void put(QByteArray& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
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

QByteArray colladaNode(const char* id, const char* name, const char* place) {
  return QByteArray("<node id='") + id + "' name='" + name + "' type='NODE'>" + place +
         "<instance_geometry url='#shape'><bind_material><technique_common>"
         "<instance_material symbol='paint' target='#red'/></technique_common></bind_material>"
         "</instance_geometry></node>";
}

QByteArray chunk(std::uint16_t id, const QByteArray& inside) {
  QByteArray bytes;
  put(bytes, id);
  put(bytes, std::uint32_t(6 + inside.size()));
  return bytes + inside;
}

/// Returns an object of 3D Studio. A mirrored one has its axes mirrored and its faces turned.
QByteArray threeDsObject(const char* name, std::span<const glm::vec3> corners, bool mirrored) {
  QByteArray vertices;
  put(vertices, std::uint16_t(corners.size()));
  for (const glm::vec3& p : corners)
    for (const float value : {p.x, p.y, p.z})
      put(vertices, value);
  QByteArray faces;
  put(faces, std::uint16_t(kidneyTriangles().size()));
  for (const model::Triangle& t : kidneyTriangles())
    for (const std::uint32_t v : {t[0], t[mirrored ? 2 : 1], t[mirrored ? 1 : 2], 0u})
      put(faces, std::uint16_t(v));
  QByteArray painted("red\0", 4);
  for (const int value : {4, 0, 1, 2, 3})
    put(painted, std::uint16_t(value));
  QByteArray axes;
  for (const float value : {mirrored ? -1.f : 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f,
                            mirrored ? -10.f : 10.f, 0.f, 0.f})
    put(axes, value);
  return chunk(0x4000, name + QByteArray(1, '\0') +
                           chunk(0x4100, chunk(0x4110, vertices) +
                                             chunk(0x4120, faces + chunk(0x4130, painted)) +
                                             chunk(0x4160, axes)));
}

QByteArray classicTransform(const char* name, const char* place, const QByteArray& shape) {
  return "DEF " + QByteArray(name) + " Transform { " + place + " children " + shape + " }\n";
}

}  // namespace

std::span<const glm::vec3> kidneyPositions() {
  static constexpr std::array<glm::vec3, 4> corners{
      {{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 2.0f, 0.0f}, {0.0f, 0.0f, 3.0f}}};
  return corners;
}

std::span<const model::Triangle> kidneyTriangles() {
  static constexpr std::array<model::Triangle, 4> faces{
      {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  return faces;
}

std::array<glm::vec3, 4> leftKidney() {
  std::array<glm::vec3, 4> corners{};
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = kidneyPositions()[i] + glm::vec3(10.0f, 0.0f, 0.0f);
  return corners;
}

std::array<glm::vec3, 4> rightKidney() {
  std::array<glm::vec3, 4> corners = leftKidney();
  for (glm::vec3& p : corners)
    p.x = -p.x;
  return corners;
}

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

QByteArray collada(const QByteArray& metres, const QByteArray& upAxis) {
  const QByteArray unit = metres.isEmpty() ? "" : "<unit name='u' meter='" + metres + "'/>";
  const QByteArray up = upAxis.isEmpty() ? "" : "<up_axis>" + upAxis + "</up_axis>";
  return "<?xml version='1.0' encoding='utf-8'?>\n"
         "<COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'>\n"
         "<asset><created>2024-01-01T00:00:00</created><modified>2024-01-01T00:00:00</modified>" +
         unit + up +
         "</asset>\n<library_effects><effect id='paint'><profile_COMMON><technique sid='t'>"
         "<lambert><diffuse><color>1 0.5 0.25 1</color></diffuse>"
         "<transparency><float>0.5</float></transparency></lambert></technique>"
         "</profile_COMMON></effect></library_effects>\n"
         "<library_materials><material id='red' name='red'><instance_effect url='#paint'/>"
         "</material></library_materials>\n"
         "<library_geometries><geometry id='shape' name='shape'><mesh><source id='xyz'>"
         "<float_array id='numbers' count='12'>" +
         joined(kidneyCoordinates(), " ") +
         "</float_array><technique_common><accessor count='4' source='#numbers' stride='3'>"
         "<param name='X' type='float'/><param name='Y' type='float'/>"
         "<param name='Z' type='float'/></accessor></technique_common></source>"
         "<vertices id='corners'><input semantic='POSITION' source='#xyz'/></vertices>"
         "<triangles count='4' material='paint'>"
         "<input semantic='VERTEX' source='#corners' offset='0'/><p>" +
         joined(kidneyCorners([](int last) { return last; }), " ") +
         "</p></triangles></mesh></geometry></library_geometries>\n"
         "<library_visual_scenes><visual_scene id='scene' name='scene'>"
         "<node id='n1' name='Abdomen' type='NODE'>" +
         colladaNode("n2", "left kidney", "<translate>10 0 0</translate>") +
         colladaNode("n3", "right kidney", "<translate>-10 0 0</translate><scale>-1 1 1</scale>") +
         "</node></visual_scene></library_visual_scenes>\n"
         "<scene><instance_visual_scene url='#scene'/></scene>\n</COLLADA>\n";
}

QByteArray x3dXml() {
  QByteArray indices = joined(kidneyCorners([](int last) { return last; }), ",");
  for (qsizetype i = 6; i < indices.size(); i += 9)
    indices.insert(i - 1, ",-1");
  return "<?xml version='1.0' encoding='utf-8'?>\n<X3D profile='Interchange' version='3.3'>\n"
         "<head><unit category='length' name='mm' conversionFactor='0.001'/></head>\n"
         "<Scene><NavigationInfo/><Viewpoint position='0 0 9'/>\n<Transform DEF='Abdomen'>\n"
         "<Transform DEF='left kidney' translation='10 0 0'>\n"
         "<Shape><Appearance DEF='red'><Material diffuseColor='1 0.5 0.25' transparency='0.5'/>"
         "</Appearance>\n<IndexedFaceSet DEF='shape' coordIndex='" +
         indices + "'>\n<Coordinate point='" + joined(kidneyCoordinates(), ", ") +
         "'/></IndexedFaceSet></Shape></Transform>\n"
         "<Transform DEF='right kidney' translation='-10 0 0' scale='-1 1 1'>\n"
         "<Shape><Appearance USE='red'/><IndexedFaceSet USE='shape'/></Shape></Transform>\n"
         "</Transform>\n"
         "<Switch whichChoice='-1'><Shape><IndexedFaceSet USE='shape'/></Shape></Switch>\n"
         "</Scene></X3D>\n";
}

QByteArray vrml() {
  QByteArray faces;
  for (const model::Triangle& t : kidneyTriangles())
    faces += joined(std::vector<int>(t.begin(), t.end()), ", ") + ", -1, # a face\n";
  const QByteArray left =
      "Shape { appearance DEF red Appearance { material Material { diffuseColor 1 0.5 0.25\n"
      "transparency 0.5 } }\ngeometry DEF shape IndexedFaceSet { solid FALSE\n"
      "coord Coordinate { point [ " +
      joined(kidneyCoordinates(), ", ") + " ] }\ncoordIndex [ " + faces + " ] } }";
  const QByteArray right =
      "[ Shape { appearance USE red geometry USE shape } WorldInfo { title \"{ [ #\" } ]";
  return "#VRML V2.0 utf8\n# two kidneys\nNavigationInfo { type [ \"EXAMINE\", \"ANY\" ] }\n"
         "DEF Abdomen Group { children [\n" +
         classicTransform("left_kidney", "translation 10 0 0", left) +
         classicTransform("right_kidney", "translation -10 0 0 scale -1 1 1", right) +
         "] }\nROUTE a.b TO c.d\n";
}

QByteArray threeDs() {
  QByteArray colour("\xff\x80\x40");
  QByteArray half;
  put(half, std::int16_t(50));
  const QByteArray material =
      chunk(0xafff, chunk(0xa000, QByteArray("red\0", 4)) + chunk(0xa020, chunk(0x0011, colour)) +
                        chunk(0xa050, chunk(0x0030, half)));
  return chunk(0x4d4d, chunk(0x3d3d, threeDsObject("left kidney", leftKidney(), false) + material +
                                         threeDsObject("right kidney", rightKidney(), true)));
}

QByteArray vtuText() {
  QByteArray points;
  for (const glm::vec3& p : leftKidney())
    points += text(double(p.x)) + ' ' + text(double(p.y)) + ' ' + text(double(p.z)) + '\n';
  const auto array = [](const char* type, const char* name, const QByteArray& values) {
    return QByteArray("<DataArray type='") + type + "' Name='" + name + "' format='ascii'>" +
           values + "</DataArray>\n";
  };
  return "<?xml version='1.0'?>\n<VTKFile type='UnstructuredGrid' version='0.1' "
         "byte_order='LittleEndian'>\n<UnstructuredGrid>\n"
         "<Piece NumberOfPoints='4' NumberOfCells='2'>\n<Points>\n"
         "<DataArray type='Float32' NumberOfComponents='3' format='ascii'>" +
         points + "</DataArray>\n</Points>\n<Cells>\n" +
         array("Int64", "connectivity", "0 1 2 3 0 1") + array("Int64", "offsets", "4 6") +
         array("UInt8", "types", "10 3") + "</Cells>\n<CellData>\n" +
         array("Float32", "stress", "0.5 0.25") +
         "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace sline::test
