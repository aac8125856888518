// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/preset_store.h"

#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>

#include "tests/support/suite.h"

using namespace sline;

class PresetStoreTest : public QObject {
  Q_OBJECT
 private slots:
  void survivesItsFile();
};

void PresetStoreTest::survivesItsFile() {
  QTemporaryDir folder;
  QSettings settings(folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat);
  model::Style all = {.colour = Colour{1, 2, 255},
                      .inkColour = Colour{0, 16, 32},
                      .gamma = Gamma::clamped(2.75f),
                      .opacity = Opacity::clamped(0.35f),
                      .fill = model::Fill::veil,
                      .lineThresholds = model::ThresholdValues{{"confis.margin", 0.25f},
                                                               {"ridges.curvature", 1.5f}},
                      .penWeight = 1.5f,
                      .hatchDensity = HatchDensity::clamped(2.0f),
                      .hatchTone = HatchTone::clamped(0.25f),
                      .gammaMap = model::GammaMap{.scalar = model::GammaScalar::occlusion,
                                                  .curve = {{0.1f, -0.5f}, {0.9f, 3.0f}}}};
  {
    widgets::PresetStore store(settings);
    QVERIFY(store.save(QStringLiteral(" Zarte Linie "), all));
    QVERIFY(!store.save(QStringLiteral("  "), all));
    QVERIFY(!store.save(QStringLiteral("nothing"), {}));
    QVERIFY(store.save(QStringLiteral("a"), {.gamma = Gamma::clamped(1.0f)}));
    // A distance is from structures of one scene.
    QVERIFY(!store.save(QStringLiteral("near"),
                        {.gammaMap = model::GammaMap{.scalar = model::GammaScalar::distance,
                                                     .targets = {{3}},
                                                     .curve = {{0, 1}, {1, 2}}}}));
    QVERIFY(!store.rename(QStringLiteral("a"), QStringLiteral("Zarte Linie")));
  }
  settings.sync();
  QSettings again(settings.fileName(), QSettings::IniFormat);
  {
    // A preset that cannot be read is left out.
    again.beginWriteArray(QStringLiteral("presets"), 3);
    again.setArrayIndex(2);
    again.setValue(QStringLiteral("name"), QStringLiteral("spoiled"));
    again.setValue(QStringLiteral("gamma"), QStringLiteral("nan"));
    again.setValue(QStringLiteral("fill"), QStringLiteral("mud"));
    again.setValue(QStringLiteral("colour"), QStringLiteral("#12"));
    again.endArray();
  }
  const auto presets = widgets::PresetStore(again).presets();
  QCOMPARE(presets.size(), std::size_t(2));
  const auto found = std::find_if(presets.begin(), presets.end(),
                                  [](const auto& preset) { return preset.name == "Zarte Linie"; });
  QVERIFY(found != presets.end());
  QVERIFY(found->style == all);
}

SLINE_TEST(PresetStoreTest)
#include "preset_store_test.moc"
