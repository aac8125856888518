// SPDX-License-Identifier: Apache-2.0
// Tests folders of DICOM files as they come from a hospital, and that no patient can be identified
// from them.
#include <QtTest>
#include <array>

#include "model/disk/zip_archive.h"
#include "model/import/plan/import.h"
#include "model/import/plan/plan.h"
#include "model/import/plan/read_inputs.h"
#include "model/scene_file/scene_file.h"
#include "tests/model/import/dicom/surface_facts.h"
#include "tests/model/import/dicom/written_images.h"
#include "tests/model/import/dicom/written_segmentation.h"
#include "tests/model/import/dicom/written_structures.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;

namespace {

using Path = std::filesystem::path;

void write(const QString& path, const QByteArray& bytes) {
  QDir().mkpath(QFileInfo(path).path());
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
    qFatal("cannot write %s", qPrintable(path));
}

QByteArray organs() {
  std::vector<WrittenRegion> regions;
  for (const char* name : {"Heart", "Cord", "Lung Left"})
    regions.push_back({name, "ORGAN", {}, ball({40, 0, 0}, 32, -31, 2)});
  for (const char* name : {"GTV", "PTV 60"})
    regions.push_back({name, "PTV", Colour{200, 10, 10}, ball({0, 0, 40}, 6, 35, 2)});
  regions.push_back({"Points", "MARKER", {}, {circle({0, 0, 0}, 2)}, "POINT"});
  return dicomFile(structureSet(regions));
}

QByteArray mask() {
  WrittenSegmentation written;
  written.segments = {{1, "Spleen", "Organ", {}}};
  for (int z = 0; z < 8; ++z)
    written.frames.push_back({1, {0, 0, 2.0 * z}, std::vector<std::uint8_t>(64, 1)});
  return dicomFile(segmentation(written));
}

QByteArray slice() {
  return dicomFile(identifying("1.2.840.10008.5.1.4.1.1.2"));
}

QString groupsOf(const model::Scene& scene) {
  QStringList names;
  for (const model::Node& node : scene.nodes())
    if (node.isGroup())
      names += QString::fromStdString(node.name);
  return names.join(", ");
}

QString told(const std::vector<model::ImportWarning>& warnings) {
  QString all;
  for (const model::ImportWarning& warning : warnings)
    all += QString::fromStdString(warning.file + ": " + warning.reason) + "\n";
  return all;
}

}  // namespace

class TestDicomImport : public QObject {
  Q_OBJECT
 private slots:
  void folderWithSlices();
  void contentTellsWhateverItIsCalled();
  void folderOfSlicesOnly();
  void slicesNamedOneByOne();
  void nothingOfThePatientStays();
  void planTellsTheSame();
  void slicesBecomeStructures();
  void planShowsTheScan();
};

void TestDicomImport::folderWithSlices() {
  const QTemporaryDir folder;
  for (int i = 0; i < 40; ++i)
    write(folder.filePath(QString("IM%1").arg(i, 4, 10, QChar('0'))), slice());
  write(folder.filePath("PLAN.dcm"), dicomFile(identifying("1.2.840.10008.5.1.4.1.1.481.5")));
  write(folder.filePath("RS0001"), organs());
  const auto imported = model::importInputs(std::array{Path(folder.path().toStdString())}, {});
  QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
  const QString text = told(imported->report.warnings);
  QVERIFY2(text.contains("40 CT images and 1 RT plan hold no segmentation"), qPrintable(text));
  QCOMPARE(imported->report.warnings.size(), std::size_t(2));  // the other one is about the points
  QCOMPARE(groupsOf(imported->scene), QString("Organs at risk, Targets"));
  QCOMPARE(imported->scene.structuresBelow(model::rootId).size(), std::size_t(5));
}

void TestDicomImport::contentTellsWhateverItIsCalled() {
  const QTemporaryDir folder;
  for (const char* name : {"a.seg", "b.label", "c.dicom"})
    write(folder.filePath(name), mask());
  write(folder.filePath("notes.seg"), QByteArray(400, 'x'));
  const auto imported = model::importInputs(std::array{Path(folder.path().toStdString())}, {});
  QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
  QCOMPARE(imported->scene.structuresBelow(model::rootId).size(), std::size_t(3));
  QVERIFY(!model::importInputs(std::array{Path(folder.filePath("notes.seg").toStdString())}, {}));
}

void TestDicomImport::folderOfSlicesOnly() {
  const QTemporaryDir folder;
  for (int i = 0; i < 3; ++i)
    write(folder.filePath(QString("%1.dcm").arg(i)), slice());
  const auto imported = model::importInputs(std::array{Path(folder.path().toStdString())}, {});
  QVERIFY(!imported.ok());
  QVERIFY2(imported.error().text().find("3 CT images hold no segmentation") != std::string::npos,
           imported.error().text().c_str());
}

void TestDicomImport::slicesNamedOneByOne() {
  const QTemporaryDir folder;
  std::vector<Path> inputs;
  for (int i = 0; i < 3; ++i) {
    const QString path = folder.filePath(QString("%1.dcm").arg(i));
    write(path, slice());
    inputs.emplace_back(path.toStdString());
  }
  const QString set = folder.filePath("set.dcm");
  write(set, organs());
  inputs.emplace_back(set.toStdString());
  const auto imported = model::importInputs(inputs, {});
  QVERIFY(imported.ok());
  QCOMPARE(imported->report.warnings.size(), std::size_t(2));
  QVERIFY(told(imported->report.warnings).contains("3 CT images hold no segmentation"));
}

