// SPDX-License-Identifier: Apache-2.0
// Tests files handed from one start of the program to the window of another, in one process: the
// caller waits in a thread of its own, as a second start waits before it has a window.
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>
#include <future>

#include "tests/support/suite.h"
#include "widgets/instance/window_server.h"

using namespace sline::widgets;
using namespace std::chrono_literals;

namespace {
const HandedFiles files{{QStringLiteral("/tmp/a b/lever.sline"), QStringLiteral("/data/kneé")},
                        QStringLiteral("token_TIME42")};

bool handedWhileEventsRun(const QString& socket, const HandedFiles& what) {
  std::future<bool> caller = std::async(std::launch::async, [&] { return handOver(socket, what); });
  while (caller.wait_for(1ms) != std::future_status::ready)
    QCoreApplication::processEvents();
  return caller.get();
}
/// Returns the socket of a caller that does not know the program's protocol.
int callerOf(const QString& socket) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const QByteArray path = socket.toUtf8();
  std::copy(path.begin(), path.end(), address.sun_path);
  const int caller = ::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0);
  const bool there =
      ::connect(caller, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
  return there ? caller : -1;
}

/// Sends as much of the rest as the other side takes now; returns true when that has hung up.
bool isHungUpOn(int caller, QByteArray& rest) {
  const ssize_t sent = ::send(caller, rest.constData(), std::size_t(rest.size()), MSG_NOSIGNAL);
  if (sent > 0)
    rest.remove(0, sent);
  char answer[256];
  const ssize_t got = ::recv(caller, answer, sizeof(answer), 0);
  return got == 0 || (got < 0 && errno != EAGAIN);
}
}  // namespace

class WindowServerTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  QString socket() const { return m_folder.filePath(QStringLiteral("window")); }

 private slots:
  void filesArrive() {
    WindowServer window(socket(), [] { return true; });
    QVERIFY(window.listen());
    std::vector<HandedFiles> heard;
    connect(&window, &WindowServer::handed, this,
            [&](const HandedFiles& handed) { heard.push_back(handed); });
    QVERIFY(handedWhileEventsRun(socket(), files));
    QVERIFY(QTest::qWaitFor([&] { return !heard.empty(); }));
    QCOMPARE(heard.front().paths, files.paths);
    QCOMPARE(heard.front().activationToken, files.activationToken);
    QVERIFY(handedWhileEventsRun(socket(), {{QStringLiteral("/other")}, {}}));
    QVERIFY(QTest::qWaitFor([&] { return heard.size() == 2; }));
  }

  /// No other user may call: the socket is the user's alone.
  void socketIsPrivate() {
    WindowServer window(socket(), [] { return true; });
    QVERIFY(window.listen());
    struct stat there {};
    QCOMPARE(::stat(socket().toUtf8().constData(), &there), 0);
    QCOMPARE(there.st_mode & 0777u, 0600u | (there.st_mode & 0100u));
  }

  void nobodyThere() {
    QVERIFY(!handOver(socket(), files));
    QVERIFY(!handOver({}, files));
  }

  /// A window that is asking a question itself is not disturbed.
  void notFree() {
    WindowServer window(socket(), [] { return false; });
    QVERIFY(window.listen());
    QVERIFY(!handedWhileEventsRun(socket(), files));
  }

  /// A window that hangs does not hold up the caller for long, and does not open the files when it
  /// goes on.
  void hangs() {
    WindowServer window(socket(), [] { return true; });
    QVERIFY(window.listen());
    int heard = 0;
    connect(&window, &WindowServer::handed, this, [&] { ++heard; });
    QVERIFY(!handOver(socket(), files));
    QTest::qWait(50);
    QCOMPARE(heard, 0);
  }

  /// A socket left by a crash does not keep the next window from having one.
  void afterACrash() {
    QFile left(socket());
    QVERIFY(left.open(QIODevice::WriteOnly));
    left.close();
    QVERIFY(!handOver(socket(), files));
    WindowServer window(socket(), [] { return true; });
    QVERIFY(window.listen());
    QVERIFY(handedWhileEventsRun(socket(), files));
  }

  /// The first window keeps the socket while it is there; then another can have it.
  void secondWindow() {
    auto first = std::make_unique<WindowServer>(socket(), [] { return true; });
    QVERIFY(first->listen());
    WindowServer second(socket(), [] { return true; });
    QVERIFY(second.listen());
    QVERIFY(!second.listens());
    int heard = 0;
    connect(first.get(), &WindowServer::handed, this, [&] { ++heard; });
    QVERIFY(handedWhileEventsRun(socket(), files));
    QVERIFY(QTest::qWaitFor([&] { return heard == 1; }));
    first.reset();
    QVERIFY(second.listen());
    QVERIFY(second.listens());
    QVERIFY(handedWhileEventsRun(socket(), files));
  }

  void badCallers_data() {
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("nothing of ours") << QByteArray("GET / HTTP/1.1\n");
    QTest::newRow("no paths") << QByteArray("{\"open\":[]}\n");
    QTest::newRow("a path of no folder") << QByteArray("{\"open\":[\"a.stl\"]}\n");
    QTest::newRow("no text") << QByteArray("{\"open\":[7]}\n");
    QTest::newRow("without an end") << QByteArray(longestMessage + 100, 'x');
  }

  /// Bad callers are not heard, and the window is there for the next.
  void badCallers() {
    QFETCH(QByteArray, said);
    WindowServer window(socket(), [] { return true; });
    QVERIFY(window.listen());
    int heard = 0;
    connect(&window, &WindowServer::handed, this, [&] { ++heard; });
    const int caller = callerOf(socket());
    QVERIFY(caller >= 0);
    QVERIFY(QTest::qWaitFor([&] { return isHungUpOn(caller, said); }));
    ::close(caller);
    QCOMPARE(heard, 0);
    QVERIFY(handedWhileEventsRun(socket(), files));
    QVERIFY(QTest::qWaitFor([&] { return heard == 1; }));
  }

  /// A folder that others may enter is no place for a socket.
  void runtimeFolder() {
    const QByteArray before = qgetenv("XDG_RUNTIME_DIR");
    qputenv("XDG_RUNTIME_DIR", m_folder.path().toUtf8());
    const QString there = windowSocket();
    QVERIFY2(there.startsWith(m_folder.path()), qPrintable(there));
    qputenv("DISPLAY", ":4711");
    QVERIFY(windowSocket() != there);
    qputenv("XDG_RUNTIME_DIR", before);
  }
};

SLINE_TEST_WITH_EVENTS(WindowServerTest)
#include "window_server_test.moc"
