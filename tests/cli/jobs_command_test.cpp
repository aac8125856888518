// SPDX-License-Identifier: Apache-2.0
// Tests `sline jobs`: figures of a list, all of them or a part.
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/sline_process.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

QByteArray contents(const QString& file) {
  QFile source(file);
  return source.open(QIODevice::ReadOnly) ? source.readAll() : QByteArray();
}

}  // namespace

class JobsCommandTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  QString m_sample = writeSample(m_folder.path());

  QString list(const QByteArray& text, const QString& name = "list.csv") {
    writeFile(m_folder.filePath(name), text);
    return m_folder.filePath(name);
  }
  /// Returns the files that were written, below "out".
  QStringList written() {
    QStringList names = QDir(m_folder.filePath("out")).entryList(QDir::Files | QDir::Hidden);
    names.sort();
    return names;
  }

 private slots:
  void cleanup() { QDir(m_folder.filePath("out")).removeRecursively(); }

  void flagsReachTheFigures() {
    const QString file = list(
        "input,svg,view,size-mm,gamma,bw,only\n"
        "sample,out/a.svg,anterior,24x18,1,,\n"
        "sample,out/b.svg,posterior,27x18,kidney=5; renal vein=0,no,kidney; renal vein\n"
        "sample/Organs/kidney.obj,out/c.svg,left,24x18,3,yes,\n");
    const Finished finished = runSline({"jobs", file});
    QVERIFY2(finished.code == 0, finished.err.constData());
    QVERIFY2(finished.err.contains("3 jobs done, 0 failed, 0 skipped, of 3"),
             finished.err.constData());
    QCOMPARE(written(), (QStringList{"a.svg", "b.svg", "c.svg"}));
    // The same flags given to `sline export` make the same file.
    const QString alone = m_folder.filePath("alone.svg");
    QCOMPARE(
        runSline({"export", m_sample, "--svg", alone, "--view", "posterior", "--size-mm", "27x18",
                  "--gamma", "kidney=5", "renal vein=0", "--only", "kidney", "renal vein"})
            .code,
        0);
    QCOMPARE(contents(m_folder.filePath("out/b.svg")), contents(alone));
    QVERIFY(contents(m_folder.filePath("out/c.svg")).contains("#000000"));
  }

  void jsonIsTheSame() {
    const QString file = list(R"([{"input": "sample", "svg": "out/a.svg", "size-mm": "24x18",
      "gamma": ["kidney=5", "renal vein=0"], "bw": false, "pen": 2}])",
                              "list.json");
    QCOMPARE(runSline({"jobs", file}).code, 0);
    QCOMPARE(written(), QStringList{"a.svg"});
  }

  void partsTogetherAreAll() {
    QByteArray text = "input,svg,size-mm\n";
    QStringList all;
    for (int i = 0; i < 11; ++i) {
      all << QStringLiteral("out/%1.svg").arg(i, 2, 10, QLatin1Char('0'));
      text += "sample," + all.back().toUtf8() + "\n";
    }
    const QString file = list(text);
    for (const int count : {2, 13}) {
      QStringList found;
      for (int index = 1; index <= count; ++index) {
        const QString shard = QStringLiteral("%1/%2").arg(index).arg(count);
        const Finished part = runSline({"jobs", file, "--dry-run", "--shard", shard});
        QCOMPARE(part.code, 0);
        for (const QByteArray& line : part.out.split('\n'))
          if (!line.isEmpty())
            found << QDir(m_folder.path()).relativeFilePath(QString::fromUtf8(line.split('\t')[1]));
      }
      found.sort();
      QCOMPARE(found, all);
    }
    QVERIFY2(written().isEmpty(), "a dry run writes nothing");
  }

  void failureStopsNobody() {
    const QString file = list(
        "input,svg,view\n"
        "nowhere.obj,out/a.svg,\n"
        "sample,out/b.svg,askance\n"
        "sample,out/c.svg,left\n");
    const Finished finished = runSline({"jobs", file});
    QCOMPARE(finished.code, 1);
    QCOMPARE(written(), QStringList{"c.svg"});
    for (const char* says : {"nowhere.obj", "line 2 failed", "askance", "line 3 failed",
                             "1 jobs done, 2 failed, 0 skipped, of 3"})
      QVERIFY2(finished.err.contains(says), finished.err.constData());
  }

  /// What was done is left out; what is there but is not what the job writes, is cut short, or was
  /// made of something else is done again.
  void resumeLeavesOutWhatIsDone() {
    const QByteArray jobs = "input,svg,size-mm\nsample,out/a.svg,24x18\nsample,out/b.svg,24x18\n";
    const auto resumed = [&](const QByteArray& says) {
      const Finished finished = runSline({"jobs", list(jobs), "--resume"});
      return finished.code == 0 && finished.err.contains(says);
    };
    QDir(m_folder.path()).mkdir("out");
    writeFile(m_folder.filePath("out/a.svg"), "another's");
    QVERIFY(resumed("2 jobs done, 0 failed, 0 skipped"));
    const QByteArray whole = contents(m_folder.filePath("out/a.svg"));
    QVERIFY(whole.contains("<svg"));
    QVERIFY(resumed("0 jobs done, 0 failed, 2 skipped"));

    writeFile(m_folder.filePath("out/b.svg"), whole.left(whole.size() / 2));
    QVERIFY(resumed("1 jobs done, 0 failed, 1 skipped"));
    QVERIFY(contents(m_folder.filePath("out/b.svg")).endsWith(whole.right(8)));

    const QByteArray larger = QByteArray(jobs).replace("b.svg,24x18", "b.svg,48x36");
    QVERIFY(
        runSline({"jobs", list(larger), "--resume"}).err.contains("1 jobs done, 0 failed, 1 sk"));
    QVERIFY(resumed("1 jobs done, 0 failed, 1 skipped"));

    QFile::remove(m_folder.filePath("out/a.svg"));
    QVERIFY(resumed("1 jobs done, 0 failed, 1 skipped"));
  }

  void resumeSeesThatInputsHaveChanged() {
    const QString mesh = m_folder.filePath("piece.obj");
    const auto triangle = [](const char* z) {
      return QByteArray("v 0 0 0\nv 10 0 0\nv 0 0 ") + z + "\nf 1 2 3\n";
    };
    writeFile(mesh, triangle("10"));
    const QString file = list("input,svg,size-mm\npiece.obj,out/a.svg,24x18\n");
    QCOMPARE(runSline({"jobs", file, "--resume"}).code, 0);
    QVERIFY(runSline({"jobs", file, "--resume"}).err.contains("1 skipped"));
    writeFile(mesh, triangle("12"));
    QVERIFY(runSline({"jobs", file, "--resume"}).err.contains("1 jobs done"));
    QVERIFY(runSline({"jobs", file, "--resume"}).err.contains("1 skipped"));
  }

  void filmsAreTargets() {
    const QByteArray film = "input,video,film-height,seconds,fps\nsample,";
    const QString file = list(film + "out/a.gif,36,0.2,10\n");
    const Finished dry = runSline({"jobs", file, "--dry-run"});
    QVERIFY2(dry.out.contains("out/a.gif"), dry.out.constData());
    const Finished finished = runSline({"jobs", file});
    QVERIFY2(finished.code == 0, finished.err.constData());
    QVERIFY(contents(m_folder.filePath("out/a.gif")).startsWith("GIF89a"));
    QVERIFY(runSline({"jobs", file, "--resume"}).err.contains("1 skipped"));
  }

  void textsAreNoPaths() {
    const QByteArray words = "Your bladder will be examined.";
    QTemporaryDir elsewhere;  // the list's folder is not the program's
    writeFile(m_folder.filePath("leaflet.txt"), "From the leaflet.\n");
    const QString file = list("input,pdf,sheet,text\nsample,out/a.pdf,patient," + words +
                              "\nsample,out/b.pdf,patient,leaflet.txt\n");
    const Finished finished = runSline({"jobs", file});
    QVERIFY2(finished.code == 0, finished.err.constData());
    for (const auto& [name, text] :
         {std::pair<QString, QByteArray>("a", words), {"b", "From the leaflet.\n"}}) {
      const QString alone = m_folder.filePath("alone.pdf");
      QCOMPARE(
          runSline({"export", m_sample, "--pdf", alone, "--sheet", "patient", "--text", text}).code,
          0);
      QCOMPARE(contents(m_folder.filePath("out/" + name + ".pdf")), contents(alone));
      QVERIFY(QFile::remove(alone));
    }
  }

  void valuesAreNoFlags_data() {
    QTest::addColumn<QByteArray>("job");  // in JSON; OUT is a file elsewhere
    QTest::newRow("several values")
        << QByteArray(R"("input": "sample", "svg": "out/a.svg", "only": "kidney; --png=OUT")");
    QTest::newRow("a list") << QByteArray(
        R"("input": "sample", "svg": "out/a.svg", "only": ["kidney", "--png=OUT"])");
    QTest::newRow("one value") << QByteArray(
        R"("input": "sample", "svg": "out/a.svg", "view": ["left", "--png=OUT"])");
    QTest::newRow("an input") << QByteArray(
        R"("input": ["sample", "--png=OUT"], "svg": "out/a.svg")");
    QTest::newRow("nothing before it")
        << QByteArray(R"("input": "sample", "svg": "out/a.svg", "title": "", "only": "--png=OUT")");
  }
  void valuesAreNoFlags() {
    QFETCH(QByteArray, job);
    QTemporaryDir elsewhere;
    // If the list lies in the working folder, its inputs' names are not made longer.
    const QString there = QDir::currentPath();
    QVERIFY(QDir::setCurrent(m_folder.path()));
    job.replace("OUT", elsewhere.filePath("a.png").toUtf8());
    list("[{" + job + "}]", "list.json");
    const Finished finished = runSline({"jobs", "list.json"});
    QVERIFY(QDir::setCurrent(there));
    // Either a job fails, or an input is not there.
    QVERIFY2(finished.code != 0 || finished.err.contains("--png="), finished.err.constData());
    QVERIFY(QDir(elsewhere.path()).isEmpty());
  }

  void linksLeadNowhereElse() {
    QTemporaryDir elsewhere;
    QDir(m_folder.path()).mkdir("out");
    QVERIFY(QFile::link(elsewhere.path(), m_folder.filePath("out/deep")));
    QVERIFY(QFile::link(elsewhere.filePath("new.svg"), m_folder.filePath("out/new.svg")));
    for (const QByteArray target : {"out/deep/a.svg", "out/new.svg"}) {
      const Finished finished = runSline({"jobs", list("input,svg\nsample," + target + "\n")});
      QCOMPARE(finished.code, 2);
      QVERIFY2(finished.err.contains("lies outside"), finished.err.constData());
    }
    QVERIFY(QDir(elsewhere.path()).isEmpty());
    // A link above the folder, or to a place in it, is allowed.
    QTemporaryDir another;
    QVERIFY(QFile::link(another.path(), m_folder.filePath("out/top")));
    QVERIFY(QDir(another.path()).mkdir("deep"));
    QVERIFY(QFile::link(another.filePath("deep"), another.filePath("same")));
    QCOMPARE(runSline({"jobs", list("input,svg\nsample,same/a.svg\n"), "--to",
                       m_folder.filePath("out/top")})
                 .code,
             0);
    QVERIFY(QFile::exists(another.filePath("deep/a.svg")));
  }

  /// Help and code know the same flags that have files as values.
  void filesAreKnown() {
    QStringList flags;
    for (const QByteArray& line : runSline({"export", "--help"}).out.split('\n'))
      if (line.startsWith("  --") && (line.contains(" FILE") || line.contains(" FOLDER")))
        flags << QString::fromUtf8(line).trimmed().section(' ', 0, 0);
    const QStringList targets{"--png",  "--tiff",    "--jpeg",        "--exr",    "--webp-picture",
                              "--jp2",  "--svg",     "--pdf",         "--glb",    "--mp4",
                              "--webp", "--gif",     "--anki",        "--frames", "--video",
                              "--pptx", "--page",    "--page-folder", "--moodle", "--qti",
                              "--h5p",  "--scorm12", "--scorm2004",   "--cmi5"};
    QStringList known = targets + QStringList{"--camera", "--text"};
    flags.sort();
    known.sort();
    QCOMPARE(flags, known);
    for (const QString& target : targets) {
      const QByteArray flag = target.mid(2).toUtf8();
      const Finished finished = runSline({"jobs", list("input," + flag + "\nsample,../x\n")});
      QVERIFY2(finished.err.contains("column " + flag + ": \"../x\" lies outside"),
               finished.err.constData());
    }
  }

  void otherFolder() {
    QTemporaryDir elsewhere;
    const QString file = list("input,svg,size-mm\nsample,deep/er/a.svg,24x18\n");
    QCOMPARE(runSline({"jobs", file, "--to", elsewhere.path()}).code, 0);
    QVERIFY(QFile::exists(elsewhere.filePath("deep/er/a.svg")));
  }

  void badLists_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("says");
    QTest::newRow("unknown flag") << QByteArray("input,svg,colour blind\nsample,out/a.svg,x\n")
                                  << QByteArray("line 2, column colour blind");
    QTest::newRow("no input") << QByteArray("svg\nout/a.svg\n") << QByteArray("line 2");
    QTest::newRow("no target") << QByteArray("input,view\nsample,left\n") << QByteArray("line 2");
    QTest::newRow("climbs out") << QByteArray("input,svg\nsample,out/a.svg\nsample,../a.svg\n")
                                << QByteArray("line 3, column svg");
    QTest::newRow("absolute") << QByteArray("input,svg\nsample,/a.svg\n")
                              << QByteArray("line 2, column svg");
    QTest::newRow("target twice") << QByteArray("input,svg\nsample,out/a.svg\nsample,out/./a.svg\n")
                                  << QByteArray("is written by line 2, column svg, too");
    QTest::newRow("film climbs out") << QByteArray("input,png,video\nsample,out/a.png,../a.gif\n")
                                     << QByteArray("line 2, column video");
    QTest::newRow("film twice") << QByteArray("input,gif,video\nsample,out/a.gif,out/b.gif\n")
                                << QByteArray("--video and --gif");
    QTest::newRow("another kind's ending") << QByteArray("input,mp4\nsample,out/a.gif\n")
                                           << QByteArray("out/a.gif: .gif is the ending");
    QTest::newRow("a package climbs out")
        << QByteArray("input,package,output\nsample,moodle,../a.xml\n")
        << QByteArray("line 2, column output");
    QTest::newRow("a package without a file") << QByteArray("input,png,package\nsample,a.png,qti\n")
                                              << QByteArray("--package qti names no file");
    QTest::newRow("a package's ending") << QByteArray("input,package,output\nsample,moodle,a.zip\n")
                                        << QByteArray("a.zip: .zip is the ending");
    QTest::newRow("neither yes nor no") << QByteArray("input,svg,bw\nsample,out/a.svg,perhaps\n")
                                        << QByteArray("line 2, column bw");
    QTest::newRow("help is no flag") << QByteArray("input,svg,help\nsample,out/a.svg,yes\n")
                                     << QByteArray("line 2, column help");
  }
  void badLists() {
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, says);
    const Finished finished = runSline({"jobs", list(text)});
    QCOMPARE(finished.code, 2);
    QVERIFY2(finished.err.contains(says), finished.err.constData());
    QVERIFY2(written().isEmpty(), "nothing is begun of a list that is faulty");
  }

  void wrongUse() {
    QCOMPARE(runSline({"jobs", m_folder.filePath("nowhere.csv")}).code, 2);
    QCOMPARE(runSline({"jobs", list("input,svg\nsample,out/a.svg\n"), "--shard", "5/4"}).code, 2);
    const QByteArray help = runSline({"jobs", "--help"}).out;
    QVERIFY(help.contains("SLURM_ARRAY_TASK_ID"));
    QVERIFY(help.contains("parallel -j"));
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::JobsCommandTest)
#include "jobs_command_test.moc"
