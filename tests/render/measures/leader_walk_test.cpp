// SPDX-License-Identifier: Apache-2.0
// Walks scenes and views and judges by pictures alone that every leader which is not dashed ends on
// what its label names, and that one sees it there.
#include <QDir>
#include <QtTest>
#include <glm/geometric.hpp>

#include "model/demo/demo.h"
#include "model/import/plan/import.h"
#include "model/look/opening_look.h"
#include "render/labels/seen/seen_map.h"
#include "render/measures/leader_truth.h"
#include "render/picture/headless/headless_picture.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::render;

namespace {

constexpr int height = 480;
constexpr float aspect = 4.0f / 3.0f;
constexpr glm::vec2 paper{254.0f, 190.5f};

/// One look at a scene.
struct Walk {
  const char* scene;
  const char* file;  ///< of the test data; null for the program's own scene of that name
  model::AnatomicalView view;
  std::optional<model::AnatomicalView> kept;  ///< of a section through the middle
  bool opening;                               ///< with the look that it opens with, else shaded
};

using enum model::AnatomicalView;
constexpr std::array<Walk, 7> walks{
    {{"kidney", nullptr, anterior, {}, true},
     {"kidney", nullptr, inferior, superior, false},
     {"pelvis", nullptr, superior, {}, true},
     {"pelvis", nullptr, left, right, false},
     {"abdomen", "abdomen/AbdominalAtlas-2015Sept-Slicer4-4Version.mrml", superior, {}, true},
     {"bodyparts", "pelvis/bodyparts3d", superior, {}, true},
     {"bodyparts", "pelvis/bodyparts3d", inferior, superior, true}}};

}  // namespace

class LeaderWalkTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    auto picture = HeadlessPicture::create();
    if (!picture.ok())
      QSKIP(picture.error().text().c_str());
    m_picture.emplace(std::move(*picture));
  }

  void solidLeadersAreRight_data() {
    QTest::addColumn<int>("walk");
    for (std::size_t i = 0; i < walks.size(); ++i)
      QTest::addRow("%s from side %d%s%s", walks[i].scene, int(walks[i].view),
                    walks[i].kept ? ", cut" : "", walks[i].opening ? "" : ", shaded")
          << int(i);
  }
  void solidLeadersAreRight() {
    QFETCH(int, walk);
    const Walk& at = walks[std::size_t(walk)];
    std::optional<model::Scene> scene = sceneOf(at);
    if (!scene)
      SLINE_ABSENT("there is no such anatomy here");
    const model::Box bounds = scene->visibleBounds();
    model::Camera camera = model::anatomicalCamera(at.view, bounds, aspect);
    if (at.opening) {
      model::FormIndex forms;
      if (auto look = model::openingLook(*scene, forms, {.camera = camera, .aspect = aspect}))
        scene = std::move(look->scene);
    } else {
      std::vector<model::Node> nodes = scene->nodes();
      for (model::Node& node : nodes)
        node.style.gamma = Gamma::clamped(5.0f);
      scene->setNodes(std::move(nodes));
    }
    scene->setAnnotations({});
    if (at.kept)
      scene->appendSection(
          {.plane = model::anatomicalPlane(*at.kept, bounds.centre()[model::axisOf(*at.kept)])});
    constexpr float scale = float(height) / paper.y;
    const SeenMap map(*scene, Screen(camera, paper));
    std::vector<LeaderEnd> ends;
    for (const model::NodeId id : scene->structuresBelow(model::rootId))
      if (const auto place = scene->resolve(id).visible ? map.find(id) : std::nullopt)
        ends.push_back({id, scale * place->place, place->hidden});
    const DrawPicture draw = (*m_picture)->drawing();
    const auto verdicts =
        judgeLeaders(draw,
                     {.scene = *scene,
                      .camera = camera,
                      .settings = {.width = int(aspect * float(height)), .height = height},
                      .dotRadius = 0.5f * scale},
                     ends);
    QVERIFY(verdicts.ok());
    int solid = 0;
    std::string faults;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const LeaderVerdict& verdict = (*verdicts)[i];
      solid += ends[i].dashed ? 0 : 1;
      if (ends[i].dashed || verdict.fault == LeaderFault::none)
        continue;
      faults += scene->find(ends[i].structure)->name + " at " +
                std::to_string(int(ends[i].place.x)) + "," + std::to_string(int(ends[i].place.y)) +
                " (" + std::to_string(int(verdict.fault)) + ", one sees " +
                (verdict.seen ? scene->find(*verdict.seen)->name : std::string("ground")) + "); ";
    }
    qInfo("%d solid of %d", solid, int(ends.size()));
    QVERIFY(solid > 0);
    QVERIFY2(faults.empty(), faults.c_str());
  }

 private:
  std::optional<model::Scene> sceneOf(const Walk& walk) {
    if (const auto known = m_scenes.find(walk.scene); known != m_scenes.end())
      return known->second;
    std::optional<model::Scene>& scene = m_scenes[walk.scene];
    if (!walk.file) {
      scene = model::demo(*model::demoNamed(walk.scene), model::Sex::female,
                          QDir::tempPath().toStdString());
      return scene;
    }
    const QString path = QString(SLINE_TEST_DATA) + "/" + walk.file;
    if (!QFileInfo::exists(path))
      return scene;
    const std::vector<std::filesystem::path> inputs{path.toStdString()};
    if (auto imported = model::importInputs(inputs, {}); imported.ok())
      scene = std::move(imported->scene);
    return scene;
  }

  std::optional<HeadlessPicture> m_picture;
  std::map<std::string, std::optional<model::Scene>> m_scenes;
};

SLINE_TEST(LeaderWalkTest)
#include "leader_walk_test.moc"
