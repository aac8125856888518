// SPDX-License-Identifier: Apache-2.0
// Provides the pages of help, compiled in from resources/help.
#pragma once

#include <QLocale>
#include <QString>
#include <vector>

class QWidget;

namespace sline::widgets {

/// Returns the ids of the pages in the order of the contents; help begins at the first.
std::vector<QString> helpPageIds();

/// Returns the page as Markdown in the locale's language, or else in English; empty for a page that
/// does not exist.
QString helpText(const QString& id, const QLocale& locale);
/// Returns the page's first heading.
QString helpTitle(const QString& id, const QLocale& locale);

/// Returns the pages that contain each of the words, whatever their case; all pages for no word.
std::vector<QString> helpPagesWith(const QString& words, const QLocale& locale);

/// The dynamic property of a widget that names the page about it; widgets inside it have the same
/// page.
constexpr const char* helpPageProperty = "helpPage";
/// Returns the page about the widget or what it is in, found by that property or else by the names
/// of docks and dialogs; the first page where neither names one.
QString helpPageOf(const QWidget* widget);

}  // namespace sline::widgets
