// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

namespace sline::test {

/// The markers that the file gives away to somebody who looks closely: in any letter case, as
/// UTF-8, Latin-1 or UTF-16, percent-encoded, escaped as JSON, XML and PDF escape, as PDF's
/// hexadecimal strings or base64, in names and contents of ZIP members and in whatever zlib or gzip
/// has packed (streams of PDF, chunks of PNG, strips of TIFF and EXR), as deep as it lies.
QStringList markersIn(const QByteArray& file, const QStringList& markers);

/// Of PDF pages, as `pdftotext` reads them, and what `pdfinfo` says; empty where neither is
/// installed.
QByteArray textOfPdf(const QString& path);

}  // namespace sline::test
