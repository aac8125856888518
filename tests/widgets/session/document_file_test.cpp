// SPDX-License-Identifier: Apache-2.0
// Tests the document and its file: what is saved, what differs, who may write.
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "tests/model/scene_file/limit_cases.h"
#include "tests/model/scene_file/sample_scene.h"
#include "tests/support/suite.h"
#include "tests/widgets/session/documents.h"
#include "widgets/session/recent_files.h"

namespace sline::widgets {

class DocumentFileTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

  fs::path file(const char* name) const {
    return m_folder.filePath(QLatin1String(name)).toStdString();
  }

 private slots:
  void savedAndOpenedAgain() {
    const fs::path path = file("balls.sline");
    Session session;
    QVERIFY(openMade(session));
    QVERIFY(!session.modified() && session.file().path.empty());
    QVERIFY(gamma(session, 4.0f));
    QVERIFY(session.modified());
    QVERIFY(save(session, path));
    QVERIFY(!session.modified());
    QCOMPARE(session.title(), QStringLiteral("balls.sline"));
    QVERIFY(model::FileLock::held(path));
    Session again;
    QVERIFY(open(again, path));
    QVERIFY(same(again.scene(), session.scene()));
    QVERIFY(!again.modified());
  }

  void differsByValue() {
    Session session;
    QVERIFY(openMade(session));
    QVERIFY(save(session, file("value.sline")));
    QSignalSpy marks(&session, &Session::fileChanged);
    QVERIFY(gamma(session, 3.0f));
    QVERIFY(session.modified());
    session.undo();
    QVERIFY(!session.modified());
    session.redo();
    QVERIFY(session.modified());
    QCOMPARE(marks.count(), 3);
    // Keys in a row become one step, which may end where it began.
    session.undo();
    const QString series = QStringLiteral("keys");
    QVERIFY(gamma(session, 3.0f, series) && gamma(session, 3.5f, series));
    QVERIFY(session.modified());
    session.undo();
    QVERIFY(!session.modified());
    session.preview(balls());
    QVERIFY(session.modified());
    session.cancelPreview();
    QVERIFY(!session.modified());
    // The user returns by hand to the saved state: no step back, yet nothing to save.
    const model::Scene saved = session.scene();
    QVERIFY(gamma(session, 1.0f));
    QVERIFY(session.apply(QStringLiteral("back"), {saved, true}));
    QVERIFY(!session.modified());
  }

  /// Undo takes the scene back, not the name.
  void undoKeepsTheName() {
    Session session;
    QVERIFY(openMade(session));
    QVERIFY(gamma(session, 4.0f));
    QVERIFY(save(session, file("named.sline")));
    session.undo();
    QCOMPARE(session.title(), QStringLiteral("named.sline"));
    QVERIFY(session.modified());
    QVERIFY(save(session, file("other.sline")));
    QCOMPARE(session.title(), QStringLiteral("other.sline"));
    QVERIFY(!model::FileLock::held(file("named.sline")));
    QVERIFY(model::FileLock::held(file("other.sline")));
    session.redo();
    QVERIFY(session.modified());
    QVERIFY(save(session, file("copy.sline"), SceneSaver::As::copy));
    QCOMPARE(session.title(), QStringLiteral("other.sline"));
    QVERIFY(session.modified());
    QVERIFY(!model::FileLock::held(file("copy.sline")));
    QVERIFY(same(onDisk(file("copy.sline")), session.scene()));
  }

