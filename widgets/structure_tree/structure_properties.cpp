// SPDX-License-Identifier: Apache-2.0
#include "widgets/structure_tree/structure_properties.h"

#include <QClipboard>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPointer>
#include <QPushButton>
#include <QScrollArea>
#include <QThreadPool>
#include <QVBoxLayout>
#include <algorithm>
#include <set>

#include "model/edit/credits.h"
#include "model/fairing/faired.h"
#include "model/lengths/measured_extent.h"
#include "model/scene/resolved_styles.h"
#include "widgets/gamma/stages.h"
#include "widgets/session/length_texts.h"
#include "widgets/text/told.h"
#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {

QString number(double value, int digits = 1) {
  return QLocale().toString(value, 'f', digits);
}

QString count(std::size_t value) {
  return QLocale().toString(qulonglong(value));
}

QString withReason(const QString& text, const std::string& reason) {
  return reason.empty() ? text : QStringLiteral("%1 (%2)").arg(text, told(reason));
}

QString withOrigin(const QString& text, bool own) {
  return own ? tr("%1, its own").arg(text) : tr("%1, inherited").arg(text);
}

QString fillName(model::Fill fill) {
  switch (fill) {
    case model::Fill::none:
      return tr("open");
    case model::Fill::paper:
      return tr("solid");
    case model::Fill::tint:
      return tr("tint");
    case model::Fill::veil:
      return tr("veil");
  }
  return {};
}

QString imported(const model::Provenance& p) {
  QStringList done;
  if (p.decimatedFrom > 0)
    done << tr("simplified from %1 triangles, at most %2 mm off")
                .arg(count(std::size_t(p.decimatedFrom)), number(double(p.decimationMm), 2));
  if (p.smoothingSteps > 0)
    done << tr("smoothed in %1 steps, at most %2 mm off")
                .arg(p.smoothingSteps)
                .arg(number(double(p.displacementMm), 2));
  if (p.sliceMm > 0.0f)
    done << tr("drawn without the steps of slices %1 mm apart, at most %2 mm off")
                .arg(number(double(p.sliceMm), 2),
                     number(double(model::fairingShare * p.sliceMm), 2));
  if (p.refinementSteps > 0)
    done << tr("refined in %1 steps").arg(p.refinementSteps);
  if (p.repairedFaces > 0)
    done << tr("%1 faces mended").arg(count(std::size_t(p.repairedFaces)));
  if (p.transform)
    done << tr("moved as its scene says");
  return done.isEmpty() ? tr("as in the file") : done.join(QStringLiteral("; "));
}

void addOrigin(std::vector<Property>& rows, const model::Provenance& p) {
  if (p.file.empty()) {
    rows.push_back({QStringLiteral("file"), tr("File"), tr("made by the program")});
    return;
  }
  rows.push_back({QStringLiteral("file"), tr("File"), QString::fromStdString(p.file)});
  if (!p.part.empty())
    rows.push_back(
        {QStringLiteral("part"), tr("Part of the file"), QString::fromStdString(p.part)});
  const QString doubt = p.evidence.isSure() ? QString() : QStringLiteral("?");
  rows.push_back({QStringLiteral("frame"), tr("Coordinates"),
                  withReason(QString::fromStdString(p.frame) + doubt, p.frameReason)});
  rows.push_back(
      {QStringLiteral("unit"), tr("Unit"),
       withReason(tr("%1 mm").arg(QLocale().toString(double(p.mmPerUnit), 'g', 6)), p.unitReason)});
  rows.push_back({QStringLiteral("import"), tr("Import"), imported(p)});
}

