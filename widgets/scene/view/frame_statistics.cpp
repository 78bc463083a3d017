#include "widgets/scene/view/frame_statistics.h"

#include <algorithm>
#include <vector>

namespace carina
{

void FrameTimes::add(LocalTime asked, LocalTime swapped)
{
    m_latest.push_back({asked, swapped});
    if (m_latest.size() > kKept)
        m_latest.pop_front();
    ++m_frames;
}

FrameStatistics FrameTimes::statistics() const
{
    FrameStatistics result;
    result.frames = m_frames;
    if (m_latest.empty())
        return result;
    std::vector<Duration> drawing;
    for (const Times& times : m_latest)
        drawing.push_back(times.swapped - times.asked);
    std::sort(drawing.begin(), drawing.end());
    result.medianDrawing = drawing[drawing.size() / 2];
    const double elapsed = toSeconds(m_latest.back().swapped - m_latest.front().swapped);
    if (elapsed > 0.0)
        result.framesPerSecond = static_cast<double>(m_latest.size() - 1) / elapsed;
    return result;
}

} // namespace carina
