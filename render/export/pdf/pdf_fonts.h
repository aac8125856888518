// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <qpdf/QPDFPageObjectHelper.hh>
#include <vector>

namespace sline::render {

/// Names the subsets of fonts in the order in which pages have them. Qt names them by numbers that
/// differ from run to run where there are several.
void nameFonts(std::vector<QPDFPageObjectHelper>& pages);

}  // namespace sline::render
