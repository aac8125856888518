// SPDX-License-Identifier: Apache-2.0
// Tests scenes of other programs: where things are, which side is left, how long a unit is, and
// what things are called and painted.
#include <QtTest>
#include <algorithm>
#include <assimp/IOStream.hpp>

#include "model/import/foreign/assimp_files.h"
#include "model/import/kinds/file_kinds.h"
#include "model/import/plan/import.h"
#include "tests/model/import/foreign/written_scenes.h"
#include "tests/model/import/readers/mesh_files.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using Positions = std::vector<glm::vec3>;

namespace {

using Turn = glm::vec3 (*)(const glm::vec3&);

glm::vec3 same(const glm::vec3& p) {
  return p;
}

/// Turns COLLADA's X_UP (+x up, −y to the right, +z to the front) into axes with y up.
glm::vec3 fromXUp(const glm::vec3& p) {
  return {-p.y, p.x, p.z};
}

/// Turns axes with right −x, up −z and front −y: half a turn about y from Blender's axes.
glm::vec3 fromUpsideDown(const glm::vec3& p) {
  return {-p.x, p.y, -p.z};
}

Positions sorted(std::span<const glm::vec3> positions) {
  Positions all(positions.begin(), positions.end());
  for (glm::vec3& p : all)
    p = glm::round(p * 1000.0f) / 1000.0f + 0.0f;
  std::sort(all.begin(), all.end(), [](const glm::vec3& a, const glm::vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  });
  return all;
}

Positions expected(std::span<const glm::vec3> corners, Turn turn) {
  Positions all;
  for (const glm::vec3& p : corners)
    all.push_back(turn(p));
  return sorted(all);
}

/// Returns the mesh of that name; VRML has no blanks in names.
const model::RawMesh* named(const model::RawMeshes& read, const char* name) {
  for (const model::RawMesh& mesh : read.meshes)
    if (QString::fromStdString(mesh.name).replace('_', ' ') == name)
      return &mesh;
  return nullptr;
}

/// Holds what a file states about its unit and axes.
struct Said {
  float millimetres = 0.0f;  ///< 0: no unit stated
  bool yUp = false;
  Turn turn = same;
};

void row(const char* tag, const char* extension, const QByteArray& bytes, const Said& said) {
  QTest::newRow(tag) << QString(extension) << bytes << said.millimetres << said.yUp
                     << reinterpret_cast<quintptr>(said.turn);
}

}  // namespace

class WrittenScenesTest : public QObject {
  Q_OBJECT

 private slots:
  void kidneys_data() {
    QTest::addColumn<QString>("extension");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<float>("millimetres");
    QTest::addColumn<bool>("yUp");
    QTest::addColumn<quintptr>("turn");
    const FbxSettings zUp{2.54, {0, 2, 1}, {1, 1, -1}};
    row("FBX text", ".fbx", fbxText(), {10.0f, true});
    row("FBX text, z up, inches", ".fbx", fbxText(zUp), {25.4f, false});
    row("FBX binary", ".fbx", fbxBinary({.unitScaleFactor = 100.0}), {1000.0f, true});
    row("FBX binary, z up", ".fbx", fbxBinary(zUp), {25.4f, false});
    row("FBX upside down", ".fbx", fbxText({1.0, {0, 2, 1}, {-1, -1, -1}}),
        {10.0f, false, fromUpsideDown});
    row("COLLADA", ".dae", collada(), {10.0f, true});
    row("COLLADA, z up, inches", ".dae", collada("0.0254", "Z_UP"), {25.4f, false});
    row("COLLADA, x up", ".dae", collada("0.001", "X_UP"), {1.0f, true, fromXUp});
    row("X3D", ".x3d", x3dXml(), {1.0f, true});
    row("VRML", ".wrl", vrml(), {0.0f, true});
    row("X3D, classic", ".x3dv",
        vrml().replace("#VRML V2.0 utf8",
                       "#X3D V3.3 utf8\nPROFILE Interchange\nUNIT length inch 0.0254"),
        {25.4f, true});
    row("Blender", ".blend", blend(), {0.0f, false});
    row("3DS", ".3ds", threeDs(), {0.0f, false});
    row("COLLADA that tells neither", ".dae", collada("", ""), {1000.0f, true});
  }

