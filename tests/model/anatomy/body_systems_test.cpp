// SPDX-License-Identifier: Apache-2.0
#include <QtTest>

#include "model/anatomy/body_systems.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

class BodySystemsTest : public QObject {
  Q_OBJECT
 private slots:
  void tableIsWhole();
  void systems_data();
  void systems();
  void brokenRowsAreLeftOut();
  void edits();
  void coloursByName();
};

void BodySystemsTest::tableIsWhole() {
  const AnatomyTable table;
  QVERIFY(table.patternCount() >= 200);
  QCOMPARE(table.badRows(), std::size_t(0));
}

void BodySystemsTest::systems_data() {
  QTest::addColumn<QString>("system");
  const std::pair<const char*, const char*> rows[] = {
      {"hepatic artery proper", "artery"},
      {"right_hepatic_artery", "artery"},
      {"celiac trunk", "artery"},
      {"aorta", "artery"},
      {"iliac_artery_left", "artery"},
      {"left renal vein", "vein"},
      {"inferior vena cava", "vein"},
      {"iliac_vena_right", "vein"},
      {"tributary of middle hepatic vein", "vein"},
      {"portal vein and superior mesenteric vein", "portal"},
      {"splenic vein", "portal"},
      {"caudate lobe branch of left portal vein", "portal"},
      {"left sciatic nerve", "nerve"},
      {"lumbar plexus", "nerve"},
      {"liver", "digestive"},
      {"caudate lobe of liver", "digestive"},
      {"hepatovenous segment VIII", "digestive"},
      {"stomach and duodenum", "digestive"},
      {"colon and ileum", "digestive"},
      {"rectum", "digestive"},
      {"pancreas", "digestive"},
      {"gallbladder", "bile"},
      {"common bile duct", "bile"},
      {"left duct of caudate lobe of liver", "bile"},
      {"spleen", "lymph"},
      {"axillary lymph node", "lymph"},
      {"right kidney", "urinary"},
      {"left renal pelvis", "urinary"},
      {"urinary_bladder_neck_smooth_muscle", "urinary"},
      {"ureter L", "urinary"},
      {"Pelvis", "bone"},
      {"right hip bone", "bone"},
      {"Rib6", "bone"},
      {"Thoracic12", "bone"},
      {"vertebrae_L3", "bone"},
      {"Sacrum-L5-IntervertebralDisc", "joint"},
      {"intervertebral disk of fifth lumbar vertebra", "joint"},
      {"right psoas muscle", "muscle"},
      {"left external oblique muscle", "muscle"},
      {"gluteus_maximus_left", "muscle"},
      {"left obturator internus", "muscle"},
      {"right iliococcygeus", "muscle"},
      {"left coccygeus", "muscle"},
      {"levator ani", "muscle"},
      {"rectus abdominis muscle", "muscle"},
      {"prostate", "genital"},
      {"left seminal vesicle", "genital"},
      {"right deferent duct", "genital"},
      {"left adrenal gland", "gland"},
      {"trachea", "respiratory"},
      {"left ventricle", "heart"},
      {"spinal cord", "brain"},
      {"Frontal_Sup_Orb_L", "brain"},
      {"SupraMarginal_R", "brain"},
      {"Lingual_L", "brain"},
      {"lingual artery", "artery"},
      {"superior temporal vein", "vein"},
      {"Middle_cerebellar_peduncle", "brain"},
      {"frontal bone", "bone"},
      {"frontal nerve", "nerve"},
      {"rectus_L", ""},
      {"skin", "surface"},
      {"arms", "surface"},
      {"left arm", "surface"},
      {"forearm_right", "surface"},
      {"Humerus soft tissue", "surface"},
      {"body_extremities", "surface"},
      {"body_trunc", "surface"},
      {"left upper limb", "surface"},
      {"humerus of arm", "bone"},
      {"skeleton_of_upper_limb", "bone"},
      {"right lower limb", "surface"},
      {"upper arm", "surface"},
      {"deep artery of arm", "artery"},
      {"muscle of upper limb", "muscle"},
      {"soft tissue tumour", "lesion"},
      {"posterior limb of internal capsule", "brain"},
      {"acromial extremity of clavicle", "bone"},
      {"kidney_cyst_left", "lesion"},
      {"liver tumour", "lesion"},
      // What a name takes away is not what it names.
      {"Liver-GTV", "digestive"},
      {"Kidneys-PTV", "urinary"},
      {"Bladder-PTV", "urinary"},
      {"PTV-Bladder", "lesion"},
      {"GTV-1", "lesion"},
      {"liver without tumour", "digestive"},
      {"Leber ohne Tumor", ""},
      {"non-tumor liver", "digestive"},
      {"no tumour", ""},
      {"Tumor_free_margin", ""},
      {"liver tumour, not cyst", "lesion"},
      // What was put in is no tissue.
      {"Heart prosthesis", "device"},
      {"Aortic stent", "device"},
      {"Bone marrow nail", "device"},
      {"Brain shunt", "device"},
      {"Kidney stone", "lesion"},
      {"nail of thumb", ""},
      {"body", "surface"},
      {"body of pancreas", "digestive"},
      // Lobules of the cerebellum are no levels of the spine; a number alone tells nothing.
      {"left-VIIA", "brain"},
      {"right-VIIB", "brain"},
      {"Left_VIIIA", "brain"},
      {"Left Crus I", "brain"},
      {"left-V", ""},
      // Vessels without their noun, and what else has their names.
      {"Carotid_L", "artery"},
      {"carotids", "artery"},
      {"left internal carotid", "artery"},
      {"iliacs", "artery"},
      {"common_iliac_right", "artery"},
      {"External iliac", "artery"},
      {"mesenterics", "artery"},
      {"superior mesenteric", "artery"},
      {"SMA", "artery"},
      {"left subclavian", "artery"},
      {"internal iliac vein", "vein"},
      {"superior mesenteric vein", "portal"},
      {"internal jugular", "vein"},
      {"iliac crest", "bone"},
      {"iliac bone", "bone"},
      {"iliac lymph nodes", "lymph"},
      {"mesenteric fat", "surface"},
      {"mesentery", "digestive"},
      {"carotid plexus", "nerve"},
      {"hepatic vessels", "vessel"},
      {"blood vasculature of kidney", "vessel"},
      {"blood vasculature", "vessel"},
      // Vertebrae, ribs, ventricles and nuclei.
      {"vertebrae", "bone"},
      {"vertebral body of L3", "bone"},
      {"vertebral artery", "artery"},
      {"rib_left_7", "bone"},
      {"costae", "bone"},
      {"third ventricle", "brain"},
      {"lateral ventricles", "brain"},
      {"ventricle", ""},
      {"nuclei", "brain"},
      {"red nucleus", "brain"},
      {"dorsal motor nucleus of vagus nerve", "brain"},
      {"vein of caudate nucleus", "vein"},
      {"nucleus pulposus", "joint"},
      {"basal ganglia", "brain"},
      {"ganglion of trigeminal nerve", "nerve"},
      {"cartilage of tracheobronchial tree", "joint"},
      {"skin of thoracic wall", "surface"},
      {"optic disc", "sense"},
      {"sigmoid sinus", "vein"},
      {"maxillary sinus", "respiratory"},
      {"foo bar", ""},
      {"", ""},
  };
  for (const auto& [name, system] : rows)
    QTest::newRow(name) << system;
}

