// SPDX-License-Identifier: Apache-2.0
// Tests what is kept of unsaved work: as soon as it is done, all of it, and no longer than needed.
// SLINE_KILLS=100 kills as many workers instead of ten.
#include "widgets/session/journaler.h"

#include <signal.h>

#include <QProcess>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>
#include <random>

#include "model/edit/look.h"
#include "model/edit/tree.h"
#include "tests/support/memory_requests.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"
#include "tests/widgets/session/journal_log.h"
#include "widgets/session/scene_saver.h"

namespace sline::widgets {

namespace fs = std::filesystem;

namespace {
model::Scene ofStructures(int count) {
  model::Scene scene;
  for (int i = 0; i < count; ++i)
    scene.append({.name = "structure " + std::to_string(i),
                  .style = {.fill = model::Fill::paper},
                  .mesh = test::sphere(float(1 + i % 5), 3)});
  return scene;
}

bool opened(Session& session, const model::Scene& scene) {
  session.openMade(QStringLiteral("made"), [scene](auto&&...) -> Result<LoadedDocument> {
    return LoadedDocument{.scene = scene, .title = QStringLiteral("made"), .remarks = {}};
  });
  return QTest::qWaitFor([&] { return !session.busy(); });
}

bool renamed(Session& session, const char* name) {
  return session.apply(QLatin1String(name),
                       model::renamed(session.scene(), session.scene().nodes()[0].id, name));
}

int journalsIn(const fs::path& folder, const char* extension = ".journal") {
  int count = 0;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none))
    count += entry.path().extension() == extension;
  return count;
}

/// Runs a worker and kills it after that time, counted from its first word; returns what it said.
QByteArray killedAfter(const QStringList& arguments, int milliseconds) {
  QProcess worker;
  worker.start(SLINE_JOURNAL_WORKER, arguments);
  if (!worker.waitForStarted() || !worker.waitForReadyRead())
    return "failed: " + worker.readAllStandardError();
  const QDeadlineTimer end(milliseconds);
  while (!end.hasExpired())
    worker.waitForReadyRead(int(std::max<qint64>(end.remainingTime(), 1)));
  ::kill(pid_t(worker.processId()), SIGKILL);
  worker.waitForFinished();
  const QByteArray complaint = worker.readAllStandardError();
  return complaint.isEmpty() ? worker.readAllStandardOutput() : "failed: " + complaint;
}

/// What is there after a worker was killed.
struct Left {
  std::uint32_t scene = 0;
  std::uint32_t before = 0;     ///< 0: no step to undo
  std::uint32_t selection = 0;  ///< 0: it does not say
  std::size_t steps = 0;

  /// Tells whether this is what was said in that place. What a step removes leaves the selection
  /// first, so that may be the next one's.
  bool isOf(const std::vector<test::JournalLog>& log, std::size_t i) const {
    const auto selected = [&](std::size_t at) {
      return at < log.size() && log[at].selection == selection;
    };
    return scene == log[i].scene && (selection == 0 || selected(i) || selected(i + 1));
  }
};

/// Returns what each journal brings back, and the scene file; an error text where one is
/// unreadable.
std::vector<Left> leftIn(const fs::path& folder, const fs::path& file, std::string& fault) {
  std::vector<Left> all;
  for (const model::Recoverable& found : model::recoverableIn(folder)) {
    const auto back = model::recovered(found);
    if (!back.ok()) {
      fault = back.error().text();
      continue;
    }
    const auto& states = back->states;
    all.push_back({test::sumOf(states[back->current].scene),
                   back->current > 0 ? test::sumOf(states[back->current - 1].scene) : 0,
                   test::sumOf(back->selection), states.size() - 1});
  }
  if (const auto saved = model::readSceneFile(file); saved.ok())
    all.push_back({test::sumOf(saved->scene), 0, 0, 0});
  else if (fs::exists(file))
    fault = saved.error().text();
  return all;
}
}  // namespace

class JournalerTest : public QObject {
  Q_OBJECT

