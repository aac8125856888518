// SPDX-License-Identifier: Apache-2.0
// Tests that the window's views are those of the command line: `--view` of a picture of its shape.
#include <glm/geometric.hpp>

#include "app/cli/flags/picture_flags.h"
#include "tests/gui/labels_fixture.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

constexpr std::array<Qt::Key, 6> viewKeys{Qt::Key_A, Qt::Key_P, Qt::Key_L,
                                          Qt::Key_R, Qt::Key_S, Qt::Key_I};

/// Returns the camera that the command line takes for the view, for a page as large as the window's
/// picture.
model::Camera cameraOfCommandLine(Labels& f, const std::string& view) {
  cli::PictureSpec spec;
  spec.view = view;
  spec.size = {f.viewport().width(), f.viewport().height()};
  spec.labels.viewName = view;
  spec.labels.style.mode = f.labels().style().mode;
  const widgets::LabelWish wish = f.labels().wish();
  if (!cli::prepareLabels(spec.labels, f.session.scene(), wish.size / wish.pixelsPerMm).ok())
    qFatal("there is no text");
  const Result<model::Camera> camera = cli::cameraFor(f.session.scene(), spec);
  if (!camera.ok())
    qFatal("there is no such view");
  return *camera;
}

/// Returns how far apart two cameras are as a share of their distance from what they look at; large
/// where they are held differently.
double apart(const model::Camera& a, const model::Camera& b) {
  const float far = glm::length(b.eye - b.target);
  const float turned = glm::length(glm::normalize(a.eye - a.target) - (b.eye - b.target) / far);
  return double(glm::length(a.eye - b.eye) / far + glm::length(a.up - b.up) + turned) +
         std::abs(double(a.fovyDegrees - b.fovyDegrees));
}

void scroll(Labels& f, int clicks) {
  const QPoint at(f.viewport().width() / 3, f.viewport().height() / 3);
  for (int i = 0; i < std::abs(clicks); ++i) {
    QWheelEvent wheel(at, f.viewport().mapToGlobal(at), {}, {0, clicks > 0 ? 120 : -120},
                      Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&f.viewport(), &wheel);
  }
}

model::View overviewFrom(const model::Camera& camera) {
  model::View view{.name = "Overview"};
  view.camera = camera;
  return view;
}

}  // namespace

class SameViewTest : public QObject {
  Q_OBJECT

 private slots:
  /// A key for a side shows what `--view` does, and so does Fit All from there, however near, far
  /// and aside the camera was; with labels both leave the same room for each column.
  void viewsAreThoseOfTheCommandLine_data() {
    QTest::addColumn<bool>("labelled");
    QTest::addColumn<QString>("mode");
    QTest::newRow("nothing labelled") << false << "texts";
    QTest::newRow("labels off") << true << "off";
    QTest::newRow("labels on") << true << "texts";
    QTest::newRow("numbers") << true << "numbers";
  }
  void viewsAreThoseOfTheCommandLine() {
    QFETCH(bool, labelled);
    QFETCH(QString, mode);
    Labels f;
    if (labelled) {
      f.make(f.liver, QStringLiteral("A text that makes its column wider than the other one"));
      f.make(f.bladder, QStringLiteral("short"));
    }
    f.control<QAction>(qPrintable(QStringLiteral("labels-") + mode)).trigger();
    constexpr double same = 1e-4;
    for (std::size_t i = 0; i < viewKeys.size(); ++i) {
      const std::string view(model::anatomicalViewNames[i]);
      const model::Camera wanted = cameraOfCommandLine(f, view);
      f.key(viewKeys[i]);
      const double byKey = apart(f.viewport().camera(), wanted);
      QVERIFY2(byKey < same, qPrintable(QString("%1 by key: %2").arg(view.c_str()).arg(byKey)));
      for (const int clicks : {12, -9}) {
        scroll(f, clicks);
        QVERIFY(apart(f.viewport().camera(), wanted) > 0.1);
        f.control<QAction>("fit").trigger();
        const double fitted = apart(f.viewport().camera(), wanted);
        QVERIFY2(fitted < same, qPrintable(QString("%1 by Fit All after %2 clicks: %3")
                                               .arg(view.c_str())
                                               .arg(clicks)
                                               .arg(fitted)));
      }
    }
  }

  /// Fit All goes to vertices, not to the corners of boxes, and fills the picture but for 5 %.
  void fitAllFillsThePicture() {
    Labels f;
    f.control<QAction>("fit").trigger();
    float most = 0.0f;
    for (const model::NodeId id : {f.liver, f.bladder})
      for (const glm::vec3& p : f.session.scene().find(id)->mesh->positions()) {
        const glm::vec2 size(f.viewport().width(), f.viewport().height());
        const auto pixel = model::pixelOf(f.viewport().camera(), p, size);
        QVERIFY(pixel.has_value());
        const glm::vec2 aside = glm::abs(2.0f * *pixel / size - 1.0f);
        most = std::max({most, aside.x, aside.y});
      }
    QVERIFY2(std::abs(most - 0.9f) < 2e-3f, qPrintable(QString::number(double(most))));
  }

  /// A scene opens with its view "Overview", made for 4:3: as it is in a wide picture, smaller
  /// where the picture or the room beside labels is narrow.
  void overviewsAreKept() {
    Labels plain;
    const model::Camera saved = model::anatomicalCamera(
        model::AnatomicalView::left, plain.session.scene().visibleBounds(), 4.0f / 3.0f);
    const auto opened = [&](WindowFixture& f, const model::Scene& scene) {
      f.session.openMade(QStringLiteral("Seen"), [scene](const auto&, const auto&) {
        return Result<widgets::LoadedDocument>(
            widgets::LoadedDocument{.scene = scene, .title = QStringLiteral("Seen")});
      });
      if (!f.settled())
        qFatal("the scene does not come");
      return f.viewport().camera();
    };
    model::Scene scene = plain.session.scene();
    scene.setViews({overviewFrom(saved)});
    plain.window.resize(1560, 700);
    QVERIFY(float(plain.viewport().width()) > 1.34f * float(plain.viewport().height()));
    QCOMPARE(opened(plain, scene), saved);
    WindowFixture narrow;
    narrow.window.resize(narrow.window.width() * 2 / 3, narrow.window.height());
    // The structures' panel takes its width while the scene comes.
    opened(narrow, scene);
    const model::Camera back = opened(narrow, scene);
    const auto reach = [](const model::Camera& camera) {
      return double(glm::length(camera.eye - camera.target)) * double(model::edgeSlope(camera));
    };
    const double aspect = double(narrow.viewport().width()) / double(narrow.viewport().height());
    QVERIFY(aspect < 1.3);
    const double farther = reach(back) / reach(saved) * aspect / (4.0 / 3.0);
    QVERIFY2(std::abs(farther - 1.0) < 1e-3, qPrintable(QString::number(farther)));
    scene.appendAnnotation({.anchors = {model::SurfacePoint{plain.liver, 0, {0.3f, 0.3f}}},
                            .text = "A text that makes its column wider"});
    QVERIFY(reach(opened(narrow, scene)) > 1.1 * reach(back));
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::SameViewTest)
#include "same_view_test.moc"
