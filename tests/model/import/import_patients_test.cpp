// SPDX-License-Identifier: Apache-2.0
// Tests that files of two patients never become one scene in silence, whatever says whose they are,
// and that nothing of it is told, kept or written.
#include <QtTest>
#include <algorithm>
#include <array>

#include "model/import/plan/patients.h"
#include "model/import/plan/plan.h"
#include "model/import/plan/reload.h"
#include "model/import/plan/reload_patients.h"
#include "model/scene_file/scene_file.h"
#include "tests/model/import/dicom/written_images.h"
#include "tests/model/import/dicom/written_structures.h"
#include "tests/model/import/volumes/written_volumes.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

using Path = std::filesystem::path;

/// What a file says of whose it is; empty: nothing.
struct Said {
  QByteArray id = "7";
  QByteArray name = "DOE^JANE";
  QByteArray study = "1.2.3";
  QByteArray frame = "1.2.4";
};

void say(test::WrittenSet& set, const model::Tag& tag, const QByteArray& value) {
  for (test::WrittenElement& element : set)
    if (element.tag == tag)
      element.value = value;
}

void identify(test::WrittenSet& set, const Said& said) {
  say(set, {0x0010, 0x0020}, said.id);
  say(set, {0x0010, 0x0010}, said.name);
  say(set, {0x0020, 0x000d}, said.study);
  say(set, {0x0020, 0x0052}, said.frame);
}

QByteArray structures(const Said& said, const QByteArray& organ = "Liver",
                      const test::Manner& manner = {}) {
  test::WrittenSet set =
      test::structureSet({{organ, "ORGAN", {}, test::ball({0, 0, 0}, 50, -49, 2)}});
  identify(set, said);
  return test::dicomFile(set, manner);
}

/// Returns a structure set that says nowhere but in its list of frames in which its contours are.
QByteArray referring(const QByteArray& frame) {
  test::WrittenSet set =
      test::structureSet({{"Liver", "ORGAN", {}, test::ball({0, 0, 0}, 50, -49, 2)}});
  identify(set, {.frame = ""});
  const auto first = std::find_if(set.begin(), set.end(), [](const test::WrittenElement& element) {
    return element.tag.group == 0x3006;
  });
  set.insert(first,
             test::sequence({0x3006, 0x0010}, {{test::text({0x0020, 0x0052}, "UI", frame)}}));
  return test::dicomFile(set);
}

test::WrittenVolume cube() {
  return test::sampled({12, 12, 12}, glm::dmat4(1.0), [](const glm::dvec3& p) {
    return glm::all(glm::greaterThan(p, glm::dvec3(2.0))) &&
                   glm::all(glm::lessThan(p, glm::dvec3(9.0)))
               ? 1
               : 0;
  });
}

/// Returns an NRRD file with further keys in its header.
QByteArray nrrd(const QByteArray& keys) {
  QByteArray file = test::nrrdFile(cube(), "left-posterior-superior");
  return file.insert(file.indexOf("\n\n") + 1, keys);
}

QByteArray metaImage(const QByteArray& keys) {
  QByteArray file = test::metaImageFile(cube(), false);
  return file.insert(file.indexOf("ElementDataFile"), keys);
}

QByteArray stl() {
  return "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 90 0 0\nvertex 0 90 0\n"
         "endloop\nendfacet\nfacet normal 0 0 1\nouter loop\nvertex 0 0 9\nvertex 90 0 0\n"
         "vertex 0 90 0\nendloop\nendfacet\nendsolid\n";
}

using Files = QList<std::pair<QString, QByteArray>>;

std::vector<Path> written(const QTemporaryDir& folder, const Files& files) {
  std::vector<Path> inputs;
  for (const auto& [name, bytes] : files) {
    test::writeText(folder.filePath(name), bytes);
    if (!name.endsWith(".json"))
      inputs.emplace_back(folder.filePath(name).toStdString());
  }
  return inputs;
}

