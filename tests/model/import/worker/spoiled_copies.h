// SPDX-License-Identifier: Apache-2.0
// Spoils a file again and again and reads it as the program does, in a process of its own if its
// kind asks for one.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

namespace sline::test {

struct SpoiledCopies {
  int read = 0;
  int refused = 0;
  int crashed = 0;     ///< among those refused: the child did not survive
  QStringList silent;  ///< refused without a reason or a remedy
};

/// Spoils and reads as many copies as the environment variable SLINE_SPOILED_COPIES says, else 15.
/// The same file name, such as "kidneys.fbx", gives the same copies.
SpoiledCopies readSpoiledCopies(const QString& name, const QByteArray& bytes);

/// Fails the test if a copy was refused without a reason or took more than 20 s.
void judgeSpoiledCopies(const QString& name, const QByteArray& bytes);

}  // namespace sline::test
