// SPDX-License-Identifier: Apache-2.0
#include "widgets/figure/figure_dialog.h"

#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "model/figure/figure_edit.h"
#include "render/export/figure/figure_checks.h"
#include "render/export/figure/figure_options.h"
#include "widgets/export/note_texts.h"
#include "widgets/export/option_form.h"
#include "widgets/figure/figure_preview.h"
#include "widgets/form/control.h"
#include "widgets/text/path_text.h"
#include "widgets/text/told.h"

namespace sline::widgets {

namespace {

constexpr int soonMs = 120;

QToolButton* button(const char* name, const QString& text, const QString& tip) {
  auto* made = new QToolButton;
  made->setObjectName(QLatin1String(name));
  made->setText(text);
  made->setToolTip(tip);
  made->setAccessibleName(tip);
  return made;
}

QFormLayout* emptied(QWidget& form) {
  delete form.layout();
  qDeleteAll(form.findChildren<QWidget*>(Qt::FindDirectChildrenOnly));
  auto* layout = new QFormLayout(&form);
  layout->setContentsMargins(0, 0, 0, 0);
  return layout;
}

/// Returns what the panels lack, as the window says it, the panels' names before it.
QStringList notesOf(const render::ComposedFigure& figure) {
  QStringList all;
  for (std::size_t i = 0; i < figure.panels.size(); ++i)
    for (const QString& text : noteTexts(figure.panels[i].plate.notes))
      all << FigureFields::nameOf(figure.plan.figure, i).simplified() + QStringLiteral(": ") + text;
  return all;
}

}  // namespace

/// What the background has drawn.
struct FigureDialog::Composed {
  int round = 0;
  std::optional<Error> error;
  std::shared_ptr<const render::ComposedFigure> figure;
  QImage page;
  std::vector<Error> faults;
};

FigureDialog::FigureDialog(OpenScene open, QWidget* parent)
    : QDialog(parent),
      m_open(open),
      m_desk(std::move(open)),
      m_page(FigureFields::ofPage()),
      m_preview(new FigurePreview),
      m_list(new QListWidget),
      m_panelForm(new QWidget),
      m_pageForm(new QWidget),
      m_told(new QLabel),
      m_add(button("figureAdd", tr("Add"), tr("Add a panel with a view"))),
      m_remove(button("figureRemove", tr("Remove"), tr("Remove the panel"))),
      m_up(button("figureUp", tr("Up"), tr("Move the panel up"))),
      m_down(button("figureDown", tr("Down"), tr("Move the panel down"))),
      m_export(new QPushButton(tr("&Export…"))),
      m_options(render::usualFigureOrder()),
      m_planned(m_options),
      m_writing(new FigureWriting) {
  setObjectName(QStringLiteral("figureDialog"));
  setWindowTitle(tr("Figure of Several Panels") + QStringLiteral("[*]"));
  auto* across = new QHBoxLayout;
  across->addWidget(m_preview, 1);
  across->addWidget(makeSide());
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(across, 1);
  layout->addWidget(makeBottom());
  m_soon.setSingleShot(true);
  m_soon.setInterval(soonMs);
  connect(&m_soon, &QTimer::timeout, this, &FigureDialog::compose);
  connect(m_preview, &FigurePreview::resized, this, [this] {
    if (m_drawn)
      m_soon.start();
  });
  connect(m_preview, &FigurePreview::chosen, this,
          [this](std::size_t panel) { m_list->setCurrentRow(int(panel)); });
  connect(m_preview, &FigurePreview::framed, this, &FigureDialog::addInset);
  connect(m_list, &QListWidget::currentRowChanged, this, &FigureDialog::chooseRow);
  connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, &FigureDialog::readAgain);
  connect(m_writing, &FigureWriting::ended, this, [this](const QString& words) {
    m_export->setEnabled(m_printable);
    m_told->setText(words);
  });
  showAll();
  m_list->setCurrentRow(0);
  resize(980, 620);
}

