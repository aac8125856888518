// SPDX-License-Identifier: Apache-2.0
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/sline_process.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

class AnnotateTest : public QObject {
  Q_OBJECT

 private slots:
  void init();
  void listsWhatItMade();
  void namesInOtherLanguages();
  void namesThatAreTheSame();
  void namesOfSeveral();
  void savedViewsGetThem();
  void removes();
  void refusals_data();
  void refusals();
  void drawsLabels();
  void modes();
  void sameOnEveryRun();
  void kinds();
  void distances_data();
  void distances();

 private:
  QString path(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
  QString scene() const { return path("sample.sline"); }
  QByteArray list() const { return runSline({"annotate", scene(), "--list"}).out; }
  Finished annotate(const QStringList& flags) const {
    return runSline(QStringList{"annotate", scene()} + flags);
  }
  Pixels rendered(const QStringList& flags) const;

  std::unique_ptr<QTemporaryDir> m_folder;
};

namespace {
/// Returns the number of pixels that differ.
int difference(const Pixels& a, const Pixels& b) {
  int count = 0;
  for (std::size_t i = 0; i + 3 < std::min(a.rgba.size(), b.rgba.size()); i += 4)
    count += std::equal(&a.rgba[i], &a.rgba[i] + 4, &b.rgba[i]) ? 0 : 1;
  return count;
}
}  // namespace

void AnnotateTest::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(m_folder->isValid());
  const QString sample = writeSample(m_folder->path());
  QCOMPARE(runSline({"import", sample, "-o", scene()}).code, 0);
  writeFile(path("camera.json"), frontCamera());
}

Pixels AnnotateTest::rendered(const QStringList& flags) const {
  const QString file = path("picture.png");
  QFile::remove(file);
  const Finished done =
      runSline(QStringList{"render", scene(), "-o", file, "--camera", path("camera.json")} +
               (flags.contains("--size") ? flags : flags + QStringList{"--size", "800x400"}));
  return done.code == 0 ? readPicture(file) : Pixels{};
}

void AnnotateTest::listsWhatItMade() {
  const Finished done =
      annotate({"--label", "Hilus <b>", "--on", "kidney", "--text", "de=Niere=links"});
  QCOMPARE(done.err, QByteArray());
  QCOMPARE(done.out, QByteArray("1\n"));
  QCOMPARE(list(), QByteArray("1\tlabel\tkidney\tHilus <b>\tde=Niere=links\n"));
  QCOMPARE(annotate({"--on", "kidney", "--label", "x", "--text", "zh-Hant=\xE8\x85\x8E", "--text",
                     "de-AT-1996=Niere"})
               .code,
           0);
}

void AnnotateTest::namesInOtherLanguages() {
  QCOMPARE(annotate({"--on", "kidney", "--on", "renal artery"}).out, QByteArray("1\n2\n"));
  const QByteArray listed = list();
  QVERIFY2(listed.contains("\tkidney\tkidney\tde=Niere\t"), listed);
  QVERIFY2(listed.contains("la=arteria renalis"), listed);
}

// A name that is the same in another language is known there, too; an unknown name is not.
void AnnotateTest::namesThatAreTheSame() {
  writeObj(path("sample/ureter.obj"), *sphere(10.0f, 3));
  writeObj(path("sample/blob.obj"), *sphere(12.0f, 3));
  QCOMPARE(runSline({"import", path("sample"), "-o", scene()}).code, 0);
  QCOMPARE(annotate({"--on", "ureter", "--on", "blob"}).code, 0);
  const QByteArray listed = list();
  QVERIFY2(listed.contains("\tureter\tureter\tde=Harnleiter\tla=ureter\t"), listed);
  QVERIFY2(listed.contains("\tblob\tblob\n"), listed);
}

