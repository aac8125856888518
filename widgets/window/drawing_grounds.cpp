// SPDX-License-Identifier: Apache-2.0
#include "widgets/window/drawing_grounds.h"

namespace sline::widgets {

namespace {

constexpr const char* groundKey = "picture/background";

}  // namespace

DrawingGrounds::DrawingGrounds(Session& session, Preferences& preferences, QObject* parent)
    : QObject(parent), m_preferences(preferences) {
  connect(&session, &Session::documentChanged, this, &DrawingGrounds::follow);
}

void DrawingGrounds::take(const QString& background) {
  const QString from = m_preferences.choice(QLatin1String(groundKey));
  if (from == background)
    return;
  m_steps.push_back({m_last.before, m_last.after, from, background});
  m_preferences.set(QLatin1String(groundKey), background);
}

void DrawingGrounds::follow(const Document& before, const Document& now) {
  if (before.opening != now.opening)
    m_steps.clear();
  m_last = {.before = before.scene, .after = now.scene, .from = {}, .to = {}};
  // A background that was chosen since stays.
  const QString ground = m_preferences.choice(QLatin1String(groundKey));
  for (const Step& step : m_steps) {
    const bool back = ground == step.to && now.scene == step.before && before.scene == step.after;
    const bool again =
        ground == step.from && now.scene == step.after && before.scene == step.before;
    if (back || again) {
      m_preferences.set(QLatin1String(groundKey), back ? step.from : step.to);
      return;
    }
  }
}

}  // namespace sline::widgets

#include "moc_drawing_grounds.cpp"
