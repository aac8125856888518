// SPDX-License-Identifier: Apache-2.0
#include "widgets/figure/figure_writing.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>
#include <utility>

#include "widgets/text/path_text.h"
#include "widgets/text/told.h"

namespace sline::widgets {

FigureWriting::FigureWriting(QWidget* parent)
    : QWidget(parent), m_bar(new QProgressBar), m_cancel(new QPushButton(tr("Cancel"))) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  m_bar->setObjectName(QStringLiteral("figureProgress"));
  m_bar->setAccessibleName(tr("Writing the figure…"));
  m_bar->setTextVisible(false);
  m_bar->setFixedWidth(160);
  m_cancel->setObjectName(QStringLiteral("figureCancel"));
  m_cancel->setToolTip(tr("Stop writing; a file that was there before stays as it is"));
  m_cancel->setAutoDefault(false);
  layout->addWidget(m_bar);
  layout->addWidget(m_cancel);
  connect(m_cancel, &QPushButton::clicked, this, &FigureWriting::cancel);
  hide();
}

FigureWriting::~FigureWriting() = default;

void FigureWriting::begin(FigureWork work, const std::filesystem::path& target) {
  if (m_job)
    return;
  m_job = std::make_unique<FigureJob>(std::move(work), target);
  constexpr int parts = 1000;
  m_bar->setRange(0, 0);  // until the writer reports its progress
  m_cancel->setEnabled(true);
  show();
  connect(m_job.get(), &FigureJob::progressed, this, [this](double share, const QString& what) {
    m_bar->setRange(0, parts);
    m_bar->setValue(int(parts * share));
    m_bar->setToolTip(what);
  });
  connect(m_job.get(), &FigureJob::done, this,
          [this] { end(tr("Saved %1").arg(QFileInfo(textOf(m_job->target())).fileName())); });
  connect(m_job.get(), &FigureJob::failed, this,
          [this](const Error& error) { end(told(error.text())); });
  connect(m_job.get(), &FigureJob::cancelled, this,
          [this] { end(tr("Stopped; nothing was written")); });
  m_job->start();
}

void FigureWriting::cancel() {
  m_cancel->setEnabled(false);
  if (m_job)
    m_job->cancel();
}

void FigureWriting::end(const QString& words) {
  // The job itself is the caller, so it must not be deleted at once.
  m_job.release()->deleteLater();
  hide();
  emit ended(words);
}

}  // namespace sline::widgets

#include "moc_figure_writing.cpp"
