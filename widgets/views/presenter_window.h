// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QList>
#include <QRect>
#include <QTimer>
#include <QWidget>
#include <optional>
#include <vector>

#include "model/scene/link_target.h"

class QLabel;
class QPlainTextEdit;

namespace sline::widgets {

/// Tells who presents what to say now and what comes next: title and notes of the view, the next
/// view as a small picture, the time of day and how long the presentation has taken. On a second
/// screen it fills that, else it is a window in front.
class PresenterWindow : public QWidget {
  Q_OBJECT
 public:
  explicit PresenterWindow(QWidget* parent);

  /// Holds a piece of the notes, and where it leads if it is a link.
  struct Note {
    QString text;
    std::optional<model::LinkTarget> target;
    bool operator==(const Note&) const = default;
  };
  struct Told {
    QString place;  ///< "2 / 9"
    QString title;
    std::vector<Note> notes;
    QString next;  ///< the next view's title; empty after the last
  };
  void tell(const Told& told);
  void setNextPicture(const QImage& picture);
  /// Returns how large the picture of the next view should be, in screen pixels.
  QSize pictureSize() const;
  /// Begins to count the presentation's time.
  void startClock();
  /// Shows the window: on a screen of its own it fills `place`, else it stands there in front.
  void open(const QRect& place, bool ownScreen);

 signals:
  /// Tells that a link of the notes was clicked.
  void followed(const sline::model::LinkTarget& target);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showNotes(const std::vector<Note>& notes);
  void showTime();
  void setLetters();

  QLabel* m_place;
  QLabel* m_title;
  QPlainTextEdit* m_notes;
  QLabel* m_nextTitle;
  QLabel* m_nextPicture;
  QLabel* m_clock;
  std::vector<Note> m_told;
  QElapsedTimer m_elapsed;
  QTimer m_tick;
};

/// Says where a presentation goes on these screens.
struct PresentationPlaces {
  int picture = 0;               ///< the screen of the picture
  std::optional<int> presenter;  ///< that of the presenter's window; none on one screen
};
/// Returns the places for a window whose middle is there: where there is another screen, the
/// picture fills it, as a projector does, and the presenter keeps the window's own.
PresentationPlaces presentationPlaces(const QList<QRect>& screens, const QPoint& window);

}  // namespace sline::widgets
