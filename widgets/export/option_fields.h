// SPDX-License-Identifier: Apache-2.0
// Presents the options of exports as fields of the dialog and as values in settings.
#pragma once

#include <QStringList>

#include "render/export/order/export_option.h"
#include "widgets/form/field.h"

namespace sline::widgets {

/// Returns the option as a field in the interface's language, named "export-" and the option's id.
/// `languages`: the BCP 47 tags that labels have texts in.
Field fieldOf(const render::ExportOption& option, const QStringList& languages);

/// Returns the value that the order has, as a field or settings hold it.
QVariant valueIn(const render::ExportOrder& order, const render::ExportOption& option);
/// Sets the value in the order. One that is not allowed changes nothing.
void setValue(render::ExportOrder& order, const render::ExportOption& option,
              const QVariant& value);

}  // namespace sline::widgets
