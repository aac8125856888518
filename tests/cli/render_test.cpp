// SPDX-License-Identifier: Apache-2.0
#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/sline_process.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

class RenderTest : public QObject {
  Q_OBJECT

 private slots:
  void writesEveryKind_data();
  void writesEveryKind();
  void silentInAPipe();
  void fitsWithAMargin();
  void groupsHandDown();
  void innermostNameWins();
  void onlyDrawsWhatIsNamed();
  void focusFollowsTheAmount();
  void opensAsAPlate();
  void sidesStaySides_data();
  void sidesStaySides();
  void sectionsKeepTheirSide_data();
  void sectionsKeepTheirSide();
  void cameraFileIsFollowed();
  void inkHasItsColour();
  void blackAndWhite();
  void pensAndHatching();
  void keyLight();
  void samplesSmoothEdges();
  void demo();

 private:
  /// Renders the sample; the picture is empty if that failed.
  Pixels rendered(const QStringList& flags);
  QTemporaryDir m_folder;
  QString m_sample = writeSample(m_folder.path());
};

Pixels RenderTest::rendered(const QStringList& flags) {
  const QString file = m_folder.filePath("picture.png");
  QFile::remove(file);
  const Finished finished = runSline(QStringList{"render", m_sample, "-o", file} + flags);
  if (finished.code != 0)
    qWarning("%s", finished.err.constData());
  return finished.code == 0 ? readPicture(file) : Pixels{};
}

void RenderTest::writesEveryKind_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QString>("background");
  QTest::addColumn<int>("channels");
  QTest::newRow("png") << "a.png"
                       << "white" << 3;
  QTest::newRow("png, transparent") << "a.png"
                                    << "transparent" << 4;
  QTest::newRow("tiff") << "a.tiff"
                        << "paper" << 3;
  QTest::newRow("tif, transparent") << "a.tif"
                                    << "transparent" << 4;
  QTest::newRow("exr, transparent") << "a.exr"
                                    << "transparent" << 4;
  QTest::newRow("jpg") << "a.jpg"
                       << "dark" << 3;
  QTest::newRow("JPEG, transparent") << "a.JPEG"
                                     << "transparent" << 3;
}

void RenderTest::writesEveryKind() {
  QFETCH(QString, name);
  QFETCH(QString, background);
  QFETCH(int, channels);
  const QString file = m_folder.filePath(name);
  const Finished finished = runSline({"render", m_sample, "-o", file, "--size", "201x120",
                                      "--background", background, "--gamma", "5"});
  QVERIFY2(finished.code == 0, finished.err.constData());
  const Pixels picture = readPicture(file);
  QCOMPARE(picture.width, 201);
  QCOMPARE(picture.height, 120);
  QCOMPARE(picture.channels, channels);
  const PixelBox box = drawnBox(picture);
  QVERIFY(box.right - box.left > 100);
  // Nothing is left beside the picture.
  QCOMPARE(QDir(m_folder.path()).entryList({"*" + name + "*"}, QDir::Files | QDir::Hidden).size(),
           1);
  QFile::remove(file);
}

void RenderTest::silentInAPipe() {
  const Finished finished = runSline({"render", m_sample, "-o", m_folder.filePath("quiet.png"),
                                      "--size", "64x64", "--sides", "right"});
  QCOMPARE(finished.code, 0);
  QCOMPARE(finished.out, QByteArray());
  QCOMPARE(finished.err, QByteArray());
}

void RenderTest::fitsWithAMargin() {
  // The kidney alone is a ball, so its outline fills 90 % of the height of a wide picture.
  const PixelBox box =
      drawnBox(rendered({"--size", "400x300", "--only", "kidney", "--gamma", "0"}));
  QVERIFY2(std::abs(box.top - 15) <= 3, qPrintable(QString::number(box.top)));
  QVERIFY2(std::abs(box.bottom - 284) <= 3, qPrintable(QString::number(box.bottom)));
  QVERIFY(std::abs((box.left + box.right) - 399) <= 2);
}

