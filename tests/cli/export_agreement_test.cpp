// SPDX-License-Identifier: Apache-2.0
// Compares our vectors, as other programs draw them, with our own picture: the ink lies where ours
// does, and what lets something through blends as ours does.
#include <QDir>
#include <QFileInfo>
#include <QImage>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/blobs.h"
#include "tests/cli/ink_agreement.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

constexpr int width = 1280;
constexpr int height = 720;

}  // namespace

class ExportAgreementTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void inkLiesWhereOursDoes_data();
  void inkLiesWhereOursDoes();
  void blendsAsOursDoes_data();
  void blendsAsOursDoes();
  void theShadedAbdomenStaysHandy();
  void aPencilShowsThePaper();

 private:
  QTemporaryDir m_folder;
  void rasterise(const QString& file, const QString& png);
  QString m_rasteriser;
  QString m_pdfRasteriser;
};

void ExportAgreementTest::initTestCase() {
  m_rasteriser = QStandardPaths::findExecutable("rsvg-convert");
  if (m_rasteriser.isEmpty())
    SLINE_ABSENT("rsvg-convert is not installed");
  m_pdfRasteriser = QStandardPaths::findExecutable("pdftoppm");
  for (const char* name : {"kidney", "pelvis"})
    QCOMPARE(runSline({"demo", name, "-o", m_folder.filePath(QString(name) + ".sline")}).code, 0);
  const QString labelled = m_folder.filePath("labelled.sline");
  QVERIFY(QFile::copy(m_folder.filePath("pelvis.sline"), labelled));
  QStringList annotate{"annotate", labelled};
  for (const char* name : {"uterus", "urinary bladder", "sacrum", "left ureter", "right femur",
                           "sigmoid colon", "right ovary", "abdominal aorta", "left hip bone"})
    annotate << "--on" << name;
  QCOMPARE(runSline(annotate).code, 0);
}

void ExportAgreementTest::rasterise(const QString& file, const QString& png) {
  if (file.endsWith(".svg"))
    QCOMPARE(QProcess::execute(m_rasteriser, {"-w", QString::number(width), "-h",
                                              QString::number(height), file, "-o", png}),
             0);
  else
    QCOMPARE(QProcess::execute(m_pdfRasteriser,
                               {"-png", "-singlefile", "-scale-to-x", QString::number(width),
                                "-scale-to-y", QString::number(height), file, png.chopped(4)}),
             0);
}

void ExportAgreementTest::inkLiesWhereOursDoes_data() {
  QTest::addColumn<QString>("scene");
  QTest::addColumn<QStringList>("flags");
  const QString kidney = m_folder.filePath("kidney.sline");
  const QString pelvis = m_folder.filePath("pelvis.sline");
  const QString abdomen = SLINE_TEST_DATA "/abdomen/AbdominalAtlas-2015Sept-Slicer4-4Version.mrml";
  QTest::newRow("kidney, hatched") << kidney << QStringList{"--gamma", "3"};
  QTest::newRow("pelvis as it comes") << pelvis << QStringList{};
  QTest::newRow("pelvis with labels")
      << m_folder.filePath("labelled.sline") << QStringList{"--labels", "on", "--language", "la"};
  QTest::newRow("pelvis from behind, numbered")
      << m_folder.filePath("labelled.sline")
      << QStringList{"--labels", "numbers", "--view", "posterior", "--gamma", "1"};
  QTest::newRow("pelvis, silhouettes") << pelvis << QStringList{"--gamma", "0.5"};
  QTest::newRow("pelvis, without fill") << pelvis << QStringList{"--gamma", "2", "--fill", "none"};
  QTest::newRow("pelvis from the left, cut")
      << pelvis
      << QStringList{"--view", "left", "--gamma", "3", "--section", "sagittal", "--fill", "paper"};
  QTest::newRow("abdomen, hatched")
      << abdomen << QStringList{"--gamma", "3", "--fill", "paper", "--smooth", "off"};
  QTest::newRow("abdomen from behind, without fill")
      << abdomen << QStringList{"--gamma", "1", "--fill", "none", "--view", "posterior"};
}

