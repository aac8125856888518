// SPDX-License-Identifier: Apache-2.0
// Tests the program itself, operated by keys and killed: what was not saved is there again. Started
// twice, the window that is open takes what the second start names.
#include <signal.h>

#include <QProcess>
#include <QtTest>

#include "model/edit/views.h"
#include "model/scene_file/journal.h"
#include "model/scene_file/scene_file.h"
#include "tests/gui/foreign_window.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace fs = std::filesystem;

class FilesCrashTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

  fs::path journals() const {
    return (m_folder.path() + QStringLiteral("/state/sline/journals")).toStdString();
  }
  /// Starts the program with folders and settings of its own.
  void start(QProcess& program, const QStringList& arguments) const {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"state", "config", "cache"})
      environment.insert(QStringLiteral("XDG_%1_HOME").arg(QString::fromLatin1(name).toUpper()),
                         m_folder.filePath(QString::fromLatin1(name)));
    const QString sockets = m_folder.filePath(QStringLiteral("run"));
    QDir().mkpath(sockets);
    QFile::setPermissions(sockets, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    environment.insert(QStringLiteral("XDG_RUNTIME_DIR"), sockets);
    // The program's driver is unloaded at the end, so a report could not name its leaks
    // (tests/leaks.supp).
    environment.insert(QStringLiteral("ASAN_OPTIONS"), QStringLiteral("detect_leaks=0"));
    const QString settings = m_folder.filePath(QStringLiteral("config/Sline"));
    QDir().mkpath(settings);
    QSettings file(settings + QStringLiteral("/Sline.conf"), QSettings::IniFormat);
    file.setValue(QStringLiteral("start/demoPictures"), false);
    file.sync();
    program.setProcessEnvironment(environment);
    program.start(QStringLiteral(SLINE_WORKSTATION), arguments);
  }
  static constexpr int minute = 60'000;
  static bool soon(const std::function<bool()>& holds) { return QTest::qWaitFor(holds, minute); }
  int journalsThere() const {
    int count = 0;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(journals(), none))
      count += entry.path().extension() == ".journal";
    return count;
  }

  /// Starts the program in a folder with a scene's file, changes that and kills the program.
  bool editedAndKilled(const QString& folder, const QString& path) const {
    QProcess program;
    program.setWorkingDirectory(folder);
    start(program, {path});
    if (!program.waitForStarted())
      return false;
    ForeignWindow window(program.processId());
    const std::string name = QFileInfo(path).fileName().toStdString();
    // The key light belongs to the scene.
    if (!soon([&] { return window.title().starts_with(name); }) || !window.press("k") ||
        !soon([&] { return window.title().starts_with(name + "*"); }) ||
        !soon([&] { return journalsThere() == 1; }))
      return false;
    QTest::qWait(1000);  // what is older than that may not be lost
    return ::kill(pid_t(program.processId()), SIGKILL) == 0 && program.waitForFinished();
  }
  /// Recovers what the start page offers first; returns false unless the title begins like that
  /// then.
  static bool recoveredBy(ForeignWindow& window, const char* title) {
    const auto recovered = [&] { return window.title().starts_with(title); };
    // Before the page has found the journal a key does nothing, then the button has the focus.
    constexpr int patience = 3000;
    for (int i = 0; i < 20 && !recovered(); ++i) {
      window.press("space");
      static_cast<void>(QTest::qWaitFor(recovered, patience));
    }
    return recovered();
  }

 private slots:
  void killedAndRecovered() {
    const QTemporaryDir body;
    writeBody(body.path());
    widgets::Session reader;
    reader.openPaths({body.path().toStdString()});
    QVERIFY(soon([&] { return !reader.busy(); }));
    const QString path = m_folder.filePath(QStringLiteral("body.sline"));
    const fs::path file = path.toStdString();
    QVERIFY(model::writeSceneFile(file, {.scene = reader.scene()}).ok());
    const model::Scene expected =
        model::withKeyLight(reader.scene(), model::KeyLight{.shades = true}).scene;
    const auto bytesOf = [](const model::Scene& scene) {
      return *model::sceneFileBytes({.scene = scene});
    };

    QVERIFY(editedAndKilled(m_folder.path(), path));
    const auto found = model::recoverableIn(journals());
    QCOMPARE(found.size(), std::size_t(1));
    QVERIFY(found[0].source.file == file);
    QVERIFY(bytesOf(model::readSceneFile(file)->scene) == bytesOf(reader.scene()));

    QProcess second;
    start(second, {});
    QVERIFY(second.waitForStarted());
    ForeignWindow again(second.processId());
    QVERIFY(recoveredBy(again, "body.sline*"));
    // The scene is in a journal of its own before the old one goes.
    QVERIFY(soon([&] { return !fs::exists(found[0].journal) && journalsThere() == 1; }));
    QVERIFY(again.press("s", true));
    QVERIFY(soon([&] {
      return again.title().starts_with("body.sline") && !again.title().starts_with("body.sline*");
    }));
    QVERIFY(bytesOf(model::readSceneFile(file)->scene) == bytesOf(expected));
    QVERIFY(soon([&] { return journalsThere() == 0; }));
    QVERIFY(again.press("q", true));
    QVERIFY(second.waitForFinished(minute));
    QCOMPARE(second.exitStatus(), QProcess::NormalExit);
    QCOMPARE(second.exitCode(), 0);
  }

  void recoveredElsewhere_data() {
    QTest::addColumn<bool>("changed");
    QTest::newRow("from another folder, with a file of that name") << false;
    QTest::newRow("after the file has changed") << true;
  }
  /// A name on the command line is one of the folder where the program was started, and a file that
  /// has changed since is not the one that was being edited.
  void recoveredElsewhere() {
    QFETCH(bool, changed);
    const QTemporaryDir place;
    const QTemporaryDir body;
    writeBody(body.path());
    widgets::Session reader;
    reader.openPaths({body.path().toStdString()});
    QVERIFY(soon([&] { return !reader.busy(); }));
    const auto bytesOf = [](const fs::path& file) {
      return *model::sceneFileBytes({.scene = model::readSceneFile(file)->scene});
    };
    const fs::path folders = place.path().toStdString();
    for (const char* name : {"A", "B"}) {
      fs::create_directory(folders / name);
      QVERIFY(
          model::writeSceneFile(folders / name / "scene.sline", {.scene = reader.scene()}).ok());
    }
    const fs::path file = folders / "A" / "scene.sline";
    const std::string before = bytesOf(file);

    QVERIFY(editedAndKilled(place.filePath(QStringLiteral("A")), QStringLiteral("scene.sline")));
    if (changed)
      QVERIFY(model::writeSceneFile(file, {.scene = {}}).ok());

    QProcess second;
    second.setWorkingDirectory(place.filePath(QStringLiteral("B")));
    start(second, {});
    QVERIFY(second.waitForStarted());
    ForeignWindow again(second.processId());
    QVERIFY(recoveredBy(again, "scene.sline"));
    QCOMPARE(again.title().find("read-only") != std::string::npos, changed);
    QVERIFY(again.press("s", true));
    if (changed)
      QTest::qWait(3000);  // for what must not happen
    else
      QVERIFY(soon([&] { return bytesOf(file) != before; }));
    QVERIFY(bytesOf(folders / "B" / "scene.sline") == before);
    if (changed)
      QVERIFY(model::readSceneFile(file)->scene.nodes().empty());
    second.kill();
    QVERIFY(second.waitForFinished());
    for (const model::Recoverable& left : model::recoverableIn(journals()))
      model::forget(left);
  }

  void startedTwice() {
    // A folder's name that may be a person's is no title.
    const std::string name = "pelvis";
    const QDir body(m_folder.filePath(QStringLiteral("pelvis")));
    QVERIFY(body.mkpath(QStringLiteral(".")));
    writeBody(body.path());
    QProcess first;
    start(first, {});
    QVERIFY(first.waitForStarted());
    ForeignWindow window(first.processId());
    const QDir sockets(m_folder.filePath(QStringLiteral("run")));
    QVERIFY(soon([&] {
      return !window.title().empty() &&
             !sockets.entryList({QStringLiteral("sline-*")}, QDir::System).isEmpty();
    }));
    // A path is relative to where the second program was started.
    QProcess second;
    second.setWorkingDirectory(body.path());
    start(second, {QStringLiteral(".")});
    QVERIFY(second.waitForFinished(minute));
    QCOMPARE(second.exitCode(), 0);
    QVERIFY(soon([&] { return window.title().starts_with(name); }));

    // A window of its own is asked for once, or always.
    for (const bool once : {true, false}) {
      if (!once)
        QSettings(m_folder.filePath(QStringLiteral("config/Sline/Sline.conf")),
                  QSettings::IniFormat)
            .setValue(QStringLiteral("files/outside"), QStringLiteral("own"));
      QProcess own;
      start(own, QStringList(body.path()) +
                     (once ? QStringList(QStringLiteral("--new-window")) : QStringList()));
      QVERIFY(own.waitForStarted());
      ForeignWindow another(own.processId());
      QVERIFY(soon([&] { return another.title().starts_with(name); }));
      own.kill();
      QVERIFY(own.waitForFinished());
    }
    first.kill();
    QVERIFY(first.waitForFinished());
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::FilesCrashTest)
#include "files_crash_test.moc"
