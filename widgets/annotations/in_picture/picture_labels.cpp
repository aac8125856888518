// SPDX-License-Identifier: Apache-2.0
#include "widgets/annotations/in_picture/picture_labels.h"

#include <QKeyEvent>
#include <algorithm>
#include <array>

#include "model/camera/camera_moves.h"
#include "model/edit/annotations.h"
#include "model/scene/cut_place.h"
#include "render/lettering/fitted_sides.h"
#include "render/lettering/label_style.h"
#include "widgets/annotations/annotation_texts.h"
#include "widgets/annotations/in_picture/presented_letters.h"
#include "widgets/annotations/label_preferences.h"
#include "widgets/session/names_by_language.h"
#include "widgets/viewport/tools/points.h"

namespace sline::widgets {

namespace {

/// The page's height at which letters of 10 pt have the height of one of the lines.
constexpr float presentedPageMm = float(presentedLines) * 10.0f * render::millimetresPerPoint;

QString stepOf(model::AnnotationKind kind) {
  switch (kind) {
    case model::AnnotationKind::callout:
      return PictureLabels::tr("Add Callout");
    case model::AnnotationKind::pin:
      return PictureLabels::tr("Add Pin");
    case model::AnnotationKind::distance:
      return PictureLabels::tr("Add Distance");
    default:
      return PictureLabels::tr("Add Label");
  }
}

/// Returns the anchors of a label at the place: one on a cut face belongs to what was cut.
std::vector<model::Anchor> anchorsAt(const model::Scene& scene, const render::Picks& picks) {
  if (!picks.anchor)
    return {};
  const auto* cut = std::get_if<glm::vec3>(&*picks.anchor);
  const model::Node* node = cut && picks.seen ? scene.find(picks.seen->id) : nullptr;
  return node ? model::anchorsOnCut(*node, *cut) : std::vector<model::Anchor>{*picks.anchor};
}

}  // namespace

PictureLabels::PictureLabels(Context place)
    : QObject(&place.picture),
      m_place(std::move(place)),
      m_style{.mode = render::LabelMode::on},
      m_layer(new LabelLayer(&m_place.picture)),
      m_tool(new LabelTool(
          m_place.session, *m_layer,
          [this](const glm::vec2& pixel, const LabelTool::Answer& answer) {
            Picker::Question question = m_place.question({double(pixel.x), double(pixel.y)});
            question.anchored = true;
            m_place.picker.ask(std::move(question), [this, answer](const render::Picks& picks) {
              answer(anchorsAt(m_place.session.scene(), picks));
            });
          },
          this)),
      m_editor(new LabelEditor(&m_place.picture)) {
  connect(m_editor, &LabelEditor::accepted, this, &PictureLabels::accept);
  connect(m_editor, &LabelEditor::cancelled, this, [this] {
    m_written.reset();
    showMarks();
  });
  Session& session = m_place.session;
  connect(&session, &Session::documentChanged, this, &PictureLabels::documentChange);
  connect(&session, &Session::activeAnnotationChanged, this, &PictureLabels::showMarks);
  // Del and F2 act on what was selected last.
  connect(&session, &Session::selectionChanged, this,
          [&session] { session.activateAnnotation(std::nullopt); });
}

void PictureLabels::setStyle(const render::LabelStyle& style) {
  const render::Background ground = m_style.ground;
  m_style = style;
  m_style.ground = ground;
  emit wishChanged();
}

void PictureLabels::setGround(render::Background ground) {
  // Labels are on a sheet of their own over the picture, in which halos cannot be gaps.
  m_style.ground = ground == render::Background::transparent ? render::Background::white : ground;
}

LabelWish PictureLabels::wish(bool moving) const {
  const QWidget& picture = m_place.picture;
  LabelWish wish{.style = m_style,
                 .size = {float(picture.width()), float(picture.height())},
                 .pixelsPerMm = float(picture.logicalDpiY()) / render::millimetresPerInch,
                 .ratio = picture.devicePixelRatioF(),
                 .document = m_place.session.document().opening,
                 .moving = moving,
                 .arrivals = m_arrivals};
  if (m_presented)
    wish.pixelsPerMm = std::max(wish.pixelsPerMm, wish.size.y / presentedPageMm);
  for (const QRectF& mark : m_place.marks())
    wish.style.reserved.push_back(
        {vec(mark.topLeft()) / wish.pixelsPerMm, vec(mark.bottomRight()) / wish.pixelsPerMm});
  return wish;
}

bool PictureLabels::arrive() {
  ++m_arrivals;
  return m_layer->sheet() && !m_layer->sheet()->empty();
}

bool PictureLabels::outgrown() const {
  const LabelSheet* sheet = m_layer->sheet();
  return sheet && !sheet->empty() && widgets::outgrown(sheet->settled, sheet->camera);
}

bool PictureLabels::waits() const {
  return m_layer->sheet() && m_layer->sheet()->waits();
}

model::FreeSides PictureLabels::sidesBeside(const model::Scene& scene,
                                            const model::Camera& camera) const {
  const LabelWish now = wish();
  const glm::vec2 size = now.size / now.pixelsPerMm;
  if (!(size.x > 0.0f) || !(size.y > 0.0f))
    return {};
  return render::sidesBesideLabels(scene, camera, size, now.style);
}

void PictureLabels::took(const LabelSheetPtr& sheet, const model::Camera& camera) {
  m_camera = camera;
  m_ready = sheet != nullptr;
  if (sheet)
    m_layer->show(sheet);
  else if (m_layer->sheet() && m_layer->sheet()->camera != camera)
    m_layer->show(nullptr);
  m_layer->setGeometry(m_place.picture.rect());
  showMarks();
  if (sheet && !sheet->wish.moving) {
    m_sights = sightsOf(*sheet);
    emit sighted();
  }
}

void PictureLabels::setShut(bool shut) {
  m_shut = shut;
  if (!shut)
    return;
  m_tool->cancel();
  m_editor->finish();
  make(std::nullopt);
  hover(std::nullopt);
}

void PictureLabels::make(std::optional<model::AnnotationKind> kind) {
  if (m_shut)
    kind.reset();
  m_begun.clear();
  showMarks();
  if (kind == m_making)
    return;
  m_making = kind;
  emit makingChanged();
}

void PictureLabels::setCurrentView(std::function<std::optional<std::size_t>()> current) {
  m_currentView = std::move(current);
}

std::optional<std::size_t> PictureLabels::currentView() const {
  const std::optional<std::size_t> view = m_currentView ? m_currentView() : std::nullopt;
  return view && *view < m_place.session.scene().views().size() ? view : std::nullopt;
}

bool PictureLabels::click(const QPointF& at) {
  if (!m_making || m_shut)
    return false;
  Picker::Question question = m_place.question(at);
  question.anchored = true;
  m_place.picker.ask(std::move(question),
                     [this, at](const render::Picks& picks) { clicked(picks, at); });
  return true;
}

void PictureLabels::clicked(const render::Picks& picks, const QPointF& at) {
  if (!m_making)
    return;
  if (!picks.anchor) {
    emit missed();
    return;
  }
  if (*m_making != model::AnnotationKind::distance) {
    const QString name = offeredText(m_place.session, picks.seen->id, typedLanguage(m_style));
    begin({.kind = *m_making, .anchors = anchorsAt(m_place.session.scene(), picks)}, name, at);
    return;
  }
  m_begun.push_back(*picks.anchor);
  if (m_begun.size() == model::anchorCount(model::AnnotationKind::distance))
    add({.kind = model::AnnotationKind::distance, .anchors = std::exchange(m_begun, {})});
  showMarks();
}

void PictureLabels::begin(model::Annotation annotation, const QString& offered, const QPointF& at) {
  m_editor->finish();
  constexpr int beside = 12;  // pixels, so that the labelled place stays in sight
  const bool lines = annotation.kind == model::AnnotationKind::callout;
  m_new = annotation.id == model::AnnotationId{};
  m_written = std::move(annotation);
  m_offered = offered;
  m_editor->open(at.toPoint() + QPoint(m_new ? beside : 0, 0),
                 {.text = offered,
                  .lines = lines,
                  .points = m_style.points,
                  .language = languageName(QString::fromStdString(typedLanguage(m_style)))});
  showMarks();
}

void PictureLabels::edit(model::AnnotationId id) {
  const model::Annotation* annotation = model::findAnnotation(m_place.session.scene(), id);
  if (!annotation || m_shut)
    return;
  const QRectF box = m_layer->sheet() ? boxOf(*m_layer->sheet(), id) : QRectF();
  begin(*annotation, wordsIn(*annotation, typedLanguage(m_style)),
        box.isEmpty() ? QRectF(m_place.picture.rect()).center()
                      : QPointF(box.left(), box.center().y()));
}

void PictureLabels::accept(const QString& text) {
  if (!m_written)
    return;
  model::Annotation written = *std::exchange(m_written, std::nullopt);
  showMarks();
  Session& session = m_place.session;
  const bool wordless =
      written.kind == model::AnnotationKind::pin || written.kind == model::AnnotationKind::distance;
  if (text.isEmpty() && !wordless)
    return;
  if (m_new) {
    // Whoever takes the structure's own name means all of it: other views may point elsewhere.
    written.found = !wordless && text == m_offered &&
                    std::holds_alternative<model::SurfacePoint>(written.anchors.front());
    add(withFirstText(session, written, typedLanguage(m_style), text));
    return;
  }
  const model::Annotation* now = model::findAnnotation(session.scene(), written.id);
  if (now && text != wordsIn(*now, typedLanguage(m_style)))
    session.apply(tr("Change What a Label Says"),
                  model::withAnnotationChanged(session.scene(), written.id,
                                               withText(*now, typedLanguage(m_style), text)));
}

void PictureLabels::add(const model::Annotation& annotation) {
  Session& session = m_place.session;
  if (!session.apply(stepOf(annotation.kind),
                     model::withAnnotationMade(session.scene(), annotation, currentView())))
    return;
  const model::AnnotationId id = session.scene().annotations().back().id;
  session.activateAnnotation(id);
  emit made(id);
}

void PictureLabels::remove(model::AnnotationId id) {
  Session& session = m_place.session;
  session.apply(tr("Delete Label"), model::withoutAnnotations(session.scene(), std::array{id}));
}

bool PictureLabels::doubleClick(const QPointF& at) {
  const std::optional<LabelGrip> grip = m_shut ? std::nullopt : m_tool->gripAt(vec(at));
  if (!grip)
    return false;
  m_place.session.activateAnnotation(grip->id);
  edit(grip->id);
  return true;
}

bool PictureLabels::wants(const QKeyEvent& key) const {
  const bool plain = key.modifiers() == Qt::NoModifier || key.modifiers() == Qt::KeypadModifier;
  if (!plain || m_shut)
    return false;
  const bool active = m_place.session.activeAnnotation().has_value();
  switch (key.key()) {
    case Qt::Key_Delete:
    case Qt::Key_F2:
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return active;
    case Qt::Key_Escape:
      return active || m_making;
    default:
      return false;
  }
}

bool PictureLabels::press(const QKeyEvent& key) {
  if (!wants(key))
    return false;
  const std::optional<model::AnnotationId> active = m_place.session.activeAnnotation();
  if (key.key() == Qt::Key_Escape) {
    // Each press goes one step back.
    if (!m_begun.empty())
      make(m_making);
    else if (m_making)
      make(std::nullopt);
    else
      m_place.session.activateAnnotation(std::nullopt);
  } else if (key.key() == Qt::Key_Delete) {
    remove(*active);
  } else {
    edit(*active);
  }
  return true;
}

void PictureLabels::hover(const std::optional<QPointF>& at) {
  m_mouse = at;
  showMarks();
}

std::optional<Qt::CursorShape> PictureLabels::cursor() const {
  const std::optional<model::AnnotationId>& over = m_layer->marks().hovered;
  const model::Annotation* annotation =
      over ? model::findAnnotation(m_place.session.scene(), *over) : nullptr;
  if (annotation)
    return annotation->locked ? Qt::PointingHandCursor : Qt::OpenHandCursor;
  return m_making ? std::optional(Qt::CrossCursor) : std::nullopt;
}

std::optional<glm::vec2> PictureLabels::begunAt() const {
  const bool typed = m_written && m_new;
  if (m_begun.empty() && !typed)
    return std::nullopt;
  const auto place =
      m_place.session.scene().placeOf(typed ? m_written->anchors.back() : m_begun.front());
  return place ? pixelOf(m_camera, *place, wish().size) : std::nullopt;
}

void PictureLabels::showMarks() {
  LabelLayer::Marks marks{.active = m_shut ? std::nullopt : m_place.session.activeAnnotation(),
                          .begun = begunAt()};
  if (m_mouse && !m_shut) {
    if (const std::optional<LabelGrip> grip = m_tool->gripAt(vec(*m_mouse)))
      marks.hovered = grip->id;
    if (!m_begun.empty())
      marks.mouse = vec(*m_mouse);
  }
  m_layer->mark(marks);
}

void PictureLabels::documentChange(const Document& before, const Document& now) {
  if (before.opening != now.opening) {
    m_written.reset();
    m_editor->cancel();
    m_tool->cancel();
    make(std::nullopt);
    m_layer->show(nullptr);
    m_sights.clear();
    emit sighted();
  }
  if (m_written && !m_new && !model::findAnnotation(now.scene, m_written->id)) {
    m_written.reset();
    m_editor->cancel();
  }
  std::erase_if(m_begun, [&now](const model::Anchor& anchor) {
    return !now.scene.placeOf(anchor).has_value();
  });
  showMarks();
}

}  // namespace sline::widgets

#include "moc_picture_labels.cpp"
