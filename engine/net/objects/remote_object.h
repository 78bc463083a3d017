#pragma once

#include "engine/sync/streams/shape_view.h"
#include "engine/sync/streams/stream_view.h"
#include "engine/tracking/pose_history.h"

#include <mutex>

namespace carina
{

/// An object O that another participant shares, as this node draws it in the anatomy frame A of its
/// station. The node's thread adds samples, any thread reads.
///
/// Up to the newest sample the pose is that of the measured samples (PoseHistory). Beyond it the
/// pose is extrapolated for 150 ms, with a velocity that then fades, and blended to each next
/// sample (StreamView).
class RemoteObject
{
public:
    /// Samples kept, of 60 in a second: 4 s. Who draws or compares looks back by 2 s at most
    /// (ShownViews::kHolds), and there may be many objects.
    static constexpr std::size_t kKept = 256;

    /// Adds the next sample, newer than the last; `drawn` is the session time being drawn.
    void take(const StreamCpo& cpo, SessionTime drawn);
    /// Gives up all samples but the newest, where that is from before this time.
    void forgetPast(SessionTime before);

    /// X_AO at session time t; nothing before the first sample. Lost where it was not tracked, and
    /// more than StreamView::kStaleAfter after the newest sample. Without velocity once the
    /// velocity fades.
    [[nodiscard]] std::optional<PoseSample> at(SessionTime t) const;
    /// How it bends then, as its owner has it; nothing where it does not, or that is not known.
    [[nodiscard]] std::optional<ShapeBetween> shapeAt(SessionTime t) const;
    /// The newest sample as received.
    [[nodiscard]] std::optional<PoseSample> newest() const;

private:
    mutable std::mutex m_mutex;
    std::optional<PoseSample> m_newest;
    bool m_hasPast = false; // besides m_newest
    PoseHistory m_past{PoseHistory::Limits{.capacity = kKept}};
    StreamView m_ahead;
    ShapeView m_shape;
};

} // namespace carina
