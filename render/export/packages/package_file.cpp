// SPDX-License-Identifier: Apache-2.0
#include "render/export/packages/package_file.h"

#include "model/disk/whole_file.h"
#include "model/disk/zip_archive.h"
#include "render/export/packages/h5p_package.h"
#include "render/export/packages/moodle_quiz.h"
#include "render/export/packages/picture_questions.h"
#include "render/export/packages/qti_package.h"

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
  const Result<std::string> bytes = make(*book, order.of<PackageOptions>());
  if (!bytes.ok())
    return named(bytes.error());
  return model::writeText(target, *bytes);
}

}  // namespace

Status writeMoodle(const ExportOrder& order, const fs::path& target,
                   const ExportProgress& progress) {
  return writeQuestions(
      order, target, progress,
      [](const QuestionBook& book, const PackageOptions& options) -> Result<std::string> {
        return moodleQuiz(book, options);
      });
}

Status writeQti(const ExportOrder& order, const fs::path& target, const ExportProgress& progress) {
  return writeQuestions(order, target, progress,
                        [](const QuestionBook& book, const PackageOptions& options) {
                          return zippedMembers(qtiPackage(book, options));
                        });
}

Status writeH5p(const ExportOrder& order, const fs::path& target, const ExportProgress& progress) {
  return writeQuestions(order, target, progress,
                        [](const QuestionBook& book, const PackageOptions& options) {
                          return zippedMembers(h5pPackage(book, options));
                        });
}

}  // namespace sline::render