std::size_t structuresIn(const Scene& scene) {
  return scene.structuresBelow(rootId).size();
}

QString told(const ImportReport& report) {
  QString all;
  for (const ImportWarning& warning : report.warnings)
    all += QString::fromStdString(warning.file + ": " + warning.reason) + "\n";
  return all;
}

}  // namespace

class ImportPatientsTest : public QObject {
  Q_OBJECT
 private slots:
  void apart_data();
  void apart();
  void whereMarksStand_data();
  void whereMarksStand();
  void slicesOfTwo();
  void filesThatSayNothingGoWithAny();
  void onlyTheFirst();
  void nothingOfThemIsTold();
  void reloadStaysWithThePatient();
  void reloadComparesTheScenesTraces();
  void beginningsThatEndAnywhere();
};

void ImportPatientsTest::apart_data() {
  QTest::addColumn<Files>("files");
  QTest::addColumn<QString>("outcome");  // one, apart, perhaps apart, frames
  const auto row = [](const char* tag, const Files& files, const char* outcome) {
    QTest::newRow(tag) << files << QString(outcome);
  };
  const auto pair = [](const Said& a, const Said& b, const test::Manner& manner = {}) {
    return Files{{"a.dcm", structures(a, "Liver", manner)},
                 {"b.dcm", structures(b, "Spleen", manner)}};
  };
  const Said jane;
  row("one patient", pair(jane, jane), "one");
  row("another ID", pair(jane, {.id = "8"}), "apart");
  row("another name", pair(jane, {.name = "DOE^JOHN"}), "apart");
  row("another name, no ID", pair({.id = ""}, {.id = "", .name = "ROE^RICHARD"}), "apart");
  row("ID in one alone", pair({.id = ""}, jane), "one");
  row("name as others spell it", pair(jane, {.name = "Doe^Jane"}), "one");
  row("another study of one", pair(jane, {.study = "1.2.9"}), "one");
  row("another frame of one", pair(jane, {.study = "1.2.9", .frame = "1.2.8"}), "frames");
  row("two studies, nobody named",
      pair({.id = "", .name = ""}, {.id = "", .name = "", .study = "5"}), "perhaps apart");
  row("anonymous, two studies",
      pair({.id = "", .name = "Anonymous"}, {.id = "", .name = "ANONYMOUS", .study = "5"}),
      "perhaps apart");
  row("anonymous, one study", pair({.id = "", .name = ""}, {.id = "", .name = ""}), "one");
  row("frames alone", pair({"", "", "", "1.2.4"}, {"", "", "", "1.2.5"}), "perhaps apart");
  row("one frame alone", pair({"", "", "", "1.2.4"}, {"", "", "", "1.2.4"}), "one");
  row("nothing said", pair({"", "", "", ""}, {"", "", "", ""}), "one");
  row("implicit", pair(jane, {.id = "8"}, {.syntax = test::Syntax::implicitLittle}), "apart");
  row("big endian", pair(jane, {.id = "8"}, {.syntax = test::Syntax::explicitBig}), "apart");
  row("deflated", pair(jane, {.id = "8"}, {.syntax = test::Syntax::deflated}), "apart");
  row("open lengths", pair(jane, {.id = "8"}, {.openLengths = true}), "apart");
  row("no preamble", pair(jane, {.id = "8"}, {.preamble = false}), "apart");
  row("NRRD, words of DICOM",
      {{"a.nrrd", nrrd("0010|0020:=7\n")}, {"b.nrrd", nrrd("0010|0020:=8\n")}}, "apart");
  row("NRRD, names",
      {{"a.nrrd", nrrd("DICOM_0010_0010_Patient_Name:=DOE^JANE\n")},
       {"b.nrrd", nrrd("DICOM_0010_0010_Patient_Name:=ROE\n")}},
      "apart");
  row("NRRD of one", {{"a.nrrd", nrrd("PatientID:=7\n")}, {"b.nrrd", nrrd("PatientID:=7\n")}},
      "one");
  row("NRRD and DICOM", {{"a.nrrd", nrrd("PatientID:=8\n")}, {"b.dcm", structures(jane)}}, "apart");
  row("NRRD and DICOM of one", {{"a.nrrd", nrrd("PatientID:=7\n")}, {"b.dcm", structures(jane)}},
      "one");
  row("MetaImage",
      {{"a.mha", metaImage("PatientID = 7\n")}, {"b.mha", metaImage("PatientID = 8\n")}}, "apart");
  row("NIfTI with JSON",
      {{"a.json", R"({"PatientName":"DOE^JANE"})"},
       {"a.nii", test::niftiFile(cube())},
       {"b.json", R"({"PatientName":"ROE"})"},
       {"b.nii", test::niftiFile(cube())}},
      "apart");
  row("subjects of BIDS",
      {{"sub-01/sub-01_seg.nii", test::niftiFile(cube())},
       {"sub-02/sub-02_seg.nii", test::niftiFile(cube())}},
      "apart");
  row("one subject of BIDS",
      {{"sub-01/sub-01_a.nii", test::niftiFile(cube())},
       {"sub-01/sub-01_b.nii", test::niftiFile(cube())}},
      "one");
  row("anatomy called so", {{"sub-lingual_gland.stl", stl()}, {"sub-mental_vein.stl", stl()}},
      "one");
  // Nothing but names tells whose they are.
  row("persons before one organ",
      {{"Meier_Hans_liver.stl", stl()}, {"Schulz_Eva_liver.stl", stl()}}, "perhaps apart");
  row("persons before other organs",
      {{"Meier_Hans_liver.stl", stl()}, {"Schulz_Eva_spleen.stl", stl()}}, "one");
  row("folders of persons",
      {{"Meier_Hans/left_hip_bone.stl", stl()}, {"Schulz_Eva/left_hip_bone.stl", stl()}},
      "perhaps apart");
  row("versions of one organ", {{"liver_nnunet.stl", stl()}, {"liver_manual.stl", stl()}}, "one");
  row("one person", {{"Meier_liver.stl", stl()}, {"Meier_spleen.stl", stl()}}, "one");
  row("persons' folders with other organs",
      {{"Meier_Hans/left_femur.stl", stl()},
       {"Meier_Hans/sacrum.stl", stl()},
       {"Schulz_Eva/right_femur.stl", stl()},
       {"Schulz_Eva/urinary_bladder.stl", stl()}},
      "perhaps apart");
  row("structures that no table knows",
      {{"left_Area_Tempestas_nucleus.stl", stl()},
       {"right_Area_Tempestas_nucleus.stl", stl()},
       {"left_Reuniens_Perifasc_nucleus.stl", stl()},
       {"right_Reuniens_Perifasc_nucleus.stl", stl()}},
      "one");
  row("numbered patients", {{"patient01/sacrum.stl", stl()}, {"patient02/prostate.stl", stl()}},
      "perhaps apart");
  row("one numbered patient", {{"patient1/sacrum.stl", stl()}, {"patient01_prostate.stl", stl()}},
      "one");
  row("a woman's and a man's", {{"VH_F_Heart.stl", stl()}, {"VH_M_Liver.stl", stl()}},
      "perhaps apart");
  row("the same in other words",
      {{"3d-vh-m-trachea.stl", stl()}, {"female_pelvis/bladder.stl", stl()}}, "perhaps apart");
  row("two of one man", {{"VH_M_Pelvis.stl", stl()}, {"SBU_M_Intestine_Large.stl", stl()}}, "one");
  row("a letter that says no sex", {{"m_biceps.stl", stl()}, {"f_lata.stl", stl()}}, "one");
  row("subjects of BIDS, as surfaces", {{"sub-01_liver.stl", stl()}, {"sub-02_liver.stl", stl()}},
      "apart");
}

