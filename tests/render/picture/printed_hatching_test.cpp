// SPDX-License-Identifier: Apache-2.0
// Tests hatching as S §3.4 prints it: where it may be, where it is, and what it does not depend on.
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "model/geometry/surface.h"
#include "tests/render/picture/scenes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using render::HatchingMethod;
using render::Image;
using render::PictureSettings;

namespace {

constexpr int width = 480;
constexpr int height = 360;

/// Returns a style without lines, so that all ink is hatching.
model::Style bare(float gamma) {
  model::Style style = gammaStyle(gamma);
  style.penWeight = 0.0f;
  return style;
}

/// Describes z = (a·x² + b·y²)/2, normals to +z, where the ray meets it nearest to the eye.
struct Paraboloid {
  float a;
  float b;
  float size;

  /// Holds w_k of S eq. 6, −⟨k, v̂⟩ in 1/mm, in closed form, and nv.
  struct Fields {
    float darkening;
    float nv;
  };

  std::optional<glm::vec3> hit(const glm::vec3& from, const glm::vec3& direction) const {
    const float q2 = 0.5f * (a * direction.x * direction.x + b * direction.y * direction.y);
    const float q1 = a * from.x * direction.x + b * from.y * direction.y - direction.z;
    const float q0 = 0.5f * (a * from.x * from.x + b * from.y * from.y) - from.z;
    const float root = q1 * q1 - 4.0f * q2 * q0;
    if (root < 0.0f)
      return std::nullopt;
    float first = std::numeric_limits<float>::infinity();
    for (const float sign : {-1.0f, 1.0f}) {
      // In Citardauq's form q2 may be next to nothing.
      const float t =
          std::abs(q2) > 1e-9f ? (-q1 + sign * std::sqrt(root)) / (2.0f * q2) : -q0 / q1;
      const glm::vec3 p = from + t * direction;
      if (t > 0.0f && std::max(std::abs(p.x), std::abs(p.y)) <= size)
        first = std::min(first, t);
    }
    if (!std::isfinite(first))
      return std::nullopt;
    return from + first * direction;
  }

  Fields at(const glm::vec3& p, const glm::vec3& v, float distance) const {
    const float g = std::sqrt(1.0f + a * a * p.x * p.x + b * b * p.y * p.y);
    glm::vec3 n = glm::vec3(-a * p.x, -b * p.y, 1.0f) / g;
    // Convex is positive: seen from +z a bowl is concave.
    float sense = -1.0f;
    if (glm::dot(n, v) < 0.0f) {
      n = -n;
      sense = 1.0f;
    }
    const float nv = glm::dot(n, v);
    const glm::vec3 w = v - nv * n;
    const float sww = sense * (a * w.x * w.x + b * w.y * w.y) / g;
    return {-(sww + nv / distance * glm::dot(w, w)), nv};
  }
};

struct Ray {
  glm::vec3 from;
  glm::vec3 direction;
};

Ray rayThrough(const model::Camera& camera, int x, int y) {
  const model::CameraFrame frame = model::cameraFrame(camera);
  const bool parallel = camera.projection == model::Projection::orthographic;
  const float half = parallel ? 0.5f * camera.heightMm
                              : std::tan(camera.fovyDegrees * std::numbers::pi_v<float> / 360.0f);
  const float right = half * (2.0f * (float(x) + 0.5f) - width) / height;
  const float up = half * (1.0f - 2.0f * (float(y) + 0.5f) / height);
  const glm::vec3 aside = right * frame.right + up * frame.up;
  if (parallel)
    return {camera.eye + aside, -frame.back};
  return {camera.eye, glm::normalize(aside - frame.back)};
}

model::Camera slanted(bool parallel) {
  model::Camera camera = frontal(90.0f);
  camera.eye = {20.0f, -90.0f, 90.0f};
  if (!parallel) {
    camera.projection = model::Projection::perspective;
    camera.fovyDegrees = 40.0f;
  }
  return camera;
}

int inkedPixels(const Image& image) {
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      count += inkAt(image, x, y) > 0.02f;
  return count;
}

}  // namespace

class PrintedHatchingTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void liesWhereBrightnessFallsTowardsTheEye_data();
  void liesWhereBrightnessFallsTowardsTheEye();
  void showsOnlyWhereItIsDue_data();
  void showsOnlyWhereItIsDue();
  void mirrors();
  void orientationOfASheetChangesNothing();
  void hiddenByItsOwnSurface();
  void stopsAtCuts();
  void methodsDiffer();
  void piecesGiveTheSamePicture();

 private:
  Image picture(const model::Scene& scene, const model::Camera& camera,
                HatchingMethod method = HatchingMethod::asPrinted);
  Studio m_studio;
};

void PrintedHatchingTest::initTestCase() {
  m_studio = openStudio();
  if (!m_studio.absent.empty())
    QSKIP(m_studio.absent.c_str());
  QVERIFY2(m_studio.fault.empty(), m_studio.fault.c_str());
}

Image PrintedHatchingTest::picture(const model::Scene& scene, const model::Camera& camera,
                                   HatchingMethod method) {
  auto image = m_studio.picture->render(scene, camera,
                                        {.width = width, .height = height, .hatching = method});
  if (!image)
    qFatal("%s", image.error().text().c_str());
  return std::move(*image);
}

void PrintedHatchingTest::liesWhereBrightnessFallsTowardsTheEye_data() {
  QTest::addColumn<float>("a");
  QTest::addColumn<float>("b");
  QTest::addColumn<bool>("parallel");
  QTest::addColumn<float>("gamma");
  QTest::newRow("bowl") << 0.02f << 0.012f << true << 3.0f;
  QTest::newRow("bowl, perspective") << 0.02f << 0.012f << false << 3.0f;
  QTest::newRow("saddle") << -0.012f << 0.016f << true << 3.0f;
  QTest::newRow("saddle, perspective") << -0.012f << 0.016f << false << 3.0f;
  QTest::newRow("saddle, entering") << -0.012f << 0.016f << true << 2.6f;
  QTest::newRow("saddle, leaving") << -0.012f << 0.016f << true << 4.5f;
}

void PrintedHatchingTest::liesWhereBrightnessFallsTowardsTheEye() {
  QFETCH(float, a);
  QFETCH(float, b);
  QFETCH(bool, parallel);
  QFETCH(float, gamma);
  const Paraboloid shape{a, b, 30.0f};
  const model::MeshPtr mesh = paraboloid(a, b, shape.size, 160);
  const float feature = model::prepareSurface(mesh)->featureSize;
  model::Style style = bare(gamma);
  style.opacity = Opacity::clamped(0.0f);  // no fill
  model::Scene scene;
  add(scene, mesh, style);
  const model::Camera camera = slanted(parallel);
  const Image image = picture(scene, camera);
  constexpr float quarterTurn = 0.5f * std::numbers::pi_v<float>;
  const float threshold = quarterTurn * (1.0f - std::min(gamma - 2.0f, 1.0f));
  const float left = 1.0f - std::clamp(gamma - 4.0f, 0.0f, 1.0f);
  int due = 0;
  int drawn = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float ink = inkAt(image, x, y);
      const Ray ray = rayThrough(camera, x, y);
      const auto p = shape.hit(ray.from, ray.direction);
      if (!p)
        continue;
      const auto [darkening, nv] =
          shape.at(*p, -ray.direction,
                   parallel ? std::numeric_limits<float>::infinity() : glm::length(*p - ray.from));
      if (std::max(std::abs(p->x), std::abs(p->y)) > 0.95f * shape.size || nv < 0.1f)
        continue;
      const float byAngle =
          std::clamp((std::acos(nv) - threshold) / (quarterTurn - threshold), 0.0f, 1.0f);
      const float opacity = left * std::clamp(byAngle * darkening * feature, 0.0f, 1.0f);
      if (ink > opacity + 0.03f)
        QFAIL(qPrintable(QString("(%1, %2): %3 where at most %4 is due")
                             .arg(x)
                             .arg(y)
                             .arg(double(ink))
                             .arg(double(opacity))));
      due += opacity > 0.05f;
      drawn += opacity > 0.05f && ink > 0.3f * opacity;
    }
  QVERIFY2(due > 3000 && drawn > due / 4, qPrintable(QString("%1 of %2").arg(drawn).arg(due)));
}

