// SPDX-License-Identifier: Apache-2.0
// METHOD's limits on real anatomy: the way from silhouette to shaded surface is seamless (§7), its
// tone holds (§6.9), and strokes are steadier than hatching as printed (§6.10) with definite edges
// (§6.8).
#include <QtTest>
#include <map>

#include "model/import/import.h"
#include "render/gpu/headless/context.h"
#include "render/measures/ramp.h"
#include "render/measures/steadiness.h"
#include "render/measures/subject.h"

using namespace sline;

class OrgansTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void rampIsSeamless_data() { organs(); }
  void rampIsSeamless();
  void strokesAreSteady_data() { organs(); }
  void strokesAreSteady();

 private:
  static void organs();
  static QString path(const QString& file) { return QString(SLINE_TEST_DATA) + "/" + file; }
  /// The scene of a file of the test data, read once; null where it cannot be read.
  const model::Scene* sceneOf(const QString& file);

  std::unique_ptr<render::gpu::HeadlessContext> m_context;
  std::unique_ptr<render::Picture> m_picture;
  std::map<QString, model::Scene> m_scenes;
};

namespace {

// Above 360 rows a pen is wider than a pixel, and its width can jump where its opacity does not.
constexpr int rampHeight = 480;
constexpr int steadyHeight = 360;
constexpr float aspect = 4.0f / 3.0f;
constexpr int frames = 3;

render::Subject subjectOf(const model::Scene& scene, model::NodeId structure, int height) {
  render::Subject subject{.scene = render::alone(scene, structure),
                          .width = int(aspect * float(height)),
                          .height = height};
  const model::Mesh& mesh = *subject.structure().mesh;
  subject.camera =
      model::fitted(model::anatomicalCamera(model::AnatomicalView::anterior, mesh.bounds(), aspect),
                    mesh.positions(), aspect);
  return subject;
}

QByteArray listed(const std::vector<std::string>& faults) {
  QByteArray text;
  for (const std::string& fault : faults)
    text += QByteArray::fromStdString(fault) + "; ";
  return text;
}

}  // namespace

void OrgansTest::organs() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<QString>("name");
  const QString abdomen = "abdomen/AbdominalAtlas-2015Sept-Slicer4-4Version.mrml";
  const QString pelvis = "pelvis/bodyparts3d/";
  QTest::newRow("liver") << abdomen << "liver";
  QTest::newRow("right kidney") << abdomen << "right kidney";
  QTest::newRow("stomach") << abdomen << "stomach and duodenum";
  QTest::newRow("spleen") << abdomen << "spleen";
  QTest::newRow("pancreas") << abdomen << "pancreas";
  QTest::newRow("aorta") << abdomen << "aorta";
  QTest::newRow("hip bone") << pelvis + "FJ3152_FMA16586_right_hip_bone.obj"
                            << "right hip bone";
  QTest::newRow("sacrum") << pelvis + "FJ3393_FMA16202_sacrum.obj"
                          << "sacrum";
  QTest::newRow("bladder") << pelvis + "FJ3149_FMA15900_urinary_bladder.obj"
                           << "urinary bladder";
  QTest::newRow("left ventricle") << "misc/hra/VH_F_Heart.glb"
                                  << "left ventricle";
}

void OrgansTest::initTestCase() {
  auto context = render::gpu::HeadlessContext::create();
  if (!context.ok())
    QSKIP(context.error().text().c_str());
  m_context = std::move(*context);
  auto picture = render::Picture::create();
  QVERIFY2(picture.ok(), picture.ok() ? "" : picture.error().text().c_str());
  m_picture = std::move(*picture);
}

const model::Scene* OrgansTest::sceneOf(const QString& file) {
  if (const auto known = m_scenes.find(file); known != m_scenes.end())
    return &known->second;
  const std::vector<std::filesystem::path> inputs{path(file).toStdString()};
  auto imported = model::importInputs(inputs, {});
  return imported.ok() ? &(m_scenes[file] = std::move(imported->scene)) : nullptr;
}

void OrgansTest::rampIsSeamless() {
  QFETCH(QString, file);
  QFETCH(QString, name);
  if (!QFile::exists(path(file)))
    QSKIP("there is no such anatomy here");
  const model::Scene* scene = sceneOf(file);
  QVERIFY(scene);
  const auto structures = scene->named(name.toStdString());
  QCOMPARE(structures.size(), std::size_t(1));
  const render::Subject subject = subjectOf(*scene, structures.front(), rampHeight);
  const auto ramp = render::measureRamp(render::rampPictures(*m_picture, subject));
  QVERIFY2(ramp.ok(), ramp.ok() ? "" : ramp.error().text().c_str());
  const std::vector<std::string> faults = render::faults(*ramp);
  QVERIFY2(faults.empty(), listed(faults).constData());
}

void OrgansTest::strokesAreSteady() {
  QFETCH(QString, file);
  QFETCH(QString, name);
  if (!QFile::exists(path(file)))
    QSKIP("there is no such anatomy here");
  const model::Scene* scene = sceneOf(file);
  QVERIFY(scene);
  const auto structures = scene->named(name.toStdString());
  QCOMPARE(structures.size(), std::size_t(1));
  const render::Subject subject = subjectOf(*scene, structures.front(), steadyHeight);
  const Gamma hatched = Gamma::clamped(3.0f);
  const std::array<render::HatchingPicture, 2> ways{
      hatchingPicture(*m_picture, subject, hatched, render::HatchingMethod::strokes),
      hatchingPicture(*m_picture, subject, hatched, render::HatchingMethod::asPrinted)};
  const auto flickers = render::measureFlicker({.mesh = subject.structure().mesh,
                                                .camera = subject.camera,
                                                .width = subject.width,
                                                .height = subject.height,
                                                .frames = frames},
                                               ways);
  QVERIFY2(flickers.ok(), flickers.ok() ? "" : flickers.error().text().c_str());
  if (!flickers->front().anyHatching() && !flickers->back().anyHatching())
    QSKIP("it has no hollow that hatching would show from here");
  const std::vector<std::string> faults =
      render::faults({.strokes = flickers->front(), .asPrinted = flickers->back()});
  QVERIFY2(faults.empty(), listed(faults).constData());
}

QTEST_GUILESS_MAIN(OrgansTest)
#include "organs_test.moc"
