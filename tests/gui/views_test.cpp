// SPDX-License-Identifier: Apache-2.0
// Saved views in the window: made, renamed, ordered, updated, deleted, gone to and presented.
#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QScrollBar>
#include <QStatusBar>
#include <QToolButton>
#include <QtTest>

#include "model/edit/style.h"
#include "model/edit/views.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/shapes.h"
#include "widgets/theme/theme.h"
#include "widgets/views/view_list.h"
#include "widgets/views/view_pictures.h"
#include "widgets/views/view_row.h"
#include "widgets/views/views_panel.h"

namespace sline::test {

namespace {

/// The window with a body of two balls in it, and hands for the panel.
struct Views : WindowFixture {
  model::NodeId left;
  model::NodeId right;

  explicit Views(const std::vector<model::View>& views = {}) {
    session.openMade(QStringLiteral("Balls"), [this, views](const auto&, const auto&) {
      model::Scene scene;
      left = scene.append(
          {.name = "left ball", .mesh = moved(*sphere(20, 3), 1.0f, {30.0f, 0.0f, 0.0f})});
      right = scene.append(
          {.name = "right ball", .mesh = moved(*sphere(20, 3), 1.0f, {-30.0f, 0.0f, 0.0f})});
      scene.setViews(views);
      return Result<widgets::Loaded>(
          widgets::Loaded{.scene = std::move(scene), .title = QStringLiteral("Balls")});
    });
    if (!settled())
      qFatal("the scene does not come");
  }

  const model::Scene& scene() const { return session.scene(); }
  QString names() const {
    QStringList all;
    for (const model::View& view : scene().views())
      all << QString::fromStdString(view.name);
    return all.join(QLatin1Char('|'));
  }
  QDockWidget& dock() { return control<QDockWidget>("viewsPanel"); }
  widgets::ViewRow& row() { return control<widgets::ViewRow>("viewRow"); }
  QRect card(int index) { return row().visualRect(row().model()->index(index, 0)); }
  void clickCard(int index) {
    QTest::mouseClick(row().viewport(), Qt::LeftButton, {}, card(index).center());
  }
  void press(const char* button) {
    QTest::mouseClick(&control<QToolButton>(button), Qt::LeftButton);
  }
  void add(const char* key) {
    QTest::keyClick(&viewport(), Qt::Key(key[0]));
    QTest::keyClick(&viewport(), Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
  }
  /// Front, back and left.
  void addThree() {
    for (const char* key : {"A", "P", "L"})
      add(key);
    QVERIFY(settled());
  }
  void setGamma(model::NodeId id, float gamma) {
    session.apply(QStringLiteral("Γ"),
                  model::withStyle(scene(), std::array{id}, {.gamma = Gamma::clamped(gamma)}));
  }
  void type(const QString& name) {
    auto* editor = row().findChild<QLineEdit*>(QStringLiteral("viewName"));
    if (!editor)
      qFatal("no name is being typed");
    editor->selectAll();
    QTest::keyClicks(editor, name);
    QTest::keyClick(editor, Qt::Key_Return);
    typed();
  }
  /// What was typed is taken over when the event loop comes to it.
  void typed() {
    if (!QTest::qWaitFor(
            [this] { return !row().findChild<QLineEdit*>(QStringLiteral("viewName")); }))
      qFatal("the name is still being typed");
  }
  int steps() { return session.history().index(); }
  void undo() { QTest::keyClick(&viewport(), Qt::Key_Z, Qt::ControlModifier); }
  void fly() {
    settings.setValue(QStringLiteral("navigation/flights"), true);
    viewport().setFlights(true);
  }
  QString presented() {
    const auto& label = control<QLabel>("presentedView");
    return label.isVisible() ? label.text() : QString();
  }
  const widgets::ViewPictures& pictures() {
    return window.findChild<widgets::ViewsPanel*>(QStringLiteral("views"))->pictures();
  }
  QImage cardPicture(int index) {
    return row().model()->index(index, 0).data(Qt::DecorationRole).value<QImage>();
  }
  bool pictured(int count) {
    constexpr int minute = 60'000;
    return QTest::qWaitFor(
        [&] {
          for (int i = 0; i < count; ++i)
            if (cardPicture(i).isNull())
              return false;
          return true;
        },
        minute);
  }
};

}  // namespace

class ViewsTest : public QObject {
  Q_OBJECT

