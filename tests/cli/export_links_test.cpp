// SPDX-License-Identifier: Apache-2.0
// Tests links in texts where they cannot be followed: every file but the students' page has their
// words alone.
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "render/export/formats/export_formats.h"
#include "tests/cli/sline_process.h"
#include "tests/support/marker_scan.h"
#include "tests/support/suite.h"

namespace sline::test {

class ExportLinksTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  QString m_scene = m_folder.filePath("scene.sline");

  /// Returns the files of that kind, exported to an empty folder.
  QStringList exported(const QString& kind, const QString& name, const QStringList& flags) {
    const QString out = m_folder.filePath("out");
    QDir(out).removeRecursively();
    QDir().mkpath(out);
    const Finished finished =
        runSline(QStringList{"export", m_scene, "--" + kind, out + "/" + name, "--dpi", "72",
                             "--seconds", "0.5", "--fps", "6", "--film-height", "96"} +
                 flags);
    if (finished.code != 0)
      qWarning("%s", finished.err.constData());
    QStringList files;
    for (QDirIterator each(out, QDir::Files, QDirIterator::Subdirectories); each.hasNext();)
      files << each.next();
    return finished.code == 0 ? files : QStringList();
  }

 private slots:
  void initTestCase() {
    const QString sample = writeSample(m_folder.path());
    QCOMPARE(runSline({"import", sample, "-o", m_scene}).code, 0);
    QCOMPARE(runSline({"annotate", m_scene, "--kind", "callout", "--on", "kidney", "--label",
                       "Of [QZXCALLOUT](#structure=kidney) ends"})
                 .code,
             0);
    QCOMPARE(runSline({"annotate", m_scene, "--on", "kidney"}).code, 0);
    for (const char* side : {"anterior", "left"})
      QCOMPARE(runSline({"view", m_scene, "--add", QString("From ") + QLatin1String(side), "--from",
                         side, "--labels", "all", "--text", "Go [QZXTEXT](#view=2) now", "--notes",
                         "Say [QZXNOTES](#view=1) then"})
                   .code,
               0);
  }

  void onlyWordsAreShown_data() {
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QStringList>("flags");
    for (const render::ExportFormat& format : render::exportFormats())
      if (!format.forLearning && !QString(format.id).startsWith("page"))
        QTest::newRow(format.id) << format.id
                                 << QString("figure") + (*format.extension ? "." : "") +
                                        format.extension
                                 << QStringList{"--view", "From left"};
    for (const char* sheet : {"figure", "teaching", "patient"})
      QTest::addRow("%s sheet", sheet) << "pdf"
                                       << "sheet.pdf" << QStringList{"--sheet", sheet};
    QTest::newRow("lesson") << "pdf"
                            << "lesson.pdf" << QStringList{"--views", "all"};
    QTest::newRow("film with subtitles")
        << "mp4"
        << "film.mp4" << QStringList{"--views", "all", "--subtitles"};
  }
  void onlyWordsAreShown() {
    QFETCH(QString, kind);
    QFETCH(QString, name);
    QFETCH(QStringList, flags);
    const QStringList files = exported(kind, name, flags);
    QVERIFY(!files.isEmpty());
    // Packed pixels may hold any three bytes by chance.
    const QStringList marks{"](#vi", "](#st", "#view=", "#structure="};
    for (const QString& file : files) {
      QFile source(file);
      QVERIFY(source.open(QIODevice::ReadOnly));
      const QByteArray bytes = source.readAll();
      QCOMPARE(markersIn(bytes, marks), QStringList());
      if (file.endsWith(".pdf"))
        QCOMPARE(markersIn(textOfPdf(file), marks), QStringList());
    }
  }

  /// The words are there, with what stands around them.
  void wordsAreThere() {
    const auto found = [](const QStringList& files, const QStringList& words) {
      QFile source(files.value(0));
      QStringList all = markersIn(source.open(QIODevice::ReadOnly) ? source.readAll() : "", words);
      all.sort();
      return all;
    };
    // Slides have each run and each line for itself.
    const QStringList slides{"QZXCALLOUT", "QZXTEXT", "Say QZXNOTES then"};
    QCOMPARE(found(exported("pptx", "a.pptx", {"--view", "From left"}), slides), slides);
    const QStringList surfaces{"Go QZXTEXT now", "Of QZXCALLOUT ends"};
    QCOMPARE(found(exported("glb", "a.glb", {}), surfaces), surfaces);
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::ExportLinksTest)
#include "export_links_test.moc"
