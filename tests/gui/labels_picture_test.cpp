// SPDX-License-Identifier: Apache-2.0
// Tests labels as the picture shows them: drawn, in every mode and language, steady, with their
// picture.
#include <QActionGroup>

#include "model/edit/look.h"
#include "model/edit/visibility.h"
#include "tests/gui/labels_fixture.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

/// Returns how many pixels are darker, or lighter, than halfway.
int inked(const QImage& image, const QRect& box, bool dark) {
  int count = 0;
  for (int y = box.top(); y <= box.bottom(); ++y)
    for (int x = box.left(); x <= box.right(); ++x)
      count += (qGray(image.pixel(x, y)) < 128) == dark ? 1 : 0;
  return count;
}

}  // namespace

class LabelsPictureTest : public QObject {
  Q_OBJECT

  static QRect boxIn(Labels& f, model::AnnotationId id) {
    return widgets::boxOf(f.sheet(), id).toAlignedRect();
  }
  static void showAs(Labels& f, const char* mode) {
    f.control<QAction>(qPrintable(QStringLiteral("labels-") + mode)).trigger();
    QVERIFY(f.settled());
  }

 private slots:
  void wordsAreInThePicture() {
    Labels f;
    const QImage bare = f.whole();
    f.make(f.liver, {});
    const QRect box = boxIn(f, f.only().id);
    f.session.activateAnnotation(std::nullopt);
    QVERIFY(inked(f.whole(), box, true) > inked(bare, box, true) + 20);
    // The leader is drawn, and the dot at its place, too.
    const QRect changed = difference(bare, f.whole());
    QVERIFY(changed.contains(f.placeAt(f.only().id)));
    // On dark ground ink is light.
    f.control<QAction>("background-dark").trigger();
    QVERIFY(f.settled());
    QVERIFY(inked(f.whole(), boxIn(f, f.only().id), false) > 20);
  }

  /// The picture has the same words of the same size in millimetres as one of the command line.
  void layoutIsThatOfExports() {
    Labels f;
    f.make(f.liver, {});
    f.make(f.bladder, {}, Qt::Key_P, Qt::ShiftModifier);
    const widgets::LabelSheet& sheet = f.sheet();
    model::MeshTrees trees;
    const render::LabelPlate plate = render::labelPlate(
        f.session.scene(),
        render::Screen(f.viewport().camera(), sheet.wish.size / sheet.wish.pixelsPerMm),
        sheet.wish.style, trees);
    QCOMPARE(plate.layout.labels.size(), std::size_t(2));
    for (const render::PlacedLabel& label : plate.layout.labels) {
      const render::PlacedLabel* shown = sheet.plate.layout.find(label.id);
      QVERIFY(shown);
      QVERIFY(shown->box.size() == label.box.size());
      QCOMPARE(int(shown->post), int(label.post));
    }
  }

