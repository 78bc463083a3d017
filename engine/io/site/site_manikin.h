#pragma once

#include "engine/registration/manikin/manikin_profile.h"

namespace carina
{

/// A place of the manikin's airway, touched with the stylus.
struct TouchedAirwayPlace {
    AirwayPlace place = AirwayPlace::Incisors;
    Vec3 p_MQ = Vec3::Zero(); ///< in the manikin frame M, metres
};

/// The manikin of a site: its make, and what was measured on it here.
struct SiteManikin {
    std::optional<ManikinProfile> profile{};
    std::optional<Length> measuredTeethToCarina{}; ///< with a tube, at this site
    std::vector<TouchedAirwayPlace> airway{};      ///< none twice
    /// SiteRegistration::madeAt of the registration whose frame M the airway is in. After a new fit
    /// M may be another, and the airway is touched again.
    std::string registeredAt{};

    [[nodiscard]] bool isEmpty() const
    {
        return !profile && !measuredTeethToCarina && airway.empty();
    }
};

} // namespace carina