  void kidneys() {
    QFETCH(QString, extension);
    QFETCH(QByteArray, bytes);
    QFETCH(float, millimetres);
    QFETCH(bool, yUp);
    QFETCH(quintptr, turn);
    const QTemporaryDir folder;
    const Result<model::RawMeshes> read = readBytes(folder, "scene" + extension, bytes);
    QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
    QCOMPARE(int(read->meshes.size()), 2);
    QVERIFY2(read->warnings.empty(), qPrintable(warningText(*read)));
    for (const auto& [name, corners] :
         {std::pair("left kidney", leftKidney()), std::pair("right kidney", rightKidney())}) {
      const model::RawMesh* mesh = named(*read, name);
      QVERIFY2(mesh, name);
      QCOMPARE(sorted(mesh->positions), expected(corners, reinterpret_cast<Turn>(turn)));
      QCOMPARE(int(mesh->triangles.size()), 4);
      // Six times the volume is positive with normals outward: the mirrored one has turned with it.
      QVERIFY(std::abs(volume(*mesh) - 6.0) < 1e-3);
      if (extension != ".3ds")
        QCOMPARE(mesh->groups, std::vector<std::string>{"Abdomen"});
      const bool light = extension == ".blend";
      QVERIFY(mesh->colour == (light ? Colour{255, 188, 137} : Colour{255, 128, 64}));
      QCOMPARE(mesh->opacity.has_value(), !light);
      QVERIFY(light || std::abs(mesh->opacity->value() - 0.5f) < 1e-3f);
      QCOMPARE(mesh->unitReason.empty(), millimetres == 0.0f);
      if (millimetres > 0.0f)
        QVERIFY(std::abs(mesh->millimetresPerUnit / millimetres - 1.0f) < 1e-6f);
      QCOMPARE(mesh->yUp, yUp);
      QVERIFY(!mesh->frame);
    }
  }

  /// The file tells which way is up, the names which way is left: a scene that faces the other way
  /// is turned about.
  void sidesAreVotedOn() {
    const QTemporaryDir folder;
    for (const bool swapped : {false, true}) {
      QByteArray bytes = collada("0.001", "Y_UP");
      if (swapped) {
        bytes.replace("'left kidney'", "'X kidney'");
        bytes.replace("'right kidney'", "'left kidney'");
        bytes.replace("'X kidney'", "'right kidney'");
      }
      QFile file(folder.filePath("kidneys.dae"));
      QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
      file.close();
      model::ImportOptions options;
      options.smoothing.mode = model::Smoothing::Mode::off;
      const std::filesystem::path inputs[] = {file.fileName().toStdString()};
      const Result<model::Imported> imported = model::importInputs(inputs, options);
      QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
      QVERIFY(imported->report.frame == (swapped ? model::Frame::ras : model::Frame::lps));
      for (const model::NodeId id : imported->scene.structuresBelow(model::rootId)) {
        const model::Node& node = *imported->scene.find(id);
        const model::Box box = node.mesh->bounds();
        QCOMPARE(box.centre().x > 0.0f, node.name.find("left") != std::string::npos);
        QVERIFY2(std::abs(box.size().z - 2.0f) < 1e-3f, "y has become up");
        QVERIFY(std::abs(box.size().y - 3.0f) < 1e-3f);
      }
    }
  }

  void grids() {
    const QTemporaryDir folder;
    const Result<model::RawMeshes> read = readBytes(folder, "grid.vtu", vtuText());
    QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
    QCOMPARE(int(read->meshes.size()), 1);
    const model::RawMesh& mesh = read->meshes[0];
    QCOMPARE(sorted(mesh.positions), expected(leftKidney(), same));
    QVERIFY(std::abs(volume(mesh) - 6.0) < 1e-3);
    QVERIFY(!mesh.frame && !mesh.yUp && mesh.unitReason.empty());
    QVERIFY2(warningText(*read).contains("1 lines or points are left out"),
             qPrintable(warningText(*read)));
  }

