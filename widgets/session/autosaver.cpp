// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/autosaver.h"

#include <algorithm>

namespace sline::widgets {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

/// Holds the copy's file, which gets its name when the first copy is made.
struct Autosaver::Copy {
  std::optional<model::Autosave> file;
};

Autosaver::Autosaver(Session& session, std::filesystem::path folder, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_folder(std::move(folder)),
      m_copy(std::make_shared<Copy>()) {
  connect(&session, &Session::documentChanged, this, &Autosaver::documentChange);
  connect(&session, &Session::fileChanged, this, &Autosaver::fileChange);
  connect(&m_timer, &QTimer::timeout, this, &Autosaver::keepIfDue);
}

Autosaver::~Autosaver() = default;

void Autosaver::setInterval(milliseconds interval) {
  if (interval == m_interval)
    return;
  m_interval = interval;
  m_clock = model::AutosaveClock(interval);
  m_timer.stop();
  if (interval.count() > 0 && m_session.modified())
    documentChange({}, m_session.document());
}

void Autosaver::documentChange(const Document& before, const Document& now) {
  if (m_interval.count() <= 0 || m_folder.empty() || before.scene == now.scene)
    return;
  // Structures come and go rarely, and much work may depend on each.
  const bool large = before.scene.nodes().size() != now.scene.nodes().size();
  m_clock.changed(Clock::now(), large);
  constexpr milliseconds longest(1000);
  constexpr milliseconds shortest(20);
  m_timer.start(std::clamp(m_interval / 5, shortest, longest));
}

void Autosaver::fileChange() {
  if (!m_session.modified())
    discard();
}

void Autosaver::discard() {
  m_clock.kept();
  m_timer.stop();
  m_queue.add([copy = m_copy, left = m_session.file().copy](const std::stop_token&) {
    if (copy->file)
      copy->file->discard();
    if (left)
      model::forget(*left);
    return BackgroundQueue::Sequel();
  });
}

void Autosaver::keepIfDue() {
  if (!m_session.modified()) {
    m_timer.stop();
    m_clock.kept();
  } else if (m_clock.due(Clock::now()) && !m_queue.busy()) {
    keep();
  }
}

void Autosaver::keep() {
  m_clock.kept();
  m_timer.stop();
  const DocumentFile& file = m_session.file();
  m_queue.add([this, copy = m_copy, folder = m_folder, scene = m_session.sceneBeforePreview(),
               thumbnail = file.thumbnail, others = file.others, left = file.copy,
               source = model::AutosaveSource{m_session.title().toStdString(), file.path}](
                  const std::stop_token&) -> BackgroundQueue::Sequel {
    if (!copy->file) {
      Result<model::Autosave> begun = model::Autosave::begin(folder);
      if (!begun.ok())
        return [this, error = begun.error()] { finish(error); };
      copy->file.emplace(std::move(*begun));
    }
    model::SceneDocument document{.scene = scene};
    if (thumbnail)
      document.thumbnail = *thumbnail;
    if (others)
      document.others = *others;
    const Status kept = copy->file->keep(document, source);
    // The document's own copy has everything that this one had.
    if (kept.ok() && left)
      model::forget(*left);
    return [this, kept] { finish(kept); };
  });
}

void Autosaver::finish(const Status& status) {
  if (status.ok()) {
    m_failing = false;
    emit kept();
    return;
  }
  m_clock.changed(Clock::now());  // tries again later
  m_timer.start(1000);
  if (!std::exchange(m_failing, true))
    emit failed(status.error());
}

}  // namespace sline::widgets

#include "moc_autosaver.cpp"
