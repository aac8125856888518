// SPDX-License-Identifier: Apache-2.0
// Writes 3D Slicer's scenes beside two meshes for the tests, and imports them.
#pragma once

#include <QByteArray>
#include <QFile>
#include <QString>
#include <QTemporaryDir>
#include <array>
#include <filesystem>
#include <glm/vec3.hpp>

#include "model/import/plan/import.h"
#include "tests/model/import/written_meshes.h"

namespace sline::test {

QByteArray fiducial(const char* visible);

class SlicerFolder {
 public:
  SlicerFolder() {
    for (const char* name : {"liver", "spleen"})
      test::writeMesh(m_folder.filePath(QString("Data/%1.ply").arg(name)),
                      *test::octahedron({-70, 5, 10}, 20));
  }
  void write(const QString& name, const QByteArray& text) const {
    test::writeText(m_folder.filePath(name), text);
  }
  Result<model::Imported> import(const QString& name) const {
    return model::importInputs(
        std::array{std::filesystem::path(m_folder.filePath(name).toStdString())},
        {.keepFileNames = true});
  }
  QByteArray read(const QString& name) const {
    QFile file(m_folder.filePath(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }

 private:
  QTemporaryDir m_folder;
};

bool near(const glm::vec3& a, const glm::vec3& b);

}  // namespace sline::test