/// A name that several structures have means none of them.
void AnnotateTest::namesOfSeveral() {
  const QString twice = path("twice.sline");
  QCOMPARE(runSline({"import", scene(), path("sample"), "-o", twice}).code, 0);
  const auto label = [&twice](const QStringList& on) {
    return runSline(QStringList{"annotate", twice} + on);
  };
  for (const QStringList& on :
       {QStringList{"--on", "kidney"},
        QStringList{"--on", "renal vein", "--to", "kidney", "--kind", "distance"}}) {
    const Finished refused = label(on);
    QVERIFY(refused.code != 0);
    QVERIFY2(refused.err.contains("names 2 structures, and one is meant: "), refused.err);
  }
  QCOMPARE(runSline({"annotate", twice, "--list"}).out, QByteArray());
}

// A saved view that left out no label shows those made later for all; what is made for one view no
// other shows. A new view takes what is no other's.
void AnnotateTest::savedViewsGetThem() {
  QCOMPARE(annotate({"--on", "kidney"}).code, 0);
  const auto view = [this](const QStringList& flags) {
    return runSline(QStringList{"view", scene()} + flags).code;
  };
  QCOMPARE(view({"--add", "All", "--from", "anterior", "--labels", "all"}), 0);
  QCOMPARE(view({"--add", "None", "--from", "anterior", "--labels", "none"}), 0);
  QCOMPARE(annotate({"--on", "renal artery"}).code, 0);
  QCOMPARE(annotate({"--on", "renal vein", "--view", "None"}).code, 0);
  QCOMPARE(
      annotate({"--label", "alone", "--on", "renal vein", "--view", "None", "--only-in-view"}).code,
      0);
  const QByteArray listed = runSline({"view", scene(), "--list", "--json"}).out;
  const QJsonArray views = QJsonDocument::fromJson(listed).object()["views"].toArray();
  QCOMPARE(views.at(0)["labels"].toArray(), QJsonArray({1, 2}));
  QCOMPARE(views.at(1)["labels"].toArray(), QJsonArray({3, 4}));
  QCOMPARE(view({"--add", "New", "--from", "left"}), 0);
  const QByteArray now = runSline({"view", scene(), "--list", "--json"}).out;
  QCOMPARE(QJsonDocument::fromJson(now).object()["views"].toArray().at(2)["labels"].toArray(),
           QJsonArray());
}

void AnnotateTest::removes() {
  QCOMPARE(annotate({"--on", "kidney", "--on", "renal artery"}).code, 0);
  QCOMPARE(annotate({"--remove", "1"}).code, 0);
  QVERIFY(list().startsWith("2\t"));
  QCOMPARE(annotate({"--on", "renal vein"}).out, QByteArray("3\n"));
}

void AnnotateTest::refusals_data() {
  QTest::addColumn<QStringList>("flags");
  QTest::addColumn<QByteArray>("says");
  QTest::newRow("nothing to do") << QStringList{} << QByteArray("--list");
  QTest::newRow("two things") << QStringList{"--list", "--on", "kidney"} << QByteArray("one of");
  QTest::newRow("unknown structure") << QStringList{"--on", "kidny"} << QByteArray("\"kidney\"");
  QTest::newRow("a group") << QStringList{"--on", "Vessels"} << QByteArray("renal artery");
  QTest::newRow("no place") << QStringList{"--label", "x"} << QByteArray("--on STRUCTURE");
  QTest::newRow("bad place") << QStringList{"--on", "kidney", "--at", "1,2"} << QByteArray("x,y,z");
  QTest::newRow("endless place") << QStringList{"--on", "kidney", "--at", "1,2,inf"}
                                 << QByteArray("x,y,z");
  QTest::newRow("one end") << QStringList{"--on", "kidney", "--kind", "distance", "--at", "0,0,0"}
                           << QByteArray("--to");
  QTest::newRow("unknown end") << QStringList{"--on",     "kidney", "--kind",
                                              "distance", "--to",   "kidny"}
                               << QByteArray("\"kidney\"");
  QTest::newRow("end of nothing") << QStringList{"--label", "x",        "--at", "0,0,0",
                                                 "--kind",  "distance", "--to", "kidney"}
                                  << QByteArray("--on");
  QTest::newRow("end of a label") << QStringList{"--on", "kidney", "--to", "0,0,0"}
                                  << QByteArray("two places");
  QTest::newRow("no language") << QStringList{"--on", "kidney", "--text", "Niere"}
                               << QByteArray("its language");
  for (const char* tag : {"xx_bad!", "d", "-de", "de-", "de--AT", "4d", "deutschland", ""})
    QTest::addRow("language '%s'", tag)
        << QStringList{"--on", "kidney", "--text", QString(tag) + "=foo"}
        << QByteArray("its language");
  QTest::newRow("a language twice")
      << QStringList{"--on", "kidney", "--text", "de=a", "--text", "de=b"}
      << QByteArray("two things in the language de");
  QTest::newRow("a language without words")
      << QStringList{"--on", "kidney", "--text", "de="} << QByteArray("no words");
  QTest::newRow("label without words")
      << QStringList{"--on", "kidney", "--label", ""} << QByteArray("--label has no words");
  QTest::newRow("label of spaces")
      << QStringList{"--on", "kidney", "--label", " \n"} << QByteArray("--label has no words");
  QTest::newRow("unknown view") << QStringList{"--on", "kidney", "--view", "front"}
                                << QByteArray("anterior");
  QTest::newRow("no saved view") << QStringList{"--on", "kidney", "--view", "left",
                                                "--only-in-view"}
                                 << QByteArray("no saved view");
  QTest::newRow("unknown number") << QStringList{"--remove", "7"} << QByteArray("--list");
}

