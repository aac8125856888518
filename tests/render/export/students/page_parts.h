// SPDX-License-Identifier: Apache-2.0
// Takes a students' page apart again, as a browser does.
#pragma once

#include <QByteArray>
#include <QString>
#include <nlohmann/json.hpp>
#include <string>

#include "render/export/students/students_page.h"

namespace sline::test {

/// Returns what stands between the first start tag that begins so and its end tag; empty where
/// there is none.
QByteArray elementOf(const std::string& html, const QByteArray& startTag);
/// Returns the value of the attribute in the first tag that begins so.
QByteArray attributeOf(const std::string& html, const QByteArray& startTag, const char* name);
/// Returns the page's facts; null where they are no JSON.
nlohmann::json factsOf(const std::string& html);
/// Returns the bytes of gzip; empty for others.
QByteArray gunzipped(const QByteArray& packed);
/// Returns everything that the page has, data in gzip and base64 unpacked.
QByteArray unpackedPage(const render::StudentsPage& page);

/// Makes the page of that order; its title is "Lesson". It fails the test where that fails.
render::StudentsPage pageOf(const render::ExportOrder& order,
                            const render::StudentsOptions& own = {.title = "Lesson"});

}  // namespace sline::test
