// SPDX-License-Identifier: Apache-2.0
// Tests that no file made from a scene reveals where the scene came from: not its path, not who
// made it where and when, nothing that DICOM says of a patient, no comment of a mesh.
#include <QDate>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <filesystem>

#include "model/import/plan/import.h"
#include "model/scene_file/scene_file.h"
#include "render/export/formats/export_formats.h"
#include "render/export/order/view_orders.h"
#include "tests/cli/sline_process.h"
#include "tests/model/import/dicom/written_dicom.h"
#include "tests/model/import/dicom/written_structures.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/marker_scan.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

constexpr const char* folderMarker = "qzxpath-Jané-Doe";

QByteArray contents(const QString& file) {
  QFile source(file);
  return source.open(QIODevice::ReadOnly) ? source.readAll() : QByteArray();
}

/// Returns the markers that are planted; none of them is in a structure's, group's or view's name.
QStringList markers() {
  QStringList all{
      QLatin1String(folderMarker),   QStringLiteral("QZXPLY"),    QStringLiteral("QZXOBJ"),
      QStringLiteral("QZXMATERIAL"), QStringLiteral("QZXSTL"),    QStringLiteral("QZXOFF"),
      QStringLiteral("QZXFILE"),     QStringLiteral("QZXUNREAD"), QStringLiteral("QZXMEMBER"),
      QStringLiteral("QZXREASON"),   QStringLiteral("QZXPART"),   QStringLiteral("qzxuser"),
      QStringLiteral("qzxhost"),     QStringLiteral("qzxhome"),   QStringLiteral("QZXHIDDEN"),
      QStringLiteral("QZXTHUMB")};
  for (const QByteArray& identity : identities())
    // Digits alone could occur by chance.
    if (identity.startsWith("QZX"))
      all << QString::fromLatin1(identity);
  const QDate today = QDate::currentDate();
  for (const char* form : {"yyyyMMdd", "yyyy-MM-dd", "yyyy:MM:dd", "yyyy/MM/dd"})
    all << today.toString(QLatin1String(form));
  return all;
}

void plant(QByteArray& text, const char* before, const QByteArray& marker) {
  const qsizetype at = text.indexOf(before);
  if (at < 0)
    qFatal("no place for %s", marker.constData());
  text.insert(at, marker);
}

/// Writes meshes with comments in them and a structure set into the folder; returns the paths of
/// all.
std::vector<std::filesystem::path> writeSources(const QString& folder) {
  const auto path = [&folder](const char* name) { return folder + '/' + name; };
  const auto ball = [](float x) { return moved(*sphere(12.0f, 3), 1.0f, {x, 0.0f, 0.0f}); };
  writeMesh(path("QZXFILE-1.ply"), *ball(-40.0f));
  QByteArray ply = contents(path("QZXFILE-1.ply"));
  plant(ply, "element vertex", "comment QZXPLY by Jane\n");
  writeFile(path("QZXFILE-1.ply"), ply);
  writeObj(path("QZXFILE-2.obj"), *ball(0.0f));
  writeFile(path("QZXFILE-2.obj"),
            "# QZXOBJ\nmtllib QZXMATERIAL.mtl\no QZXPART\n" + contents(path("QZXFILE-2.obj")));
  writeMesh(path("QZXFILE-3.stl"), *ball(40.0f));
  QByteArray stl = contents(path("QZXFILE-3.stl"));
  // The comment goes into the first line of text or into the first 80 bytes.
  stl.startsWith("solid") ? stl.insert(6, "QZXSTL ") : stl.replace(0, 6, "QZXSTL");
  writeFile(path("QZXFILE-3.stl"), stl);
  writeFile(path("QZXFILE-4.dcm"),
            dicomFile(structureSet(
                {{.name = "region", .contours = test::ball({0.0, 30.0, 0.0}, 10.0, -9.0, 3.0)}})));
  return {path("QZXFILE-1.ply").toStdString(), path("QZXFILE-2.obj").toStdString(),
          path("QZXFILE-3.stl").toStdString(), path("QZXFILE-4.dcm").toStdString()};
}

