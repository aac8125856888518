// SPDX-License-Identifier: Apache-2.0
// Tests section planes in the picture: cut faces where they must be, and nothing where things are
// gone.
#include <QtTest>
#include <cmath>
#include <numbers>

#include "model/edit/look.h"
#include "tests/render/picture/section_scenes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using model::AnatomicalView;
using render::Image;
using render::PictureSettings;

class SectionsPictureTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void sphereIsDisc_data();
  void sphereIsDisc();
  void colourFollowsFill_data();
  void colourFollowsFill();
  void outlineAtEveryGamma_data();
  void outlineAtEveryGamma();
  void torusIsTwoDiscs();
  void cavityIsAnAnnulus();
  void sheetsHaveNoCap();
  void mirroredSceneMirroredPicture();
  void nothingIsLeftOfWhatIsGone_data();
  void nothingIsLeftOfWhatIsGone();
  void capsHideWhatIsBehind_data();
  void capsHideWhatIsBehind();
  void innerFaceLiesOnTheOuter_data();
  void innerFaceLiesOnTheOuter();
  void hatchingRunsAt45Degrees();
  void inkAloneHasNoColour();

 private:
  Image picture(const model::Scene& scene, const model::Camera& camera,
                const PictureSettings& settings = square);
  static constexpr PictureSettings square{.width = 400, .height = 400};
  Studio m_studio;
};

void SectionsPictureTest::initTestCase() {
  m_studio = openStudio();
  if (!m_studio.absent.empty())
    QSKIP(m_studio.absent.c_str());
  QVERIFY2(m_studio.fault.empty(), m_studio.fault.c_str());
}

Image SectionsPictureTest::picture(const model::Scene& scene, const model::Camera& camera,
                                   const PictureSettings& settings) {
  auto image = m_studio.picture->render(scene, camera, settings);
  if (!image.ok())
    qFatal("%s", image.error().text().c_str());
  return std::move(*image);
}

void SectionsPictureTest::sphereIsDisc_data() {
  QTest::addColumn<float>("gamma");
  QTest::addColumn<bool>("perspective");
  for (const float gamma : {0.0f, 1.0f, 2.5f, 3.5f, 4.6f, 5.0f})
    for (const bool perspective : {false, true})
      QTest::addRow("gamma %.1f, %s", double(gamma), perspective ? "perspective" : "parallel")
          << gamma << perspective;
}

void SectionsPictureTest::sphereIsDisc() {
  QFETCH(float, gamma);
  QFETCH(bool, perspective);
  model::Scene scene;
  add(scene, moved(*sphere(40.0f, 5), 1.0f, {5, 0, -3}), styled(gamma, red));
  cut(scene, AnatomicalView::posterior, 15.0f);
  // The scale is 4 pixels a millimetre, in the plane of the cut.
  model::Camera camera = frontal(100.0f);
  camera.eye.y = -485.0f;
  if (perspective) {
    camera.projection = model::Projection::perspective;
    camera.fovyDegrees = float(2.0 * std::atan(50.0 / 500.0) * 180.0 / std::numbers::pi);
  }
  const Image image = picture(scene, camera);
  const double radius = 4.0 * std::sqrt(1600.0 - 225.0);
  const Spot face = spot(image, reddish);
  // Half of the outline's pen covers the face.
  const double pen = 2.0 * 400.0 / 720.0 * (gamma > 4.0f ? 0.5 + 0.5 * (5.0 - double(gamma)) : 1.0);
  const double area = std::numbers::pi * std::pow(radius - 0.5 * std::max(pen, 1.0), 2.0);
  QVERIFY2(std::abs(face.count / area - 1.0) < 0.008,
           qPrintable(QString("%1 of %2").arg(face.count).arg(area)));
  QVERIFY2(std::abs(face.x - 220.0) < 0.5, qPrintable(QString::number(face.x)));
  QVERIFY2(std::abs(face.y - 212.0) < 0.5, qPrintable(QString::number(face.y)));
  // Outside of face and pen there is nothing: the rest of the ball lies behind.
  const Spot all = spot(image, drawn);
  QVERIFY(all.count < std::numbers::pi * std::pow(radius + 0.5 * pen + 1.0, 2.0));
}