void RenderTest::groupsHandDown() {
  const QStringList flags{"--size",  "400x200",        "--gamma", "5",
                          "--color", "Organs=#00ff00", "--color", "Vessels=#ff0000"};
  const Pixels picture = rendered(flags);
  const Tinted red = tinted(picture, 0);
  const Tinted green = tinted(picture, 1);
  QVERIFY(red.count > 200);
  QVERIFY(green.count > 1000);
  QVERIFY(std::abs(red.column - 199.5) < 3.0);  // both vessels, one on either side
  // Drawn as bare outlines they lose their colour; the other group keeps its own.
  const Pixels outlines = rendered(flags + QStringList{"--gamma", "Vessels=0"});
  QVERIFY(tinted(outlines, 0).count * 10 < red.count);
  QCOMPARE(tinted(outlines, 1).count, green.count);
}

void RenderTest::innermostNameWins() {
  const QStringList size{"--size", "400x200", "--gamma", "5", "--only", "Vessels"};
  const QStringList inner{"--color", "renal artery=#0000ff"};
  const QStringList outer{"--color", "VESSELS=#ff0000"};
  for (const QStringList& flags : {size + inner + outer, size + outer + inner}) {
    const Pixels picture = rendered(flags);
    QVERIFY(tinted(picture, 2).column > 300.0);  // the artery, at the patient's left
    QVERIFY(tinted(picture, 0).column < 100.0);
  }
}

void RenderTest::onlyDrawsWhatIsNamed() {
  const QStringList base{"--size",  "300x300", "--camera", m_folder.filePath("front.json"),
                         "--gamma", "1"};
  writeFile(m_folder.filePath("front.json"), frontCamera());
  const PixelBox all = drawnBox(rendered(base));
  const PixelBox kidney = drawnBox(rendered(base + QStringList{"--only", "kidney"}));
  const PixelBox vessels =
      drawnBox(rendered(base + QStringList{"--only", "renal artery", "renal vein"}));
  QVERIFY(kidney.right - kidney.left < all.right - all.left - 40);
  QCOMPARE(vessels.left, all.left);
  QVERIFY(vessels.bottom - vessels.top < all.bottom - all.top - 20);
}

void RenderTest::focusFollowsTheAmount() {
  writeFile(m_folder.filePath("front.json"), frontCamera());
  const QStringList base{"--size", "300x300", "--camera", m_folder.filePath("front.json")};
  const auto box = [&](const QString& names, const QString& amount) {
    return drawnBox(rendered(base + QStringList{"--focus", names, "--context", amount}));
  };
  const PixelBox all = drawnBox(rendered(base));
  const PixelBox alone = box("kidney", "0");
  QVERIFY(alone.right - alone.left < all.right - all.left - 40);
  QCOMPARE(box("kidney", "1").left, all.left);
  // Two names may stand in one text, and a group's name counts as well.
  QCOMPARE(box("renal artery,renal vein", "0").right, all.right);
  QCOMPARE(box("Vessels", "0").right, all.right);
  // A Γ that is given wins.
  const Pixels shaded = rendered(base + QStringList{"--focus", "kidney", "--context", "0"});
  const Pixels plain =
      rendered(base + QStringList{"--focus", "kidney", "--context", "0", "--gamma", "0"});
  QVERIFY(shaded.rgba != plain.rgba);
}

void RenderTest::opensAsAPlate() {
  // The kidney is the subject and shaded; of the plain drawing the lines alone are left.
  const auto coloured = [](const Pixels& picture) {
    int count = 0;
    for (std::size_t i = 0; i + 3 < picture.rgba.size(); i += 4)
      count += std::abs(int(picture.rgba[i]) - int(picture.rgba[i + 2])) > 20 ? 1 : 0;
    return count;
  };
  const Pixels plate = rendered({});
  const Pixels plain = rendered({"--look", "plain"});
  QVERIFY(!plate.rgba.empty() && !plain.rgba.empty());
  QVERIFY(coloured(plate) > plate.width * plate.height / 20);
  QCOMPARE(coloured(plain), 0);
  // What is said of all of it is taken for its look.
  QCOMPARE(rendered({"--gamma", "2"}).rgba, plain.rgba);
  QVERIFY(coloured(rendered({"--gamma", "renal vein=1"})) > plate.width * plate.height / 20);
  const Finished wrong =
      runSline({"render", m_sample, "-o", m_folder.filePath("x.png"), "--look", "nice"});
  QCOMPARE(wrong.code, 2);
  QVERIFY(wrong.err.contains("--look"));
}