void AnnotateTest::refusals() {
  QFETCH(QStringList, flags);
  QFETCH(QByteArray, says);
  QFile file(scene());
  QVERIFY(file.open(QIODevice::ReadOnly));
  const QByteArray before = file.readAll();
  const Finished done = annotate(flags);
  QCOMPARE(done.code, 2);
  QCOMPARE(done.out, QByteArray());
  QVERIFY2(done.err.contains(says), done.err);
  file.seek(0);
  QCOMPARE(file.readAll(), before);
}

void AnnotateTest::drawsLabels() {
  const QStringList none{"render", scene(), "-o", path("none.png")};
  QVERIFY(runSline(none + QStringList{"--labels", "on"}).err.contains("the scene has no labels"));
  QVERIFY(!runSline(none).err.contains("no labels"));
  QCOMPARE(annotate({"--label", "Seen from the front", "--on", "kidney"}).code, 0);
  const Pixels plain = rendered({});
  const Pixels labelled = rendered({"--labels", "on"});
  QVERIFY(!plain.rgba.empty() && !labelled.rgba.empty());
  const PixelBox before = drawnBox(plain);
  const PixelBox after = drawnBox(labelled);
  QVERIFY2(after.left < before.left - 60 || after.right > before.right + 60,
           "the text does not stand beside the anatomy");
  QCOMPARE(after.top, before.top);
  QCOMPARE(difference(plain, rendered({"--labels", "off"})), 0);
}

void AnnotateTest::modes() {
  // Places at different heights leave no doubt which label is above the other.
  QCOMPARE(annotate({"--on", "kidney", "--at", "-5,-28,10"}).code, 0);
  QCOMPARE(annotate({"--on", "renal artery", "--on", "renal vein"}).code, 0);
  const QStringList base{"render", scene(), "-o", path("p.png"), "--size", "400x200"};
  // Down the left side, then down the right one.
  const Finished numbers = runSline(base + QStringList{"--labels", "numbers"});
  QCOMPARE(numbers.out, QByteArray("1\tkidney\n2\trenal vein\n3\trenal artery\n"));
  // As large as the picture is taken to be, so that labels stand in the same places.
  const Finished exported = runSline({"export", scene(), "--svg", path("p.svg"), "--size-mm",
                                      "105.8333x52.9167", "--labels", "numbers"});
  QCOMPARE(exported.out, numbers.out);
  const Finished german = runSline(base + QStringList{"--labels", "numbers", "--language", "de"});
  QVERIFY2(german.out.startsWith("1\tNiere\n"), german.out);
  const Pixels blank = rendered({"--labels", "blank"});
  const Pixels german2 = rendered({"--labels", "blank", "--language", "de"});
  QVERIFY(!blank.rgba.empty());
  QVERIFY2(difference(blank, german2) == 0, "blank lines tell how long the words are");
  QVERIFY(difference(rendered({"--labels", "on"}),
                     rendered({"--labels", "on", "--language", "de"})) > 0);
  QCOMPARE(runSline(base + QStringList{"--labels", "some"}).code, 2);
}

