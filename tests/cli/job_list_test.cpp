// SPDX-License-Identifier: Apache-2.0
// Tests that lists of exports are understood or refused, and splits them into parts.
#include <QTest>

#include "app/cli/jobs/job_list.h"
#include "model/disk/paths_below.h"
#include "tests/support/mutator.h"
#include "tests/support/suite.h"

namespace sline::cli {

namespace {

QString described(const std::vector<Job>& jobs) {
  QStringList lines;
  for (const Job& job : jobs) {
    QStringList fields;
    for (const JobField& field : job.fields) {
      QStringList values;
      for (const std::string& value : field.values)
        values << QString::fromStdString(value);
      fields << QString::fromStdString(field.flag) + "=" + values.join('+');
    }
    lines << fields.join(' ');
  }
  return lines.join('|');
}

Result<std::vector<Job>> read(const QByteArray& text, bool json) {
  return json ? jobsOfJson(text.toStdString()) : jobsOfTable(text.toStdString());
}

}  // namespace

class JobListTest : public QObject {
  Q_OBJECT

 private slots:
  void understood_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<bool>("json");
    QTest::addColumn<QString>("jobs");
    const auto table = [](const char* name, const QByteArray& text, const char* jobs) {
      QTest::newRow(name) << text << false << QString::fromUtf8(jobs);
    };
    const auto json = [](const char* name, const QByteArray& text, const char* jobs) {
      QTest::newRow(name) << text << true << QString::fromUtf8(jobs);
    };
    table("plain", "input,svg\na,b\nc,d\n", "input=a svg=b|input=c svg=d");
    table("no last line break", "input,svg\na,b", "input=a svg=b");
    table("Windows", "\xef\xbb\xbfinput,svg\r\na,b\r\n", "input=a svg=b");
    table("old Mac", "input,svg\ra,b\rc,d", "input=a svg=b|input=c svg=d");
    table("semicolons", "input;svg\na;b,c\n", "input=a svg=b,c");
    table("tabs", "input\tsvg\na b\tc\n", "input=a b svg=c");
    table("quoted", "input,svg\n\"a,\"\"b\"\"\nc\",d\n", "input=a,\"b\"\nc svg=d");
    table("blank lines", "\n\ninput,svg\n\na,b\n,\n", "input=a svg=b");
    table("empty cells", "input,svg,bw\na,,yes\nb,c\n", "input=a bw=yes|input=b svg=c");
    table("headings as flags", " --Input , --SVG\na,b\n", "input=a svg=b");
    table("any script", "input,svg\n心/肝.obj,ß.svg\n", "input=心/肝.obj svg=ß.svg");
    json("plain", R"([{"input":"a","svg":"b"}])", "input=a svg=b");
    json("values", R"([{"input":["a","b"],"dpi":300,"bw":true,"view":null,"x":false}])",
         "input=a+b dpi=300 bw=");
  }
  void understood() {
    QFETCH(QByteArray, text);
    QFETCH(bool, json);
    QFETCH(QString, jobs);
    const auto list = read(text, json);
    QVERIFY2(list.ok(), list.ok() ? "" : list.error().text().c_str());
    QCOMPARE(described(*list), jobs);
  }

