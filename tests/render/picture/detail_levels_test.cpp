// SPDX-License-Identifier: Apache-2.0
// Tests that pictures of surfaces whose triangles are far smaller than pixels show a coarser one,
// and show no difference by it.
#include "render/picture/surfaces/detail_levels.h"

#include <QImage>
#include <QtTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

#include "render/picture/surfaces/surface_cache.h"
#include "tests/render/picture/scenes.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using render::CachedSurface;
using render::Image;
using render::PictureSettings;

namespace {

/// A torus with waves all over it, of twice so many triangles.
model::MeshPtr fineMesh(int aroundRing, int aroundTube) {
  const model::MeshPtr smooth = torus(50.0f, 20.0f, aroundRing, aroundTube);
  std::vector<glm::vec3> positions(smooth->positions().begin(), smooth->positions().end());
  for (glm::vec3& p : positions)
    p += 1.2f * glm::vec3(std::sin(0.16f * p.y), std::sin(0.13f * p.z), std::sin(0.2f * p.x));
  const auto triangles = smooth->triangles();
  return std::make_shared<const model::Mesh>(
      std::move(*model::Mesh::create(std::move(positions), {triangles.begin(), triangles.end()})));
}

model::Camera slantedCamera() {
  model::Camera camera = frontal(190.0f);
  camera.eye = {60.0f, -320.0f, 170.0f};
  return camera;
}

}  // namespace

class DetailLevelsTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    m_levels = openStudio({});
    if (!m_levels.absent.empty())
      QSKIP(m_levels.absent.c_str());
    QVERIFY2(m_levels.fault.empty(), m_levels.fault.c_str());
    auto picture = render::Picture::create({.levelsOfDetail = false});
    QVERIFY(picture.ok());
    m_whole = std::move(*picture);
    m_mesh = fineMesh(1000, 320);
  }

  void theCoarsestThatIsAllowedIsShown() {
    render::DetailLevels levels;
    QVERIFY(levels.empty());
    const auto trianglesAt = [&](float edge, bool hurried = false) {
      return levels.at(m_mesh, {}, {.edge = edge, .hurried = hurried})
          .surface->mesh->triangleCount();
    };
    const std::size_t all = m_mesh->triangleCount();
    QCOMPARE(trianglesAt(0.0f), all);
    QCOMPARE(levels.at(m_mesh, {}, {}).surface->mesh, m_mesh);
    // A level that takes time to make is not made in a hurry, ...
    QCOMPARE(trianglesAt(1.0f, true), all);
    const std::size_t first = trianglesAt(1.0f);
    QVERIFY2(first < all / 2, qPrintable(QString::number(first)));
    // ... and one that is there is shown at once.
    QCOMPARE(trianglesAt(1.0f, true), first);
    QCOMPARE(trianglesAt(0.0f, true), all);
    QCOMPARE(trianglesAt(0.0f), all);
    // Levels end where little is left to win.
    const std::size_t last = trianglesAt(50.0f);
    QVERIFY(last < 200'000 && last > 20'000);
    QCOMPARE(trianglesAt(1.0f), first);
  }

  /// Whichever levels were prepared before, each has normals and curvature of the mesh itself.
  void verticesAreThoseOfTheMesh() {
    const model::MeshPtr finest = fineMesh(1400, 480);
    render::DetailLevels levels;
    const auto at = [](render::DetailLevels& of, const model::MeshPtr& mesh, float edge) {
      return of.at(mesh, {}, {.edge = edge}).surface;
    };
    const model::SurfacePtr second = at(levels, finest, 4.0f);
    const model::SurfacePtr first = at(levels, finest, 1.0f);
    const model::SurfacePtr whole = at(levels, finest, 0.0f);
    QVERIFY(second->mesh->triangleCount() < first->mesh->triangleCount());
    std::map<std::tuple<float, float, float>, std::uint32_t> places;
    for (std::uint32_t v = 0; v < whole->mesh->vertexCount(); ++v) {
      const glm::vec3& p = whole->mesh->positions()[v];
      places[{p.x, p.y, p.z}] = v;
    }
    const auto same = [&](const model::Surface& level, const model::Surface& mesh) {
      for (std::size_t v = 0; v < level.vertices.size(); ++v) {
        const model::SurfaceVertex& own = level.vertices[v];
        const model::SurfaceVertex& fine =
            mesh.vertices[places.at({own.position.x, own.position.y, own.position.z})];
        if (level.mesh->positions()[v] != own.position || own.normal != fine.normal ||
            own.e1 != fine.e1 || own.k != fine.k || own.derivative != fine.derivative)
          return false;
      }
      return true;
    };
    QVERIFY(same(*first, *whole));
    QVERIFY(same(*second, *whole));
    render::DetailLevels down;
    const model::SurfacePtr again = at(down, finest, 0.0f);
    QVERIFY(same(*at(down, finest, 1.0f), *again));
    QVERIFY(same(*at(down, finest, 4.0f), *again));
  }

  /// Larger forms of a level are those of the mesh itself.
  void scalesAreThoseOfTheMesh() {
    render::DetailLevels levels;
    render::CachedSurface& coarse = levels.at(m_mesh, {}, {.edge = 1.0f});
    render::CachedSurface& whole = levels.at(m_mesh, {}, {});
    const float deviation = 4.0f * whole.surface->meanEdge;
    const auto ofCoarse = coarse.scales.at(coarse.surface, deviation);
    const auto ofWhole = whole.scales.at(whole.surface, deviation);
    QCOMPARE(ofCoarse.size(), std::size_t(1));
    QCOMPARE(ofWhole.size(), std::size_t(1));
    std::map<std::tuple<float, float, float>, glm::vec2> known;
    for (const model::SurfaceVertex& v : ofWhole[0].surface->vertices.all())
      known[{v.position.x, v.position.y, v.position.z}] = v.k;
    for (const model::SurfaceVertex& v : ofCoarse[0].surface->vertices.all())
      QVERIFY(known.at({v.position.x, v.position.y, v.position.z}) == v.k);
    QCOMPARE(ofCoarse[0].surface->mesh, coarse.surface->mesh);
  }

  void nothingHasOneLevel() {
    const auto none = std::make_shared<const model::Mesh>(*model::Mesh::create({}, {}));
    render::DetailLevels levels;
    QCOMPARE(levels.at(none, {}, {.edge = 1.0f}).surface->mesh, model::MeshPtr(none));
    QCOMPARE(levels.at(none, {}, {}).surface->mesh, model::MeshPtr(none));
  }

  void coarsenessFollowsThePicture() {
    render::DrawnStructure shown;
    shown.mesh = m_mesh;
    shown.style = model::ResolvedStyle();
    shown.style.gamma = Gamma::clamped(1.0f);
    PictureSettings settings{.width = 400, .height = 400};
    const auto allowed = [&](model::Camera camera, float size) {
      settings.width = settings.height = int(size);
      const render::PictureView view(camera, m_mesh->bounds(), settings.width, settings.height);
      return render::allowedCoarseness(shown, view, settings).edge;
    };
    const float once = allowed(slantedCamera(), 400.0f);
    QVERIFY(once > 0.0f);
    QVERIFY(std::abs(allowed(slantedCamera(), 800.0f) / once - 0.5f) < 0.01f);
    // One that will be reduced again shows the same one.
    settings.samples = 2;
    QVERIFY(std::abs(allowed(slantedCamera(), 800.0f) / once - 1.0f) < 0.01f);
    settings.samples = 1;
    // So does a moving one.
    settings.surfaceStep = 3;
    QCOMPARE(allowed(slantedCamera(), 400.0f), once);
    settings.surfaceStep = 1;
    shown.style.gammaMap.scalar = model::GammaScalar::curvature;
    shown.style.gammaMap.curve = {{0.0f, 1.0f}};
    QCOMPARE(allowed(slantedCamera(), 400.0f), 0.0f);
    shown.style.gammaMap = {};
    // From within it may be as near as can be.
    model::Camera inside = slantedCamera();
    inside.projection = model::Projection::perspective;
    inside.eye = inside.target - glm::vec3(0.0f, 5.0f, 0.0f);
    QCOMPARE(allowed(inside, 400.0f), 0.0f);
  }

  void samplesAreTakenOfCoarserForms() {
    const model::MeshPtr mesh = torus(50.0f, 20.0f, 250, 80);
    const model::SurfacePtr surface = model::prepareSurface(mesh);
    render::SampleLevels levels;
    const auto at = [&](float edges, bool hurried = false) {
      return levels.at(*surface, {.edge = edges * surface->meanEdge, .hurried = hurried});
    };
    QVERIFY(!at(0.0f));
    QVERIFY(!at(1.5f));
    // What is not there is not made in a hurry.
    QVERIFY(!at(3.0f, true));
    const model::Clusters* first = at(3.0f);
    QVERIFY(first && first->localTriangles.size() < mesh->triangleCount() / 2);
    QCOMPARE(at(3.0f, true), first);
    const model::Clusters* second = at(6.0f);
    QVERIFY(second && second->localTriangles.size() < first->localTriangles.size() / 2);
    QCOMPARE(at(3.0f), first);
    QVERIFY(!at(1.0f));
    // Its corners are the surface's own, and its clusters hold them.
    for (const model::Cluster& cluster : second->items)
      for (std::uint32_t i = 0; i < cluster.vertexCount; ++i) {
        const std::uint32_t vertex = second->vertices[cluster.firstVertex + i];
        QVERIFY(vertex < mesh->vertexCount());
        QVERIFY(glm::distance(mesh->positions()[vertex], cluster.bounds.centre) <=
                cluster.bounds.radius);
      }
    // There is an end to it.
    const model::Clusters* last = at(1000.0f);
    QVERIFY(last && last->localTriangles.size() >= 200);
  }

  void nobodySeesIt_data() {
    QTest::addColumn<float>("gamma");
    QTest::addColumn<int>("step");
    QTest::newRow("contours") << 0.8f << 1;
    QTest::newRow("suggestive contours") << 2.0f << 1;
    QTest::newRow("hatching") << 3.0f << 1;
    QTest::newRow("shading") << 4.6f << 1;
    QTest::newRow("moving") << 2.0f << 2;
    QTest::newRow("moving, hatched") << 3.0f << 3;
    QTest::newRow("moving, shaded") << 4.6f << 3;
  }

  void nobodySeesIt() {
    QFETCH(float, gamma);
    QFETCH(int, step);
    model::Scene scene;
    add(scene, m_mesh, gammaStyle(gamma));
    const PictureSettings settings{.width = 180, .height = 150, .surfaceStep = step};
    const auto expected = m_whole->render(scene, slantedCamera(), settings);
    const auto found = m_levels.picture->render(scene, slantedCamera(), settings);
    QVERIFY(expected.ok() && found.ok());
    if (const QByteArray folder = qgetenv("SLINE_PICTURES"); !folder.isEmpty()) {
      const auto save = [&](const Image& image, const char* what) {
        QImage(image.rgba.data(), image.width, image.height, QImage::Format_RGBA8888)
            .save(QString("%1/%2 %3.png").arg(folder, QTest::currentDataTag(), what));
      };
      save(*expected, "whole");
      save(*found, "level");
    }
    const Difference apart = difference(*expected, *found);
    QVERIFY2(apart.mean > 0.0 && apart.mean <= 1.0,
             qPrintable(QString("mean %1, %2 % of pixels, largest %3")
                            .arg(apart.mean)
                            .arg(100.0 * apart.share)
                            .arg(apart.largest)));
    qInfo("mean %.3f, %.2f %% of pixels", apart.mean, 100.0 * apart.share);
  }

 private:
  Studio m_levels;
  std::unique_ptr<render::Picture> m_whole;
  model::MeshPtr m_mesh;
};

SLINE_TEST(DetailLevelsTest)
#include "detail_levels_test.moc"
