// SPDX-License-Identifier: Apache-2.0
// Tests the list of pockets by mouse and keys on the real window.
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QtTest>
#include <cmath>

#include "model/edit/visibility.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;

namespace {

/// Returns atoms around two hollows, 4 and 3 mm in radius and 25 mm apart.
model::KeptAtoms twoHollows() {
  auto set = std::make_shared<model::AtomSet>();
  for (std::uint32_t i = 0; i < 2; ++i) {
    set->residues.push_back("GLY A " + std::to_string(i + 1));
    const double reach = i == 0 ? 5.5 : 4.5;
    const int count = int(4.0 * M_PI * reach * reach / 0.5);
    for (int k = 0; k < count; ++k) {
      const double z = 1.0 - 2.0 * (k + 0.5) / count;
      const double turn = 2.39996323 * k;
      const double across = reach * std::sqrt(1.0 - z * z);
      set->atoms.push_back(
          {glm::vec3(25.0 * i + across * std::cos(turn), across * std::sin(turn), reach * z), 1.5f,
           i});
    }
  }
  return {std::move(set)};
}

model::Scene protein() {
  model::Scene scene;
  const model::NodeId entry = scene.append({.name = "1ABC – Made up"});
  model::Node chain{.parent = entry, .name = "Chain A", .mesh = sphere(9, 3)};
  chain.atoms = twoHollows();
  scene.append(chain);
  scene.append({.parent = entry, .name = "ATP", .mesh = sphere(2, 2)});
  return scene;
}

struct PocketsFixture : WindowFixture {
  explicit PocketsFixture(const model::Scene& scene) {
    session.openMade("protein",
                     [scene](const model::ImportProgress&,
                             const std::stop_token&) -> Result<widgets::LoadedDocument> {
                       widgets::LoadedDocument loaded;
                       loaded.scene = scene;
                       return loaded;
                     });
    settled();
    control<QDockWidget>("pocketsPanel").show();
    control<QDockWidget>("pocketsPanel").raise();
  }
  QTreeWidget& list() { return control<QTreeWidget>("pocketList"); }
  QString hint() { return control<QLabel>("pocketsHint").text(); }
  void click(QTreeWidgetItem* row) {
    QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().visualItemRect(row).center());
  }
};

}  // namespace

class PocketsPanelTest : public QObject {
  Q_OBJECT
 private slots:
  void listsPockets() {
    PocketsFixture f(protein());
    QTRY_COMPARE(f.list().topLevelItemCount(), 2);
    QTreeWidgetItem* first = f.list().topLevelItem(0);
    QCOMPARE(first->text(0), QStringLiteral("1 – ATP"));
    QVERIFY(std::abs(first->text(1).toInt() - 268) < 12);
    QCOMPARE(first->text(2), QStringLiteral("0"));
    QVERIFY(first->child(0)->text(0).contains(QStringLiteral("GLY A 1")));
    QCOMPARE(f.list().topLevelItem(1)->text(0), QStringLiteral("2"));
    QVERIFY(f.hint().contains(QLatin1Char('2')));
    QVERIFY(!f.control<QPushButton>("pocketsCancel").isVisible());
  }

  void oneClickFocuses() {
    PocketsFixture f(protein());
    QTRY_COMPARE(f.list().topLevelItemCount(), 2);
    const int steps = f.session.history().count();
    f.click(f.list().topLevelItem(0));
    QTRY_COMPARE(f.session.history().count(), steps + 1);
    const auto room = f.session.scene().named("Pocket 1");
    QCOMPARE(room.size(), std::size_t(1));
    const model::NodeId chain = f.session.scene().named("Chain A")[0];
    QVERIFY(f.session.scene().resolve(chain).gammaMap.targets == room);
    QTRY_VERIFY(glm::length(f.viewport().camera().target) < 1.0f);
    // The list stays; another pocket follows by keys, and undo brings all back.
    QCOMPARE(f.list().topLevelItemCount(), 2);
    f.list().setCurrentItem(f.list().topLevelItem(1));
    QTest::keyClick(&f.list(), Qt::Key_Return);
    QTRY_COMPARE(f.session.history().count(), steps + 2);
    QVERIFY(f.session.scene().resolve(chain).gammaMap.targets ==
            f.session.scene().named("Pocket 2"));
    f.session.undo();
    f.session.undo();
    QVERIFY(f.session.scene().named("Pocket 1").empty());
  }

  void radiiCount() {
    PocketsFixture f(protein());
    QTRY_COMPARE(f.list().topLevelItemCount(), 2);
    auto& probe = f.control<QDoubleSpinBox>("pocketProbe");
    QVERIFY(probe.suffix().contains(QStringLiteral("Å")));
    probe.setValue(3.3);
    QTRY_COMPARE(f.list().topLevelItemCount(), 1);
    f.control<QDoubleSpinBox>("pocketLeastVolume").setValue(1000.0);
    QTRY_COMPARE(f.list().topLevelItemCount(), 0);
  }

  void followsTheDocument() {
    PocketsFixture f(protein());
    QTRY_COMPARE(f.list().topLevelItemCount(), 2);
    const std::vector<model::NodeId> chain = f.session.scene().named("Chain A");
    f.session.apply("hide", model::withHidden(f.session.scene(), chain));
    QTRY_COMPARE(f.list().topLevelItemCount(), 0);
    QVERIFY(f.hint().contains(QStringLiteral("PDB")));
    f.session.undo();
    QTRY_COMPARE(f.list().topLevelItemCount(), 2);
  }
};

SLINE_TEST_WITH_WIDGETS(PocketsPanelTest)
#include "pockets_panel_test.moc"
