// SPDX-License-Identifier: Apache-2.0
// Tests Ctrl+C in the middle of an export: the program ends by the signal, and no half file stays.
#include <signal.h>

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/sline_process.h"
#include "tests/support/suite.h"

namespace sline::test {

class InterruptionTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  QString m_sample = writeSample(m_folder.path());

 private slots:
  void leavesNothing_data() {
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("signal");
    QTest::newRow("gif") << "gif"
                         << "a.gif" << SIGINT;
    QTest::newRow("frames") << "frames"
                            << "a" << SIGTERM;
    QTest::newRow("png") << "png"
                         << "a.png" << SIGHUP;
  }
  void leavesNothing() {
    QFETCH(QString, kind);
    QFETCH(QString, name);
    QFETCH(int, signal);
    const QTemporaryDir out;
    QProcess process;
    // The exports are long films, and a picture of many bands.
    process.start(QStringLiteral(SLINE_PROGRAM),
                  {"export", m_sample, "--" + kind, out.filePath(name), "--seconds", "60",
                   "--film-height", "480", "--size-px", "6000x6000"});
    QVERIFY(process.waitForStarted());
    const auto everything = [&out] {
      return QDir(out.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    };
    QVERIFY2(QTest::qWaitFor([&] { return !everything().isEmpty(); }, 60'000),
             "nothing is being written");
    QVERIFY(process.state() == QProcess::Running);
    QCOMPARE(kill(pid_t(process.processId()), signal), 0);
    QVERIFY(process.waitForFinished(60'000));
    QCOMPARE(process.exitStatus(), QProcess::CrashExit);
    QCOMPARE(process.exitCode(), signal);
    QCOMPARE(everything(), QStringList());
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::InterruptionTest)
#include "interruption_test.moc"
