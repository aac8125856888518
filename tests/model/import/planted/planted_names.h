// SPDX-License-Identifier: Apache-2.0
// Writes files of every kind in which a made-up name stands wherever a person's may: in the names
// of folders and files, in headers, comments, tags and tables, as names of structures and groups.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <map>
#include <vector>

namespace sline::test {

class Planting {
 public:
  /// Writes them below the folder.
  explicit Planting(const QString& top);

  /// Returns the folder that holds surfaces and volumes of all kinds.
  QString folder() const { return m_folder; }
  /// Returns everything that an import is to be given, the folder among it.
  const QStringList& inputs() const { return m_inputs; }
  /// Returns the places by the names that stand there, each in one place alone. Each has six
  /// letters and is part of no other.
  const std::map<QString, QString>& places() const { return m_places; }
  QStringList names() const;

  /// Returns the name that stands in a place, a new one for a new place.
  QByteArray name(const QString& place);
  /// Writes a file below `folder()`; its own folder is made.
  void write(const QString& file, const QByteArray& bytes);
  /// Writes a file of that ending, whose name and folder are planted.
  void writeNamed(const QString& ending, const QByteArray& bytes);
  /// Writes an input that lies beside the folder, where its kind is not read within one.
  void writeInput(const QString& file, const QByteArray& bytes, bool isInput = true);

 private:
  QString m_top;
  QString m_folder;
  QStringList m_inputs;
  std::map<QString, QString> m_places;
  std::map<QString, QByteArray> m_names;  ///< by place
};

/// Return texts with planted names in place of what stands there; the test fails where nothing
/// does.
QByteArray replaced(QByteArray text, const QByteArray& before, const QByteArray& after);
QByteArray inserted(QByteArray text, const QByteArray& behind, const QByteArray& more);

/// Write the files of their kinds.
void plantSurfaces(Planting& planting);
void plantForeignScenes(Planting& planting);
void plantVolumes(Planting& planting);
void plantDicom(Planting& planting);
void plantSlicerScenes(Planting& planting);

}  // namespace sline::test