void ImportPatientsTest::apart() {
  QFETCH(Files, files);
  QFETCH(QString, outcome);
  const QTemporaryDir folder;
  const std::vector<Path> inputs = written(folder, files);
  const bool apart = outcome.contains("apart");
  const Patients patients = patientsAmong(inputs, {}, ScannerSlices::read);
  QCOMPARE(patients.several(), apart);
  QCOMPARE(patients.apart.size(), std::size_t(apart ? 2 : 0));
  QCOMPARE(patients.certain, outcome == "apart");
  if (apart && patients.byName)
    QCOMPARE(patients.apart.front().files.front().filename(), inputs.front().filename());
  const auto whole = std::array{Path(folder.path().toStdString())};
  for (const std::span<const Path> given :
       {std::span<const Path>(inputs), std::span<const Path>(whole)}) {
    const auto imported = importInputs(given, {});
    QCOMPARE(imported.ok(), !apart);
    QCOMPARE(planImport(given, {}).ok(), !apart);
    if (!apart) {
      QCOMPARE(told(imported->report).contains("frames of reference"), outcome == "frames");
      continue;
    }
    const QString error = QString::fromStdString(imported.error().text());
    QVERIFY2(error.contains("together on purpose"), qPrintable(error));
    QCOMPARE(error.contains("the names of the files tell of 2 bodies"), patients.byName);
    for (const Path& input : inputs)
      QVERIFY2(error.contains(QString::fromStdString(input.filename().string())),
               qPrintable(error));
  }
  const auto together = importInputs(inputs, {.patients = PatientsWanted::together});
  QVERIFY2(together.ok(), together.ok() ? "" : together.error().text().c_str());
  QCOMPARE(structuresIn(together->scene), inputs.size());
}

