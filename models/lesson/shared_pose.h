#pragma once

#include "engine/net/node/session_node.h"

#include <memory>
#include <mutex>
#include <optional>

namespace carina
{

/// The newest pose of an object that a program has without a tracker. One thread sets it, and the
/// node's thread reads it.
class SharedPose
{
public:
    /// std::nullopt: it is nowhere now, and nothing is sent.
    void set(const std::optional<PoseSample>& pose)
    {
        const std::scoped_lock lock{m_mutex};
        m_pose = pose;
    }
    [[nodiscard]] std::optional<PoseSample> newest() const
    {
        const std::scoped_lock lock{m_mutex};
        return m_pose;
    }

private:
    mutable std::mutex m_mutex;
    std::optional<PoseSample> m_pose;
};

} // namespace carina
