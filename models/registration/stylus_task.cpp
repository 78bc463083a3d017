#include "models/registration/stylus_task.h"

#include "models/site/site_changes.h"

#include <QCoreApplication>

namespace carina
{
namespace
{

class StylusWords
{
    Q_DECLARE_TR_FUNCTIONS(StylusTask)
};

} // namespace

StylusTask::StylusTask(SiteEditor& editor, StylusWatch& watch) : m_editor{editor}, m_watch{watch} {}

const StylusTip* StylusTask::tip() const { return m_editor.site().stylus(m_watch.tool()); }

void StylusTask::findTip()
{
    m_watch.watchFor(StylusUse::Pivot);
    Q_EMIT m_editor.changed();
}

void StylusTask::findAxis()
{
    m_watch.watchFor(StylusUse::Spin);
    Q_EMIT m_editor.changed();
}

void StylusTask::stop()
{
    m_watch.watchFor(StylusUse::Nothing);
    Q_EMIT m_editor.changed();
}

void StylusTask::take(const StylusNews& news)
{
    if (news.tip) {
        const StylusTip tip{.p_SQ = news.tip->p_SQ,
                            .rms = news.tip->rms,
                            .calibratedAt = m_editor.now(),
                            .tool = m_watch.tool(),
                            .covariance_S = news.tip->covariance_S,
                            .poses = m_watch.pivot().poses,
                            .outliers = news.tip->outliers};
        m_watch.watchFor(StylusUse::Nothing);
        if (m_editor.become(withStylus(m_editor.site(), tip)))
            m_editor.tell(StylusWords::tr("The tip is found"));
    }
    if (news.axis)
        takeAxis(*news.axis);
}

void StylusTask::takeAxis(const Result<SpinCalibration>& axis)
{
    if (!axis)
        return m_editor.refuse(axis.error());
    if (m_editor.become(withStylusAxis(m_editor.site(), m_watch.tool(),
                                       {axis->axis_S, axis->wobble, m_editor.now()})))
        m_editor.tell(StylusWords::tr("The axis is found"));
}

} // namespace carina
