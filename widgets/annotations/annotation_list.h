// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>

#include "widgets/annotations/label_sights.h"
#include "widgets/session/session.h"

namespace sline::widgets {

/// Lists the scene's annotations as rows: a tick for what is shown beside its number, its words,
/// its kind and what it points at.
class AnnotationList : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { number, text, kind, place, columnCount_ };
  explicit AnnotationList(Session& session, QObject* parent = nullptr);

  /// Returns the language in which texts are shown and typed; empty for the scene's own.
  const std::string& language() const { return m_language; }
  void setLanguage(const std::string& tag);
  /// Greys the labels that the picture lacks; their tips say why.
  void setSights(LabelSightsById sights);
  /// Returns what the picture says about the label: empty where it stands there as usual.
  QString sightOf(const model::Annotation& annotation) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

  const model::Annotation* at(int row) const;
  /// Returns the annotation's row, or −1 where there is none.
  int rowOf(std::optional<model::AnnotationId> id) const;

 private:
  void documentChange(const Document& before, const Document& now);
  void allChanged();
  /// Returns the number that the annotation has in pictures, counted from 1 among the visible ones.
  int numberOf(int row) const;

  Session& m_session;
  std::string m_language;
  LabelSightsById m_sights;
};

}  // namespace sline::widgets
