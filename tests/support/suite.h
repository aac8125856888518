// SPDX-License-Identifier: Apache-2.0
// Puts several suites of tests in one program, so that a room's tests are linked once: each source
// file enrols one QObject of test slots under its own name, and `PROGRAM NAME [QtTest's arguments]`
// runs it in a process of its own, as a program with QTEST_MAIN would.
#pragma once

#include <QtTest>

namespace sline::test {

using RunSuite = int (*)(int argc, char** argv);

/// Enrols a suite under the stem of its source file. Returns true, so that it can start a constant.
bool enrol(const char* sourceFile, RunSuite run);

template <class Suite>
int runSuite(int argc, char** argv) {
  Suite suite;
  return QTest::qExec(&suite, argc, argv);
}

/// Runs the suite with an event loop: `Application` is QCoreApplication, QGuiApplication or
/// QApplication.
template <class Suite, class Application>
int runSuiteIn(int argc, char** argv) {
  QTest::Internal::callInitMain<Suite>();
  Application application(argc, argv);
  QCoreApplication::setAttribute(Qt::AA_Use96Dpi, true);
  return runSuite<Suite>(argc, argv);
}

}  // namespace sline::test

/// Ends a test that lacks something from outside the project: real anatomy, or a program that it
/// asks for an opinion. It counts as skipped, or as failed if the variable SLINE_NOTHING_ABSENT
/// says that all of it must be there, as in CI.
#define SLINE_ABSENT(reason)                               \
  do {                                                     \
    if (qEnvironmentVariableIsSet("SLINE_NOTHING_ABSENT")) \
      QFAIL(reason);                                       \
    QSKIP(reason);                                         \
  } while (false)

#define SLINE_ENROL(...) \
  static const bool slineEnrolled [[maybe_unused]] = sline::test::enrol(__FILE__, __VA_ARGS__);
/// Enrols tests that need no application object.
#define SLINE_TEST(Suite) SLINE_ENROL(sline::test::runSuite<Suite>)
/// Enrols tests that need events, processes or settings.
#define SLINE_TEST_WITH_EVENTS(Suite) SLINE_ENROL(sline::test::runSuiteIn<Suite, QCoreApplication>)
/// Enrols tests that draw with Qt (QGuiApplication) and those that show widgets (QApplication).
#define SLINE_TEST_WITH_GUI(Suite) SLINE_ENROL(sline::test::runSuiteIn<Suite, QGuiApplication>)
#define SLINE_TEST_WITH_WIDGETS(Suite) SLINE_ENROL(sline::test::runSuiteIn<Suite, QApplication>)
