// SPDX-License-Identifier: Apache-2.0
#include "widgets/window/sides_actions.h"

#include <QAction>
#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <algorithm>
#include <array>

#include "model/scene/known_frame.h"
#include "widgets/session/other_sides.h"
#include "widgets/text/told.h"

namespace sline::widgets {

namespace {

constexpr std::array<const char*, 3> answerActions{"sidesRight", "sidesMirror", "sidesTurn"};

QAction& actionOf(const WindowActions& actions, model::SideAnswer answer) {
  return actions[QLatin1String(answerActions[std::size_t(answer)])];
}

}  // namespace

SidesActions::SidesActions(Session& session, const WindowActions& actions, QGridLayout& centre,
                           QObject* parent)
    : QObject(parent), m_session(session), m_actions(actions) {
  makeBar(centre);
  for (const auto answer :
       {model::SideAnswer::right, model::SideAnswer::mirror, model::SideAnswer::turn})
    connect(&actionOf(actions, answer), &QAction::triggered, this,
            [this, answer] { settle(answer); });
  connect(&session, &Session::documentChanged, this, &SidesActions::showState);
  connect(&session.otherSides(), &OtherSides::changed, this, &SidesActions::showState);
  showState();
}

SidesActions::~SidesActions() {
  delete m_bar;
}

void SidesActions::makeBar(QGridLayout& centre) {
  m_bar = new QFrame;
  m_bar->setFrameShape(QFrame::StyledPanel);
  m_bar->setObjectName(QStringLiteral("sidesBar"));
  m_bar->setAccessibleName(tr("Left and right"));
  m_question = new QLabel;
  m_question->setObjectName(QStringLiteral("sidesQuestion"));
  m_question->setWordWrap(true);
  m_question->setTextFormat(Qt::PlainText);
  auto* row = new QHBoxLayout(m_bar);
  row->setContentsMargins(10, 4, 6, 4);
  row->addWidget(m_question, 1);
  const auto addButton = [&](model::SideAnswer answer, const QString& text) {
    QAction& action = actionOf(m_actions, answer);
    auto* button = new QPushButton(text);
    button->setObjectName(action.objectName() + QStringLiteral("Button"));
    button->setToolTip(action.statusTip());
    connect(button, &QPushButton::clicked, &action, &QAction::trigger);
    row->addWidget(button);
    m_answers[std::size_t(answer)] = button;
  };
  addButton(model::SideAnswer::right, tr("Sides are right"));
  addButton(model::SideAnswer::mirror, tr("Mirror"));
  addButton(model::SideAnswer::turn, tr("Turn"));
  auto* close = new QToolButton;
  close->setObjectName(QStringLiteral("closeSidesBar"));
  close->setText(QStringLiteral("✕"));
  close->setAutoRaise(true);
  close->setAccessibleName(tr("Ask later"));
  close->setToolTip(tr("Ask later: the menu Edit has the same answers"));
  connect(close, &QToolButton::clicked, this, [this] {
    m_closedFor = m_session.document().opening;
    showState();
  });
  row->addWidget(close);
  centre.addWidget(m_bar, centre.rowCount(), 0);
}

void SidesActions::settle(model::SideAnswer answer) {
  const bool names = !model::hasDoubtedSides(m_session.scene());
  const QString step = answer == model::SideAnswer::right
                           ? (names ? tr("Names are right") : tr("Sides are right"))
                       : answer == model::SideAnswer::mirror ? tr("Mirror left and right")
                                                             : tr("Turn about the body's axis");
  const bool moved = answer != model::SideAnswer::right;
  if (m_session.apply(step, model::withSidesSettled(m_session.scene(), answer)) && moved)
    m_actions[QStringLiteral("fit")].trigger();
}

QString SidesActions::question() const {
  const auto& nodes = m_session.scene().nodes();
  const auto first = std::find_if(nodes.begin(), nodes.end(), [](const model::Node& node) {
    return !node.isGroup() && !node.provenance.evidence.isSure();
  });
  const bool conflict =
      first != nodes.end() && first->provenance.evidence.sides == model::Evidence::conflict;
  const QString what =
      model::isOnlyUpDoubted(m_session.scene())
          ? tr("Nothing tells that z leads to the head; it was assumed.")
      : model::isOnlyFrontDoubted(m_session.scene())
          ? tr("Front and back are not certain: names tell left and right alone.")
      : conflict ? tr("Left and right are not certain: names or places contradict the frame.")
                 : tr("Left and right are not certain: they were assumed.");
  if (first == nodes.end())
    return what;
  return what + QLatin1Char(' ') +
         tr("Read as %1 (%2).")
             .arg(QString::fromStdString(first->provenance.frame),
                  told(first->provenance.frameReason));
}

void SidesActions::showState() {
  const model::Scene& scene = m_session.scene();
  const bool doubted = model::hasDoubtedSides(scene);
  const auto& nodes = scene.nodes();
  const auto sided = [](const model::Node& node) {
    return !node.isGroup() && node.provenance.frame != model::fileFrame;
  };
  const auto frontDoubted = [](const model::Node& node) {
    return !node.isGroup() && !model::isSure(node.provenance.evidence.front);
  };
  const bool any = std::any_of(nodes.begin(), nodes.end(), sided);
  const bool names = !doubted && model::hasDoubtedNames(scene);
  actionOf(m_actions, model::SideAnswer::right).setEnabled(doubted || names);
  actionOf(m_actions, model::SideAnswer::mirror).setEnabled(any);
  actionOf(m_actions, model::SideAnswer::turn).setEnabled(any);
  const std::string& other = m_session.otherSides().text();
  for (QPushButton* answer : m_answers)
    answer->setVisible(doubted);
  QPushButton& right = *m_answers[std::size_t(model::SideAnswer::right)];
  right.setVisible(doubted || names);
  right.setText(names ? tr("Names are right") : tr("Sides are right"));
  m_answers[std::size_t(model::SideAnswer::mirror)]->setVisible(doubted &&
                                                                !model::isOnlyUpDoubted(scene));
  m_answers[std::size_t(model::SideAnswer::turn)]->setVisible(
      std::any_of(nodes.begin(), nodes.end(), frontDoubted) && !model::isOnlyFrontDoubted(scene));
  QStringList says;
  if (doubted)
    says << question();
  if (!other.empty())
    says << told(other) + QLatin1Char('.');
  if (names && !other.empty())
    says << tr("Labels show such names with a question mark, and no question asks for them.");
  if (!says.isEmpty())
    m_question->setText(says.join(QLatin1Char('\n')));
  m_bar->setVisible(!says.isEmpty() && m_closedFor != m_session.document().opening);
}

}  // namespace sline::widgets

#include "moc_sides_actions.cpp"
