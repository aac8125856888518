// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QHash>
#include <QStyledItemDelegate>

namespace sline::widgets {

/// Paints the name, the eye, the swatch, the inline Γ slider and the lock; the view handles the
/// mouse on them.
class StructureDelegate : public QStyledItemDelegate {
  Q_OBJECT
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  /// Looks names up again: some have changed, come or gone.
  void forgetNames();

 private:
  /// Returns the name as it is shown in a row of that look.
  QString nameIn(const QStyleOptionViewItem& look, const QModelIndex& index) const;

  /// The names in a group, from which each must be told; by the group's id.
  mutable QHash<quintptr, QStringList> m_together;
  struct Shown {
    QString name;
    int width = 0;  ///< pixels
    QString text;
  };
  mutable QHash<quintptr, Shown> m_shown;  ///< what was shortened, by the row's id
};

}  // namespace sline::widgets