FigureDialog::~FigureDialog() {
  m_queue.drop();
}

QWidget* FigureDialog::makeSide() {
  auto* side = new QWidget;
  auto* layout = new QVBoxLayout(side);
  layout->addWidget(makePanels());
  auto* page = new QGroupBox(tr("Page"));
  auto* inPage = new QVBoxLayout(page);
  inPage->addWidget(m_pageForm);
  layout->addWidget(page);
  auto* file = new QGroupBox(tr("File"));
  auto* inFile = new QVBoxLayout(file);
  const render::OptionList options = render::figureOptions();
  auto* form = new OptionForm(m_options, {options.begin(), options.end()}, {});
  connect(form, &OptionForm::changed, this, &FigureDialog::optionsChanged);
  inFile->addWidget(form);
  layout->addWidget(file);
  layout->addStretch(1);
  auto* scroll = new QScrollArea;
  scroll->setWidget(side);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  fillForm(*emptied(*m_pageForm), m_page);
  scroll->setMinimumWidth(340);
  return scroll;
}

QWidget* FigureDialog::makePanels() {
  auto* panels = new QGroupBox(tr("Panels"));
  auto* layout = new QVBoxLayout(panels);
  m_list->setObjectName(QStringLiteral("figurePanels"));
  m_list->setAccessibleName(tr("Panels"));
  m_list->setMaximumHeight(130);
  layout->addWidget(m_list);
  auto* buttons = new QHBoxLayout;
  m_add->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(m_add);
  menu->setObjectName(QStringLiteral("figureAddMenu"));
  connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillAddMenu(*menu); });
  m_add->setMenu(menu);
  for (QToolButton* each : {m_add, m_remove, m_up, m_down})
    buttons->addWidget(each);
  buttons->addStretch(1);
  layout->addLayout(buttons);
  layout->addWidget(m_panelForm);
  connect(m_remove, &QToolButton::clicked, this,
          [this] { change(model::withoutPanel(figure(), std::size_t(m_list->currentRow()))); });
  const auto move = [this](int by) {
    const int row = m_list->currentRow();
    const int to = row + by;
    change(model::withPanelMoved(figure(), std::size_t(row), std::size_t(to)));
    m_list->setCurrentRow(to);
  };
  connect(m_up, &QToolButton::clicked, this, [move] { move(-1); });
  connect(m_down, &QToolButton::clicked, this, [move] { move(1); });
  return panels;
}

QWidget* FigureDialog::makeBottom() {
  auto* bottom = new QWidget;
  auto* layout = new QHBoxLayout(bottom);
  layout->setContentsMargins(0, 0, 0, 0);
  m_told->setObjectName(QStringLiteral("figureTold"));
  m_told->setTextFormat(Qt::PlainText);
  m_told->setWordWrap(true);
  layout->addWidget(m_told, 1);
  layout->addWidget(m_writing);
  const auto add = [&](const char* name, QPushButton* made, const auto& what) {
    made->setObjectName(QLatin1String(name));
    made->setAutoDefault(false);
    connect(made, &QPushButton::clicked, this, what);
    layout->addWidget(made);
  };
  add("figureOpen", new QPushButton(tr("&Open…")), [this] { askThen([this] { chooseOpen(); }); });
  add("figureSave", new QPushButton(tr("&Save Figure…")), [this] { chooseSave(); });
  m_export->setToolTip(tr("As PDF, SVG, PNG or TIFF"));
  add("figureExport", m_export, [this] { chooseExport(); });
  add("figureClose", new QPushButton(tr("Close")), [this] { reject(); });
  return bottom;
}

void FigureDialog::fillForm(QFormLayout& layout, const std::vector<FigureField>& fields) {
  for (const FigureField& each : fields) {
    QWidget* control = makeControl(each.field, [this, write = each.write](const QVariant& value) {
      if (m_filling)
        return;
      model::Figure changed = figure();
      write(changed, value);
      change(std::move(changed));
    });
    showValue(*control, each.field.kind, each.read(figure()));
    if (std::holds_alternative<SwitchField>(each.field.kind))
      layout.addRow(control);
    else
      layout.addRow(each.field.text, control);
  }
}

