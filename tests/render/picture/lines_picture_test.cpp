// SPDX-License-Identifier: Apache-2.0
// Tests lines in the picture: where they are, how wide, and that hidden ones stay hidden.
#include <QtTest>
#include <cmath>
#include <numbers>

#include "tests/render/picture/scenes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using render::Image;
using render::PictureSettings;

class LinesPictureTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void sphereIsACircle_data();
  void sphereIsACircle();
  void penIsEven_data();
  void penIsEven();
  void hiddenLinesStayHidden_data();
  void hiddenLinesStayHidden();
  void silhouetteAloneAtZero();
  void linesGrowWithGamma();
  void inkColour_data();
  void inkColour();
  void mirroredMeshMirrorsThePicture_data();
  void mirroredMeshMirrorsThePicture();
  void scaleChangesNothing();
  void doubleSizeIsTheSameDrawing();
  void refinedSurfacesKeepTheirNoiseToThemselves();

 private:
  Image picture(const model::Scene& scene, const model::Camera& camera,
                const PictureSettings& settings);
  Studio m_studio;
};

namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr float turn = 2.0f * pi;

struct Ring {
  float inner = 0.0f;  ///< in px, where ink starts seen from the centre
  float width = 0.0f;  ///< in px, ink added up along the ray
};

/// Measures the ink along a ray from the picture's centre.
Ring ring(const Image& image, float angle) {
  Ring r;
  constexpr float step = 0.125f;
  float weighted = 0.0f;
  for (float radius = 0.0f; radius < 0.49f * float(image.height); radius += step) {
    const float x = 0.5f * float(image.width) + radius * std::cos(angle);
    const float y = 0.5f * float(image.height) + radius * std::sin(angle);
    // The samples are bilinear between pixel centres, so that slanted rays see the coverage itself.
    const float fx = x - 0.5f;
    const float fy = y - 0.5f;
    const int ix = int(std::floor(fx));
    const int iy = int(std::floor(fy));
    const float ax = fx - float(ix);
    const float ay = fy - float(iy);
    const float ink =
        (inkAt(image, ix, iy) * (1 - ax) + inkAt(image, ix + 1, iy) * ax) * (1 - ay) +
        (inkAt(image, ix, iy + 1) * (1 - ax) + inkAt(image, ix + 1, iy + 1) * ax) * ay;
    r.width += ink * step;
    weighted += ink * step * radius;
  }
  r.inner = weighted / r.width - 0.5f * r.width;
  return r;
}

/// Returns a camera around the origin, `degrees` above the horizon.
model::Camera tilted(float degrees, float heightMm) {
  model::Camera camera = frontal(heightMm);
  const float a = degrees * pi / 180.0f;
  camera.eye = {0.0f, -1000.0f * std::cos(a), 1000.0f * std::sin(a)};
  return camera;
}

double totalInk(const Image& image) {
  double sum = 0.0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      sum += double(inkAt(image, x, y));
  return sum;
}

}  // namespace

void LinesPictureTest::initTestCase() {
  m_studio = openStudio();
  if (!m_studio.absent.empty())
    QSKIP(m_studio.absent.c_str());
  QVERIFY2(m_studio.fault.empty(), m_studio.fault.c_str());
}

Image LinesPictureTest::picture(const model::Scene& scene, const model::Camera& camera,
                                const PictureSettings& settings) {
  auto image = m_studio.picture->render(scene, camera, settings);
  if (!image)
    qFatal("%s", image.error().text().c_str());
  return std::move(*image);
}

void LinesPictureTest::sphereIsACircle_data() {
  QTest::addColumn<bool>("perspective");
  QTest::addColumn<float>("gamma");
  for (const float gamma : {0.0f, 1.0f, 2.0f, 4.0f})
    for (const bool perspective : {false, true})
      QTest::addRow("%s, gamma %g", perspective ? "perspective" : "parallel", double(gamma))
          << perspective << gamma;
}

