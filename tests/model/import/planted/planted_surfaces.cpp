// SPDX-License-Identifier: Apache-2.0
// Plants names in files of surfaces.
#include <QFile>

#include "model/disk/zip_archive.h"
#include "tests/model/import/planted/planted_names.h"
#include "tests/model/import/readers/mesh_files.h"
#include "tests/model/import/volumes/written_brain.h"

namespace sline::test {

namespace {

void plantObj(Planting& planting) {
  const QByteArray material = planting.name("the name of an .mtl");
  const QByteArray paint = planting.name("a material of an .obj");
  const QByteArray cube = cubeFile("obj");
  planting.writeNamed(".obj", "# " + planting.name("a comment of an .obj") + "\nmtllib " +
                                  material + ".mtl\no " + planting.name("an object of an .obj") +
                                  "\ng " + planting.name("a group of an .obj") + "\nusemtl " +
                                  paint + "\n" + cube);
  planting.write(
      planting.name("a folder in it") + "/" + planting.name("the folder of a .obj") + "/" +
          material + ".mtl",
      "# " + planting.name("a comment of an .mtl") + "\nnewmtl " + paint + "\nKd 1 0 0\n");
  planting.write("several/objects.obj", cube + "o " + planting.name("the first object of an .obj") +
                                            "\n" + cube.mid(7) + "g " +
                                            planting.name("the second object of an .obj") +
                                            " liver\n" + cube.mid(7));
}

void plantStl(Planting& planting) {
  QByteArray solid = cubeFile("stl text");
  const auto titled = [&solid](const QByteArray& title) {
    return "solid " + title + solid.mid(solid.indexOf('\n'));
  };
  planting.writeNamed(".stl", titled(planting.name("the title of an .stl")));
  planting.write("several/solids.stl", titled(planting.name("the first solid of an .stl")) +
                                           titled(planting.name("the second solid of an .stl")));
  QByteArray binary = cubeFile("stl binary");
  const QByteArray header = planting.name("the header of a binary .stl") + " on 1961-02-03";
  planting.write("binary/femur.stl", binary.replace(0, header.size(), header));
}

void plantPolygons(Planting& planting) {
  planting.writeNamed(
      ".ply", inserted(cubeFile("ply text"), "1.0\n",
                       "comment " + planting.name("a comment of a .ply") + " made it\nobj_info " +
                           planting.name("an obj_info of a .ply") + "\n"));
  planting.writeNamed(".off", inserted(cubeFile("off"), "OFF\n",
                                       "# " + planting.name("a comment of an .off") + "\n"));
  QByteArray legacy = cubeFile("vtk 4.2 text");
  const qsizetype title = legacy.indexOf('\n') + 1;
  legacy.replace(title, legacy.indexOf('\n', title) - title,
                 planting.name("the title of a .vtk") + " of the ward");
  planting.writeNamed(".vtk", legacy + "\nPOINT_DATA 8\nSCALARS " +
                                  planting.name("a field of a .vtk") +
                                  " float 1\nLOOKUP_TABLE default\n0 0 0 0 0 0 0 0\n");
  planting.writeNamed(".vtp", inserted(cubeFile("vtp text"), "?>",
                                       "<!-- " + planting.name("a comment of a .vtp") + " -->"));
}

/// Plants names in the JSON of a glTF cube; `kind` tells places of .gltf and .glb apart.
QByteArray plantedGltf(Planting& planting, QByteArray json, const QString& kind) {
  json =
      inserted(json, "\"asset\":{",
               "\"generator\":\"" + planting.name("the generator of a " + kind) +
                   "\",\"extras\":{\"patient\":\"" + planting.name("extras of a " + kind) + "\"},");
  json =
      replaced(json, "\"name\":\"group\"",
               "\"name\":\"" + planting.name("a group of a " + kind) + "\",\"extras\":{\"who\":\"" +
                   planting.name("extras of a group of a " + kind) + "\"}");
  json = replaced(json, "\"name\":\"cube\"",
                  "\"name\":\"" + planting.name("a node of a " + kind) + "\"");
  return inserted(json, "\"meshes\":[{",
                  "\"name\":\"" + planting.name("a mesh of a " + kind) + "\",");
}

void plantGltf(Planting& planting) {
  planting.writeNamed(".gltf", plantedGltf(planting, cubeFile("gltf"), ".gltf"));
  // A head of 12 bytes, then chunks, each behind its length and kind.
  const QByteArray binary = cubeFile("glb");
  const qsizetype length = qsizetype(std::uint8_t(binary[12])) + 256 * std::uint8_t(binary[13]);
  planting.writeNamed(".glb", glb(plantedGltf(planting, binary.mid(20, length), ".glb"),
                                  binary.mid(20 + length + 8)));
}

void plantThreeMf(Planting& planting) {
  QByteArray text =
      "<?xml version=\"1.0\"?><model unit=\"millimeter\"><metadata name=\"Title\">" +
      planting.name("the title of a .3mf") + "</metadata><metadata name=\"Designer\">" +
      planting.name("the designer of a .3mf") + "</metadata><resources><object id=\"1\" name=\"" +
      planting.name("an object of a .3mf") + "\" partnumber=\"" +
      planting.name("a part number of a .3mf") + "\"><mesh><vertices>";
  for (const glm::vec3& p : cubePositions())
    text += "<vertex x=\"" + QByteArray::number(double(p.x)) + "\" y=\"" +
            QByteArray::number(double(p.y)) + "\" z=\"" + QByteArray::number(double(p.z)) + "\"/>";
  text += "</vertices><triangles>";
  for (const model::Triangle& t : cubeTriangles())
    text += "<triangle v1=\"" + QByteArray::number(t[0]) + "\" v2=\"" + QByteArray::number(t[1]) +
            "\" v3=\"" + QByteArray::number(t[2]) + "\"/>";
  text += "</triangles></mesh></object></resources><build><item objectid=\"1\"/></build></model>";
  const model::ZipMember relations{
      "_rels/.rels",
      "<Relationships><Relationship Target=\"/3D/3dmodel.model\" "
      "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"};
  const model::ZipMember part{"3D/3dmodel.model", text.toStdString()};
  const model::ZipMember other{
      "Metadata/" + planting.name("a member of a .3mf").toStdString() + ".txt", "nothing"};
  const auto packed = model::zipped({&relations, &part, &other});
  if (!packed.ok())
    qFatal("%s", packed.error().text().c_str());
  planting.writeNamed(".3mf", QByteArray::fromStdString(*packed));
}

void plantBrains(Planting& planting) {
  const QByteArray gifti = giftiCube({.anatomy = "CortexLeft"});
  const qsizetype open = gifti.indexOf("<GIFTI");
  const qsizetype end = gifti.indexOf('>', open) + 1;
  const QByteArray more = "<MetaData><MD><Name>UserName</Name><Value>" +
                          planting.name("metadata of a .gii") +
                          "</Value></MD></MetaData><LabelTable><Label Key=\"0\">" +
                          planting.name("a label of a .gii") + "</Label></LabelTable>";
  planting.writeNamed(".gii", gifti.left(end) + more + gifti.mid(end));
  const QByteArray surface =
      replaced(freeSurferCube(), "created by a test",
               "created by " + planting.name("the creator of a surface of FreeSurfer"));
  for (const char* ending : {".pial", ".white", ".smoothwm", ".orig", ".inflated", ".sphere"})
    planting.writeNamed(ending, surface);
}

/// Molecules are no one's, but their files may lie in someone's folder.
void plantMolecules(Planting& planting) {
  const auto seed = [](const char* name) {
    QFile file(QStringLiteral(SLINE_FUZZ_SEEDS "/") + QLatin1String(name));
    if (!file.open(QIODevice::ReadOnly))
      qFatal("there is no %s", qPrintable(file.fileName()));
    return file.readAll();
  };
  planting.writeNamed(".pdb", seed("pdb/peptide.pdb"));
  planting.writeNamed(".ent", seed("pdb/entry.pdb"));
  planting.writeNamed(".cif", seed("cif/peptide.cif"));
  planting.writeNamed(".mmcif", seed("cif/entry.cif"));
  planting.writeNamed(".json", seed("json/entry.json"));
}

}  // namespace

void plantSurfaces(Planting& planting) {
  plantObj(planting);
  plantStl(planting);
  plantPolygons(planting);
  plantGltf(planting);
  plantThreeMf(planting);
  plantBrains(planting);
  plantMolecules(planting);
}

}  // namespace sline::test