void RenderTest::sidesStaySides_data() {
  QTest::addColumn<QString>("view");
  QTest::addColumn<bool>("leftAtRight");  // the patient's left at the right of the picture
  QTest::newRow("anterior") << "anterior" << true;
  QTest::newRow("posterior") << "posterior" << false;
  QTest::newRow("superior") << "superior" << false;
  QTest::newRow("inferior") << "inferior" << true;
}

void RenderTest::sidesStaySides() {
  QFETCH(QString, view);
  QFETCH(bool, leftAtRight);
  const Pixels picture = rendered({"--size", "400x200", "--gamma", "5", "--view", view, "--color",
                                   "renal artery=#ff0000", "--only", "Vessels"});
  const Tinted artery = tinted(picture, 0);
  QVERIFY(artery.count > 100);
  QCOMPARE(artery.column > 200.0, leftAtRight);
}

void RenderTest::sectionsKeepTheirSide_data() {
  QTest::addColumn<QString>("section");
  QTest::addColumn<QString>("view");
  QTest::addColumn<bool>("artery");  // at the patient's left
  QTest::addColumn<bool>("vein");    // at the patient's right
  QTest::newRow("left kept") << "sagittal=0:left"
                             << "anterior" << true << false;
  QTest::newRow("right kept") << "sagittal=0:right"
                              << "anterior" << false << true;
  QTest::newRow("seen from the right") << "sagittal=0"
                                       << "right" << true << false;
  QTest::newRow("seen from the left") << "sagittal=0"
                                      << "left" << false << true;
  QTest::newRow("by its equation") << "-2,0,0,0"
                                   << "posterior" << true << false;
  QTest::newRow("both halved") << "coronal"
                               << "anterior" << true << true;
}

void RenderTest::sectionsKeepTheirSide() {
  QFETCH(QString, section);
  QFETCH(QString, view);
  QFETCH(bool, artery);
  QFETCH(bool, vein);
  const Pixels picture =
      rendered({"--size", "300x200", "--gamma", "5", "--color", "renal artery=#ff0000", "--color",
                "renal vein=#0000ff", "--only", "Vessels", "--view", view, "--section", section,
                "--section-faces", "tint"});
  QCOMPARE(tinted(picture, 0).count > 100, artery);
  QCOMPARE(tinted(picture, 2).count > 100, vein);
}

void RenderTest::cameraFileIsFollowed() {
  // The camera is parallel and 100 mm high: a ball of radius 30 takes 60 % of the height.
  writeFile(m_folder.filePath("parallel.json"),
            R"({"projection":"orthographic","eye":[0,-400,0],"target":[0,0,0],"up":[0,0,1],)"
            R"("height_mm":100})");
  const PixelBox box = drawnBox(rendered({"--size", "400x400", "--only", "kidney", "--gamma", "0",
                                          "--camera", m_folder.filePath("parallel.json")}));
  QVERIFY2(std::abs((box.bottom - box.top + 1) - 240) <= 4,
           qPrintable(QString::number(box.bottom - box.top)));
}

void RenderTest::inkHasItsColour() {
  const QStringList base{"--size", "400x200", "--gamma", "1", "--line-variation", "0"};
  QCOMPARE(tinted(rendered(base), 0).count, 0);
  const Pixels one = rendered(base + QStringList{"--ink-colour", "renal artery=#ff0000"});
  QVERIFY(tinted(one, 0).count > 40);
  QVERIFY(tinted(one, 0).column > 300.0);
  const Pixels all =
      rendered(base + QStringList{"--ink-color", "#0000ff", "--ink-color", "Vessels=#ff0000"});
  QVERIFY(tinted(all, 2).count > 100);
  QVERIFY(std::abs(tinted(all, 0).column - 199.5) < 3.0);
}

