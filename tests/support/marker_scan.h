// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

namespace sline::test {

/// Returns the markers that the file reveals to a close reader: in any letter case, as UTF-8,
/// Latin-1 or UTF-16, percent-encoded, escaped as JSON, XML and PDF escape, as PDF's hexadecimal
/// strings or base64, in names and contents of ZIP members and in whatever zlib or gzip has packed
/// (streams of PDF, chunks of PNG, strips of TIFF and EXR), as deep as it lies.
QStringList markersIn(const QByteArray& file, const QStringList& markers);

/// Returns the text of PDF pages, as `pdftotext` reads them, and what `pdfinfo` says; empty if
/// neither is installed.
QByteArray textOfPdf(const QString& path);

}  // namespace sline::test
