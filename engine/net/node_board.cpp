#include "engine/net/node_board.h"

#include <algorithm>

namespace carina
{
namespace
{

bool sameLinks(const std::vector<NodeBoard::Link>& a, const std::vector<NodeBoard::Link>& b)
{
    return std::ranges::equal(a, b, [](const NodeBoard::Link& x, const NodeBoard::Link& y) {
        return x.report.peer == y.report.peer && x.report.state == y.report.state;
    });
}

} // namespace

void NodeBoard::showActions(View& view, const SharedActions& actions) const
{
    view.actions = this->actions();
    if (view.actions->revision() != actions.revision())
        view.actions = std::make_shared<SharedActions>(actions);
}

bool NodeBoard::show(View view)
{
    const std::scoped_lock lock{m_mutex};
    const bool changed = view.self != m_view.self || view.state != m_view.state
                         || view.pending != m_view.pending || view.refusal != m_view.refusal
                         || view.clock.has_value() != m_view.clock.has_value()
                         || !sameLinks(view.links, m_view.links);
    m_view = std::move(view);
    return changed;
}

void NodeBoard::onChange(std::function<void()> callback)
{
    const std::scoped_lock lock{m_mutex};
    m_callback = std::move(callback);
}

void NodeBoard::announce() const
{
    std::function<void()> callback;
    {
        const std::scoped_lock lock{m_mutex};
        callback = m_callback;
    }
    if (callback)
        callback();
}

} // namespace carina
