// SPDX-License-Identifier: Apache-2.0
#include "widgets/window/about_dialog.h"

#include <QApplication>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QSysInfo>
#include <QVBoxLayout>

namespace sline::widgets {

namespace {
QLabel* paragraph(const QString& text) {
  auto* label = new QLabel(text);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  return label;
}
}  // namespace

AboutDialog::AboutDialog(const QString& driver, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("aboutDialog"));
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("About Sline"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(24, 20, 24, 16);
  layout->setSpacing(10);
  auto* name = new QLabel(QStringLiteral("Sline %1").arg(QApplication::applicationVersion()));
  QFont font = name->font();
  font.setPointSizeF(1.8 * font.pointSizeF());
  name->setFont(font);
  layout->addWidget(name);
  layout->addWidget(
      paragraph(tr("Turns segmented anatomy into focus-and-context line "
                   "illustrations. Free software under the Apache License 2.0.")));
  layout->addWidget(
      paragraph(tr("After Lichtenberg, Smit, Hansen and Lawonn, “Sline: Seamless Line Illustration "
                   "for Interactive Biomedical Visualization” (VCBM 2016), and Lawonn, Mönch and "
                   "Preim, “Streamlines for Illustrative Real-Time Rendering” (EuroVis 2013).")));
  QLabel* facts = paragraph(tr("Qt %1 on %2\nOpenGL: %3")
                                .arg(QLatin1String(qVersion()), QSysInfo::prettyProductName(),
                                     driver.isEmpty() ? tr("not started yet") : driver));
  facts->setObjectName(QStringLiteral("aboutFacts"));
  layout->addWidget(facts);
  layout->addStretch();
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  QPushButton* copy = buttons->addButton(tr("Copy"), QDialogButtonBox::ActionRole);
  connect(copy, &QPushButton::clicked, this, [name, facts] {
    QApplication::clipboard()->setText(name->text() + QLatin1Char('\n') + facts->text());
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  layout->addWidget(buttons);
  setMinimumWidth(460);
}

}  // namespace sline::widgets

#include "moc_about_dialog.cpp"