 private slots:
  void journalsComeAndGo() {
    const QTemporaryDir place;
    const fs::path folder = place.filePath(QStringLiteral("new/journals")).toStdString();
    const fs::path path = place.filePath(QStringLiteral("work.sline")).toStdString();
    Session session;
    Journaler journaler(session, folder);
    SceneSaver saver(session);
    QSignalSpy kept(&journaler, &Journaler::kept);
    const auto save = [&] {
      saver.save(path, SceneSaver::As::document);
      return QTest::qWaitFor([&] { return !saver.busy(); });
    };
    QVERIFY(opened(session, ofStructures(3)) && save());
    QVERIFY(renamed(session, "a"));
    QTRY_COMPARE(kept.count(), 1);
    QCOMPARE(journalsIn(folder), 1);
    QVERIFY(model::recoverableIn(folder).empty());  // its program still runs
    session.undo();                                 // nothing to lose any more
    QTRY_COMPARE(journalsIn(folder), 0);
    session.redo();
    QTRY_COMPARE(journalsIn(folder), 1);
    QVERIFY(save());
    QTRY_COMPARE(journalsIn(folder), 0);
    QCOMPARE(journalsIn(folder, ".meshes"), 1);  // for what is edited next
    QVERIFY(renamed(session, "b"));
    QTRY_COMPARE(journalsIn(folder), 1);
    journaler.discard();
    QTRY_COMPARE(journalsIn(folder), 0);
    QTRY_COMPARE(journalsIn(folder, ".meshes"), 0);
    // What is told late of a step does not begin a journal that was discarded; the next step does.
    QVERIFY(save() && renamed(session, "c"));
    journaler.discard();
    QTest::qWait(100);
    QCOMPARE(journalsIn(folder), 0);
    QVERIFY(renamed(session, "d"));
    QTRY_COMPARE(journalsIn(folder), 1);
  }

  void historyAndSelectionComeBack() {
    const QTemporaryDir place;
    const fs::path folder = place.path().toStdString();
    const model::Scene scene = ofStructures(3);
    std::vector<std::uint32_t> sums;
    {
      Session session;
      Journaler journaler(session, folder);
      QSignalSpy kept(&journaler, &Journaler::kept);
      QVERIFY(opened(session, scene));
      for (const char* name : {"a", "b", "c", "d"}) {
        sums.push_back(test::sumOf(session.scene()));
        QVERIFY(renamed(session, name));
      }
      session.undo();
      session.select({scene.nodes()[1].id, scene.nodes()[2].id});
      QTRY_VERIFY(kept.count() > 0);
    }
    const auto found = model::recoverableIn(folder);
    QCOMPARE(found.size(), std::size_t(1));
    QCOMPARE(found[0].source.title, std::string("made"));
    // Something else is open when it is recovered.
    Session session;
    Journaler journaler(session, folder);
    QSignalSpy kept(&journaler, &Journaler::kept);
    QVERIFY(opened(session, ofStructures(1)));
    session.openRecovered(found[0]);
    QVERIFY(QTest::qWaitFor([&] { return !session.busy(); }));
    QVERIFY(session.modified());
    QCOMPARE(session.scene().nodes()[0].name, std::string("c"));
    QCOMPARE(session.selection().size(), std::size_t(2));
    QCOMPARE(session.history().redoText(), QStringLiteral("d"));
    // The document's own journal has all of it before the one that was left goes.
    QTRY_VERIFY(!fs::exists(found[0].journal));
    QCOMPARE(journalsIn(folder), 1);
    for (const char* name : {"c", "b", "a"}) {
      QCOMPARE(test::sumOf(session.scene()), sums.back());
      sums.pop_back();
      QCOMPARE(session.history().undoText(), QLatin1String(name));
      session.undo();
    }
  }

  void aNewDocumentHasAJournalOfItsOwn() {
    const QTemporaryDir place;
    const fs::path folder = place.path().toStdString();
    {
      Session session;
      Journaler journaler(session, folder);
      QSignalSpy kept(&journaler, &Journaler::kept);
      QVERIFY(opened(session, ofStructures(2)) && renamed(session, "of the first"));
      QTRY_COMPARE(kept.count(), 1);
      QVERIFY(opened(session, ofStructures(1)));
      QTRY_COMPARE(journalsIn(folder), 0);
      QVERIFY(renamed(session, "of the second"));
      QTRY_VERIFY(kept.count() > 1);
      session.undo();
      session.undo();  // to the first document, which was never saved
      QTRY_COMPARE(journalsIn(folder), 1);
      kept.clear();
      QVERIFY(renamed(session, "again"));
      QTRY_VERIFY(kept.count() > 0);
    }
    const auto found = model::recoverableIn(folder);
    QCOMPARE(found.size(), std::size_t(1));
    const auto back = model::recovered(found[0]);
    QVERIFY(back.ok());
    QCOMPARE(back->states[back->current].scene.nodes()[0].name, std::string("again"));
    QCOMPARE(back->states[back->current].scene.nodes().size(), std::size_t(2));
  }

