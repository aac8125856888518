// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/view_row.h"

#include <QKeyEvent>
#include <QPainter>
#include <QScrollBar>

#include "widgets/views/view_card.h"

namespace sline::widgets {

namespace {

/// Tells whether the key has another meaning here than in the window.
bool isOwnKey(const QKeyEvent& event) {
  switch (event.key()) {
    case Qt::Key_F2:
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Delete:
    case Qt::Key_Home:
    case Qt::Key_End:
      return event.modifiers() == Qt::NoModifier || event.modifiers() == Qt::KeypadModifier;
    case Qt::Key_Left:
    case Qt::Key_Right:
      return true;
    default:
      return false;
  }
}

}  // namespace

ViewRow::ViewRow(QWidget* parent) : QListView(parent) {
  setObjectName(QStringLiteral("viewRow"));
  setAccessibleName(tr("Saved views"));
  setItemDelegate(new ViewCard(this));
  setFlow(LeftToRight);
  setWrapping(false);
  setUniformItemSizes(true);
  setHorizontalScrollMode(ScrollPerPixel);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSelectionMode(SingleSelection);
  setEditTriggers(DoubleClicked | EditKeyPressed);
  setDragDropMode(InternalMove);
  setDefaultDropAction(Qt::MoveAction);
  setMouseTracking(true);
  setFrameShape(NoFrame);
  viewport()->setAutoFillBackground(false);
  connect(this, &QListView::clicked, this,
          [this](const QModelIndex& index) { emit goWanted(index.row()); });
}

std::vector<int> ViewRow::visibleRows() const {
  std::vector<int> rows;
  const int count = model() && isVisible() ? model()->rowCount() : 0;
  const QRect area = viewport()->rect();
  for (int row = 0; row < count; ++row)
    if (visualRect(model()->index(row, 0)).intersects(area))
      rows.push_back(row);
  return rows;
}

QSize ViewRow::sizeHint() const {
  const QSize card = ViewCard::cardSize(fontMetrics());
  return {4 * card.width(), card.height() + horizontalScrollBar()->sizeHint().height()};
}

QSize ViewRow::minimumSizeHint() const {
  return {ViewCard::cardSize(fontMetrics()).width(), sizeHint().height()};
}

bool ViewRow::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && currentIndex().isValid() &&
      isOwnKey(*static_cast<QKeyEvent*>(event))) {
    event->accept();
    return true;
  }
  const bool handled = QListView::event(event);
  if (event->type() == QEvent::Show || event->type() == QEvent::Hide ||
      event->type() == QEvent::LayoutRequest || event->type() == QEvent::ScreenChangeInternal)
    emit visibleRowsChanged();
  return handled;
}

void ViewRow::keyPressEvent(QKeyEvent* event) {
  const int row = currentIndex().row();
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  const bool side = event->key() == Qt::Key_Left || event->key() == Qt::Key_Right;
  if (row >= 0 && state() != EditingState) {
    if (enter)
      return emit goWanted(row);
    if (event->key() == Qt::Key_Delete)
      return emit removeWanted(row);
    if (side && event->modifiers().testFlag(Qt::AltModifier))
      return emit moveWanted(row, row + (event->key() == Qt::Key_Left ? -1 : 1));
  }
  QListView::keyPressEvent(event);
}

void ViewRow::resizeEvent(QResizeEvent* event) {
  QListView::resizeEvent(event);
  emit visibleRowsChanged();
}

void ViewRow::scrollContentsBy(int dx, int dy) {
  QListView::scrollContentsBy(dx, dy);
  emit visibleRowsChanged();
}

void ViewRow::paintEvent(QPaintEvent* event) {
  QListView::paintEvent(event);
  if (!model() || model()->rowCount() > 0)
    return;
  QPainter painter(viewport());
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(viewport()->rect().adjusted(8, 0, -8, 0), Qt::AlignCenter | Qt::TextWordWrap,
                   tr("A view keeps what you see: camera, what is shown, Γ, colours and sections"));
}

}  // namespace sline::widgets

#include "moc_view_row.cpp"
