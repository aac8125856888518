// SPDX-License-Identifier: Apache-2.0
// The pages of help, compiled in from resources/help.
#pragma once

#include <QLocale>
#include <QString>
#include <vector>

class QWidget;

namespace sline::widgets {

/// Their ids, in the order in which the contents list them; the first is where help begins.
std::vector<QString> helpPageIds();

/// The page in the locale's language, else in English; empty for a page that is not there.
/// Markdown.
QString helpText(const QString& id, const QLocale& locale);
/// Its first heading.
QString helpTitle(const QString& id, const QLocale& locale);

/// Pages that contain each of the words, whatever their case; all pages for no word.
std::vector<QString> helpPagesWith(const QString& words, const QLocale& locale);

/// A widget's dynamic property that names the page about it; what is inside has the same page.
constexpr const char* helpPageProperty = "helpPage";
/// Of the widget or what it is in, by that property, else by the names of docks and dialogs; the
/// first page where nobody says.
QString helpPageOf(const QWidget* widget);

}  // namespace sline::widgets
