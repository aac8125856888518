// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <functional>

#include "widgets/instance/hand_over.h"

class QLocalServer;
class QLocalSocket;

namespace sline::widgets {

/// The window's end of the socket: hears of files that later starts of the program hand over. The
/// socket is the user's alone. One window has it; another takes it over when it is used and that
/// one is gone.
class WindowServer : public QObject {
  Q_OBJECT
 public:
  /// `free` is asked whether the window may be given files now: one that asks something itself may
  /// not. It must outlive the object.
  WindowServer(QString socket, std::function<bool()> free, QObject* parent = nullptr);

  /// True where it listens, or another window of the program does. What a crash left of a socket is
  /// put away.
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
