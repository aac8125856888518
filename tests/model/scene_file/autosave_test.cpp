// SPDX-License-Identifier: Apache-2.0
#include "model/scene_file/autosave.h"

#include <unistd.h>

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <csignal>
#include <random>
#include <thread>

#include "model/disk/whole_file.h"
#include "tests/model/scene_file/sample_scene.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {
/// Holds what one worker reported before it was killed.
struct Log {
  long edited = 0;
  long saving = 0;
  long saved = 0;
  long keeping = 0;
  long kept = 0;
};

Log logOf(const QByteArray& said) {
  Log log;
  for (const QByteArray& line : said.split('\n')) {
    const QList<QByteArray> words = line.split(' ');
    if (words.size() != 2)
      continue;
    const long number = words[1].toLong();
    for (const auto& [name, target] :
         {std::pair{"edited", &log.edited}, std::pair{"saving", &log.saving},
          std::pair{"saved", &log.saved}, std::pair{"keeping", &log.keeping},
          std::pair{"kept", &log.kept}})
      if (words[0] == name)
        *target = number;
  }
  return log;
}

/// Returns the file's version, 0 if there is no file, or −1 if it cannot be read.
long versionIn(const fs::path& file) {
  if (!fs::exists(file))
    return 0;
  const auto document = readSceneFile(file);
  return document.ok() ? std::stol(document->scene.nodes()[0].name) : -1;
}

QByteArray killedAfter(const QStringList& arguments, std::chrono::microseconds time) {
  QProcess worker;
  worker.start(SLINE_AUTOSAVE_WORKER, arguments);
  if (!worker.waitForStarted() || !worker.waitForReadyRead())
    return "failed: " + worker.readAllStandardError();
  std::this_thread::sleep_for(time);
  ::kill(pid_t(worker.processId()), SIGKILL);
  worker.waitForFinished();
  const QByteArray complaint = worker.readAllStandardError();
  return complaint.isEmpty() ? worker.readAllStandardOutput() : "failed: " + complaint;
}
}  // namespace

class AutosaveTest : public QObject {
  Q_OBJECT
 private slots:
  void clock();
  void keptAndRecovered();
  void ofOneProcessEachHasItsOwn();
  void damagedCopiesAreFoundAllTheSame();
  void killedAtAnyMoment();
};

void AutosaveTest::clock() {
  const AutosaveClock::Time start{};
  AutosaveClock clock;
  QVERIFY(!clock.due(start + 1h));
  clock.changed(start);
  clock.changed(start + 50s);
  QVERIFY(!clock.due(start + 59s));
  QVERIFY(clock.due(start + 60s));  // a minute after the first change that no copy has
  clock.kept();
  QVERIFY(!clock.due(start + 2h));
  clock.changed(start + 2h, true);
  QVERIFY(clock.due(start + 2h));
  clock.kept();
  QVERIFY(!clock.due(start + 3h));
}

void AutosaveTest::keptAndRecovered() {
  const QTemporaryDir folder;
  const fs::path copies = fs::path(folder.path().toStdString()) / "new" / "autosave";
  const AutosaveSource source{"Pélvis", "/home/someone/pelvis.sline"};
  const SceneDocument document{
      .scene = test::sampleScene(), .thumbnail = "picture", .others = {{"notes.txt", "mine"}}};
  {
    const auto autosave = Autosave::begin(copies);
    QVERIFY(autosave.ok());
    QVERIFY(autosave->keep(document, source).ok());
    QVERIFY(recoverableIn(copies).empty());  // its program still runs
  }
  const auto found = recoverableIn(copies);
  QCOMPARE(found.size(), std::size_t(1));
  QVERIFY(found[0].source == source);
  const auto again = recovered(found[0]);
  QVERIFY(again.ok());
  QCOMPARE(test::difference(again->scene, document.scene), std::string());
  QCOMPARE(again->thumbnail, document.thumbnail);
  QCOMPARE(again->others.size(), std::size_t(1));
  QCOMPARE(again->others[0].bytes, std::string("mine"));
  forget(found[0]);
  QVERIFY(recoverableIn(copies).empty());
  QVERIFY(fs::is_empty(copies));
}