void SectionsPictureTest::colourFollowsFill_data() {
  QTest::addColumn<float>("gamma");
  QTest::addColumn<float>("opacity");
  QTest::addColumn<double>("strength");
  QTest::newRow("silhouette: light tint") << 0.0f << 1.0f << 0.35;
  QTest::newRow("suggestive contours: light tint") << 2.0f << 1.0f << 0.35;
  QTest::newRow("half on the way") << 3.5f << 1.0f << 0.675;
  QTest::newRow("filled: full colour") << 4.0f << 1.0f << 1.0;
  QTest::newRow("shaded: full colour") << 5.0f << 1.0f << 1.0;
  QTest::newRow("half transparent") << 5.0f << 0.5f << 0.5;
}

void SectionsPictureTest::colourFollowsFill() {
  QFETCH(float, gamma);
  QFETCH(float, opacity);
  QFETCH(double, strength);
  model::Scene scene;
  model::Style style = styled(gamma, red);
  style.opacity = Opacity::clamped(opacity);
  add(scene, sphere(40.0f, 4), style);
  cut(scene, AnatomicalView::posterior, 0.0f);
  const Image image = picture(scene, frontal(100.0f));
  for (const auto& [x, y] : {std::pair{200, 200}, {120, 260}, {300, 150}}) {
    const Pixel p = pixelAt(image, x, y);
    QVERIFY(std::abs(p.red - (255.0 + strength * (200.0 - 255.0))) < 2.0);
    QVERIFY(std::abs(p.blue - (255.0 + strength * (40.0 - 255.0))) < 2.0);
  }
}

void SectionsPictureTest::outlineAtEveryGamma_data() {
  QTest::addColumn<float>("gamma");
  QTest::addColumn<double>("width");  // width of the scene's pen
  QTest::newRow("silhouette") << 0.0f << 1.0;
  QTest::newRow("contours") << 1.0f << 1.0;
  QTest::newRow("hatching") << 3.0f << 1.0;
  QTest::newRow("Phong") << 4.0f << 1.0;
  QTest::newRow("lines leave") << 4.5f << 0.75;
  QTest::newRow("shaded surface") << 5.0f << 0.5;
}

void SectionsPictureTest::outlineAtEveryGamma() {
  QFETCH(float, gamma);
  QFETCH(double, width);
  model::Scene scene;
  add(scene, sphere(40.0f, 5), styled(gamma, {255, 255, 255}));
  cut(scene, AnatomicalView::posterior, 10.0f);
  const Image image =
      picture(scene, frontal(100.0f), {.width = 1440, .height = 1440});  // λ is 2 pixels
  // Ink adds up along a row through the middle: twice across the pen of 4 pixels.
  double ink = 0.0;
  for (int x = 0; x < image.width; ++x)
    ink += double(inkAt(image, x, 720));
  QVERIFY2(std::abs(ink - 8.0 * width) < 0.4, qPrintable(QString::number(ink)));
}

void SectionsPictureTest::torusIsTwoDiscs() {
  model::Scene scene;
  add(scene, torus(30.0f, 10.0f, 120, 60), styled(2.0f, red));
  cut(scene, AnatomicalView::posterior, 0.0f);
  const Image image = picture(scene, frontal(100.0f));
  const Spot left = spot(image, reddish);
  QVERIFY(std::abs(left.x - 200.0) < 0.5);
  const double disc = std::numbers::pi * 39.4 * 39.4;
  QVERIFY(std::abs(left.count / (2.0 * disc) - 1.0) < 0.02);
  QVERIFY(reddish(pixelAt(image, 80, 200)));
  QVERIFY(reddish(pixelAt(image, 320, 200)));
  QVERIFY(!reddish(pixelAt(image, 200, 200)));
}

void SectionsPictureTest::cavityIsAnAnnulus() {
  model::Scene scene;
  const model::MeshPtr inner = sphere(20.0f, 4);
  std::vector<model::Triangle> inward(inner->triangles().begin(), inner->triangles().end());
  for (model::Triangle& t : inward)
    std::swap(t[1], t[2]);
  const auto cavity = model::Mesh::create({inner->positions().begin(), inner->positions().end()},
                                          std::move(inward));
  add(scene, together(*sphere(40.0f, 4), *cavity), styled(2.0f, red));
  cut(scene, AnatomicalView::posterior, 0.0f);
  const Image image = picture(scene, frontal(100.0f));
  const double area = std::numbers::pi * (159.4 * 159.4 - 80.6 * 80.6);
  QVERIFY(std::abs(spot(image, reddish).count / area - 1.0) < 0.01);
  QCOMPARE(pixelAt(image, 200, 200).grey(), 255);
}

