// SPDX-License-Identifier: Apache-2.0
// Tests that no command writes over what it reads, drops a target or writes two into one file.
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/sline_process.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

/// Runs commands on a test folder. In the arguments, DIR is that folder with scene.sline, mesh.obj,
/// front.json, picture.png, which leads to the scene, and meshes/liver.glb.
class InputsStayTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

  /// Returns all files below the folder with their content, links followed.
  QMap<QString, QByteArray> everything() const {
    QMap<QString, QByteArray> all;
    for (const QString& folder : {QStringLiteral("."), QStringLiteral("meshes")})
      for (const QString& name :
           QDir(m_folder.filePath(folder)).entryList(QDir::AllEntries | QDir::Hidden)) {
        QFile file(m_folder.filePath(folder + "/" + name));
        all[folder + "/" + name] = file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
      }
    return all;
  }

 private slots:
  void initTestCase() {
    writeObj(m_folder.filePath("mesh.obj"), *sphere(10.0f, 2), "heart");
    writeFile(m_folder.filePath("front.json"), frontCamera());
    QVERIFY(QDir(m_folder.path()).mkdir("meshes"));
    const QString mesh = m_folder.filePath("mesh.obj");
    const QString scene = m_folder.filePath("scene.sline");
    QCOMPARE(runSline({"import", mesh, "-o", scene}).code, 0);
    QCOMPARE(runSline({"export", mesh, "--glb", m_folder.filePath("meshes/liver.glb")}).code, 0);
    QVERIFY(QFile::link(scene, m_folder.filePath("picture.png")));
    writeFile(m_folder.filePath("list.csv"), "input,pdf\nscene.sline,scene.sline\n");
    writeFile(
        m_folder.filePath("other.csv"),
        "input,glb\nscene.sline,new.glb\nmesh.obj,meshes/liver.glb\nmeshes/liver.glb,b.glb\n");
    writeFile(m_folder.filePath("itself.json"), R"([{"input":"scene.sline","svg":"itself.json"}])");
  }

  void refused_data() {
    QTest::addColumn<QString>("arguments");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* name, const QString& arguments, const char* says) {
      QTest::newRow(name) << arguments << says;
    };
    const QString exported = "export|DIR/scene.sline|";
    row("scene as PDF", exported + "--pdf|DIR/scene.sline", "scene.sline|--pdf");
    row("scene as SVG", exported + "--svg|DIR/scene.sline", "scene.sline|--svg");
    row("any scene", "export|DIR/mesh.obj|--svg|DIR/scene.sline", "scene.sline");
    row("picture over a link", exported + "--png|DIR/picture.png", "picture.png|scene.sline");
    row("rendered over a link", "render|DIR/scene.sline|-o|DIR/picture.png", "picture.png");
    row("mesh of a folder", "export|DIR/meshes|--glb|DIR/meshes/liver.glb", "liver.glb");
    row("lines over the camera",
        "lines|DIR/mesh.obj|--size|64x64|--camera|DIR/front.json|-o|DIR/front.json", "front.json");
    row("lines over a scene",
        "lines|DIR/mesh.obj|--size|64x64|--camera|DIR/front.json|-o|DIR/scene.sline", "scene");
    row("curvature over the mesh", "curvature|DIR/mesh.obj|-o|DIR/mesh.obj", "mesh.obj");
    row("curvature over a scene", "curvature|DIR/mesh.obj|-o|DIR/scene.sline", "scene.sline");
    row("sheet over a link", "ramp|DIR/scene.sline|--sheet|DIR/picture.png", "picture.png");
    row("a job over its scene", "jobs|DIR/list.csv", "line 2|scene.sline");
    row("a job over another's mesh", "jobs|DIR/other.csv", "line 3|liver.glb");
    row("a job over the list", "jobs|DIR/itself.json", "job 1|itself.json");

    row("two films of a kind", exported + "--gif|DIR/a.gif|--video|DIR/b.gif", "--video|--gif");
    row("one file for two", exported + "--png|DIR/a|--tiff|DIR/./a", "--png|--tiff|same file");
    row("a film as another", exported + "--mp4|DIR/a.gif", "a.mp4");
    row("a picture as a mesh", exported + "--glb|DIR/a.glb|--png|DIR/a.glb", "a.png");
    row("cards in a text", exported + "--anki|DIR/a.txt", "a.apkg");
    row("standard output", exported + "--png|-", "/dev/stdout");
    row("no name", exported + "--png|", "--png names no file");
    row("no film's name", exported + "--svg|DIR/a.svg|--video|", "extension");
  }
  void refused() {
    QFETCH(QString, arguments);
    QFETCH(QString, says);
    const auto before = everything();
    const Finished finished = runSline(arguments.replace("DIR", m_folder.path()).split('|'));
    QCOMPARE(finished.code, 2);
    for (const QString& part : says.split('|'))
      QVERIFY2(finished.err.contains(part.toUtf8()), finished.err.constData());
    QCOMPARE(everything(), before);
  }

  void whatIsNoInputIsWrittenOver() {
    const QString picture = m_folder.filePath("meshes/liver.png");
    for (int i = 0; i < 2; ++i)
      QCOMPARE(
          runSline({"render", m_folder.filePath("meshes"), "-o", picture, "--size", "32x32"}).code,
          0);
    QCOMPARE(readPicture(picture).width, 32);
    QVERIFY(QFile::remove(picture));
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::InputsStayTest)
#include "inputs_stay_test.moc"