void ExportAgreementTest::inkLiesWhereOursDoes() {
  QFETCH(QString, scene);
  QFETCH(QStringList, flags);
  if (!QFileInfo::exists(scene))
    SLINE_ABSENT("there is no real anatomy to draw");
  const QString png = m_folder.filePath("ours.png");
  const QString theirs = m_folder.filePath("theirs.png");
  const QString size = QString("%1x%2").arg(width).arg(height);
  const Finished drawn = runSline(
      QStringList{"render", scene, "-o", png, "--size", size, "--bw", "--marks", "on"} + flags);
  if (drawn.code != 0)
    QSKIP(("no picture can be drawn here: " + drawn.err).constData());
  const Pixels a = readPicture(png);
  for (const QString kind : {"svg", "pdf"}) {
    if (kind == "pdf" && m_pdfRasteriser.isEmpty())
      continue;
    // The page is as large as pictures are taken to be, so that labels are as large as well.
    const QString file = m_folder.filePath("ours." + kind);
    const Finished exported = runSline(QStringList{"export", scene, "--" + kind, file, "--size-mm",
                                                   "338.6667x190.5", "--bw", "--marks", "on"} +
                                       flags);
    QVERIFY2(exported.code == 0, exported.err.constData());
    QVERIFY(QFileInfo(file).size() <= 5'000'000);
    rasterise(file, theirs);
    const Pixels b = readPicture(theirs);
    QCOMPARE(b.width, a.width);
    QCOMPARE(b.height, a.height);
    const Agreement vectors = agreement(b, a);
    const Agreement picture = agreement(a, b);
    qInfo("%s: %d pixels of ink, %.2f %% near ours; %d in ours, %.2f %% near it; %lld kB",
          qPrintable(kind), vectors.ink, 100.0 * vectors.share, picture.ink, 100.0 * picture.share,
          QFileInfo(file).size() / 1000);
    QVERIFY(vectors.ink > 2000);
    QVERIFY(picture.ink > 2000);
    QVERIFY(vectors.share >= 0.95);
    QVERIFY(picture.share >= 0.95);
  }
}

void ExportAgreementTest::blendsAsOursDoes_data() {
  QTest::addColumn<QString>("scene");
  QTest::addColumn<QString>("fill");
  QTest::addColumn<QString>("gamma");
  const QString abdomen = SLINE_TEST_DATA "/abdomen/AbdominalAtlas-2015Sept-Slicer4-4Version.mrml";
  const QString pelvis = SLINE_TEST_DATA "/pelvis/bodyparts3d";
  for (const char* fill : {"none", "veil", "tint"})
    for (const char* gamma : {"3", "3.5"}) {
      const auto row = [&](const char* name, const QString& scene) {
        QTest::addRow("%s, %s, %s", name, fill, gamma) << scene << fill << gamma;
      };
      // Without any fill a dozen hatched surfaces of the made pelvis show through each other, more
      // than vectors of a handy size can tell.
      if (fill != QLatin1String("none"))
        row("made pelvis", m_folder.filePath("pelvis.sline"));
      row("pelvis", pelvis);
      row("abdomen", abdomen);
    }
}

void ExportAgreementTest::blendsAsOursDoes() {
  QFETCH(QString, scene);
  QFETCH(QString, fill);
  QFETCH(QString, gamma);
  if (!QFileInfo::exists(scene))
    SLINE_ABSENT("there is no real anatomy to draw");
  const QString png = m_folder.filePath("ours.png");
  const QStringList flags{"--look", "plain", "--gamma", gamma, "--fill", fill, "--marks", "off"};
  const Finished drawn = runSline(
      QStringList{"render", scene, "-o", png, "--size", QString("%1x%2").arg(width).arg(height)} +
      flags);
  if (drawn.code != 0)
    QSKIP(("no picture can be drawn here: " + drawn.err).constData());
  const Finished exported =
      runSline(QStringList{"export", scene, "--svg", m_folder.filePath("ours.svg"), "--pdf",
                           m_folder.filePath("ours.pdf"), "--size-mm", "338.6667x190.5"} +
               flags);
  QVERIFY2(exported.code == 0, exported.err.constData());
  const Pixels ours = readPicture(png);
  for (const QString kind : {"svg", "pdf"}) {
    if (kind == "pdf" && m_pdfRasteriser.isEmpty())
      continue;
    const QString file = m_folder.filePath("ours." + kind);
    const QString theirs = m_folder.filePath("theirs.png");
    QVERIFY(QFileInfo(file).size() <= 5'000'000);
    rasterise(file, theirs);
    const Pixels other = readPicture(theirs);
    QCOMPARE(other.width, ours.width);
    QCOMPARE(other.height, ours.height);
    const Blobs blobs = differingBlobs(other, ours);
    qInfo("%s: %d blobs, %.3f %%, at most %.2f; %lld kB", qPrintable(kind), blobs.count,
          100.0 * blobs.share, blobs.largest, QFileInfo(file).size() / 1000);
    QVERIFY(blobs.share <= 0.0005);
  }
}

