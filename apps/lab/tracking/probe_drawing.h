#pragma once

#include "engine/tracking/markers/probe.h"

#include <string>

namespace carina::lab
{

/// A drawing of a probe as SVG on A4: seen along each axis, with its markers numbered, those that
/// face away hollow; and a table of their places.
[[nodiscard]] std::string drawingOf(const Probe& probe, const std::string& title);

} // namespace carina::lab
