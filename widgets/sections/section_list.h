// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>

#include "widgets/session/session.h"

namespace sline::widgets {

/// Lists the scene's sections as rows: a tick for those that cut, name, position and what is cut.
class SectionList : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { name, position, scope, columnCount_ };
  explicit SectionList(Session& session, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

  const model::Section* at(int row) const;
  /// Returns the section's row, or −1 where there is none.
  int rowOf(std::optional<model::SectionId> id) const;

 private:
  void documentChange(const Document& before, const Document& now);

  Session& m_session;
};

}  // namespace sline::widgets
