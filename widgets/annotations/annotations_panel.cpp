// SPDX-License-Identifier: Apache-2.0
#include "widgets/annotations/annotations_panel.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QScopedValueRollback>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>

#include "model/edit/annotations.h"
#include "widgets/annotations/annotation_list.h"
#include "widgets/annotations/annotation_texts.h"
#include "widgets/annotations/label_field.h"
#include "widgets/annotations/label_preferences.h"
#include "widgets/annotations/label_views.h"
#include "widgets/session/colour_dialog.h"
#include "widgets/session/names_by_language.h"

namespace sline::widgets {

namespace {

using model::AnnotationKind;

QIcon swatch(const std::optional<Colour>& colour, const QPalette& palette) {
  QPixmap pixmap(16, 16);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(palette.color(QPalette::ButtonText));
  painter.setBrush(colour ? QColor(colour->red, colour->green, colour->blue)
                          : palette.color(QPalette::ButtonText));
  painter.drawEllipse(QRectF(2.5, 2.5, 11.0, 11.0));
  return QIcon(pixmap);
}

}  // namespace

AnnotationsPanel::AnnotationsPanel(Session& session, Preferences& preferences, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_preferences(preferences),
      m_annotations(new AnnotationList(session, this)) {
  setObjectName(QStringLiteral("annotations"));
  makeList();
  makeSight();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->setSpacing(6);
  layout->addWidget(makeButtons());
  layout->addWidget(m_list, 1);
  layout->addWidget(m_sight);
  layout->addWidget(makeDetails());
  layout->addWidget(makePreferencesRow());
  connect(&session, &Session::documentChanged, this, &AnnotationsPanel::showActive);
  connect(&session, &Session::activeAnnotationChanged, this, &AnnotationsPanel::showActive);
  connect(&session.names(), &DisplayNames::changed, this, &AnnotationsPanel::followPreferences);
  connect(&preferences, &Preferences::changed, this, &AnnotationsPanel::followPreferences);
  followPreferences();
}

int AnnotationsPanel::heightOf(int lines) const {
  return lines * fontMetrics().lineSpacing() + 14;
}

const model::Annotation* AnnotationsPanel::active() const {
  return m_annotations->at(m_annotations->rowOf(m_session.activeAnnotation()));
}

void AnnotationsPanel::change(const QString& step, const model::Annotation& annotation,
                              const QString& series) {
  m_session.apply(step, model::withAnnotationChanged(m_session.scene(), annotation.id, annotation),
                  series);
}

std::vector<model::AnnotationId> AnnotationsPanel::chosen() const {
  std::vector<int> rows;
  for (const QModelIndex& index : m_list->selectionModel()->selectedRows())
    rows.push_back(index.row());
  std::sort(rows.begin(), rows.end());
  std::vector<model::AnnotationId> ids;
  for (const int row : rows)
    if (const model::Annotation* annotation = m_annotations->at(row))
      ids.push_back(annotation->id);
  if (const model::Annotation* annotation = active(); ids.empty() && annotation)
    ids.push_back(annotation->id);
  return ids;
}

void AnnotationsPanel::remove() {
  const std::vector<model::AnnotationId> ids = chosen();
  if (ids.empty())
    return;
  const int row = m_annotations->rowOf(ids.front());
  m_session.apply(ids.size() == 1 ? tr("Delete Label") : tr("Delete Labels"),
                  model::withoutAnnotations(m_session.scene(), ids));
  // The next label takes its place, so that a key held down deletes one after the other.
  const model::Annotation* next = m_annotations->at(std::min(row, m_annotations->rowCount() - 1));
  m_session.activateAnnotation(next ? std::optional(next->id) : std::nullopt);
}

bool AnnotationsPanel::eventFilter(QObject* watched, QEvent* event) {
  const bool shortcut = event->type() == QEvent::ShortcutOverride;
  if (!shortcut && event->type() != QEvent::KeyPress)
    return QWidget::eventFilter(watched, event);
  auto* key = static_cast<QKeyEvent*>(event);
  const bool enter = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
  // Del removes structures elsewhere in the window.
  if (watched == m_list && key->key() == Qt::Key_Delete) {
    if (shortcut)
      event->accept();
    else
      remove();
    return true;
  }
  const model::Annotation* annotation = active();
  if (watched == m_text && enter && !shortcut && annotation &&
      annotation->kind != AnnotationKind::callout) {
    m_list->setFocus();  // a label is one line
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void AnnotationsPanel::write() {
  const model::Annotation* there = active();
  if (m_following || !there)
    return;
  QString text = m_text->toPlainText();
  if (there->kind != AnnotationKind::callout)
    text.replace(QLatin1Char('\n'), QLatin1Char(' '));  // the text may have been pasted
  change(tr("Change What a Label Says"), withText(*there, m_annotations->language(), text),
         QStringLiteral("annotation-text-%1").arg(there->id.value));
}

void AnnotationsPanel::kindChosen(int row) {
  if (const model::Annotation* there = active()) {
    model::Annotation annotation = *there;
    annotation.kind = AnnotationKind(m_kind->itemData(row).toInt());
    change(tr("Kind of Label"), annotation);
  }
}

void AnnotationsPanel::setColour(const QString& step, std::optional<Colour> colour) {
  if (const model::Annotation* there = active()) {
    model::Annotation annotation = *there;
    annotation.colour = colour;
    change(step, annotation);
  }
}

void AnnotationsPanel::chooseColour() {
  const model::Annotation* there = active();
  if (!there)
    return;
  const Colour now = there->colour.value_or(Colour{});
  auto* dialog = makeColourDialog(m_session.names(), QColor(now.red, now.green, now.blue), this);
  dialog->setObjectName(QStringLiteral("annotationColourDialog"));
  dialog->setWindowTitle(tr("Colour of a Label"));
  // While it is open each colour shows at once; accepting makes the one undo step.
  connect(dialog, &QColorDialog::currentColorChanged, this,
          [this, id = there->id](const QColor& c) {
            const model::Scene& before = m_session.sceneBeforePreview();
            const model::Annotation* was = model::findAnnotation(before, id);
            if (!was)
              return;
            model::Annotation annotation = *was;
            annotation.colour =
                Colour{std::uint8_t(c.red()), std::uint8_t(c.green()), std::uint8_t(c.blue())};
            m_session.preview(model::withAnnotationChanged(before, id, annotation).scene);
          });
  connect(dialog, &QColorDialog::accepted, this,
          [this] { m_session.commitPreview(tr("Colour of a Label")); });
  connect(dialog, &QColorDialog::rejected, this, [this] { m_session.cancelPreview(); });
  dialog->open();
}

void AnnotationsPanel::followPreferences() {
  m_annotations->setLanguage(typedLanguage(labelStyle(m_preferences, m_session.names())));
  showActive();
}

void AnnotationsPanel::setSights(LabelSightsById sights) {
  m_annotations->setSights(std::move(sights));
  showSight();
}

void AnnotationsPanel::showSight() {
  const model::Annotation* annotation = active();
  const QString says = annotation ? m_annotations->sightOf(*annotation) : QString();
  m_sight->setText(says);
  m_sight->setVisible(!says.isEmpty());
}

void AnnotationsPanel::showChoices(const model::Annotation& annotation) {
  m_kind->clear();
  const bool distance = annotation.kind == AnnotationKind::distance;
  for (const AnnotationKind kind : {AnnotationKind::label, AnnotationKind::callout,
                                    AnnotationKind::pin, AnnotationKind::distance})
    if (distance == (kind == AnnotationKind::distance))
      m_kind->addItem(kindText(kind), int(kind));
  m_kind->setCurrentIndex(m_kind->findData(int(annotation.kind)));
  m_kind->setEnabled(!distance);
  m_colour->setIcon(swatch(annotation.colour, palette()));
  m_locked->setChecked(annotation.locked);
  m_release->setEnabled(annotation.offset.has_value());
  m_views->setLabels(chosen());
}

void AnnotationsPanel::showActive() {
  const QScopedValueRollback following(m_following, true);
  const int row = m_annotations->rowOf(m_session.activeAnnotation());
  const model::Annotation* annotation = m_annotations->at(row);
  if (row != m_list->currentIndex().row())
    m_list->setCurrentIndex(m_annotations->index(row, AnnotationList::text));
  showSight();
  m_remove->setEnabled(annotation);
  m_details->setEnabled(annotation);
  if (!annotation) {
    m_text->clear();
    m_text->setToolTip({});
    m_text->setLanguage({});
    m_text->setFixedHeight(heightOf(2));
    m_text->setHint(tr("Choose a label"));
    return;
  }
  // Where the language has no words, those of the scene's own language apply.
  const std::string& tag = m_annotations->language();
  const auto own = annotation->texts.find(tag);
  const QString text = QString::fromStdString(tag.empty()                      ? annotation->text
                                              : own == annotation->texts.end() ? std::string()
                                                                               : own->second);
  const bool callout = annotation->kind == AnnotationKind::callout;
  m_text->setMarkup(callout);
  m_text->setFixedHeight(heightOf(callout ? 5 : 2));
  m_text->setToolTip(callout ? LabelField::markupHint() : QString());
  m_text->setHint(plainWordsIn(*annotation, tag));
  m_text->setLanguage(languageName(QString::fromStdString(tag)));
  if (m_text->toPlainText() != text)
    m_text->setPlainText(text);
  showChoices(*annotation);
}

}  // namespace sline::widgets

#include "moc_annotations_panel.cpp"