  /// After a change to another view or a much nearer one, labels stand as if there had been none
  /// before.
  void anotherViewIsLaidOutAnew() {
    Labels f;
    f.make(f.liver, QStringLiteral("A text that makes its column very much wider"));
    f.make(f.bladder, QStringLiteral("B"));
    const auto strayed = [&f] {
      const widgets::LabelSheet& sheet = f.sheet();
      model::MeshTrees trees;
      const render::LabelPlate plate = render::labelPlate(
          f.session.scene(),
          render::Screen(f.viewport().camera(), sheet.wish.size / sheet.wish.pixelsPerMm),
          sheet.wish.style, trees);
      float most = sheet.plate.layout.labels.size() == plate.layout.labels.size() ? 0.0f : 1e6f;
      for (const render::PlacedLabel& label : plate.layout.labels)
        if (const render::PlacedLabel* shown = sheet.plate.layout.find(label.id))
          most = std::max(most, glm::distance(shown->box.low, label.box.low));
      return most;
    };
    f.viewport().setFlights(true);
    for (const Qt::Key key : {Qt::Key_P, Qt::Key_L, Qt::Key_A}) {
      f.key(key);
      QVERIFY2(strayed() < 0.1f, qPrintable(QKeySequence(key).toString()));
    }
    for (int i = 0; i < 2; ++i) {
      QWheelEvent wheel(f.viewport().rect().center(),
                        f.viewport().mapToGlobal(f.viewport().rect().center()), {}, {0, 120},
                        Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
      QCoreApplication::sendEvent(&f.viewport(), &wheel);
    }
    QVERIFY2(strayed() < 0.1f, "nearer");
  }

  /// In a window of another size a text that was moved by hand stands where it stood beside its
  /// structure, and the other label on its side.
  void anotherSizeOfTheWindowMovesNoText() {
    Labels f;
    f.make(f.liver, {});
    f.make(f.bladder, {}, Qt::Key_T);
    const model::AnnotationId id = f.annotations().front().id;
    const model::AnnotationId other = f.annotations().back().id;
    dragMouse(f.viewport(), f.textAt(id), f.textAt(id) + QPoint(60, -70));
    const auto beside = [&] {
      const glm::vec2 from(f.textAt(id).x() - f.placeAt(id).x(),
                           f.textAt(id).y() - f.placeAt(id).y());
      return from / f.sheet().wish.size.y;
    };
    const glm::vec2 before = beside();
    const render::LabelPost side = f.sheet().plate.layout.find(other)->post;
    const QSize size = f.window.size();
    for (const QSize& now :
         {QSize(size.width() - 60, size.height()), QSize(size.width() - 60, size.height() - 50),
          QSize(size.width() - 20, size.height() - 80), size}) {
      f.window.resize(now);
      QVERIFY(f.settled());
      QVERIFY2(glm::distance(beside(), before) * f.sheet().wish.size.y < 3.0f,
               qPrintable(QStringLiteral("%1 x %2").arg(now.width()).arg(now.height())));
      QCOMPARE(f.sheet().plate.layout.find(other)->post, side);
    }
  }

  /// Until the picture has another size, labels would stand where their places were.
  void labelsWaitForThePicturesSize() {
    Labels f;
    f.make(f.liver, {});
    const auto painted = [&f] {
      const QImage image =
          f.control<QWidget>("labelLayer").grab().toImage().convertToFormat(QImage::Format_ARGB32);
      int count = 0;
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
          count += image.pixel(x, y) != image.pixel(0, 0) ? 1 : 0;
      return count;
    };
    f.sheet();
    QVERIFY(painted() > 100);
    f.window.resize(f.window.size() - QSize(120, 90));
    QCOMPARE(painted(), 0);
    f.sheet();
    QVERIFY(painted() > 100);
  }

  /// Fit All leaves the anatomy between the columns.
  void fitAllLeavesRoomForLabels() {
    Labels f;
    f.make(f.liver, QStringLiteral("A text that makes its column wider"));
    f.make(f.bladder, QStringLiteral("Another such text"));
    f.key(Qt::Key_P);
    f.key(Qt::Key_A);
    for (int i = 0; i < 4; ++i) {
      QWheelEvent wheel(f.viewport().rect().center(),
                        f.viewport().mapToGlobal(f.viewport().rect().center()), {}, {0, 120},
                        Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
      QCoreApplication::sendEvent(&f.viewport(), &wheel);
    }
    f.control<QAction>("fit").trigger();
    const widgets::LabelSheet& sheet = f.sheet();
    const render::ObstacleMask anatomy = render::obstaclesOf(
        f.session.scene(),
        render::Screen(f.viewport().camera(), sheet.wish.size / sheet.wish.pixelsPerMm));
    QCOMPARE(sheet.plate.layout.labels.size(), std::size_t(2));
    for (const render::PlacedLabel& label : sheet.plate.layout.labels)
      QVERIFY(!render::overlap(label.box, *anatomy.extent));
  }

  /// A place that is hidden in exports is hidden here, too.
  void hiddenPlacesAreTold() {
    Labels f;
    f.make(f.liver, QStringLiteral("Left lobe"));
    QVERIFY(!f.sheet().plate.labels.front().item.hidden);
    f.key(Qt::Key_P);  // from behind
    QVERIFY(f.sheet().plate.labels.front().item.hidden);
    // A structure's own name stands for all of it: its place is where the structure shows.
    f.undo();
    f.key(Qt::Key_A);
    f.make(f.liver, {});
    f.key(Qt::Key_P);
    QVERIFY(!f.sheet().plate.labels.front().item.hidden);
    // A structure that is not shown has no label.
    f.session.apply("hide", model::withLook(f.session.scene(), {&f.liver, 1}, {.visible = false}));
    QVERIFY(f.settled());
    QVERIFY(!f.labels().layer().sheet());
    f.undo();
    QVERIFY(f.settled());
    QVERIFY(f.labels().layer().sheet());
    // A removed structure has none either; undo brings both back.
    f.session.select({f.liver});
    f.control<QAction>("remove").trigger();
    QVERIFY(f.annotations().empty());
    QVERIFY(f.settled());
    QVERIFY(!f.labels().layer().sheet());
    f.undo();
    QVERIFY(f.settled());
    QVERIFY(f.labels().layer().sheet());
  }

  void modesAreChosen() {
    Labels f;
    f.make(f.liver, {});
    f.make(f.bladder, {});
    const auto lines = [&f] { return f.shownLines(); };
    QCOMPARE(lines(), QStringList({"liver", "bladder"}));
    showAs(f, "numbers");
    QCOMPARE(lines(), QStringList({"1", "2"}));
    QCOMPARE(f.window.preferences().choice("labels/mode"), QStringLiteral("numbers"));
    showAs(f, "blank");
    QCOMPARE(lines(), QStringList({"", ""}));
    // Blank lines reveal nothing of their words.
    f.session.activateAnnotation(std::nullopt);
    QVERIFY(f.settled());
    const QImage before = f.whole();
    model::Annotation other = f.annotations().front();
    other.text = "another word, and longer";
    f.session.apply("words", model::withAnnotationChanged(f.session.scene(), other.id, other));
    QVERIFY(f.settled());
    QVERIFY(difference(before, f.whole()).isEmpty());
    showAs(f, "off");
    QVERIFY(!f.labels().layer().sheet());
    showAs(f, "texts");
    QCOMPARE(lines(), QStringList({"another word,/and longer", "bladder"}));
  }

  void languageIsChosen() {
    Labels f;
    f.make(f.liver, {});
    f.make(f.bladder, QStringLiteral("my bladder"));
    const auto speak = [&f](const char* language) {
      f.window.preferences().set("labels/language", language);
      return f.shownLines();
    };
    QCOMPARE(speak("de"), QStringList({"Leber", "my bladder"}));
    QCOMPARE(speak("la"), QStringList({"hepar", "my bladder"}));
    QCOMPARE(speak("scene"), QStringList({"liver", "my bladder"}));
    // The labels use the language of the structures' names.
    f.window.preferences().set("language/structures", "nl");
    QCOMPARE(speak("structures"), QStringList({"lever", "my bladder"}));
    // Typed words count as words of that language.
    QTest::mouseDClick(&f.viewport(), Qt::LeftButton, {}, f.textAt(f.annotations().back().id));
    QVERIFY(f.typing());
    QTest::keyClicks(&f.editor(), QStringLiteral("mijn blaas"));
    QTest::keyClick(&f.editor(), Qt::Key_Return);
    QCOMPARE(f.annotations().back().text, std::string("my bladder"));
    QCOMPARE(f.annotations().back().texts.at("nl"), std::string("mijn blaas"));
    QCOMPARE(speak("scene"), QStringList({"liver", "my bladder"}));
  }

  void lettersHaveTheirSize() {
    Labels f;
    f.make(f.liver, {});
    const QRectF before = widgets::boxOf(f.sheet(), f.only().id);
    f.window.preferences().set("labels/points", 20);
    const QRectF after = widgets::boxOf(f.sheet(), f.only().id);
    QVERIFY(std::abs(after.height() / before.height() - 2.0) < 0.05);
    // Points are points of this screen.
    const double pixels = 20.0 * f.viewport().logicalDpiY() / 72.0;
    QVERIFY(after.height() > pixels && after.height() < 1.5 * pixels);
  }

  /// Labels belong to the camera of the picture that they lie over, at every step of a turn, and
  /// stay on their side.
  void labelsComeWithTheirPicture() {
    Labels f;
    f.make(f.liver, {});
    f.make(f.bladder, {});
    const auto postOf = [&f](std::size_t i) {
      return f.sheet().plate.layout.find(f.annotations()[i].id)->post;
    };
    const render::LabelPost liver = postOf(0);
    const render::LabelPost bladder = postOf(1);
    QVERIFY(liver != bladder);
    for (int step = 0; step < 6; ++step) {
      f.key(Qt::Key_Right);
      QVERIFY(f.sheet().camera == f.viewport().camera());
      QVERIFY(postOf(0) == liver);
      QVERIFY(postOf(1) == bladder);
    }
    const QPoint from = f.viewport().rect().center() + QPoint(0, 200);
    sendMouse(f.viewport(), QEvent::MouseButtonPress, from);
    for (int step = 1; step <= 8; ++step) {
      sendMouse(f.viewport(), QEvent::MouseMove, from - QPoint(12 * step, 0));
      QTRY_VERIFY(f.labels().layer().sheet() &&
                  f.labels().layer().sheet()->camera == f.viewport().camera());
    }
    sendMouse(f.viewport(), QEvent::MouseButtonRelease, from - QPoint(96, 0));
  }

  /// Neither texts nor leaders are under the cube, the bar, the letters or the time.
  void labelsKeepClearOfMarks() {
    Labels f;
    f.control<QAction>("showFrameTime").setChecked(true);
    model::Scene scene = f.session.scene();
    for (std::uint32_t i = 0; i < 26; ++i) {
      const model::NodeId on = i % 2 == 0 ? f.liver : f.bladder;
      const auto count = std::uint32_t(scene.find(on)->mesh->triangleCount());
      scene = model::withAnnotation(
                  scene, {.anchors = {model::SurfacePoint{on, (i * 2477U) % count, {0.3f, 0.3f}}},
                          .text = "label " + std::to_string(i)})
                  .scene;
    }
    f.session.apply("labels", {.scene = scene, .changed = true});
    const auto marks = [&f] {
      QList<QRectF> boxes;
      for (const char* name : {"orientationCube", "scaleBar", "frameTime", "letterLeft",
                               "letterRight", "letterTop", "letterBottom"}) {
        const QWidget& mark = f.control<QWidget>(name);
        if (mark.isVisible())
          boxes << QRectF(mark.geometry());
      }
      return boxes;
    };
    for (int step = 0; step < 5; ++step) {
      const widgets::LabelSheet& sheet = f.sheet();
      QVERIFY(marks().size() >= 6);
      QVERIFY2(sheet.plate.layout.labels.size() > 5,
               qPrintable(QString::number(sheet.plate.layout.labels.size())));
      const double scale = double(sheet.wish.pixelsPerMm);
      for (const render::PlacedLabel& label : sheet.plate.layout.labels)
        for (const QRectF& mark : marks()) {
          const QRectF box = widgets::boxOf(sheet, label.id);
          QVERIFY2(!box.intersects(mark), qPrintable(QString("step %1").arg(step)));
          const auto& leader = label.leader;
          for (std::size_t i = 1; i < leader.size(); ++i)
            for (double t = 0.0; t <= 1.0; t += 0.02) {
              const QPointF a(double(leader[i - 1].x), double(leader[i - 1].y));
              const QPointF b(double(leader[i].x), double(leader[i].y));
              QVERIFY(!mark.contains(scale * (a + t * (b - a))));
            }
        }
      f.key(Qt::Key_Right);
    }
  }

  /// Presented labels can be read from the last row of a hall: they have a fortieth of the
  /// picture's height, and nothing lies over the letter of the lower side.
  void presentedLabelsAreLarge() {
    Labels f;
    f.make(f.liver, {});
    f.key(Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(f.settled());
    const auto letters = [&f] {
      const widgets::LabelWish& wish = f.sheet().wish;
      return double(wish.style.points * wish.pixelsPerMm) * 25.4 / 72.0 /
             double(f.viewport().height());
    };
    const double before = letters() * double(f.viewport().height());
    const int letterBefore = f.control<QWidget>("letterBottom").height();
    f.control<QAction>("present").trigger();
    QVERIFY(f.settled());
    QVERIFY2(letters() > 0.0245 && letters() < 0.026, qPrintable(QString::number(letters())));
    const double pixels = letters() * double(f.viewport().height());
    QVERIFY2(pixels > before + 5.0, qPrintable(QString::number(pixels)));
    const auto& below = f.control<QWidget>("letterBottom");
    QVERIFY(below.isVisible() && below.height() >= f.viewport().height() / 40);
    const auto& name = f.control<QWidget>("presentedView");
    QVERIFY(name.isVisible() && !name.geometry().intersects(below.geometry()));
    QVERIFY(f.viewport().rect().contains(name.geometry()));
    QVERIFY(name.height() < f.viewport().height() / 16);  // one line
    const QRectF text = widgets::boxOf(f.sheet(), f.only().id);
    QVERIFY(!text.isEmpty() && !text.intersects(QRectF(name.geometry())));
    if (const QString folder = qEnvironmentVariable("SLINE_SCREENSHOTS"); !folder.isEmpty())
      QVERIFY(f.window.grab().save(folder + "/presented.png"));
    f.key(Qt::Key_Escape);
    QVERIFY(f.settled());
    QTRY_COMPARE(letters() * double(f.viewport().height()), before);
    QCOMPARE(f.control<QWidget>("letterBottom").height(), letterBefore);
  }

  /// Neither sorting the meshes nor a new document is a reason to wait for a picture.
  void anotherDocumentHasItsOwn() {
    Labels f;
    f.make(f.liver, {});
    f.session.openEmpty(QStringLiteral("nothing"));
    QVERIFY(f.settled());
    QVERIFY(!f.labels().layer().sheet());
    f.session.undo();
    QVERIFY(f.settled());
    QVERIFY(f.labels().layer().sheet());
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::LabelsPictureTest)
#include "labels_picture_test.moc"
