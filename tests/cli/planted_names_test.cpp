// SPDX-License-Identifier: Apache-2.0
// Tests that no name which stands in a folder's or file's name, in a header, comment, tag or table,
// or in the environment, is in anything that leaves the program: each place against each product.
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QSysInfo>
#include <QTemporaryDir>
#include <QTest>

#include "model/import/kinds/file_kinds.h"
#include "model/scene_file/scene_file.h"
#include "render/export/formats/export_formats.h"
#include "render/export/order/view_orders.h"
#include "tests/cli/sline_process.h"
#include "tests/model/import/planted/planted_names.h"
#include "tests/support/marker_scan.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

QByteArray contents(const QString& file) {
  QFile source(file);
  return source.open(QIODevice::ReadOnly) ? source.readAll() : QByteArray();
}

/// A sub-command of `sline` and what it is given besides the scene; "OUT" stands for the folder of
/// products. Without arguments it makes no product of a scene, for the reason.
struct Command {
  QStringList arguments;
  const char* reason = "";
};

const std::map<QString, Command>& commands() {
  static const std::map<QString, Command> all{
      {"render", {{"-o", "OUT/picture.png"}}},
      {"proof", {{"--json", "--apply", "-o", "OUT/proof.sline"}}},
      {"compare", {{"-o", "OUT/sheet.svg", "--json"}}},
      {"lines", {{"--camera", "CAMERA", "--size", "90x60", "-o", "OUT/lines.json"}}},
      {"info", {{"--json"}}},
      {"pockets", {{"--json"}}},
      {"view", {{"--list", "--json"}}},
      {"annotate", {{"--list"}}},
      {"describe", {{"--view", "anterior"}}},
      {"credit", {{"--json"}}},
      {"ramp", {{}, "measures structures that are named"}},
      {"steadiness", {{}, "measures structures that are named"}},
      {"compose", {{}, "has a figure's file in place of a scene: see figures()"}},
      {"export", {{}, "is walked kind by kind"}},
      {"jobs", {{}, "exports"}},
      {"curvature", {{}, "writes numbers of one mesh"}},
      {"import", {{}, "makes the scene file, and tells of files to who has them"}},
      {"reload", {{}, "tells of files to who has them"}},
      {"demo", {{}, "reads nothing"}}};
  return all;
}

}  // namespace

class PlantedNamesTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_top{QDir::tempPath() + "/planted-XXXXXX"};
  std::unique_ptr<Planting> m_planting;
  QStringList m_names;
  QString m_scene;
  int m_products = 0;

  QString out() const { return m_top.filePath("out"); }

  /// Fails where one of the names is in the bytes, and says from which place it came.
  bool isClean(const QString& product, const QByteArray& bytes) {
    QStringList places;
    for (const QString& name : markersIn(bytes, m_names))
      places << m_planting->places().at(name) + " (" + name + ')';
    if (places.isEmpty())
      return true;
    qWarning("%s: %s", qPrintable(product), qPrintable(places.join(", ")));
    return false;
  }

  /// Looks through everything that was written, and what was printed.
  void verifyProduct(const QString& product, const QByteArray& printed) {
    bool clean = isClean(product + ", printed", printed);
    int files = 0;
    for (QDirIterator each(out(), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
         each.hasNext();) {
      const QString file = each.next();
      const QString name = QDir(out()).relativeFilePath(file);
      ++files;
      clean = isClean(product + ", " + name, name.toUtf8() + '\n' + contents(file)) && clean;
      if (name.endsWith(".pdf"))
        clean = isClean(product + ", text of " + name, textOfPdf(file)) && clean;
    }
    QVERIFY2(files > 0 || !printed.isEmpty(), "there is no product");
    QVERIFY(clean);
    ++m_products;
  }

  void emptyOut() const {
    QDir(out()).removeRecursively();
    QDir().mkpath(out());
  }

  void plantEnvironment() {
    for (const char* variable : {"USER", "LOGNAME", "USERNAME", "HOSTNAME", "REALNAME", "EMAIL"})
      qputenv(variable, m_planting->name(QStringLiteral("the variable ") + variable));
    const QString home = m_top.filePath(m_planting->name("the home folder"));
    QDir().mkpath(home);
    qputenv("HOME", QFile::encodeName(home));
  }

  /// Labels all that has a surface and saves a view, as a person would.
  void dress() {
    const auto read = model::readSceneFile(m_scene.toStdString());
    QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
    QStringList arguments{"annotate", m_scene};
    for (const model::NodeId id : read->scene.structuresBelow(model::rootId))
      arguments << "--on" << QString::fromStdString(read->scene.find(id)->name);
    const Finished labelled = runSline(arguments);
    QVERIFY2(labelled.code == 0, labelled.err);
    const Finished viewed = runSline({"view", m_scene, "--add", "front"});
    QVERIFY2(viewed.code == 0, viewed.err);
  }

 private slots:
  void initTestCase() {
    m_planting = std::make_unique<Planting>(m_top.path());
    plantEnvironment();
    m_scene = m_top.filePath(m_planting->name("the name of the scene file") + ".sline");
    m_names = m_planting->names();
    const Finished made = runSline(QStringList{"import"} + m_planting->inputs() +
                                   QStringList{"-o", m_scene, "--keep-volume", "--sides", "right"});
    QVERIFY2(made.code == 0, made.err);
    dress();
  }

  void cleanupTestCase() {
    qInfo("%d places of names against %d products", int(m_names.size()), m_products);
  }

  /// A new kind of file comes under test by itself, or is missed here.
  void everyKindOfFileIsPlanted() {
    QStringList endings;
    for (QDirIterator each(m_planting->folder(), QDir::Files, QDirIterator::Subdirectories);
         each.hasNext();)
      endings << '.' + QFileInfo(each.next()).suffix();
    for (const model::FileKind& kind : model::fileKinds())
      QVERIFY2(endings.contains(QString::fromUtf8(kind.extension.data(), kind.extension.size())),
               kind.extension.data());
  }

  /// What stands in the scene came from all of the files.
  void everythingWasRead() {
    const auto read = model::readSceneFile(m_scene.toStdString());
    QVERIFY(read.ok());
    std::map<std::string, int> frames;
    for (const model::NodeId id : read->scene.structuresBelow(model::rootId))
      ++frames[read->scene.find(id)->provenance.frameReason];
    qInfo("%d structures, %d annotations, %d views",
          int(read->scene.structuresBelow(model::rootId).size()),
          int(read->scene.annotations().size()), int(read->scene.views().size()));
    QVERIFY(read->scene.structuresBelow(model::rootId).size() > 60);
    QVERIFY(read->scene.views().size() >= 3);
  }

  void sceneFile() {
    emptyOut();
    QVERIFY(QFile::copy(m_scene, out() + "/scene.sline"));
    verifyProduct("scene file", {});
  }

  /// All kinds of files in one run, as one that is new comes under test by itself.
  void exports() {
    emptyOut();
    QStringList flags{"--seconds", "0.5", "--fps", "6", "--film-height", "96"};
    for (const render::ExportFormat& format : render::exportFormats()) {
      const QString extension = QString::fromLatin1(format.extension);
      flags << "--" + QString::fromLatin1(format.id)
            << out() + '/' + QLatin1String(format.id) +
                   (extension.isEmpty() ? "-folder" : '.' + extension);
    }
    const Finished finished = runSline(QStringList{"export", m_scene} + flags);
    QVERIFY2(finished.code == 0, finished.err);
    verifyProduct("all kinds of files", finished.out);
  }

  void otherExports_data() {
    QTest::addColumn<QStringList>("flags");
    for (const char* sheet : {"figure", "teaching", "patient"})
      QTest::addRow("pdf, a sheet %s", sheet)
          << QStringList{"--pdf", out() + "/sheet.pdf", "--sheet", sheet};
    QTest::newRow("page, a quiz alone")
        << QStringList{"--page", out() + "/quiz.html", "--quiz", "only"};
    QTest::newRow("cards as text") << QStringList{"--anki", out() + "/cards.zip"};
  }
  void otherExports() {
    QFETCH(QStringList, flags);
    emptyOut();
    const Finished finished = runSline(QStringList{"export", m_scene} + flags);
    QVERIFY2(finished.code == 0, finished.err);
    verifyProduct(QTest::currentDataTag(), finished.out);
  }

  void subCommands_data() {
    QTest::addColumn<QStringList>("arguments");
    const QString help = QString::fromUtf8(runSline({"--help"}).out);
    static const QRegularExpression line(QStringLiteral("^  ([a-z]+) {2,}"),
                                         QRegularExpression::MultilineOption);
    QString listed = help.mid(help.indexOf("Subcommands:"));
    for (auto each = line.globalMatch(listed); each.hasNext();) {
      const QString name = each.next().captured(1);
      const auto command = commands().find(name);
      if (command == commands().end())
        qFatal("sline %s is not known here", qPrintable(name));
      if (!command->second.arguments.isEmpty())
        QTest::newRow(qPrintable(name)) << QStringList{name} + command->second.arguments;
    }
  }
  void subCommands() {
    QFETCH(QStringList, arguments);
    emptyOut();
    const QString camera = m_top.filePath("camera.json");
    writeFile(camera, frontCamera());
    for (QString& argument : arguments)
      argument.replace("OUT", out()).replace("CAMERA", camera);
    arguments.insert(1, m_scene);
    const Finished finished = runSline(arguments);
    QVERIFY2(finished.code == 0, finished.err);
    verifyProduct(arguments.front(), finished.out);
  }

  /// Figures have panels of scenes that lie beside their file.
  void figures() {
    emptyOut();
    const QString figure = m_top.filePath("figure.json");
    writeFile(figure, "{\"sline_figure\":1,\"panels\":[{\"scene\":\"" +
                          QFileInfo(m_scene).fileName().toUtf8() + "\",\"view\":\"front\"}]}");
    const Finished finished = runSline({"compose", figure, "-o", out() + "/f.svg", "-o",
                                        out() + "/f.pdf", "-o", out() + "/f.png"});
    QVERIFY2(finished.code == 0, finished.err);
    verifyProduct("compose", finished.out);
  }

  /// Whoever wants to keep the names can.
  void byChoice() {
    const QString whole = m_top.filePath("whole.sline");
    const Finished made =
        runSline(QStringList{"import"} + m_planting->inputs() +
                 QStringList{"-o", whole, "--keep-file-names", "--sides", "right"});
    QVERIFY2(made.code == 0, made.err);
    const QStringList kept = markersIn(contents(whole), m_names);
    for (const char* place :
         {"the folder of a .stl", "the name of a .ply", "a group of an .obj", "a model of an .mrml",
          "a label of a table .tsv", "a region of a DICOM structure set", "a saved view of an .mrb",
          "a point of an .fcsv"})
      QVERIFY2(kept.contains(QString::fromLatin1(m_planting->name(place))), place);
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::PlantedNamesTest)
#include "planted_names_test.moc"