  /// A file that a scene refers to is opened in the scene's own folder and nowhere else.
  void othersFilesStayShut() {
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir("in"));
    for (const char* name : {"in/a.dae", "in/b.dae", "c.dae"}) {
      QFile file(folder.filePath(name));
      QVERIFY(file.open(QIODevice::WriteOnly) && file.write("x") == 1);
    }
    QVERIFY(QFile::link(folder.filePath("c.dae"), folder.filePath("in/link.dae")));
    const auto path = [&](const char* name) { return folder.filePath(name).toStdString(); };
    const Result<model::Source> source = model::Source::read(path("in/a.dae"), {});
    QVERIFY(source.ok());
    model::AssimpFiles files(*source);
    for (const std::string& there : {path("in/a.dae"), path("in/b.dae"), std::string("b.dae")}) {
      QVERIFY2(files.Exists(there.c_str()), there.c_str());
      Assimp::IOStream* stream = files.Open(there.c_str(), "rb");
      QVERIFY2(stream && stream->FileSize() == 1, there.c_str());
      files.Close(stream);
      QVERIFY(!files.Open(there.c_str(), "wb"));
    }
    for (const std::string& out : {path("c.dae"), path("in/link.dae"), std::string("../c.dae"),
                                   std::string("/etc/passwd"), std::string("http://a.b/c.dae")}) {
      QVERIFY2(!files.Exists(out.c_str()), out.c_str());
      QVERIFY2(!files.Open(out.c_str(), "rb"), out.c_str());
    }
  }

  void refusals_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("told");
    QTest::newRow("FBX cut") << "a.fbx" << fbxBinary().left(900) << "cannot be read as FBX";
    QTest::newRow("FBX without meshes")
        << "a.fbx" << fbxText().replace("\"Mesh\"", "\"Null\"") << "holds no meshes";
    QTest::newRow("FBX that is none")
        << "a.fbx" << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n") << "looks like OBJ";
    QTest::newRow("COLLADA that is none")
        << "a.dae" << QByteArray("<html></html>") << "cannot be read as COLLADA";
    QTest::newRow("Blender's by zstd")
        << "a.blend" << QByteArray("\x28\xb5\x2f\xfd packed") << "is packed by zstd";
    QTest::newRow("Blender's that is none")
        << "a.blend" << QByteArray("BLENDER-v279") << "cannot be read as a scene of Blender";
    QTest::newRow("VRML 1.0") << "a.wrl" << QByteArray("#VRML V1.0 ascii\n") << "VRML 1.0";
    QTest::newRow("VRML not closed") << "a.wrl" << vrml().left(400) << "line";
    QTest::newRow("VRML's index beyond") << "a.wrl" << vrml().replace("1, 2, 3, -1", "1, 2, 9, -1")
                                         << "refer to vertices that do not exist";
    QTest::newRow("VRML in a circle")
        << "a.wrl"
        << QByteArray("#VRML V2.0 utf8\nDEF a Group { children [ Group { children USE a } ] }")
        << "in a circle";
    QTest::newRow("X3D cut") << "a.x3d" << x3dXml().left(700) << "is not valid XML";
    QTest::newRow("X3D refers to others")
        << "a.x3d" << QByteArray("<X3D><Scene><Inline url='\"b.x3d\"'/></Scene></X3D>")
        << "refers to other files";
    QTest::newRow("3DS cut") << "a.3ds" << threeDs().left(300) << "promises";
    QTest::newRow("3DS that is none") << "a.3ds" << QByteArray("solid a") << "no file of 3D Studio";
    QTest::newRow("VTU cut") << "a.vtu" << vtuText().left(500) << "cannot be read as VTU";
    QTest::newRow("VTU without faces") << "a.vtu"
                                       << vtuText()
                                              .replace("4 6", "2 6")
                                              .replace("10 3", "3 4")
                                              .replace("0 1 2 3 0 1", "0 1 2 3 0 1")
                                       << "only lines or points";
  }

  void refusals() {
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    QFETCH(QString, told);
    const QTemporaryDir folder;
    const Result<model::RawMeshes> read = readBytes(folder, name, bytes);
    QVERIFY(!read.ok());
    QVERIFY2(QString::fromStdString(read.error().text()).contains(told),
             read.error().text().c_str());
    QVERIFY(!read.error().remedy.empty());
  }
};

SLINE_TEST_WITH_EVENTS(WrittenScenesTest)
#include "test_written_scenes.moc"