void ImportPatientsTest::whereMarksStand_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<QByteArray>("bytes");
  QTest::addColumn<QString>("found");  // i: ID, n: name, s: study, f: frame; for each patient
  const auto row = [](const char* tag, const char* file, const QByteArray& bytes,
                      const char* found) {
    QTest::newRow(tag) << QString(file) << bytes << QString(found);
  };
  QByteArray analyze(348, '\0');
  analyze.replace(283, 4, "QZX7");
  row("Analyze", "a.hdr", analyze, "i");
  QByteArray nifti = analyze;
  nifti.replace(344, 3, "ni1");
  row("NIfTI's pair", "a.hdr", nifti, "");
  row("MINC", "a.mnc",
      QByteArray("CDF\1", 4) + QByteArray("\0\0\0\x09", 4) + "full_name" + QByteArray(3, '\0') +
          QByteArray("\0\0\0\2\0\0\0\x08", 8) + "DOE^JANE",
      "n");
  const auto item = [](const char* attributes) {
    return QByteArray("<SubjectHierarchyItem id=\"3\" attributes=\"") + attributes + "\"/>";
  };
  row("3D Slicer", "a.mrml",
      item("Level^Patient|DICOM.PatientID^7|DICOM.PatientName^DOE^JANE|") + item("Level^Study|"),
      "in");
  row("3D Slicer, two", "a.mrml",
      item("Level^Patient|DICOM.PatientID^7|") + item("Level^Patient|DICOM.PatientID^8|"), "i i");
  row("studies and frames", "a.nrrd",
      "NRRD0004\n0020|000d:=1.2\nFrameOfReferenceUID:=1.3\n\nPatientID:=7\n", "sf");
  row("nobody", "a.nrrd", "NRRD0004\nPatientID:= Anonymized\nPatientName:=\n\n", "");
  row("structure set", "a.dcm", structures({}), "insf");
  row("no frame of its own", "a.dcm", structures({.frame = ""}), "ins");
  row("frame that a structure set refers to", "a.dcm", referring("1.9"), "insf");
  row("slice", "a.dcm", test::dicomFile(test::image({})), "insf");
}

