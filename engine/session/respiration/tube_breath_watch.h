#pragma once

#include "engine/session/respiration/patient_run.h"

#include <optional>

namespace carina
{

/// Finds the first breath that bag or ventilator deliver through a tube where it lies: the first
/// that began after the mechanics had the tube there and something blew, and was delivered
/// (PatientRun::deliveredBreath).
class TubeBreathWatch
{
public:
    TubeBreathWatch() = default;
    /// One that has found the breath through a tube there.
    explicit TubeBreathWatch(TubeSeat found) : m_seat{found}, m_isFound{true} {}

    /// Takes a patient at ascending times; a breath that lies between two of them is missed.
    /// @param seat of the tip by who asks. While the mechanics have another one, as before a fact
    ///             takes effect or where the console overrides it, there is no breath.
    /// @returns when the breath began; once for each way that the tube takes, airway or oesophagus
    [[nodiscard]] std::optional<SessionTime> take(const PatientRun& run, TubeSeat seat);

private:
    TubeSeat m_seat = TubeSeat::None;
    SessionTime m_since{}; ///< nothing was delivered there until then
    bool m_isFound = false;
};

} // namespace carina
