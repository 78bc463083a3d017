#pragma once

#include "engine/core/session_time.h"

#include <deque>

namespace carina
{

/// How a view draws, over its latest frames.
struct FrameStatistics {
    double framesPerSecond = 0.0; ///< 0 before the second frame
    Duration medianDrawing{};     ///< from asking for the frame to the swapped buffers
    Duration worstDrawing{};
    std::size_t frames = 0; ///< drawn since the view was made
};

/// Keeps the times of the latest kKept frames.
class FrameTimes
{
public:
    static constexpr std::size_t kKept = 120;

    void add(LocalTime asked, LocalTime swapped);
    [[nodiscard]] FrameStatistics statistics() const;

private:
    struct Times {
        LocalTime asked;
        LocalTime swapped;
    };
    std::deque<Times> m_latest;
    std::size_t m_frames = 0;
};

} // namespace carina
