#pragma once

#include "engine/core/units.h"

#include <cstdint>

namespace carina
{

/// How far the registration of a participant's manikin can be relied on.
enum class RegistrationState : std::uint8_t {
    Simulated, ///< a simulated manikin, registered without error
    Good,      ///< verified: good
    Unverified,
    NotGood, ///< verified: not good
    Stale,
    Missing,
    NoTracker, ///< after another one: the program has no tracker any more
};

/// Why a registration is stale, or why its verification no longer counts.
enum class StaleReason : std::uint8_t {
    None,
    Tracker,     ///< it was made with another tracker
    Stylus,      ///< the stylus was calibrated anew
    Landmarks,   ///< landmarks were changed
    Manikin,     ///< the manikin was moved, and its landmarks touched again since
    Touches,     ///< landmarks were touched again
    Fit,         ///< the patient was fitted again
    Patient,     ///< it is of another patient
    Registering, ///< the manikin is being registered again
    Age,         ///< it was verified too long ago
    Drift,       ///< landmarks are no longer where they were
};

/// The judgement of a registration.
struct RegistrationStanding {
    RegistrationState state = RegistrationState::Missing;
    /// Of Stale; and of Unverified where there was a verification before.
    StaleReason reason = StaleReason::None;
    /// Good and Unverified: 95 % bound of the error expected at the glottis; NotGood: the largest
    /// error of a check; Stale by Drift: the estimated shift. 0 where it is not known.
    Length error{};

    friend bool operator==(const RegistrationStanding&, const RegistrationStanding&) = default;
};

namespace fact
{

/// How far the registration of the author's manikin can be relied on, as its program judges it.
/// Holds until its next, or until the author joins again. The station has no meaning.
struct RegistrationStated {
    RegistrationStanding standing;

    friend bool operator==(const RegistrationStated&, const RegistrationStated&) = default;
};

} // namespace fact

} // namespace carina
