// SPDX-License-Identifier: Apache-2.0
// Tests an import by hand: what the dialog shows, what is changed in it, and what results.
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>
#include <QtTest>
#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "tests/gui/window_fixture.h"
#include "tests/model/import/volumes/written_volumes.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"
#include "widgets/import_dialog/import_dialog.h"
#include "widgets/import_dialog/plan_tree.h"
#include "widgets/shell/message_bar.h"

namespace sline::test {

using model::NodeId;
using widgets::ImportDialog;
using widgets::PlanTree;
using widgets::PlanTreeModel;

namespace {

/// Provides the dialog over a window, and helpers that operate it.
struct Desk {
  explicit Desk(const QString& path, bool shift = true) {
    if (!f.drop(path, shift ? Qt::ShiftModifier : Qt::NoModifier))
      qFatal("the window does not take %s", qPrintable(path));
  }

  WindowFixture f;

  ImportDialog* dialog() { return f.window.findChild<ImportDialog*>(); }
  bool planned() {
    return QTest::qWaitFor([this] { return dialog() && dialog()->draft().ready(); }, 60'000);
  }
  const model::ImportPlan& plan() { return dialog()->draft().plan(); }
  PlanTree& tree() { return f.control<PlanTree>("planTree"); }
  QString text(const char* label) { return f.control<QLabel>(label).text(); }

  NodeId idOf(const char* name) {
    const std::vector<NodeId> found = plan().scene.named(name);
    if (found.size() != 1)
      qFatal("%zu nodes are named %s", found.size(), name);
    return found.front();
  }
  QPoint placeOf(const char* name, int column) {
    const QModelIndex index = tree().indexOf(idOf(name), column);
    tree().scrollTo(index);
    return tree().visualRect(index).center();
  }
  QString cell(const char* name, int column) {
    return tree().indexOf(idOf(name), column).data().toString();
  }
  void select(std::initializer_list<const char*> names) {
    Qt::KeyboardModifiers keys;
    for (const char* name : names) {
      QTest::mouseClick(tree().viewport(), Qt::LeftButton, keys,
                        placeOf(name, PlanTreeModel::triangles));
      keys = Qt::ControlModifier;
    }
  }
  /// Chooses by the keyboard, as a user without a mouse would.
  void pick(const char* name, const char* id) {
    auto& box = f.control<QComboBox>(name);
    box.setFocus();
    QTest::keyClick(&box, Qt::Key_Home);
    for (int i = 0; i < box.count() && box.currentData().toString() != QLatin1String(id); ++i)
      QTest::keyClick(&box, Qt::Key_Down);
    QCOMPARE(box.currentData().toString(), QLatin1String(id));
  }
  void click(const char* button) {
    QTest::mouseClick(&f.control<QPushButton>(button), Qt::LeftButton);
  }
  const model::Node& imported(const char* name) { return named(f.session.scene(), name); }
};

}  // namespace

class ImportDialogTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_body;
  QString m_broken;

 private slots:
  void initTestCase() {
    writeBody(m_body.path());
    m_broken = m_body.filePath(QStringLiteral("Organs/spleen.obj"));
    writeText(m_broken, "v 0 0\nf 1 2 3\n");
  }

  void showsWhatWouldBe() {
    Desk desk(m_body.path());
    QVERIFY(desk.planned());
    QVERIFY2(!desk.f.session.busy(), "nothing is imported before it was asked for");
    QVERIFY(desk.text("importSummary").contains(QStringLiteral("5 structures")));
    QVERIFY(desk.text("frameReason").startsWith(QStringLiteral("LPS")));
    QVERIFY(desk.text("frameReason").contains(QStringLiteral("vote:")));
    QVERIFY(desk.text("unitReason").startsWith(QStringLiteral("mm")));
    QCOMPARE(desk.cell("left kidney", PlanTreeModel::file), QStringLiteral("left kidney.ply"));
    QCOMPARE(desk.cell("left kidney", PlanTreeModel::size), QStringLiteral("40"));
    QVERIFY(!desk.f.control<QLabel>("importDoubt").isVisible());
    desk.select({"left kidney"});
    QVERIFY(desk.text("details").contains(QStringLiteral("vote:")));
  }

  void leftOutTellsFileAndReason() {
    Desk desk(m_body.path());
    QVERIFY(desk.planned());
    auto& tabs = desk.f.control<QTabWidget>("importTabs");
    QVERIFY(tabs.tabText(1).contains(QLatin1Char('1')));
    tabs.setFocus();
    QTest::keyClick(&tabs, Qt::Key_Tab, Qt::ControlModifier);
    const auto& table = desk.f.control<QTableWidget>("leftOut");
    QVERIFY(table.isVisible());
    QCOMPARE(table.rowCount(), 1);
    QCOMPARE(table.item(0, 0)->text(), QStringLiteral("spleen.obj"));
    QVERIFY(table.item(0, 1)->text().contains(QStringLiteral("line 1")));
  }

