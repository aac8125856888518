// SPDX-License-Identifier: Apache-2.0
// Hands files that a second start of the program gets to the window that is already open, instead
// of opening a window of its own. Both speak through a socket in the user's runtime folder, in
// lines of JSON: the window greets each caller, which tells a window that hangs from one that will
// answer, and only then is it told what to open.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <chrono>
#include <optional>

namespace sline::widgets {

/// Holds what is handed over.
struct HandedFiles {
  QStringList paths;        ///< absolute
  QString activationToken;  ///< lets the window come to the front; may be empty
};

/// The length above which a message or greeting is no longer read.
inline constexpr qsizetype longestMessage = qsizetype(1) << 20;

/// Returns one line, including its end. The greeting of a window says whether it may be given files
/// now.
QByteArray greeting(bool free);
bool isFreeGreeting(const QByteArray& line);
QByteArray messageOf(const HandedFiles& files);
/// Returns the files in the line; none where the line is no message, or a path in it is not
/// absolute.
std::optional<HandedFiles> filesIn(const QByteArray& line);

/// Returns the socket of this user's windows on this display; empty where no folder belongs to the
/// user alone.
QString windowSocket();

/// Takes from the environment what the desktop gave this start to bring a window to the front
/// (XDG_ACTIVATION_TOKEN, DESKTOP_STARTUP_ID); it must be called before there is an application
/// object, which takes it too.
QString takenActivationToken();

/// Returns true where a window took the files; false, after `patience` at the latest, where there
/// is no window, none is free, or it does not answer.
bool handOver(const QString& socket, const HandedFiles& files,
              std::chrono::milliseconds patience = std::chrono::seconds(1));

}  // namespace sline::widgets
