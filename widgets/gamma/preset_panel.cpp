// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/preset_panel.h"

#include <QGridLayout>
#include <QMenu>
#include <QPushButton>

#include "model/edit/emphasis.h"
#include "model/edit/visibility.h"
#include "widgets/gamma/look_drag.h"
#include "widgets/gamma/preset_dialogs.h"

namespace sline::widgets {

namespace {

struct OwnPreset {
  const char* name;
  QString text;
  QString tip;
  /// Makes the edit; null for focus, which must first analyse what is around the structures.
  model::Edited (*edit)(const model::Scene&, std::span<const model::NodeId>);
};

std::vector<OwnPreset> ownPresets() {
  return {{"focusButton", PresetPanel::tr("Focus"),
           PresetPanel::tr("These in detail, everything else by what it is to them"), nullptr},
          {"contextButton", PresetPanel::tr("Context"), PresetPanel::tr("These as contours"),
           model::withContext},
          {"ghostButton", PresetPanel::tr("Ghost"),
           PresetPanel::tr("These as their outer edges alone"), model::withGhost},
          {"hiddenButton", PresetPanel::tr("Hidden"), PresetPanel::tr("Hides these"),
           model::withHidden}};
}

/// Escapes the text, so that a menu's entry shows '&' as it is written.
QString plain(QString text) {
  return text.replace(QLatin1Char('&'), QStringLiteral("&&"));
}

}  // namespace

PresetPanel::PresetPanel(Session& session, QSettings& settings, QWidget* parent)
    : QWidget(parent), m_session(session), m_store(settings), m_menu(new QMenu(this)) {
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  int place = 0;
  for (const OwnPreset& row : ownPresets()) {
    auto* button = new QPushButton(row.text);
    button->setObjectName(QLatin1String(row.name));
    button->setToolTip(row.tip);
    layout->addWidget(button, place / 2, place % 2);
    ++place;
    connect(button, &QPushButton::clicked, this, [this, row] {
      if (!row.edit)
        return emit focusWanted();
      m_session.apply(row.text, row.edit(m_session.scene(), m_session.selection()));
    });
  }
  m_menu->setObjectName(QStringLiteral("presetMenu"));
  auto* own = new QPushButton(tr("My presets"));
  own->setObjectName(QStringLiteral("presetsButton"));
  own->setToolTip(tr("Looks that you have named"));
  own->setMenu(m_menu);
  layout->addWidget(own, place / 2, 0, 1, 2);
  connect(m_menu, &QMenu::aboutToShow, this, &PresetPanel::fillMenu);
}

void PresetPanel::fillMenu() {
  m_menu->clear();
  for (const model::StylePreset& preset : m_store.presets()) {
    QAction* action = m_menu->addAction(plain(QString::fromStdString(preset.name)));
    connect(action, &QAction::triggered, this, [this, preset] { put(preset); });
  }
  const bool any = !m_menu->isEmpty();
  if (any)
    m_menu->addSeparator();
  QAction* save = m_menu->addAction(tr("&Save This Look…"));
  save->setObjectName(QStringLiteral("savePreset"));
  connect(save, &QAction::triggered, this, &PresetPanel::askForName);
  QAction* manage = m_menu->addAction(tr("&Manage…"));
  manage->setObjectName(QStringLiteral("managePresets"));
  manage->setEnabled(any);
  connect(manage, &QAction::triggered, this,
          [this] { (new ManagePresetsDialog(m_store, window()))->open(); });
}

void PresetPanel::put(const model::StylePreset& preset) {
  const NodeIds& ids = m_session.selection();
  m_session.apply(lookStepName(QString::fromStdString(preset.name), m_session, ids),
                  model::withLook(m_session.scene(), ids, preset.style));
}

void PresetPanel::askForName() {
  if (m_session.selection().empty())
    return;
  model::Style look = model::lookOf(m_session.scene(), m_session.selection().front());
  look.visible.reset();
  (new SavePresetDialog(m_store, look, window()))->open();
}

}  // namespace sline::widgets

#include "moc_preset_panel.cpp"
