// SPDX-License-Identifier: Apache-2.0
// Files that a second start of the program gives to the window that is open already, instead of
// opening one of its own. Both speak through a socket in the user's runtime folder, in lines of
// JSON: the window greets whoever calls, so that one that hangs is told from one that will answer,
// and only then is it told what to open.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <chrono>
#include <optional>

namespace sline::widgets {

/// What is handed over.
struct HandedFiles {
  QStringList paths;        ///< absolute
  QString activationToken;  ///< what lets the window come to the front; may be empty
};

/// A message or greeting longer than this is no longer listened to.
inline constexpr qsizetype longestMessage = qsizetype(1) << 20;

/// One line, its end included. The greeting of a window says whether it may be given files now.
QByteArray greeting(bool free);
bool isFreeGreeting(const QByteArray& line);
QByteArray messageOf(const HandedFiles& files);
/// None where the line is no message, or a path in it is not absolute.
std::optional<HandedFiles> filesIn(const QByteArray& line);

/// The socket of this user's windows on this display. Empty where there is no folder that is the
/// user's alone.
QString windowSocket();

/// Takes from the environment what the desktop gave this start to bring a window to the front
/// (XDG_ACTIVATION_TOKEN, DESKTOP_STARTUP_ID); to be asked before there is an application object,
/// which takes it too.
QString takenActivationToken();

/// True where a window took them. False, after `patience` at the latest, where none is there, none
/// is free, or it does not answer.
bool handOver(const QString& socket, const HandedFiles& files,
              std::chrono::milliseconds patience = std::chrono::seconds(1));

}  // namespace sline::widgets