void TestDicomImport::nothingOfThePatientStays() {
  const QTemporaryDir folder;
  // Exports name folders and files after patients and UIDs.
  write(folder.filePath("QZXNAME_QZXJANE/QZX.9.87.STUDY/RS.QZX.9.87.SOP.dcm"), organs());
  write(folder.filePath("QZXNAME_QZXJANE/QZX-PATIENTID/SEG.QZX.9.87.SOP.dcm"), mask());
  write(folder.filePath("QZXNAME_QZXJANE/QZX-PATIENTID/CT1.dcm"), slice());
  const auto imported =
      model::importInputs(std::array{Path(folder.filePath("QZXNAME_QZXJANE").toStdString())}, {});
  QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
  QCOMPARE(imported->scene.structuresBelow(model::rootId).size(), std::size_t(6));
  const Path saved = folder.filePath("scene.sline").toStdString();
  QVERIFY(model::writeSceneFile(saved, {imported->scene, {}, {}, 0}).ok());
  QFile file(QString::fromStdString(saved.string()));
  QVERIFY(file.open(QIODevice::ReadOnly));
  const QByteArray archive = file.readAll();
  const auto zip =
      model::ZipReader::open(std::string_view(archive.constData(), std::size_t(archive.size())));
  QVERIFY(zip.ok());
  QByteArray all = archive;
  for (const model::ZipReader::Entry& entry : zip->entries()) {
    const auto bytes = zip->read(entry);
    QVERIFY(bytes.ok());
    all += QByteArray::fromStdString(entry.name + "\n" + *bytes);
  }
  QVERIFY(all.contains("Lung Left"));
  for (const QByteArray& identity : identities())
    QVERIFY2(!all.contains(identity), identity.constData());
  // Three letters alone occur in a mesh's bytes by chance.
  for (const char* begun : {"QZXNAME", "QZX.9", "QZX-"})
    QVERIFY2(!all.contains(begun), begun);
  for (const model::ImportWarning& warning : imported->report.warnings)
    for (const QByteArray& identity : identities())
      QVERIFY2(warning.reason.find(identity.toStdString()) == std::string::npos,
               warning.reason.c_str());
}

void TestDicomImport::planTellsTheSame() {
  const QTemporaryDir folder;
  write(folder.filePath("set.dcm"), organs());
  const auto plan =
      model::planImport(std::array{Path(folder.filePath("set.dcm").toStdString())}, {});
  QVERIFY(plan.ok());
  QCOMPARE(groupsOf(plan->scene), QString("Organs at risk, Targets"));
  for (const model::NodeId id : plan->scene.structuresBelow(model::rootId)) {
    const model::Provenance& provenance = plan->scene.find(id)->provenance;
    QCOMPARE(provenance.file, std::string("DICOM structure set"));
    QCOMPARE(provenance.frame, std::string("LPS"));
    QCOMPARE(provenance.unitReason, std::string("DICOM: millimetres"));
  }
}

/// Writes a ball of bone in the patient's left, in ten slices, with a localizer of another series.
static void writeScan(const QTemporaryDir& folder) {
  for (int z = 0; z < 10; ++z) {
    WrittenImage slice;
    slice.columns = slice.rows = 16;
    slice.spacing = "2\\2";
    slice.position = {20, -16, 2.0 * z};
    slice.value = [z](int x, int y) {
      const int d = (x - 8) * (x - 8) + (y - 8) * (y - 8) + (z - 5) * (z - 5);
      return d <= 9 ? 1624 : 24;
    };
    write(folder.filePath(QString("QZXNAME/IM%1").arg(z, 4, 10, QChar('0'))),
          dicomFile(image(slice)));
  }
}

void TestDicomImport::slicesBecomeStructures() {
  const QTemporaryDir folder;
  writeScan(folder);
  model::ImportOptions options;
  options.thresholds = {{"bone", 300.0, {}}};
  options.keepScans = true;
  const auto imported = model::importInputs(std::array{Path(folder.path().toStdString())}, options);
  QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
  const model::Scene& scene = imported->scene;
  const std::vector<model::NodeId> all = scene.structuresBelow(model::rootId);
  QCOMPARE(all.size(), std::size_t(1));
  const model::Node& bone = *scene.find(all.front());
  const glm::vec3 centre = bone.mesh->bounds().centre();
  QVERIFY2(glm::length(centre - glm::vec3(36, 0, 10)) < 0.5f,
           qPrintable(QString("%1 %2 %3").arg(centre.x).arg(centre.y).arg(centre.z)));
  QCOMPARE(bone.provenance.file, std::string("CT"));
  QCOMPARE(scene.scans().size(), std::size_t(1));
  QVERIFY(scene.scans().front().hounsfield);
  QCOMPARE(scene.scans().front().spacing(), glm::dvec3(2.0));
  const auto bytes = model::sceneFileBytes({.scene = scene});
  QVERIFY(bytes.ok());
  QVERIFY(bytes->find("QZXNAME") == std::string::npos);
  QVERIFY2(!groupsOf(scene).contains("QZX"), qPrintable(groupsOf(scene)));
}

void TestDicomImport::planShowsTheScan() {
  const QTemporaryDir folder;
  writeScan(folder);
  const auto plan = model::planImport(std::array{Path(folder.path().toStdString())}, {});
  QVERIFY2(plan.ok(), plan.ok() ? "" : plan.error().text().c_str());
  QVERIFY(plan->read);
  QCOMPARE(plan->read->scans.size(), std::size_t(1));
  QCOMPARE(plan->read->scans.front().raw.file, std::string("CT"));
}

SLINE_TEST_WITH_EVENTS(TestDicomImport)
#include "test_dicom_import.moc"
