#pragma once

#include "engine/core/units.h"
#include "engine/geometry/vec.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace carina
{

/// The places of an airway that a stylus can touch in a manikin, on the way in.
enum class AirwayPlace : std::uint8_t { Incisors, Epiglottis, Glottis, Carina };
inline constexpr std::array kAirwayPlaces{AirwayPlace::Incisors, AirwayPlace::Epiglottis,
                                          AirwayPlace::Glottis, AirwayPlace::Carina};

/// A length from teeth to carina, along the way of a tube, and who measured it.
struct SourcedLength {
    Length length{};
    std::string source{};

    friend bool operator==(const SourcedLength&, const SourcedLength&) = default;
};

/// What is known of a make of manikin. A figure that nobody has published is absent; it is measured
/// at the site (SiteManikin).
struct ManikinProfile {
    std::string name{}; ///< as shown: "TruCorp AirSim"
    std::string note{}; ///< what is published about its airway, and where; may be empty
    /// Names of the landmarks to register it by, as in the catalogues of the patient; may be empty.
    std::vector<std::string> landmarks{};
    std::string landmarksSource{}; ///< not empty where there are landmarks
    std::string patient{};         ///< whose airway it has, as for patientFromWords; may be empty
    std::string patientSource{};   ///< not empty where there is a patient
    std::optional<SourcedLength> teethToCarina{};

    friend bool operator==(const ManikinProfile&, const ManikinProfile&) = default;
};

/// Limits of plausibility of teethToCarina in a profile, chosen by us so that a slip of the pen or
/// of the unit is refused. They are no measurements; what is between them need not be right.
inline constexpr Length kLeastTeethToCarina = millimetres(100.0);
inline constexpr Length kMostTeethToCarina = millimetres(350.0);

/// The profiles that Carina offers: the manikin of 2004 and two adult airway heads.
[[nodiscard]] std::span<const ManikinProfile> builtinManikins();

} // namespace carina
