#include "apps/program/site_blade.h"

namespace carina::program
{

std::optional<Blade> bladeOf(const SharedTools& tools)
{
    const auto shape = tools.blade();
    return shape ? std::optional{touchedBlade(*shape)} : std::nullopt;
}

} // namespace carina::program
