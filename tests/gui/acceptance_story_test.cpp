// SPDX-License-Identifier: Apache-2.0
// Tests the main job from start to end by hand, counting clicks: a folder is dropped, an organ
// found, its line style set, focus, a colour, a turn, saved, closed and opened again.
#include <QAction>
#include <QColorDialog>
#include <QFileDialog>
#include <QLineEdit>
#include <QToolBar>
#include <QtTest>

#include "tests/gui/window_fixture.h"
#include "tests/support/suite.h"
#include "widgets/focus/focus_context.h"
#include "widgets/gamma/gamma_slider.h"
#include "widgets/structure_tree/structure_tree_model.h"

namespace sline::test {

namespace {

/// Acts and counts as a user does. A press of the mouse is a click, whether or not a drag follows;
/// a key with its modifiers and a word typed in one go are actions of their own.
class Hands {
 public:
  void click(QWidget& widget, const QPoint& at) {
    QTest::mouseClick(&widget, Qt::LeftButton, {}, at);
    ++m_clicks;
  }
  void click(QWidget& widget) { click(widget, widget.rect().center()); }
  void drag(QWidget& widget, const QPoint& from, const QPoint& to) {
    dragMouse(widget, from, to);
    ++m_clicks;
  }
  void key(QWidget& widget, Qt::Key key, Qt::KeyboardModifiers keys = {}) {
    QTest::keyClick(&widget, key, keys);
    ++m_keys;
  }
  void type(QWidget& widget, const QString& text) {
    QTest::keyClicks(&widget, text);
    ++m_words;
  }
  /// Sets the text in one go and counts a typed word; typed letter by letter, completion would
  /// interfere.
  void write(QLineEdit& edit, const QString& text) {
    edit.setText(text);
    ++m_words;
  }
  /// Counts a drag of files from elsewhere onto the window.
  void dropped() { ++m_clicks; }
  int clicks() const { return m_clicks; }
  QString text() const {
    return QStringLiteral("%1 clicks, %2 keys, %3 words").arg(m_clicks).arg(m_keys).arg(m_words);
  }

 private:
  int m_clicks = 0;
  int m_keys = 0;
  int m_words = 0;
};

template <class T>
T* dialog(const char* name = nullptr) {
  T* found = nullptr;
  const bool there = QTest::qWaitFor([&] {
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (auto* one = qobject_cast<T*>(widget);
          one && one->isVisible() && (!name || one->objectName() == QLatin1String(name)))
        found = one;
    return found != nullptr;
  });
  return there ? found : nullptr;
}

/// Tells whether the scenes are equal in all but where in memory the meshes lie.
bool alike(const model::Scene& a, const model::Scene& b) {
  std::vector<model::Node> nodes = a.nodes();
  if (nodes.size() != b.nodes().size())
    return false;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const model::MeshPtr& other = b.nodes()[i].mesh;
    if (!nodes[i].mesh != !other || (other && !(*nodes[i].mesh == *other)))
      return false;
    nodes[i].mesh = other;
  }
  return nodes == b.nodes() && a.sections() == b.sections() && a.views() == b.views() &&
         a.annotations() == b.annotations() && a.keyLight() == b.keyLight();
}

/// Copies the files of that folder's manifest that make a scene of 28 structures.
bool copyCore(const QString& from, const QString& to) {
  QFile manifest(from + QStringLiteral("/MANIFEST.tsv"));
  if (!manifest.open(QIODevice::ReadOnly))
    return false;
  int copied = 0;
  while (!manifest.atEnd()) {
    const QStringList cells = QString::fromUtf8(manifest.readLine()).split(QLatin1Char('\t'));
    constexpr int core = 4;
    if (cells.size() > core && cells[core] == QLatin1String("1"))
      copied += QFile::copy(from + QLatin1Char('/') + cells[0], to + QLatin1Char('/') + cells[0]);
  }
  return copied == 28;
}

}  // namespace

class AcceptanceStoryTest : public QObject {
  Q_OBJECT

  /// Returns where in the picture a click selects the structure: it may be behind another in
  /// places.
  static std::optional<QPoint> placeOf(WindowFixture& f, model::NodeId id) {
    const QRect area = f.areaOf(id) & f.viewport().rect();
    for (int step = 6; step >= 2; --step)
      for (int y = 1; y < step; ++y)
        for (int x = 1; x < step; ++x) {
          const QPoint at =
              area.topLeft() + QPoint(area.width() * x / step, area.height() * y / step);
          f.session.select({});
          QTest::mouseClick(&f.viewport(), Qt::LeftButton, {}, at);
          if (QTest::qWaitFor([&] { return !f.session.selection().empty(); }, 1000) &&
              f.session.selection() == widgets::NodeIds{id}) {
            f.session.select({});
            return at;
          }
        }
    return std::nullopt;
  }

