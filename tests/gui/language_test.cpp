// SPDX-License-Identifier: Apache-2.0
// Tests another language while the program runs: texts, numbers and names of structures change;
// what the user has made of the window stays.
#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QToolBar>
#include <QtTest>

#include "model/edit/look.h"
#include "model/edit/visibility.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/suite.h"
#include "widgets/language/language_switch.h"
#include "widgets/language/languages.h"
#include "widgets/structure_tree/structure_tree_model.h"

namespace sline::test {

class LanguageTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_body;

  /// Provides the window and the object that switches its language.
  struct Spoken : WindowFixture {
    widgets::LanguageSwitch language;
    Spoken() { language.follow(window.preferences()); }
    ~Spoken() { language.use(QStringLiteral("en")); }
    bool speak(const QString& choice) {
      const bool changed = window.preferences().set(QStringLiteral("language/interface"), choice);
      QCoreApplication::sendPostedEvents();
      return changed;
    }
    QString title(const char* dock) { return control<QDockWidget>(dock).windowTitle(); }
  };

 private slots:
  void initTestCase() { writeBody(m_body.path()); }

  void allThatIsReadChanges_data() {
    QTest::addColumn<QString>("structures");
    QTest::addColumn<QString>("edit");
    QTest::addColumn<QString>("number");
    QTest::addColumn<QString>("kidney");
    QTest::newRow("de") << "Strukturen"
                        << "&Bearbeiten"
                        << "3,25"
                        << "linke Niere";
    QTest::newRow("nl") << "Structuren"
                        << "Be&werken"
                        << "3,25"
                        << "linker nier";
    QTest::newRow("nb") << "Strukturer"
                        << "&Rediger"
                        << "3,25"
                        << "venstre nyre";
  }
  void allThatIsReadChanges() {
    QFETCH(QString, structures);
    QFETCH(QString, edit);
    QFETCH(QString, number);
    QFETCH(QString, kidney);
    Spoken f;
    QVERIFY(f.drop(m_body.path()) && f.settled());
    const model::NodeId id = f.session.scene().named("left kidney").front();
    f.session.select({id});
    QVERIFY(f.session.apply(
        "Γ", model::withLook(f.session.scene(), {&id, 1}, {.gamma = Gamma::clamped(3.25f)})));
    QCOMPARE(f.title("structuresPanel"), QStringLiteral("Structures"));
    QVERIFY(f.speak(QString::fromUtf8(QTest::currentDataTag())));
    QCOMPARE(f.title("structuresPanel"), structures);
    QStringList menus;
    for (const QAction* menu : f.window.menuBar()->actions())
      menus << menu->text();
    QVERIFY2(menus.contains(edit), qPrintable(menus.join(' ')));
    QVERIFY(f.control<QDoubleSpinBox>("gammaNumber").text().contains(number));
    QCOMPARE(f.control<QLabel>("gammaTitle").text(), kidney);
    QCOMPARE(f.tree().indexOf(id).data().toString(), kidney);
    // The scene keeps its own name; the rename box begins with it.
    QCOMPARE(f.tree().indexOf(id).data(Qt::EditRole).toString(), QStringLiteral("left kidney"));
    QCOMPARE(f.session.scene().find(id)->name, std::string("left kidney"));
    QVERIFY(f.speak(QStringLiteral("en")));
    QCOMPARE(f.title("structuresPanel"), QStringLiteral("Structures"));
    QCOMPARE(f.control<QLabel>("gammaTitle").text(), QStringLiteral("left kidney"));
  }

  /// No language is offered for names in which none are known.
  void eachLanguageOfNamesHasSome() {
    int offered = 0;
    for (const widgets::PreferenceRow& row : widgets::preferenceRows())
      if (row.field.id == QLatin1String("language/structures"))
        for (const auto& choice : std::get<widgets::ChoiceField>(row.field.kind).choices) {
          const QString& id = choice.id;
          if (id == QLatin1String("file") || id == QLatin1String("interface"))
            continue;
          QVERIFY2(widgets::namesLanguage(id, QLocale::c()).has_value(), qPrintable(id));
          ++offered;
        }
    QCOMPARE(offered, 5);
  }

