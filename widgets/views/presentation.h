// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QLabel>
#include <QObject>
#include <QPointer>
#include <QRect>
#include <limits>
#include <optional>

#include "model/scene/link_target.h"
#include "widgets/session/session.h"
#include "widgets/viewport/viewport.h"
#include "widgets/views/presentation_keys.h"
#include "widgets/views/presenter_window.h"

class QKeyEvent;
class QMainWindow;

namespace sline::widgets {

class PresentationBoard;
class PresentedLinks;
class PresentedQuiz;
class ViewCaption;

/// Shows the tour on the whole screen: the picture, the view's title and its text, nothing else.
/// Keys are those of other presentation programs (`presentation_keys.h`). Where there is another
/// screen, the picture fills that one and the presenter's window, with notes and clock, the
/// window's own. The mouse turns the scene, but nothing of the document can be changed; when the
/// presentation ends, the document, the window and the camera are as they were.
class Presentation : public QObject {
  Q_OBJECT
 public:
  Presentation(QMainWindow& window, Session& session, Viewport& viewport, QObject* parent);
  ~Presentation() override;

  /// Begins at that view; does nothing where there are no views.
  void begin(int index);
  void end();
  bool running() const { return m_before.has_value(); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// Holds the state of the window before the presentation.
  struct Before {
    QByteArray docks;
    Qt::WindowStates states;
    QRect place;
    QWidget* focus = nullptr;
    MarkChoice marks;
    model::Camera camera;
    glm::vec3 pivot{0.0f};
    std::optional<model::SectionId> section;
    int opening = 0;
  };
  /// Stands for all labels of a view, however many it has.
  static constexpr std::size_t all = std::numeric_limits<std::size_t>::max();

  void showBars(bool shown);
  void fillScreens();
  void openNotes();
  int count() const { return int(m_session.scene().views().size()); }
  const model::View& view(int index) const { return m_session.scene().views()[std::size_t(index)]; }
  std::string language() const;

  void show(int index, std::size_t labels);
  /// Returns the scene as the view at hand shows it, with its first labels.
  model::Scene seen(std::size_t labels) const;
  std::size_t labelCount() const;
  /// Lights the structure up, or no longer; one that the view hides is shown until then.
  void lightUp(std::optional<model::NodeId> id);
  void follow(const model::LinkTarget& target);
  void go(PresentationWish wish);
  void goOn();
  void goBack();
  void jump();
  void blank(bool black);
  void toggleReveal();
  void toggleQuiz();
  /// Begins the quiz that was asked for, once the picture of its view tells what one sees there.
  void beginQuiz();
  void quizChange();
  void key(const QKeyEvent& event);
  /// Tells whether the picture must not hear of the event.
  bool mouse(QEvent& event);
  /// Takes a click in the picture.
  void click(const QPointF& at);
  void laser(const std::optional<QPointF>& at);

  void say();
  void place();
  void placeLinks();
  void tellPresenter();
  std::vector<PresenterWindow::Note> notes(const std::string& tag);
  void took(PreviewsOf asker, int id, const QImage& image);
  void documentChange();

  QMainWindow& m_window;
  Session& m_session;
  Viewport& m_viewport;
  QPointer<QLabel> m_name;  ///< belongs to the viewport, as do the next three
  QPointer<ViewCaption> m_caption;
  QPointer<PresentedLinks> m_links;
  QPointer<PresentationBoard> m_board;
  QPointer<PresenterWindow> m_presenter;  ///< belongs to the window
  std::optional<QRect> m_notesScreen;     ///< the screen that it has for itself
  PresentedQuiz* m_quiz;
  std::optional<Before> m_before;
  int m_at = 0;
  int m_number = -1;             ///< that was typed to jump to; below 0 for none
  bool m_revealing = false;      ///< labels come one by one
  bool m_quizAwaited = false;    ///< was asked for
  std::size_t m_revealed = all;  ///< how many of the view's labels are shown
  std::optional<QPointF> m_pressed;
  std::optional<model::NodeId> m_lit;  ///< by a link
  bool m_hidden = false;               ///< the mouse's arrow, while there is a laser's dot
};

}  // namespace sline::widgets
