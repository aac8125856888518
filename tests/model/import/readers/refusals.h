// SPDX-License-Identifier: Apache-2.0
// Builds rows of files that a reader must refuse, and breaks good files.
#pragma once

#include "tests/model/import/readers/mesh_files.h"

namespace sline::test {

/// Returns the cube of that kind with the first `from` replaced; aborts if there is none, so that a
/// row cannot pass by testing an unbroken file.
QByteArray edited(const char* kind, const QByteArray& from, const QByteArray& to);
/// Returns that part of the cube's bytes, from the beginning.
QByteArray cut(const char* kind, double part);
/// Returns the cube with the bytes at `at` overwritten; a negative place counts from the end.
QByteArray patched(const char* kind, qsizetype at, const QByteArray& with);

template <class T>
QByteArray raw(T value, std::endian order) {
  QByteArray bytes;
  append(bytes, value, order);
  return bytes;
}

void addRefusalColumns();
/// Adds a row. `fragment` must stand in the error's place, reason or remedy; a bar separates
/// alternatives, for files cut at places that move with their contents.
void addRefusal(const QString& what, const char* extension, const QByteArray& bytes,
                const char* fragment);
/// Runs the test of such a row.
void checkRefusal();

}  // namespace sline::test
