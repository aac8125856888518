// SPDX-License-Identifier: Apache-2.0
// Plants names in scenes of other programs.
#include "model/disk/zip_archive.h"
#include "tests/model/import/foreign/written_scenes.h"
#include "tests/model/import/planted/planted_names.h"
#include "tests/model/import/readers/mesh_files.h"

namespace sline::test {

namespace {

/// Puts names in place of those that all written scenes have; lengths stay.
QByteArray withNames(Planting& planting, const QByteArray& scene, const QString& kind,
                     char space = ' ') {
  QByteArray text = scene;
  if (text.contains("Abdomen"))
    text = replaced(text, "Abdomen", planting.name("a group of a " + kind) + 'k');
  const QByteArray left = QByteArray("left") + space;
  return replaced(text, left + "kidney", left + planting.name("a structure of a " + kind));
}

void plantX3d(Planting& planting) {
  planting.writeNamed(
      ".x3d", inserted(withNames(planting, x3dXml(), ".x3d"), "<head>",
                       "<meta name='title' content='" + planting.name("the title of an .x3d") +
                           "'/><meta name='creator' content='" +
                           planting.name("the creator of an .x3d") + "'/>"));
  for (const char* ending : {".wrl", ".x3dv"}) {
    QByteArray text = withNames(planting, vrml(), ending, '_');
    if (ending == QByteArray(".x3dv"))
      text = replaced(text, "#VRML V2.0 utf8", "#X3D V3.0 utf8\nPROFILE Immersive");
    text =
        replaced(text, "# two kidneys", "# " + planting.name("a comment of a " + QString(ending)));
    planting.writeNamed(
        ending,
        replaced(text, "title \"{ [ #\"",
                 "title \"" + planting.name("the title of a " + QString(ending)) + "\" info [ \"" +
                     planting.name("the info of a " + QString(ending)) + "\" ]"));
  }
}

void plantCollada(Planting& planting) {
  const QByteArray by = planting.name("the author of a .dae");
  planting.writeNamed(
      ".dae",
      inserted(withNames(planting, collada(), ".dae"), "<asset>",
               "<contributor><author>" + by + "</author><comments>" +
                   planting.name("a comment of a .dae") + "</comments></contributor><keywords>" +
                   planting.name("a keyword of a .dae") + "</keywords><title>" +
                   planting.name("the title of a .dae") + "</title>"));
}

QByteArray mrmlModel(const QByteArray& id, const QByteArray& name, const QByteArray& file) {
  return "<ModelHierarchy id=\"H" + id + "\" parentNodeRef=\"G\" associatedNodeRef=\"" + id +
         "\"/><Model id=\"" + id + "\" name=\"" + name + "\" storageNodeRef=\"S" + id +
         "\" displayNodeRef=\"D" + id + "\" transformNodeRef=\"T\" description=\"" + name +
         "\"/><ModelStorage id=\"S" + id + "\" fileName=\"" + file + "\"/><ModelDisplay id=\"D" +
         id + "\" color=\"1 0 0\" visibility=\"true\"/>";
}

/// Returns a scene of 3D Slicer whose models lie in `data`; `kind` tells places apart.
QByteArray mrml(Planting& planting, const QString& kind, const QByteArray& data) {
  const auto name = [&](const char* what) { return planting.name(what + (" of " + kind)); };
  const QByteArray camera =
      "<Camera id=\"C\" position=\"0 500 0\" focalPoint=\"1 2 3\" viewUp=\"0 0 1\"/>";
  return "<MRML version=\"Slicer4.4.0\" userTags=\"" + name("a tag") +
         "\"><ModelHierarchy id=\"G\" name=\"" + name("a group") +
         "\" expanded=\"true\"/><LinearTransform id=\"T\" name=\"" + name("a transform") +
         "\" matrixTransformToParent=\"1 0 0 9 0 1 0 0 0 0 1 0 0 0 0 1\"/>" +
         mrmlModel("A", name("a model"), data + ".ply") +
         mrmlModel("B", "liver " + name("a second model"), data + "-2.ply") +
         "<MarkupsFiducial id=\"F\" name=\"" + name("a list of points") +
         "\" storageNodeRef=\"SF\"/><MarkupsFiducialStorage id=\"SF\" fileName=\"" + data +
         ".fcsv\" coordinateSystem=\"0\"/><AnnotationRuler id=\"R\" name=\"" + name("a ruler") +
         "\" ctrlPtsCoord=\"1 2 3|4 5 6\" ctrlPtsSelected=\"0 0\"/>" + camera +
         "<SceneView name=\"" + name("a saved view") + "\" description=\"" +
         name("the description of a saved view") + "\">" + camera + "</SceneView></MRML>";
}

QByteArray table(Planting& planting, const QString& kind) {
  return "# Markups fiducial file version = 4.11\n# CoordinateSystem = RAS\n"
         "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n"
         "1,0,0,0,0,0,0,1,1,1,0," +
         planting.name("a point of " + kind) + "-1," +
         planting.name("the description of a point of " + kind) + ",\n";
}

void plantBundle(Planting& planting) {
  const QByteArray folder = planting.name("a folder of an .mrb");
  const QByteArray data = "Data/" + planting.name("a file of an .mrb");
  const QByteArray scene = mrml(planting, "an .mrb", data);
  std::vector<model::ZipMember> members;
  const auto add = [&](const QByteArray& name, const QByteArray& bytes) {
    members.push_back({(folder + "/" + name).toStdString(), bytes.toStdString()});
  };
  add(planting.name("the scene of an .mrb") + ".mrml", scene);
  add(data + ".ply", cubeFile("ply text"));
  add(data + "-2.ply", cubeFile("ply little endian"));
  add(data + ".fcsv", table(planting, "an .mrb"));
  std::vector<const model::ZipMember*> all;
  for (const model::ZipMember& member : members)
    all.push_back(&member);
  const auto packed = model::zipped(all);
  if (!packed.ok())
    qFatal("%s", packed.error().text().c_str());
  planting.writeInput(planting.name("the name of an .mrb") + ".mrb",
                      QByteArray::fromStdString(*packed));
}

}  // namespace

void plantForeignScenes(Planting& planting) {
  plantX3d(planting);
  plantCollada(planting);
  planting.writeNamed(".3ds", withNames(planting, threeDs(), ".3ds"));
  planting.writeNamed(".fbx", withNames(planting, fbxBinary(), ".fbx"));
  planting.write("text/heart.fbx", withNames(planting, fbxText(), "text .fbx"));
  planting.writeNamed(".blend", withNames(planting, blend(), ".blend"));
  planting.writeNamed(".vtu", replaced(vtuText(), "stress", planting.name("a field of a .vtu")));
}

void plantSlicerScenes(Planting& planting) {
  const QByteArray folder = planting.name("the folder of an .mrml's models");
  const QByteArray data = folder + "/" + planting.name("a model's file of an .mrml");
  planting.writeInput(data + ".ply", cubeFile("ply text"), false);
  planting.writeInput(data + "-2.ply", cubeFile("ply little endian"), false);
  planting.writeInput(data + ".fcsv", table(planting, "an .mrml"), false);
  planting.writeInput(planting.name("the name of an .mrml") + ".mrml",
                      mrml(planting, "an .mrml", data));
  plantBundle(planting);
  planting.writeInput(planting.name("the name of an .fcsv") + ".fcsv", table(planting, "an .fcsv"));
  planting.writeInput(
      planting.name("the name of a .mrk.json") + ".mrk.json",
      "{\"markups\":[{\"type\":\"Fiducial\",\"name\":\"" +
          planting.name("the name in a .mrk.json") +
          "\",\"coordinateSystem\":\"LPS\",\"controlPoints\":[{\"id\":\"1\",\"label\":\"" +
          planting.name("a point of a .mrk.json") + "\",\"description\":\"" +
          planting.name("the description of a point of a .mrk.json") +
          "\",\"position\":[1,2,3]}]}]}");
}

}  // namespace sline::test