void ImportPatientsTest::whereMarksStand() {
  QFETCH(QString, file);
  QFETCH(QByteArray, bytes);
  QFETCH(QString, found);
  const QTemporaryDir folder;
  test::writeText(folder.filePath(file), bytes);
  QStringList all;
  for (const PatientMarks& marks : patientMarks(folder.filePath(file).toStdString(), {}))
    all << QString(marks.id ? "i" : "") + (marks.name ? "n" : "") + (marks.study ? "s" : "") +
               (marks.frame ? "f" : "");
  QCOMPARE(all.join(' '), found);
}

void ImportPatientsTest::slicesOfTwo() {
  const QTemporaryDir folder;
  for (int i = 0; i < 6; ++i) {
    test::WrittenImage slice;
    slice.position = {0, 0, 2.0 * i};
    slice.series = i < 4 ? "1.5" : "1.6";
    test::WrittenSet set = test::image(slice);
    identify(set, i < 4 ? Said() : Said{.id = "8"});
    test::put(folder, QString("%1.dcm").arg(i), test::dicomFile(set));
  }
  const auto inputs = std::array{Path(folder.path().toStdString())};
  ImportOptions options{.thresholds = {{"bone", -900.0, {}}}};
  QVERIFY(!importInputs(inputs, options).ok());
  options.patients = PatientsWanted::first;
  const auto first = importInputs(inputs, options);
  QVERIFY2(first.ok(), first.ok() ? "" : first.error().text().c_str());
  QCOMPARE(told(first->report).count("is of another patient"), 2);
  QCOMPARE(structuresIn(first->scene), std::size_t(1));
}

void ImportPatientsTest::filesThatSayNothingGoWithAny() {
  const QTemporaryDir folder;
  const auto inputs = written(folder, {{"a.dcm", structures({})}, {"skin.stl", stl()}});
  const auto imported = importInputs(inputs, {});
  QVERIFY(imported.ok());
  QCOMPARE(structuresIn(imported->scene), std::size_t(2));
}

void ImportPatientsTest::onlyTheFirst() {
  const QTemporaryDir folder;
  const auto inputs = written(folder, {{"a.dcm", structures({})},
                                       {"b.dcm", structures({.id = "8"}, "Spleen")},
                                       {"c.dcm", structures({}, "Heart")},
                                       {"skin.stl", stl()}});
  const auto imported = importInputs(inputs, {.patients = PatientsWanted::first});
  QVERIFY(imported.ok());
  QCOMPARE(structuresIn(imported->scene), std::size_t(3));
  QVERIFY(test::named(imported->scene, "Spleen").name.empty());
  QVERIFY(told(imported->report).contains("b.dcm: is of another patient"));
  // What was decided is part of the plan.
  auto plan = planImport(inputs, {.patients = PatientsWanted::first});
  QVERIFY(plan.ok());
  plan->options.patients = PatientsWanted::together;
  const auto all = planAgain(*plan);
  QVERIFY(all.ok());
  QCOMPARE(structuresIn(all->scene), std::size_t(4));
}

void ImportPatientsTest::nothingOfThemIsTold() {
  const QTemporaryDir folder;
  const Said secret{"QZX7", "QZXDOE^JANE", "9.8.7.6", "9.8.7.5"};
  const auto inputs = written(
      folder, {{"a.dcm", structures(secret)}, {"b.dcm", structures({.id = "8"}, "Spleen")}});
  const auto refused = importInputs(inputs, {});
  QVERIFY(!refused.ok());
  const auto together = importInputs(inputs, {.patients = PatientsWanted::together});
  QVERIFY(together.ok());
  const Path saved = folder.filePath("scene.sline").toStdString();
  QVERIFY(writeSceneFile(saved, {together->scene, {}, {}, 0}).ok());
  QFile file(QString::fromStdString(saved.string()));
  QVERIFY(file.open(QIODevice::ReadOnly));
  QByteArray all = file.readAll();
  all += refused.error().text().c_str();
  all += told(together->report).toUtf8();
  for (const QByteArray& word : {secret.id, QByteArray("QZXDOE"), secret.study, secret.frame})
    QVERIFY2(!all.contains(word), word.constData());
}

