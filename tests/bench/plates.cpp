// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/plates.h"

#include <iomanip>
#include <map>
#include <ostream>

#include "render/lettering/typesetting.h"
#include "tests/bench/kept_plate.h"
#include "tests/support/plate_products.h"

namespace sline::bench {

namespace {

void printRow(std::ostream& out, const std::string& kind, int count,
              const test::ProductProof& proof) {
  out << std::left << std::setw(12) << kind << std::right << std::setw(9) << count << std::setw(7)
      << proof.marks << std::setw(8) << proof.labels << std::setw(9) << proof.leftOut
      << std::setw(13) << proof.overAnatomy << std::setw(8) << proof.labelsOver << std::setw(9)
      << proof.pixels << std::setw(6) << proof.throughDots << std::setw(7) << proof.throughTexts
      << std::setw(7) << proof.crossings << std::setw(8) << proof.astray << std::setw(11)
      << proof.elsewhere << '\n';
}

}  // namespace

Status countPlates(render::Picture& picture, const model::Scene& scene, const PlateCourse& course,
                   std::ostream& out) {
  const auto typesetting = render::Typesetting::create();
  if (!typesetting)
    return typesetting.error();
  const render::DrawPicture draw = picture.drawing();
  test::ProductTools tools;
  std::map<std::string, std::pair<int, test::ProductProof>> sums;
  for (int k = 0; k < course.products; ++k) {
    const int index = k % test::mostProducts;
    if (course.near && !test::isNear(index))
      continue;
    const auto product = test::productOf(scene, index, tools);
    if (!product)
      return product.error();
    const auto proof = test::proved(
        *product, draw,
        {.judge = course.judged > 0 && k % course.judged == 0, .unruled = course.unruled}, tools);
    if (!proof)
      return proof.error();
    for (const std::string& line : proof->lines)
      out << index << ' ' << line << '\n';
    out.flush();
    auto& [count, sum] = sums[product->kind];
    ++count;
    sum.add(*proof);
    if (course.folder.empty() || proof->clean())
      continue;
    for (const bool ink : {false, true})
      for (std::size_t i = 0; i < product->colour.size(); ++i)
        if (const Status kept =
                keepPlate(picture, (ink ? product->ink : product->colour)[i].order, **typesetting,
                          {.path = course.folder + '/' + std::to_string(index) +
                                   (ink ? "-ink" : "-colour") + std::to_string(i) + ".png"});
            !kept)
          return kept.error();
  }
  out << "kind         products  marks  labels  leftOut  overAnatomy  letters   pixels  dots  "
         "texts  cross  "
         "astray  elsewhere\n";
  test::ProductProof all;
  for (const auto& [kind, sum] : sums) {
    printRow(out, kind, sum.first, sum.second);
    all.add(sum.second);
  }
  if (course.unruled)
    out << "uncut, " << all.overUncut << " marks and letters lie over anatomy (" << all.pixelsUncut
        << " pixels); laid out by itself, ink has " << all.elsewhereAlone << " elsewhere\n";
  return Unit{};
}

}  // namespace sline::bench