void AutosaveTest::ofOneProcessEachHasItsOwn() {
  const QTemporaryDir folder;
  const fs::path copies = folder.path().toStdString();
  const auto a = Autosave::begin(copies);
  const auto b = Autosave::begin(copies);
  QVERIFY(a.ok() && b.ok());
  QVERIFY(a->file() != b->file());
  QVERIFY(a->keep({}, {"a", ""}).ok() && b->keep({}, {"b", ""}).ok());
  a->discard();
  QVERIFY(!fs::exists(a->file()) && fs::exists(b->file()));
  QVERIFY(!Autosave::begin("/sys/autosave").ok());
}

void AutosaveTest::damagedCopiesAreFoundAllTheSame() {
  const QTemporaryDir folder;
  const fs::path copies = folder.path().toStdString();
  QVERIFY(writeText(copies / "1-1.sline", "damaged").ok());
  QVERIFY(writeText(copies / "note.txt", "nothing of ours").ok());
  const auto found = recoverableIn(copies);
  QCOMPARE(found.size(), std::size_t(1));
  QVERIFY(found[0].source.title.empty());
  const auto document = recovered(found[0]);
  QVERIFY(!document.ok() && document.error().file == found[0].copy.string());
}

/// In 200 rounds the file is whole and either the one before or the one being saved, and the copy
/// holds all later edits up to the last copy. Each worker goes on where the one before it was
/// killed, over its lock and its leftovers.
void AutosaveTest::killedAtAnyMoment() {
  const QTemporaryDir folder;
  const fs::path file = folder.filePath("work.sline").toStdString();
  const fs::path copies = folder.filePath("copies").toStdString();
  constexpr int rounds = 200;
  constexpr int millisecondsBetweenCopies = 10;
  std::mt19937 random(3);
  long saved = 0;
  long whole = 0;  // this version may not be lost any more
  int duringSave = 0;
  int duringCopy = 0;
  int recoveries = 0;
  for (int round = 0; round < rounds; ++round) {
    const QByteArray said =
        killedAfter({QString::fromStdString(file.string()), QString::fromStdString(copies.string()),
                     QString::number(millisecondsBetweenCopies), QString::number(round)},
                    std::chrono::microseconds(random() % 60'000));
    QVERIFY2(!said.startsWith("failed"), said.constData());
    const Log log = logOf(said);
    const long now = versionIn(file);
    saved = std::max(saved, log.saved);
    QVERIFY2(now == saved || (now == log.saving && log.saving > saved),
             (said + "file: " + QByteArray::number(int(now))).constData());
    duringSave += log.saving != log.saved;
    duringCopy += log.keeping != log.kept;
    saved = now;
    long newest = now;
    for (const Recoverable& found : recoverableIn(copies)) {
      const auto copy = recovered(found);
      QVERIFY2(copy.ok(), copy.ok() ? "" : copy.error().text().c_str());
      QCOMPARE(found.source.title, std::string("work"));
      newest = std::max(newest, std::stol(copy->scene.nodes()[0].name));
      ++recoveries;
    }
    QVERIFY2(newest >= std::max({whole, log.kept, log.saved}), said.constData());
    QVERIFY2(newest <= std::max(whole, log.edited), said.constData());
    whole = newest;
  }
  qInfo(
      "%d rounds, version %ld; killed %d times while saving, %d times while keeping a copy; %d "
      "copies offered",
      rounds, saved, duringSave, duringCopy, recoveries);
  QVERIFY(duringSave > 0 && duringCopy > 0 && recoveries > 0);
}

SLINE_TEST_WITH_EVENTS(AutosaveTest)
#include "autosave_test.moc"