void FigureDialog::fillAddMenu(QMenu& menu) {
  menu.clear();
  const auto add = [this, &menu](const std::string& view) {
    QString text = FigureFields::viewName(view);
    menu.addAction(text.replace(QLatin1Char('&'), QLatin1String("&&")), this, [this, view] {
      change(model::withPanel(figure(), {.view = view}));
      m_list->setCurrentRow(m_list->count() - 1);
    });
  };
  for (const model::View& view : m_open.scene->views())
    add(view.name);
  menu.addSeparator();
  for (const std::string_view side : model::anatomicalViewNames)
    add(std::string(side));
  menu.addSeparator();
  menu.addAction(tr("Another Scene…"), this, [this] { chooseScene(); });
}

void FigureDialog::showAll() {
  m_filling = true;
  for (const FigureField& each : m_page)
    if (auto* control = m_pageForm->findChild<QWidget*>(each.field.id))
      showValue(*control, each.field.kind, each.read(figure()));
  {
    const QSignalBlocker quiet(m_list);
    const int row = m_list->currentRow();
    m_list->clear();
    for (std::size_t i = 0; i < figure().panels.size(); ++i)
      m_list->addItem(FigureFields::nameOf(figure(), i));
    m_list->setCurrentRow(std::min(std::max(row, 0), m_list->count() - 1));
  }
  m_filling = false;
  showPanel();
  setWindowModified(m_desk.modified());
  watchFiles();
  redraw();
}

void FigureDialog::redraw() {
  ++m_round;
  m_preview->setStale(tr("The page as it was; it is being drawn anew…"));
  m_soon.start();
}

void FigureDialog::sceneChanged(std::shared_ptr<const model::Scene> scene) {
  m_open.scene = scene;
  if (m_desk.setOpenScene(std::move(scene)))
    showAll();
}

void FigureDialog::watchFiles() {
  if (!m_watcher.files().empty())
    m_watcher.removePaths(m_watcher.files());
  for (const std::filesystem::path& file : m_desk.otherFiles())
    m_watcher.addPath(textOf(file));
}

void FigureDialog::readAgain(const QString& path) {
  // A file that is being replaced is away for a moment.
  constexpr int moment = 200;  // milliseconds
  m_preview->setStale(tr("The page as it was; %1 has changed").arg(QFileInfo(path).fileName()));
  QTimer::singleShot(moment, this, [this, path] {
    const Status read = m_desk.readAgain(pathOf(path));
    showAll();
    if (!read.ok())
      tell(read, {});
  });
}

void FigureDialog::optionsChanged() {
  if (!render::samePage(m_options, m_planned))
    redraw();
}

FigureWork FigureDialog::work() const {
  return {figure(), m_desk.scenes(), m_options, m_drawn};
}

void FigureDialog::chooseRow(int) {
  showPanel();
}

void FigureDialog::showPanel() {
  const int row = m_list->currentRow();
  const bool any = row >= 0 && row < int(figure().panels.size());
  m_remove->setEnabled(any && figure().panels.size() > 1);
  m_up->setEnabled(any && row > 0);
  m_down->setEnabled(any && row + 1 < m_list->count());
  m_add->setEnabled(figure().panels.size() < model::mostPanels);
  m_preview->choose(any ? std::optional(std::size_t(row)) : std::nullopt);
  m_filling = true;
  QFormLayout* layout = emptied(*m_panelForm);
  if (any)
    fillForm(*layout, FigureFields::ofPanel(figure(), std::size_t(row),
                                            m_desk.sceneOfPanel(std::size_t(row))));
  m_filling = false;
}

