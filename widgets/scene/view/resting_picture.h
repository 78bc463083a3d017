#pragma once

#include "engine/core/session_time.h"

namespace carina
{

/// Tells when a picture rests: once some frames were drawn alike it is drawn in full detail,
/// kFullFrames times, and then held as it is until something changes.
///
/// These frames are kFramesBefore, and at least kWait times as long as one in full detail took
/// last: what changes now and then must not wait for frames in full detail most of the time.
class RestingPicture
{
public:
    static constexpr int kFramesBefore = 20;
    static constexpr int kMostFramesBefore = 600;
    static constexpr double kWait = 40.0;
    static constexpr int kFullFrames = 2; ///< the first one may have a shader that is not ready

    /// Something else than a frame's state changed.
    void stir()
    {
        m_alike = 0;
        m_before = m_next;
    }

    /// Whether the next frame is one in full detail.
    [[nodiscard]] bool isFull() const { return m_alike >= m_before; }

    /// The state of the next frame has come.
    /// @param isAlike it is drawn like the one before
    /// @returns whether it has to be drawn: the picture is not held
    [[nodiscard]] bool comes(bool isAlike);

    /// A frame in full detail took so long to draw.
    /// @param interval at least, from one frame to the next
    void fullTook(Duration drawing, Duration interval);

private:
    int m_before = kFramesBefore; ///< frames drawn alike before it rests
    int m_next = kFramesBefore;   ///< the same, next time
    int m_alike = 0;              ///< frames that were drawn alike
    int m_full = 0;               ///< of these in full detail
};

} // namespace carina
