// SPDX-License-Identifier: Apache-2.0
// Gives each harness once the inputs that fuzzing began with and those it found: any input that
// broke a reader once is tried with every build.
#include <QDirIterator>
#include <QFile>
#include <QtTest>

#include "tests/fuzz/harnesses.h"
#include "tests/support/process_memory.h"
#include "tests/support/suite.h"

using namespace sline;

namespace {
QByteArray contents(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}
}  // namespace

class ReplayTest : public QObject {
  Q_OBJECT
 private slots:
  void inputs_data() {
    QTest::addColumn<QString>("harness");
    QTest::addColumn<QString>("path");
    for (const char* kind : {"seeds", "crashers"}) {
      const QDir folder(QStringLiteral(SLINE_FUZZ_INPUTS "/") + kind);
      QDirIterator it(folder.path(), QDir::Files, QDirIterator::Subdirectories);
      while (it.hasNext()) {
        const QString path = it.next();
        const QString name = folder.relativeFilePath(path);
        QTest::newRow(qPrintable(kind + ('/' + name))) << name.section('/', 0, 0) << path;
      }
    }
  }
  void inputs() {
    QFETCH(QString, harness);
    QFETCH(QString, path);
    const fuzz::Harness* found = fuzz::harnessNamed(harness.toStdString());
    QVERIFY2(found, "this folder has no harness");
    const QByteArray bytes = contents(path);
    const std::string fault = found->run({bytes.constData(), std::size_t(bytes.size())});
    QVERIFY2(fault.empty(), fault.c_str());
  }

  void seedsForAll() {
    for (const fuzz::Harness& harness : fuzz::harnesses()) {
      const QString folder = QStringLiteral(SLINE_FUZZ_INPUTS "/seeds/") +
                             QString::fromUtf8(harness.name.data(), qsizetype(harness.name.size()));
      QVERIFY2(!QDir(folder).entryList(QDir::Files).isEmpty(), qPrintable(folder + " is empty"));
    }
  }

  void memoryIsBounded() { QVERIFY(test::peakResidentMiB() < 2048); }
};

SLINE_TEST_WITH_EVENTS(ReplayTest)
#include "replay_test.moc"