  void whatWasMadeOfTheWindowStays() {
    Spoken f;
    QVERIFY(f.drop(m_body.path()) && f.settled());
    const model::NodeId id = f.session.scene().named("aorta").front();
    f.session.select({id});
    f.viewport().showFrom(model::AnatomicalView::left);
    f.control<QDockWidget>("historyPanel").show();
    f.window.addDockWidget(Qt::LeftDockWidgetArea, &f.control<QDockWidget>("gammaPanel"));
    f.control<QLineEdit>("structureFilter").setText(QStringLiteral("a"));
    f.control<QLineEdit>("structureFilter").setFocus();
    QVERIFY(f.settled());
    const model::Camera camera = f.viewport().camera();
    const widgets::Document document = f.session.document();
    const widgets::Viewport* viewport = &f.viewport();
    const int steps = f.session.history().count();

    for (const char* language : {"de", "nb", "nl", "en"}) {
      QVERIFY(f.speak(QLatin1String(language)));
      QCOMPARE(&f.viewport(), viewport);
      QVERIFY(f.viewport().camera() == camera);
      QVERIFY(f.session.document() == document);
      QCOMPARE(f.session.history().count(), steps);
      QCOMPARE(f.session.selection(), widgets::NodeIds{id});
      QCOMPARE(f.tree().selectionModel()->selectedRows().size(), 1);
      QCOMPARE(f.control<QLineEdit>("structureFilter").text(), QStringLiteral("a"));
      QCOMPARE(f.window.focusWidget(), &f.control<QLineEdit>("structureFilter"));
      QVERIFY(f.control<QDockWidget>("historyPanel").isVisible());
      QCOMPARE(f.window.dockWidgetArea(&f.control<QDockWidget>("gammaPanel")),
               Qt::LeftDockWidgetArea);
      QCOMPARE(f.window.findChildren<QToolBar*>().size(), 1);
      QCOMPARE(f.window.findChildren<QDockWidget*>(QStringLiteral("structuresPanel")).size(), 1);
    }
  }

  void controlsMadeAnewWork() {
    Spoken f;
    QVERIFY(f.drop(m_body.path()) && f.settled());
    for (const char* language : {"de", "nl"})
      QVERIFY(f.speak(QLatin1String(language)));
    const model::NodeId id = f.session.scene().named("bladder").front();
    f.session.select({id});
    QTest::keyClick(&f.tree(), Qt::Key_Space);
    QVERIFY(!f.session.scene().resolve(id).visible);
    QCOMPARE(f.session.history().count(), 1);  // objects that are gone receive no signal any more
    f.control<QAction>("undo").trigger();
    QVERIFY(f.session.scene().resolve(id).visible);
    f.control<QAction>("sectionSagittal").trigger();
    QCOMPARE(f.session.scene().sections().size(), std::size_t(1));
    QVERIFY(f.control<QAction>("sectionSagittal").isChecked());
    f.control<QAction>("focus").trigger();
    QTRY_VERIFY(f.session.scene().resolve(id).gamma.value() > 4.0f);
    f.pullGamma(id, 2.0f);
    f.letGoOfGamma();
    QCOMPARE(f.session.scene().resolve(id).gamma.value(), 2.0f);
    QTest::keyClick(&f.window, Qt::Key_P);
    QVERIFY(model::cameraFrame(f.viewport().camera()).back.y > 0.9f);
    f.control<QAction>("showAll").trigger();
    f.control<QAction>("isolate").trigger();
    QCOMPARE(model::visibilityOf(f.session.scene(), f.session.scene().find(id)->parent),
             model::Visibility::some);
  }

  /// What went wrong is said by rooms that know no language, and read in each.
  void bannersFollow() {
    Spoken f;
    f.session.openPaths({"nowhere/liver.stl"});
    const auto says = [&f] { return f.control<QLabel>("messageText").text(); };
    QTRY_VERIFY(says().contains("There is no such file or folder"));
    QVERIFY(f.speak("de"));
    QVERIFY2(says().contains(QStringLiteral("Diese Datei oder diesen Ordner gibt es nicht")) &&
                 says().contains(QStringLiteral("Prüfe den Pfad")) && says().contains("liver.stl"),
             qPrintable(says()));
    QVERIFY(f.speak("en"));
    QVERIFY(says().contains("There is no such file or folder"));
  }

