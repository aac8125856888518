// SPDX-License-Identifier: Apache-2.0
#include "render/export/packages/package_file.h"

#include "model/disk/whole_file.h"
#include "model/disk/zip_archive.h"
#include "render/export/description/alt_text.h"
#include "render/export/packages/h5p_package.h"
#include "render/export/packages/moodle_quiz.h"
#include "render/export/packages/page_package.h"
#include "render/export/packages/picture_questions.h"
#include "render/export/packages/qti_package.h"
#include "render/export/students/students_page.h"

namespace sline::render {

namespace fs = std::filesystem;

namespace {

Result<std::string> zippedMembers(const std::vector<model::ZipMember>& members) {
  std::vector<const model::ZipMember*> all;
  all.reserve(members.size());
  for (const model::ZipMember& member : members)
    all.push_back(&member);
  return model::zipped(all);
}

/// Makes the questions into bytes and writes these.
template <class Make>
Status writeQuestions(const ExportOrder& order, const fs::path& target,
                      const ExportProgress& progress, const Make& make) {
  const auto named = [&target](Error error) {
    error.file = target.string();
    return error;
  };
  const Result<QuestionBook> book = pictureQuestions(order, progress);
  if (!book.ok())
    return named(book.error());
  if (progress && !progress(0.95, "writing questions"))
    return givenUp(target);
  const Result<std::string> bytes = make(*book, questionKinds(order));
  if (!bytes.ok())
    return named(bytes.error());
  return model::writeText(target, *bytes);
}

/// Makes the students' page, which talks to its system by the standard, and packs it.
Status writePagePackage(PageStandard standard, const ExportOrder& order, const fs::path& target,
                        const ExportProgress& progress) {
  StudentsOptions own = order.of<StudentsOptions>();
  own.folder = true;
  own.fileTitle = target.stem().string();
  own.report = reportName(standard);
  Result<StudentsPage> page = studentsPage(order, own, progress);
  if (!page.ok()) {
    Error error = page.error();
    error.file = target.string();
    return error;
  }
  const PageAbout about{.title = page->title,
                        .language = page->language,
                        .credit = fileCredit(order, {}),
                        .passing = order.of<PackageOptions>().passing / 100.0};
  page->files["index.html"] = page->html;
  const Result<std::string> bytes = zippedMembers(pagePackage(standard, page->files, about));
  return bytes.ok() ? model::writeText(target, *bytes) : Status(bytes.error());
}

}  // namespace

Status writeScorm12(const ExportOrder& order, const fs::path& target,
                    const ExportProgress& progress) {
  return writePagePackage(PageStandard::scorm12, order, target, progress);
}

Status writeScorm2004(const ExportOrder& order, const fs::path& target,
                      const ExportProgress& progress) {
  return writePagePackage(PageStandard::scorm2004, order, target, progress);
}

Status writeCmi5(const ExportOrder& order, const fs::path& target, const ExportProgress& progress) {
  return writePagePackage(PageStandard::cmi5, order, target, progress);
}

Status writeMoodle(const ExportOrder& order, const fs::path& target,
                   const ExportProgress& progress) {
  return writeQuestions(
      order, target, progress,
      [](const QuestionBook& book, const QuestionKinds& kinds) -> Result<std::string> {
        return moodleQuiz(book, kinds);
      });
}

Status writeQti(const ExportOrder& order, const fs::path& target, const ExportProgress& progress) {
  return writeQuestions(order, target, progress,
                        [](const QuestionBook& book, const QuestionKinds& kinds) {
                          return zippedMembers(qtiPackage(book, kinds));
                        });
}

Status writeH5p(const ExportOrder& order, const fs::path& target, const ExportProgress& progress) {
  return writeQuestions(
      order, target, progress, [&progress](const QuestionBook& book, const QuestionKinds& kinds) {
        if (const auto texts = shortenedInH5p(book); !texts.empty())
          progress.note({.kind = ExportNote::Kind::textShortened, .names = texts, .detail = {}});
        return zippedMembers(h5pPackage(book, kinds));
      });
}

}  // namespace sline::render
