// SPDX-License-Identifier: Apache-2.0
// Shows help in a window of its own: contents and search on the left, the page on the right.
#pragma once

#include <QWidget>

class QLineEdit;
class QListWidget;

namespace sline::widgets {

class HelpBrowser;

class HelpWindow : public QWidget {
  Q_OBJECT
 public:
  explicit HelpWindow(QWidget* parent = nullptr);
  void showPage(const QString& id);

 private:
  QWidget* makeContents();
  QWidget* makeBar();
  void list();
  void mark(const QString& id);
  /// Moves to where the page has the first of the words that are searched for.
  void findWords();
  void askBeforeLeaving(const QUrl& address);

  QLineEdit* m_search;
  QListWidget* m_contents;
  HelpBrowser* m_page;
};

}  // namespace sline::widgets