  void failuresAreSaidOnce() {
    Session session;
    Journaler journaler(session, "/proc/none/journals");
    QSignalSpy failed(&journaler, &Journaler::failed);
    QVERIFY(opened(session, ofStructures(2)) && renamed(session, "a"));
    QTRY_COMPARE(failed.count(), 1);
    QVERIFY(renamed(session, "b"));
    QTest::qWait(50);
    QCOMPARE(failed.count(), 1);
    journaler.setEnabled(false);
  }

  /// The journal copies the scene, and does no more for an edit in the window's thread.
  void costOfAnEdit() {
    const QTemporaryDir place;
    constexpr int edits = 50;
    std::uint64_t each[2] = {};
    for (const bool with : {false, true}) {
      Session session;
      QVERIFY(opened(session, ofStructures(94)));
      std::optional<Journaler> journaler;
      if (with)
        journaler.emplace(session, place.path().toStdString());
      for (int i = 0; i < edits; ++i) {
        auto edited = model::withLook(session.scene(), session.scene().children(model::rootId),
                                      {.gamma = Gamma::clamped(0.01f * float(i))});
        const std::uint64_t before = test::memoryRequests();
        session.apply(QStringLiteral("Γ"), std::move(edited));
        each[with] += test::memoryRequests() - before;
      }
      each[with] /= edits;
    }
    qInfo("an edit of 94 structures: %llu requests for memory, with a journal %llu",
          static_cast<unsigned long long>(each[false]),
          static_cast<unsigned long long>(each[true]));
    const model::Scene scene = ofStructures(94);
    const std::uint64_t before = test::memoryRequests();
    const model::Scene copy = scene;
    const std::uint64_t copied = test::memoryRequests() - before;
    QCOMPARE(copy.nodes().size(), scene.nodes().size());
    QVERIFY(each[true] <= each[false] + 3 * copied + 100);
  }

  /// Whatever the moment: all is readable, and nothing is lost that the journal said it has. Each
  /// worker goes on where the one before it was killed.
  void killedAtAnyMoment() {
    const QTemporaryDir place;
    const fs::path folder = place.filePath(QStringLiteral("journals")).toStdString();
    const fs::path file = place.filePath(QStringLiteral("work.sline")).toStdString();
    const int kills =
        qEnvironmentVariableIsSet("SLINE_KILLS") ? qEnvironmentVariableIntValue("SLINE_KILLS") : 10;
    std::mt19937 random(5);
    std::vector<test::JournalLog> log;
    std::size_t lost = 0;
    std::size_t kept = 0;
    std::size_t steps = 0;
    int journals = 0;
    for (int round = 0; round < kills; ++round) {
      const QByteArray said =
          killedAfter({QString::fromStdString(file.string()),
                       QString::fromStdString(folder.string()), QString::number(round)},
                      int(random() % 1200));
      QVERIFY2(!said.startsWith("failed"), said.constData());
      for (const test::JournalLog& entry : test::JournalLog::from(said.toStdString()))
        log.push_back(entry);
      std::string fault;
      const std::vector<Left> left = leftIn(folder, file, fault);
      QVERIFY2(fault.empty(), fault.c_str());
      journals += left.size() > 1;
      // The newest that is left; what the worker had done after it is lost.
      std::size_t newest = 0;
      for (const Left& each : left) {
        std::size_t i = log.size();
        while (i > 0 && !each.isOf(log, i - 1))
          --i;
        QVERIFY2(i > 0, "what is left was never there");
        QVERIFY(each.before == 0 || log[i - 1].before == 0 || each.before == log[i - 1].before);
        newest = std::max(newest, i - 1);
        steps = std::max(steps, each.steps);
      }
      for (std::size_t i = newest + 1; i < log.size(); ++i) {
        QVERIFY2(!log[i].kept, "an edit is lost that the journal said it has");
        ++lost;
      }
      kept +=
          std::size_t(std::count_if(log.begin(), log.end(), [](const auto& e) { return e.kept; }));
      log.resize(std::min(log.size(), newest + 1));
    }
    qInfo(
        "%d kills, %d with a journal; %zu actions; %zu lost; %zu times all was kept; up to %zu "
        "steps of undo",
        kills, journals, log.size(), lost, kept, steps);
    QVERIFY(journals > 0 && steps > 0 && kept > 0);
  }
};

}  // namespace sline::widgets

SLINE_TEST_WITH_EVENTS(sline::widgets::JournalerTest)
#include "journaler_test.moc"