  /// The dialog in which the language is chosen follows, also the second time it is opened.
  void preferencesFollow() {
    Spoken f;
    for (const char* language : {"de", "en"}) {
      f.control<QAction>("preferences").trigger();
      QVERIFY(f.speak(QLatin1String(language)));
      QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
      QList<QDialog*> shown;
      for (QDialog* dialog : f.window.findChildren<QDialog*>("preferencesDialog"))
        if (dialog->isVisible())
          shown << dialog;
      QCOMPARE(shown.size(), qsizetype(1));
      QCOMPARE(shown.front()->windowTitle(), language == QLatin1String("de")
                                                 ? QStringLiteral("Einstellungen")
                                                 : QStringLiteral("Preferences"));
      shown.front()->close();
    }
  }

  void filterKnowsAllNames_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("found");
    QTest::newRow("as in the file") << "left kid"
                                    << "left kidney";
    QTest::newRow("Latin") << "ren sinister"
                           << "left kidney";
    QTest::newRow("German") << "rechte niere"
                            << "right kidney";
    QTest::newRow("Norwegian") << "urinblære"
                               << "bladder";
    QTest::newRow("Dutch") << "nierader"
                           << "left renal vein";
    QTest::newRow("synonym") << "Hauptschlagader"
                             << "aorta";
  }
  void filterKnowsAllNames() {
    QFETCH(QString, text);
    QFETCH(QString, found);
    Spoken f;
    QVERIFY(f.drop(m_body.path()) && f.settled());
    QTest::keyClicks(&f.control<QLineEdit>("structureFilter"), text);
    for (const model::Node& node : f.session.scene().nodes())
      if (!node.isGroup())
        QCOMPARE(f.tree().indexOf(node.id).isValid(), node.name == found.toStdString());
  }

  void structuresHaveALanguageOfTheirOwn_data() {
    QTest::addColumn<QString>("interface");
    QTest::addColumn<QString>("kidney");
    QTest::newRow("file") << "de"
                          << "left kidney";
    QTest::newRow("interface") << "de"
                               << "linke Niere";
    QTest::newRow("latin") << "de"
                           << "ren sinister";
    QTest::newRow("nb") << "en"
                        << "venstre nyre";
    QTest::newRow("en") << "de"
                        << "left kidney";
  }
  void structuresHaveALanguageOfTheirOwn() {
    QFETCH(QString, interface);
    QFETCH(QString, kidney);
    Spoken f;
    QVERIFY(f.drop(m_body.path()) && f.settled());
    const model::NodeId id = f.session.scene().named("left kidney").front();
    f.session.select({id});
    f.speak(interface);
    f.window.preferences().set(QStringLiteral("language/structures"),
                               QString::fromUtf8(QTest::currentDataTag()));
    QCOMPARE(f.tree().indexOf(id).data().toString(), kidney);
    QCOMPARE(f.control<QLabel>("gammaTitle").text(), kidney);
  }

  void systemsLanguageIsTaken_data() {
    QTest::addColumn<QString>("choice");
    QTest::addColumn<QLocale>("system");
    QTest::addColumn<QLocale>("locale");
    const QLocale swiss(QLocale::German, QLocale::Switzerland);
    const QLocale french(QLocale::French);
    QTest::newRow("system") << "system" << swiss << swiss;
    QTest::newRow("of the same language") << "de" << swiss << swiss;
    QTest::newRow("another") << "nl" << swiss << QLocale(QLocale::Dutch);
    QTest::newRow("unknown") << "system" << french << QLocale(QLocale::English);
    QTest::newRow("none") << "system" << QLocale::c() << QLocale::c();
  }
  void systemsLanguageIsTaken() {
    QFETCH(QString, choice);
    QFETCH(QLocale, system);
    QFETCH(QLocale, locale);
    QCOMPARE(widgets::localeOf(choice, system), locale);
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::LanguageTest)
#include "language_test.moc"
