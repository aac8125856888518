// SPDX-License-Identifier: Apache-2.0
// Holds the user's lasting settings: a table of rows, read and written through one object that says
// when a value changes. The dialog is made from the same table.
#pragma once

#include <QObject>
#include <QString>
#include <QVariant>
#include <vector>

#include "widgets/form/field.h"

class QSettings;

namespace sline::widgets {

/// A row of the table; its field's id is its key in the settings file: "picture/background".
struct PreferenceRow {
  Field field;
  QString page;
  QVariant standard;
};

/// Returns the rows in the order in which the dialog shows them; rows of one page follow each
/// other.
std::vector<PreferenceRow> preferenceRows();
/// Returns the row's field. Asserts that the table has the row.
Field preferenceField(const QString& id);

class Preferences : public QObject {
  Q_OBJECT
 public:
  /// Reads and writes the settings, which must outlive it.
  explicit Preferences(QSettings& settings, QObject* parent = nullptr);

  /// Returns the value, or the standard where none, or none that is allowed, was set. Asserts that
  /// the table has the row and that it is of that kind.
  bool isOn(const QString& id) const;
  QString choice(const QString& id) const;
  int number(const QString& id) const;
  QVariant value(const QString& id) const;

  /// Sets the value; returns false if it is unchanged or not allowed.
  bool set(const QString& id, const QVariant& value);
  /// Removes the values of all rows from the settings.
  void restoreStandards();

 signals:
  void changed(const QString& id);

 private:
  QSettings& m_settings;
};

}  // namespace sline::widgets
