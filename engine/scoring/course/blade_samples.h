#pragma once

#include "engine/tracking/pose_sample.h"

#include <deque>
#include <optional>
#include <vector>

namespace carina
{

/// Samples of a laryngoscope, until it is known whether its blade was in the mouth at their time.
/// A blade is noted to be out only once it has stayed away for a while, so what it did there comes
/// before that is known.
class BladeSamples
{
public:
    /// By then it is known: BladeOut comes 2 s after the blade left (the time between two
    /// attempts), and no step is dated more than 4 s back (docs/airway-and-tube.md).
    static constexpr Duration kKnownAfter = std::chrono::seconds{5};

    void add(const PoseSample& X_FL) { m_waiting.push_back(X_FL); }
    void bladeIn(SessionTime at) { m_in = at; }
    /// @returns what of the samples up to then was in the mouth; they are asked for once
    [[nodiscard]] std::vector<PoseSample> inMouthUntil(SessionTime t);
    /// @returns the last of them
    [[nodiscard]] std::vector<PoseSample> bladeOut(SessionTime at);

private:
    std::deque<PoseSample> m_waiting;
    std::optional<SessionTime> m_in; ///< nothing while it is out
};

} // namespace carina