void SectionsPictureTest::sheetsHaveNoCap() {
  model::Scene scene;
  add(scene, cylinder(30.0f, 80.0f, 64, 20), styled(2.0f, red));
  cut(scene, AnatomicalView::inferior, 10.0f);
  model::Camera camera = frontal(120.0f);
  camera.eye = {0.0f, -400.0f, 400.0f};
  const Image image = picture(scene, camera);
  QCOMPARE(spot(image, reddish).count, 0);
  QVERIFY(spot(image, drawn).count > 1000);  // cut open, with a line around the opening
}

void SectionsPictureTest::mirroredSceneMirroredPicture() {
  const model::MeshPtr shape = moved(*askew(*torus(30.0f, 11.0f, 90, 44)), 1.0f, {4, 3, -2});
  model::Scene left;
  add(left, shape, styled(3.6f, red));
  cut(left, AnatomicalView::left, 6.0f);
  model::Scene right;
  add(right, mirrored(*shape), styled(3.6f, red));
  cut(right, AnatomicalView::right, -6.0f);
  model::Camera camera = frontal(110.0f);
  camera.eye = {-300.0f, -300.0f, 200.0f};
  const Image image = picture(left, camera);
  camera.eye.x = 300.0f;
  PictureSettings mirror = square;
  // In a mirror the light is on the other side, too.
  mirror.environment.light = model::upperLeftLight * glm::vec3(-1.0f, 1.0f, 1.0f);
  const Difference d = difference(image, mirroredImage(picture(right, camera, mirror)));
  QVERIFY2(d.share < 0.002, qPrintable(QString::number(d.share)));
  QVERIFY(spot(image, reddish).count > 2000);
  // Left and right can be told apart.
  QVERIFY(difference(image, picture(right, camera)).share > 0.05);
}

void SectionsPictureTest::nothingIsLeftOfWhatIsGone_data() {
  QTest::addColumn<int>("kept");
  QTest::addColumn<int>("x");  // the side of the picture towards which things stay
  QTest::addColumn<int>("y");
  // Seen from the front: the patient's left is on the right of the picture.
  QTest::newRow("left") << int(AnatomicalView::left) << 1 << 0;
  QTest::newRow("right") << int(AnatomicalView::right) << -1 << 0;
  QTest::newRow("superior") << int(AnatomicalView::superior) << 0 << -1;
  QTest::newRow("inferior") << int(AnatomicalView::inferior) << 0 << 1;
}

void SectionsPictureTest::nothingIsLeftOfWhatIsGone() {
  QFETCH(int, kept);
  QFETCH(int, x);
  QFETCH(int, y);
  for (const float gamma : {0.0f, 2.0f, 3.5f, 4.5f, 5.0f}) {
    model::Scene scene = crowd(gamma);
    cut(scene, AnatomicalView(kept), 5.0f);
    const Image image = picture(scene, frontal(120.0f));
    // 5 mm are 16.7 pixels; the outline may reach half a pen over the plane.
    const Spot wrong = spot(image, [](const Pixel& p) { return p.grey() < 252; });
    QVERIFY(wrong.count > 1000);
    for (int row = 0; row < image.height; ++row)
      for (int column = 0; column < image.width; ++column) {
        const double across = x * (column + 0.5 - 216.7) + y * (row + 0.5 - 183.3);
        if (across < -2.6)
          QVERIFY2(pixelAt(image, column, row).grey() >= 252,
                   qPrintable(QString("gamma %1 at %2, %3").arg(gamma).arg(column).arg(row)));
      }
  }
}

void SectionsPictureTest::capsHideWhatIsBehind_data() {
  QTest::addColumn<float>("gamma");
  QTest::newRow("lines alone") << 1.0f;
  QTest::newRow("shaded") << 5.0f;
}

