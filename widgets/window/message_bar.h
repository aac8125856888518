// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

#include "model/base/result.h"

class QLabel;
class QPushButton;

namespace sline::widgets {

/// A line above the picture that says what went wrong, or what was left out, and stays until it is
/// closed; nothing waits for it.
class MessageBar : public QFrame {
  Q_OBJECT
 public:
  explicit MessageBar(QWidget* parent = nullptr);
  void showError(const Error& error);
  /// The first is shown, the others on demand.
  void showRemarks(const QStringList& remarks);
  QString text() const;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  enum class Kind { error, remark };
  void display(Kind kind, const QString& heading, const QString& body);
  void dress();
  void showDetails();

  Kind m_kind = Kind::remark;
  QLabel* m_text;
  QPushButton* m_details;
  QStringList m_remarks;
};

}  // namespace sline::widgets
