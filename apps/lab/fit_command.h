#pragma once

#include "apps/lab/command.h"

namespace carina::lab
{

/// `fit`: registers landmarks touched on a manikin to those of the anatomy.
[[nodiscard]] Command fitCommand();

} // namespace carina::lab