void SectionsPictureTest::capsHideWhatIsBehind() {
  QFETCH(float, gamma);
  model::Scene scene;
  add(scene, sphere(40.0f, 5), styled(gamma, red));
  // One ball is within the cut ball behind the cut, one behind the cut ball.
  add(scene, moved(*sphere(8.0f, 4), 1.0f, {10, 20, 5}), styled(4.0f, blue));
  add(scene, moved(*sphere(8.0f, 4), 1.0f, {-10, 70, -5}), styled(4.0f, blue));
  cut(scene, AnatomicalView::posterior, 0.0f);
  tintFaces(scene);
  const model::Camera from = frontal(100.0f);
  QCOMPARE(spot(picture(scene, from), bluish).count, 0);
  // If the eye is in the part that is gone, nothing of the inside shows either.
  model::Camera near;
  near.eye = {2.0f, -30.0f, 3.0f};
  near.target = {2.0f, 10.0f, 3.0f};
  near.fovyDegrees = 60.0f;
  const Image image = picture(scene, near);
  QCOMPARE(spot(image, bluish).count, 0);
  QVERIFY(reddish(pixelAt(image, 200, 200)));
}

void SectionsPictureTest::innerFaceLiesOnTheOuter_data() {
  QTest::addColumn<bool>("innerFirst");
  QTest::addColumn<bool>("perspective");
  for (const bool first : {false, true})
    for (const bool perspective : {false, true})
      QTest::addRow("%s, %s", first ? "inner first" : "outer first",
                    perspective ? "perspective" : "parallel")
          << first << perspective;
}

void SectionsPictureTest::innerFaceLiesOnTheOuter() {
  QFETCH(bool, innerFirst);
  QFETCH(bool, perspective);
  model::Scene scene;
  const auto inner = [&] { add(scene, sphere(20.0f, 5), styled(5.0f, blue)); };
  if (innerFirst)
    inner();
  add(scene, sphere(40.0f, 5), styled(5.0f, red));
  if (!innerFirst)
    inner();
  scene.appendSection({.id = {},
                       .name = "slanted",
                       .plane = {glm::normalize(glm::vec3(0.3f, -1.0f, 0.4f)), 0.0f},
                       .scope = model::rootId});
  tintFaces(scene);
  model::Camera camera = frontal(100.0f);
  if (perspective)
    camera = {.eye = {0, -300, 0}};
  const Image image = picture(scene, camera);
  // No speck of the outer shows through the inner face, which is a whole disc.
  const Spot disc = spot(image, bluish);
  int holes = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (std::hypot(x + 0.5 - disc.x, y + 0.5 - disc.y) < 38.0)
        holes += !bluish(pixelAt(image, x, y));
  QCOMPARE(holes, 0);
  QVERIFY(spot(image, reddish).count > disc.count);
}

void SectionsPictureTest::hatchingRunsAt45Degrees() {
  model::Scene scene;
  add(scene, sphere(40.0f, 5), styled(2.0f, red));
  cut(scene, AnatomicalView::posterior, 0.0f);
  const Image plain = picture(scene, frontal(100.0f));
  std::vector<model::Section> sections = scene.sections();
  sections.front().hatched = true;
  scene.setSections(sections);
  const Image hatched = picture(scene, frontal(100.0f));
  QVERIFY(difference(plain, hatched).share > 0.05);
  // Along a stroke nothing changes, across it does.
  double along = 0.0;
  double across = 0.0;
  for (int y = 120; y < 280; ++y)
    for (int x = 120; x < 280; ++x) {
      const int here = pixelAt(hatched, x, y).blue;
      along += std::abs(here - pixelAt(hatched, x + 3, y + 3).blue);
      across += std::abs(here - pixelAt(hatched, x + 3, y - 3).blue);
    }
  const double ratio = along / across;
  QVERIFY2(ratio < 0.05 || ratio > 20.0, qPrintable(QString::number(ratio)));
}

void SectionsPictureTest::inkAloneHasNoColour() {
  model::Scene scene = crowd(5.0f);
  cut(scene, AnatomicalView::posterior, 0.0f);
  QVERIFY(spot(picture(scene, frontal(120.0f)), reddish).count > 1000);
  const model::Edited bare = model::withInkAlone(scene);
  QVERIFY(bare.changed);
  QVERIFY(!model::withInkAlone(bare.scene).changed);
  const Image image = picture(bare.scene, frontal(120.0f));
  const auto coloured = [](const Pixel& p) {
    return std::max({p.red, p.green, p.blue}) - std::min({p.red, p.green, p.blue}) > 2;
  };
  QCOMPARE(spot(image, coloured).count, 0);
  QVERIFY(spot(image, drawn).count > 4000);  // the ink of the faces' hatching
}

SLINE_TEST_WITH_EVENTS(SectionsPictureTest)
#include "sections_picture_test.moc"
