// SPDX-License-Identifier: Apache-2.0
// Tests the proof before print by hand: what looks alike is listed, shown and mended in one step.
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QtTest>

#include "tests/gui/window_fixture.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"
#include "widgets/export/print_proof_dialog.h"

namespace sline::test {

namespace {

struct ProofDesk : WindowFixture {
  /// Shows two balls that overlap in the picture.
  ProofDesk(const Colour& left, const Colour& right) {
    session.openMade(QStringLiteral("Balls"), [left, right](const auto&, const auto&) {
      model::Scene scene;
      const model::MeshPtr ball = sphere(20, 3);
      for (const auto& [name, colour, x] :
           {std::tuple("left ball", left, 15.0f), std::tuple("right ball", right, -15.0f)}) {
        model::Node node{.name = name, .mesh = moved(*ball, 1.0f, {x, 0.0f, 0.0f})};
        node.style.colour = colour;
        node.style.gamma = Gamma::clamped(5.0f);
        scene.append(std::move(node));
      }
      return Result<widgets::LoadedDocument>(
          widgets::LoadedDocument{.scene = std::move(scene), .title = QStringLiteral("Balls")});
    });
    if (!settled())
      qFatal("the scene does not come");
  }

  widgets::PrintProofDialog* dialog() { return window.findChild<widgets::PrintProofDialog*>(); }
  template <class T>
  T& part(const char* name) {
    T* found = dialog()->findChild<T*>(QLatin1String(name));
    if (!found)
      qFatal("the dialog has no %s", name);
    return *found;
  }
  bool looked() {
    return QTest::qWaitFor([this] { return dialog() && dialog()->proof(); }, 60'000);
  }
  bool drawn() {
    return QTest::qWaitFor([this] { return !part<QLabel>("proofPicture").pixmap().isNull(); },
                           60'000);
  }
};

int coloured(const QImage& image) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      count += image.pixelColor(x, y).hsvSaturation() > 60 ? 1 : 0;
  return count;
}

}  // namespace

class ProofDialogTest : public QObject {
  Q_OBJECT

 private slots:
  void alikeInGrey() {
    // The colours are equally light, and of different hues.
    ProofDesk desk({210, 80, 80}, {70, 140, 70});
    desk.control<QAction>("printProof").trigger();
    QVERIFY(desk.looked());
    auto& pairs = desk.part<QTreeWidget>("proofPairs");
    QCOMPARE(pairs.topLevelItemCount(), 1);
    const QTreeWidgetItem& pair = *pairs.topLevelItem(0);
    QVERIFY2(pair.text(0).contains(QStringLiteral("left ball")) &&
                 pair.text(0).contains(QStringLiteral("right ball")),
             qPrintable(pair.text(0)));
    QVERIFY2(pair.text(1).contains(QStringLiteral("in grey")), qPrintable(pair.text(1)));
    QVERIFY(desk.part<QLabel>("proofTold").text().startsWith(QStringLiteral("1 pair")));
    QVERIFY(desk.part<QTreeWidget>("proofChanges").topLevelItemCount() > 0);

    QVERIFY(desk.drawn());
    const auto picture = [&desk] { return desk.part<QLabel>("proofPicture").pixmap().toImage(); };
    QCOMPARE(coloured(picture()), 0);
    auto& vision = desk.part<QComboBox>("proofVision");
    QTest::keyClick(&vision, Qt::Key_Home);
    QVERIFY(coloured(picture()) > 1000);
    const QImage before = picture();
    QTest::mouseClick(&desk.part<QCheckBox>("proofChanged"), Qt::LeftButton, {},
                      {8, desk.part<QCheckBox>("proofChanged").height() / 2});
    QTRY_VERIFY(desk.drawn() && picture() != before);

    const int steps = desk.session.history().count();
    const model::Scene scene = desk.session.scene();
    desk.part<QPushButton>("proofApply").click();
    QTRY_VERIFY(!desk.dialog());
    QCOMPARE(desk.session.history().count(), steps + 1);
    QVERIFY(desk.session.scene() != scene);
    // The proposal helps.
    QVERIFY(desk.settled());
    desk.control<QAction>("printProof").trigger();
    QVERIFY(desk.looked());
    QCOMPARE(desk.part<QTreeWidget>("proofPairs").topLevelItemCount(), 0);
    QVERIFY(!desk.part<QPushButton>("proofApply").isEnabled());
    desk.part<QPushButton>("proofClose").click();
    desk.session.history().undo();
    QCOMPARE(desk.session.scene().nodes(), scene.nodes());
  }

  void alikeOnScreen() {
    ProofDesk desk({180, 120, 90}, {180, 120, 90});
    desk.control<QAction>("printProof").trigger();
    QVERIFY(desk.looked());
    auto& pairs = desk.part<QTreeWidget>("proofPairs");
    QCOMPARE(pairs.topLevelItemCount(), 0);
    auto& all = desk.part<QCheckBox>("proofAll");
    QTest::mouseClick(&all, Qt::LeftButton, {}, {8, all.height() / 2});
    QVERIFY(!desk.dialog()->proof());
    QVERIFY(desk.looked());
    QCOMPARE(pairs.topLevelItemCount(), 1);
    QVERIFY(pairs.topLevelItem(0)->text(1).contains(QStringLiteral("on the screen")));
  }

  /// If it is closed while the picture is examined, it is simply gone.
  void closedEarly() {
    ProofDesk desk({210, 80, 80}, {70, 140, 70});
    desk.control<QAction>("printProof").trigger();
    QVERIFY(desk.dialog());
    QTest::keyClick(desk.dialog(), Qt::Key_Escape);
    QTRY_VERIFY(!desk.dialog());
    QVERIFY(desk.settled());
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::ProofDialogTest)
#include "proof_dialog_test.moc"
