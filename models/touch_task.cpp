#include "models/touch_task.h"

#include "models/site_changes.h"

#include <QCoreApplication>

#include <algorithm>

namespace carina
{
namespace
{

class TouchWords
{
    Q_DECLARE_TR_FUNCTIONS(TouchTask)
};

} // namespace

TouchTask::TouchTask(SiteEditor& editor, StylusWatch& watch, const LandmarkTask& landmarks)
    : m_editor{editor}, m_watch{watch}, m_landmarks{landmarks}
{
}

std::optional<std::size_t> TouchTask::next() const
{
    const auto& all = m_landmarks.catalogue().landmarks;
    if (m_chosen && *m_chosen < all.size())
        return m_chosen;
    const auto open = std::ranges::find_if(all, [this](const Landmark& landmark) {
        const TouchedPoint* touch = touchOf(m_editor.site(), landmark.name);
        return !touch || touch->stale;
    });
    return open == all.end() ? std::nullopt : std::optional{std::size_t(open - all.begin())};
}

void TouchTask::choose(std::optional<std::size_t> landmark)
{
    m_chosen = landmark;
    start();
}

void TouchTask::start()
{
    const StylusTip* tip = m_editor.site().stylus(m_watch.tool());
    m_watch.watchFor(tip ? StylusUse::Touch : StylusUse::Nothing,
                     tip ? std::optional{tip->p_SQ} : std::nullopt);
    Q_EMIT m_editor.changed();
}

void TouchTask::takeNow()
{
    const StylusTip* tip = m_editor.site().stylus(m_watch.tool());
    if (!tip || !next())
        return;
    if (const auto touch = m_watch.pointNow(tip->p_SQ))
        take(*touch);
    else
        m_editor.refuse(TouchWords::tr("The stylus is out of view: turn its markers to the "
                                       "tracker and press again."));
}

void TouchTask::take(const StylusNews& news)
{
    if (news.touch && next())
        take(*news.touch);
}

void TouchTask::take(const StylusTouch& touch) { take(touch, *next()); }

void TouchTask::take(const StylusTouch& touch, std::size_t landmark)
{
    const std::string name = m_landmarks.catalogue().landmarks[landmark].name;
    Site base = m_editor.site();
    if (!base.catalogue)
        base.catalogue = m_landmarks.catalogue();
    if (!m_editor.become(withTouch(std::move(base), name, touch)))
        return;
    m_chosen.reset();
    m_editor.tell(QString::fromStdString(name));
    Q_EMIT m_editor.changed();
}

} // namespace carina