/// Where no file is as it was, the scene still knows whose it is.
void ImportPatientsTest::reloadComparesTheScenesTraces() {
  const QTemporaryDir folder;
  const auto inputs = written(folder, {{"a.nrrd", nrrd("0020|000d:=1.2.3\n")}});
  const auto imported = importInputs(inputs, {});
  QVERIFY(imported.ok());
  QCOMPARE(imported->scene.traces().size(), std::size_t(1));
  test::writeText(folder.filePath("a.nrrd"), nrrd("0020|000d:=1.2.3\nnote:=new\n"));
  QVERIFY(reload(imported->scene, inputs).changed);
  QVERIFY(!patientsToReload(imported->scene, inputs).several());
  test::writeText(folder.filePath("a.nrrd"), nrrd("0020|000d:=1.2.9\n"));
  for (const PatientsWanted wanted : {PatientsWanted::one, PatientsWanted::first}) {
    const Reloaded other = reload(imported->scene, inputs, {}, wanted);
    QVERIFY(!other.changed);
    QCOMPARE(other.files.front().reason, std::string(otherPatientNow));
  }
  const Patients patients = patientsToReload(imported->scene, inputs);
  QCOMPARE(patients.apart.size(), std::size_t(2));
  QCOMPARE(patients.apart[0].files, std::vector<Path>{openSceneName});
  QCOMPARE(patients.apart[1].files.front().filename(), Path("a.nrrd"));
  const Reloaded together = reload(imported->scene, inputs, {}, PatientsWanted::together);
  QVERIFY(together.changed);
  QCOMPARE(together.scene.traces().size(), std::size_t(2));
}

void ImportPatientsTest::reloadStaysWithThePatient() {
  const QTemporaryDir folder;
  const auto inputs = written(
      folder, {{"a.nrrd", nrrd("PatientID:=7\n")}, {"b.nrrd", nrrd("PatientID:=7\nnote:=old\n")}});
  const auto imported = importInputs(inputs, {});
  QVERIFY(imported.ok());
  const auto fateOf = [](const Reloaded& reloaded, const char* name) {
    for (const ReloadedFile& file : reloaded.files)
      if (file.file == name)
        return file.fate;
    return ReloadedFile::Fate::absent;
  };
  test::writeText(folder.filePath("b.nrrd"), nrrd("PatientID:=8\n"));
  const Reloaded other = reload(imported->scene, inputs);
  QVERIFY(fateOf(other, "a.nrrd") == ReloadedFile::Fate::unchanged);
  QVERIFY(fateOf(other, "b.nrrd") == ReloadedFile::Fate::failed);
  QVERIFY(!other.changed);
  QVERIFY(reload(imported->scene, inputs, {}, PatientsWanted::together).changed);
  test::writeText(folder.filePath("b.nrrd"), nrrd("PatientID:=7\nnote:=newer\n"));
  QVERIFY(fateOf(reload(imported->scene, inputs), "b.nrrd") == ReloadedFile::Fate::replaced);
}

void ImportPatientsTest::beginningsThatEndAnywhere() {
  const QTemporaryDir folder;
  const QString path = folder.filePath("a.dcm");
  for (const test::Manner& manner : {test::Manner(), test::Manner{.openLengths = true}}) {
    const QByteArray whole = structures({}, "Liver", manner);
    for (qsizetype size = 1; size < std::min<qsizetype>(whole.size(), 1400); ++size) {
      test::writeText(path, whole.left(size));
      QVERIFY(patientMarks(path.toStdString(), {}).size() <= 1);
    }
    test::writeText(path, whole);
    const auto marks = patientMarks(path.toStdString(), {});
    QCOMPARE(marks.size(), std::size_t(1));
    QVERIFY(marks.front().id && marks.front().name && marks.front().study && marks.front().frame);
  }
}

SLINE_TEST(ImportPatientsTest)
#include "import_patients_test.moc"
