// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractListModel>
#include <QImage>
#include <vector>

#include "widgets/session/session.h"

namespace sline::widgets {

class ViewTour;

/// Returns the name of a view on screen: plain text on one line, shortened to a readable length.
QString shownName(const model::View& view);
/// Returns its title in the language in the same way.
QString shownTitle(const model::View& view, const std::string& language);

/// Lists the scene's views as rows, in the tour's order, each with its small picture
/// (`Qt::DecorationRole`) and how much of what it refers to is gone (`absentRole`). Names and
/// places change through the tour.
class ViewList : public QAbstractListModel {
  Q_OBJECT
 public:
  static constexpr int absentRole = Qt::UserRole;
  ViewList(Session& session, ViewTour& tour, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
  QStringList mimeTypes() const override;
  QMimeData* mimeData(const QModelIndexList& indexes) const override;
  bool moveRows(const QModelIndex& from, int row, int count, const QModelIndex& to,
                int before) override;

  const QImage& picture(int row) const { return m_cards[std::size_t(row)].picture; }
  void setPicture(int row, const QImage& picture);

 private:
  struct Card {
    model::View view;
    QImage picture;  ///< may be out of date
    std::size_t absent = 0;
  };
  void documentChange(const Document& before, const Document& now);
  void follow(std::vector<Card> cards);
  std::vector<Card> cardsNow(bool another) const;
  bool moveAlone(const std::vector<Card>& cards);

  Session& m_session;
  ViewTour& m_tour;
  std::vector<Card> m_cards;
};

}  // namespace sline::widgets
