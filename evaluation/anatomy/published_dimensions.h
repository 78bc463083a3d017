#pragma once

#include "engine/anatomy/patient/patient_dimensions.h"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace carina
{

/// A dimension as it was measured in people: its mean is
///
///     mean + perCentimetre * height + perMonth * age
///
struct PublishedDimension {
    std::string_view name; ///< as measuredDimensions has it, with the unit
    double fromAge = 18.0; ///< years, of whom it holds
    double toAge = 200.0;
    std::optional<Sex> sex{}; ///< nothing: of both
    double mean = 0.0;
    double perCentimetre = 0.0;
    double perMonth = 0.0;
    std::optional<double> deviation{}; ///< standard deviation; nothing where none was found
    std::string_view source;

    [[nodiscard]] bool holdsFor(const PatientParameters& person) const;
    [[nodiscard]] double meanFor(const PatientParameters& person) const;
};

/// All that were found; of one dimension and person there may be several.
[[nodiscard]] std::span<const PublishedDimension> publishedDimensions();

} // namespace carina