/// A pencil on rough paper lays as much less ink in vectors as in the picture, and in places: it is
/// no paler pen.
void ExportAgreementTest::aPencilShowsThePaper() {
  struct Laid {
    double ink = 0.0;   ///< of all pixels, 1: black
    double dark = 0.0;  ///< the share of them that is nearly black
  };
  const auto laidOn = [](const QString& png) {
    const QImage image = QImage(png).convertToFormat(QImage::Format_Grayscale8);
    Laid laid;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const double ink = 1.0 - image.constScanLine(y)[x] / 255.0;
        laid.ink += ink;
        laid.dark += ink > 0.75 ? 1.0 : 0.0;
      }
    return laid;
  };
  std::map<QString, std::array<Laid, 2>> laid;
  for (const int pencil : {0, 1}) {
    const QStringList flags{"--look", "plain",   "--gamma",
                            "2",      "--bw",    "--marks",
                            "off",    "--grain", QString::number(pencil)};
    const QString scene = m_folder.filePath("kidney.sline");
    const QString file = m_folder.filePath("pencil.");
    const QString size = QString("%1x%2").arg(width).arg(height);
    const Finished drawn =
        runSline(QStringList{"render", scene, "-o", file + "png", "--size", size} + flags);
    QVERIFY2(drawn.code == 0, drawn.err.constData());
    const Finished exported = runSline(QStringList{"export", scene, "--svg", file + "svg", "--pdf",
                                                   file + "pdf", "--size-mm", "338.6667x190.5"} +
                                       flags);
    QVERIFY2(exported.code == 0, exported.err.constData());
    laid["picture"][std::size_t(pencil)] = laidOn(file + "png");
    for (const QString kind : {"svg", "pdf"}) {
      if (kind == "pdf" && m_pdfRasteriser.isEmpty())
        continue;
      rasterise(file + kind, m_folder.filePath("theirs.png"));
      laid[kind][std::size_t(pencil)] = laidOn(m_folder.filePath("theirs.png"));
    }
  }
  const auto left = [](const std::array<Laid, 2>& each) { return each[1].ink / each[0].ink; };
  const double ours = left(laid["picture"]);
  for (const auto& [kind, each] : laid) {
    qInfo("%s: a pencil leaves %.3f of the ink, %.3f of the black", qPrintable(kind), left(each),
          each[1].dark / each[0].dark);
    QVERIFY(left(each) < 0.95);
    QVERIFY(std::abs(left(each) - ours) < 0.06);
    QVERIFY(each[1].dark > 0.05 * each[0].dark);
  }
}

// The lines and rims of all structures show through each other.
void ExportAgreementTest::theShadedAbdomenStaysHandy() {
  const QString abdomen = SLINE_TEST_DATA "/abdomen/AbdominalAtlas-2015Sept-Slicer4-4Version.mrml";
  if (!QFileInfo::exists(abdomen))
    SLINE_ABSENT("there is no real anatomy to draw");
  const QString file = m_folder.filePath("open.svg");
  const Finished exported = runSline({"export", abdomen, "--svg", file, "--gamma", "3.5"});
  QVERIFY2(exported.code == 0, exported.err.constData());
  QVERIFY2(QFileInfo(file).size() <= 5'000'000,
           qPrintable(QString::number(QFileInfo(file).size())));
  QVERIFY(QFileInfo(file).size() >= 2'000'000);
}

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::ExportAgreementTest)
#include "export_agreement_test.moc"
