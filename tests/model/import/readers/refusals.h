// SPDX-License-Identifier: Apache-2.0
// Rows of files that a reader must refuse, and ways to break a good file.
#pragma once

#include "tests/model/import/readers/mesh_files.h"

namespace sline::test {

/// The cube of that kind with the first `from` replaced; aborts where there is none, so that a row
/// cannot pass by testing an unbroken file.
QByteArray edited(const char* kind, const QByteArray& from, const QByteArray& to);
/// That part of the cube's bytes, from the beginning.
QByteArray cut(const char* kind, double part);
/// The bytes at `at` overwritten; a negative place counts from the end.
QByteArray patched(const char* kind, qsizetype at, const QByteArray& with);

template <class T>
QByteArray raw(T value, std::endian order) {
  QByteArray bytes;
  append(bytes, value, order);
  return bytes;
}

void addRefusalColumns();
/// `fragment` must stand in the error's place, reason or remedy; a bar separates alternatives, for
/// files cut at places that move with their contents.
void addRefusal(const QString& what, const char* extension, const QByteArray& bytes,
                const char* fragment);
/// The test function of such rows.
void checkRefusal();

}  // namespace sline::test
