// SPDX-License-Identifier: Apache-2.0
#include "widgets/instance/hand_over.h"

#include <QCryptographicHash>
#include <QDeadlineTimer>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocalSocket>
#include <QStandardPaths>

namespace sline::widgets {

namespace {

constexpr const char* freeKey = "free";
constexpr const char* pathsKey = "open";
constexpr const char* tokenKey = "token";

QByteArray lineOf(const QJsonObject& object) {
  return QJsonDocument(object).toJson(QJsonDocument::Compact) + '\n';
}

QJsonObject objectIn(const QByteArray& line) {
  return QJsonDocument::fromJson(line).object();
}

/// Waits for a whole line; returns an empty one where none comes in time.
QByteArray lineFrom(QLocalSocket& socket, const QDeadlineTimer& deadline) {
  while (!socket.canReadLine())
    if (socket.bytesAvailable() > longestMessage ||
        !socket.waitForReadyRead(int(deadline.remainingTime())))
      return {};
  return socket.readLine();
}

}  // namespace

QByteArray greeting(bool free) {
  return lineOf({{QLatin1String(freeKey), free}});
}

bool isFreeGreeting(const QByteArray& line) {
  return objectIn(line).value(QLatin1String(freeKey)).toBool();
}

QByteArray messageOf(const HandedFiles& files) {
  return lineOf({{QLatin1String(pathsKey), QJsonArray::fromStringList(files.paths)},
                 {QLatin1String(tokenKey), files.activationToken}});
}

std::optional<HandedFiles> filesIn(const QByteArray& line) {
  const QJsonObject object = objectIn(line);
  HandedFiles files{{}, object.value(QLatin1String(tokenKey)).toString()};
  for (const QJsonValue& value : object.value(QLatin1String(pathsKey)).toArray()) {
    const QString path = value.toString();
    if (!QDir::isAbsolutePath(path) || path.contains(QChar(0)))
      return std::nullopt;
    files.paths << path;
  }
  return files.paths.isEmpty() ? std::nullopt : std::optional(files);
}

QString windowSocket() {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::RuntimeLocation);
  const QFileInfo there(folder);
  constexpr QFile::Permissions others = QFile::ReadGroup | QFile::WriteGroup | QFile::ExeGroup |
                                        QFile::ReadOther | QFile::WriteOther | QFile::ExeOther;
  if (folder.isEmpty() || !there.isDir() || (there.permissions() & others) != 0)
    return {};
  QByteArray display = QGuiApplication::platformName().toUtf8();
  for (const char* name : {"WAYLAND_DISPLAY", "DISPLAY"})
    display += '\n' + qgetenv(name);
  const QByteArray digest = QCryptographicHash::hash(display, QCryptographicHash::Sha256);
  return folder + QStringLiteral("/sline-") + QString::fromLatin1(digest.toHex().left(16));
}

QString takenActivationToken() {
  QString token;
  for (const char* name : {"XDG_ACTIVATION_TOKEN", "DESKTOP_STARTUP_ID"})
    if (token.isEmpty())
      token = qEnvironmentVariable(name);
  return token;
}

bool handOver(const QString& socket, const HandedFiles& files, std::chrono::milliseconds patience) {
  const QByteArray message = messageOf(files);
  if (socket.isEmpty() || message.size() > longestMessage)
    return false;
  const QDeadlineTimer deadline(patience);
  QLocalSocket window;
  window.connectToServer(socket);
  if (!window.waitForConnected(int(deadline.remainingTime())) ||
      !isFreeGreeting(lineFrom(window, deadline)))
    return false;
  window.write(message);
  while (window.bytesToWrite() > 0)
    if (!window.waitForBytesWritten(int(deadline.remainingTime())))
      return false;
  // The window answered a moment ago: even if the confirmation is late, the files are on their way.
  lineFrom(window, deadline);
  return true;
}

}  // namespace sline::widgets