void PrintedHatchingTest::showsOnlyWhereItIsDue_data() {
  QTest::addColumn<QString>("shape");
  QTest::addColumn<float>("gamma");
  QTest::addColumn<bool>("part");
  QTest::addColumn<bool>("hatched");
  QTest::newRow("sphere") << "sphere" << 3.0f << true << false;
  QTest::newRow("ring") << "ring" << 3.0f << true << true;
  QTest::newRow("ring, before its time") << "ring" << 2.0f << true << false;
  QTest::newRow("ring, silhouette") << "ring" << 0.0f << true << false;
  QTest::newRow("ring, past its time") << "ring" << 5.0f << true << false;
  QTest::newRow("ring, not asked for") << "ring" << 3.0f << false << false;
}

void PrintedHatchingTest::showsOnlyWhereItIsDue() {
  QFETCH(QString, shape);
  QFETCH(float, gamma);
  QFETCH(bool, part);
  QFETCH(bool, hatched);
  model::Style style = bare(gamma);
  style.opacity = Opacity::clamped(0.0f);
  model::Scene scene;
  add(scene, shape == "sphere" ? sphere(30.0f, 5) : torus(24.0f, 12.0f, 160, 80), style);
  const auto image = m_studio.picture->render(scene, slanted(true),
                                              {.width = width,
                                               .height = height,
                                               .hatching = HatchingMethod::asPrinted,
                                               .parts = {.hatching = part}});
  QVERIFY(image.ok());
  const int inked = inkedPixels(*image);
  QVERIFY2(hatched ? inked > 500 : inked == 0, qPrintable(QString::number(inked)));
}

void PrintedHatchingTest::mirrors() {
  const model::MeshPtr saddle =
      moved(*paraboloid(-0.012f, 0.016f, 30.0f, 160), 1.0f, {4.0f, 3.0f, 0.0f});
  model::Scene scene;
  add(scene, saddle, bare(3.0f));
  model::Scene other;
  add(other, mirrored(*saddle), bare(3.0f));
  const model::Camera camera = slanted(true);
  model::Camera opposite = camera;
  opposite.eye.x = -camera.eye.x;
  const Image image = picture(scene, camera);
  QVERIFY(inkedPixels(image) > 3000);
  const Difference d = difference(mirroredImage(image), picture(other, opposite));
  QVERIFY2(d.share < 0.01, qPrintable(QString("%1 of pixels").arg(d.share)));
  QVERIFY(difference(image, mirroredImage(image)).share > 0.05);
}

void PrintedHatchingTest::orientationOfASheetChangesNothing() {
  const model::MeshPtr sheet = paraboloid(-0.012f, 0.016f, 30.0f, 120);
  std::vector<model::Triangle> turned(sheet->triangles().begin(), sheet->triangles().end());
  for (model::Triangle& t : turned)
    std::swap(t[1], t[2]);
  const auto mesh = model::Mesh::create({sheet->positions().begin(), sheet->positions().end()},
                                        std::move(turned));
  QVERIFY(mesh.ok());
  model::Scene scene;
  add(scene, sheet, bare(3.0f));
  model::Scene other;
  add(other, std::make_shared<const model::Mesh>(*mesh), bare(3.0f));
  const Image image = picture(scene, slanted(false));
  QVERIFY(inkedPixels(image) > 3000);
  const Difference d = difference(image, picture(other, slanted(false)));
  QVERIFY2(d.share < 0.005, qPrintable(QString("%1 of pixels").arg(d.share)));
}