/// Returns the scene with names that say nothing, and with all that a scene file can carry unseen.
model::Scene dressed(model::Scene scene) {
  const std::string unread = R"({"note":"QZXUNREAD"})";
  std::vector<model::Node> nodes = scene.nodes();
  int number = 0;
  for (model::Node& node : nodes) {
    node.name = (node.isGroup() ? "group " : "organ ") + std::to_string(++number);
    node.unread = unread;
    node.provenance.frameReason = "QZXREASON";
    node.provenance.unitReason = "QZXREASON";
    node.provenance.file = "QZXFILE.ply";
    node.provenance.part = "QZXPART";
  }
  // A hidden structure is not to be seen.
  nodes.back().style.visible = false;
  nodes.back().name = "QZXHIDDEN";
  scene.setNodes(nodes);
  scene.setUnread(unread);
  for (const model::NodeId id : scene.structuresBelow(model::rootId)) {
    model::Annotation label;
    label.anchors = {model::SurfacePoint{.structure = id, .triangle = 3}};
    label.found = true;  // where one sees it, so that tests ask for it
    label.text = "a label";
    label.unread = unread;
    scene.appendAnnotation(label);
  }
  model::Section section{.name = "cut"};
  section.plane.normal = {0.0f, 1.0f, 0.0f};
  section.plane.offset = 20.0f;  // it lies behind the labels, which it must not take away
  section.unread = unread;
  scene.appendSection(section);
  model::View view{.name = "front"};
  view.camera.eye = {0.0f, -500.0f, 0.0f};
  view.unread = unread;
  scene.setViews({view});
  return scene;
}

}  // namespace

class ExportPrivacyTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_top{QDir::tempPath() + "/privacy-XXXXXX"};
  QString m_folder = m_top.filePath(QString::fromUtf8(folderMarker));
  QString m_scene = m_folder + "/QZXFILE.sline";

  QString out() const { return m_folder + "/out"; }
  /// The scene as it was imported, with the labels and views that a person adds by a click.
  QString undressed() const { return m_folder + "/plain.sline"; }

  /// Returns what is planted in the names of files and folders and in titles of files.
  static QStringList plantedNames() {
    return {QStringLiteral("QZXFILE"), QStringLiteral("QZXFOLDER"), QStringLiteral("QZXSTL"),
            QStringLiteral("QZXPLY"), QStringLiteral("qzxpath")};
  }

  /// Imports a folder of named files in named folders and makes of it what is exported.
  void writeUndressed() {
    const QString top = m_folder + "/QZXFOLDER_qzxpath_4711";
    QDir().mkpath(top + "/QZXFOLDER_bones");
    const auto ball = [](float x) { return moved(*sphere(12.0f, 3), 1.0f, {x, 0.0f, 0.0f}); };
    writeMesh(top + "/QZXFOLDER_bones/QZXFILE_femur.stl", *ball(-40.0f));
    QByteArray stl = contents(top + "/QZXFOLDER_bones/QZXFILE_femur.stl");
    stl.startsWith("solid") ? stl.insert(6, "QZXSTL ") : stl.replace(0, 6, "QZXSTL");
    writeFile(top + "/QZXFOLDER_bones/QZXFILE_femur.stl", stl);
    writeMesh(top + "/QZXFILE_4711.ply", *ball(0.0f));
    writeMesh(top + "/4711-QZXFILE-liver.off", *ball(40.0f));
    const Finished made = runSline({"import", top, m_folder + "/QZXFILE-1.ply", "-o", undressed()});
    QVERIFY2(made.code == 0, made.err);
    QCOMPARE(runSline({"annotate", undressed(), "--on", "liver", "--on", "femur"}).code, 0);
    QCOMPARE(runSline({"view", undressed(), "--add", "front"}).code, 0);
  }

  /// Exports a scene to an empty folder and returns the resulting files by their places there.
  QStringList exported(const QString& scene, const QString& kind, const QString& extension,
                       const QStringList& view) {
    QDir(out()).removeRecursively();
    QDir().mkpath(out());
    const QString target = out() + "/figure" + (extension.isEmpty() ? "" : "." + extension);
    const Finished finished =
        runSline(QStringList{"export", scene, "--" + kind, target, "--seconds", "0.5", "--fps", "6",
                             "--film-height", "96"} +
                 view);
    if (finished.code != 0)
      qWarning("%s", finished.err.constData());
    QStringList names;
    for (QDirIterator each(out(), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
         each.hasNext();)
      names << QDir(out()).relativeFilePath(each.next());
    names.sort();
    return finished.code == 0 ? names : QStringList();
  }

 private slots:
  void initTestCase() {
    qputenv("USER", "qzxuser");
    qputenv("LOGNAME", "qzxuser");
    qputenv("HOSTNAME", "qzxhost");
    const QString home = m_top.filePath("qzxhome");
    QDir().mkpath(home);
    qputenv("HOME", QFile::encodeName(home));
    QDir().mkpath(m_folder);
    const auto sources = writeSources(m_folder);
    const auto imported = model::importInputs(sources, {});
    QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
    QCOMPARE(imported->scene.structuresBelow(model::rootId).size(), std::size_t(4));
    model::SceneDocument document{.scene = dressed(imported->scene)};
    document.thumbnail = "\x89PNG\r\n\x1a\nQZXTHUMB";
    document.others = {{"notes.txt", "QZXMEMBER"}};
    const Status written = model::writeSceneFile(m_scene.toStdString(), document);
    QVERIFY2(written.ok(), written.ok() ? "" : written.error().text().c_str());
    // The scene file itself is no export: it holds what it was made of, which shows that there is
    // something to give away.
    const QStringList held = markersIn(contents(m_scene), markers());
    for (const char* marker : {"QZXUNREAD", "QZXMEMBER", "QZXREASON", "QZXFILE", "QZXPART"})
      QVERIFY2(held.contains(marker), marker);
    writeUndressed();
  }

  void nothingIsGivenAway_data() {
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("extension");
    QTest::addColumn<QStringList>("flags");
    const QStringList size{"--size-mm", "160x90"};
    for (const render::ExportFormat& format : render::exportFormats()) {
      QTest::newRow(format.id) << format.id << format.extension
                               << size + QStringList{"--view", "front"};
      if (format.has(render::viewsOption))
        QTest::addRow("%s of all views", format.id)
            << format.id << format.extension << size + QStringList{"--views", "all"};
    }
    const QStringList test{"--views", "all", "--sheet", "teaching", "--word-bank", "--key", "end"};
    QTest::newRow("a lesson with tests") << "pdf"
                                         << "pdf" << test;
    QTest::newRow("a quiz alone") << "page"
                                  << "html" << QStringList{"--quiz", "only"};
    QTest::newRow("cards of every kind")
        << "anki"
        << "apkg" << size + QStringList{"--views", "all", "--cover-cards"};
    QTest::newRow("cards as text") << "anki"
                                   << "zip" << size + QStringList{"--views", "all"};
  }
  /// Names of files and folders that become names of what is in them are the way by which they
  /// reach every product; nobody has given names here.
  void namesOfFilesAreNotGivenAway_data() {
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("extension");
    for (const render::ExportFormat& format : render::exportFormats())
      QTest::newRow(format.id) << format.id << format.extension;
  }
  void namesOfFilesAreNotGivenAway() {
    QFETCH(QString, kind);
    QFETCH(QString, extension);
    const QStringList planted = plantedNames();
    QCOMPARE(markersIn(contents(undressed()), planted), QStringList());
    const QStringList names = exported(undressed(), kind, extension, {});
    QVERIFY2(!names.isEmpty(), "it wrote nothing");
    for (const QString& name : names) {
      const QByteArray bytes = contents(out() + '/' + name);
      const QStringList found = markersIn(name.toUtf8() + '\n' + bytes, planted);
      QVERIFY2(found.isEmpty(), qPrintable(name + ": " + found.join(", ")));
      if (name.endsWith(".pdf"))
        QCOMPARE(markersIn(textOfPdf(out() + '/' + name), planted), QStringList());
    }
  }

  /// What commands print of a scene goes into reports and programs.
  void printedOnesNeither() {
    for (const QStringList& command :
         {QStringList{"info", undressed()}, QStringList{"info", undressed(), "--json"},
          QStringList{"describe", undressed()}, QStringList{"annotate", undressed(), "--list"}}) {
      const Finished finished = runSline(command);
      QVERIFY2(finished.code == 0, finished.err);
      const QStringList found = markersIn(finished.out, plantedNames());
      QVERIFY2(found.isEmpty(), qPrintable(command.join(' ') + ": " + found.join(", ")));
    }
  }

  void nothingIsGivenAway() {
    QFETCH(QString, kind);
    QFETCH(QString, extension);
    QFETCH(QStringList, flags);
    const QStringList names = exported(m_scene, kind, extension, flags);
    QVERIFY2(!names.isEmpty(), "it wrote nothing");
    std::map<QString, QByteArray> first;
    for (const QString& name : names) {
      const QByteArray bytes = contents(out() + '/' + name);
      QVERIFY2(!bytes.isEmpty(), qPrintable(name));
      const QStringList found = markersIn(name.toUtf8() + '\n' + bytes, markers());
      QVERIFY2(found.isEmpty(), qPrintable(name + ": " + found.join(", ")));
      if (name.endsWith(".pdf")) {
        const QStringList read = markersIn(textOfPdf(out() + '/' + name), markers());
        QVERIFY2(read.isEmpty(), qPrintable(name + ": " + read.join(", ")));
      }
      first[name] = bytes;
    }
    // The files are the same each time: no date in bytes that are never read, no random number.
    QCOMPARE(exported(m_scene, kind, extension, flags), names);
    for (const QString& name : names)
      QVERIFY2(contents(out() + '/' + name) == first[name], qPrintable(name));
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::ExportPrivacyTest)
#include "export_privacy_test.moc"
