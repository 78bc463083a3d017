#include "models/console/saved_views.h"

#include "models/console/kept_console.h"

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

constexpr double kNearestEye = 1e-3; ///< metres from the target
constexpr double kLeastSine = 1e-3;  ///< between up and the line to the target

} // namespace

bool isPossible(const SavedView& view)
{
    const Vec3 back = view.p_A_eye - view.p_A_target;
    if (!view.p_A_eye.allFinite() || !view.p_A_target.allFinite() || !view.up_A.allFinite())
        return false;
    return back.norm() > kNearestEye
           && back.cross(view.up_A).norm() > kLeastSine * back.norm() * view.up_A.norm();
}

SavedViews::SavedViews(KeptConsole& kept, QObject* parent)
    : QObject{parent}, m_kept{kept}, m_views{kept.views()}
{
}

QString SavedViews::faultOf(const QString& name) const
{
    const QString given = name.trimmed();
    if (given.isEmpty())
        return tr("Give the view a name.");
    if (given.size() > kLongestName)
        return tr("A name has %1 letters at most.").arg(kLongestName);
    const bool isThere = std::ranges::find(m_views, given, &SavedView::name) != m_views.end();
    if (!isThere && m_views.size() >= kMost)
        return tr("There are %1 views, as many as there can be: delete one first.").arg(kMost);
    return {};
}

void SavedViews::save(SavedView view)
{
    view.name = view.name.trimmed();
    const auto same = std::ranges::find(m_views, view.name, &SavedView::name);
    if (same == m_views.end()) {
        m_views.push_back(std::move(view));
    } else if (*same != view) {
        if (m_history)
            m_history->add(*this, tr("View %1 → saved over").arg(view.name),
                           [this, before = *same, saved = view] { replaceBack(before, saved); });
        *same = std::move(view);
    }
    keep();
}

/// Unless another one has the name by now.
void SavedViews::replaceBack(const SavedView& view, const SavedView& saved)
{
    const auto now = std::ranges::find(m_views, view.name, &SavedView::name);
    if (now == m_views.end())
        return refuse(tr("Not undone: the view %1 has been deleted.").arg(view.name));
    if (*now != saved)
        return refuse(tr("Not undone: another view is called %1 now.").arg(view.name));
    *now = view;
    keep();
}

void SavedViews::refuse(const QString& why)
{
    if (m_history)
        m_history->refuse(why);
}

void SavedViews::remove(const QString& name)
{
    const auto found = std::ranges::find(m_views, name, &SavedView::name);
    if (found == m_views.end())
        return;
    if (m_history)
        m_history->add(*this, tr("View %1 → deleted").arg(name),
                       [this, view = *found, place = std::size_t(found - m_views.begin())] {
                           bringBack(view, place);
                       });
    m_views.erase(found);
    keep();
}

void SavedViews::bringBack(const SavedView& view, std::size_t place)
{
    const bool isThere = std::ranges::find(m_views, view.name, &SavedView::name) != m_views.end();
    QString why;
    if (isThere)
        why = tr("Not undone: another view is called %1 now.").arg(view.name);
    else if (m_views.size() >= kMost)
        why = tr("Not undone: there are %1 views, as many as there can be.").arg(kMost);
    if (!why.isEmpty())
        return refuse(why);
    m_views.insert(m_views.begin() + std::ptrdiff_t(std::min(place, m_views.size())), view);
    keep();
}

void SavedViews::keep()
{
    m_kept.keepViews(m_views);
    Q_EMIT changed();
}

} // namespace carina
