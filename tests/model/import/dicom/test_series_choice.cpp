// SPDX-License-Identifier: Apache-2.0
// Tests which slices make a volume: what is refused, that series are told apart, and that nothing
// of the patient is kept.
#include <QtTest>

#include "model/import/dicom/dicom.h"
#include "tests/model/import/dicom/written_images.h"
#include "tests/model/import/dicom/written_stacks.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;

namespace {

using Path = std::filesystem::path;

}  // namespace

class TestSeriesChoice : public QObject {
  Q_OBJECT
 private slots:
  void refusals_data();
  void refusals();
  void seriesAreToldApart();
  void nothingOfThePatient();
  void realSlices();
};

void TestSeriesChoice::refusals_data() {
  QTest::addColumn<std::function<void(std::vector<WrittenImage>&)>>("spoil");
  QTest::addColumn<QString>("message");
  using Slices = std::vector<WrittenImage>;
  using Spoil = std::function<void(Slices&)>;
  QTest::newRow("a slice is missing")
      << Spoil([](Slices& s) { s.erase(s.begin() + 2); }) << "not evenly spaced: two lie 5 mm";
  QTest::newRow("uneven") << Spoil([](Slices& s) { s[4].position.z += 0.4; })
                          << "not evenly spaced";
  QTest::newRow("one slice") << Spoil([](Slices& s) { s.resize(1); }) << "a single slice";
  QTest::newRow("none") << Spoil([](Slices& s) { s.clear(); }) << "no slices";
  QTest::newRow("two phases") << Spoil([](Slices& s) { s[3].position = s[2].position; })
                              << "lie where another one does";
  QTest::newRow("another size") << Spoil([](Slices& s) { s[3].rows = 14; }) << "16 × 14 pixels";
  QTest::newRow("turned") << Spoil([](Slices& s) { s[3].orientation = "0\\1\\0\\-1\\0\\0"; })
                          << "is turned or scaled otherwise";
  QTest::newRow("no orientation") << Spoil([](Slices& s) { s[3].orientation = ""; })
                                  << "does not say how it is turned";
  QTest::newRow("another series") << Spoil([](Slices& s) { s[3].series = "9.9"; })
                                  << "belongs to another series";
  QTest::newRow("another kind") << Spoil([](Slices& s) {
    s[0].sopClass = "1.2.840.10008.5.1.4.1.1.481.2";
  }) << "its content is of the kind RT dose";
  QTest::newRow("aside") << Spoil([](Slices& s) { s[2].position.x += 4; })
                         << "do not lie above each other";
}

void TestSeriesChoice::refusals() {
  QFETCH(std::function<void(std::vector<WrittenImage>&)>, spoil);
  QFETCH(QString, message);
  std::vector<WrittenImage> slices = stack();
  spoil(slices);
  const auto read = volumeOf(slices);
  QVERIFY(!read.ok());
  const QString text = QString::fromStdString(read.error().text());
  QVERIFY2(text.contains(message), qPrintable(text));
  QVERIFY(!read.error().remedy.empty());
}

void TestSeriesChoice::seriesAreToldApart() {
  const QTemporaryDir folder;
  std::vector<Path> all;
  WrittenImage scout;
  scout.series = "1.2.3";
  all.push_back(put(folder, "scout", dicomFile(image(scout))));
  for (const Path& path : files(folder, stack()))
    all.push_back(path);
  all.push_back(put(folder, "plan.dcm", dicomFile(identifying("1.2.840.10008.5.1.4.1.1.481.5"))));
  all.push_back(put(folder, "text.dcm", "no DICOM"));
  // The series' UID of a packed file is found as well, and that of one with a long beginning.
  WrittenImage mr;
  mr.sopClass = mrClass;
  mr.series = "1.2.4";
  all.push_back(put(folder, "deflated", dicomFile(image(mr), {Syntax::deflated})));
  mr.position.z = 3;
  WrittenSet longer = image(mr);
  longer.insert(longer.begin() + 4,
                WrittenElement{{0x0009, 0x1001}, "OB", QByteArray(200'000, 'x'), {}});
  all.push_back(put(folder, "long", dicomFile(longer)));
  const std::vector<model::DicomSeries> series = model::seriesIn(all, {});
  QCOMPARE(series.size(), std::size_t(3));
  QCOMPARE(series[0].files.size(), std::size_t(5));
  QCOMPARE(series[0].scanner, std::string("CT"));
  QCOMPARE(series[1].files.size(), std::size_t(2));
  QCOMPARE(series[1].scanner, std::string("MR"));
  QCOMPARE(series[2].files.size(), std::size_t(1));
  QVERIFY(model::readDicomSeries(series[0].files, {}).ok());
}

void TestSeriesChoice::nothingOfThePatient() {
  std::vector<WrittenImage> slices = stack();
  const auto good = volumeOf(slices);
  QVERIFY(good.ok());
  slices.erase(slices.begin() + 1);
  const auto bad = volumeOf(slices);
  QVERIFY(!bad.ok());
  for (const std::string& said :
       {good->name + good->frameReason + good->unitReason, bad.error().text()})
    for (const QByteArray& identity : identities())
      QVERIFY2(said.find(identity.toStdString()) == std::string::npos, said.c_str());
}

void TestSeriesChoice::realSlices() {
  const Path folder = std::string(SLINE_TEST_DATA) + "/formats/dicom";
  if (!std::filesystem::exists(folder / "ct.0.dcm"))
    SLINE_ABSENT("no such files");
  const std::array files{folder / "ct.0.dcm", folder / "ct_image.dcm", folder / "rtss.dcm"};
  const std::vector<model::DicomSeries> series = model::seriesIn(files, {});
  QCOMPARE(series.size(), std::size_t(2));
  const auto read = model::readDicomSeries(std::array{files[0]}, {});
  QVERIFY(!read.ok());
  QVERIFY2(read.error().reason.find("single slice") != std::string::npos,
           read.error().text().c_str());
}

SLINE_TEST_WITH_EVENTS(TestSeriesChoice)
#include "test_series_choice.moc"
