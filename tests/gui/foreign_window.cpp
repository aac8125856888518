// SPDX-License-Identifier: Apache-2.0
// Includes no header of Qt, since names of Xlib and its macros clash with Qt's.
#include "tests/gui/foreign_window.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>

namespace sline::test {

struct ForeignWindow::Data {
  explicit Data(std::int64_t id) : process(id), display(XOpenDisplay(nullptr)) {
    // Windows may go away while they are examined.
    XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
  }
  Data(const Data&) = delete;
  Data& operator=(const Data&) = delete;
  ~Data() {
    if (display)
      XCloseDisplay(display);
  }

  std::int64_t process;
  Display* display;

  std::string property(Window window, const char* name) const {
    Atom type = 0;
    int format = 0;
    unsigned long items = 0;
    unsigned long rest = 0;
    unsigned char* bytes = nullptr;
    constexpr long longest = 1024;
    if (XGetWindowProperty(display, window, XInternAtom(display, name, False), 0, longest, False,
                           AnyPropertyType, &type, &format, &items, &rest, &bytes) != Success ||
        !bytes)
      return {};
    // Items of 32 bits come as longs.
    const std::size_t each = format == 32 ? sizeof(long) : std::size_t(format) / 8;
    std::string text(reinterpret_cast<const char*>(bytes), items * each);
    XFree(bytes);
    return text;
  }

  /// Returns the process's largest window that is shown; 0: none.
  Window window() const {
    Window root = DefaultRootWindow(display);
    Window parent = 0;
    Window* children = nullptr;
    unsigned count = 0;
    if (XQueryTree(display, root, &root, &parent, &children, &count) == 0)
      return 0;
    Window best = 0;
    int size = 0;
    for (unsigned i = 0; i < count; ++i) {
      XWindowAttributes shape{};
      const std::string owner = property(children[i], "_NET_WM_PID");
      if (owner.size() != sizeof(long) ||
          *reinterpret_cast<const long*>(owner.data()) != long(process) ||
          XGetWindowAttributes(display, children[i], &shape) == 0 || shape.map_state != IsViewable)
        continue;
      if (shape.width * shape.height > size) {
        size = shape.width * shape.height;
        best = children[i];
      }
    }
    if (children)
      XFree(children);
    return best;
  }
};

ForeignWindow::ForeignWindow(std::int64_t process) : m_data(std::make_unique<Data>(process)) {}

ForeignWindow::~ForeignWindow() = default;

std::string ForeignWindow::title() const {
  const Window window = m_data->display ? m_data->window() : 0;
  return window == 0 ? std::string() : m_data->property(window, "_NET_WM_NAME");
}

bool ForeignWindow::press(const char* key, bool control) {
  const Window window = m_data->display ? m_data->window() : 0;
  if (window == 0)
    return false;
  XSetInputFocus(m_data->display, window, RevertToParent, CurrentTime);
  XEvent event{};
  event.xkey.display = m_data->display;
  event.xkey.window = window;
  event.xkey.root = DefaultRootWindow(m_data->display);
  event.xkey.same_screen = True;
  event.xkey.keycode = XKeysymToKeycode(m_data->display, XStringToKeysym(key));
  event.xkey.state = control ? ControlMask : 0;
  for (const int type : {KeyPress, KeyRelease}) {
    event.type = type;
    XSendEvent(m_data->display, window, True, type == KeyPress ? KeyPressMask : KeyReleaseMask,
               &event);
  }
  XFlush(m_data->display);
  return true;
}

}  // namespace sline::test
