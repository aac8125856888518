// SPDX-License-Identifier: Apache-2.0
// Tests `sline export --pptx`: which slides there are, and what flags say of them.
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/sline_process.h"
#include "tests/render/export/slides/opened_slides.h"
#include "tests/support/suite.h"

namespace sline::test {

class SlidesCommandTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  QString m_scene = m_folder.filePath("lesson.sline");
  QString m_file = m_folder.filePath("lesson.pptx");

  /// Exports with those flags; returns what the command said.
  Finished exported(const QStringList& flags) const {
    QFile::remove(m_file);
    return runSline(QStringList{"export", m_scene, "--pptx", m_file, "--dpi", "40"} + flags);
  }
  OpenedSlides opened() const {
    QFile file(m_file);
    return OpenedSlides(file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : "");
  }

 private slots:
  void initTestCase() {
    const QString sample = writeSample(m_folder.path());
    QCOMPARE(runSline({"import", sample, "--sides", "right", "-o", m_scene}).code, 0);
    QCOMPARE(runSline({"annotate", m_scene, "--on", "kidney"}).code, 0);
    QCOMPARE(runSline({"view", m_scene, "--add", "Front", "--from", "anterior", "--title",
                       "From in front", "--notes", "say it"})
                 .code,
             0);
    QCOMPARE(runSline({"view", m_scene, "--add", "Side", "--from", "left", "--labels", "all",
                       "--text", "**Look**"})
                 .code,
             0);
  }

  void eachViewHasASlide() {
    QCOMPARE(exported({}).code, 0);
    const OpenedSlides all = opened();
    QVERIFY2(all.faults().isEmpty(), qPrintable(all.faults().join('\n')));
    QCOMPARE(all.slides(), 2);
    QVERIFY(wordsOf(all.slide(1)).startsWith("From in front\n"));
    QVERIFY(wordsOf(all.slide(2)).startsWith("Side\nLook\n"));
    QVERIFY(!all.slide(1).child("p:timing"));
    QCOMPARE(exported({"--self-test", "--on-click"}).code, 0);
    const OpenedSlides tested = opened();
    QCOMPARE(tested.slides(), 6);
    QVERIFY(tested.slide(1).child("p:timing"));
    QVERIFY(!tested.slide(2).child("p:timing"));
  }

  void oneIsShownWhereItIsAskedFor_data() {
    QTest::addColumn<QStringList>("flags");
    QTest::addColumn<QString>("title");
    QTest::newRow("a saved view") << QStringList{"--view", "Side"} << "Side";
    QTest::newRow("a side of the body") << QStringList{"--view", "posterior"} << "Posterior view";
    QTest::newRow("what is shown") << QStringList{"--views", "shown"} << "Anterior view";
    QTest::newRow("and its words")
        << QStringList{"--views", "shown", "--view", "Front"} << "From in front";
  }
  void oneIsShownWhereItIsAskedFor() {
    QFETCH(QStringList, flags);
    QFETCH(QString, title);
    QCOMPARE(exported(flags).code, 0);
    const OpenedSlides one = opened();
    QCOMPARE(one.slides(), 1);
    QCOMPARE(wordsOf(one.slide(1)).section('\n', 0, 0), title);
  }

  void shapes() {
    const auto width = [this] {
      return opened().root("ppt/presentation.xml").select_node("p:sldSz/@cx").attribute().as_int();
    };
    QCOMPARE(exported({}).code, 0);
    QCOMPARE(width(), 12'192'000);
    QCOMPARE(exported({"--slide-shape", "4:3"}).code, 0);
    QCOMPARE(width(), 9'144'000);
    QVERIFY(exported({"--slide-shape", "5:4"}).code != 0);
    QVERIFY(!QFile::exists(m_file));
  }

  /// What saved views show is theirs to say.
  void choicesThatAreNone() {
    const char* warning = "each view shows what was saved with it";
    QVERIFY(exported({"--only", "kidney"}).err.contains(warning));
    QVERIFY(!exported({"--only", "kidney", "--views", "shown"}).err.contains(warning));
    QVERIFY(!exported({}).err.contains(warning));
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::SlidesCommandTest)
#include "slides_command_test.moc"