void addLooks(std::vector<Property>& rows, const model::Scene& scene, const model::Node& node) {
  const model::ResolvedStyle style = scene.resolve(node.id);
  const model::Style& own = node.style;
  const QString colour = QStringLiteral("#%1%2%3")
                             .arg(style.colour.red, 2, 16, QLatin1Char('0'))
                             .arg(style.colour.green, 2, 16, QLatin1Char('0'))
                             .arg(style.colour.blue, 2, 16, QLatin1Char('0'));
  rows.push_back({QStringLiteral("gamma"), tr("Γ"),
                  withOrigin(gammaText(style.gamma), own.gamma.has_value())});
  rows.push_back(
      {QStringLiteral("colour"), tr("Colour"), withOrigin(colour, own.colour.has_value())});
  rows.push_back({QStringLiteral("opacity"), tr("Opacity"),
                  withOrigin(tr("%1 %").arg(number(100.0 * double(style.opacity.value()), 0)),
                             own.opacity.has_value())});
  rows.push_back({QStringLiteral("fill"), tr("Between the lines"),
                  withOrigin(fillName(style.fill), own.fill.has_value())});
  rows.push_back(
      {QStringLiteral("pen"), tr("Line width"),
       withOrigin(tr("%1 ×").arg(number(double(style.penWeight), 2)), own.penWeight.has_value())});
  rows.push_back({QStringLiteral("shown"), tr("Shown"), style.visible ? tr("yes") : tr("no")});
  rows.push_back({QStringLiteral("locked"), tr("Locked"),
                  node.locked               ? tr("yes")
                  : scene.isLocked(node.id) ? tr("by the group above")
                                            : tr("no")});
}

}  // namespace

std::vector<Property> propertiesOf(const model::Scene& scene, const NodeIds& ids,
                                   const OtherSides& otherSides) {
  std::vector<Property> rows;
  if (ids.empty())
    return rows;
  const model::Node& first = *scene.find(ids.front());
  const bool one = ids.size() == 1;
  if (one) {
    rows.push_back({QStringLiteral("name"), tr("Name"), QString::fromStdString(first.name)});
    if (const std::string path = scene.groupPath(first.id); !path.empty())
      rows.push_back({QStringLiteral("group"), tr("In"), QString::fromStdString(path)});
  }
  const std::vector<model::ResolvedStructure> structures = model::resolvedBelow(scene, ids);
  if (!one || first.isGroup())
    rows.push_back({QStringLiteral("structures"), tr("Structures"), count(structures.size())});
  std::size_t triangles = 0;
  model::Box bounds;
  for (const model::ResolvedStructure& structure : structures) {
    const model::MeshPtr& mesh = structure.node->mesh;
    triangles += mesh->triangleCount();
    if (!mesh->bounds().empty())
      bounds.add(mesh->bounds());
  }
  rows.push_back({QStringLiteral("triangles"), tr("Triangles"), count(triangles)});
  if (!bounds.empty()) {
    const glm::vec3 size = bounds.size();
    rows.push_back(
        {QStringLiteral("size"), tr("Size"),
         (hasSides(scene) ? tr("%1 (right–left, front–back, foot–head)") : tr("%1 (x, y, z)"))
             .arg(sizeText(scene, glm::dvec3(size)))});
  }
  if (one && !first.isGroup())
    addOrigin(rows, first.provenance);
  if (one && otherSides.has(first.id))
    rows.push_back({QStringLiteral("side"), tr("Side"), tr("another than its name says")});
  if (one)
    addLooks(rows, scene, first);
  return rows;
}

std::vector<Property> extentProperties(const std::vector<model::Node>& structures,
                                       model::DrawnUnit unit) {
  double area = 0.0;
  double volume = 0.0;
  std::size_t closed = 0;
  bool areaAsRead = true;
  bool volumeAsRead = true;
  for (const model::Node& structure : structures) {
    const model::MeasuredExtent measured = model::measuredExtent(structure);
    area += measured.extent.area;
    volume += measured.extent.volume.value_or(0.0);
    closed += measured.extent.volume ? 1 : 0;
    areaAsRead = areaAsRead && measured.areaAsRead;
    volumeAsRead = volumeAsRead && measured.volumeAsRead;
  }
  const auto with = [](const QString& text, bool asRead) {
    return asRead ? text : tr("%1, of the smoothed surface").arg(text);
  };
  QString inside = closed == 0 ? tr("none: the surface has holes")
                               : with(volumeText(unit, volume), volumeAsRead);
  if (closed > 0 && closed < structures.size())
    inside = tr("%1, of %2 closed surfaces").arg(inside, count(closed));
  return {{QStringLiteral("area"), tr("Surface"), with(areaText(unit, area), areaAsRead)},
          {QStringLiteral("volume"), tr("Volume"), inside}};
}

