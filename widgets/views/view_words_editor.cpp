// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/view_words_editor.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QScopedValueRollback>

#include "model/edit/views.h"
#include "widgets/annotations/label_field.h"
#include "widgets/annotations/label_preferences.h"
#include "widgets/preferences/preference_control.h"
#include "widgets/views/view_caption.h"
#include "widgets/views/view_list.h"

namespace sline::widgets {

namespace {

constexpr int longestTitle = 200;
constexpr int fieldLines = 4;

/// Returns the words in that language alone, without falling back to the scene's own.
QString ownWords(const model::Wording& wording, const std::string& language) {
  if (language.empty())
    return QString::fromStdString(wording.text);
  const auto found = wording.texts.find(language);
  return found == wording.texts.end() ? QString() : QString::fromStdString(found->second);
}

}  // namespace

ViewWordsEditor::ViewWordsEditor(Session& session, Viewport& viewport, Preferences& preferences)
    : m_session(session),
      m_viewport(viewport),
      m_preferences(preferences),
      m_caption(new ViewCaption(viewport)) {
  setObjectName(QStringLiteral("viewWordsEditor"));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 2);
  grid->setSpacing(4);
  makeTitle(*grid);
  m_text = makeField("viewText", tr("What is to be read with the view"));
  m_text->setMarkup(true);
  m_text->setToolTip(LabelField::markupHint());
  m_notes = makeField("viewNotes", tr("Notes for who presents the view"));
  m_notes->setToolTip(tr("For you alone, while you present: no file for others has them") +
                      QLatin1Char('\n') + LabelField::linkHint());
  m_description = makeField("viewDescription", tr("What the view shows"));
  m_description->setToolTip(
      tr("For who does not see the picture: files for others have it, and without it they say what "
         "is seen"));
  grid->addWidget(m_text, 0, 1, 2, 1);
  grid->addWidget(m_notes, 0, 2, 2, 1);
  grid->setColumnStretch(0, 3);
  grid->setColumnStretch(1, 5);
  grid->addWidget(m_description, 0, 3, 2, 1);
  grid->setColumnStretch(2, 4);
  grid->setColumnStretch(3, 3);
  connect(m_title, &QLineEdit::textEdited, this,
          [this](const QString& text) { writeWording("title", &model::ViewWords::title, text); });
  connect(m_text, &QPlainTextEdit::textChanged, this,
          [this] { writeWording("text", &model::ViewWords::text, m_text->toPlainText()); });
  connect(m_notes, &QPlainTextEdit::textChanged, this,
          [this] { writeWording("notes", &model::ViewWords::notes, m_notes->toPlainText()); });
  connect(m_description, &QPlainTextEdit::textChanged, this, [this] {
    writeWording("description", &model::ViewWords::description, m_description->toPlainText());
  });
  connect(m_seconds, &QDoubleSpinBox::valueChanged, this, [this](double seconds) {
    if (const model::View* now = view(); now && !m_following) {
      model::ViewWords words = now->words;
      words.seconds = seconds > 0.0 ? std::optional(float(seconds)) : std::nullopt;
      write("seconds", words);
    }
  });
  connect(&session, &Session::documentChanged, this, &ViewWordsEditor::showWords);
  connect(&session.names(), &DisplayNames::changed, this, &ViewWordsEditor::showWords);
  connect(&preferences, &Preferences::changed, this, &ViewWordsEditor::showWords);
  viewport.installEventFilter(this);
  showWords();
}

ViewWordsEditor::~ViewWordsEditor() {
  if (!m_caption)
    return;  // the window is being destroyed, and the picture before it
  if (m_caption->isVisible())
    m_viewport.setPresented(false);
  delete m_caption;
}

void ViewWordsEditor::makeTitle(QGridLayout& grid) {
  m_title = new QLineEdit;
  m_title->setObjectName(QStringLiteral("viewTitle"));
  m_title->setAccessibleName(tr("Title of the view"));
  m_title->setToolTip(tr("What the view is called where it is shown, if that is not its name"));
  m_title->setMaxLength(longestTitle);
  m_seconds = new QDoubleSpinBox;
  m_seconds->setObjectName(QStringLiteral("viewSeconds"));
  m_seconds->setAccessibleName(tr("How long the view is shown"));
  m_seconds->setToolTip(tr("How long a film rests at the view; 0 for as long as at the others"));
  m_seconds->setRange(0.0, double(model::viewSecondsLimits.high));
  m_seconds->setDecimals(1);
  m_seconds->setKeyboardTracking(false);
  m_seconds->setSuffix(tr(" s", "seconds"));
  m_seconds->setSpecialValueText(tr("as others", "how long a view is shown"));
  QWidget* language = makePreferenceControl(m_preferences, QLatin1String(labelLanguageKey));
  language->setObjectName(QStringLiteral("viewLanguage"));
  if (auto* box = qobject_cast<QComboBox*>(language)) {
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(5);
  }
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  row->addWidget(language, 3);
  row->addWidget(m_seconds, 2);
  grid.addWidget(m_title, 0, 0);
  grid.addLayout(row, 1, 0);
}