 private slots:
  void panelComesWithTheFirstView();
  void panelAsSomebodySays();
  void addedByKeyButtonAndMenu();
  void renamed_data();
  void renamed();
  void orderedByDrag_data();
  void orderedByDrag();
  void orderedByKeys();
  void updated();
  void deleted();
  void goingThere();
  void goingThereByEnter();
  void goingThereByTheMenu();
  void transition();
  void interruptedByHand();
  void editedMeanwhile();
  void picturesAreKeptAndDrawnAgain();
  void presentation();
  void presentationGivesAllBack();
  void presentationLeavesTheSceneAlone();
  void presentationEndsWithTheDocument();
  void whatIsGoneIsMarked();
  void twoHundred();
  void hostileNames();
};

void ViewsTest::panelComesWithTheFirstView() {
  Views f;
  QVERIFY(!f.dock().isVisible());
  f.add("A");
  QVERIFY(f.dock().isVisible());
  QVERIFY2(f.dock().height() <= 130, qPrintable(QString::number(f.dock().height())));
  f.undo();
  QVERIFY(!f.dock().isVisible());
  Views withViews({{.name = "V"}});
  QVERIFY(withViews.dock().isVisible());
}

void ViewsTest::panelAsSomebodySays() {
  Views f;
  f.dock().toggleViewAction()->trigger();
  QVERIFY(f.dock().isVisible());
  f.add("A");
  f.undo();
  QVERIFY(f.dock().isVisible());
  f.dock().close();
  f.add("A");
  QVERIFY(!f.dock().isVisible());
}

void ViewsTest::addedByKeyButtonAndMenu() {
  Views f;
  f.add("A");
  QCOMPARE(f.names(), QString("View 1"));
  f.press("viewAdd");
  f.control<QAction>("addView").trigger();
  QCOMPARE(f.names(), QString("View 1|View 2|View 3"));
  QCOMPARE(f.steps(), 3);
  QCOMPARE(f.row().model()->rowCount(), 3);
  QCOMPARE(f.row().currentIndex().row(), 2);
  QVERIFY(f.scene().views()[0].camera == f.viewport().camera());
  QCOMPARE(f.scene().views()[0].looks->size(), f.scene().nodes().size());
  f.undo();
  QCOMPARE(f.names(), QString("View 1|View 2"));
  f.row().setCurrentIndex(f.row().model()->index(0, 0));
  f.press("viewDelete");
  f.press("viewAdd");
  QCOMPARE(f.names(), QString("View 2|View 3"));
  WindowFixture empty;
  QVERIFY(!empty.control<QAction>("addView").isEnabled());
  QVERIFY(!empty.control<QAction>("present").isEnabled());
}

void ViewsTest::renamed_data() {
  QTest::addColumn<bool>("byMouse");
  QTest::addColumn<QString>("typed");
  QTest::addColumn<QString>("names");
  QTest::newRow("by F2") << false << "Front"
                         << "View 1|Front|View 3";
  QTest::newRow("by a double click") << true << "Front"
                                     << "View 1|Front|View 3";
  QTest::newRow("to one there is") << false << "View 1"
                                   << "View 1|View 1 2|View 3";
  QTest::newRow("to nothing") << false << " "
                              << "View 1|View 2|View 3";
}

void ViewsTest::renamed() {
  QFETCH(bool, byMouse);
  QFETCH(QString, typed);
  QFETCH(QString, names);
  Views f;
  f.addThree();
  f.clickCard(1);
  const int steps = f.steps();
  if (byMouse)
    QTest::mouseDClick(f.row().viewport(), Qt::LeftButton, {}, f.card(1).center());
  else
    QTest::keyClick(&f.row(), Qt::Key_F2);
  f.type(typed);
  QCOMPARE(f.names(), names);
  const bool changed = names != "View 1|View 2|View 3";
  QCOMPARE(f.steps(), steps + int(changed));
  if (changed)
    f.undo();
  QCOMPARE(f.names(), QString("View 1|View 2|View 3"));
}

void ViewsTest::orderedByDrag_data() {
  QTest::addColumn<int>("from");
  QTest::addColumn<int>("beside");
  QTest::addColumn<bool>("before");
  QTest::addColumn<QString>("names");
  QTest::newRow("last to the front") << 2 << 0 << true << "View 3|View 1|View 2";
  QTest::newRow("first to the end") << 0 << 2 << false << "View 2|View 3|View 1";
  QTest::newRow("one on") << 0 << 1 << false << "View 2|View 1|View 3";
  QTest::newRow("nowhere else") << 1 << 0 << false << "View 1|View 2|View 3";
}

void ViewsTest::orderedByDrag() {
  QFETCH(int, from);
  QFETCH(int, beside);
  QFETCH(bool, before);
  QFETCH(QString, names);
  Views f;
  f.addThree();
  f.clickCard(from);
  const int steps = f.steps();
  QWidget& canvas = *f.row().viewport();
  const QPoint begin = f.card(from).center();
  const QRect target = f.card(beside);
  const QPoint end(before ? target.left() + 4 : target.right() - 4, target.center().y());
  // The drag runs an event loop of its own: what the hand does next comes from within.
  QTimer hand;
  int moves = 0;
  connect(&hand, &QTimer::timeout, this, [&] {
    QWindow* window = f.window.windowHandle();
    const QPoint at = canvas.mapTo(&f.window, end) + QPoint(moves % 2, 0);
    if (++moves < 4)
      QTest::mouseMove(window, at);
    else
      QTest::mouseRelease(window, Qt::LeftButton, {}, at);
  });
  hand.start(30);
  QWindow* window = f.window.windowHandle();
  QTest::mousePress(window, Qt::LeftButton, {}, canvas.mapTo(&f.window, begin));
  QTest::mouseMove(window, canvas.mapTo(&f.window, begin + QPoint(12, 0)));
  QTest::mouseMove(window, canvas.mapTo(&f.window, begin + QPoint(24, 0)));
  QTRY_VERIFY(moves >= 4);
  hand.stop();
  QCOMPARE(f.names(), names);
  const bool moved = names != "View 1|View 2|View 3";
  QCOMPARE(f.steps(), steps + int(moved));
  if (moved)
    QCOMPARE(f.row().currentIndex().data().toString(), QString("View %1").arg(from + 1));
  if (moved)
    f.undo();
  QCOMPARE(f.names(), QString("View 1|View 2|View 3"));
}

void ViewsTest::orderedByKeys() {
  Views f;
  f.addThree();
  f.clickCard(1);
  QTest::keyClick(&f.row(), Qt::Key_Right, Qt::AltModifier);
  QCOMPARE(f.names(), QString("View 1|View 3|View 2"));
  QCOMPARE(f.row().currentIndex().row(), 2);
  QTest::keyClick(&f.row(), Qt::Key_Right, Qt::AltModifier);
  QCOMPARE(f.names(), QString("View 1|View 3|View 2"));
  QTest::keyClick(&f.row(), Qt::Key_Left, Qt::AltModifier);
  QTest::keyClick(&f.row(), Qt::Key_Left, Qt::AltModifier);
  QTest::keyClick(&f.row(), Qt::Key_Left, Qt::AltModifier);
  QCOMPARE(f.names(), QString("View 2|View 1|View 3"));
}

void ViewsTest::updated() {
  Views f;
  f.addThree();
  f.clickCard(0);
  f.setGamma(f.left, 5.0f);
  QTest::keyClick(&f.viewport(), Qt::Key_S);
  const int steps = f.steps();
  f.press("viewUpdate");
  QCOMPARE(f.steps(), steps + 1);
  const model::View& view = f.scene().views()[0];
  QVERIFY(view.camera == f.viewport().camera());
  QCOMPARE(model::shown(f.scene(), view).scene.resolve(f.left).gamma.value(), 5.0f);
  QCOMPARE(f.names(), QString("View 1|View 2|View 3"));
  f.undo();
  QCOMPARE(model::shown(f.scene(), f.scene().views()[0]).scene.resolve(f.left).gamma.value(), 2.0f);
}

void ViewsTest::deleted() {
  Views f;
  f.addThree();
  QTest::keyClick(&f.viewport(), Qt::Key_A);
  f.row().setCurrentIndex(f.row().model()->index(1, 0));
  f.press("viewDelete");
  QCOMPARE(f.names(), QString("View 1|View 3"));
  f.session.select({f.left});
  QTest::keyClick(&f.row(), Qt::Key_Delete);
  QCOMPARE(f.scene().views().size(), std::size_t(1));
  QCOMPARE(f.scene().nodes().size(), std::size_t(2));  // Del removes structures elsewhere
  f.undo();
  f.undo();
  QCOMPARE(f.names(), QString("View 1|View 2|View 3"));
  for (int i = 0; i < 3; ++i)
    QTest::keyClick(&f.row(), Qt::Key_Delete);
  QVERIFY(f.scene().views().empty());
  QVERIFY(!f.control<QToolButton>("viewDelete").isEnabled());
}

void ViewsTest::goingThere() {
  Views f;
  f.addThree();
  f.setGamma(f.left, 5.0f);
  const int steps = f.steps();
  const model::Scene before = f.scene();
  f.clickCard(0);
  QVERIFY(f.viewport().camera() == f.scene().views()[0].camera);
  QCOMPARE(f.scene().resolve(f.left).gamma.value(), 2.0f);
  QCOMPARE(f.steps(), steps + 1);
  QVERIFY(f.settled());
  // The looks come back; the camera stays, as turning is no edit.
  f.undo();
  QVERIFY(f.scene() == before);
  QVERIFY(f.viewport().camera() == f.scene().views()[0].camera);
  // Where only the camera differs there is no step.
  f.session.redo();
  f.clickCard(2);
  QVERIFY(f.viewport().camera() == f.scene().views()[2].camera);
  QCOMPARE(f.steps(), steps + 1);
}

void ViewsTest::goingThereByEnter() {
  Views f;
  f.addThree();
  f.row().setCurrentIndex(f.row().model()->index(2, 0));
  QTest::keyClick(&f.row(), Qt::Key_Home);
  QCOMPARE(f.row().currentIndex().row(), 0);
  QVERIFY(!(f.viewport().camera() == f.scene().views()[0].camera));
  QTest::keyClick(&f.row(), Qt::Key_Return);
  QVERIFY(f.viewport().camera() == f.scene().views()[0].camera);
}

void ViewsTest::goingThereByTheMenu() {
  Views f;
  f.addThree();
  f.control<QMenu>("savedViews").actions()[1]->trigger();
  QVERIFY(f.viewport().camera() == f.scene().views()[1].camera);
  QCOMPARE(f.row().currentIndex().row(), 1);
}

void ViewsTest::transition() {
  Views f;
  f.add("A");
  f.setGamma(f.left, 5.0f);
  f.add("P");
  QVERIFY(f.settled());
  f.clickCard(0);
  QVERIFY(f.settled());
  f.fly();
  QElapsedTimer clock;
  clock.start();
  QList<glm::vec3> eyes;
  connect(&f.viewport(), &widgets::Viewport::cameraChanged, &f.viewport(),
          [&] { eyes << f.viewport().camera().eye; });
  f.clickCard(1);
  QVERIFY(!f.viewport().upToDate());
  // The document is there at once, the picture on its way.
  QCOMPARE(f.scene().resolve(f.left).gamma.value(), 5.0f);
  QVERIFY(f.settled());
  QVERIFY(f.viewport().camera() == f.scene().views()[1].camera);
  QVERIFY2(eyes.size() >= 2, qPrintable(QString::number(eyes.size())));
  // On an arc: never nearer than both ends.
  const model::Camera end = f.viewport().camera();
  const float distance = glm::length(end.eye - end.target);
  for (const glm::vec3& eye : eyes)
    QVERIFY(glm::length(eye - end.target) > 0.8f * distance);
  const QImage flown = f.picture();
  f.viewport().setFlights(false);
  f.clickCard(0);
  QVERIFY(f.settled());
  f.clickCard(1);
  QVERIFY(f.settled());
  QCOMPARE(difference(flown, f.picture()), QRect());
}

void ViewsTest::interruptedByHand() {
  Views f;
  f.add("A");
  f.setGamma(f.left, 5.0f);
  f.add("P");
  QVERIFY(f.settled());
  f.fly();
  f.clickCard(0);
  QVERIFY(!f.viewport().upToDate());
  dragMouse(f.viewport(), {300, 300}, {340, 300});
  const model::Camera stopped = f.viewport().camera();
  QVERIFY(f.settled());
  QVERIFY(f.viewport().camera() == stopped);
  QVERIFY(!(stopped == f.scene().views()[0].camera));
  QCOMPARE(f.scene().resolve(f.left).gamma.value(), 2.0f);
  // The picture is of the document, not of something on the way.
  const QImage picture = f.picture();
  f.viewport().setFlights(false);
  f.viewport().setCamera(f.scene().views()[0].camera);
  QVERIFY(f.settled());
  f.viewport().setCamera(stopped);
  QVERIFY(f.settled());
  QCOMPARE(difference(picture, f.picture()), QRect());
}

void ViewsTest::editedMeanwhile() {
  Views f;
  f.add("A");
  f.setGamma(f.left, 5.0f);
  f.add("P");
  QVERIFY(f.settled());
  f.fly();
  f.clickCard(0);
  f.undo();
  QVERIFY(f.settled());
  QCOMPARE(f.scene().resolve(f.left).gamma.value(), 5.0f);
  QVERIFY(f.viewport().camera() == f.scene().views()[0].camera);
  const QImage picture = f.picture();
  f.session.redo();
  QVERIFY(f.settled());
  f.session.undo();
  QVERIFY(f.settled());
  QCOMPARE(difference(picture, f.picture()), QRect());
}

void ViewsTest::picturesAreKeptAndDrawnAgain() {
  Views f;
  f.addThree();
  QVERIFY(f.pictured(3));
  QCOMPARE(f.pictures().drawn(), 3);
  const QImage first = f.cardPicture(0);
  QCOMPARE(first.size(), QSize(112, 68));
  QVERIFY(first != f.cardPicture(2));
  // Names and order are no part of a picture, nor what the views say themselves.
  f.row().setCurrentIndex(f.row().model()->index(0, 0));
  QTest::keyClick(&f.row(), Qt::Key_Right, Qt::AltModifier);
  QVERIFY(f.cardPicture(1) == first);
  f.setGamma(f.left, 0.0f);
  QVERIFY(f.settled());
  // One that shows something else is drawn again, alone.
  f.session.apply(QStringLiteral("Γ"),
                  model::withStyle(f.scene(), std::array{f.left}, {.visible = false}));
  f.press("viewUpdate");
  constexpr int minute = 60'000;
  QVERIFY(QTest::qWaitFor([&] { return f.cardPicture(1) != first; }, minute));
  QCOMPARE(f.pictures().drawn(), 4);
  f.undo();
  QVERIFY(QTest::qWaitFor([&] { return f.cardPicture(1) == first; }, minute));
  QCOMPARE(f.pictures().drawn(), 4);
}

void ViewsTest::presentation() {
  Views f;
  f.addThree();
  f.clickCard(1);
  QVERIFY(f.settled());
  QTest::keyClick(&f.viewport(), Qt::Key_F5, Qt::ShiftModifier);
  QCOMPARE(f.presented(), QString("2 / 3   View 2"));
  QVERIFY(f.window.isFullScreen());
  QVERIFY(!f.window.menuBar()->isVisible() && !f.window.statusBar()->isVisible());
  for (QDockWidget* dock : f.window.findChildren<QDockWidget*>())
    QVERIFY2(!dock->isVisible(), qPrintable(dock->objectName()));
  const struct {
    Qt::Key key;
    int at;
  } rows[] = {{Qt::Key_Right, 3},     {Qt::Key_Right, 3},  {Qt::Key_Left, 2},
              {Qt::Key_Home, 1},      {Qt::Key_Up, 1},     {Qt::Key_Space, 2},
              {Qt::Key_PageDown, 3},  {Qt::Key_PageUp, 2}, {Qt::Key_End, 3},
              {Qt::Key_Backspace, 2}, {Qt::Key_Return, 3}};
  for (const auto& row : rows) {
    QTest::keyClick(&f.viewport(), row.key);
    QCOMPARE(f.presented(), QString("%1 / 3   View %1").arg(row.at));
    QVERIFY(f.viewport().camera() == f.scene().views()[std::size_t(row.at - 1)].camera);
  }
  // The mouse turns the scene.
  dragMouse(f.viewport(), {300, 300}, {360, 300});
  QVERIFY(!(f.viewport().camera() == f.scene().views()[2].camera));
  QTest::keyClick(&f.viewport(), Qt::Key_Escape);
  QCOMPARE(f.presented(), QString());
  QCOMPARE(f.row().currentIndex().row(), 2);
}

void ViewsTest::presentationGivesAllBack() {
  Views f;
  f.addThree();
  QTest::keyClick(&f.viewport(), Qt::Key_Plus);
  QTest::keyClick(&f.window, Qt::Key_1, Qt::ControlModifier);
  QVERIFY(f.settled());
  const model::Camera camera = f.viewport().camera();
  const QRect place = f.window.geometry();
  QStringList before;
  const auto visible = [&] {
    QStringList names;
    for (QWidget* widget : f.window.findChildren<QWidget*>())
      if (widget->isVisible() && !widget->objectName().isEmpty())
        names << widget->objectName();
    names.sort();
    return names;
  };
  before = visible();
  const QImage picture = f.picture();
  QVERIFY(f.session.activeSection());
  f.control<QAction>("present").trigger();
  QVERIFY(f.settled());
  QVERIFY(!f.session.activeSection());
  QTest::keyClick(&f.viewport(), Qt::Key_Escape);
  QVERIFY(!f.window.isFullScreen());
  QTRY_COMPARE(f.window.geometry(), place);
  QVERIFY(f.settled());
  QVERIFY(f.session.activeSection());
  QVERIFY(f.viewport().camera() == camera);
  QCOMPARE(visible(), before);
  QCOMPARE(difference(picture, f.picture()), QRect());
}

void ViewsTest::presentationLeavesTheSceneAlone() {
  Views f;
  f.addThree();
  f.setGamma(f.left, 5.0f);
  f.session.select({f.left});
  QVERIFY(f.settled());
  const QImage edited = f.picture();
  const model::Scene before = f.scene();
  const int steps = f.steps();
  f.control<QAction>("present").trigger();
  QVERIFY(f.settled());
  for (const Qt::Key key : {Qt::Key_Delete, Qt::Key_F, Qt::Key_Slash, Qt::Key_K, Qt::Key_X})
    QTest::keyClick(&f.viewport(), key);
  QTest::keyClick(&f.viewport(), Qt::Key_Z, Qt::ControlModifier);
  QTest::keyClick(&f.viewport(), Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
  QTest::mouseClick(&f.viewport(), Qt::LeftButton, {}, f.viewport().rect().center());
  QTest::mouseClick(&f.viewport(), Qt::RightButton, {}, f.viewport().rect().center());
  QVERIFY(f.settled());
  QVERIFY(f.scene() == before && f.steps() == steps);
  QCOMPARE(f.session.selection(), widgets::NodeIds{f.left});
  QVERIFY(!QApplication::activePopupWidget());
  // What is shown is the view all the same: all at Γ 2.
  QCOMPARE(f.viewport().shownScene().resolve(f.left).gamma.value(), 2.0f);
  QTest::keyClick(&f.viewport(), Qt::Key_Escape);
  QVERIFY(f.settled());
  QCOMPARE(difference(edited, f.picture()), QRect());
}

void ViewsTest::presentationEndsWithTheDocument() {
  Views f;
  f.addThree();
  f.control<QAction>("present").trigger();
  QVERIFY(!f.presented().isEmpty());
  f.session.openEmpty(QStringLiteral("another"));
  QVERIFY(f.presented().isEmpty());
  QVERIFY(!f.window.isFullScreen());
  QVERIFY(f.window.menuBar()->isVisible());
}

void ViewsTest::whatIsGoneIsMarked() {
  model::View view{.name = "V"};
  view.looks = {{.node = {901}}, {.node = {902}}};
  Views f({view, {.name = "whole"}});
  const QModelIndex index = f.row().model()->index(0, 0);
  QCOMPARE(index.data(widgets::ViewList::absentRole).toInt(), 2);
  QVERIFY2(index.data(Qt::ToolTipRole).toString().contains("2 of the structures"),
           qPrintable(index.data(Qt::ToolTipRole).toString()));
  QCOMPARE(f.row().model()->index(1, 0).data(widgets::ViewList::absentRole).toInt(), 0);
  // It can be gone to, and an update forgets what is gone.
  f.clickCard(0);
  QVERIFY(f.settled());
  f.press("viewUpdate");
  QCOMPARE(f.row().model()->index(0, 0).data(widgets::ViewList::absentRole).toInt(), 0);
}

void ViewsTest::twoHundred() {
  std::vector<model::View> views;
  for (int i = 0; i < 200; ++i) {
    model::View view{.name = "View " + std::to_string(i + 1)};
    view.camera.eye = {500.0f * std::sin(float(i)), -500.0f * std::cos(float(i)), 0.0f};
    views.push_back(view);
  }
  Views f(views);
  QCOMPARE(f.row().model()->rowCount(), 200);
  const int seen = int(f.row().visibleRows().size());
  QVERIFY2(seen >= 2 && seen < 15, qPrintable(QString::number(seen)));
  QVERIFY(f.pictured(seen));
  QVERIFY(f.cardPicture(150).isNull());  // only those on screen are drawn
  QVERIFY(f.pictures().drawn() < 20);
  f.row().scrollTo(f.row().model()->index(199, 0));
  constexpr int minute = 60'000;
  QVERIFY(QTest::qWaitFor([&] { return !f.cardPicture(199).isNull(); }, minute));
  f.clickCard(199);
  QVERIFY(f.viewport().camera() == f.scene().views()[199].camera);
  QTest::keyClick(&f.row(), Qt::Key_Delete);
  QCOMPARE(f.row().model()->rowCount(), 199);
  QVERIFY(f.row().horizontalScrollBar()->value() > 0);
}

void ViewsTest::hostileNames() {
  const std::vector<std::string> names{"<b>bold</b><img src=x>",
                                       "a\nb\tc",
                                       "&File",
                                       std::string(5000, 'x'),
                                       "\xE2\x80\xAE"
                                       "evil",
                                       "\xD8\xB9\xD8\xB1\xD8\xA8\xD9\x8A",
                                       "\xFF\xFE",
                                       "%1 %n"};
  std::vector<model::View> views;
  for (const std::string& name : names)
    views.push_back({.name = name});
  Views f(views);
  const auto shown = [&](int row) { return f.row().model()->index(row, 0).data().toString(); };
  QCOMPARE(shown(0), QString("<b>bold</b><img src=x>"));
  QCOMPARE(shown(1), QString("a b c"));
  QVERIFY(shown(3).size() <= 200);
  QCOMPARE(shown(4), QString("evil"));
  const QString tip = f.row().model()->index(0, 0).data(Qt::ToolTipRole).toString();
  QVERIFY2(!tip.contains("<b>") && tip.contains("&lt;b&gt;"), qPrintable(tip));
  QCOMPARE(f.control<QMenu>("savedViews").actions()[2]->text(), QString("&&File"));
  f.control<QAction>("present").trigger();
  QCOMPARE(f.presented(), QString("1 / 8   <b>bold</b><img src=x>"));
  QCOMPARE(f.control<QLabel>("presentedView").textFormat(), Qt::PlainText);
  for (int i = 1; i < 8; ++i) {
    QTest::keyClick(&f.viewport(), Qt::Key_Right);
    const auto& label = f.control<QLabel>("presentedView");
    QVERIFY(f.viewport().rect().contains(label.geometry()));
  }
  QVERIFY(f.presented().endsWith("%1 %n"));
  QTest::keyClick(&f.viewport(), Qt::Key_Escape);
  // Typing changes what is typed alone.
  f.clickCard(1);
  QTest::keyClick(&f.row(), Qt::Key_F2);
  auto* editor = f.row().findChild<QLineEdit*>(QStringLiteral("viewName"));
  QVERIFY(editor);
  QTest::keyClick(editor, Qt::Key_Return);
  f.typed();
  QCOMPARE(f.scene().views()[1].name, std::string("a\nb\tc"));
}

}  // namespace sline::test

QTEST_MAIN(sline::test::ViewsTest)
#include "views_test.moc"