  void lockGoesWithTheDocument() {
    const fs::path a = file("a.sline");
    const fs::path b = file("b.sline");
    for (const fs::path& path : {a, b})
      QVERIFY(model::writeSceneFile(path, {.scene = balls()}).ok());
    Session session;
    QVERIFY(open(session, a));
    QVERIFY(model::FileLock::held(a));
    QVERIFY(open(session, b));
    QVERIFY(!model::FileLock::held(a) && model::FileLock::held(b));
    session.undo();
    QVERIFY(model::FileLock::held(a) && !model::FileLock::held(b));
    QCOMPARE(session.title(), QStringLiteral("a.sline"));
    QVERIFY(open(session, a));  // opened again: the lock is its own
    QVERIFY(session.file().writable == Writable::yes);
    session.closeDocument();
    QVERIFY(!model::FileLock::held(a));
    QCOMPARE(session.document().opening, 0);
    session.undo();
    QVERIFY(model::FileLock::held(a));
    QVERIFY(session.file().writable == Writable::yes);
    session.redo();
    // Meanwhile another program writes the file: the scene that undo brings back must not overwrite
    // that.
    model::Scene other = balls();
    other.append({.name = "three", .mesh = test::sphere(3, 1)});
    QVERIFY(model::writeSceneFile(a, {.scene = other}).ok());
    session.undo();
    QVERIFY(session.file().writable == Writable::changedOnDisk);
    session.revert();
    QVERIFY(idle(session));
    QVERIFY(session.file().writable == Writable::yes && !session.modified());
    QCOMPARE(session.scene().nodes().size(), std::size_t(3));
    session.undo();
    QCOMPARE(session.scene().nodes().size(), std::size_t(2));
    QVERIFY(session.modified());
  }

  /// Undo across openings asks the system for a file that nobody has touched, and reads no other.
  void whatNobodyTouchedIsNotRead() {
    const fs::path path = file("untouched.sline");
    Session session;
    QVERIFY(openMade(session));
    QVERIFY(save(session, path));
    DocumentFile saved = session.file();
    QVERIFY(saved.state && saved.state == model::fileState(path));
    saved.lock.reset();
    session.closeDocument();
    // A stamp that no file has tells whether the file is read.
    saved.stamp = model::Fingerprint{.bytes = 1, .crc = 1};
    DocumentFile untouched = saved;
    relock(untouched);
    QVERIFY(untouched.writable == Writable::yes && untouched.lock);
    untouched.lock.reset();
    happen(Meanwhile::replacedByOneAsLarge, path);
    DocumentFile changed = saved;
    relock(changed);
    QVERIFY(changed.writable == Writable::changedOnDisk && !changed.lock);
    fs::remove(path);
    QVERIFY(!model::fileState(path) && !model::fileState(path.parent_path()));
  }