LabelField* ViewWordsEditor::makeField(const char* name, const QString& says) {
  auto* field = new LabelField;
  field->setObjectName(QLatin1String(name));
  field->setAccessibleName(says);
  field->setTabChangesFocus(true);
  field->setFixedHeight(fieldLines * fontMetrics().lineSpacing() + 10);
  return field;
}

const model::View* ViewWordsEditor::view() const {
  const std::vector<model::View>& views = m_session.scene().views();
  return m_index >= 0 && std::size_t(m_index) < views.size() ? &views[std::size_t(m_index)]
                                                             : nullptr;
}

void ViewWordsEditor::setView(int index) {
  m_index = index;
  showWords();
}

void ViewWordsEditor::write(const char* field, const model::ViewWords& words) {
  m_session.apply(tr("Change What a View Says"),
                  model::withViewWords(m_session.scene(), std::size_t(m_index), words),
                  QStringLiteral("view-%1-%2").arg(QLatin1String(field)).arg(m_index));
}

void ViewWordsEditor::writeWording(const char* field, model::Wording model::ViewWords::*wording,
                                   const QString& text) {
  const model::View* now = view();
  if (m_following || !now)
    return;
  model::ViewWords words = now->words;
  (words.*wording).set(m_language, text.toStdString());
  write(field, words);
}

void ViewWordsEditor::showWords() {
  const QScopedValueRollback following(m_following, true);
  m_language = typedLanguage(labelStyle(m_preferences, m_session.names()));
  const model::View* now = view();
  setEnabled(now);
  const model::ViewWords words = now ? now->words : model::ViewWords();
  const QString title = ownWords(words.title, m_language);
  if (m_title->text() != title)
    m_title->setText(title);
  m_title->setPlaceholderText(!now ? tr("Choose a view")
                              : words.title.empty()
                                  ? shownName(*now)
                                  : QString::fromStdString(words.title.in(m_language)));
  m_seconds->setValue(double(words.seconds.value_or(0.0f)));
  const struct {
    LabelField& field;
    const model::Wording& wording;
    QString hint;
  } fields[] = {{*m_text, words.text, tr("Text, to be read with the view")},
                {*m_notes, words.notes, tr("Notes, for who presents it")},
                {*m_description, words.description, tr("Description, for who does not see it")}};
  for (const auto& each : fields) {
    const QString text = ownWords(each.wording, m_language);
    if (each.field.toPlainText() != text)
      each.field.setPlainText(text);
    const QString other = QString::fromStdString(each.wording.in(m_language));
    each.field.setHint(other.isEmpty() ? each.hint : other);
  }
  preview();
}

void ViewWordsEditor::preview() {
  if (!m_caption)
    return;  // the window is being destroyed, and the picture before it
  const model::View* now = view();
  if (!isVisible() || !now) {
    if (m_caption->isVisible()) {
      m_caption->say({}, ViewCaption::Place::foot);
      m_viewport.setPresented(false);
    }
    return;
  }
  const QRect before = m_caption->isVisible() ? m_caption->geometry() : QRect();
  m_caption->say(
      render::captionMarkup(now->words.title.in(m_language), now->words.text.in(m_language)),
      ViewCaption::Place::foot, m_viewport.fontMetrics().height());
  const QRect covered = m_caption->isVisible() ? m_caption->geometry() : QRect();
  if (covered != before)
    m_viewport.setPresented(false, covered);
}

bool ViewWordsEditor::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &m_viewport && event->type() == QEvent::Resize)
    preview();
  return QWidget::eventFilter(watched, event);
}

void ViewWordsEditor::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  preview();
}

void ViewWordsEditor::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  preview();
}

}  // namespace sline::widgets

#include "moc_view_words_editor.cpp"
