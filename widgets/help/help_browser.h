// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTextBrowser>

namespace sline::widgets {

/// Shows the program's own pages and pictures and nothing else: it reads no file and uses no
/// network. Links that lead outside are passed on.
class HelpBrowser : public QTextBrowser {
  Q_OBJECT
 public:
  explicit HelpBrowser(QWidget* parent = nullptr);

  void showPage(const QString& id);
  /// Returns the id of the page that is shown.
  QString page() const;
  QVariant loadResource(int type, const QUrl& name) override;

 signals:
  void pageShown(const QString& id);
  void outsideWanted(const QUrl& address);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void follow(const QUrl& link);
  void dress();
  void fitPictures();

  int m_fittedWidth = 0;
};

}  // namespace sline::widgets
