// SPDX-License-Identifier: Apache-2.0
// Starts the built program on small scenes made for the test.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::test {

struct Finished {
  int code = -1;  ///< −1: it crashed or did not end within two minutes
  QByteArray out;
  QByteArray err;
};
Finished runSline(const QStringList& arguments);
/// Runs a copy of the program alone in that folder, without what lies beside it.
Finished runSlineCopiedTo(const QString& folder, const QStringList& arguments);
/// Runs the program with its streams redirected by a shell, as in ">/dev/full 2>&1" or ">&-".
Finished runSlineLed(const QString& streams, const QStringList& arguments);

/// Writes the mesh as OBJ, by default without a group's name in it.
void writeObj(const QString& file, const model::Mesh& mesh, const QString& group = {});
void writeFile(const QString& file, const QByteArray& text);

/// Writes into the folder Organs/kidney.obj (radius 30 at the middle), Vessels/renal artery.obj
/// (radius 10, at +x) and Vessels/renal vein.obj (radius 10, at −x). Returns its path.
QString writeSample(const QString& folder);

/// Returns a camera from the front, 400 mm before the middle.
QByteArray frontCamera();

/// Holds 8-bit pixels with straight alpha, rows from the top; empty if the file cannot be read.
struct Pixels {
  int width = 0;
  int height = 0;
  int channels = 0;  ///< in the file
  std::vector<unsigned char> rgba;
  const unsigned char* at(int x, int y) const { return &rgba[std::size_t(4 * (y * width + x))]; }
};
Pixels readPicture(const QString& file);

/// Holds the smallest box of pixels that differ from the top left one; [0, −1] if there are none.
struct PixelBox {
  int left = 0;
  int top = 0;
  int right = -1;
  int bottom = -1;
};
PixelBox drawnBox(const Pixels& picture);

/// Describes the pixels in which channel `strong` (0 red, 1 green, 2 blue) is at least 60 above the
/// others: how many there are, and their mean column.
struct Tinted {
  int count = 0;
  double column = 0.0;
};
Tinted tinted(const Pixels& picture, int strong);

}  // namespace sline::test