  /// A ball of bone in air is kept as a scan and made into a structure by its threshold.
  void scanByThreshold() {
    QTemporaryDir folder;
    glm::dmat4 grid(2.0);
    grid[3] = glm::dvec4(-31.0, -31.0, -31.0, 1.0);
    const WrittenVolume ball = sampled(glm::ivec3(32), grid, [](const glm::dvec3& p) {
      return int(std::clamp(200.0 - 100.0 * (glm::length(p) - 15.0), -1000.0, 900.0));
    });
    const QString ct = folder.filePath(QStringLiteral("ct.nii"));
    writeText(ct, niftiFile(ball, Number::int16));
    Desk desk(ct);
    QVERIFY(desk.planned());
    auto& panel = desk.f.control<QWidget>("thresholdPanel");
    QVERIFY2(panel.isVisible(), "a scan alone is shown at once");
    QVERIFY(!desk.f.control<QPushButton>("importButton").isEnabled());
    QVERIFY(desk.text("scanAbout").contains(QStringLiteral("32 × 32 × 32")));
    auto& low = desk.f.control<QDoubleSpinBox>("thresholdLow");
    QCOMPARE(low.value(), 200.0);
    desk.click("preset_skin");
    QCOMPARE(low.value(), -300.0);
    auto& range = desk.f.control<QWidget>("intensityRange");
    range.setFocus();
    for (int i = 0; i < 10; ++i)
      QTest::keyClick(&range, Qt::Key_Right, Qt::ControlModifier);
    QVERIFY(low.value() > -200.0);
    QTest::mouseClick(&range, Qt::LeftButton, {}, QPoint(range.width() - 30, 40));
    QVERIFY(desk.f.control<QDoubleSpinBox>("thresholdHigh").value() < 900.0);
    desk.click("preset_bone");
    if (const QString file = qEnvironmentVariable("SLINE_SCAN_PICTURE"); !file.isEmpty())
      desk.dialog()->grab().save(file);
    desk.click("addThreshold");
    QVERIFY(desk.planned());
    QVERIFY(desk.text("thresholdsMade").contains(QStringLiteral("bone")));
    QCOMPARE(desk.plan().parts.size(), std::size_t(1));
    QTest::mouseClick(&desk.f.control<QCheckBox>("keepScan"), Qt::LeftButton, {}, QPoint(8, 8));
    QVERIFY(desk.plan().options.keepScans);
    desk.click("importButton");
    QVERIFY(desk.f.settled());
    const float width = desk.imported("bone").mesh->bounds().size().x;
    QVERIFY(std::abs(width - 30.0f) < 1.0f);
    QCOMPARE(desk.f.session.scene().scans().size(), std::size_t(1));
  }

  void eachStructureAsChosen() {
    Desk desk(m_body.path());
    QVERIFY(desk.planned());
    desk.pick("importSmoothing", "off");
    desk.select({"left kidney"});
    desk.pick("selectionSmoothing", "10");
    desk.select({"right kidney", "bladder"});
    desk.pick("selectionDecimation", "1");
    QCOMPARE(desk.cell("bladder", PlanTreeModel::decimation), QStringLiteral("within 1 mm"));
    QCOMPARE(desk.cell("aorta", PlanTreeModel::decimation), QStringLiteral("no"));
    desk.select({"left renal vein"});
    QTest::keyClick(&desk.tree(), Qt::Key_Space);
    QVERIFY(desk.text("importSummary").contains(QStringLiteral("1 skipped")));
    const std::size_t triangles =
        desk.plan().scene.find(desk.idOf("bladder"))->mesh->triangleCount();
    desk.click("importButton");
    QVERIFY(desk.f.settled());
    QTRY_VERIFY(!desk.dialog());
    const model::Scene& scene = desk.f.session.scene();
    QCOMPARE(scene.structuresBelow(model::rootId).size(), std::size_t(4));
    QVERIFY(scene.named("left renal vein").empty());
    QCOMPARE(desk.imported("left kidney").provenance.smoothingSteps, 10);
    QCOMPARE(desk.imported("aorta").provenance.smoothingSteps, 0);
    for (const char* name : {"right kidney", "bladder"}) {
      QCOMPARE(desk.imported(name).provenance.decimatedFrom, int(triangles));
      QVERIFY(desk.imported(name).mesh->triangleCount() < triangles);
    }
    QCOMPARE(desk.imported("left kidney").provenance.decimatedFrom, 0);
  }

