// SPDX-License-Identifier: Apache-2.0
#include "widgets/annotations/in_picture/label_actions.h"

#include <QAction>
#include <QLocale>
#include <QMainWindow>
#include <QMenu>
#include <QStatusBar>
#include <algorithm>
#include <array>
#include <utility>

#include "model/edit/annotations.h"
#include "model/lengths/shortest_distance.h"
#include "render/labels/seen/seen_map.h"
#include "widgets/annotations/annotation_texts.h"
#include "widgets/annotations/in_picture/picture_labels.h"
#include "widgets/annotations/label_preferences.h"
#include "widgets/preferences/choice_actions.h"
#include "widgets/viewport/tools/tool.h"

namespace sline::widgets {

namespace {

constexpr int readable = 6000;  // milliseconds

struct KindAction {
  const char* id;
  model::AnnotationKind kind;
};
constexpr std::array<KindAction, 4> kinds{{{"annotateLabel", model::AnnotationKind::label},
                                           {"annotateCallout", model::AnnotationKind::callout},
                                           {"annotatePin", model::AnnotationKind::pin},
                                           {"annotateDistance", model::AnnotationKind::distance}}};

QString hintOf(model::AnnotationKind kind) {
  switch (kind) {
    case model::AnnotationKind::distance:
      return LabelActions::tr("Click on two places to measure between them; Esc ends this");
    case model::AnnotationKind::pin:
      return LabelActions::tr("Click on a place to mark it; Esc ends this");
    case model::AnnotationKind::callout:
      return LabelActions::tr(
          "Click on a structure and type; Shift+Return begins a line, Esc ends this");
    default:
      return LabelActions::tr("Click on a structure and type; Esc ends this");
  }
}

bool hasLabel(const model::Scene& scene, model::NodeId structure) {
  const auto& all = scene.annotations();
  return std::any_of(all.begin(), all.end(), [structure](const model::Annotation& annotation) {
    return annotation.kind == model::AnnotationKind::label && structureOf(annotation) == structure;
  });
}

/// Runs in the background, because sorting the meshes takes longer than a window may stand still.
std::vector<model::Annotation> labelsFor(const model::Scene& scene, const NodeIds& structures,
                                         const render::Screen& screen,
                                         const std::stop_token& stop) {
  std::vector<model::Annotation> found;
  const render::SeenMap map(scene, screen);
  for (const model::NodeId id : structures) {
    if (stop.stop_requested())
      break;
    if (auto label = map.labelFor(id))
      found.push_back(*std::move(label));
  }
  return found;
}

}  // namespace

std::vector<QAction*> labelMakers(const WindowActions& actions) {
  std::vector<QAction*> makers;
  for (const KindAction& row : kinds)
    makers.push_back(&actions[QLatin1String(row.id)]);
  makers.push_back(&actions[QStringLiteral("labelSelected")]);
  return makers;
}

LabelActions::LabelActions(const Context& context, QObject* parent)
    : QObject(parent),
      m_window(context.window),
      m_session(context.session),
      m_picture(context.picture),
      m_view(context.view),
      m_labels(context.labels),
      m_preferences(context.preferences),
      m_actions(context.actions) {
  makeTools();
  addChoiceActions(context.shown, m_preferences, QLatin1String(labelModeKey),
                   QStringLiteral("labels"));
  connect(&m_preferences, &Preferences::changed, this, &LabelActions::follow);
  connect(&m_session.names(), &DisplayNames::changed, this, &LabelActions::follow);
  connect(&m_session, &Session::documentChanged, this, &LabelActions::showState);
  connect(&m_session, &Session::selectionChanged, this, &LabelActions::showState);
  connect(&m_session, &Session::activeAnnotationChanged, this, &LabelActions::showState);
  follow();
  showState();
  showMaking();
}

void LabelActions::makeTools() {
  for (const KindAction& row : kinds) {
    QAction& action = m_actions[QLatin1String(row.id)];
    action.setCheckable(true);
    action.installEventFilter(this);
    connect(&action, &QAction::triggered, this, [this, kind = row.kind](bool on) {
      if (on && kind == model::AnnotationKind::distance && measureSelected())
        on = false;
      m_labels.make(on ? std::optional(kind) : std::nullopt);
      m_picture.setFocus(Qt::OtherFocusReason);
      showMaking();
    });
  }
  connect(&m_labels, &PictureLabels::makingChanged, this, &LabelActions::showMaking);
  connect(&m_labels, &PictureLabels::missed, this, [this] {
    m_window.statusBar()->showMessage(tr("Nothing is there: click on a structure"), readable);
  });
  // Other messages disappear after a while; the hint on how to go on with a tool stays.
  connect(m_window.statusBar(), &QStatusBar::messageChanged, this, [this](const QString& says) {
    if (says.isEmpty() && !m_hint.isEmpty())
      m_window.statusBar()->showMessage(m_hint);
  });
  connect(&m_labels, &PictureLabels::made, this, [this] {
    if (const QString apart = notInAllViews(); !apart.isEmpty())
      m_window.statusBar()->showMessage(tr("Label added; %1").arg(apart), readable);
  });
  connect(&m_labels, &PictureLabels::made, this, [this](model::AnnotationId id) { m_made = id; });
  connect(&m_labels, &PictureLabels::sighted, this, &LabelActions::tellOfMade);
  connect(&m_labels, &PictureLabels::sighted, this, &LabelActions::tellOfAdded);
  connect(&m_actions[QStringLiteral("labelSelected")], &QAction::triggered, this,
          &LabelActions::labelSelected);
  connect(&m_actions[QStringLiteral("labelEdit")], &QAction::triggered, this, [this] {
    if (const auto active = m_session.activeAnnotation())
      m_labels.edit(*active);
  });
  connect(&m_actions[QStringLiteral("labelDelete")], &QAction::triggered, this, [this] {
    if (const auto active = m_session.activeAnnotation())
      m_labels.remove(*active);
  });
}

bool LabelActions::eventFilter(QObject* watched, QEvent* event) {
  // A key takes the tool up and never puts it away: otherwise letters typed next would act as keys
  // of the window.
  const auto* action = qobject_cast<const QAction*>(watched);
  if (event->type() != QEvent::Shortcut || !action || !action->isChecked())
    return QObject::eventFilter(watched, event);
  m_picture.setFocus(Qt::OtherFocusReason);
  return true;
}

void LabelActions::follow() {
  m_labels.setStyle(labelStyle(m_preferences, m_session.names()));
}

void LabelActions::showMaking() {
  const std::optional<model::AnnotationKind> making = m_labels.making();
  for (const KindAction& row : kinds)
    m_actions[QLatin1String(row.id)].setChecked(making == row.kind);
  QStatusBar& bar = *m_window.statusBar();
  const QString before = std::exchange(m_hint, making ? hintOf(*making) : QString());
  if (making)
    bar.showMessage(m_hint);
  else if (bar.currentMessage() == before)
    bar.clearMessage();
}

void LabelActions::showState() {
  const bool scene = !m_session.scene().nodes().empty();
  for (const KindAction& row : kinds)
    m_actions[QLatin1String(row.id)].setEnabled(scene);
  const bool active = m_session.activeAnnotation().has_value();
  m_actions[QStringLiteral("labelSelected")].setEnabled(!m_session.selection().empty());
  m_actions[QStringLiteral("labelEdit")].setEnabled(active);
  m_actions[QStringLiteral("labelDelete")].setEnabled(active);
}

bool LabelActions::measureSelected() {
  const model::Scene& scene = m_session.scene();
  const NodeIds two = scene.structuresBelow(m_session.selection());
  if (two.size() != 2)
    return false;
  m_queue.add([this, scene, two, opening = m_session.document().opening](
                  const std::stop_token&) -> BackgroundQueue::Sequel {
    return [this, opening, distance = model::shortestDistance(scene, two[0], two[1])] {
      if (!distance || opening != m_session.document().opening)
        return;
      if (!m_session.apply(
              tr("Add Distance"),
              model::withAnnotationMade(m_session.scene(), *distance, m_labels.currentView())))
        return;
      m_window.statusBar()->showMessage(
          tr("The shortest distance between the two selected structures was added; with another "
             "selection you choose two places"),
          readable);
    };
  });
  return true;
}

void LabelActions::labelSelected() {
  const model::Scene& scene = m_session.scene();
  NodeIds structures;
  for (const model::NodeId structure : scene.structuresBelow(m_session.selection()))
    if (!hasLabel(scene, structure))
      structures.push_back(structure);
  const LabelWish wish = m_labels.wish();
  const render::Screen screen = render::Screen(m_view.camera(), wish.size / wish.pixelsPerMm)
                                    .onDark(wish.style.ground == render::Background::dark);
  m_queue.add([this, scene, structures, screen, opening = m_session.document().opening](
                  const std::stop_token& stop) -> BackgroundQueue::Sequel {
    return [this, opening, found = labelsFor(scene, structures, screen, stop)] {
      take(found, opening);
    };
  });
}

void LabelActions::take(const std::vector<model::Annotation>& found, int opening) {
  if (opening != m_session.document().opening)
    return;
  const std::string tag = typedLanguage(m_labels.style());
  model::Edited all{m_session.scene(), false};
  int count = 0;
  for (const model::Annotation& place : found) {
    const QString name = offeredText(m_session, *structureOf(place), tag);
    model::Edited next = model::withAnnotationMade(
        all.scene, withFirstText(m_session, place, tag, name), m_labels.currentView());
    count += next.changed ? 1 : 0;
    all = {std::move(next.scene), all.changed || next.changed};
  }
  m_session.apply(tr("Add %n labels", nullptr, count), std::move(all));
  const QString apart = count > 0 ? notInAllViews() : QString();
  const QString added = tr("%n labels added", nullptr, count);
  m_saidOfAdded = count == 0 ? tr("What is selected has labels already, or is not in the picture")
                  : apart.isEmpty() ? added
                                    : added + QStringLiteral("; ") + apart;
  m_window.statusBar()->showMessage(m_saidOfAdded, readable);
  const std::vector<model::Annotation>& annotations = m_session.scene().annotations();
  m_added.clear();
  for (auto it = annotations.end() - count; it != annotations.end(); ++it)
    m_added.push_back(it->id);
}

void LabelActions::tellOfAdded() {
  const LabelSheet* sheet = m_labels.layer().sheet();
  if (m_added.empty() || !sheet)
    return;
  int without = 0;
  for (const model::AnnotationId id : m_added) {
    const auto sight = m_labels.sights().find(id.value);
    const bool known = sight != m_labels.sights().end();
    if (!known && !sheet->plate.layout.find(id))
      return;  // its picture is still to come
    without += known && sight->second == LabelSight::withoutRoom ? 1 : 0;
  }
  m_added.clear();
  if (without > 0)
    m_window.statusBar()->showMessage(
        m_saidOfAdded + QStringLiteral("; ") +
            tr("%n have no room in this picture: the panel Labels says which", nullptr, without),
        readable);
}

void LabelActions::tellOfMade() {
  const model::Annotation* made =
      m_made ? model::findAnnotation(m_session.scene(), *m_made) : nullptr;
  const LabelSheet* sheet = m_labels.layer().sheet();
  const auto sight = made ? m_labels.sights().find(made->id.value) : m_labels.sights().end();
  if (sight != m_labels.sights().end())
    m_window.statusBar()->showMessage(sightText(sight->second, *made), readable);
  else if (made && (!sheet || !sheet->plate.layout.find(made->id)))
    return;  // its picture is still to come
  m_made.reset();
}

QString LabelActions::notInAllViews() const {
  const model::Scene& scene = m_session.scene();
  if (scene.annotations().empty())
    return {};
  const std::size_t showing = model::viewsShowing(scene, scene.annotations().back().id).size();
  return showing == scene.views().size()
             ? QString()
             : tr("shown in %1 of %2 saved views: the panel Labels says in which")
                   .arg(QLocale().toString(qulonglong(showing)),
                        QLocale().toString(qulonglong(scene.views().size())));
}

}  // namespace sline::widgets

#include "moc_label_actions.cpp"
