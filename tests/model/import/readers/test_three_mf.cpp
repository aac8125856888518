// SPDX-License-Identifier: Apache-2.0
// Tests 3MF: what its packages hold, and packages that lie.
#include <QTest>
#include <array>
#include <glm/geometric.hpp>

#include "model/disk/zip_archive.h"
#include "model/import/plan/import.h"
#include "tests/model/import/readers/mesh_files.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;

namespace {

using Member = std::pair<QByteArray, QByteArray>;

QByteArray package(const std::vector<Member>& files) {
  std::vector<model::ZipMember> members;
  for (const auto& [name, bytes] : files)
    members.push_back({name.toStdString(), bytes.toStdString()});
  std::vector<const model::ZipMember*> all;
  for (const model::ZipMember& member : members)
    all.push_back(&member);
  const auto packed = model::zipped(all);
  return packed.ok() ? QByteArray::fromStdString(*packed) : QByteArray();
}

QByteArray relations(const char* target) {
  return QByteArray("<Relationships><Relationship Target=\"") + target +
         "\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
         "</Relationships>";
}

QByteArray modelPart(const QByteArray& resources, const QByteArray& build,
                     const QByteArray& unit = {}) {
  return "<?xml version=\"1.0\"?><model " + (unit.isEmpty() ? unit : "unit=\"" + unit + '"') +
         " xmlns:m=\"m\" xmlns:p=\"p\"><resources>" + resources + "</resources><build>" + build +
         "</build></model>";
}

/// Returns the cube as an object of that id.
QByteArray cube(const QByteArray& id, const QByteArray& more = {}, const QByteArray& paint = {}) {
  QByteArray text = "<object id=\"" + id + "\" " + more + "><mesh><vertices>";
  for (const glm::vec3& p : cubePositions())
    text += "<vertex x=\"" + QByteArray::number(p.x) + "\" y=\"" + QByteArray::number(p.y) +
            "\" z=\"" + QByteArray::number(p.z) + "\"/>";
  text += "</vertices><triangles>";
  for (const model::Triangle& t : cubeTriangles())
    text += "<triangle v1=\"" + QByteArray::number(t[0]) + "\" v2=\"" + QByteArray::number(t[1]) +
            "\" v3=\"" + QByteArray::number(t[2]) + "\" " + paint + "/>";
  return text + "</triangles></mesh></object>";
}

QByteArray file(const QByteArray& resources, const QByteArray& build, const QByteArray& unit = {}) {
  return package({{"_rels/.rels", relations("/3D/3dmodel.model")},
                  {"3D/3dmodel.model", modelPart(resources, build, unit)}});
}

const QByteArray item = "<item objectid=\"1\"/>";

/// Returns objects of two components each, nested that many levels deep.
QByteArray doubling(int levels) {
  QByteArray text = cube("0");
  for (int i = 1; i <= levels; ++i) {
    const QByteArray below = "<component objectid=\"" + QByteArray::number(i - 1) + "\"/>";
    text += "<object id=\"" + QByteArray::number(i) + "\"><components>" + below + below +
            "</components></object>";
  }
  return text;
}

}  // namespace

class ThreeMfTest : public QObject {
  Q_OBJECT

 private slots:
  void units_data() {
    QTest::addColumn<float>("millimetres");
    QTest::newRow("") << 1.0f;
    QTest::newRow("micron") << 0.001f;
    QTest::newRow("millimeter") << 1.0f;
    QTest::newRow("centimeter") << 10.0f;
    QTest::newRow("inch") << 25.4f;
    QTest::newRow("foot") << 304.8f;
    QTest::newRow("meter") << 1000.0f;
  }

  void units() {
    QFETCH(float, millimetres);
    const QTemporaryDir folder;
    const auto read = readBytes(folder, "a.3mf", file(cube("1"), item, QTest::currentDataTag()));
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QCOMPARE(read->meshes[0].millimetresPerUnit, millimetres);
    QVERIFY(read->meshes[0].unitReason.starts_with("3MF: "));
    QVERIFY(!read->meshes[0].frame && !read->meshes[0].yUp);
  }