void LinesPictureTest::sphereIsACircle() {
  QFETCH(bool, perspective);
  QFETCH(float, gamma);
  model::Scene scene;
  model::Style style = gammaStyle(gamma);
  style.colour = Colour{255, 255, 255};
  add(scene, sphere(50.0f, 6), style);
  model::Camera camera = frontal(150.0f);
  float radius = 50.0f / 150.0f * 720.0f;
  if (perspective) {
    camera.projection = model::Projection::perspective;
    camera.eye.y = -300.0f;
    // The contour of a sphere lies nearer than its centre: tan of the angle it spans.
    const float tangent = 50.0f / std::sqrt(300.0f * 300.0f - 50.0f * 50.0f);
    radius = tangent / std::tan(camera.fovyDegrees * pi / 360.0f) * 360.0f;
  }
  const Image image = picture(scene, camera, {.width = 720, .height = 720});
  if (gamma > 3.0f) {  // a filled sphere: only that the ink is where it should be
    const int y = int(std::lround(360.0f - radius));
    QVERIFY(std::max(inkAt(image, 360, y), inkAt(image, 360, y - 1)) > 0.9f);
    return;
  }
  for (int i = 0; i < 64; ++i) {
    const Ring r = ring(image, turn * float(i) / 64.0f);
    QVERIFY2(std::abs(r.inner - (radius - 0.5f)) < 0.35f,
             qPrintable(QString("direction %1: from %2 for %3").arg(i).arg(r.inner).arg(radius)));
  }
}

void LinesPictureTest::penIsEven_data() {
  QTest::addColumn<int>("height");
  QTest::addColumn<float>("weight");
  QTest::addColumn<float>("expected");
  QTest::newRow("2 λ") << 720 << 1.0f << 2.0f;
  QTest::newRow("a bold pen") << 720 << 2.0f << 4.0f;
  QTest::newRow("a poster") << 1440 << 1.0f << 4.0f;
  QTest::newRow("never thinner than a pixel, but lighter") << 360 << 0.5f << 0.5f;
}

void LinesPictureTest::penIsEven() {
  QFETCH(int, height);
  QFETCH(float, weight);
  QFETCH(float, expected);
  model::Scene scene;
  model::Style style = gammaStyle(1.0f);
  style.penWeight = weight;
  add(scene, sphere(50.0f, 6), style);
  const Image image = picture(scene, frontal(150.0f), {.width = height, .height = height});
  for (int i = 0; i < 48; ++i) {
    const float width = ring(image, turn * float(i) / 48.0f).width;
    QVERIFY2(std::abs(width - expected) < 0.12f + 0.1f * expected,
             qPrintable(QString("direction %1: %2").arg(i).arg(width)));
  }
}

void LinesPictureTest::hiddenLinesStayHidden_data() {
  QTest::addColumn<float>("degrees");
  QTest::addColumn<float>("gamma");
  // The views go from the horizon, where the far side and the hole hide behind the near side, to
  // where the far contour passes close behind the visible one (the hole closes at about 36°).
  for (const float degrees : {0.0f, 4.0f, 12.0f, 20.0f, 30.0f})
    for (const float gamma : {1.0f, 2.0f})
      QTest::addRow("%g degrees, gamma %g", double(degrees), double(gamma)) << degrees << gamma;
}

void LinesPictureTest::hiddenLinesStayHidden() {
  QFETCH(float, degrees);
  QFETCH(float, gamma);
  const model::MeshPtr ring = torus(50.0f, 20.0f, 240, 96);
  const model::Camera camera = tilted(degrees, 180.0f);
  const PictureSettings settings{.width = 960, .height = 720};
  model::Scene whole;
  add(whole, ring, gammaStyle(gamma));
  const Image image = picture(whole, camera, settings);
  // In the lower half the front of the tube faces the eye: nothing but its own outline is there.
  // Its ink is that of the outline's pen, in a column through the middle exactly two crossings
  // (bottom, and for the upper half top or inner edge).
  const float a = degrees * pi / 180.0f;
  const float pxPerMm = 720.0f / 180.0f;
  const float bottom = 360.0f + (50.0f * std::sin(a) + 20.0f) * pxPerMm;
  const float nearCentre = 360.0f + 50.0f * std::sin(a) * pxPerMm;
  int dark = 0;
  for (int y = int(nearCentre - 12.0f * pxPerMm); y < int(bottom) - 4; ++y)
    for (int x = 470; x < 490; ++x)
      dark += inkAt(image, x, y) > 0.1f;
  QCOMPARE(dark, 0);
  QVERIFY(inkAt(image, 480, int(std::lround(bottom))) > 0.5f);
}