StructureProperties::StructureProperties(Session& session, const NodeIds& ids,
                                         const QString& explanation, QWidget* parent)
    : QDialog(parent), m_form(new QFormLayout) {
  setObjectName(QStringLiteral("propertiesDialog"));
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Properties"));
  auto* content = new QWidget;
  content->setLayout(m_form);
  m_form->setContentsMargins(16, 16, 16, 16);
  m_form->setHorizontalSpacing(18);
  m_form->setVerticalSpacing(7);
  m_form->setLabelAlignment(Qt::AlignRight | Qt::AlignTop);
  auto* scroll = new QScrollArea;
  scroll->setObjectName(QStringLiteral("propertiesScroll"));
  scroll->setAccessibleName(tr("Properties"));
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setWidget(content);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  QPushButton* copyButton = buttons->addButton(tr("&Copy"), QDialogButtonBox::ActionRole);
  copyButton->setObjectName(QStringLiteral("propertiesCopy"));
  buttons->button(QDialogButtonBox::Close)->setObjectName(QStringLiteral("propertiesClose"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 12);
  layout->addWidget(scroll, 1);
  auto* foot = new QVBoxLayout;
  foot->setContentsMargins(16, 0, 16, 0);
  foot->addWidget(buttons);
  layout->addLayout(foot);
  connect(copyButton, &QPushButton::clicked, this, &StructureProperties::copy);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  resize(540, 480);
  buttons->button(QDialogButtonBox::Close)->setDefault(true);

  add(propertiesOf(session.scene(), ids, session.otherSides()));
  addCredit(session, ids);
  if (!explanation.isEmpty())
    add({{QStringLiteral("drawn"), tr("Drawn"), explanation}});
  std::vector<model::Node> structures;
  for (const auto& [node, style] : model::resolvedBelow(session.scene(), ids))
    structures.push_back(*node);
  // A million triangles take longer than a window may stand still.
  QThreadPool::globalInstance()->start(
      [structures, unit = drawnUnit(session.scene()), dialog = QPointer(this)] {
        const std::vector<Property> rows = extentProperties(structures, unit);
        QMetaObject::invokeMethod(QCoreApplication::instance(), [dialog, rows] {
          if (dialog)
            dialog->add(rows);
        });
      });
}

void StructureProperties::add(const std::vector<Property>& properties) {
  for (const Property& property : properties) {
    auto* text = new QLabel(property.text);
    text->setObjectName(QStringLiteral("property-") + property.id);
    text->setAccessibleName(property.label);
    text->setTextFormat(Qt::PlainText);
    text->setWordWrap(true);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* label = new QLabel(property.label);
    label->setEnabled(false);
    m_form->addRow(label, text);
    m_lines << property.label + QLatin1Char('\t') + property.text;
  }
}

/// Adds a field for each part of the credit; one that is left open changes nothing.
void StructureProperties::addCredit(Session& session, const NodeIds& ids) {
  const struct {
    const char* id;
    QString label;
    std::string model::SourceCredit::*field;
    std::optional<std::string> model::CreditChange::*change;
  } rows[] = {
      {"authors", tr("Authors"), &model::SourceCredit::authors, &model::CreditChange::authors},
      {"source", tr("Source"), &model::SourceCredit::source, &model::CreditChange::source},
      {"licence", tr("Licence"), &model::SourceCredit::licence, &model::CreditChange::licence}};
  for (const auto& row : rows) {
    std::set<std::string> said;
    for (const auto& [node, style] : model::resolvedBelow(session.scene(), ids))
      said.insert(node->provenance.credit.*row.field);
    auto* edit = new QLineEdit;
    edit->setObjectName(QStringLiteral("property-") + QLatin1String(row.id));
    edit->setAccessibleName(row.label);
    edit->setToolTip(tr("Whose work the surface is; exports print it where you wish"));
    edit->setMaxLength(int(model::longestCredit));
    if (said.size() == 1)
      edit->setText(QString::fromStdString(*said.begin()));
    else
      edit->setPlaceholderText(tr("several"));
    auto* label = new QLabel(row.label);
    label->setEnabled(false);
    label->setBuddy(edit);
    m_form->addRow(label, edit);
    connect(edit, &QLineEdit::editingFinished, this, [&session, ids, edit, change = row.change] {
      if (!edit->isModified())
        return;
      edit->setModified(false);
      model::CreditChange typed;
      typed.*change = edit->text().toStdString();
      session.apply(tr("Say Whose Work It Is"), model::withCredit(session.scene(), ids, typed));
    });
  }
}

void StructureProperties::copy() const {
  QGuiApplication::clipboard()->setText(m_lines.join(QLatin1Char('\n')));
}

}  // namespace sline::widgets

#include "moc_structure_properties.cpp"
