// SPDX-License-Identifier: Apache-2.0
// Tests that a job ends in exactly one way, tells how far it is, and is over when its owner lets go
// of it.
#include "widgets/session/background_job.h"

#include <QSignalSpy>
#include <QtTest>
#include <chrono>

#include "tests/support/suite.h"

using namespace sline;
using namespace sline::widgets;

namespace {

/// Holds the signals that one job has sent.
struct Ends {
  explicit Ends(BackgroundJob& job)
      : done(&job, &BackgroundJob::done),
        failed(&job, &BackgroundJob::failed),
        cancelled(&job, &BackgroundJob::cancelled) {}
  bool wait() {
    return QTest::qWaitFor(
        [this] { return done.count() + failed.count() + cancelled.count() > 0; });
  }
  QSignalSpy done;
  QSignalSpy failed;
  QSignalSpy cancelled;
};

class Counting : public BackgroundJob {
 public:
  explicit Counting(std::atomic<int>& steps)
      : BackgroundJob([this](const Progress& progress) { return count(progress); }),
        m_steps(steps) {}
  ~Counting() override { end(); }

 private:
  Status count(const Progress& progress) {
    while (progress(0.5, "counting"))
      ++m_steps;
    return Error{.reason = "given up"};
  }
  std::atomic<int>& m_steps;
};

}  // namespace

class BackgroundJobTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() { qRegisterMetaType<sline::Error>("sline::Error"); }

  void doneOnItsOwnersThread() {
    std::thread::id worked;
    BackgroundJob job([&worked](const BackgroundJob::Progress& progress) -> Status {
      worked = std::this_thread::get_id();
      return progress(0.25, "ünder way") ? Status(Unit{}) : Error{.reason = "stopped"};
    });
    std::thread::id heard;
    connect(&job, &BackgroundJob::done, this, [&heard] { heard = std::this_thread::get_id(); });
    QSignalSpy progress(&job, &BackgroundJob::progressed);
    Ends ends(job);
    job.start();
    QVERIFY(ends.wait());
    QCOMPARE(ends.done.count(), 1);
    QVERIFY(heard == std::this_thread::get_id() && worked != heard);
    QTRY_COMPARE(progress.count(), 1);
    QCOMPARE(progress.first().at(0).toDouble(), 0.25);
    QCOMPARE(progress.first().at(1).toString(), QStringLiteral("ünder way"));
  }

  void failureIsTold() {
    BackgroundJob job([](const BackgroundJob::Progress&) -> Status {
      return caught([]() -> Status { throw std::bad_alloc(); }, {.memory = "Close something"});
    });
    Ends ends(job);
    job.start();
    QVERIFY(ends.wait());
    QCOMPARE(ends.failed.count(), 1);
    const auto error = ends.failed.first().at(0).value<sline::Error>();
    QCOMPARE(error.remedy, std::string("Close something"));
  }

  void cancelledInTheMiddle() {
    std::atomic<int> steps = 0;
    Counting job(steps);
    Ends ends(job);
    job.start();
    QTRY_VERIFY(steps > 0);
    job.cancel();
    QVERIFY(ends.wait());
    QCOMPARE(ends.cancelled.count(), 1);
    QCOMPARE(ends.failed.count(), 0);
  }

  void endsWithItsOwner() {
    std::atomic<int> steps = 0;
    {
      Counting job(steps);
      job.start();
      QTRY_VERIFY(steps > 0);
    }
    const int then = steps;
    QTest::qWait(30);
    QCOMPARE(int(steps), then);
  }
};

SLINE_TEST_WITH_EVENTS(BackgroundJobTest)
#include "background_job_test.moc"
