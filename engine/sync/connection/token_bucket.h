#pragma once

#include "engine/core/session_time.h"

#include <optional>

namespace carina
{

/// A token bucket: holds two seconds' worth, and fills with the passing of time.
class TokenBucket
{
public:
    static constexpr double kBurst_s = 2.0;

    /// Takes an amount if it is there. @param perSecond how fast the bucket fills
    /// @param burst held in any case, however slowly it fills
    [[nodiscard]] bool take(double amount, double perSecond, LocalTime now, double burst = 0.0);
    /// Puts back what was taken.
    void putBack(double amount, double perSecond);

private:
    double m_used_s = 0.0; ///< taken and not refilled, in seconds of filling
    std::optional<LocalTime> m_at;
};

} // namespace carina