void LinesPictureTest::silhouetteAloneAtZero() {
  // A torus seen from 20°, where its hole is closed: the near rim's inner contour lies within the
  // mask.
  const model::MeshPtr ring = torus(50.0f, 20.0f, 240, 96);
  const model::Camera camera = tilted(20.0f, 180.0f);
  const PictureSettings settings{.width = 960, .height = 720};
  model::Scene zero;
  add(zero, ring, gammaStyle(0.0f));
  model::Scene one;
  add(one, ring, gammaStyle(1.0f));
  const Image silhouette = picture(zero, camera, settings);
  const Image contours = picture(one, camera, settings);
  int inner = 0;
  for (int y = 0; y < 720; ++y)
    for (int x = 0; x < 960; ++x) {
      QVERIFY(inkAt(silhouette, x, y) <= inkAt(contours, x, y) + 0.02f);
      // Well within the outline.
      const float dx = (float(x) - 480.0f) / 240.0f;
      const float dy = (float(y) - 360.0f) / 130.0f;
      if (dx * dx + dy * dy > 1.0f)
        continue;
      inner += inkAt(contours, x, y) > 0.5f;
      QVERIFY2(inkAt(silhouette, x, y) < 0.05f, qPrintable(QString("(%1, %2)").arg(x).arg(y)));
    }
  QVERIFY(inner > 50);
}

void LinesPictureTest::linesGrowWithGamma() {
  const model::MeshPtr ring = torus(50.0f, 20.0f, 160, 64);
  double last = 0.0;
  for (const float gamma : {0.0f, 0.3f, 0.7f, 1.0f, 1.4f, 1.8f, 2.0f}) {
    model::Scene scene;
    add(scene, ring, gammaStyle(gamma));
    const double ink =
        totalInk(picture(scene, tilted(40.0f, 180.0f), {.width = 640, .height = 480}));
    QVERIFY2(ink >= last * 0.999, qPrintable(QString("gamma %1: %2").arg(gamma).arg(ink)));
    last = ink;
  }
}

void LinesPictureTest::inkColour_data() {
  QTest::addColumn<int>("background");
  QTest::addColumn<bool>("own");
  QTest::addColumn<QList<int>>("ink");
  QTest::addColumn<QList<int>>("paper");
  const auto row = [](const char* name, render::Background b, bool own, const QList<int>& ink,
                      const QList<int>& paper) {
    QTest::newRow(name) << int(b) << own << ink << paper;
  };
  using render::Background;
  row("white", Background::white, false, {0, 0, 0, 255}, {255, 255, 255, 255});
  row("paper", Background::paper, false, {0, 0, 0, 255}, {250, 246, 236, 255});
  row("dark", Background::dark, false, {238, 236, 230, 255}, {28, 30, 34, 255});
  row("transparent", Background::transparent, false, {0, 0, 0, 255}, {0, 0, 0, 0});
  row("own colour", Background::white, true, {180, 20, 40, 255}, {255, 255, 255, 255});
}

void LinesPictureTest::inkColour() {
  QFETCH(int, background);
  QFETCH(bool, own);
  QFETCH(QList<int>, ink);
  QFETCH(QList<int>, paper);
  model::Scene scene;
  model::Style style = gammaStyle(1.0f);
  style.penWeight = 3.0f;
  if (own)
    style.inkColour = Colour{180, 20, 40};
  add(scene, sphere(50.0f, 5), style);
  const Image image = picture(
      scene, frontal(150.0f),
      {.width = 720, .height = 720, .environment = {.background = render::Background(background)}});
  const auto same = [](const Pixel& p, const QList<int>& c) {
    return p.red == c[0] && p.green == c[1] && p.blue == c[2] && p.alpha == c[3];
  };
  QVERIFY(same(pixelAt(image, 360, 360 - 240 - 3), ink));
  QVERIFY(same(pixelAt(image, 5, 5), paper));
  QVERIFY(same(pixelAt(image, 360, 360), paper));
}

void LinesPictureTest::mirroredMeshMirrorsThePicture_data() {
  QTest::addColumn<float>("gamma");
  for (const float gamma : {0.5f, 2.0f, 3.5f, 5.0f})
    QTest::addRow("gamma %g", double(gamma)) << gamma;
}

