// SPDX-License-Identifier: Apache-2.0
// Tests the one way by which scenes change: steps, drags, jobs.
#include <QSemaphore>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "model/edit/look.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"
#include "widgets/session/session.h"

namespace sline::widgets {

class SessionTest : public QObject {
  Q_OBJECT

  static model::Scene twoBalls() {
    model::Scene scene;
    scene.append({.name = "one", .mesh = test::sphere(1.0f, 1)});
    scene.append({.name = "two", .mesh = test::sphere(1.0f, 1)});
    return scene;
  }
  static SceneMaker maker(const QString& title) {
    return [title](const model::ImportProgress&, const std::stop_token&) -> Result<LoadedDocument> {
      return LoadedDocument{.scene = twoBalls(), .title = title, .remarks = {}};
    };
  }
  static bool open(Session& session, const QString& title = QStringLiteral("balls")) {
    session.openMade(title, maker(title));
    return QTest::qWaitFor([&] { return !session.busy(); });
  }
  static model::Edited withGamma(const Session& session, float gamma) {
    const model::NodeId first[] = {session.scene().nodes().front().id};
    return model::withLook(session.scene(), first, {.gamma = Gamma::clamped(gamma)});
  }

 private slots:
  void editsAreSteps() {
    Session session;
    QVERIFY(open(session));
    QCOMPARE(session.history().count(), 0);
    const Document before = session.document();
    QSignalSpy changes(&session, &Session::documentChanged);
    QVERIFY(session.apply(QStringLiteral("Γ"), withGamma(session, 4.0f)));
    QVERIFY(!session.apply(QStringLiteral("Γ"), withGamma(session, 4.0f)));
    QCOMPARE(changes.count(), 1);
    QCOMPARE(session.history().count(), 1);
    QCOMPARE(session.history().undoText(), QStringLiteral("Γ"));
    session.undo();
    QVERIFY(session.document() == before);
    session.redo();
    QVERIFY(!(session.document() == before));
    QCOMPARE(changes.count(), 3);
  }

  void aDragIsOneStep() {
    Session session;
    QVERIFY(open(session));
    const model::Scene before = session.scene();
    for (const float gamma : {2.5f, 3.0f, 4.0f})
      session.preview(withGamma(session, gamma).scene);
    QVERIFY(session.previewing());
    QVERIFY(session.sceneBeforePreview() == before);
    QCOMPARE(session.history().count(), 0);
    session.commitPreview(QStringLiteral("Γ"));
    QCOMPARE(session.history().count(), 1);
    session.undo();
    QVERIFY(session.scene() == before);
  }

  void aDragToWhereItBeganIsNone() {
    Session session;
    QVERIFY(open(session));
    const model::Scene before = session.scene();
    session.preview(withGamma(session, 4.0f).scene);
    session.preview(before);
    session.commitPreview(QStringLiteral("Γ"));
    QCOMPARE(session.history().count(), 0);
    session.preview(withGamma(session, 4.0f).scene);
    session.cancelPreview();
    QVERIFY(session.scene() == before);
    QVERIFY(!session.previewing());
    QCOMPARE(session.history().count(), 0);
  }

  void undoDuringADragGivesItUp() {
    Session session;
    QVERIFY(open(session));
    const model::Scene first = session.scene();
    session.apply(QStringLiteral("a"), withGamma(session, 3.0f));
    session.preview(withGamma(session, 4.0f).scene);
    session.undo();
    QVERIFY(session.scene() == first);
    QVERIFY(!session.previewing());
  }

  void keysInARowAreOneStep() {
    Session session;
    QVERIFY(open(session));
    const model::Scene before = session.scene();
    const QString series = QStringLiteral("keys");
    for (const float gamma : {2.05f, 2.10f, 2.15f})
      session.apply(QStringLiteral("Γ"), withGamma(session, gamma), series);
    QCOMPARE(session.history().count(), 1);
    session.apply(QStringLiteral("Γ"), withGamma(session, 3.0f), QStringLiteral("other keys"));
    QCOMPARE(session.history().count(), 2);
    session.undo();
    session.undo();
    QVERIFY(session.scene() == before);
  }

  void openingIsAStepButTheFirst() {
    Session session;
    QVERIFY(open(session, QStringLiteral("first")));
    const Document first = session.document();
    session.select({session.scene().nodes().front().id});
    QVERIFY(open(session, QStringLiteral("second")));
    QCOMPARE(session.document().title, QStringLiteral("second"));
    QVERIFY(session.selection().empty());
    QVERIFY(session.document().opening != first.opening);
    QCOMPARE(session.history().count(), 1);
    session.undo();
    QVERIFY(session.document() == first);
  }

