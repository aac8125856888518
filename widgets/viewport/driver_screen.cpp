// SPDX-License-Identifier: Apache-2.0
#include "widgets/viewport/driver_screen.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <utility>

namespace sline::widgets {

DriverScreen::DriverScreen(QWidget& parent, Told told)
    : QOpenGLWidget(&parent), m_told(std::move(told)) {
  setFormat(pictureFormat());
  setAttribute(Qt::WA_TransparentForMouseEvents);
}

DriverScreen::~DriverScreen() {
  // QOpenGLWidget's destructor destroys the context when there is nobody any more who could react.
  if (context())
    context()->disconnect(this);
  stop();
}

bool DriverScreen::start() {
  if (!context())
    return false;
  m_handoff = std::make_unique<render::gpu::Handoff>();
  return true;
}

void DriverScreen::stop() {
  if (!m_handoff)
    return;
  makeCurrent();
  m_handoff->releaseShowing();
  m_handoff.reset();
  doneCurrent();
  m_shown = 0;
}

void DriverScreen::initializeGL() {
  // A widget that moves to another window, or has lost its context, begins anew.
  m_told.closing();
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { m_told.closing(); });
  const auto text = [gl = context()->functions()](GLenum name) {
    return QString::fromUtf8(reinterpret_cast<const char*>(gl->glGetString(name)));
  };
  m_driver = text(GL_RENDERER) + QStringLiteral(", ") + text(GL_VERSION);
  m_told.ready();
}

Result<render::PictureTarget> DriverScreen::begin(render::gpu::TextureSize size) {
  const auto target = m_handoff->begin(size);
  return target ? Result<render::PictureTarget>(**target)
                : Result<render::PictureTarget>(target.error());
}

void DriverScreen::showPaper() {
  context()->functions()->glClearColor(m_paper.redF(), m_paper.greenF(), m_paper.blueF(), 1.0f);
  context()->functions()->glClear(GL_COLOR_BUFFER_BIT);
}

void DriverScreen::paintGL() {
  if (!m_handoff)
    return;
  if (m_shown == 0) {
    // The background is shown until there is a picture.
    showPaper();
    m_handoff->warmUp();
  }
  const std::uint64_t shown = m_handoff->show(pixelsOf(*this));
  if (shown <= m_blank) {
    showPaper();
    return;
  }
  if (std::exchange(m_shown, shown) != shown)
    m_told.shown(shown);
}

}  // namespace sline::widgets
