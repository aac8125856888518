// SPDX-License-Identifier: Apache-2.0
#include "app/cli/files/targets.h"

#include <sys/stat.h>

#include <QTemporaryDir>
#include <QTest>
#include <filesystem>
#include <fstream>

#include "tests/support/suite.h"

namespace sline::cli {

namespace fs = std::filesystem;

/// Tests names of files to be written, in a folder with "scene.sline", "mesh.glb", "front.json",
/// "notes.txt" and, in "meshes", "liver.glb" and "liver.png".
class TargetsTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

  fs::path at(const std::string& name) const {
    return fs::path(m_folder.path().toStdString()) / name;
  }
  /// Returns the error's text for targets "png a.png; pdf b.pdf"; empty if all is well.
  std::string fault(const QString& targets, const std::vector<std::string>& read) const {
    std::map<std::string, std::string> byKind;
    for (const QString& each : targets.split("; ")) {
      const std::string name = each.section(' ', 1).toStdString();
      byKind[each.section(' ', 0, 0).toStdString()] =
          name.empty() || name == "-" || name[0] == '/' ? name : at(name).string();
    }
    std::vector<std::string> files;
    for (const std::string& name : read)
      files.push_back(at(name).string());
    const Status checked = checkTargets(exportTargets(byKind), files);
    return checked.ok() ? std::string() : checked.error().text();
  }

 private slots:
  void initTestCase() {
    fs::create_directories(at("meshes"));
    for (const char* name : {"scene.sline", "mesh.glb", "front.json", "notes.txt",
                             "meshes/liver.glb", "meshes/liver.png"})
      std::ofstream(at(name)) << "x";
    fs::create_symlink(at("scene.sline"), at("link.pdf"));
    fs::create_hard_link(at("scene.sline"), at("same.pdf"));
    fs::create_directory_symlink(at("meshes"), at("linked"));
    QCOMPARE(mkfifo(at("pipe.png").c_str(), 0600), 0);
  }

  void targets_data() {
    QTest::addColumn<QString>("targets");
    QTest::addColumn<QString>(
        "says");  // '|' separates texts that must all be there; empty: it is fine
    const auto row = [](const char* name, const char* targets, const char* says) {
      QTest::newRow(name) << targets << says;
    };
    row("a picture", "png new.png", "");
    row("that is there", "png meshes/liver.png", "");
    row("capitals", "png new.PNG", "");
    row("the other ending", "tiff new.tif; jpeg new.jpeg; anki new.zip", "");
    row("no ending", "png new; frames film; anki deck", "");
    row("an ending of nothing", "svg fig.v2; png fig.part", "");
    row("a device", "pdf /dev/null; svg /dev/null", "");
    row("a pipe, whatever it is called", "pdf pipe.png", "");

    row("the scene", "pdf scene.sline", "scene.sline|--pdf|.pdf");
    row("another scene", "svg new.sline", "new.sline|--svg");
    row("a folder like a scene", "frames new.sline", "--frames");
    row("a link to the scene", "pdf link.pdf", "link.pdf|read");
    row("the scene by another name", "pdf same.pdf", "same.pdf|read");
    row("a mesh that is read", "glb mesh.glb", "mesh.glb|read");
    row("a mesh of the folder", "glb meshes/liver.glb", "folder that is read");
    row("through a linked folder", "glb linked/liver.glb", "folder that is read");
    row("the camera", "svg front.json", ".json");

    row("no name", "png ", "--png names no file");
    row("standard output", "png -", "/dev/stdout");
    row("a film as another", "mp4 new.gif", ".gif|new.mp4");
    row("a mesh as text", "glb new.gltf", ".gltf|new.glb");
    row("a picture as another", "png new.jpg", "new.png");
    row("a picture as a mesh", "png new.stl", "new.png");
    row("cards as text", "anki new.txt", "new.apkg");
    row("frames as a picture", "frames new.png", ".png");
    row("two kinds, one file", "png new; tiff ./new", "--png and --tiff name the same file");
    row("two kinds, one file through a folder", "png meshes/a; tiff linked/a", "the same file");
  }
  void targets() {
    QFETCH(QString, targets);
    QFETCH(QString, says);
    const std::string text = fault(targets, {"scene.sline", "mesh.glb", "front.json", "meshes"});
    QVERIFY2(text.empty() == says.isEmpty(), text.c_str());
    for (const QString& part : says.split('|', Qt::SkipEmptyParts))
      QVERIFY2(QString::fromStdString(text).contains(part), text.c_str());
  }

  void scenesTakeThePlaceOfScenes() {
    const std::vector<std::string> read{at("scene.sline").string(), at("mesh.glb").string()};
    const auto write = [&](const std::string& name) {
      const Target scene{
          .flag = "--output", .name = at(name).string(), .endings = {}, .scene = true};
      return checkTargets({&scene, 1}, read).ok();
    };
    QVERIFY(write("scene.sline"));
    QVERIFY(write("new.sline"));
    fs::create_symlink(at("mesh.glb"), at("mesh.sline"));
    QVERIFY(!write("mesh.sline"));
  }
};

}  // namespace sline::cli

SLINE_TEST(sline::cli::TargetsTest)
#include "targets_test.moc"
