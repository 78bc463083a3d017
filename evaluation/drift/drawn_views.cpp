#include "evaluation/drift/drawn_views.h"

#include "evaluation/drift/action_script.h"

#include <algorithm>

namespace carina
{

DrawnViews::DrawnViews(VirtualStar& star, const ViewFrames& frames, std::uint32_t seed)
    : m_star{star}, m_views(star.participants() - 1U)
{
    const std::vector<DisplayFrames> displays = displaysOf(frames, m_views.size(), seed);
    for (std::size_t view = 0; view < m_views.size(); ++view) {
        m_views[view].frame = displays[view].interval;
        m_views[view].next = displays[view].first;
    }
}

void DrawnViews::runTo(Duration t)
{
    while (true) {
        const auto first = std::ranges::min_element(m_views, {}, &View::next);
        if (first->frame == Duration{} || first->next > t)
            break;
        m_star.runTo(first->next);
        draw(static_cast<std::size_t>(first - m_views.begin()), first->next);
        first->next += first->frame;
    }
    m_star.runTo(t);
    for (std::size_t view = 0; view < m_views.size(); ++view)
        if (m_views[view].frame == Duration{})
            draw(view, t);
}

void DrawnViews::draw(std::size_t view, Duration t)
{
    const auto id = static_cast<std::uint16_t>(view + 2);
    const auto poseOf = [&](ObjectId object) {
        const auto shown = m_star.shown(id, object, t);
        return shown ? shown->acted.X_AO : RigidTransform{};
    };
    m_views[view].turned = poseOf(ActionScript::kTurned);
    m_views[view].moved = poseOf(ActionScript::kMoved);
}

} // namespace carina
