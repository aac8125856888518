// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/view_list.h"

#include <QLocale>
#include <QMimeData>
#include <algorithm>

#include "model/edit/views.h"
#include "widgets/views/view_tour.h"

namespace sline::widgets {

namespace {
constexpr const char* mimeType = "application/x-sline-view";
constexpr qsizetype longestName = 200;

QString oneLine(const std::string& text) {
  // Line breaks and marks that reverse the writing direction would affect more than the name.
  QString name = QString::fromStdString(text).left(longestName);
  constexpr char16_t nonJoiner = 0x200c;  // spelling in Persian, and the joiner next to it
  constexpr char16_t joiner = 0x200d;
  for (QChar& each : name)
    if (!each.isSurrogate() && !each.isPrint() && each != nonJoiner && each != joiner)
      each = QLatin1Char(' ');
  return name.simplified();
}

}  // namespace

QString shownName(const model::View& view) {
  return oneLine(view.name);
}

QString shownTitle(const model::View& view, const std::string& language) {
  return oneLine(model::titleIn(view, language));
}

ViewList::ViewList(Session& session, ViewTour& tour, QObject* parent)
    : QAbstractListModel(parent), m_session(session), m_tour(tour) {
  connect(&session, &Session::documentChanged, this, &ViewList::documentChange);
  m_cards = cardsNow(true);
}

/// Returns the cards with the pictures of their views: each picture goes to the view that is
/// unchanged, else to one of the same name, else to one with the same camera.
std::vector<ViewList::Card> ViewList::cardsNow(bool another) const {
  const std::vector<model::View>& views = m_session.scene().views();
  std::vector<Card> cards;
  std::vector<bool> taken(m_cards.size(), another);
  const auto take = [&](Card& card, const auto& fits) {
    for (std::size_t i = 0; card.picture.isNull() && i < m_cards.size(); ++i)
      if (!taken[i] && fits(m_cards[i].view)) {
        card.picture = m_cards[i].picture;
        taken[i] = true;
      }
  };
  for (const model::View& view : views) {
    cards.push_back({.view = view, .absent = model::absentFrom(m_session.scene(), view)});
    take(cards.back(), [&view](const model::View& each) { return each == view; });
  }
  for (Card& card : cards)
    take(card, [&card](const model::View& each) { return each.name == card.view.name; });
  for (Card& card : cards)
    take(card, [&card](const model::View& each) { return each.camera == card.view.camera; });
  return cards;
}

void ViewList::documentChange(const Document& before, const Document& now) {
  const bool another = before.opening != now.opening;
  const auto sameIds = [](const auto& a, const auto& b) { return a.id == b.id; };
  const bool sameNodes =
      std::equal(before.scene.nodes().begin(), before.scene.nodes().end(),
                 now.scene.nodes().begin(), now.scene.nodes().end(), sameIds) &&
      std::equal(before.scene.annotations().begin(), before.scene.annotations().end(),
                 now.scene.annotations().begin(), now.scene.annotations().end(), sameIds);
  if (another || !sameNodes || before.scene.views() != now.scene.views())
    follow(cardsNow(another));
}

/// Announces the change as a move of one row, so that attached views keep their place.
bool ViewList::moveAlone(const std::vector<Card>& cards) {
  const auto same = [](const Card& a, const Card& b) { return a.view == b.view; };
  const auto size = int(cards.size());
  int first = 0;
  int last = size - 1;
  while (first < size && same(m_cards[std::size_t(first)], cards[std::size_t(first)]))
    ++first;
  while (last > first && same(m_cards[std::size_t(last)], cards[std::size_t(last)]))
    --last;
  if (first >= last)
    return false;
  for (const bool forth : {true, false}) {
    std::vector<Card> moved = m_cards;
    const auto at = moved.begin();
    if (forth)
      std::rotate(at + first, at + first + 1, at + last + 1);
    else
      std::rotate(at + first, at + last, at + last + 1);
    if (!std::equal(moved.begin(), moved.end(), cards.begin(), same))
      continue;
    beginMoveRows({}, forth ? first : last, forth ? first : last, {}, forth ? last + 1 : first);
    m_cards = cards;
    endMoveRows();
    return true;
  }
  return false;
}

void ViewList::follow(std::vector<Card> cards) {
  const auto size = int(m_cards.size());
  const auto now = int(cards.size());
  int same = 0;
  while (same < std::min(size, now) &&
         m_cards[std::size_t(same)].view == cards[std::size_t(same)].view)
    ++same;
  if (now == size + 1) {
    beginInsertRows({}, same, same);
    m_cards = std::move(cards);
    endInsertRows();
  } else if (now == size - 1) {
    beginRemoveRows({}, same, same);
    m_cards = std::move(cards);
    endRemoveRows();
  } else if (now != size) {
    beginResetModel();
    m_cards = std::move(cards);
    endResetModel();
    return;
  } else if (!moveAlone(cards)) {
    m_cards = std::move(cards);
  }
  if (now > 0)
    emit dataChanged(index(0), index(now - 1));
}

int ViewList::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(m_cards.size());
}

QVariant ViewList::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount())
    return {};
  const Card& card = m_cards[std::size_t(index.row())];
  const QString name = shownName(card.view);
  const QString gone = tr("%n of the structures and labels it shows are no longer in the scene",
                          nullptr, int(card.absent));
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return name;
    case Qt::ToolTipRole: {
      const QString text = QStringLiteral("%1. %2").arg(QLocale().toString(index.row() + 1), name);
      const QString html = QStringLiteral("<p>%1</p>").arg(text.toHtmlEscaped());
      return card.absent == 0 ? html : html + QStringLiteral("<p>%1</p>").arg(gone.toHtmlEscaped());
    }
    case Qt::AccessibleDescriptionRole:
      return card.absent == 0 ? QString() : gone;
    case Qt::DecorationRole:
      return card.picture;
    case absentRole:
      return qulonglong(card.absent);
    default:
      return {};
  }
}

Qt::ItemFlags ViewList::flags(const QModelIndex& index) const {
  // Items can be dropped between cards, not on one.
  if (!index.isValid())
    return Qt::ItemIsDropEnabled;
  return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemIsDragEnabled |
         Qt::ItemNeverHasChildren;
}

bool ViewList::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !index.isValid() || value.toString() == data(index, role).toString())
    return false;
  m_tour.rename(index.row(), value.toString());
  return true;
}

QStringList ViewList::mimeTypes() const {
  return {QLatin1String(mimeType)};
}

QMimeData* ViewList::mimeData(const QModelIndexList& indexes) const {
  auto* data = new QMimeData;
  data->setData(QLatin1String(mimeType),
                QByteArray::number(indexes.isEmpty() ? -1 : indexes.front().row()));
  return data;
}

bool ViewList::moveRows(const QModelIndex& from, int row, int count, const QModelIndex& to,
                        int before) {
  if (from.isValid() || to.isValid() || count != 1)
    return false;
  m_tour.move(row, before > row ? before - 1 : before);
  return true;
}

void ViewList::setPicture(int row, const QImage& picture) {
  if (row < 0 || row >= rowCount())
    return;
  m_cards[std::size_t(row)].picture = picture;
  emit dataChanged(index(row), index(row), {Qt::DecorationRole});
}

}  // namespace sline::widgets

#include "moc_view_list.cpp"
