// SPDX-License-Identifier: Apache-2.0
// What a person sets once and for all: a table of rows, read and written through one object that
// says when a value changes. The dialog is made from the same table.
#pragma once

#include <QObject>
#include <QString>
#include <QVariant>
#include <vector>

#include "widgets/form/field.h"

class QSettings;

namespace sline::widgets {

/// The field's id is its key in the settings file: "picture/background".
struct PreferenceRow {
  Field field;
  QString page;
  QVariant standard;
};

/// In the order in which the dialog shows them; rows of one page follow each other.
std::vector<PreferenceRow> preferenceRows();
/// Returns the row's field. Asserts that the table has the row.
Field preferenceField(const QString& id);

class Preferences : public QObject {
  Q_OBJECT
 public:
  /// The settings must outlive it.
  explicit Preferences(QSettings& settings, QObject* parent = nullptr);

  /// The standard where nothing, or nothing that is allowed, was set. Asserts that the table has
  /// the row and that it is of that kind.
  bool isOn(const QString& id) const;
  QString choice(const QString& id) const;
  int number(const QString& id) const;
  QVariant value(const QString& id) const;

  /// False where it is so already, or is not allowed.
  bool set(const QString& id, const QVariant& value);
  /// Forgets all that the table has.
  void restoreStandards();

 signals:
  void changed(const QString& id);

 private:
  QSettings& m_settings;
};

}  // namespace sline::widgets