void BodySystemsTest::systems() {
  QFETCH(QString, system);
  const AnatomyTable table;
  const auto match = table.match(QTest::currentDataTag());
  QCOMPARE(match ? QString::fromStdString(table.systems()[match->system].id) : QString(), system);
}

void BodySystemsTest::brokenRowsAreLeftOut() {
  const AnatomyTable table(
      "a\tAs\t#ff0000\torgan\nb\tBs\tred\torgan\n",
      "# comment\nx\ta\t\t0\nx y\ta\t#00ff00\t0\nz\tnone\t\t0\nw\ta\t\t7\nv\ta\n");
  QCOMPARE(table.badRows(), std::size_t(4));
  QCOMPARE(table.patternCount(), std::size_t(2));
  QCOMPARE(table.match("the x")->colour, (Colour{255, 0, 0}));
  QCOMPARE(table.match("the x y")->colour, (Colour{0, 255, 0}));
}

void BodySystemsTest::edits() {
  // Rank comes before length, and length before order.
  const AnatomyTable table("a\tAs\t#000001\torgan\nb\tBs\t#000002\torgan\n",
                           "long pattern of words\ta\t\t0\nartery\tb\t\t1\n=whole\tb\t\t0\n");
  QCOMPARE(table.match("artery of long pattern of words")->system, std::size_t(1));
  QVERIFY(table.match("whole"));
  QVERIFY(!table.match("whole thing"));
}

/// The colours that a person chooses from are those that names give.
void BodySystemsTest::coloursByName() {
  const AnatomyTable table;
  const std::vector<NamedColour> colours = table.colours();
  QVERIFY(colours.size() > table.systems().size());
  QVERIFY(colours.front().system && colours.front().name == "Bones");
  std::size_t systems = 0;
  for (const NamedColour& named : colours) {
    systems += named.system ? 1 : 0;
    if (named.system)
      continue;
    const auto match = table.match(named.name);
    QVERIFY2(match && match->colour == named.colour, named.name.c_str());
  }
  QCOMPARE(systems, table.systems().size());
}

SLINE_TEST(BodySystemsTest)
#include "body_systems_test.moc"
