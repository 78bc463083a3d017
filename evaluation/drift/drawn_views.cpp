#include "evaluation/drift/drawn_views.h"

#include "evaluation/drift/action_script.h"

#include <algorithm>
#include <random>

namespace carina
{

DrawnViews::DrawnViews(VirtualStar& star, const ViewFrames& frames, std::uint32_t seed)
    : m_star{star}, m_views(star.participants() - 1U)
{
    if (frames.rate <= 0.0)
        return;
    std::mt19937 random{seed};
    const auto share = [&] { return static_cast<double>(random()) / 4294967296.0; };
    for (View& view : m_views) {
        const double rate = frames.rate * (1.0 + frames.rateError * (2.0 * share() - 1.0));
        view.frame = fromSeconds(1.0 / rate);
        view.next = fromSeconds(-share() / rate);
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
