// SPDX-License-Identifier: Apache-2.0
// Tests real bodies: the meshes yield what an anatomist would say of a structure's surroundings.
#include <QFileInfo>
#include <QRegularExpression>
#include <QTest>
#include <map>

#include "model/demo/demo.h"
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

  /// Returns the structures in pairs by their names, as they stand in the files: "left" or "right",
  /// or an L or R at the end or between spaces; the codes of atlases aside.
  static std::vector<std::pair<NodeId, NodeId>> pairsOf(const Scene& scene) {
    static const QRegularExpression left("(^|[ _])(left|l)($|[ _])",
                                         QRegularExpression::CaseInsensitiveOption);
    static const QRegularExpression code(" [0-9]{3,}$");
    std::map<QString, NodeId> names;
    for (const NodeId id : scene.structuresBelow(rootId))
      names[QString::fromStdString(scene.find(id)->name).toLower().remove(code)] = id;
    std::vector<std::pair<NodeId, NodeId>> pairs;
    for (const auto& [name, id] : names) {
      const QRegularExpressionMatch match = left.match(name);
      if (!match.hasMatch())
        continue;
      QString other = name;
      other.replace(match.capturedStart(2), match.capturedLength(2),
                    match.captured(2) == "l" ? "r" : "right");
      if (const auto found = names.find(other); found != names.end())
        pairs.emplace_back(id, found->second);
    }
    return pairs;
  }

  /// Returns what the focus decides of a structure.
  static Style drawn(const Scene& scene, NodeId id) {
    Style style = scene.find(id)->style;
    style.colour.reset();
    style.inkColour.reset();
    return style;
  }

  Body* body(const QString& path) {
    if (path.startsWith("demo ")) {
      auto& made = m_bodies[path];
      if (!made) {
        made = std::make_unique<Body>();
        made->scene = demo(*demoNamed(path.mid(5).toStdString()), Sex::male, {});
      }
      return made.get();
    }
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
    for (const Relation& relation : analysis->relations)
      if (relation.role == ContextRole::feeder &&
          (relation.tissue == Tissue::bone || relation.tissue == Tissue::joint ||
           relation.tissue == Tissue::muscle))
        wrong << QString::fromStdString(known->scene.find(relation.structure)->name) +
                     " is taken for a vessel or duct";
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join("; ")));
  }

  /// Where the subject lies on the body's middle, left and right are drawn alike from whatever side
  /// and with however much context (METHOD §12.3).
  void pairsOutsideTheFocusAreAlike_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<QStringList>("subject");
    QTest::addColumn<int>("fewest");
    const QString abdomen = QStringLiteral("abdomen/AbdominalAtlas-2015Sept-Slicer4-4Version.mrml");
    const QString pelvis = QStringLiteral("pelvis/bodyparts3d");
    const QString male = QStringLiteral("pelvis/hra_vh_male");
    const QString labels = QStringLiteral("labelmap/totalsegmentator/ct_total_labels_3mm.nii.gz");
    QTest::newRow("pancreas") << abdomen << QStringList{"pancreas"} << 24;
    QTest::newRow("great vessels") << abdomen << QStringList{"aorta", "inferior vena cava"} << 24;
    QTest::newRow("urinary bladder") << pelvis << QStringList{"urinary bladder"} << 15;
    QTest::newRow("rectum and prostate") << pelvis << QStringList{"rectum", "prostate"} << 15;
    QTest::newRow("zones of the prostate")
        << male << QStringList{"peripheral zone of prostate L", "peripheral zone of prostate R"}
        << 15;
    QTest::newRow("fundus of the bladder")
        << male << QStringList{"fundus of urinary bladder dome"} << 15;
    QTest::newRow("bladder in a label map") << labels << QStringList{"urinary bladder"} << 15;
    QTest::newRow("spinal cord") << labels << QStringList{"spinal cord"} << 15;
    QTest::newRow("pelvis that is modelled")
        << "demo pelvis" << QStringList{"urinary bladder"} << 5;
    QTest::newRow("abdomen that is modelled") << "demo abdomen" << QStringList{"pancreas"} << 2;
  }
  void pairsOutsideTheFocusAreAlike() {
    QFETCH(QString, path);
    QFETCH(QStringList, subject);
    QFETCH(int, fewest);
    Body* known = body(path);
    if (!known)
      SLINE_ABSENT("no real anatomy here");
    const Scene& scene = known->scene;
    std::vector<NodeId> targets;
    for (const QString& name : subject) {
      const auto ids = scene.named(name.toStdString());
      QVERIFY2(!ids.empty(), qPrintable(name));
      targets.push_back(ids.front());
    }
    QStringList unlike;
    int compared = 0;
    for (const std::optional<AnatomicalView> view :
         {std::optional<AnatomicalView>(), std::optional(AnatomicalView::anterior),
          std::optional(AnatomicalView::left)}) {
      FocusQuestion question{.targets = targets};
      if (view)
        question.camera = anatomicalCamera(*view, scene.visibleBounds(), 1.0f);
      const auto analysis = analysed(scene, question, known->forms);
      QVERIFY(analysis);
      for (const float amount : {0.3f, 0.5f, 0.8f}) {
        const Scene after =
            withFocusAndContext(scene, *analysis, ContextAmount::clamped(amount)).scene;
        for (const auto& [left, right] : pairsOf(scene)) {
          const auto isTarget = [&](NodeId id) {
            return std::find(targets.begin(), targets.end(), id) != targets.end();
          };
          if (isTarget(left) || isTarget(right))
            continue;
          ++compared;
          if (drawn(after, left) != drawn(after, right))
            unlike << QString::fromStdString(scene.find(left)->name);
        }
      }
    }
    QVERIFY2(compared >= 9 * fewest, qPrintable(QString::number(compared)));
    QVERIFY2(unlike.isEmpty(), qPrintable(unlike.join("; ")));
    qInfo("%d pairs compared", compared);
  }

  /// Ribs, vertebrae and discs are each drawn alike, whatever is in focus.
  void familiesAreTreatedWhole_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("target");
    QTest::addColumn<QString>("members");
    const QString abdomen = QStringLiteral("abdomen/AbdominalAtlas-2015Sept-Slicer4-4Version.mrml");
    const QString labels = QStringLiteral("labelmap/totalsegmentator/ct_total_labels_3mm.nii.gz");
    for (const char* target : {"liver", "left kidney", "pancreas"}) {
      QTest::addRow("ribs round the %s", target) << abdomen << target << "^Rib[0-9]+$";
      QTest::addRow("vertebrae behind the %s", target)
          << abdomen << target << "^(Thoracic|Lumbar)[0-9]+$";
      QTest::addRow("discs behind the %s", target) << abdomen << target << "IntervertebralDisc$";
    }
    QTest::newRow("ribs of a label map") << labels << "liver"
                                         << "^rib (left|right) [0-9]+$";
    QTest::newRow("calyces") << "pelvis/hra_vh_male"
                             << "urinary bladder neck smooth muscle"
                             << "^minor calyx [LR] [a-i]$";
  }
  void familiesAreTreatedWhole() {
    QFETCH(QString, path);
    QFETCH(QString, target);
    QFETCH(QString, members);
    Body* known = body(path);
    if (!known)
      SLINE_ABSENT("no real anatomy here");
    const std::vector<NodeId> targets = known->scene.named(target.toStdString());
    const auto analysis = analysed(known->scene, {targets, std::nullopt}, known->forms);
    QVERIFY(analysis);
    const Scene after =
        withFocusAndContext(known->scene, *analysis, ContextAmount::clamped(0.5f)).scene;
    const QRegularExpression fits(members);
    std::vector<NodeId> family;
    for (const NodeId id : after.structuresBelow(rootId))
      if (fits.match(QString::fromStdString(after.find(id)->name)).hasMatch())
        family.push_back(id);
    QVERIFY(family.size() >= 6);
    for (const NodeId id : family)
      QVERIFY2(drawn(after, id) == drawn(after, family.front()), after.find(id)->name.c_str());
  }
};

}  // namespace sline::model

SLINE_TEST(sline::model::FocusAnatomyTest)
#include "focus_anatomy_test.moc"
