// SPDX-License-Identifier: Apache-2.0
#include "widgets/instance/window_server.h"

#include <QLocalServer>
#include <QLocalSocket>
#include <QTimer>
#include <utility>

namespace sline::widgets {

namespace {
/// The time after which a caller that was greeted and says nothing is dropped.
constexpr std::chrono::seconds silence{5};
}  // namespace

WindowServer::WindowServer(QString socket, std::function<bool()> free, QObject* parent)
    : QObject(parent),
      m_socket(std::move(socket)),
      m_free(std::move(free)),
      m_server(new QLocalServer(this)) {
  m_server->setSocketOptions(QLocalServer::UserAccessOption);
  connect(m_server, &QLocalServer::newConnection, this, &WindowServer::greet);
}

bool WindowServer::listens() const {
  return m_server->isListening();
}

bool WindowServer::listen() {
  if (listens())
    return true;
  if (m_socket.isEmpty())
    return false;
  // For an existing window the kernel connects at once, even if it hangs, and for a crashed one it
  // refuses.
  QLocalSocket other;
  other.connectToServer(m_socket);
  if (other.waitForConnected(100))
    return true;
  QLocalServer::removeServer(m_socket);
  return m_server->listen(m_socket);
}

void WindowServer::greet() {
  while (QLocalSocket* caller = m_server->nextPendingConnection()) {
    caller->setReadBufferSize(longestMessage + 1);
    connect(caller, &QLocalSocket::disconnected, caller, &QObject::deleteLater);
    connect(caller, &QLocalSocket::readyRead, this, [this, caller] { hear(caller); });
    QTimer::singleShot(silence, caller, [caller] { caller->abort(); });
    caller->write(greeting(m_free()));
    caller->flush();
  }
}

void WindowServer::hear(QLocalSocket* caller) {
  if (!caller->canReadLine()) {
    if (caller->bytesAvailable() > longestMessage)
      caller->abort();
    return;
  }
  const std::optional<HandedFiles> files = filesIn(caller->readLine());
  if (files)
    caller->write(greeting(true));
  caller->disconnectFromServer();
  if (files)
    emit handed(*files);
}

}  // namespace sline::widgets

#include "moc_window_server.cpp"
