#pragma once

#include "engine/core/result.h"
#include "evaluation/anatomy/airway_measures.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// One figure of a generated patient and of a real set, in the unit at the end of its name. The
/// limit applies to the difference or, if `relative`, to the difference divided by the set's
/// figure; nothing where a real person may differ from published means by any amount.
struct Deviation {
    std::string name;
    double generated = 0.0;
    double real = 0.0; ///< of the set, scaled
    std::optional<double> limit = 0.0;
    bool relative = false;

    /// The difference or, if `relative`, its fraction of the set's figure.
    [[nodiscard]] double deviation() const;
    [[nodiscard]] bool met() const;
};

/// Mean distances between the surfaces of one organ.
struct OrganDistance {
    std::string organ;
    double toReal_mm = 0.0;   ///< from the generated surface to the real one, mean
    double fromReal_mm = 0.0; ///< and back
    bool oneWay = false; ///< only toReal_mm counts: the set's organ extends beyond the patient's

    [[nodiscard]] double mean_mm() const;
    [[nodiscard]] bool met() const;
};

/// A surface that intersects itself.
struct SelfIntersection {
    std::string part;
    std::size_t level = 0;
    std::size_t pairs = 0; ///< of triangles
};

/// The comparison of a generated patient with a real one.
struct AnatomyComparison {
    double airwayScale = 1.0; ///< of the set's head and airway: ratio of cords-to-carina lengths
    double chestScale = 1.0;  ///< of its chest: cube root of the ratio of lung volumes
    std::vector<Deviation> figures;
    std::vector<OrganDistance> organs;
    std::vector<std::string> notInSet; ///< organs that only the patient has
    std::vector<std::string> notInPatient;
    std::vector<SelfIntersection> selfIntersections;

    [[nodiscard]] bool met() const;
};

inline constexpr double kLargestMeanDistance_mm = 6.0;

/// The self-intersecting surfaces of a patient, in every level of detail.
[[nodiscard]] std::vector<SelfIntersection> selfIntersectionsOf(const Anatomy& anatomy);

/// Percentage of each lobe in the volume of all five: right upper, middle, lower, left upper,
/// lower. std::nullopt if a lobe is missing.
[[nodiscard]] std::optional<std::array<double, 5>> lobeShares(const Anatomy& anatomy);

/// Compares two patients, both in their frame A; scaling is about the carina.
/// @returns NothingRecognised, naming the patient whose airway cannot be measured.
[[nodiscard]] Result<AnatomyComparison> compareAnatomy(const Anatomy& generated,
                                                       const Anatomy& real);

} // namespace carina
