// SPDX-License-Identifier: Apache-2.0
// Tests that the window's heart goes on beating while files come in, however many there are: each
// event that its thread handles is little work. Milliseconds are told by sline-bench-window.
#include <QAction>
#include <QEventLoop>
#include <QPushButton>
#include <QToolButton>
#include <QtTest>

#include "tests/gui/event_watch.h"
#include "tests/gui/window_fixture.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"
#include "widgets/import_dialog/import_dialog.h"
#include "widgets/import_dialog/plan_tree.h"
#include "widgets/shell/message_bar.h"

namespace sline::test {

namespace {

constexpr std::uint64_t limit = 400'000;  // requests for memory in one event

WatchedApplication& watch() {
  return *static_cast<WatchedApplication*>(QCoreApplication::instance());
}

class Heart : public QObject {
 public:
  Heart() { startTimer(5, Qt::PreciseTimer); }

  /// Runs the event loop until the condition holds; returns false after two minutes.
  bool beatUntil(const std::function<bool()>& holds) {
    m_until = holds;
    QTimer end;
    end.setSingleShot(true);
    connect(&end, &QTimer::timeout, &m_loop, &QEventLoop::quit);
    end.start(120'000);
    m_loop.exec();
    m_until = nullptr;
    return holds();
  }
  /// Does something between two beats, as the user's hand would.
  bool beatDuring(const std::function<void()>& act) {
    bool done = false;
    QTimer::singleShot(20, this, [&] {
      act();
      done = true;
    });
    return beatUntil([&] { return done; });
  }
  int beats() const { return m_beats; }

 protected:
  void timerEvent(QTimerEvent*) override {
    ++m_beats;
    if (m_until && m_until())
      m_loop.quit();
  }

 private:
  QEventLoop m_loop;
  std::function<bool()> m_until;
  int m_beats = 0;
};

/// Writes as many files as a whole body has parts, in folders, and two large ones.
void writeCrowd(const QString& folder) {
  const model::MeshPtr small = sphere(3.0f, 2);
  const model::MeshPtr large = sphere(60.0f, 7);
  for (int g = 0; g < 50; ++g) {
    const QString group = folder + QStringLiteral("/Group %1").arg(g);
    QDir().mkpath(group);
    for (int s = 0; s < 45; ++s)
      writeMesh(group + QStringLiteral("/part %1.ply").arg(45 * g + s),
                *moved(*small, 1.0f, {8.0f * float(s), 0.0f, 8.0f * float(g)}));
  }
  writeMesh(folder + QStringLiteral("/left lung.ply"), *moved(*large, 1.0f, {250, 90, 200}));
  writeMesh(folder + QStringLiteral("/right lung.ply"), *moved(*large, 1.0f, {100, 90, 200}));
}

}  // namespace

class HeartbeatTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_crowd;

  /// Prints what was counted; returns false if an event was much work or the heart did not beat.
  static bool alive(const Heart& heart, const char* during) {
    const bool fine = heart.beats() > 0 && watch().mostRequests() < limit;
    qInfo().noquote() << during << QStringLiteral(": %1 beats,").arg(heart.beats())
                      << watch().report(3);
    watch().forget();
    return fine;
  }
  static void rows() {
    QTest::addColumn<QString>("path");
    QTest::newRow("2,250 files") << QString();
    QTest::newRow("pelvis") << SLINE_TEST_DATA "/pelvis/bodyparts3d";
    QTest::newRow("atlas") << SLINE_TEST_DATA
        "/abdomen/AbdominalAtlas-2015Sept-Slicer4-4Version.mrml";
    QTest::newRow("label volume") << SLINE_TEST_DATA
        "/labelmap/spl_abdomen/spl_abdomen_labels.nrrd";
  }
  QString pathOf(const QString& row) const { return row.isEmpty() ? m_crowd.path() : row; }

 private slots:
  void initTestCase() { writeCrowd(m_crowd.path()); }

  void importing_data() { rows(); }
  void importing() {
    QFETCH(QString, path);
    if (!path.isEmpty() && !QFileInfo::exists(path))
      SLINE_ABSENT("no real anatomy here");
    WindowFixture f;
    watch().forget();
    Heart heart;
    QVERIFY(f.drop(pathOf(path)));
    QVERIFY(heart.beatUntil([&] { return !f.session.busy() && f.viewport().upToDate(); }));
    QVERIFY(f.session.scene().nodes().size() > 3);
    QVERIFY(alive(heart, "import"));
  }

