// SPDX-License-Identifier: Apache-2.0
// Tests that every kind of file that a scene can be exported to is written, or refused in words, in
// little time and memory, whatever the scale: a body of 100 km, a camera as near as one can be or
// as far, a thousand specks beside one large body.
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>

#include "model/edit/sections.h"
#include "render/export/formats/export_formats.h"
#include "render/export/motion/film_options.h"
#include "tests/support/process_memory.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {
namespace {

using model::Camera;
using model::Scene;

/// The most that one file may take, MiB.
constexpr double mostMemory = 1500.0;

void add(Scene& scene, const char* name, const model::MeshPtr& mesh) {
  scene.append({.name = name, .style = {.gamma = Gamma::clamped(3.5f)}, .mesh = mesh});
}

Camera orthographic(const glm::vec3& eye, float height) {
  Camera camera{.eye = eye, .target = {}, .up = {0.0f, 0.0f, 1.0f}};
  camera.projection = model::Projection::orthographic;
  camera.heightMm = height;
  return camera;
}

/// Adds a view from there, one of the whole scene, a label and a cut with patterns.
Scene with(Scene scene, const Camera& camera) {
  const model::NodeId body = scene.nodes().front().id;
  scene.appendAnnotation(
      {.anchors = {model::SurfacePoint{body, 0, {0.3f, 0.3f}}}, .text = "femur"});
  const Camera whole =
      model::anatomicalCamera(model::AnatomicalView::anterior, scene.visibleBounds(), 4.0f / 3.0f);
  model::Section section =
      model::anatomicalSection(scene, model::rootId, model::AnatomicalView::left, 0.5f);
  section.faces = model::CutFaces::tissue;
  scene.appendSection(section);
  scene.setViews({{.name = "whole", .camera = whole}, {.name = "there", .camera = camera}});
  return scene;
}

Scene ball() {
  Scene scene;
  add(scene, "femur", sphere(40.0f, 3));
  return scene;
}

}  // namespace

class ExtremeExportsTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

 private slots:
  void everyKindEnds_data() {
    QTest::addColumn<Scene>("scene");
    QTest::addColumn<Camera>("camera");
    const auto row = [](const char* name, const Scene& scene, const Camera& camera) {
      QVERIFY2(!model::cameraFault(camera), name);
      QTest::newRow(name) << with(scene, camera) << camera;
    };
    Scene giant;
    add(giant, "femur", moved(*sphere(4.9e7f, 3), 1.0f, {5e7f, 5e7f, 5e7f}));
    row("100 km, seen whole", giant,
        model::anatomicalCamera(model::AnatomicalView::anterior, giant.visibleBounds(), 1.3f));
    row("100 km, seen from a metre", giant,
        {.eye = {5e7f, 1e6f - 1000.0f, 5e7f}, .target = {5e7f, 1e6f, 5e7f}, .up = {0, 0, 1}});
    row("the least height", ball(), orthographic({0.0f, -1e-20f, 0.0f}, 1e-24f));
    row("the least height from outside", ball(), orthographic({0.0f, -100.0f, 0.0f}, 2e-4f));
    row("a speck far away", ball(), {.eye = {0.0f, -9e10f, 0.0f}, .target = {}, .up = {0, 0, 1}});
    Scene specks;
    add(specks, "femur", sphere(5e7f, 3));
    for (int i = 0; i < 1000; ++i) {
      const auto at = float(i);
      add(specks, "speck",
          moved(*sphere(1e-3f, 0), 1.0f,
                {40.0f * std::cos(at), 0.08f * at - 40.0f, 40.0f * std::sin(at)}));
    }
    row("1,000 specks in a large body", specks,
        {.eye = {0.0f, -200.0f, 0.0f}, .target = {}, .up = {0, 0, 1}});
  }
  void everyKindEnds() {
    QFETCH(Scene, scene);
    QFETCH(Camera, camera);
    QString refused;
    for (const render::ExportFormat& format : render::exportFormats()) {
      render::ExportOrder order{.scene = scene, .camera = camera, .viewName = "there"};
      order.page = {{40.0f, 30.0f}, 72.0f};
      order.labels.mode = render::LabelMode::on;
      auto& film = order.of<render::FilmOptions>();
      film.seconds = 0.3;
      film.framesPerSecond = 10;
      film.format = render::FilmFormat::typed;
      film.width = 64;
      film.height = 48;
      const QString target =
          m_folder.filePath(QStringLiteral("%1-%2").arg(QTest::currentDataTag(), format.id)) +
          QStringLiteral(".") + QString::fromLatin1(format.extension);
      resetPeak();
      const Status written = format.write(order, target.toStdString(), {});
      const QString said = QStringLiteral("%1: %2 MiB, %3")
                               .arg(format.id)
                               .arg(peakResidentMiB())
                               .arg(QString::fromStdString(written.ok() ? std::string("written")
                                                                        : written.error().text()));
      QVERIFY2(sanitized || peakResidentMiB() < mostMemory, qPrintable(said));
      if (!written.ok()) {
        QVERIFY2(!written.error().reason.empty(), qPrintable(said));
        refused += said + QLatin1Char('\n');
        continue;
      }
      const QFileInfo file(target);
      QVERIFY2(file.isDir() ? !QDir(target).isEmpty() : file.size() > 0, qPrintable(said));
      if (format.id == std::string_view("svg")) {
        QFile drawing(target);
        QVERIFY(drawing.open(QFile::ReadOnly));
        static const QRegularExpression noNumber(QStringLiteral("[\", (]-?(nan|inf)\\b"));
        QVERIFY2(!QString::fromUtf8(drawing.readAll()).contains(noNumber), qPrintable(said));
      }
    }
    qInfo().noquote() << refused;
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_GUI(sline::test::ExtremeExportsTest)
#include "extreme_exports_test.moc"
