// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

#include "model/base/result.h"

class QAction;
class QLabel;
class QPushButton;
class QToolButton;

namespace sline::widgets {

/// Shows a line above the picture, and never over it, that says what went wrong, or what was left
/// out, and stays until it is closed or is so no longer; the program does not wait for it.
class MessageBar : public QFrame {
  Q_OBJECT
 public:
  explicit MessageBar(QWidget* parent = nullptr);
  void showError(const Error& error);
  /// Shows the first remark on what is open, and the others on demand.
  void showRemarks(const QStringList& remarks);
  /// Adds a button for what can be done about the current message; it disappears with the message.
  void offer(QAction& action);
  /// Adds a second button likewise.
  void offerOther(QAction& action);
  /// Shows a notice that stays until it is closed or `hideNotice` is called; the button runs the
  /// action.
  void showNotice(const QString& heading, const QString& body, QAction& action);
  /// Reports a success; each action is a button, at most two of them. Where there are remarks the
  /// first takes the body's place, and the others are shown on demand.
  void showDone(const QString& heading, const QString& body, const QList<QAction*>& actions,
                const QStringList& remarks = {});
  /// Hides a notice; other messages stay.
  void hideNotice();
  /// Hides the error, where that is what is shown: it is so no longer.
  void hideError(const Error& error);
  /// Hides a reported success, with remarks or without; other messages stay.
  void hideDone();
  /// Hides remarks on what is open; other messages stay.
  void hideRemarks();
  QString text() const;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  enum class Kind { error, remark, notice, done, doneInPart };
  void display(Kind kind, const QString& heading, const QString& body);
  void dress();
  void offerOn(QPushButton& button, QAction& action);
  void showDetails();
  void displayError();
  void nameControls();

  Kind m_kind = Kind::remark;
  QLabel* m_text;
  QPushButton* m_details;
  QToolButton* m_close;
  QPushButton* m_remedy;
  QPushButton* m_other;  ///< a second thing that can be done
  QStringList m_remarks;
  Error m_error;  ///< the last one that was shown
};

}  // namespace sline::widgets