  void choosing_data() { rows(); }
  void choosing() {
    QFETCH(QString, path);
    if (!path.isEmpty() && !QFileInfo::exists(path))
      SLINE_ABSENT("no real anatomy here");
    WindowFixture f;
    QVERIFY(f.drop(QFileInfo(m_crowd.path()).filePath() + QStringLiteral("/Group 1")));
    QVERIFY(f.settled());
    watch().forget();
    Heart heart;
    QVERIFY(f.drop(pathOf(path), Qt::ShiftModifier));
    const auto dialog = [&] { return f.window.findChild<widgets::ImportDialog*>(); };
    QVERIFY(heart.beatUntil([&] { return dialog()->draft().ready(); }));
    QVERIFY(alive(heart, "planning"));

    Heart atWork;
    widgets::PlanTree& tree = f.control<widgets::PlanTree>("planTree");
    tree.selectAll();
    const widgets::NodeIds all = tree.selectedNodes();
    const std::function<void()> acts[] = {
        [&] { QTest::keyClick(&tree, Qt::Key_Space); },
        [&] { QTest::keyClick(&tree, Qt::Key_Space); },
        [&] { tree.sortByColumn(widgets::PlanTreeModel::triangles, Qt::DescendingOrder); },
        [&] { tree.setFilter(QStringLiteral("1")); },
        [&] { tree.setFilter({}); },
        [&] { dialog()->draft().choose(all, [](auto& choice) { choice.unit = 10.0f; }); }};
    for (const auto& act : acts)
      QVERIFY(atWork.beatDuring(act));
    QVERIFY(atWork.beatUntil([&] { return dialog()->draft().ready(); }));
    QVERIFY(alive(atWork, "choosing"));

    Heart adding;
    QTest::mouseClick(&f.control<QPushButton>("addButton"), Qt::LeftButton);
    QVERIFY(adding.beatUntil([&] {
      return !f.session.busy() && !(dialog() && dialog()->isVisible()) && f.viewport().upToDate();
    }));
    QVERIFY(alive(adding, "adding"));
    Heart undoing;
    QTest::keyClick(&f.window, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(undoing.beatUntil([&] { return f.viewport().upToDate(); }));
    QVERIFY(alive(undoing, "undoing"));
  }

  /// After dropping the wrong folder the user has the window back at once, whatever is under way.
  void cancelling() {
    WindowFixture f;
    for (const int beats : {1, 20, 80, 200}) {
      Heart heart;
      int beat = 0;
      QVERIFY(f.drop(m_crowd.path()));
      QVERIFY(heart.beatUntil([&] { return ++beat >= beats || !f.session.busy(); }));
      f.session.cancelJob();
      QVERIFY(!f.session.busy());
      QVERIFY(
          heart.beatUntil([&] { return f.session.findChildren<widgets::SceneJob*>().isEmpty(); }));
      QVERIFY(alive(heart, "cancelling"));
    }
    // A second import takes the place of the first.
    QVERIFY(f.drop(m_crowd.path()));
    QVERIFY(f.drop(m_crowd.filePath(QStringLiteral("Group 1"))));
    QVERIFY(f.settled());
    QCOMPARE(f.session.scene().structuresBelow(model::rootId).size(), std::size_t(45));
  }

  /// Whatever a reader in a process of its own does, the window lives, reports it and keeps its
  /// document.
  void readersMisbehave_data() {
    QTest::addColumn<QString>("reason");
    QTest::newRow("crash") << QStringLiteral("crashed over this file");
    QTest::newRow("loop1") << QStringLiteral("did not come to an end");
    QTest::newRow("eat300") << QStringLiteral("of memory");
    QTest::newRow("lie") << QStringLiteral("makes no sense");
  }
  void readersMisbehave() {
    QFETCH(QString, reason);
    qputenv("SLINE_READER", MISBEHAVING_READER);
    WindowFixture f;
    QVERIFY(f.drop(m_crowd.filePath(QStringLiteral("Group 1"))));
    QVERIFY(f.settled());
    const widgets::Document before = f.session.document();
    const QString path = f.folder.filePath(QStringLiteral("bad.dcm"));
    writeText(path, QTest::currentDataTag());
    watch().forget();
    Heart heart;
    QVERIFY(f.drop(path));
    QVERIFY(heart.beatUntil([&] { return !f.session.busy(); }));
    QVERIFY(alive(heart, QTest::currentDataTag()));
    auto& message = f.control<widgets::MessageBar>("messageBar");
    QTRY_VERIFY(message.isVisible());
    QVERIFY2(message.text().contains(reason), qPrintable(message.text()));
    QVERIFY2(message.text().contains(QStringLiteral("bad.dcm")), qPrintable(message.text()));
    QVERIFY(f.session.document() == before);
    qunsetenv("SLINE_READER");
  }

  void cancellingReader() {
    qputenv("SLINE_READER", MISBEHAVING_READER);
    WindowFixture f;
    const widgets::Document before = f.session.document();
    const QString path = f.folder.filePath(QStringLiteral("bad.dcm"));
    writeText(path, "loop");
    QVERIFY(f.drop(path));
    Heart heart;
    int beat = 0;
    QVERIFY(heart.beatUntil([&] { return ++beat > 40; }));
    QVERIFY(f.session.busy());
    // The reader would go on for ever.
    QTest::mouseClick(&f.control<QToolButton>("cancel"), Qt::LeftButton);
    QVERIFY(
        heart.beatUntil([&] { return f.session.findChildren<widgets::SceneJob*>().isEmpty(); }));
    QVERIFY(alive(heart, "cancelling a reader"));
    QVERIFY(f.session.document() == before);
    qunsetenv("SLINE_READER");
  }
};

}  // namespace sline::test

SLINE_ENROL(sline::test::runSuiteIn<sline::test::HeartbeatTest, sline::test::WatchedApplication>)
#include "heartbeat_test.moc"
