// SPDX-License-Identifier: Apache-2.0
// Tests that nothing needs an OpenGL driver where no graphics card is, but for what says so.
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/sline_process.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

/// Hides every driver from programs that are started as long as it lives: the dispatch library
/// looks for them in an empty folder.
class DriversHidden {
 public:
  DriversHidden() { qputenv(variable, QFile::encodeName(m_empty.path())); }
  ~DriversHidden() { qunsetenv(variable); }
  DriversHidden(const DriversHidden&) = delete;
  DriversHidden& operator=(const DriversHidden&) = delete;

 private:
  static constexpr const char* variable = "__EGL_VENDOR_LIBRARY_DIRS";
  QTemporaryDir m_empty;
};

QByteArray contentsOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class NoDriverTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  QString m_sample = writeSample(m_folder.path());

 private slots:
  void picturesAreTheSame_data() {
    QTest::addColumn<QStringList>("arguments");
    const auto row = [](const char* name, const QStringList& arguments) {
      QTest::newRow(name) << arguments;
    };
    row("plain", {"render", "-o"});
    row("hatched, dark", {"render", "--gamma", "3.5", "--background", "dark", "-o"});
    row("cut, labelled", {"render", "--section", "coronal", "--labels", "on", "-o"});
    row("focus", {"render", "--focus", "kidney", "-o"});
    row("fine", {"export", "--dpi", "200", "--png"});
    row("black and white", {"export", "--bw", "--bits", "1", "--png"});
  }
  void picturesAreTheSame() {
    QFETCH(QStringList, arguments);
    arguments.insert(1, m_sample);
    const QString usual = m_folder.filePath("usual.png");
    const QString hidden = m_folder.filePath("hidden.png");
    const Finished first = runSline(arguments + QStringList{usual});
    QVERIFY2(first.code == 0, first.err.constData());
    const DriversHidden drivers;
    const Finished second = runSline(arguments + QStringList{hidden});
    QVERIFY2(second.code == 0, second.err.constData());
    QVERIFY(!contentsOf(usual).isEmpty());
    QCOMPARE(contentsOf(hidden), contentsOf(usual));
  }

  void whatNeedsOneSaysSo_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("says");
    QTest::newRow("noise") << QStringList{"render",      "--gamma",   "3",
                                          "--technique", "noise_lic", "-o"}
                           << QByteArray("hatching that is found pixel by pixel needs OpenGL");
    QTest::newRow("16 bits") << QStringList{"export", "--bits", "16", "--png"}
                             << QByteArray("16 bits per channel need OpenGL");
  }
  void whatNeedsOneSaysSo() {
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, says);
    arguments.insert(1, m_sample);
    const QString path = m_folder.filePath("needs.png");
    arguments << path;
    {
      const DriversHidden drivers;
      const Finished refused = runSline(arguments);
      QVERIFY(refused.code > 0);
      QVERIFY2(refused.err.contains(says), refused.err.constData());
      QVERIFY(!QFile::exists(path));
    }
    const Finished drawn = runSline(arguments);
    QVERIFY2(drawn.code == 0, drawn.err.constData());
    QVERIFY(QFile::remove(path));
  }
};

}  // namespace sline::test

SLINE_TEST(sline::test::NoDriverTest)
#include "no_driver_test.moc"