  /// Does everything up to saving; leaves the structure in focus and coloured.
  void illustrate(WindowFixture& f, Hands& hands, const QString& word, const QString& name,
                  bool inThePicture) {
    const model::NodeId id = f.session.scene().named(name.toStdString()).front();
    if (inThePicture) {
      const std::optional<QPoint> at = placeOf(f, id);
      QVERIFY2(at, "nothing of it can be seen");
      hands.click(f.viewport(), *at);
    } else {
      hands.key(f.window, Qt::Key_F, Qt::ControlModifier);
      auto& filter = f.control<QLineEdit>("structureFilter");
      hands.type(filter, word);
      hands.click(*f.tree().viewport(),
                  f.tree().cellOf(id, widgets::StructureTreeModel::name).center());
      hands.key(filter, Qt::Key_Escape);
    }
    QTRY_COMPARE(f.session.selection(), widgets::NodeIds{id});

    auto& slider = f.control<widgets::GammaSlider>("gammaSlider");
    const Gamma before = f.session.scene().resolve(id).gamma;
    hands.drag(slider, slider.pointOf(before).toPoint(),
               slider.pointOf(Gamma::clamped(3.5f)).toPoint());
    QVERIFY(std::abs(f.session.scene().resolve(id).gamma.value() - 3.5f) < 0.1f);

    QAction& focus = *f.window.findChild<QAction*>(QStringLiteral("focus"));
    hands.click(*f.control<QToolBar>("tools").widgetForAction(&focus));
    QTRY_VERIFY(!f.window.focus().busy());
    QVERIFY(f.session.scene().resolve(id).gamma.value() > 4.0f);

    f.tree().scrollTo(f.tree().indexOf(id));
    hands.click(*f.tree().viewport(),
                f.tree().cellOf(id, widgets::StructureTreeModel::swatch).center());
    auto* colours = dialog<QColorDialog>("colourDialog");
    QVERIFY(colours);
    auto* code = colours->findChild<QLineEdit*>();
    QVERIFY(code);
    code->selectAll();
    hands.type(*code, QStringLiteral("#c05030"));
    hands.key(*code, Qt::Key_Return);
    QTRY_COMPARE(f.session.scene().resolve(id).colour, (Colour{0xc0, 0x50, 0x30}));

    const model::Camera camera = f.viewport().camera();
    const QPoint middle = f.viewport().rect().center();
    hands.drag(f.viewport(), middle, middle + QPoint(80, 30));
    QVERIFY(!(f.viewport().camera() == camera));
  }

 private slots:
  void fromFolderToFile_data() {
    QTest::addColumn<bool>("real");
    QTest::addColumn<bool>("inThePicture");
    QTest::addColumn<QString>("word");
    QTest::addColumn<QString>("name");
    QTest::newRow("written meshes") << false << false << "bla"
                                    << "bladder";
    QTest::newRow("pelvis of 28, by three letters") << true << false << "bla"
                                                    << "urinary bladder";
    QTest::newRow("pelvis of 28, in the picture") << true << true << QString() << "sacrum";
  }
  void fromFolderToFile() {
    QFETCH(bool, real);
    QFETCH(bool, inThePicture);
    QFETCH(QString, word);
    QFETCH(QString, name);
    QTemporaryDir body;
    const QString pelvis = QStringLiteral(SLINE_TEST_DATA "/pelvis/bodyparts3d");
    if (!real)
      writeBody(body.path());
    else if (!copyCore(pelvis, body.path()))
      SLINE_ABSENT("no real anatomy here");
    const QString file = body.path() + QStringLiteral("/story.sline");
    Hands hands;
    model::Scene made;
    WindowFixture f;
    QVERIFY(f.drop(body.path()));
    hands.dropped();
    QVERIFY(f.settled());
    QVERIFY(f.tree().model()->rowCount() > 0);
    illustrate(f, hands, word, name, inThePicture);
    if (QTest::currentTestFailed())
      return;

    hands.key(f.window, Qt::Key_S, Qt::ControlModifier);
    auto* saving = dialog<QFileDialog>("saveDialog");
    QVERIFY(saving);
    auto* path = saving->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
    QVERIFY(path);
    // While the dialog has no focus, its list of files would interfere.
    QApplication::setActiveWindow(saving);
    path->setFocus();
    hands.write(*path, file);
    hands.key(*path, Qt::Key_Return);
    QApplication::setActiveWindow(&f.window);
    QTRY_VERIFY_WITH_TIMEOUT(!f.session.modified(), 60'000);
    made = f.session.scene();
    hands.key(f.window, Qt::Key_W, Qt::ControlModifier);
    QTRY_VERIFY(f.session.scene().nodes().empty());

    QVERIFY(f.drop(file));
    hands.dropped();
    QVERIFY(f.settled());
    QVERIFY(alike(f.session.scene(), made));
    qInfo("%s", qPrintable(hands.text()));
    QVERIFY2(hands.clicks() <= 25, qPrintable(hands.text()));
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::AcceptanceStoryTest)
#include "acceptance_story_test.moc"
