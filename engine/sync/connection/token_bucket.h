#pragma once

#include "engine/core/session_time.h"

#include <optional>

namespace carina
{

/// A token bucket: fills with the passing of time.
class TokenBucket
{
public:
    static constexpr double kBurst_s = 2.0;

    /// Takes an amount if it is there, of a bucket that holds two seconds' worth.
    /// @param perSecond how fast the bucket fills
    [[nodiscard]] bool take(double amount, double perSecond, LocalTime now)
    {
        return takeOf(kBurst_s * perSecond, amount, perSecond, now);
    }
    /// The same of a bucket that holds `capacity`, however slowly it fills.
    [[nodiscard]] bool takeOf(double capacity, double amount, double perSecond, LocalTime now);
    /// Puts back what was taken.
    void putBack(double amount, double perSecond);

private:
    double m_used_s = 0.0; ///< taken and not refilled, in seconds of filling
    std::optional<LocalTime> m_at;
};

} // namespace carina
