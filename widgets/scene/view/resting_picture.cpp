#include "widgets/scene/view/resting_picture.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace carina
{

/// The first frame in full detail may differ from the one before, as its surfaces do.
bool RestingPicture::comes(bool isAlike)
{
    if (!isFull()) {
        m_full = 0;
        if (isAlike)
            ++m_alike;
        else
            stir();
        return true;
    }
    if (m_full > 0 && !isAlike) {
        stir();
        return true;
    }
    if (m_full == kFullFrames)
        return false;
    ++m_full;
    return true;
}

void RestingPicture::fullTook(Duration drawing, Duration interval)
{
    constexpr Duration kLeastInterval = std::chrono::milliseconds{1};
    const double frames =
        kWait * toSeconds(drawing) / toSeconds(std::max(interval, kLeastInterval));
    m_next = int(std::clamp(std::ceil(frames), double(kFramesBefore), double(kMostFramesBefore)));
}

} // namespace carina
