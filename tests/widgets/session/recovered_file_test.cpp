// SPDX-License-Identifier: Apache-2.0
// Tests what is recovered after a crash: it is unsaved, and writes over no file that it does not
// know.
#include <QTemporaryDir>

#include "tests/support/suite.h"
#include "tests/widgets/session/documents.h"

namespace sline::widgets {

class RecoveredFileTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

  fs::path file(const char* name) const {
    return m_folder.filePath(QLatin1String(name)).toStdString();
  }

 private slots:
  void recoveredIsUnsaved() {
    const fs::path folder = file("left");
    const fs::path path = file("lost.sline");
    model::Scene scene = balls();
    {
      const auto journal = model::Journal::reserve(folder);
      QVERIFY(journal.ok());
      QVERIFY((*journal)
                  ->start({"lost.sline", path}, {},
                          {.scene = std::make_shared<const model::Scene>(scene)})
                  .ok());
      QVERIFY((*journal)->writeMeshes(std::chrono::minutes(1)).ok());
    }
    Session session;
    const auto found = model::recoverableIn(folder);
    QCOMPARE(found.size(), std::size_t(1));
    session.openRecovered(found[0]);
    QVERIFY(idle(session));
    QVERIFY(same(session.scene(), scene));
    QVERIFY(session.modified());
    QVERIFY(session.file().path == path);
    QVERIFY(save(session, path));
    QVERIFY(!session.modified());
    QVERIFY(same(onDisk(path), scene));
  }

  /// What a journal cannot bring back may still be in the file, which is not written over.
  void recoveredInPart() {
    const fs::path folder = file("partly");
    const fs::path path = file("partly.sline");
    QVERIFY(model::writeSceneFile(path, {.scene = balls()}).ok());
    model::Scene scene = balls();
    std::vector<model::Node> nodes = scene.nodes();
    nodes[0].name = std::string(1001, 'x');
    scene.setNodes(std::move(nodes));
    {
      const auto journal = model::Journal::reserve(folder);
      QVERIFY(journal.ok());
      QVERIFY((*journal)
                  ->start({"partly.sline", path, stampOf(path)}, {},
                          {.scene = std::make_shared<const model::Scene>(scene)})
                  .ok());
      QVERIFY((*journal)->writeMeshes(std::chrono::minutes(1)).ok());
    }
    Session session;
    session.openRecovered(model::recoverableIn(folder).at(0));
    QVERIFY(idle(session));
    QCOMPARE(session.scene().nodes()[0].name, std::string(1000, 'x'));
    QVERIFY(session.file().writable == Writable::newerProgram);
    QVERIFY2(session.file().reason.contains(QLatin1String("was cut there")),
             qPrintable(session.file().reason));
  }

  void recoveredWhereTheFileMayHaveChanged_data() {
    QTest::addColumn<int>("meanwhile");
    QTest::addColumn<int>("writable");
    const auto row = [](const char* name, Meanwhile meanwhile, Writable writable) {
      QTest::newRow(name) << int(meanwhile) << int(writable);
    };
    row("nothing happened", Meanwhile::nothing, Writable::yes);
    row("touched", Meanwhile::touched, Writable::yes);
    row("another", Meanwhile::replaced, Writable::changedOnDisk);
    row("another, from a backup", Meanwhile::replacedByAnOlder, Writable::changedOnDisk);
    row("another, of its length and time", Meanwhile::replacedByOneAsLarge,
        Writable::changedOnDisk);
    row("gone", Meanwhile::gone, Writable::yes);
    row("gone with its folder", Meanwhile::goneWithItsFolder, Writable::notPermitted);
  }
  void recoveredWhereTheFileMayHaveChanged() {
    QFETCH(int, meanwhile);
    QFETCH(int, writable);
    const QTemporaryDir place;
    const fs::path folder = fs::path(place.path().toStdString()) / "scenes";
    const fs::path journals = fs::path(place.path().toStdString()) / "journals";
    fs::create_directory(folder);
    const fs::path path = folder / "work.sline";
    QVERIFY(model::writeSceneFile(path, {.scene = balls()}).ok());
    leaveJournal(journals, {"work.sline", path, stampOf(path)});
    happen(Meanwhile(meanwhile), path);
    const auto then = stampOf(path);
    Session session;
    session.openRecovered(model::recoverableIn(journals).at(0));
    QVERIFY(idle(session));
    QCOMPARE(int(session.file().writable), writable);
    QVERIFY(session.modified());
    if (writable == int(Writable::yes)) {
      QVERIFY(save(session, path));
      QVERIFY(same(onDisk(path), session.scene()));
      return;
    }
    const QString reason = session.file().reason;
    QCOMPARE(reason.contains(QLatin1String("has changed")),
             writable == int(Writable::changedOnDisk));
    QCOMPARE(reason.contains(QString::fromStdString("no folder " + folder.string())),
             writable == int(Writable::notPermitted));
    // Nor does coming back to it let it be written over.
    QVERIFY(openMade(session));
    session.undo();
    QCOMPARE(int(session.file().writable), writable);
    QCOMPARE(session.file().reason, reason);
    QVERIFY(stampOf(path) == then);
    QVERIFY(save(session, file("elsewhere.sline")));
    QVERIFY(session.file().writable == Writable::yes);
    QVERIFY(stampOf(path) == then);
  }

  /// Journals of older programs do not say what the file held, nor always where it was.
  void whatAnOlderJournalDoesNotSayIsNotGuessed_data() {
    QTest::addColumn<bool>("there");
    QTest::addColumn<bool>("relative");
    QTest::newRow("a file is there") << true << false;
    QTest::newRow("no file is there") << false << false;
    QTest::newRow("a name alone") << true << true;
  }
  void whatAnOlderJournalDoesNotSayIsNotGuessed() {
    QFETCH(bool, there);
    QFETCH(bool, relative);
    const QTemporaryDir place;
    const fs::path journals = place.path().toStdString();
    const fs::path path = file("older.sline");
    fs::remove(path);
    if (there)
      QVERIFY(model::writeSceneFile(path, {.scene = balls()}).ok());
    leaveJournal(journals, {"older.sline", path, {}});
    model::Recoverable found = model::recoverableIn(journals).at(0);
    if (relative)
      found.source.file = fs::relative(path);
    Session session;
    session.openRecovered(found);
    QVERIFY(idle(session));
    QVERIFY(session.modified());
    QCOMPARE(session.title(), QStringLiteral("older.sline"));
    QCOMPARE(session.file().path.empty(), relative);
    QCOMPARE(session.file().writable == Writable::yes, !there || relative);
    if (there && !relative)
      QVERIFY(session.file().reason.contains(QLatin1String("not known")));
  }
};

}  // namespace sline::widgets

SLINE_TEST_WITH_EVENTS(sline::widgets::RecoveredFileTest)
#include "recovered_file_test.moc"
