// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <functional>

#include "widgets/instance/hand_over.h"

class QLocalServer;
class QLocalSocket;

namespace sline::widgets {

/// Receives, at the window's end of the socket, the files that later starts of the program hand
/// over. The socket is accessible to the user alone. One window holds it; another takes it over
/// when that window is used after the first has gone.
class WindowServer : public QObject {
  Q_OBJECT
 public:
  /// Prepares the server. `free` tells whether the window may be given files now, which it may not
  /// while it asks the user something; it must outlive the object.
  WindowServer(QString socket, std::function<bool()> free, QObject* parent = nullptr);

  /// Returns true where this window or another window of the program listens. Removes a socket that
  /// a crash left behind.
  bool listen();
  bool listens() const;

 signals:
  void handed(const HandedFiles& files);

 private:
  void greet();
  void hear(QLocalSocket* caller);

  QString m_socket;
  std::function<bool()> m_free;
  QLocalServer* m_server;
};

}  // namespace sline::widgets