  void unitAndFrameOfAll() {
    Desk desk(m_body.path());
    QVERIFY(desk.planned());
    desk.pick("importUnit", "cm");
    QVERIFY(desk.planned());
    QCOMPARE(desk.cell("left kidney", PlanTreeModel::size), QStringLiteral("400"));
    QVERIFY(desk.text("unitReason").contains(QStringLiteral("chosen by the user")));
    QVERIFY(!desk.f.control<QLabel>("importDoubt").isVisible());
    desk.pick("importFrame", "ras");
    QVERIFY(desk.planned());
    QVERIFY2(desk.text("importDoubt").contains(QStringLiteral("Left and right look swapped")),
             "nobody turns a body round unwarned");
    QVERIFY(desk.f.control<QLabel>("importDoubt").isVisible());
    desk.click("importButton");
    QVERIFY(desk.f.settled());
    const glm::vec3 middle = desk.imported("left kidney").mesh->bounds().centre();
    QVERIFY(std::abs(middle.x + 600.0f) < 1.0f);
    QCOMPARE(desk.imported("left kidney").provenance.frameReason,
             std::string("chosen by the user"));
  }

  void doubtfulSizeNamesTheUnit() {
    Desk desk(m_body.path());
    QVERIFY(desk.planned());
    desk.pick("importUnit", "m");
    QVERIFY(desk.planned());
    QVERIFY(desk.text("importDoubt").contains(QStringLiteral("millimetres")));
    QVERIFY(desk.text("importDoubt").contains(QStringLiteral("160 mm")));
  }

  void frameOfOneFile() {
    Desk desk(m_body.path());
    QVERIFY(desk.planned());
    desk.select({"left kidney"});
    desk.pick("selectionFrame", "ras");
    QVERIFY(desk.planned());
    QCOMPARE(desk.cell("left kidney", PlanTreeModel::frame), QStringLiteral("RAS"));
    QCOMPARE(desk.cell("aorta", PlanTreeModel::frame), QStringLiteral("LPS"));
    QVERIFY(desk.text("frameReason").contains(QStringLiteral("4: LPS")));
    desk.pick("selectionFrame", "");
    QVERIFY(desk.planned());
    QCOMPARE(desk.cell("left kidney", PlanTreeModel::frame), QStringLiteral("LPS"));
    QVERIFY(desk.plan().choices.empty());
  }

  void groupsAreTriState() {
    Desk desk(m_body.path());
    QVERIFY(desk.planned());
    const auto state = [&](const char* name) {
      return Qt::CheckState(desk.tree().indexOf(desk.idOf(name)).data(Qt::CheckStateRole).toInt());
    };
    desk.select({"aorta"});
    QTest::keyClick(&desk.tree(), Qt::Key_Space);
    QCOMPARE(state("Vessels"), Qt::PartiallyChecked);
    QCOMPARE(state("aorta"), Qt::Unchecked);
    QCOMPARE(state("Organs"), Qt::Checked);
    desk.select({"Vessels"});
    QTest::keyClick(&desk.tree(), Qt::Key_Space);
    QCOMPARE(state("aorta"), Qt::Checked);
    QTest::keyClick(&desk.tree(), Qt::Key_Space);
    QCOMPARE(state("left renal vein"), Qt::Unchecked);
    desk.select({"Organs"});
    QTest::keyClick(&desk.tree(), Qt::Key_Space);
    QVERIFY2(!desk.f.control<QPushButton>("importButton").isEnabled(), "nothing is left to import");
    QVERIFY(!desk.text("importState").isEmpty());
    auto& include = desk.f.control<QCheckBox>("selectionInclude");
    QTest::mouseClick(&include, Qt::LeftButton, {}, QPoint(8, include.height() / 2));
    QVERIFY(desk.f.control<QPushButton>("importButton").isEnabled());
    QCOMPARE(state("Organs"), Qt::Checked);
  }