  void componentsAndTransforms() {
    const QTemporaryDir folder;
    const QByteArray pair =
        "<object id=\"2\" name=\"Pair\"><components>"
        "<component objectid=\"1\"/>"
        "<component objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 10 0 0\"/></components></object>";
    const auto read =
        readBytes(folder, "a.3mf",
                  file(cube("1", "name=\"Cube\"") + pair + cube("3", "type=\"support\""),
                       "<item objectid=\"2\" transform=\"0 2 0 -2 0 0 0 0 2 100 0 0\"/>"
                       "<item objectid=\"3\"/>"));
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QCOMPARE(read->meshes.size(), std::size_t(2));
    for (const model::RawMesh& mesh : read->meshes) {
      QCOMPARE(mesh.name, std::string("Cube"));
      QCOMPARE(mesh.groups, std::vector<std::string>{"Pair"});
      // The mirrored one, too, has its normals outward.
      QVERIFY(std::abs(volume(mesh) - 6.0 * 8.0) < 1e-3);
    }
    // The component's (10, 0, 0) is turned by the item's quarter turn, doubled and moved.
    glm::vec3 middle(0.0f);
    for (const glm::vec3& p : read->meshes[1].positions)
      middle += p / float(read->meshes[1].positions.size());
    QVERIFY(glm::length(middle - glm::vec3(100, 20, 0)) < 1e-3f);
    QVERIFY(warningText(*read).contains("supports the print"));
  }

  void colours_data() {
    QTest::addColumn<QByteArray>("resources");
    QTest::addColumn<QString>("colour");
    const QByteArray base =
        "<basematerials id=\"5\"><base name=\"a\" displaycolor=\"#112233\"/>"
        "<base name=\"b\" displaycolor=\"#445566FF\"/></basematerials>";
    const QByteArray group = "<m:colorgroup id=\"6\"><m:color color=\"#0000A0FF\"/></m:colorgroup>";
    QTest::newRow("none") << cube("1") << "";
    QTest::newRow("material") << base + cube("1", "pid=\"5\" pindex=\"1\"") << "445566";
    QTest::newRow("first") << base + cube("1", "pid=\"5\"") << "112233";
    QTest::newRow("group") << group + cube("1", "pid=\"6\" pindex=\"0\"") << "0000a0";
    QTest::newRow("triangles") << base + group +
                                      cube("1", "pid=\"5\" pindex=\"0\"", "pid=\"6\" p1=\"0\"")
                               << "0000a0";
    QTest::newRow("triangles of the object's")
        << base + cube("1", "pid=\"5\" pindex=\"0\"", "p1=\"1\"") << "445566";
    QTest::newRow("no such index") << base + cube("1", "pid=\"5\" pindex=\"7\"") << "";
    QTest::newRow("no such group") << cube("1", "pid=\"5\" pindex=\"0\"") << "";
    QTest::newRow("no colour")
        << "<basematerials id=\"5\"><base displaycolor=\"red\"/></basematerials>" +
               cube("1", "pid=\"5\"")
        << "";
  }

  void colours() {
    QFETCH(QByteArray, resources);
    QFETCH(QString, colour);
    const QTemporaryDir folder;
    const auto read = readBytes(folder, "a.3mf", file(resources, item));
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    const auto& found = read->meshes[0].colour;
    QCOMPARE(found ? QString("%1%2%3")
                         .arg(found->red, 2, 16, QChar('0'))
                         .arg(found->green, 2, 16, QChar('0'))
                         .arg(found->blue, 2, 16, QChar('0'))
                   : QString(),
             colour);
  }

  void groupsOfTheFileAreThoseOfTheScene() {
    const QTemporaryDir folder;
    const auto pair = [](const QByteArray& id, const QByteArray& name, const QByteArray& x) {
      return "<object id=\"" + id + "\" name=\"" + name +
             "\"><components><component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 " + x +
             " 0 0\"/><component objectid=\"2\"/></components></object>";
    };
    const QString path = folder.filePath("a.3mf");
    QFile out(path);
    QVERIFY(out.open(QIODevice::WriteOnly));
    out.write(file("<basematerials id=\"5\"><base displaycolor=\"#FF0000\"/></basematerials>" +
                       cube("1", "name=\"plug\" pid=\"5\"") + cube("2", "name=\"socket\"") +
                       pair("3", "Upper", "5") + pair("4", "Lower", "9"),
                   "<item objectid=\"3\"/><item objectid=\"4\"/>"));
    out.close();
    const auto imported = model::importInputs(std::array{std::filesystem::path(path.toStdString())},
                                              {.keepFileNames = true});
    QVERIFY(imported.ok());
    const model::Scene& scene = imported->scene;
    QCOMPARE(scene.nodes().size(), std::size_t(6));
    const model::Node& plug = *scene.find(scene.named("plug").at(0));
    QCOMPARE(scene.groupPath(plug.id), std::string("Upper"));
    QCOMPARE(plug.style.colour, std::optional(Colour{255, 0, 0}));
    QCOMPARE(plug.provenance.part, std::string("plug"));
    QCOMPARE(plug.provenance.unitReason, std::string("3MF: millimeter"));
  }

