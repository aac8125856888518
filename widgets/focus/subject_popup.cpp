// SPDX-License-Identifier: Apache-2.0
#include "widgets/focus/subject_popup.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QToolButton>
#include <algorithm>

#include "widgets/focus/role_texts.h"
#include "widgets/gamma/stage_previews.h"

namespace sline::widgets {

namespace {

constexpr QSize pictureSize(232, 174);  // pixels of the window
// Pictures are drawn twice as large and averaged, with lines as wide as in a print of that size.
constexpr int picturedTwice = 2;
constexpr double pictureLine = 0.7;

/// Returns a number for each popup, from which those of its pictures are made.
int nextRound() {
  static int rounds = 0;
  return rounds = (rounds + 1) % 1'000'000;
}

}  // namespace

SubjectPopup::SubjectPopup(Session& session, FocusContext& focus, Viewport& viewport)
    : QFrame(&viewport, Qt::Popup),
      m_session(session),
      m_focus(focus),
      m_viewport(viewport),
      m_waiting(new QLabel(tr("Working out other plates…"))),
      m_round(nextRound()) {
  setObjectName(QStringLiteral("subjectPopup"));
  setAccessibleName(tr("Other subjects"));
  setAttribute(Qt::WA_DeleteOnClose);
  setFrameShape(QFrame::StyledPanel);
  auto* layout = new QHBoxLayout(this);
  m_waiting->setMargin(12);
  layout->addWidget(m_waiting);
  for (std::size_t i = 0; i < choices; ++i) {
    auto* button = new QToolButton;
    button->setObjectName(QStringLiteral("subject%1").arg(i));
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIconSize(pictureSize);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
    button->hide();
    connect(button, &QToolButton::clicked, this, [this, i] { choose(i); });
    layout->addWidget(button);
    m_choices[i].button = button;
  }
  connect(&focus, &FocusContext::subjectOffered, this, &SubjectPopup::offer);
  connect(&viewport, &Viewport::previewed, this, &SubjectPopup::took);
}

SubjectPopup::~SubjectPopup() {
  m_viewport.askPreviews({.previews = {}, .asker = PreviewsOf::subjects});
}

float SubjectPopup::aspect() const {
  return float(m_viewport.width()) / float(std::max(m_viewport.height(), 1));
}

void SubjectPopup::open() {
  adjustSize();
  move(m_viewport.mapToGlobal(m_viewport.rect().center()) - rect().center());
  show();
  m_focus.offerSubjects(float(pictureSize.width()) / float(pictureSize.height()), choices);
}

void SubjectPopup::offer(std::size_t subject,
                         const std::shared_ptr<const model::OpeningLook>& look) {
  if (m_offered >= choices)
    return;
  m_waiting->hide();
  Choice& choice = m_choices[m_offered];
  choice.subject = subject;
  choice.look = look;
  const QString text = subjectText(m_session, look->subject.title);
  choice.button->setText(text);
  choice.button->setAccessibleName(text);
  QPixmap blank(pictureSize);
  blank.fill(Qt::white);
  choice.button->setIcon(blank);
  choice.button->show();
  if (++m_offered == 1)
    choice.button->setFocus();
  adjustSize();
  move(m_viewport.mapToGlobal(m_viewport.rect().center()) - rect().center());
  askPictures();
}

void SubjectPopup::askPictures() {
  PreviewRequest request{.previews = {}, .asker = PreviewsOf::subjects};
  const double ratio = devicePixelRatioF() * double(picturedTwice);
  const QSize size = pictureSize * ratio;
  for (std::size_t i = 0; i < m_offered; ++i) {
    const Choice& choice = m_choices[i];
    if (!choice.drawn)
      request.previews.push_back(
          {.id = m_round * int(choices) + int(i),
           .scene =
               withSmallLines(choice.look->scene, smallLines(size.height(), ratio, pictureLine)),
           .camera = choice.look->camera,
           .settings = {.width = size.width(),
                        .height = size.height(),
                        .environment = m_viewport.environment()},
           .samples = picturedTwice});
  }
  m_viewport.askPreviews(std::move(request));
}

void SubjectPopup::took(PreviewsOf asker, int id, const QImage& image) {
  if (asker != PreviewsOf::subjects || id / int(choices) != m_round)
    return;
  Choice& choice = m_choices[std::size_t(id % int(choices))];
  choice.drawn = true;
  choice.button->setIcon(QPixmap::fromImage(image));
}

void SubjectPopup::choose(std::size_t index) {
  m_focus.chooseLook(aspect(), m_choices[index].subject);
  close();
}

void SubjectPopup::step(int by) {
  if (m_offered == 0)
    return;
  int now = 0;
  for (std::size_t i = 0; i < m_offered; ++i)
    if (m_choices[i].button->hasFocus())
      now = int(i);
  const int next = std::clamp(now + by, 0, int(m_offered) - 1);
  m_choices[std::size_t(next)].button->setFocus(Qt::TabFocusReason);
}

void SubjectPopup::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Escape:
      close();
      return;
    case Qt::Key_Left:
      step(-1);
      return;
    case Qt::Key_Right:
      step(1);
      return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      for (std::size_t i = 0; i < m_offered; ++i)
        if (m_choices[i].button->hasFocus())
          return choose(i);
      return;
    default:
      QFrame::keyPressEvent(event);
  }
}

}  // namespace sline::widgets

#include "moc_subject_popup.cpp"
