// SPDX-License-Identifier: Apache-2.0
#include "tests/model/import/foreign/written_scenes.h"

#include <QtGlobal>
#include <cstdint>
#include <vector>

#include "tests/model/import/foreign/scene_numbers.h"

namespace sline::test {

namespace {

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
