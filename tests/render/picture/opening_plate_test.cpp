// SPDX-License-Identifier: Apache-2.0
// Measures on real anatomy that what opens is a plate (METHOD §12, proof): most of the subject is
// seen, little of the sheet is ink, and some of it has colour.
#include <QElapsedTimer>
#include <QFileInfo>
#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/base/parallel.h"
#include "model/geometry/mesh_trees.h"
#include "model/import/plan/import.h"
#include "model/look/opening_look.h"
#include "model/scene/visible_structures.h"
#include "render/picture/headless/headless_picture.h"
#include "tests/support/suite.h"

namespace sline::render {

class OpeningPlateTest : public QObject {
  Q_OBJECT

  static constexpr int width = 1600;
  static constexpr int height = 1200;

  /// Tells whether a structure hides what is behind it: what is nothing but lines does not.
  static bool hides(const model::ResolvedStyle& style) {
    return style.fill != model::Fill::none && style.opacity.value() > 0.3f;
  }

  /// Returns the share of the subject's own silhouette, as the camera sees it, that no filled
  /// structure of the context hides.
  static double visibleShare(const model::OpeningLook& look) {
    struct Body {
      model::BvhPtr tree;
      bool asked;
    };
    std::vector<Body> bodies;
    const auto& wanted = look.subject.structures;
    for (const model::VisibleStructure& each : model::visibleStructures(look.scene)) {
      const bool asked = std::find(wanted.begin(), wanted.end(), each.node->id) != wanted.end();
      if (asked || hides(each.style))
        bodies.push_back({model::treeOf(each.node->mesh), asked});
    }
    const model::Camera& camera = look.camera;
    const model::CameraFrame frame = model::cameraFrame(camera);
    const float half = std::tan(0.5f * camera.fovyDegrees * float(M_PI) / 180.0f);
    constexpr int step = 8;
    std::vector<int> own(height / step, 0);
    std::vector<int> seen(height / step, 0);
    parallelFor(own.size(), 4, [&](std::size_t row) {
      for (int x = step / 2; x < width; x += step) {
        const float u = (2.0f * float(x) / float(width) - 1.0f) * float(width) / float(height);
        const float v = 1.0f - 2.0f * float(int(row) * step + step / 2) / float(height);
        const glm::vec3 way =
            glm::normalize(half * u * frame.right + half * v * frame.up - frame.back);
        float subject = std::numeric_limits<float>::infinity();
        float context = subject;
        for (const Body& body : bodies) {
          float& nearest = body.asked ? subject : context;
          if (const auto hit = body.tree->nearest({camera.eye, way, 0.0f, nearest}))
            nearest = std::min(nearest, hit->t);
        }
        own[row] += std::isfinite(subject);
        seen[row] += std::isfinite(subject) && subject <= context;
      }
    });
    int all = 0;
    int shown = 0;
    for (std::size_t i = 0; i < own.size(); ++i) {
      all += own[i];
      shown += seen[i];
    }
    return all > 0 ? double(shown) / double(all) : 0.0;
  }

  struct Shares {
    double ink = 0.0;       ///< darker than a third of the paper
    double coloured = 0.0;  ///< with a hue that one sees
  };
  static Shares sharesOf(const Image& image) {
    Shares shares;
    const double each = 1.0 / double(image.width * image.height);
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
      const auto [low, high] = std::minmax({image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]});
      constexpr int dark = 85;
      constexpr int hue = 20;
      shares.ink += high < dark ? each : 0.0;
      shares.coloured += high - low >= hue ? each : 0.0;
    }
    return shares;
  }

 private slots:
  void plates_data() {
    QTest::addColumn<QString>("path");
    QTest::newRow("abdomen") << "abdomen/AbdominalAtlas-2015Sept-Slicer4-4Version.mrml";
    QTest::newRow("label map") << "labelmap/spl_abdomen/spl_abdomen_labels.nrrd";
    QTest::newRow("segmentation") << "labelmap/totalsegmentator/ct_total_labels_3mm.nii.gz";
    QTest::newRow("pelvis") << "pelvis/bodyparts3d";
    QTest::newRow("male pelvis") << "pelvis/hra_vh_male";
    QTest::newRow("protein") << "protein/2src.pdb";
    QTest::newRow("liver vessels") << "misc/bp3d_liver_vessels";
    QTest::newRow("heart") << "misc/hra/VH_F_Heart.glb";
  }
  void plates() {
    QFETCH(QString, path);
    const QString whole = QStringLiteral(SLINE_TEST_DATA "/") + path;
    if (!QFileInfo::exists(whole))
      SLINE_ABSENT("the anatomy is not there");
    const std::filesystem::path paths[] = {whole.toStdString()};
    const auto imported = model::importInputs(paths, {}, {});
    QVERIFY(imported.ok());
    model::FormIndex forms;
    QElapsedTimer timer;
    timer.start();
    const std::optional<model::OpeningLook> look =
        model::openingLook(imported->scene, forms, {.aspect = float(width) / float(height)});
    const qint64 ms = timer.elapsed();
    QVERIFY(look);
    const double visible = visibleShare(*look);
    const auto picture = HeadlessPicture::create();
    QVERIFY(picture.ok());
    const auto image =
        (*picture)->render(look->scene, look->camera, {.width = width, .height = height});
    QVERIFY(image.ok());
    const Shares shares = sharesOf(*image);
    qInfo("%s: %.0f %% of the subject seen, %.1f %% ink, %.1f %% coloured, chosen in %lld ms",
          qPrintable(path), 100.0 * visible, 100.0 * shares.ink, 100.0 * shares.coloured, ms);
    QVERIFY(visible >= 0.6);
    QVERIFY(shares.ink <= 0.1);
    QVERIFY(shares.coloured >= 0.03);
  }
};

}  // namespace sline::render

SLINE_TEST(sline::render::OpeningPlateTest)
#include "opening_plate_test.moc"