  void whereTheModelIs() {
    const QTemporaryDir folder;
    const auto elsewhere = readBytes(
        folder, "a.3mf",
        package({{"_rels/.rels", relations("/3D/x.model")},
                 {"3D/x.model", modelPart("", "<item objectid=\"1\" p:path=\"/y.model\"/>")},
                 {"y.model", modelPart(cube("1"), "")}}));
    QVERIFY2(elsewhere, elsewhere ? "" : elsewhere.error().text().c_str());
    QCOMPARE(triangleCount(*elsewhere), std::size_t(12));
    const auto bare =
        readBytes(folder, "a.3mf", package({{"3D/3dmodel.model", modelPart(cube("1"), "")}}));
    QVERIFY(bare && triangleCount(*bare) ==
                        12);  // without a build, every object that is no component counts
  }

  void refused_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("reason");
    const auto row = [](const char* tag, const QByteArray& bytes, const char* reason) {
      QTest::newRow(tag) << bytes << QString(reason);
    };
    row("text", "solid x", "no whole ZIP file");
    row("no model", package({{"a.txt", "x"}}), "there is no part '3D/3dmodel.model'");
    row("broken XML", package({{"3D/3dmodel.model", "<model"}}), "the XML is broken");
    row("another root", package({{"3D/3dmodel.model", "<x/>"}}), "no <model>");
    row("an unknown unit", file(cube("1"), item, "parsec"), "its unit 'parsec'");
    row("empty", file("", ""), "no object with triangles");
    row("no such object", file(cube("2"), item), "object '1': does not exist");
    row("no such part", file(cube("1"), "<item objectid=\"1\" p:path=\"/no.model\"/>"),
        "no part 'no.model'");
    row("a short transform", file(cube("1"), "<item objectid=\"1\" transform=\"1 0 0\"/>"),
        "not twelve numbers");
    row("no number", file(cube("1").replace("x=\"", "x=\"a"), item), "vertex 0");
    row("an index too high", file(cube("1").replace("v1=\"0\"", "v1=\"8\""), item),
        "v1 is no index of its 8 vertices");
    row("a negative index", file(cube("1").replace("v2=\"2\"", "v2=\"-2\""), item), "v2 is no");
    row("a circle",
        file("<object id=\"1\"><components><component objectid=\"1\"/></components></object>",
             item),
        "in a circle");
    row("2 to the 40", file(doubling(40), "<item objectid=\"40\"/>"), "far beyond its own size");
    row("2 to the 100", file(doubling(100), "<item objectid=\"100\"/>"), "levels deep");
    row("a bomb of spaces", package({{"3D/3dmodel.model", QByteArray(80 << 20, ' ')}}), "");
  }

  void refused() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, reason);
    const QTemporaryDir folder;
    const auto read = readBytes(folder, "a.3mf", bytes);
    QVERIFY(!read);
    const QString text = QString::fromStdString(read.error().text());
    QVERIFY2(text.contains(reason) && text.contains("a.3mf"), qPrintable(text));
    QVERIFY(!read.error().remedy.empty() && !text.contains("looks like a ZIP"));
  }

  void mutationsNeverCrash() {
    const QTemporaryDir folder;
    const QByteArray good = file(cube("1", "pid=\"5\""), item);
    QVERIFY(readBytes(folder, "a.3mf", good));
    for (int at = 0; at < good.size(); at += 3) {
      QByteArray bad = good;
      bad[at] = char(bad[at] ^ (1 << at % 8));
      (void)readBytes(folder, "a.3mf", bad);
    }
  }
};

SLINE_TEST(ThreeMfTest)
#include "test_three_mf.moc"
