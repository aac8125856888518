// SPDX-License-Identifier: Apache-2.0
#include "widgets/focus/focus_context.h"

#include <QCoreApplication>
#include <QScopedValueRollback>
#include <QTimer>
#include <algorithm>

#include "model/disk/process.h"
#include "widgets/focus/role_texts.h"

namespace sline::widgets {

namespace {
/// The number of analyses that are remembered.
constexpr std::size_t mostRecords = 60;
constexpr int shortly = 50;  // milliseconds

QString amountStep(model::ContextAmount amount) {
  // lupdate does not know the class by its short name here.
  return QCoreApplication::translate("sline::widgets::FocusContext", "Context %1 %")
      .arg(qRound(100.0f * amount.value()));
}
}  // namespace

FocusContext::FocusContext(Session& session, CameraOf camera, QObject* parent)
    : QObject(parent), m_session(session), m_camera(std::move(camera)) {
  m_pool.setMaxThreadCount(1);
  connect(&session, &Session::documentChanged, this, &FocusContext::documentChange);
}

FocusContext::~FocusContext() {
  m_stop.request_stop();
  m_offerStop.request_stop();
  m_pool.waitForDone();
}

void FocusContext::focusOn(NodeIds targets) {
  if (!targets.empty())
    analyse(targets, m_state.analysis && m_state.analysis->camera.has_value(), tr("Focus"));
}

void FocusContext::setFromCamera(bool camera) {
  if (m_state.analysis)
    analyse(m_state.targets, camera, camera ? tr("Focus from this view") : tr("Focus all round"));
}

std::stop_token FocusContext::freshQuestion() {
  m_stop.request_stop();
  m_offerStop.request_stop();
  m_stop = std::stop_source();
  return m_stop.get_token();
}

void FocusContext::inBackground(std::function<void()> work) {
  m_pool.start([work = std::move(work)] {
    // A thread of the pool serves many questions, but lowers its priority only once.
    static thread_local const bool stoodBack = (model::standBack(), true);
    static_cast<void>(stoodBack);
    work();
  });
}

void FocusContext::analyse(const NodeIds& targets, bool fromCamera, const QString& step) {
  const std::stop_token stop = freshQuestion();
  const std::uint64_t question = ++m_asked;
  std::optional<model::Camera> camera;
  if (fromCamera)
    camera = m_camera();
  // The scene is a value, so a later change in the session cannot affect this question.
  inBackground([this, question, targets, camera, step, stop, forms = m_forms,
                scene = m_session.sceneBeforePreview()] {
    auto analysis = model::analysed(scene, {targets, camera}, *forms, stop);
    forms->trim();
    const Answer answer =
        analysis ? std::make_shared<const model::FocusAnalysis>(std::move(*analysis)) : nullptr;
    QMetaObject::invokeMethod(this, [=, this] { take(question, answer, targets, step); });
  });
  await(question);
}

void FocusContext::chooseLook(float aspect, std::size_t subject) {
  askForLook({.aspect = aspect, .subject = subject});
}

void FocusContext::openWith(const model::DrawingStyle& style, float aspect) {
  askForLook({.aspect = aspect, .opening = &style});
}

void FocusContext::askForLook(const LookQuestion& asked) {
  const std::stop_token stop = freshQuestion();
  m_subject = asked.subject;
  const std::uint64_t question = ++m_asked;
  inBackground([this, question, asked, stop, forms = m_forms, plain = undrawn(),
                scene = m_session.sceneBeforePreview()] {
    auto look =
        model::openingLook(plain, *forms, {.subject = asked.subject, .aspect = asked.aspect}, stop);
    if (look && asked.opening && asked.opening->styleOf)
      look->scene = model::withDrawingStyle(look->scene, *asked.opening, *forms,
                                            {.camera = look->camera}, stop)
                        .scene;
    forms->trim();
    const Look answer =
        look ? std::make_shared<const model::OpeningLook>(std::move(*look)) : nullptr;
    const bool opening = asked.opening != nullptr;
    QMetaObject::invokeMethod(this, [=, this] { takeLook(question, answer, scene, opening); });
  });
  await(question);
}

model::Scene FocusContext::undrawn() const {
  return model::withOwnColours(m_session.sceneBeforePreview());
}

void FocusContext::offerSubjects(float aspect, std::size_t count) {
  m_offerStop.request_stop();
  m_offerStop = std::stop_source();
  inBackground([this, aspect, count, from = m_subject, forms = m_forms, scene = undrawn(),
                stop = m_offerStop.get_token()] {
    const std::size_t all = model::subjectsOf(scene).size();
    for (std::size_t i = 1; i <= count && i < all; ++i) {
      const std::size_t subject = (from + i) % all;
      auto look = model::openingLook(scene, *forms, {.subject = subject, .aspect = aspect}, stop);
      if (!look)
        return;
      const Look offer = std::make_shared<const model::OpeningLook>(std::move(*look));
      QMetaObject::invokeMethod(this, [=, this] {
        if (!stop.stop_requested())
          emit subjectOffered(subject, offer);
      });
    }
  });
}

QString FocusContext::explanation(model::NodeId structure) const {
  if (!m_state.analysis)
    return {};
  for (model::Relation relation : m_state.analysis->relations) {
    if (relation.structure != structure)
      continue;
    if (const auto wish = m_state.wishes.roles.find(structure); wish != m_state.wishes.roles.end())
      relation.role = wish->second;
    // What was changed by hand afterwards is not the focus' doing.
    const model::Node* node = m_session.scene().find(structure);
    const model::Style drawn = model::contextStyle(relation, m_state.amount);
    const bool own = node && node->style.gamma == drawn.gamma && node->style.fill == drawn.fill &&
                     node->style.visible == drawn.visible;
    return own ? mannerText(relation, *drawn.visible) : tr("set by hand since");
  }
  return {};
}

void FocusContext::takeLook(std::uint64_t question, const Look& look, const model::Scene& asked,
                            bool opening) {
  if (question != m_awaited)
    return;
  await(0);
  // What the user did meanwhile counts more than a choice made for the scene as it was.
  if (!look || m_session.previewing() || !(m_session.scene() == asked))
    return;
  const model::Focus& focus = look->scene.focus();
  m_state = {.analysis = look->analysis,
             .targets = focus.targets,
             .amount = focus.amount,
             .wishes = focus.wishes};
  {
    const QScopedValueRollback applying(m_applying, true);
    model::Edited edited{look->scene, !(look->scene == asked)};
    if (opening)
      m_session.completeOpening(tr("Opening look"), std::move(edited));
    else
      m_session.apply(tr("Plate"), std::move(edited));
  }
  remember(look->analysis);
  emit lookChosen(*look);
  emit changed();
}

void FocusContext::await(std::uint64_t question) {
  const bool before = busy();
  m_awaited = question;
  if (busy() != before)
    emit busyChanged(busy());
}

void FocusContext::take(std::uint64_t question, const Answer& answer, const NodeIds& targets,
                        const QString& step) {
  if (question != m_awaited)
    return;
  if (m_session.previewing()) {  // a drag goes on first: it has its own step
    QTimer::singleShot(shortly, this, [=, this] { take(question, answer, targets, step); });
    return;
  }
  await(0);
  if (!answer) {
    emit failed(Error{.reason = tr("nothing is left to focus on").toStdString(),
                      .remedy = tr("Select something that no section takes away").toStdString()});
    return;
  }
  FocusState state = m_state;
  if (state.targets != targets)
    state.wishes = {};
  state.analysis = answer;
  state.targets = targets;
  apply(step, std::move(state));
}

model::Edited FocusContext::edited(const model::Scene& scene) const {
  return model::withFocusAndContext(scene, *m_state.analysis, m_state.amount, m_state.wishes);
}

void FocusContext::remember(const Answer& analysis) {
  if (!analysis)
    return;
  const int opening = m_session.document().opening;
  std::erase_if(m_records, [&](const Record& record) {
    return record.opening == opening && record.analysis->asked == analysis->asked &&
           record.analysis->camera == analysis->camera;
  });
  if (m_records.size() >= mostRecords)
    m_records.erase(m_records.begin());
  m_records.push_back({opening, analysis});
}

void FocusContext::apply(const QString& step, FocusState state, const QString& series,
                         const NodeIds& freed) {
  m_state = std::move(state);
  remember(m_state.analysis);
  {
    const QScopedValueRollback applying(m_applying, true);
    model::Edited after = edited(model::withoutHand(m_session.scene(), freed).scene);
    after.changed = !(after.scene == m_session.scene());
    m_session.apply(step, std::move(after), series);
  }
  emit changed();
}

void FocusContext::giveBack(const NodeIds& structures) {
  m_session.apply(tr("Back to the focus"), model::withoutHand(m_session.scene(), structures));
}

void FocusContext::setRoles(const NodeIds& structures, model::ContextRole role) {
  if (!m_state.analysis || structures.empty())
    return;
  FocusState state = m_state;
  for (const model::Relation& relation : state.analysis->relations)
    if (std::find(structures.begin(), structures.end(), relation.structure) != structures.end()) {
      if (relation.role == role)
        state.wishes.roles.erase(relation.structure);
      else
        state.wishes.roles[relation.structure] = role;
    }
  apply(tr("Role in the context"), std::move(state), {}, structures);
}

void FocusContext::setHiddenToo(bool too) {
  if (!m_state.analysis || m_state.wishes.hiddenToo == too)
    return;
  FocusState state = m_state;
  state.wishes.hiddenToo = too;
  apply(tr("Hidden structures in the context"), std::move(state));
}

void FocusContext::dragTo(model::ContextAmount amount) {
  if (!m_state.analysis)
    return;
  if (!m_dragging) {
    m_dragging = true;
    m_beforeDrag = m_state.amount;
  }
  m_state.amount = amount;
  const QScopedValueRollback applying(m_applying, true);
  m_session.preview(edited(m_session.sceneBeforePreview()).scene);
}

void FocusContext::finishDrag() {
  if (!m_dragging)
    return;
  m_dragging = false;
  {
    const QScopedValueRollback applying(m_applying, true);
    m_session.commitPreview(amountStep(m_state.amount));
  }
  emit changed();
}

void FocusContext::cancelDrag() {
  if (!m_dragging)
    return;
  m_dragging = false;
  m_state.amount = m_beforeDrag;
  {
    const QScopedValueRollback applying(m_applying, true);
    m_session.cancelPreview();
  }
  emit changed();
}

void FocusContext::stepTo(model::ContextAmount amount) {
  if (!m_state.analysis || amount == m_state.amount)
    return;
  FocusState state = m_state;
  state.amount = amount;
  apply(amountStep(amount), std::move(state), QStringLiteral("context amount"));
}

void FocusContext::documentChange(const Document& before, const Document& now) {
  // What is near a place is another focus already while the place is dragged.
  const bool another = before.opening != now.opening;
  const bool otherTargets = m_state.targets != now.scene.focus().targets;
  if (m_applying || (m_session.previewing() && !otherTargets))
    return;
  if (m_dragging) {  // the drag was ended elsewhere
    m_dragging = false;
    m_state.amount = m_beforeDrag;
  }
  if (!another && !otherTargets && before.scene.focus() == now.scene.focus())
    return;
  if (another) {
    m_stop.request_stop();
    m_offerStop.request_stop();
    await(0);
  }
  follow(now);
  emit changed();
}

void FocusContext::follow(const Document& now) {
  const model::Focus& focus = now.scene.focus();
  m_state = {.analysis = nullptr,
             .targets = focus.targets,
             .amount = focus.amount,
             .wishes = focus.wishes};
  if (focus.targets.empty())
    return;
  for (const Record& record : m_records)
    if (record.opening == now.opening && record.analysis->asked == focus.targets &&
        record.analysis->camera == focus.seenFrom)
      m_state.analysis = record.analysis;
  if (!m_state.analysis)
    analyseAgain();
}

void FocusContext::analyseAgain() {
  const std::stop_token stop = freshQuestion();
  const std::uint64_t question = ++m_asked;
  inBackground([this, question, stop, forms = m_forms, scene = m_session.sceneBeforePreview()] {
    const model::Focus& focus = scene.focus();
    auto analysis = model::analysed(scene, {focus.targets, focus.seenFrom}, *forms, stop);
    forms->trim();
    const Answer answer =
        analysis ? std::make_shared<const model::FocusAnalysis>(std::move(*analysis)) : nullptr;
    QMetaObject::invokeMethod(this, [=, this] {
      if (question != m_awaited)
        return;
      await(0);
      // A focus of which nothing is left stays without its context.
      m_state.analysis = answer;
      remember(answer);
      emit changed();
    });
  });
  await(question);
}

}  // namespace sline::widgets

#include "moc_focus_context.cpp"