void RenderTest::blackAndWhite() {
  // Shaded balls in colour become outlines and strokes in black; the kidney still hides the ball
  // behind it, of which the kidney's lit side would show the shadow.
  writeFile(m_folder.filePath("side.json"),
            R"({"projection":"orthographic","eye":[-400,0,0],"target":[0,0,0],"up":[0,0,1],)"
            R"("height_mm":100})");
  const QStringList base{"--size",  "200x200",       "--camera", m_folder.filePath("side.json"),
                         "--gamma", "kidney=5",      "--gamma",  "Vessels=4.5",
                         "--only",  "kidney",        "--only",   "renal artery",
                         "--color", "kidney=#ff0000"};
  QVERIFY(tinted(rendered(base), 0).count > 3000);
  const Pixels printed = rendered(base + QStringList{"--bw"});
  QCOMPARE(tinted(printed, 0).count, 0);
  const auto inkWithin = [&](int radius, bool lit) {
    int dark = 0;
    for (int y = 0; y < 200; ++y)
      for (int x = 0; x < 200; ++x)
        dark += std::hypot(x - 99.5, y - 99.5) < radius && (x + y < 199) == lit &&
                printed.at(x, y)[0] < 250;
    return dark;
  };
  QCOMPARE(inkWithin(50, true), 0);
  QVERIFY(inkWithin(70, true) > 100);
  QVERIFY(inkWithin(50, false) > 200);
}

void RenderTest::pensAndHatching() {
  const QStringList base{"--size", "300x300", "--only", "kidney", "--gamma", "3"};
  const auto ink = [&](const QStringList& flags) {
    const Pixels picture = rendered(base + flags);
    double sum = 0.0;
    for (int y = 0; y < 300; ++y)
      for (int x = 0; x < 300; ++x)
        sum += 255.0 - picture.at(x, y)[0];
    return sum;
  };
  const double usual = ink({});
  QVERIFY(ink({"--hatch-tone", "0"}) < 0.9 * usual);
  QVERIFY(ink({"--hatch-tone", "1.6"}) > 1.1 * usual);
  QVERIFY(std::abs(ink({"--hatch-density", "2"}) / usual - 1.0) < 0.1);
  QVERIFY(ink({"--pen", "2"}) > 1.05 * usual);
  // The tone is set for another structure.
  QCOMPARE(ink({"--hatch-tone", "Vessels=0"}), usual);
  QCOMPARE(ink({"--hatch-tone", "0", "--hatch-tone", "kidney=1"}), usual);
}

void RenderTest::keyLight() {
  const QStringList base{"--size", "200x200", "--only", "kidney", "--gamma", "5"};
  const auto difference = [](const Pixels& p) {
    return int(p.at(70, 70)[0]) - int(p.at(130, 130)[0]);
  };
  QVERIFY(std::abs(difference(rendered(base))) <= 2);
  QVERIFY(difference(rendered(base + QStringList{"--key-light"})) > 30);
}

void RenderTest::samplesSmoothEdges() {
  const QStringList base{"--size", "160x120", "--gamma", "5", "--samples"};
  const Pixels fine = rendered(base + QStringList{"4"});
  const auto distance = [&](const QString& samples) {
    const Pixels picture = rendered(base + QStringList{samples});
    double sum = 0.0;
    for (std::size_t i = 0; i < fine.rgba.size(); ++i)
      sum += std::abs(int(fine.rgba[i]) - int(picture.rgba[i]));
    return sum;
  };
  QCOMPARE(fine.width, 160);
  QVERIFY(distance("2") < 0.6 * distance("1"));
  QCOMPARE(distance("auto"), distance("2"));
}

void RenderTest::demo() {
  const QString file = m_folder.filePath("kidney.png");
  const Finished finished = runSline({"demo", "kidney", "-o", file, "--size", "320x200"});
  QVERIFY2(finished.code == 0, finished.err.constData());
  QVERIFY(drawnBox(readPicture(file)).bottom > 100);
}

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::RenderTest)
#include "render_test.moc"
