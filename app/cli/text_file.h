// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/disk/whole_file.h"

namespace sline::cli {

using model::readText;
using model::writeBeside;
using model::writeText;

}  // namespace sline::cli
