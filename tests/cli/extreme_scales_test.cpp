// SPDX-License-Identifier: Apache-2.0
// Tests that every command ends, in little memory and with a word for it, whatever the scale:
// bodies of a millionth of an atom or of a galaxy, cameras between two floats or beyond all of
// them.
#include <QTemporaryDir>
#include <QTest>
#include <cstring>

#include "model/disk/zip_archive.h"
#include "model/scene_file/scene_file.h"
#include "tests/cli/sline_process.h"
#include "tests/support/process_memory.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {
namespace {

/// The most that a command may take, MiB.
constexpr double mostMemory = 1024.0;

QByteArray boxObj(const char* size) {
  QByteArray text;
  for (int i = 0; i < 8; ++i) {
    text += "v";
    for (int axis = 0; axis < 3; ++axis)
      text += (i >> axis & 1) != 0 ? QByteArray(" ") + size : QByteArray(" 0");
    text += "\n";
  }
  return text + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
}

QByteArray cameraText(const char* projection, const char* eye, const char* height) {
  return QByteArray("{\"projection\":\"") + projection + "\",\"eye_mm\":[" + eye +
         "],\"target_mm\":[0,0,0],\"up\":[0,0,1],\"height_mm\":" + height + "}";
}

}  // namespace

class ExtremeScalesTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  QString path(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }
  /// Runs the commands that draw or write what is in the file, at Γ where most is drawn. All end
  /// with that code.
  void allEnd(const QString& input, int code, const QStringList& more = {}) {
    const QStringList drawn = QStringList{"--size", "160x120"} + more;
    const std::vector<QStringList> commands{
        QStringList{"info", input},
        QStringList{"render", input, "-o", path("p.png"), "--gamma", "3"} + drawn,
        QStringList{"render", input, "-o", path("p.png"), "--gamma", "4.5"} + drawn,
        QStringList{"export", input, "--svg", path("p.svg"), "--gamma", "2.5"} + more,
        QStringList{"export", input, "--glb", path("p.glb")}};
    for (const QStringList& command : commands) {
      const bool looks = command.contains("--gamma");
      const Finished finished = runSline(command);
      QVERIFY2(finished.code == (more.isEmpty() || looks ? code : 0),
               qPrintable(command.join(' ') + '\n' + finished.err));
    }
  }

 private slots:
  void boxes_data() {
    QTest::addColumn<QString>("size");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("word");
    QTest::newRow("of nothing") << "1e-40" << 0 << "";
    QTest::newRow("below any unit") << "1e-30" << 0 << "";
    QTest::newRow("below an atom") << "1e-12" << 0 << "";
    QTest::newRow("1 km") << "1e6" << 0 << "\"box\" is 1 km across: an implausible size";
    QTest::newRow("the largest") << "1e8" << 0 << "\"box\" is 100 km across";
    QTest::newRow("a planet") << "1e9" << 1 << "it lies more than 100 km from the origin";
    QTest::newRow("1e12") << "1e12" << 1 << "it lies more than 100 km from the origin";
    QTest::newRow("1e20") << "1e20" << 1 << "it lies more than 100 km from the origin";
    QTest::newRow("1e30") << "1e30" << 1 << "it lies more than 100 km from the origin";
    QTest::newRow("the last float") << "3.4e38" << 1 << "was left out";
  }
  void boxes() {
    QFETCH(QString, size);
    QFETCH(int, code);
    QFETCH(QString, word);
    writeFile(path("box.obj"), boxObj(size.toLatin1().constData()));
    const Finished imported = runSline({"import", path("box.obj"), "-o", path("box.sline")});
    QVERIFY2(imported.code == code, imported.err.constData());
    QVERIFY2(imported.err.contains(word.toUtf8()), imported.err.constData());
    allEnd(path("box.obj"), code);
    QVERIFY(childrenPeakMiB() < mostMemory);
  }

  /// A stray vertex far away made so many cubes of hatching that no picture came of it.
  void strayVertex_data() {
    QTest::addColumn<float>("away");
    QTest::newRow("10 m") << 1e4f;
    QTest::newRow("10 km") << 1e7f;
    QTest::newRow("100 km") << 1e8f;
  }
  void strayVertex() {
    QFETCH(float, away);
    const model::MeshPtr ball = sphere(40.0f, 4);
    std::vector<glm::vec3> positions(ball->positions().begin(), ball->positions().end());
    positions[7] = {away, 0.5f * away, -0.3f * away};
    auto stray = model::Mesh::create(std::move(positions),
                                     {ball->triangles().begin(), ball->triangles().end()});
    writeObj(path("stray.obj"), *stray);
    allEnd(path("stray.obj"), 0);
    const QString close = path("close.json");
    writeFile(close, cameraText("perspective", "0,-300,0", "200"));
    allEnd(path("stray.obj"), 0, {"--camera", close});
    QVERIFY(childrenPeakMiB() < mostMemory);
  }

  void cameras_data() {
    QTest::addColumn<QByteArray>("camera");
    QTest::addColumn<int>("code");
    const auto row = [](const char* name, const QByteArray& camera, int code) {
      QTest::newRow(name) << camera << code;
    };
    row("orthographic, no height at all", cameraText("orthographic", "0,-100,0", "1e-30"), 2);
    row("orthographic, a cell", cameraText("orthographic", "0,-100,0", "2e-4"), 0);
    row("orthographic, edge on", cameraText("orthographic", "0,-300,0.001", "0.01"), 0);
    row("orthographic, a speck", cameraText("orthographic", "0,-100,0", "9e10"), 0);
    row("the last float", cameraText("perspective", "3.4e38,-3.4e38,0", "200"), 2);
    row("perspective, a speck", cameraText("perspective", "0,-9e10,0", "200"), 0);
    row("perspective, on the surface", cameraText("perspective", "0,-40.0001,0", "200"), 0);
    row("perspective, in the middle", cameraText("perspective", "0,-1e-20,0", "200"), 0);
    row("orthographic, in the middle", cameraText("orthographic", "0,-1e-20,0", "1e-24"), 0);
  }
  void cameras() {
    QFETCH(QByteArray, camera);
    QFETCH(int, code);
    writeObj(path("ball.obj"), *sphere(40.0f, 4));
    writeFile(path("box.obj"), boxObj("50"));
    writeFile(path("camera.json"), camera);
    for (const char* body : {"ball.obj", "box.obj"})
      allEnd(path(body), code, {"--camera", path("camera.json")});
    QVERIFY(childrenPeakMiB() < mostMemory);
  }

  /// Returns the scene's file with another text in place of one in its scene.json, which must be
  /// there.
  static QByteArray withText(const model::SceneDocument& document, const char* before,
                             const char* after) {
    const Result<std::string> bytes = model::sceneFileBytes(document);
    const Result<model::ZipReader> zip = model::ZipReader::open(*bytes);
    std::vector<model::ZipMember> members;
    for (const model::ZipReader::Entry& entry : zip->entries())
      members.push_back({entry.name, *zip->read(entry)});
    std::vector<const model::ZipMember*> all;
    bool found = false;
    for (model::ZipMember& member : members) {
      if (const std::size_t at = member.bytes.find(before);
          member.name == "scene.json" && at != std::string::npos) {
        member.bytes.replace(at, std::strlen(before), after);
        found = true;
      }
      all.push_back(&member);
    }
    if (!found)
      qFatal("%s is not in scene.json", before);
    return QByteArray::fromStdString(*model::zipped(all));
  }

  /// What an earlier program wrote does not hang this one.
  void sceneFiles() {
    model::Node node;
    node.name = "ball";
    node.mesh = sphere(40.0f, 3);
    model::SceneDocument document;
    document.scene.append(node);
    document.scene.setViews({model::View{.name = "lost", .camera = {.eye = {0.0f, -77e5f, 0.0f}}}});
    writeFile(path("lost.sline"), withText(document, "-7700000.0", "-3.4e38"));
    for (const QStringList& command :
         {QStringList{"info", path("lost.sline")},
          QStringList{"render", path("lost.sline"), "-o", path("p.png")},
          QStringList{"import", path("lost.sline"), "-o", path("again.sline")}}) {
      const Finished finished = runSline(command);
      QVERIFY2(finished.code == 0 || finished.code == 1, finished.err.constData());
      QVERIFY2(finished.err.contains("100,000 km"), finished.err.constData());
    }
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::ExtremeScalesTest)
#include "extreme_scales_test.moc"
