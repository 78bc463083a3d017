#pragma once

#include "engine/core/session_time.h"

#include <map>

namespace carina
{

/// How much of the time the views of a program take, which draw in one thread, one after another.
/// A view that is drawn seldom and has to be drawn in full detail, as what a laryngoscope shows,
/// leaves the less to one that is drawn often.
class SharedTime
{
public:
    static constexpr Duration kOver = std::chrono::seconds{1}; ///< of ours
    static constexpr double kLeastLeft = 0.4;                  ///< of ours

    /// Records what a view took since it was recorded last; zero where it was not drawn.
    /// @param interval in which it is drawn at most
    void took(const void* view, LocalTime now, Duration drawing, Duration interval);
    void forget(const void* view) { m_views.erase(view); }

    /// The share of the time that those leave that are drawn more seldom than each `interval`: a
    /// mean over the last second or so, and at least kLeastLeft.
    [[nodiscard]] double leftFor(Duration interval) const;

private:
    struct View {
        LocalTime at;
        Duration interval{};
        double share = 0.0;
    };
    std::map<const void*, View> m_views;
};

} // namespace carina
