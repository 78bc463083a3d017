#pragma once

#include "engine/core/session_time.h"

#include <deque>

namespace carina
{

/// Frame rate and drawing times of a view, over its latest frames.
struct FrameStatistics {
    double framesPerSecond = 0.0; ///< 0 before the second frame
    Duration medianDrawing{};     ///< from the request of the frame until its buffers were swapped
    std::size_t frames = 0;       ///< drawn since the view was created
};

/// Stores the times of the latest kKept frames.
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
