// SPDX-License-Identifier: Apache-2.0
// A file spoiled again and again and read as the program reads it, in a process of its own where
// its kind asks for one.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

namespace sline::test {

struct SpoiledCopies {
  int read = 0;
  int refused = 0;
  int crashed = 0;     ///< of those refused: the child did not survive
  QStringList silent;  ///< refused without a reason or a remedy
  qint64 slowest = 0;  ///< milliseconds
};

/// Spoils and reads as many copies as the environment variable SLINE_SPOILED_COPIES says, else 15;
/// the same ones for the same name, which is the file's: "kidneys.fbx".
SpoiledCopies readSpoiledCopies(const QString& name, const QByteArray& bytes);

/// Fails the test where a copy was refused without a word or took more than 20 s.
void judgeSpoiledCopies(const QString& name, const QByteArray& bytes);

}  // namespace sline::test