void AnnotateTest::sameOnEveryRun() {
  QCOMPARE(annotate({"--on", "kidney", "--on", "renal artery"}).code, 0);
  const Pixels first = rendered({"--labels", "on"});
  const Pixels second = rendered({"--labels", "on"});
  QVERIFY(!first.rgba.empty());
  QCOMPARE(difference(first, second), 0);
  // The text scales with the picture, not with its pixels.
  const PixelBox small = drawnBox(first);
  const PixelBox large = drawnBox(rendered({"--labels", "on", "--size", "1600x800"}));
  QVERIFY(std::abs(large.right - 2 * small.right) <= 6);
  QVERIFY(std::abs(large.left - 2 * small.left) <= 6);
}

void AnnotateTest::kinds() {
  QCOMPARE(annotate({"--on", "kidney", "--kind", "callout"}).code, 0);
  QCOMPARE(annotate({"--label", "free", "--at", "0,-30,20", "--kind", "pin"}).code, 0);
  QCOMPARE(annotate({"--label", "wide", "--on", "kidney", "--kind", "distance", "--at", "-30,0,0",
                     "--to", "30,0,0"})
               .code,
           0);
  const QByteArray listed = list();
  QVERIFY2(listed.contains("2\tpin\t\tfree\n"), listed);
  // Both ends are on what was named.
  QVERIFY2(listed.contains("3\tdistance\tkidney\twide\tmm="), listed);
  QVERIFY(difference(rendered({}), rendered({"--labels", "on"})) > 500);
}

/// Returns the length that the list has for the only distance, mm; 0 where it has none.
double listedLength(const QByteArray& list) {
  const qsizetype at = list.indexOf("mm=");
  QByteArray length = at < 0 ? "0" : list.mid(at + 3).split('\n').front().split('\t').front();
  if (length.endsWith('?'))
    length.chop(1);  // a liver of 20 mm has perhaps another unit
  return length.toDouble();
}

void AnnotateTest::distances_data() {
  QTest::addColumn<QStringList>("flags");
  QTest::addColumn<double>("mm");
  // A ball of 10 mm about the origin, one of 5 mm at 40 mm to the left.
  QTest::newRow("between two structures") << QStringList{"--to", "tumour"} << 25.0;
  QTest::newRow("from a place on one")
      << QStringList{"--at", "0,-10,0", "--to", "tumour"} << std::sqrt(1700.0) - 5.0;
  QTest::newRow("between two places on one")
      << QStringList{"--at", "-30,0,0", "--to", "30,0,0"} << 20.0;
}

void AnnotateTest::distances() {
  QFETCH(QStringList, flags);
  QFETCH(double, mm);
  const QString file = path("liver.ply");
  const QString other = path("tumour.ply");
  writeMesh(file, *test::sphere(10.0f, 5));
  writeMesh(other, *test::moved(*test::sphere(5.0f, 5), 1.0f, {40.0f, 0.0f, 0.0f}));
  QCOMPARE(runSline({"import", file, other, "--smooth", "off", "-o", scene()}).code, 0);
  const Finished done = annotate(QStringList{"--kind", "distance", "--on", "liver"} + flags);
  QVERIFY2(done.code == 0, done.err);
  const QByteArray listed = list();
  QVERIFY2(std::abs(listedLength(listed) - mm) < 0.05, listed);
  QCOMPARE(listed.contains("liver – tumour"), flags.contains("tumour"));
}

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::AnnotateTest)
#include "annotate_test.moc"
