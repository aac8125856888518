// SPDX-License-Identifier: Apache-2.0
// Offers plates of what else the scene may be about, as small pictures to choose from.
#pragma once

#include <QFrame>
#include <QPointer>
#include <array>
#include <memory>

#include "model/look/opening_look.h"
#include "widgets/focus/focus_context.h"
#include "widgets/viewport/viewport.h"

class QLabel;
class QToolButton;

namespace sline::widgets {

/// Shows the next three subjects over the picture until one is chosen, with mouse or keyboard, or
/// something else is clicked. Deletes itself when closed.
class SubjectPopup : public QFrame {
  Q_OBJECT
 public:
  static constexpr std::size_t choices = 3;

  SubjectPopup(Session& session, FocusContext& focus, Viewport& viewport);
  ~SubjectPopup() override;
  /// Shows the popup in the middle of the picture and begins to work out the plates.
  void open();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Choice {
    QToolButton* button = nullptr;
    std::size_t subject = 0;
    std::shared_ptr<const model::OpeningLook> look;
    bool drawn = false;
  };
  void offer(std::size_t subject, const std::shared_ptr<const model::OpeningLook>& look);
  void askPictures();
  void took(PreviewsOf asker, int id, const QImage& image);
  void choose(std::size_t index);
  /// Moves the keyboard's focus by so many buttons.
  void step(int by);
  float aspect() const;

  Session& m_session;
  FocusContext& m_focus;
  Viewport& m_viewport;
  QLabel* m_waiting;
  std::array<Choice, choices> m_choices;
  std::size_t m_offered = 0;
  int m_round = 0;  ///< tells the pictures of this popup from those of one before
};

}  // namespace sline::widgets
