// SPDX-License-Identifier: Apache-2.0
// Tests real bodies: the meshes yield what an anatomist would say of a structure's surroundings.
#include <QFileInfo>
#include <QTest>
#include <map>

#include "model/focus/context.h"
#include "model/import/plan/import.h"
#include "tests/support/suite.h"

namespace sline::model {

class FocusAnatomyTest : public QObject {
  Q_OBJECT

  struct Body {
    Scene scene;
    FormIndex forms;
  };
  std::map<QString, std::unique_ptr<Body>> m_bodies;

  Body* body(const QString& path) {
    const QString whole = QStringLiteral(SLINE_TEST_DATA "/") + path;
    if (!QFileInfo::exists(whole))
      return nullptr;
    auto& found = m_bodies[path];
    if (!found) {
      const std::filesystem::path paths[] = {whole.toStdString()};
      auto imported = importInputs(paths, {}, {});
      if (!imported.ok())
        qFatal("%s", imported.error().text().c_str());
      found = std::make_unique<Body>();
      found->scene = std::move(imported->scene);
    }
    return found.get();
  }

 private slots:
  void rolesAreWhatAnatomistsSay_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("target");
    QTest::addColumn<QStringList>("feeders");
    QTest::addColumn<QStringList>("neighbours");
    QTest::addColumn<QStringList>("shells");
    const QString abdomen = QStringLiteral("abdomen/AbdominalAtlas-2015Sept-Slicer4-4Version.mrml");
    const QString pelvis = QStringLiteral("pelvis/bodyparts3d");
    QTest::newRow("right kidney") << abdomen << "right kidney"
                                  << QStringList{"right renal artery", "right renal vein",
                                                 "right ureter", "aorta", "inferior vena cava"}
                                  << QStringList{"right adrenal gland", "liver",
                                                 "right psoas muscle",
                                                 "right quadratus lumborum muscle",
                                                 "stomach and duodenum"}
                                  << QStringList{"rectus abdominis muscle",
                                                 "right external oblique muscle",
                                                 "right internal oblique muscle",
                                                 "right erector spinae muscle",
                                                 "Rib11",
                                                 "Rib10"};
    QTest::newRow("left kidney") << abdomen << "left kidney"
                                 << QStringList{"left renal artery", "left renal vein",
                                                "left ureter", "aorta", "inferior vena cava"}
                                 << QStringList{"left adrenal gland", "spleen", "left psoas muscle",
                                                "left quadratus lumborum muscle"}
                                 << QStringList{"rectus abdominis muscle",
                                                "left external oblique muscle",
                                                "left internal oblique muscle",
                                                "left erector spinae muscle", "Rib11"};
    QTest::newRow("liver") << abdomen << "liver"
                           << QStringList{"portal vein and superior mesenteric vein",
                                          "right hepatic artery", "left hepatic artery",
                                          "right hepatic vein", "inferior vena cava"}
                           << QStringList{"gallbladder", "right kidney", "right adrenal gland",
                                          "stomach and duodenum"}
                           << QStringList{"rectus abdominis muscle", "Rib9", "Rib8"};
    QTest::newRow("urinary bladder")
        << pelvis << "urinary bladder" << QStringList{"left ureter", "right ureter", "urethra"}
        << QStringList{"prostate", "rectum"}
        << QStringList{"left hip bone", "right hip bone", "sacrum"};
    QTest::newRow("prostate") << pelvis << "prostate" << QStringList{"urethra"}
                              << QStringList{"urinary bladder", "right pubococcygeus"}
                              << QStringList{"left hip bone", "right hip bone", "sacrum"};
  }
  void rolesAreWhatAnatomistsSay() {
    QFETCH(QString, path);
    QFETCH(QString, target);
    QFETCH(QStringList, feeders);
    QFETCH(QStringList, neighbours);
    QFETCH(QStringList, shells);
    Body* known = body(path);
    if (!known)
      SLINE_ABSENT("no real anatomy here");
    const std::vector<NodeId> targets = known->scene.named(target.toStdString());
    const auto analysis = analysed(known->scene, {targets, std::nullopt}, known->forms);
    QVERIFY(analysis);
    QStringList wrong;
    const auto expect = [&](const QStringList& names, ContextRole role, const char* word) {
      for (const QString& name : names) {
        const std::vector<NodeId> ids = known->scene.named(name.toStdString());
        if (ids.size() != 1) {
          wrong << name + " is not there";
          continue;
        }
        for (const Relation& relation : analysis->relations)
          if (relation.structure == ids.front() && relation.role != role)
            wrong << QStringLiteral("%1 is not a %2 but %3")
                         .arg(name, QLatin1String(word))
                         .arg(int(relation.role));
      }
    };
    expect({target}, ContextRole::target, "target");
    expect(feeders, ContextRole::feeder, "feeder");
    expect(neighbours, ContextRole::neighbour, "neighbour");
    expect(shells, ContextRole::shell, "shell");
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join("; ")));
  }
};

}  // namespace sline::model

SLINE_TEST(sline::model::FocusAnatomyTest)
#include "focus_anatomy_test.moc"