void FigureDialog::change(model::Figure changed) {
  if (changed == figure())
    return;
  m_desk.set(std::move(changed));
  redraw();
  // A control that has just been used must not be deleted by what it says.
  QMetaObject::invokeMethod(this, &FigureDialog::showAll, Qt::QueuedConnection);
}

void FigureDialog::addInset(std::size_t panel, const model::FigureBox& part) {
  change(model::withInset(figure(), panel, part));
  QMetaObject::invokeMethod(
      this, [this] { m_list->setCurrentRow(m_list->count() - 1); }, Qt::QueuedConnection);
}

void FigureDialog::compose() {
  m_queue.drop();
  m_planned = m_options;
  m_queue.add([dialog = QPointer(this), round = m_round, work = work(),
               room = QSizeF(m_preview->size()) *
                      m_preview->devicePixelRatioF()](const std::stop_token& stop) {
    Composed made{.round = round};
    const auto goOn = [&stop](double, std::string_view) { return !stop.stop_requested(); };
    Result<render::ComposedFigure> drawn = composed(work, goOn);
    if (const Status fine = render::checkFigureOptions(work.options, work.figure.blackAndWhite);
        !fine.ok())
      made.faults.push_back(fine.error());
    if (drawn.ok()) {
      const std::vector<Error> faults = render::printFaults(*drawn);
      made.faults.insert(made.faults.end(), faults.begin(), faults.end());
      made.page = render::pagePicture(render::pageOf(*drawn),
                                      FigurePreview::pageWidth(room, drawn->plan.layout.sizeMm));
      made.figure = std::make_shared<const render::ComposedFigure>(std::move(*drawn));
    } else {
      made.error = drawn.error();
    }
    return BackgroundQueue::Sequel([dialog, made = std::move(made)] {
      if (dialog)
        dialog->show(made);
    });
  });
}

void FigureDialog::show(const Composed& made) {
  if (made.round != m_round)
    return;
  m_shown = made.round;
  m_printable = made.figure && made.faults.empty();
  m_export->setEnabled(m_printable && !m_writing->busy());
  const Error* problem = made.error            ? &*made.error
                         : made.faults.empty() ? nullptr
                                               : &made.faults.front();
  const QStringList notes = made.figure ? notesOf(*made.figure) : QStringList();
  // What was said of a file stays until there is something else to say of the page.
  const QString words = problem ? told(problem->text()) : notes.join(QLatin1Char('\n'));
  if (words != m_said)
    m_told->setText(words);
  m_said = words;
  m_preview->setStale(made.figure ? QString() : tr("The page as it was before the last change"));
  if (!made.figure)
    return;
  m_drawn = made.figure;
  m_preview->show(made.page, made.figure->plan.layout);
}

void FigureDialog::tell(const Status& status, const QString& done) {
  m_told->setText(status.ok() ? done : told(status.error().text()));
}

void FigureDialog::askThen(const std::function<void()>& goOn) {
  if (!m_desk.modified())
    return goOn();
  auto* box = new QMessageBox(this);
  box->setObjectName(QStringLiteral("figureAsk"));
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setIcon(QMessageBox::Question);
  box->setText(tr("The figure has changes that are in no file."));
  QPushButton* save = box->addButton(tr("Save…"), QMessageBox::AcceptRole);
  QPushButton* discard = box->addButton(tr("Discard"), QMessageBox::DestructiveRole);
  save->setObjectName(QStringLiteral("figureAskSave"));
  discard->setObjectName(QStringLiteral("figureAskDiscard"));
  box->setDefaultButton(box->addButton(QMessageBox::Cancel));
  connect(save, &QPushButton::clicked, this, [this, goOn] { chooseSave(goOn); });
  connect(discard, &QPushButton::clicked, this, goOn);
  box->open();
}

void FigureDialog::reject() {
  if (m_writing->busy())
    return m_writing->cancel();
  askThen([this] { QDialog::reject(); });
}

}  // namespace sline::widgets

#include "moc_figure_dialog.cpp"
