#pragma once

#include "engine/sync/streams/stream_view.h"
#include "engine/tracking/pose_history.h"

#include <mutex>

namespace carina
{

/// An object O that another participant shares, as this node draws it in the anatomy frame A of its
/// station. The node's thread takes samples in, any thread asks.
///
/// Up to the newest sample it is what was measured (PoseHistory). Beyond that it is carried on for
/// 150 ms, with a velocity that then fades, and each next sample is blended to (StreamView).
class RemoteObject
{
public:
    /// The next sample, newer than the last, while session time `drawn` is being drawn.
    /// @returns how far it moves what is drawn; nothing where one of the two is lost.
    std::optional<Drift> take(const StreamCpo& cpo, SessionTime drawn);

    /// X_AO at session time t; nothing before the first sample. Lost where it was not seen, and
    /// beyond the newest sample by more than StreamView::kStaleAfter. Has no motion once the
    /// velocity fades.
    [[nodiscard]] std::optional<PoseSample> at(SessionTime t) const;
    /// The newest sample as it came.
    [[nodiscard]] std::optional<PoseSample> newest() const;

private:
    mutable std::mutex m_mutex;
    std::optional<PoseSample> m_newest;
    PoseHistory m_past;
    StreamView m_ahead;
};

} // namespace carina
