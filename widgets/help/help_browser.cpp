// SPDX-License-Identifier: Apache-2.0
#include "widgets/help/help_browser.h"

#include <QImage>
#include <QScrollBar>
#include <QTextTable>
#include <QTimer>
#include <algorithm>

#include "widgets/help/help_pages.h"

namespace sline::widgets {

namespace {

QString idOf(const QUrl& address) {
  return address.fileName().section(QLatin1Char('.'), 0, 0);
}

bool isPage(const QUrl& address) {
  const std::vector<QString> ids = helpPageIds();
  return address.path().endsWith(QLatin1String(".md")) &&
         std::find(ids.begin(), ids.end(), idOf(address)) != ids.end();
}

}  // namespace

HelpBrowser::HelpBrowser(QWidget* parent) : QTextBrowser(parent) {
  setOpenLinks(false);
  setFrameShape(NoFrame);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  document()->setDocumentMargin(22.0);
  connect(this, &QTextBrowser::anchorClicked, this, &HelpBrowser::follow);
  connect(this, &QTextBrowser::sourceChanged, this, [this](const QUrl& address) {
    dress();
    emit pageShown(idOf(address));
  });
}

void HelpBrowser::showPage(const QString& id) {
  setSource(QUrl(QStringLiteral("help:/%1.md").arg(id)), QTextDocument::MarkdownResource);
}

QString HelpBrowser::page() const {
  return idOf(source());
}

void HelpBrowser::follow(const QUrl& link) {
  const QUrl address = source().resolved(link);
  if (isPage(address))
    showPage(idOf(address));
  else if (!link.isRelative())
    emit outsideWanted(link);
}

QVariant HelpBrowser::loadResource(int type, const QUrl& name) {
  const QUrl address = source().resolved(name);
  if (address.scheme() != QLatin1String("help"))
    return {};
  if (type != QTextDocument::ImageResource)
    return isPage(address) ? helpText(idOf(address), QLocale()) : QVariant();
  QImage picture(QStringLiteral(":/help") + address.path());
  // The pictures are drawn for paper, as the pages are, and must be no wider than the page.
  const int room = std::max(100, viewport()->width() - 2 * int(document()->documentMargin()) - 4);
  if (picture.width() > room)
    picture = picture.scaledToWidth(room, Qt::SmoothTransformation);
  return picture;
}

void HelpBrowser::dress() {
  // Tables from Markdown come without lines and as narrow as they can be.
  for (QTextFrame* frame : document()->rootFrame()->childFrames()) {
    auto* table = qobject_cast<QTextTable*>(frame);
    if (!table)
      continue;
    QTextTableFormat format = table->format();
    format.setBorder(0.5);
    format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
    format.setBorderBrush(palette().mid());
    format.setBorderCollapse(true);
    format.setCellPadding(6.0);
    format.setCellSpacing(0.0);
    format.setTopMargin(6.0);
    format.setBottomMargin(10.0);
    table->setFormat(format);
  }
}

void HelpBrowser::resizeEvent(QResizeEvent* event) {
  QTextBrowser::resizeEvent(event);
  // Pictures have the width that was available when they were read. Fitting waits, because a page
  // that is being read must not start again.
  QTimer::singleShot(0, this, &HelpBrowser::fitPictures);
}

void HelpBrowser::fitPictures() {
  if (source().isEmpty() || m_fittedWidth == viewport()->width())
    return;
  m_fittedWidth = viewport()->width();
  const int place = verticalScrollBar()->value();
  reload();
  dress();
  verticalScrollBar()->setValue(place);
}

}  // namespace sline::widgets

#include "moc_help_browser.cpp"
