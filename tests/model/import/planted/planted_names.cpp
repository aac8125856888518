// SPDX-License-Identifier: Apache-2.0
#include "tests/model/import/planted/planted_names.h"

#include <QDir>
#include <QFileInfo>

#include "tests/model/import/written_meshes.h"

namespace sline::test {

Planting::Planting(const QString& top) : m_top(top) {
  m_folder = m_top + '/' + name("the folder above") + '/' + name("the folder") + "_1961";
  m_inputs << m_folder;
  plantSurfaces(*this);
  plantForeignScenes(*this);
  plantVolumes(*this);
  plantDicom(*this);
  plantSlicerScenes(*this);
}

QByteArray Planting::name(const QString& place) {
  QByteArray& name = m_names[place];
  if (name.isEmpty()) {
    constexpr const char letters[] = "bcdfghjklmnpqrtvwxz";  // no vowel, nothing that ends a plural
    constexpr std::size_t count = sizeof(letters) - 1;
    const std::size_t number = m_places.size();
    // So long that no base64 of surfaces holds it by chance, in any case of its letters.
    name = QByteArray("Zqxvwjg") + letters[number / count % count] + letters[number % count] + 'k';
    m_places[QString::fromLatin1(name)] = place;
  }
  return name;
}

QStringList Planting::names() const {
  QStringList names;
  for (const auto& [name, place] : m_places)
    names << name;
  return names;
}

void Planting::write(const QString& file, const QByteArray& bytes) {
  writeText(m_folder + '/' + file, bytes);
}

void Planting::writeNamed(const QString& ending, const QByteArray& bytes) {
  write(name("a folder in it") + "/" + name("the folder of a " + ending) + "/" +
            name("the name of a " + ending) + ending,
        bytes);
}

void Planting::writeInput(const QString& file, const QByteArray& bytes, bool isInput) {
  const QString path = QFileInfo(m_folder).path() + '/' + file;
  writeText(path, bytes);
  if (isInput)
    m_inputs << path;
}

QByteArray replaced(QByteArray text, const QByteArray& before, const QByteArray& after) {
  if (!text.contains(before))
    qFatal("there is no %s to be replaced", before.constData());
  return text.replace(before, after);
}

QByteArray inserted(QByteArray text, const QByteArray& behind, const QByteArray& more) {
  const qsizetype at = text.indexOf(behind);
  if (at < 0)
    qFatal("there is no %s to insert behind", behind.constData());
  return text.insert(at + behind.size(), more);
}

}  // namespace sline::test
