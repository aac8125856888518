// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/view_actions.h"

#include <QAction>
#include <QMenu>
#include <QSettings>

#include "model/edit/views.h"
#include "widgets/viewport/viewport.h"
#include "widgets/views/view_list.h"

namespace sline::widgets {

namespace {
constexpr const char* keyLightKey = "picture/keyLight";
}

ViewActions::ViewActions(Session& session, Viewport& viewport, QSettings& settings,
                         const WindowActions& actions, QMenu& savedViews)
    : QObject(&savedViews),
      m_session(session),
      m_viewport(viewport),
      m_settings(settings),
      m_keyLight(actions[QStringLiteral("keyLight")]),
      m_savedViews(savedViews) {
  m_viewport.setKeyLight(m_settings.value(QLatin1String(keyLightKey)).toBool());
  m_keyLight.setCheckable(true);
  m_keyLight.setChecked(m_viewport.keyLight());
  connect(&m_keyLight, &QAction::triggered, this, &ViewActions::lightKey);
  connect(&m_session, &Session::documentChanged, this, &ViewActions::documentChange);
  listViews();
}

void ViewActions::lightKey(bool on) {
  m_settings.setValue(QLatin1String(keyLightKey), on);
  m_viewport.setKeyLight(on);
  if (m_session.document().opening == 0)
    return;
  model::KeyLight light = m_session.scene().keyLight().value_or(model::KeyLight());
  light.shades = on;
  m_session.apply(tr("Key Light"), model::withKeyLight(m_session.scene(), light));
}

void ViewActions::listViews() {
  m_savedViews.clear();
  const std::vector<model::View>& views = m_session.scene().views();
  for (int i = 0; i < int(views.size()); ++i) {
    // An ampersand in a name must not mark a key.
    const QString name =
        shownName(views[std::size_t(i)]).replace(QLatin1Char('&'), QStringLiteral("&&"));
    m_savedViews.addAction(name, this, [this, i] { emit viewChosen(i); });
  }
  m_savedViews.setEnabled(!m_savedViews.isEmpty());
}

void ViewActions::documentChange(const Document& before, const Document& now) {
  if (before.opening != now.opening || before.scene.views() != now.scene.views())
    listViews();
  m_keyLight.setChecked(m_viewport.keyLight());
}

}  // namespace sline::widgets

#include "moc_view_actions.cpp"