void PrintedHatchingTest::hiddenByItsOwnSurface() {
  // A bowl has a lid that belongs to the same mesh: nothing within may be hatched.
  const model::MeshPtr bowl = paraboloid(0.02f, 0.012f, 30.0f, 80);
  const model::MeshPtr lid = paraboloid(0.0f, 0.0f, 60.0f, 8);
  std::vector<glm::vec3> positions(bowl->positions().begin(), bowl->positions().end());
  std::vector<model::Triangle> triangles(bowl->triangles().begin(), bowl->triangles().end());
  const auto first = std::uint32_t(positions.size());
  for (const glm::vec3& p : lid->positions())
    positions.push_back(p + glm::vec3(0.0f, 0.0f, 20.0f));
  for (const auto& [a, b, c] : lid->triangles())
    triangles.push_back({first + a, first + b, first + c});
  const auto mesh = model::Mesh::create(std::move(positions), std::move(triangles));
  QVERIFY(mesh.ok());
  model::Scene scene;
  add(scene, std::make_shared<const model::Mesh>(*mesh), bare(3.0f));
  model::Camera above = frontal(50.0f);
  above.eye = {0.0f, -30.0f, 200.0f};
  above.up = {0.0f, 1.0f, 0.0f};
  QCOMPARE(inkedPixels(picture(scene, above)), 0);
  model::Scene open;
  add(open, bowl, bare(3.0f));
  QVERIFY(inkedPixels(picture(open, above)) > 3000);
}

void PrintedHatchingTest::stopsAtCuts() {
  const Paraboloid shape{0.02f, 0.012f, 30.0f};
  model::Scene scene;
  add(scene, paraboloid(shape.a, shape.b, shape.size, 160), bare(3.0f));
  const auto inked = [&](const Image& image) {
    std::pair<int, int> counts{0, 0};  // where y < 0 is kept, where y > 0 is taken away
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const Ray ray = rayThrough(slanted(true), x, y);
        const auto p = shape.hit(ray.from, ray.direction);
        if (p && std::abs(p->y) > 0.5f && inkAt(image, x, y) > 0.02f)
          ++(p->y < 0.0f ? counts.first : counts.second);
      }
    return counts;
  };
  const auto whole = inked(picture(scene, slanted(true)));
  QVERIFY(whole.first > 2000 && whole.second > 2000);
  model::Section section;
  section.plane = {{0.0f, 1.0f, 0.0f}, 0.0f};
  scene.appendSection(section);
  const auto cut = inked(picture(scene, slanted(true)));
  QVERIFY(cut.first > 0.8 * whole.first);
  QCOMPARE(cut.second, 0);
}

void PrintedHatchingTest::methodsDiffer() {
  model::Scene scene;
  const model::NodeId id = add(scene, torus(24.0f, 12.0f, 160, 80), gammaStyle(3.0f));
  const Image printed = picture(scene, slanted(true));
  const Image strokes = picture(scene, slanted(true), HatchingMethod::strokes);
  QVERIFY(difference(printed, strokes).share > 0.01);
  // The layer that is kept remembers how it was hatched.
  QCOMPARE(difference(picture(scene, slanted(true)), printed).largest, 0);
  std::vector<model::Node> nodes = scene.nodes();
  for (model::Node& node : nodes)
    if (node.id == id)
      node.style.gamma = Gamma::clamped(2.0f);
  scene.setNodes(nodes);
  QCOMPARE(difference(picture(scene, slanted(true)),
                      picture(scene, slanted(true), HatchingMethod::strokes))
               .largest,
           0);
}

void PrintedHatchingTest::piecesGiveTheSamePicture() {
  model::Scene scene;
  add(scene, torus(24.0f, 12.0f, 160, 80), gammaStyle(3.0f));
  add(scene, moved(*paraboloid(-0.012f, 0.016f, 30.0f, 120), 1.0f, {3.0f, 5.0f, 2.0f}),
      gammaStyle(2.8f));
  const Image whole = picture(scene, slanted(false));
  auto pieces = render::Picture::create({.maximumSide = 120});
  QVERIFY(pieces.ok());
  const auto tiled =
      (*pieces)->render(scene, slanted(false),
                        {.width = width, .height = height, .hatching = HatchingMethod::asPrinted});
  QVERIFY(tiled.ok());
  // A seed's border may fall on the other side of a pixel.
  const Difference d = difference(whole, *tiled);
  QVERIFY2(d.share < 0.001, qPrintable(QString("%1 of pixels").arg(d.share)));
}

SLINE_TEST_WITH_EVENTS(PrintedHatchingTest)
#include "printed_hatching_test.moc"
