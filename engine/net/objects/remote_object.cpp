#include "engine/net/objects/remote_object.h"

#include "engine/net/objects/pose_stream.h"

namespace carina
{

void RemoteObject::take(const StreamCpo& cpo, SessionTime drawn)
{
    const std::scoped_lock lock{m_mutex};
    StreamCpo next = cpo;
    if (next.validity == StreamValidity::Lost)
        next.motion.reset(); // where it was last, not where it goes
    m_ahead.take(next, drawn);
    m_newest = fromStream(next);
    m_past.push(*m_newest);
    m_hasPast = true;
    if (next.shape && next.validity != StreamValidity::Lost)
        m_shape.take(*next.shape);
    else
        m_shape.clear();
}

void RemoteObject::forgetPast(SessionTime before)
{
    const std::scoped_lock lock{m_mutex};
    if (!m_hasPast || m_newest->time >= before)
        return;
    m_past.clear();
    m_shape.clear();
    m_past.push(*m_newest);
    m_hasPast = false;
}

std::optional<PoseSample> RemoteObject::at(SessionTime t) const
{
    const std::scoped_lock lock{m_mutex};
    if (!m_newest || t <= m_newest->time)
        return m_past.at(t);
    PoseSample sample = *m_newest;
    sample.how = How::Predicted;
    sample.X_FO = m_ahead.at(t);
    if (m_ahead.isStale(t))
        sample.validity = Validity::Lost;
    if (t - m_newest->time > StreamView::kHorizon)
        sample.motion.reset();
    sample.time = t;
    return sample;
}

std::optional<ShapeBetween> RemoteObject::shapeAt(SessionTime t) const
{
    const std::scoped_lock lock{m_mutex};
    return m_shape.at(t);
}

std::optional<PoseSample> RemoteObject::newest() const
{
    const std::scoped_lock lock{m_mutex};
    return m_newest;
}

} // namespace carina
