// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/alt_text_hint.h"

#include <QCoreApplication>
#include <QPointer>
#include <QThreadPool>

#include "render/export/description/alt_text.h"

namespace sline::widgets {

AltTextHint::AltTextHint(QObject* parent) : QObject(parent) {
  constexpr int pauseMs = 300;
  m_pause.setSingleShot(true);
  m_pause.setInterval(pauseMs);
  connect(&m_pause, &QTimer::timeout, this, &AltTextHint::find);
}

void AltTextHint::ask(const render::ExportPiece& file) {
  m_file = file;
  m_file.order.altText.clear();
  ++m_asked;
  m_pause.start();
}

void AltTextHint::find() {
  QThreadPool::globalInstance()->start([file = m_file, number = m_asked, hint = QPointer(this)] {
    const QString text = QString::fromStdString(render::altTextOf(render::readyOrder(file)).text);
    QMetaObject::invokeMethod(QCoreApplication::instance(), [hint, number, text] {
      if (hint && hint->m_asked == number)
        emit hint->told(text);
    });
  });
}

}  // namespace sline::widgets

#include "moc_alt_text_hint.cpp"
