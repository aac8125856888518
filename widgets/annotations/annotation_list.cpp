// SPDX-License-Identifier: Apache-2.0
#include "widgets/annotations/annotation_list.h"

#include <QGuiApplication>
#include <QLocale>
#include <QPalette>
#include <algorithm>

#include "model/edit/annotations.h"
#include "widgets/annotations/annotation_texts.h"
#include "widgets/session/names_by_language.h"

namespace sline::widgets {

namespace {
/// Escapes the text, which may look like HTML but is none.
QString tip(const QString& text) {
  return QStringLiteral("<p>%1</p>").arg(text.toHtmlEscaped());
}
}  // namespace

AnnotationList::AnnotationList(Session& session, QObject* parent)
    : QAbstractTableModel(parent), m_session(session) {
  connect(&session, &Session::documentChanged, this, &AnnotationList::documentChange);
  connect(&session.names(), &DisplayNames::changed, this, &AnnotationList::allChanged);
}

void AnnotationList::setLanguage(const std::string& tag) {
  if (tag == m_language)
    return;
  m_language = tag;
  emit headerDataChanged(Qt::Horizontal, text, text);
  allChanged();
}

void AnnotationList::setSights(LabelSightsById sights) {
  if (sights == m_sights)
    return;
  m_sights = std::move(sights);
  allChanged();
}

QString AnnotationList::sightOf(const model::Annotation& annotation) const {
  const auto found = m_sights.find(annotation.id.value);
  return found == m_sights.end() || !annotation.visible ? QString()
                                                        : sightText(found->second, annotation);
}

void AnnotationList::allChanged() {
  if (rowCount() > 0)
    emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount_ - 1));
}

void AnnotationList::documentChange(const Document& before, const Document& now) {
  const auto& old = before.scene.annotations();
  const auto& annotations = now.scene.annotations();
  if (old == annotations && before.scene.nodes() == now.scene.nodes())
    return;
  const bool sameRows = before.opening == now.opening &&
                        std::equal(old.begin(), old.end(), annotations.begin(), annotations.end(),
                                   [](const auto& a, const auto& b) { return a.id == b.id; });
  if (sameRows) {
    allChanged();
    return;
  }
  beginResetModel();
  endResetModel();
}

const model::Annotation* AnnotationList::at(int row) const {
  const auto& annotations = m_session.scene().annotations();
  return row >= 0 && row < int(annotations.size()) ? &annotations[std::size_t(row)] : nullptr;
}

int AnnotationList::rowOf(std::optional<model::AnnotationId> id) const {
  const auto& annotations = m_session.scene().annotations();
  const auto found = std::find_if(annotations.begin(), annotations.end(),
                                  [id](const auto& annotation) { return annotation.id == id; });
  return found == annotations.end() ? -1 : int(found - annotations.begin());
}

int AnnotationList::numberOf(int row) const {
  const auto& annotations = m_session.scene().annotations();
  return int(std::count_if(annotations.begin(), annotations.begin() + row + 1,
                           [](const auto& annotation) { return annotation.visible; }));
}

int AnnotationList::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(m_session.scene().annotations().size());
}

int AnnotationList::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(columnCount_);
}

QVariant AnnotationList::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
    return {};
  switch (section) {
    case number:
      return tr("No.");
    case text:
      return m_language.empty()
                 ? tr("Says (scene’s own)")
                 : tr("Says (%1)").arg(languageName(QString::fromStdString(m_language)));
    case kind:
      return tr("Kind");
    default:
      return tr("Points at");
  }
}

QVariant AnnotationList::data(const QModelIndex& index, int role) const {
  const model::Annotation* annotation = at(index.row());
  if (!annotation)
    return {};
  if (role == Qt::CheckStateRole && index.column() == number)
    return annotation->visible ? Qt::Checked : Qt::Unchecked;
  if (role == Qt::EditRole && index.column() == text)
    return wordsIn(*annotation, m_language);
  const QString sight = sightOf(*annotation);
  if (role == Qt::ToolTipRole && index.column() == number)
    return !annotation->visible ? tr("Not shown") : sight.isEmpty() ? tr("Shown") : sight;
  if (role == Qt::ForegroundRole && !sight.isEmpty())
    return QGuiApplication::palette().brush(QPalette::Disabled, QPalette::Text);
  if (role != Qt::DisplayRole && role != Qt::ToolTipRole)
    return {};
  switch (index.column()) {
    case number:
      return annotation->visible ? QLocale().toString(numberOf(index.row())) : QString();
    case text:
      return role == Qt::ToolTipRole ? tip(shownText(m_session.scene(), *annotation, m_language))
                                     : shownText(m_session.scene(), *annotation, m_language);
    case kind:
      return kindText(annotation->kind);
    default:
      return role == Qt::ToolTipRole ? tip(placeText(m_session, *annotation))
                                     : placeText(m_session, *annotation);
  }
}

Qt::ItemFlags AnnotationList::flags(const QModelIndex& index) const {
  const Qt::ItemFlags plain = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  return index.column() == number ? plain | Qt::ItemIsUserCheckable
         : index.column() == text ? plain | Qt::ItemIsEditable
                                  : plain;
}

bool AnnotationList::setData(const QModelIndex& index, const QVariant& value, int role) {
  const model::Annotation* there = at(index.row());
  if (!there)
    return false;
  model::Annotation annotation = *there;
  QString step = tr("Change What a Label Says");
  if (role == Qt::CheckStateRole && index.column() == number) {
    annotation.visible = value.toInt() == Qt::Checked;
    step = annotation.visible ? tr("Show Label") : tr("Hide Label");
  } else if (role == Qt::EditRole && index.column() == text) {
    const QString words = value.toString().trimmed();
    if (words.isEmpty() || words == wordsIn(annotation, m_language))
      return false;
    annotation = withText(annotation, m_language, words);
  } else {
    return false;
  }
  return m_session.apply(
      step, model::withAnnotationChanged(m_session.scene(), annotation.id, annotation));
}

}  // namespace sline::widgets

#include "moc_annotation_list.cpp"