  void readOnly_data() {
    QTest::addColumn<int>("why");
    QTest::newRow("open in another window") << int(Writable::lockedElsewhere);
    QTest::newRow("no right to write") << int(Writable::notPermitted);
    QTest::newRow("of a newer program") << int(Writable::newerProgram);
    QTest::newRow("at fault") << int(Writable::newerProgram);
  }
  void readOnly() {
    QFETCH(int, why);
    const bool faulty = QLatin1String(QTest::currentDataTag()) == QLatin1String("at fault");
    const fs::path path = file("readonly.sline");
    fs::remove(path);
    Session other;
    if (why == int(Writable::newerProgram)) {
      const std::string json =
          faulty ? R"({"format":"sline scene","schema":1,"nodes":[{"id":1,"name":"Liver",
                     "style":{"gamma":7}}]})"
                 : R"({"format":"sline scene","schema":99,"nodes":[],"more":1})";
      const model::ZipMember member{"scene.json", json};
      std::ofstream(path, std::ios::binary) << *model::zipped({&member});
    } else {
      QVERIFY(model::writeSceneFile(path, {.scene = balls()}).ok());
    }
    if (why == int(Writable::notPermitted))
      fs::permissions(path, fs::perms::owner_read);
    if (why == int(Writable::lockedElsewhere))
      QVERIFY(open(other, path));
    Session session;
    QSignalSpy failures(&session, &Session::failed);
    QVERIFY(open(session, path));
    QCOMPARE(failures.count(), 0);
    QCOMPARE(int(session.file().writable), why);
    QVERIFY(!session.file().reason.isEmpty());
    QVERIFY(!session.file().lock);
    if (faulty)
      QVERIFY2(
          session.file().reason.contains("Liver") && session.file().reason.contains("from 0 to 5"),
          qPrintable(session.file().reason));
    if (why == int(Writable::newerProgram))
      QVERIFY(!save(session, path));  // not even where it is asked for
    QVERIFY(save(session, file("elsewhere.sline")));
    QVERIFY(session.file().writable == Writable::yes && session.file().reason.isEmpty());
  }

  /// Each value that a scene file refuses is refused as an edit, with a message; each other one is
  /// kept, saved and opened.
  void editsBeyondLimitsAreRefused() {
    int kept = 0;
    int refused = 0;
    const fs::path path = file("limits.sline");
    for (const test::LimitCase& each : test::limitCases()) {
      if (each.slow)
        continue;
#ifndef NDEBUG
      if (each.asserted)
        continue;
#endif
      Session session;
      session.openMade(
          QStringLiteral("sample"),
          [](const model::ImportProgress&, const std::stop_token&) -> Result<LoadedDocument> {
            return LoadedDocument{.scene = test::sampleScene(), .title = "sample", .remarks = {}};
          });
      QVERIFY(idle(session));
      const model::Scene before = session.scene();
      model::Scene edited = before;
      each.put(edited);
      QSignalSpy failures(&session, &Session::failed);
      const bool changed = !(edited == before);
      const bool applied = session.apply("edit", {edited, changed});
      const std::string name = each.field + " = " + each.value;
      QVERIFY2(applied == (each.within && changed), name.c_str());
      QVERIFY2(failures.count() == (each.within ? 0 : 1), name.c_str());
      QVERIFY2(each.within || session.scene() == before, name.c_str());
      // The same as a drag.
      session.preview(edited);
      session.commitPreview("drag");
      QVERIFY2(failures.count() == (each.within ? 0 : 2), name.c_str());
      QVERIFY2(each.within || session.scene() == before, name.c_str());
      ++(each.within ? kept : refused);
      if (!each.within)
        continue;
      fs::remove(path);
      QVERIFY2(save(session, path), name.c_str());
      const auto opened = model::readSceneFile(path);
      QVERIFY2(opened.ok() && opened->leftOut.empty(), name.c_str());
      QVERIFY2(test::difference(opened->scene, session.scene()).empty(), name.c_str());
    }
    qInfo("%d scenes kept, %d refused", kept, refused);
    QVERIFY(kept > 150 && refused > 150);
  }

  void failuresLeaveTheOldFile_data() {
    QTest::addColumn<QString>("kind");
    QTest::newRow("the folder has gone") << "gone";
    QTest::newRow("another program has changed it") << "changed";
    QTest::newRow("another one, of its length and time") << "as large";
    QTest::newRow("another window has the new name") << "locked";
    QTest::newRow("no folder") << "proc";
    QTest::newRow("a disk without space") << "full";
  }
  /// A file that is only newer by its time is the same file.
  void aTouchedFileIsSaved() {
    const fs::path path = file("touched.sline");
    QVERIFY(model::writeSceneFile(path, {.scene = balls()}).ok());
    Session session;
    QVERIFY(open(session, path) && gamma(session, 4.0f));
    fs::last_write_time(path, fs::last_write_time(path) + std::chrono::hours(1));
    QVERIFY(save(session, path));
    QVERIFY(same(onDisk(path), session.scene()));
  }

  void failuresLeaveTheOldFile() {
    QFETCH(QString, kind);
    const fs::path folder = file("place");
    fs::create_directory(folder);
    const fs::path path = folder / "work.sline";
    Session session;
    Session other;
    QVERIFY(openMade(session) && save(session, path));
    QVERIFY(gamma(session, 4.5f));
    fs::path to = path;
    if (kind == QLatin1String("gone")) {
      fs::remove_all(folder);
    } else if (kind == QLatin1String("changed")) {
      std::ofstream(path, std::ios::app) << "more";
    } else if (kind == QLatin1String("as large")) {
      happen(Meanwhile::replacedByOneAsLarge, path);
    } else if (kind == QLatin1String("locked")) {
      to = folder / "theirs.sline";
      QVERIFY(openMade(other) && save(other, to));
    } else if (kind == QLatin1String("full")) {
      to = "/dev/full";
    } else {
      to = "/proc/1/none/work.sline";
    }
    const auto before = stampOf(to);
    SceneSaver saver(session);
    QSignalSpy saved(&saver, &SceneSaver::saved);
    QSignalSpy failed(&saver, &SceneSaver::failed);
    saver.save(to, SceneSaver::As::document);
    QTRY_VERIFY(!saver.busy());
    QCOMPARE(saved.count(), 0);
    QCOMPARE(failed.count(), 1);
    const auto error = failed[0][0].value<Error>();
    QVERIFY(!error.reason.empty() && !error.remedy.empty());
    QVERIFY(session.modified());
    QVERIFY(session.file().path == path);
    QVERIFY(stampOf(to) == before);
  }

  void savesInARow() {
    const fs::path path = file("row.sline");
    Session session;
    QVERIFY(openMade(session));
    SceneSaver saver(session);
    QSignalSpy saved(&saver, &SceneSaver::saved);
    QSignalSpy ended(&saver, &SceneSaver::ended);
    for (const float value : {1.5f, 2.5f, 3.5f}) {
      QVERIFY(gamma(session, value));
      saver.save(path, SceneSaver::As::document);
    }
    QVERIFY(gamma(session, 4.5f));  // no file that was saved has this value
    QTRY_COMPARE(saved.count(), 3);
    QCOMPARE(ended.count(), 1);
    QVERIFY(session.modified());
    session.undo();
    QVERIFY(!session.modified());
    QVERIFY(same(onDisk(path), session.scene()));
  }

  void whatIsUnknownStays() {
    const fs::path path = file("more.sline");
    QVERIFY(model::writeSceneFile(
                path, {.scene = balls(), .thumbnail = "picture", .others = {{"notes.txt", "mine"}}})
                .ok());
    Session session;
    QVERIFY(open(session, path) && gamma(session, 4.0f) && save(session, path));
    const auto again = model::readSceneFile(path);
    QVERIFY(again.ok());
    QCOMPARE(again->thumbnail, std::string("picture"));
    QCOMPARE(again->others.size(), std::size_t(1));
    QCOMPARE(again->others[0].bytes, std::string("mine"));
  }

  void pathsAreAbsolute() {
    const fs::path path = file("relative.sline");
    QVERIFY(model::writeSceneFile(path, {.scene = balls()}).ok());
    Session session;
    QVERIFY(open(session, fs::relative(path)));
    QVERIFY(session.file().path.is_absolute() && fs::equivalent(session.file().path, path));
    const fs::path other = file("other.sline");
    QVERIFY(gamma(session, 4.0f) && save(session, fs::relative(other)));
    QVERIFY(session.file().path.is_absolute() && fs::equivalent(session.file().path, other));
  }

  void recentFilesAreOrdered() {
    QSettings settings(m_folder.filePath(QStringLiteral("recent.ini")), QSettings::IniFormat);
    RecentFiles recent(settings);
    QSignalSpy changes(&recent, &RecentFiles::changed);
    for (int i = 0; i < 12; ++i)
      recent.add(QStringLiteral("/a/%1.sline").arg(i));
    recent.add(QStringLiteral("/a/b/../7.sline"));
    QCOMPARE(recent.paths().size(), RecentFiles::most);
    QCOMPARE(recent.paths()[0], QStringLiteral("/a/7.sline"));
    QCOMPARE(recent.paths()[1], QStringLiteral("/a/11.sline"));
    QCOMPARE(recent.paths().count(QStringLiteral("/a/7.sline")), 1);
    recent.add(QStringLiteral("/a/7.sline"));
    QCOMPARE(changes.count(), 13);
    recent.remove(QStringLiteral("/a/7.sline"));
    QVERIFY(!recent.paths().contains(QStringLiteral("/a/7.sline")));
    recent.clear();
    QVERIFY(recent.paths().isEmpty());
  }
};

}  // namespace sline::widgets

SLINE_TEST_WITH_EVENTS(sline::widgets::DocumentFileTest)
#include "document_file_test.moc"
