// SPDX-License-Identifier: Apache-2.0
// Tests drawing styles by name on the command line.
#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "model/look/drawing_styles.h"
#include "tests/cli/sline_process.h"
#include "tests/support/suite.h"

namespace sline::test {

class DrawingTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  QString m_sample = writeSample(m_folder.path());

  Pixels rendered(const QStringList& flags) {
    const QString file = m_folder.filePath("picture.png");
    QFile::remove(file);
    const Finished finished =
        runSline(QStringList{"render", m_sample, "-o", file, "--size", "200x160"} + flags);
    if (finished.code != 0)
      qWarning("%s", finished.err.constData());
    return finished.code == 0 ? readPicture(file) : Pixels{};
  }

 private slots:
  void eachDiffersAndHasItsGround() {
    std::vector<std::vector<unsigned char>> seen;
    for (const model::DrawingStyle& style : model::drawingStyles()) {
      const Pixels picture =
          rendered({"--drawing", QString::fromUtf8(style.id.data(), int(style.id.size()))});
      QVERIFY(!picture.rgba.empty());
      const int ground = picture.at(1, 1)[2];
      QCOMPARE(ground, style.background == "dark" ? 34 : style.background == "paper" ? 236 : 255);
      QVERIFY(std::find(seen.begin(), seen.end(), picture.rgba) == seen.end());
      seen.push_back(picture.rgba);
    }
    QVERIFY(rendered({}).rgba == seen.front());  // a plate
  }
  void flagsWin() {
    QCOMPARE(int(rendered({"--drawing", "lecture-hall", "--background", "white"}).at(1, 1)[2]),
             255);
    QVERIFY(rendered({"--drawing", "woodcut", "--gamma", "0"}).rgba !=
            rendered({"--drawing", "woodcut"}).rgba);
    QVERIFY(rendered({"--drawing", "woodcut", "--gamma", "0", "--pen", "1", "--line-variation", "0",
                      "--ink-color", "#ff0000"})
                .rgba == rendered({"--drawing", "even-pen", "--gamma", "0", "--pen", "1",
                                   "--ink-color", "#ff0000"})
                             .rgba);
  }
  void exportsToo() {
    // A note has an accent in colour, an even pen black alone.
    static const QRegularExpression colour("stroke=\"#(?!000000|ffffff)[0-9a-f]{6}\"");
    for (const auto& [style, coloured] :
         {std::pair("operating-note", true), std::pair("even-pen", false)}) {
      const QString file = m_folder.filePath("drawing.svg");
      const Finished finished = runSline({"export", m_sample, "--svg", file, "--drawing", style,
                                          "--line-variation", "0", "--marks", "off"});
      QVERIFY2(finished.code == 0, finished.err.constData());
      QFile svg(file);
      QVERIFY(svg.open(QIODevice::ReadOnly));
      QCOMPARE(QString::fromUtf8(svg.readAll()).contains(colour), coloured);
    }
  }
  void unknownNamesListAll() {
    const Finished finished =
        runSline({"render", m_sample, "-o", m_folder.filePath("none.png"), "--drawing", "fresco"});
    QCOMPARE(finished.code, 2);
    for (const model::DrawingStyle& style : model::drawingStyles())
      QVERIFY(finished.err.contains(QByteArray(style.id.data(), int(style.id.size()))));
    QVERIFY(!QFile::exists(m_folder.filePath("none.png")));
    QVERIFY(runSline({"render", "--help"}).out.contains("operating-note"));
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::DrawingTest)
#include "drawing_test.moc"