void LinesPictureTest::mirroredMeshMirrorsThePicture() {
  QFETCH(float, gamma);
  const model::MeshPtr shape = moved(*torus(50.0f, 20.0f, 120, 48), 1.0f, {13.0f, 0.0f, 4.0f});
  model::Scene left;
  add(left, shape, gammaStyle(gamma));
  model::Scene right;
  add(right, mirrored(*shape), gammaStyle(gamma));
  PictureSettings settings{.width = 640, .height = 480};
  const Image a = picture(left, tilted(35.0f, 200.0f), settings);
  // In a mirror the light is on the other side, too.
  settings.environment.light = model::upperLeftLight * glm::vec3(-1.0f, 1.0f, 1.0f);
  const Image b = picture(right, tilted(35.0f, 200.0f), settings);
  // Where an edge passes a pixel's very middle, the rasteriser's rule is not symmetric; and between
  // two strokes that are each other's image on the ring itself chance decides.
  const bool hatched = gamma > 2.0f && gamma < 5.0f;
  const Difference d = difference(a, mirroredImage(b));
  QVERIFY2(d.share < (hatched ? 4e-3 : 6e-4) && d.mean < (hatched ? 0.1 : 0.02),
           qPrintable(QString("%1 of pixels, mean %2").arg(d.share).arg(d.mean)));
  QVERIFY(difference(a, b).share > 0.005);
}

void LinesPictureTest::scaleChangesNothing() {
  const model::MeshPtr shape = torus(50.0f, 20.0f, 120, 48);
  const PictureSettings settings{.width = 640, .height = 480};
  for (const float gamma : {0.5f, 2.0f, 3.5f}) {
    model::Scene small;
    add(small, shape, gammaStyle(gamma));
    model::Scene large;
    add(large, moved(*shape, 1000.0f, glm::vec3(0.0f)), gammaStyle(gamma));
    model::Camera camera = tilted(35.0f, 180.0f);
    const Image a = picture(small, camera, settings);
    camera.eye *= 1000.0f;
    camera.heightMm *= 1000.0f;
    const Difference d = difference(a, picture(large, camera, settings));
    QVERIFY2(d.share < 2e-4 && d.mean < 0.02,
             qPrintable(QString("gamma %1: %2, mean %3").arg(gamma).arg(d.share).arg(d.mean)));
  }
}

void LinesPictureTest::doubleSizeIsTheSameDrawing() {
  model::Scene scene;
  model::Style style = gammaStyle(2.0f);
  style.penWeight = 2.0f;
  add(scene, torus(50.0f, 20.0f, 200, 80), style);
  const model::Camera camera = tilted(35.0f, 180.0f);
  const Image once = picture(scene, camera, {.width = 960, .height = 720});
  const Image twice = picture(scene, camera, {.width = 1920, .height = 1440});
  const Difference d = difference(once, halved(twice));
  QVERIFY2(d.mean < 0.35, qPrintable(QString::number(d.mean)));
  const double ratio = totalInk(twice) / totalInk(once);
  QVERIFY2(std::abs(ratio - 4.0) < 0.12, qPrintable(QString::number(ratio)));
}

// The same rough ball comes once as its file gave it, and once refined on the way in: there its
// roughness is the few vertices' noise, and no pen would draw it as lines.
void LinesPictureTest::refinedSurfacesKeepTheirNoiseToThemselves() {
  const auto ball = test::sphere(20.0f, 4);
  std::vector<glm::vec3> positions(ball->positions().begin(), ball->positions().end());
  for (std::size_t i = 0; i < positions.size(); ++i)
    positions[i] *= 1.0f + 0.05f * float(i * 2654435761u % 1000) / 1000.0f;
  const auto rough = std::make_shared<const model::Mesh>(
      std::move(model::Mesh::create(std::move(positions),
                                    {ball->triangles().begin(), ball->triangles().end()}))
          .value());
  const auto ink = [&](int refinements) {
    model::Scene scene;
    scene.append({.style = gammaStyle(2.0f),
                  .mesh = std::make_shared<const model::Mesh>(*rough),
                  .provenance = {.refinementSteps = refinements}});
    const Image image = picture(scene, frontal(60.0f), {.width = 360, .height = 360});
    float sum = 0.0f;
    // Inside the outline, which is 120 px from the centre.
    for (int y = 100; y < 260; ++y)
      for (int x = 100; x < 260; ++x)
        sum += inkAt(image, x, y);
    return sum;
  };
  const float asGiven = ink(0);
  const float refined = ink(2);
  QVERIFY2(asGiven > 200.0f, qPrintable(QString::number(double(asGiven))));
  QVERIFY2(refined < 0.3f * asGiven, qPrintable(QString::number(double(refined))));
}

SLINE_TEST_WITH_EVENTS(LinesPictureTest)
#include "lines_picture_test.moc"
