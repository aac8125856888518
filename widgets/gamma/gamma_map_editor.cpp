// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/gamma_map_editor.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "model/edit/look.h"
#include "model/edit/painting.h"
#include "widgets/gamma/gamma_curve.h"
#include "widgets/gamma/selected_looks.h"

namespace sline::widgets {

namespace {

/// Returns what distances are measured to at first: what is in focus, else a structure that is
/// shown and not selected.
std::vector<model::NodeId> firstTargets(const model::Scene& scene, const NodeIds& selected) {
  const auto isSelected = [&](model::NodeId id) {
    return std::any_of(selected.begin(), selected.end(),
                       [&](model::NodeId each) { return scene.isBelow(id, each); });
  };
  std::vector<model::NodeId> targets = scene.focus().targets;
  std::erase_if(targets, [&](model::NodeId id) { return isSelected(id) || !scene.find(id); });
  if (!targets.empty())
    return targets;
  const std::vector<model::ResolvedStyle> styles = model::resolveAll(scene);
  for (std::size_t i = 0; i < styles.size(); ++i) {
    const model::Node& node = scene.nodes()[i];
    if (!node.isGroup() && styles[i].visible && !isSelected(node.id))
      return {node.id};
  }
  return {};
}

}  // namespace

void TargetBox::showPopup() {
  emit aboutToOpen();
  QComboBox::showPopup();
}

GammaMapEditor::GammaMapEditor(Session& session, QWidget* parent)
    : StyleEditor(session, QStringLiteral("gammaMap"), tr("Γ over the surface"), parent),
      m_scalar(new QComboBox),
      m_from(new QWidget),
      m_target(new TargetBox),
      m_paint(new QPushButton(tr("Paint…"))),
      m_curve(new GammaCurve) {
  setToolTip(tr("Lets Γ vary from place to place on a structure"));
  m_scalar->setObjectName(QStringLiteral("gammaMapScalar"));
  m_scalar->setAccessibleName(text());
  m_scalar->addItem(tr("The same everywhere"));
  m_scalar->addItem(tr("By cavities"));
  m_scalar->addItem(tr("By curvature"));
  m_scalar->addItem(tr("By distance"));
  m_scalar->addItem(tr("By painting"));
  m_scalar->setPlaceholderText(tr("Several"));
  m_scalar->setToolTip(
      tr("Cavities: how much of its own sky the surface hides, 0 to 1. Curvature: 1 on a ball, "
         "negative in hollows. Distance: millimetres from another structure. Painting: what "
         "you paint in the picture, 0 to 1"));
  m_target->setObjectName(QStringLiteral("gammaMapTarget"));
  m_target->setAccessibleName(tr("Distance from"));
  m_target->setToolTip(tr("The structure or group from which distances are measured"));
  m_target->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_target->setMinimumContentsLength(10);
  m_paint->setObjectName(QStringLiteral("gammaMapPaint"));
  m_paint->setToolTip(tr("Paint in the picture with a brush"));
  m_curve->setObjectName(QStringLiteral("gammaMapCurve"));
  layOut();
  connectValues();
}

void GammaMapEditor::layOut() {
  auto* first = new QHBoxLayout;
  first->setSpacing(8);
  first->addWidget(&label(), 1);
  first->addWidget(&resetButton());
  label().setBuddy(m_scalar);
  auto* from = new QHBoxLayout(m_from);
  from->setContentsMargins(0, 0, 0, 0);
  from->setSpacing(8);
  auto* caption = new QLabel(tr("Distance from"));
  caption->setBuddy(m_target);
  from->addWidget(caption);
  from->addWidget(m_target, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addLayout(first);
  layout->addWidget(m_scalar);
  layout->addWidget(m_from);
  layout->addWidget(m_paint, 0, Qt::AlignLeft);
  layout->addWidget(m_curve);
}

void GammaMapEditor::connectValues() {
  connect(m_scalar, &QComboBox::activated, this,
          [this](int place) { chooseScalar(model::GammaScalar(place)); });
  connect(m_target, &TargetBox::aboutToOpen, this, &GammaMapEditor::listTargets);
  connect(m_target, &QComboBox::activated, this, [this](int place) {
    m_map.targets = {model::NodeId{m_target->itemData(place).toULongLong()}};
    apply(drawn());
  });
  connect(m_paint, &QPushButton::clicked, this, &GammaMapEditor::brushWanted);
  connect(&resetButton(), &QToolButton::clicked, this,
          [this] { inherit({.gammaMap = model::GammaMap()}); });
  connect(m_curve, &GammaCurve::changed, this, [this] { apply(drawn()); });
  connect(m_curve, &GammaCurve::dragged, this, [this] {
    session().preview(
        model::withLook(session().sceneBeforePreview(), session().selection(), drawn()).scene);
  });
  connect(m_curve, &GammaCurve::dragFinished, this, [this] {
    session().commitPreview(lookStepName(text(), session(), session().selection()));
  });
  connect(m_curve, &GammaCurve::dragCancelled, this, [this] {
    session().cancelPreview();
    showSelection();
  });
}

model::Style GammaMapEditor::drawn() const {
  model::GammaMap map = m_map;
  map.curve = m_curve->points();
  return {.gammaMap = map};
}

void GammaMapEditor::chooseScalar(model::GammaScalar scalar) {
  m_map = {.scalar = scalar, .targets = {}, .curve = model::usualCurve(scalar)};
  if (scalar == model::GammaScalar::distance)
    m_map.targets = firstTargets(session().scene(), session().selection());
  const std::vector<model::ResolvedStyle> looks = looksOf(session().scene(), session().selection());
  if (scalar == model::GammaScalar::painted && !looks.empty())
    m_map.curve = model::firstPaintedCurve(looks.front().gamma);
  apply({.gammaMap = m_map});
  if (scalar == model::GammaScalar::painted)
    emit brushWanted();
}

void GammaMapEditor::listTargets() {
  const QSignalBlocker quiet(m_target);
  m_target->clear();
  for (const model::Node& node : session().scene().nodes())
    m_target->addItem(session().names().shown(node.name), qulonglong(node.id.value));
  if (m_map.targets.size() == 1)
    m_target->setCurrentIndex(m_target->findData(qulonglong(m_map.targets.front().value)));
  else
    m_target->setCurrentIndex(-1);
}

void GammaMapEditor::showTargets() {
  const QSignalBlocker quiet(m_target);
  m_target->clear();
  const model::Node* only =
      m_map.targets.size() == 1 ? session().scene().find(m_map.targets.front()) : nullptr;
  m_target->setPlaceholderText(
      m_map.targets.empty() ? tr("Nothing") : tr("%n items", nullptr, int(m_map.targets.size())));
  if (only)
    m_target->addItem(session().names().shown(only->name), qulonglong(only->id.value));
  m_target->setCurrentIndex(only ? 0 : -1);
}

void GammaMapEditor::showSelection() {
  const std::vector<model::ResolvedStyle> looks = looksOf(session().scene(), session().selection());
  if (looks.empty())
    return;
  m_map = looks.front().gammaMap;
  const bool mixed = std::any_of(looks.begin(), looks.end(),
                                 [&](const auto& look) { return look.gammaMap != m_map; });
  const bool varies = !mixed && m_map.scalar != model::GammaScalar::none;
  m_scalar->setCurrentIndex(mixed ? -1 : int(m_map.scalar));
  m_from->setVisible(varies && m_map.scalar == model::GammaScalar::distance);
  m_paint->setVisible(varies && m_map.scalar == model::GammaScalar::painted);
  m_curve->setVisible(varies);
  if (varies) {
    showTargets();
    m_curve->showCurve(m_map.scalar, m_map.curve);
  }
  resetButton().setEnabled(
      anyBelowSays(session().scene(), session().selection(),
                   [](const model::Style& style) { return style.gammaMap.has_value(); }));
}

}  // namespace sline::widgets

#include "moc_gamma_map_editor.cpp"
