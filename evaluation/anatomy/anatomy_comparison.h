#pragma once

#include "engine/core/result.h"
#include "evaluation/anatomy/airway_measures.h"

#include <array>
#include <string>
#include <vector>

namespace carina
{

/// One figure of a generated patient beside the same figure of a real set, in the unit that its
/// name ends with. A limit holds for the difference, or for its share of the set's figure where
/// `relative`.
struct Deviation {
    std::string name;
    double generated = 0.0;
    double real = 0.0; ///< of the set, scaled
    double limit = 0.0;
    bool relative = false;

    /// Difference, or its share.
    [[nodiscard]] double deviation() const;
    [[nodiscard]] bool met() const;
};

/// How far the surfaces of one organ are apart.
struct OrganDistance {
    std::string organ;
    double toReal_mm = 0.0;   ///< from the generated surface to the real one, mean
    double fromReal_mm = 0.0; ///< and back
    bool oneWay = false;      ///< only the first counts: the set goes on where the patient ends

    [[nodiscard]] double mean_mm() const;
    [[nodiscard]] bool met() const;
};

/// A surface that runs through itself.
struct SelfIntersection {
    std::string part;
    std::size_t level = 0;
    std::size_t pairs = 0; ///< of triangles
};

/// What a generated patient is like, beside a real one.
struct AnatomyComparison {
    double airwayScale =
        1.0;                 ///< by which the set's head and airway are multiplied: cords to carina
    double chestScale = 1.0; ///< and its chest: cube root of the volume of the lungs
    std::vector<Deviation> figures;
    std::vector<OrganDistance> organs;
    std::vector<std::string> notInSet; ///< organs that only the patient has
    std::vector<std::string> notInPatient;
    std::vector<SelfIntersection> selfIntersections;

    [[nodiscard]] bool met() const;
};

inline constexpr double kLargestMeanDistance_mm = 6.0;

/// The surfaces of a patient that run through themselves, in every level of detail.
[[nodiscard]] std::vector<SelfIntersection> selfIntersectionsOf(const Anatomy& anatomy);

/// Share in per cent of each lobe in the volume of all five: right upper, middle, lower, left
/// upper, lower. Nothing where a lobe is missing.
[[nodiscard]] std::optional<std::array<double, 5>> lobeShares(const Anatomy& anatomy);

/// Both in their frame A; scaling is about the carina.
/// @returns NothingRecognised, naming the one of which the airway cannot be measured.
[[nodiscard]] Result<AnatomyComparison> compareAnatomy(const Anatomy& generated,
                                                       const Anatomy& real);

} // namespace carina