  void renameFilterAndSort() {
    Desk desk(m_body.path());
    QVERIFY(desk.planned());
    const QModelIndex bladder = desk.tree().indexOf(desk.idOf("bladder"));
    desk.select({"bladder"});
    desk.tree().setFocus();
    desk.tree().setCurrentIndex(bladder);
    QTest::keyClick(&desk.tree(), Qt::Key_F2);
    auto* editor = desk.tree().findChild<QLineEdit*>();
    QVERIFY(editor);
    editor->selectAll();
    QTest::keyClicks(editor, QStringLiteral("<b>Vesica</b>"));
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(desk.cell("bladder", PlanTreeModel::name), QStringLiteral("<b>Vesica</b>"));
    auto& filter = desk.f.control<QLineEdit>("importFilter");
    QTest::keyClicks(&filter, QStringLiteral("kidn"));
    QVERIFY(desk.tree().indexOf(desk.idOf("left kidney")).isValid());
    QVERIFY(!desk.tree().indexOf(desk.idOf("aorta")).isValid());
    filter.clear();
    // As in the tree of structures: words in any order, one wish or the other, sides as words.
    QTest::keyClicks(&filter, QStringLiteral("kidn left or AORT"));
    QVERIFY(desk.tree().indexOf(desk.idOf("left kidney")).isValid());
    QVERIFY(!desk.tree().indexOf(desk.idOf("right kidney")).isValid());
    QVERIFY(desk.tree().indexOf(desk.idOf("aorta")).isValid());
    // What is typed is taken back in the line.
    QTest::keyClick(&filter, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(filter.text().isEmpty());
    QVERIFY(desk.tree().indexOf(desk.idOf("right kidney")).isValid());
    desk.tree().sortByColumn(PlanTreeModel::size, Qt::DescendingOrder);
    QVERIFY(desk.tree().indexOf(desk.idOf("aorta")).row() == 0);
    desk.click("importButton");
    QVERIFY(desk.f.settled());
    QVERIFY(desk.imported("<b>Vesica</b>").mesh);
  }

  void addToSceneIsOneStep() {
    Desk desk(m_body.path(), false);
    QVERIFY(desk.f.settled());
    const model::Scene before = desk.f.session.scene();
    const int steps = desk.f.session.history().count();
    QVERIFY(desk.f.drop(m_body.filePath(QStringLiteral("Vessels")), Qt::ShiftModifier));
    QVERIFY(desk.planned());
    desk.click("addButton");
    QVERIFY(desk.f.settled());
    QCOMPARE(desk.f.session.history().count(), steps + 1);
    const model::Scene& after = desk.f.session.scene();
    QCOMPARE(after.structuresBelow(model::rootId).size(),
             before.structuresBelow(model::rootId).size() + 2);
    QCOMPARE(after.named("aorta").size(), std::size_t(2));
    std::set<NodeId> ids;
    for (const model::Node& node : after.nodes())
      ids.insert(node.id);
    QCOMPARE(ids.size(), after.nodes().size());
    for (const model::Node& node : before.nodes())
      QVERIFY(*after.find(node.id) == node);
    desk.f.session.undo();
    QVERIFY(desk.f.session.scene() == before);
  }

  void cancelChangesNothing() {
    Desk desk(m_body.path(), false);
    QVERIFY(desk.f.settled());
    const widgets::Document before = desk.f.session.document();
    QVERIFY(desk.f.drop(m_body.path(), Qt::ShiftModifier));
    QVERIFY(desk.dialog());
    QTest::keyClick(desk.dialog(), Qt::Key_Escape);  // while it reads
    QTRY_VERIFY(!desk.dialog());
    QVERIFY(desk.f.drop(m_body.path(), Qt::ShiftModifier));
    QVERIFY(desk.planned());
    desk.click("cancelImportButton");
    QTRY_VERIFY(!desk.dialog());
    QVERIFY(desk.f.session.document() == before);
    QVERIFY(!desk.f.session.busy());
  }

  void nothingToReadIsTold() {
    Desk desk(m_broken);
    QTRY_VERIFY(!desk.dialog()->draft().planning());
    QVERIFY(desk.text("importDoubt").contains(QStringLiteral("line 1")));
    QVERIFY(!desk.f.control<QPushButton>("importButton").isEnabled());
  }

  void offeredAfterADoubtfulImport() {
    Desk desk(m_body.path(), false);
    QVERIFY(desk.f.settled());
    auto& offer = desk.f.control<QPushButton>("messageRemedy");
    QVERIFY2(offer.isVisible(), "a file was left out");
    QTest::mouseClick(&offer, Qt::LeftButton);
    QVERIFY(desk.planned());
    QCOMPARE(desk.plan().inputs.size(), std::size_t(1));
    desk.pick("importUnit", "cm");
    QVERIFY(desk.planned());
    desk.click("importButton");
    QVERIFY(desk.f.settled());
    QCOMPARE(desk.imported("left kidney").provenance.mmPerUnit, 10.0f);
  }

  void preferenceShowsItAlways() {
    Desk desk(m_body.path(), false);
    QVERIFY(desk.f.settled());
    QVERIFY(!desk.dialog());
    QVERIFY(desk.f.window.preferences().set(QStringLiteral("files/importOptions"), true));
    QVERIFY(desk.f.drop(m_body.path()));
    QVERIFY(desk.planned());
  }

  void menuAsksForFiles() {
    WindowFixture f;
    QTest::keyClick(&f.window, Qt::Key_I, Qt::ControlModifier);
    QTRY_VERIFY(f.window.findChild<QDialog*>(QStringLiteral("openFilesDialog")));
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::ImportDialogTest)
#include "import_dialog_test.moc"