  void refused_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<bool>("json");
    QTest::addColumn<QString>("where");
    QTest::addColumn<QString>("reason");
    const auto row = [](const char* name, bool json, const QByteArray& text, const char* where,
                        const char* reason) {
      QTest::newRow(name) << text << json << where << reason;
    };
    row("nothing", false, "", "", "no jobs");
    row("heading alone", false, "input,svg\n", "", "no jobs");
    row("open quote", false, "input,svg\na,\"b\nc,d\n", "line 2, column 3", "never closed");
    row("after the quote", false, "input,svg\n\"a\"b,c\n", "line 2, column 4", "follows");
    row("too many cells", false, "input,svg\na,b\nc,d,e\n", "line 3, column 3", "more cells");
    row("column twice", false, "input,svg,SVG\na,b,c\n", "line 1, column 3", "two columns");
    row("column without a name", false, "input,,svg\na,b,c\n", "line 1, column 2", "no heading");
    row("no JSON", true, "[{\"input\":\n \"a\",}]", "line 2", "no JSON");
    row("no list", true, "{\"input\":\"a\"}", "", "no list");
    row("empty list", true, "[]", "", "no jobs");
    row("no object", true, "[{\"input\":\"a\"},3]", "job 2", "no object");
    row("no value", true, "[{\"input\":{\"a\":1}}]", "job 1, \"input\"", "no text");
    row("nested list", true, "[{\"input\":[[\"a\"]]}]", "job 1", "no text");
    row("where no object is", true, "[{\"input\":\"a\"},\n  3]", "job 2, line 2, column 3",
        "no object");
    row("where no value is", true, "[\n {\"x\": {\"input\": 1},\n  \"svg\": 2}]",
        "job 1, \"x\", line 2, column 3", "no text");
    row("after quotes and brackets", true, "[{\"a\":\"}],\\\"{[\"},\n{\"b\":[\",\",2],\"c\": []}]",
        "job 2, \"c\", line 2, column 14", "no text");
    row("characters are counted", true, "\xef\xbb\xbf[{\"ü\":\"心\",\"b\":{}}]",
        "job 1, \"b\", line 1, column 11", "no text");
    row("key twice", true, "[{\"svg\":\"a\",\n\"--SVG\":\"b\"}]",
        "job 1, \"--SVG\", line 2, column 1", "first in line 1, column 3");
    row("where no JSON is", true, "[{\"input\":\n \"a\" x}]", "line 2, column 6", "no JSON");
    row("characters of a table", false, "input,svg\n\"心\"b,c\n", "line 2, column 4", "follows");
  }
  void refused() {
    QFETCH(QByteArray, text);
    QFETCH(bool, json);
    QFETCH(QString, where);
    QFETCH(QString, reason);
    const auto list = read(text, json);
    QVERIFY(!list.ok());
    QVERIFY2(list.error().where.starts_with(where.toStdString()), list.error().text().c_str());
    QVERIFY2(list.error().reason.find(reason.toStdString()) != std::string::npos,
             list.error().text().c_str());
    QVERIFY(!list.error().remedy.empty());
  }

  void shards_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("good");
    for (const char* good : {"1/1", "3/16", "16/16"})
      QTest::newRow(good) << good << true;
    for (const char* bad : {"", "0/4", "5/4", "1/0", "-1/4", "1", "1/", "/4", "1/4x", "1.5/4",
                            "99999999999999999999/4", "1/99999999999999999999"})
      QTest::newRow(*bad ? bad : "empty") << bad << false;
  }
  void shards() {
    QFETCH(QString, text);
    QFETCH(bool, good);
    QCOMPARE(parseShard(text.toStdString()).ok(), good);
  }

  void partsTogetherAreAll() {
    for (const std::size_t count : {1, 2, 7, 40}) {
      std::vector<int> taken(23, 0);
      for (std::size_t index = 1; index <= count; ++index)
        for (std::size_t place = 0; place < taken.size(); ++place)
          taken[place] += Shard{index, count}.has(place) ? 1 : 0;
      QVERIFY(std::all_of(taken.begin(), taken.end(), [](int times) { return times == 1; }));
    }
  }

  void pathsThatStay_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<bool>("stays");
    for (const char* good : {"a.svg", "out/a.svg", "./a.svg", "out/../a.svg", "..a.svg", "心.svg"})
      QTest::newRow(good) << good << true;
    for (const char* bad : {"", "/a.svg", "../a.svg", "out/../../a.svg", "./..", ".", "out/.."})
      QTest::newRow(*bad ? bad : "empty") << bad << false;
  }
  void pathsThatStay() {
    QFETCH(QString, path);
    QFETCH(bool, stays);
    QCOMPARE(model::staysBelow(path.toStdString()), stays);
  }

  /// Any text gives either a list or an error with a remedy.
  void spoiltLists() {
    const QByteArray seeds[] = {
        "input,svg,view\n\"a,\"\"b\",out/c.svg,front\nd;e,f,\n",
        R"([{"input":"a","svg":"b","gamma":["liver=4",3],"bw":true},{"input":"心"}])"};
    // Characters that separate and nest are put where they do not belong.
    const auto put = [](test::Mutator& random, QByteArray& bytes, qsizetype at) {
      static const QByteArray marks = "[]{}\",:;\t\n\r\\\xef\xbf";
      bytes.insert(at, marks[qsizetype(random.below(std::size_t(marks.size())))]);
    };
    test::Mutator mutator(1, {put, put, put});
    for (int i = 0; i < 12000; ++i) {
      const bool json = i % 2 == 1;
      const QByteArray spoilt = mutator(seeds[json ? 1 : 0]);
      const auto list = read(spoilt, json);
      if (list.ok())
        QVERIFY(!list->empty());
      else
        QVERIFY2(!list.error().remedy.empty(), spoilt.constData());
    }
  }

  /// A megabyte of one repeated piece, as no author writes it, gives a list or an error within
  /// seconds.
  void hugeLists_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<bool>("json");
    constexpr qsizetype megabyte = 1'000'000;
    const auto row = [](const char* name, bool json, const QByteArray& head,
                        const QByteArray& piece) {
      QTest::newRow(name) << head + piece.repeated(megabyte / piece.size()) << json;
    };
    row("brackets", true, "", "[");
    row("objects", true, "", "{\"a\":");
    row("nested but whole", true, "", "[]");
    row("keys", true, "[{\"input\":1", ",\"svg\":2");
    row("jobs", true, "[3", ",{\"input\":1}");
    row("quotes", true, "[\"", "\\\"");
    row("cells", false, "", "a,");
    row("quoted cells", false, "input,svg\n", "\"\",");
    row("lines", false, "input\n", "a\n");
    row("never closed", false, "input\n\"", "\"\"");
    row("zeros", false, "", QByteArray(1, '\0'));
  }
  void hugeLists() {
    QFETCH(QByteArray, text);
    QFETCH(bool, json);
    const auto list = read(text, json);
    QVERIFY(list.ok() ? !list->empty() : !list.error().remedy.empty());
  }
};

}  // namespace sline::cli

SLINE_TEST_WITH_EVENTS(sline::cli::JobListTest)
#include "job_list_test.moc"
