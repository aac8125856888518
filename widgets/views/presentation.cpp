// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/presentation.h"

#include <QDockWidget>
#include <QGuiApplication>
#include <QLocale>
#include <QMainWindow>
#include <QMenuBar>
#include <QScreen>
#include <QStatusBar>
#include <QToolBar>
#include <QWindow>
#include <algorithm>
#include <array>

#include "model/edit/views.h"
#include "model/edit/visibility.h"
#include "model/scene/label_words.h"
#include "widgets/annotations/in_picture/presented_letters.h"
#include "widgets/views/presentation_board.h"
#include "widgets/views/presented_links.h"
#include "widgets/views/presented_quiz.h"
#include "widgets/views/presenter_window.h"
#include "widgets/views/view_caption.h"
#include "widgets/views/view_list.h"

namespace sline::widgets {

namespace {

constexpr int presentedMargin = 24;  // pixels

}  // namespace

Presentation::Presentation(QMainWindow& window, Session& session, Viewport& viewport,
                           QObject* parent)
    : QObject(parent),
      m_window(window),
      m_session(session),
      m_viewport(viewport),
      m_name(new QLabel(&viewport)),
      m_caption(new ViewCaption(viewport)),
      m_links(new PresentedLinks(session, viewport)),
      m_board(new PresentationBoard(viewport)),
      m_quiz(new PresentedQuiz(session, viewport, this)) {
  m_name->setObjectName(QStringLiteral("presentedView"));
  m_name->setTextFormat(Qt::PlainText);
  m_name->setWordWrap(true);
  m_name->setIndent(0);
  m_name->setAttribute(Qt::WA_TransparentForMouseEvents);
  m_name->hide();
  m_caption->setObjectName(QStringLiteral("presentedText"));
  connect(&session, &Session::documentChanged, this, &Presentation::documentChange);
  connect(m_quiz, &PresentedQuiz::changed, this, &Presentation::quizChange);
  connect(&viewport, &Viewport::previewed, this, &Presentation::took);
  connect(&viewport, &Viewport::pictureShown, this, &Presentation::placeLinks);
  connect(&viewport, &Viewport::pictureShown, this, &Presentation::beginQuiz);
  connect(&viewport.labels(), &PictureLabels::sighted, this, &Presentation::beginQuiz);
  window.installEventFilter(this);
  viewport.installEventFilter(this);
}

Presentation::~Presentation() {
  // It goes with its window, which is to be restored no more.
  delete m_name;
  delete m_caption;
  delete m_links;
  delete m_board;
  delete m_presenter;
}

void Presentation::showBars(bool shown) {
  m_window.menuBar()->setVisible(shown);
  m_window.statusBar()->setVisible(shown);
  if (shown)
    return;
  for (QDockWidget* dock : m_window.findChildren<QDockWidget*>())
    dock->hide();
  for (QToolBar* tools : m_window.findChildren<QToolBar*>(Qt::FindDirectChildrenOnly))
    tools->hide();
}

void Presentation::begin(int index) {
  if (running() || count() == 0)
    return;
  m_session.cancelPreview();
  m_before = Before{.docks = m_window.saveState(),
                    .states = m_window.windowState(),
                    .place = m_window.geometry(),
                    .focus = m_window.focusWidget(),
                    .marks = m_viewport.marks(),
                    .camera = m_viewport.camera(),
                    .pivot = m_viewport.pivot(),
                    .section = m_session.activeSection(),
                    .opening = m_session.document().opening};
  m_session.activateSection(std::nullopt);  // its handles would be in the picture
  m_viewport.chooseMarks({.cube = false, .scaleBar = false, .frameTime = false});
  m_number = -1;
  m_revealing = false;
  showBars(false);
  fillScreens();
  m_viewport.setFocus();
  m_board->clear();
  m_board->show();
  show(std::clamp(index, 0, count() - 1), all);
}

/// Fills the screen or, where there are two, one with the picture and one with the notes.
void Presentation::fillScreens() {
  const QList<QScreen*> screens = QGuiApplication::screens();
  QList<QRect> areas;
  for (const QScreen* screen : screens)
    areas << screen->geometry();
  const PresentationPlaces places = presentationPlaces(areas, m_window.geometry().center());
  if (places.presenter) {
    if (QWindow* handle = m_window.windowHandle())
      handle->setScreen(screens[places.picture]);
    m_window.setGeometry(areas[places.picture]);
  }
  m_window.showFullScreen();
  if (!m_presenter) {
    m_presenter = new PresenterWindow(&m_window);
    connect(m_presenter, &PresenterWindow::followed, this, &Presentation::follow);
  }
  m_presenter->startClock();
  m_notesScreen = places.presenter ? std::optional(areas[*places.presenter]) : std::nullopt;
  if (m_notesScreen)
    openNotes();
}

/// Opens the presenter's window on its screen, else over the lower right part of the picture's.
void Presentation::openNotes() {
  if (m_notesScreen)
    return m_presenter->open(*m_notesScreen, true);
  const QRect whole = m_window.screen()->geometry();
  QRect place(QPoint(), whole.size() * 2 / 5);
  place.moveBottomRight(whole.bottomRight() - QPoint(presentedMargin, presentedMargin));
  m_presenter->open(place, false);
}

void Presentation::end() {
  if (!running())
    return;
  const Before before = *m_before;
  m_before.reset();
  m_quizAwaited = false;
  m_quiz->end();
  m_lit.reset();
  m_viewport.light(std::nullopt);
  m_links->clear();
  laser(std::nullopt);
  m_board->clear();
  m_board->hide();
  m_name->hide();
  m_caption->say({}, ViewCaption::Place::corner);
  if (m_presenter)
    m_presenter->hide();
  m_viewport.setPresented(false);
  m_viewport.showInstead(std::nullopt);
  m_viewport.setCamera(before.camera);
  m_viewport.setPivot(before.pivot);
  m_viewport.chooseMarks(before.marks);
  if (m_session.document().opening == before.opening)
    m_session.activateSection(before.section);
  // A window that fills its screen again must first be back on it.
  if (!m_window.screen()->geometry().contains(before.place.center()))
    m_window.setGeometry(before.place);
  m_window.setWindowState(before.states);
  if (!(before.states & (Qt::WindowMaximized | Qt::WindowFullScreen)))
    m_window.setGeometry(before.place);
  showBars(true);
  m_window.restoreState(before.docks);
  if (before.focus)
    before.focus->setFocus();
}

std::string Presentation::language() const {
  return model::firstLanguage(m_viewport.labels().style().language);
}

std::size_t Presentation::labelCount() const {
  const model::Scene scene = model::withViewApplied(m_session.scene(), view(m_at)).scene;
  return std::size_t(std::count_if(scene.annotations().begin(), scene.annotations().end(),
                                   [](const model::Annotation& each) { return each.visible; }));
}

model::Scene Presentation::seen(std::size_t labels) const {
  model::Scene scene = model::withViewApplied(m_session.scene(), view(m_at)).scene;
  if (m_lit && model::visibilityOf(scene, *m_lit) == model::Visibility::none)
    scene = model::withShown(scene, std::array{*m_lit}).scene;
  if (labels == all)
    return scene;
  std::vector<model::Annotation> annotations = scene.annotations();
  for (model::Annotation& each : annotations)
    if (each.visible && labels > 0)
      --labels;
    else
      each.visible = false;
  scene.setAnnotations(std::move(annotations));
  return scene;
}

void Presentation::show(int index, std::size_t labels) {
  m_at = std::clamp(index, 0, count() - 1);
  m_revealed = labels;
  m_quizAwaited = false;
  m_lit.reset();
  m_viewport.light(std::nullopt);
  m_board->wipe();
  say();
  const model::Scene before = m_viewport.shownScene();
  model::Scene after = seen(labels);
  m_viewport.travelTo(view(m_at).camera, before, after);
  m_viewport.showInstead(std::move(after));
  tellPresenter();
}

/// Says the view's title and text, or what the quiz says.
void Presentation::say() {
  if (m_quiz->running()) {
    m_name->setText(m_quiz->text());
  } else {
    m_name->setText(tr("%1 / %2   %3", "number of the view, of so many, its name")
                        .arg(QLocale().toString(m_at + 1), QLocale().toString(count()),
                             shownTitle(view(m_at), language())));
  }
  place();
}

/// Places the title in the corner, because the middle has the letter of the side that is below, and
/// the text above it.
void Presentation::place() {
  constexpr int least = 16;  // pixels
  constexpr int sides = 16;
  const int letters = std::max(least, m_viewport.height() / presentedLines);
  m_name->setStyleSheet(QStringLiteral("QLabel { color: #f4f4f2; background: rgba(28, 30, 34, 190);"
                                       " border-radius: 6px; padding: 6px %1px;"
                                       " font-size: %2px; }")
                            .arg(sides)
                            .arg(letters));
  m_name->ensurePolished();
  const int room = m_viewport.width() / 2 - 2 * presentedMargin - 2 * letters;
  const int words = m_name->fontMetrics().horizontalAdvance(m_name->text());
  const int width = std::min(words + 2 * sides + 2, room);
  const int height =
      std::min(m_name->heightForWidth(width), m_viewport.height() - 2 * presentedMargin);
  m_name->setGeometry(presentedMargin, m_viewport.height() - height - presentedMargin, width,
                      height);
  m_name->show();
  m_name->raise();
  m_viewport.setPresented(true, m_name->geometry());  // letters of the text are as large as labels'
  // The text might tell what the quiz asks for.
  m_caption->say(m_quiz->running() ? std::string() : view(m_at).words.text.in(language()),
                 ViewCaption::Place::corner, height + presentedMargin);
  if (m_caption->isVisible())
    m_viewport.setPresented(true, m_name->geometry().united(m_caption->geometry()));
  placeLinks();
  m_board->setGeometry(m_viewport.rect());
  m_board->raise();
}

/// Marks the links of the text and, in the picture that is shown, of callouts.
void Presentation::placeLinks() {
  if (!running())
    return;
  std::vector<render::LinkPlace> places = m_caption->links();
  if (const LabelSheet* sheet = m_viewport.labels().layer().sheet(); sheet && !m_quiz->running())
    for (render::LinkPlace& place : render::linkPlaces(sheet->plate))
      places.push_back(std::move(place));
  m_links->take(places, m_viewport.labels().wish().pixelsPerMm);
  m_board->raise();
}

void Presentation::lightUp(std::optional<model::NodeId> id) {
  m_lit = id == m_lit ? std::nullopt : id;
  m_viewport.light(m_lit);
  m_viewport.showInstead(seen(m_revealed));
}

void Presentation::follow(const model::LinkTarget& target) {
  if (!running() || m_quiz->running())
    return;
  if (const auto* structure = std::get_if<model::NodeId>(&target))
    lightUp(*structure);
  else if (std::get<std::size_t>(target) < std::size_t(count()))
    show(int(std::get<std::size_t>(target)), m_revealing ? 0 : all);
}

std::vector<PresenterWindow::Note> Presentation::notes(const std::string& tag) {
  std::vector<PresenterWindow::Note> notes;
  for (const model::MarkedRun& run : model::linkedRuns(view(m_at).words.notes.in(tag)))
    notes.push_back({.text = QString::fromStdString(run.text),
                     .target = run.link ? followed(*run.link, m_session) : std::nullopt});
  return notes;
}

/// Tells the presenter's window of the view, and asks for a picture of the next one.
void Presentation::tellPresenter() {
  if (!m_presenter)
    return;
  const std::string tag = language();
  const bool more = m_at + 1 < count();
  m_presenter->tell({.place = tr("%1 / %2", "number of the view, of so many")
                                  .arg(QLocale().toString(m_at + 1), QLocale().toString(count())),
                     .title = shownTitle(view(m_at), tag),
                     .notes = notes(tag),
                     .next = more ? shownTitle(view(m_at + 1), tag) : QString()});
  PreviewRequest request{.previews = {}, .asker = PreviewsOf::presented};
  if (more && m_presenter->isVisible()) {
    const QSize size = m_presenter->pictureSize();
    request.previews.push_back(
        {.id = m_at,
         .scene = model::withViewApplied(m_session.scene(), view(m_at + 1)).scene,
         .camera = view(m_at + 1).camera,
         .settings = {.width = size.width(),
                      .height = size.height(),
                      .environment = m_viewport.environment()}});
  }
  m_viewport.askPreviews(std::move(request));
}

void Presentation::took(PreviewsOf asker, int id, const QImage& image) {
  if (running() && m_presenter && asker == PreviewsOf::presented && id == m_at)
    m_presenter->setNextPicture(image);
}

void Presentation::documentChange() {
  if (!running())
    return;
  // A scene may have come in from the background.
  if (m_session.document().opening != m_before->opening || m_session.scene().views().empty()) {
    end();
    return;
  }
  m_quiz->end();
  show(m_at, m_revealed);
}

}  // namespace sline::widgets

#include "moc_presentation.cpp"