  void selectionHoldsWhatIsThere() {
    Session session;
    QVERIFY(open(session));
    const NodeIds all{session.scene().nodes()[0].id, session.scene().nodes()[1].id};
    QSignalSpy changes(&session, &Session::selectionChanged);
    session.select({all[1], all[0], all[1], model::NodeId{99}});
    QCOMPARE(session.selection(), all);
    session.select(all);
    QCOMPARE(changes.count(), 1);
  }

  void cancelledJobsLeaveNothing() {
    Session session;
    QVERIFY(open(session));
    const Document before = session.document();
    const auto seen = std::make_shared<QSemaphore>();
    session.openMade(QStringLiteral("endless"),
                     [seen](const model::ImportProgress& progress,
                            const std::stop_token&) -> Result<LoadedDocument> {
                       while (progress(0.5f, "on and on"))
                         QThread::msleep(1);
                       seen->release();
                       return Error{.reason = "cancelled"};
                     });
    QVERIFY(session.busy());
    QSignalSpy failures(&session, &Session::failed);
    session.cancelJob();
    QVERIFY(!session.busy());
    QTRY_VERIFY(seen->available() == 1);
    QTest::qWait(0);
    QVERIFY(session.document() == before);
    QCOMPARE(failures.count(), 0);
  }

  /// A job that reports nothing is told to stop, too, and a session that ends waits for it.
  void silentJobsStopToo() {
    const auto ended = std::make_shared<std::atomic<bool>>(false);
    {
      Session session;
      session.openMade(QStringLiteral("silent"),
                       [ended](const model::ImportProgress&,
                               const std::stop_token& stop) -> Result<LoadedDocument> {
                         while (!stop.stop_requested())
                           QThread::msleep(1);
                         *ended = true;
                         return Error{.reason = "cancelled"};
                       });
    }
    QVERIFY(*ended);
  }

  void aNewJobReplacesTheOld() {
    Session session;
    const auto release = std::make_shared<QSemaphore>();
    session.openMade(
        QStringLiteral("slow"),
        [release](const model::ImportProgress&, const std::stop_token&) -> Result<LoadedDocument> {
          release->acquire();
          return LoadedDocument{
              .scene = twoBalls(), .title = QStringLiteral("slow"), .remarks = {}};
        });
    QVERIFY(open(session, QStringLiteral("quick")));
    release->release();
    QTest::qWait(20);
    QCOMPARE(session.document().title, QStringLiteral("quick"));
    QCOMPARE(session.document().opening, 1);
  }

  void failuresAreTold_data() {
    QTest::addColumn<bool>("throws");
    QTest::newRow("an error") << false;
    QTest::newRow("a library that throws") << true;
  }
  void failuresAreTold() {
    QFETCH(bool, throws);
    Session session;
    QVERIFY(open(session));
    const Document before = session.document();
    QSignalSpy failures(&session, &Session::failed);
    session.openMade(
        QStringLiteral("broken"),
        [throws](const model::ImportProgress&, const std::stop_token&) -> Result<LoadedDocument> {
          if (throws)
            throw std::runtime_error("no luck");
          return Error{.file = "a.obj", .reason = "no luck"};
        });
    QTRY_COMPARE(failures.count(), 1);
    const auto error = failures.front().front().value<Error>();
    QVERIFY(QString::fromStdString(error.reason).contains(QStringLiteral("no luck")));
    QVERIFY(session.document() == before);
    QVERIFY(!session.busy());
  }

  void filesAreReadWithProgress() {
    QTemporaryDir folder;
    test::writeMesh(folder.filePath(QStringLiteral("left kidney.ply")), *test::sphere(10.0f, 2));
    test::writeText(folder.filePath(QStringLiteral("broken.obj")), "f 1 2 3\n");
    Session session;
    QSignalSpy progress(&session, &Session::jobProgressed);
    QSignalSpy remarks(&session, &Session::remarked);
    session.openPaths({folder.path().toStdString()});
    QTRY_VERIFY(!session.busy());
    QVERIFY(progress.count() > 0);
    QCOMPARE(remarks.count(), 1);
    QVERIFY(remarks.front()[0].toStringList().join(' ').contains(QStringLiteral("broken.obj")));
    QCOMPARE(session.scene().named("left kidney").size(), std::size_t(1));
    // A drawing in the window is solid unless the scene says otherwise.
    QVERIFY(session.scene().resolve(session.scene().named("left kidney").front()).fill ==
            model::Fill::paper);
  }
};

}  // namespace sline::widgets

SLINE_TEST_WITH_EVENTS(sline::widgets::SessionTest)
#include "session_test.moc"
