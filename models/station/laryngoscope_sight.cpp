#include "models/station/laryngoscope_sight.h"

#include "engine/core/expects.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

class LaryngoscopeWords
{
    Q_DECLARE_TR_FUNCTIONS(Laryngoscope)

public:
    static QString of(LaryngoscopeState state)
    {
        switch (state) {
        case LaryngoscopeState::None:
            return tr("No laryngoscope is tracked at this station: connect a tracker that has a "
                      "tool for the use Laryngoscope.");
        case LaryngoscopeState::Lost:
            return tr("▲ The laryngoscope is out of view: turn its markers to the tracker.");
        case LaryngoscopeState::Away:
            return tr("▲ The patient is not in its original place: put it back, so that the "
                      "laryngoscope is in its mouth.");
        case LaryngoscopeState::NoLarynx:
            return tr("This patient has no epiglottis, vocal cords or soft palate to be seen: "
                      "choose a patient with a whole larynx.");
        case LaryngoscopeState::Outside:
            return tr("Bring the blade into the mouth.");
        case LaryngoscopeState::Live:
            break;
        }
        return {};
    }

    static QString of(const GlotticView& view)
    {
        return tr("Grade %1 · %2 % of the glottis")
            .arg(QLatin1StringView{gradeName(view.grade)})
            .arg(std::lround(100.0 * view.opening));
    }
};

/// While nobody is at work, whoever looks is.
bool isOfWorker(const PersonPose& person, const StationMoment& moment)
{
    return person.owner == moment.worker || (moment.worker == kNobody && person.isOwn);
}

} // namespace

const PersonPose* laryngoscopeOf(const StationMoment& moment)
{
    const auto rankOf = [&moment](const PersonPose& person) {
        return 2 * int(isOfWorker(person, moment)) + int(person.pose.validity != Validity::Lost);
    };
    const PersonPose* best = nullptr;
    for (const PersonPose& person : moment.people) {
        if (person.kind != ObjectKind::Laryngoscope)
            continue;
        if (best == nullptr || rankOf(person) > rankOf(*best))
            best = &person;
    }
    return best;
}

Blade StationLaryngoscope::bladeOf(const PersonPose& laryngoscope) const
{
    if (laryngoscope.isOwn && m_ownBlade)
        return *m_ownBlade;
    return carina::bladeOf(bladeOfTool(laryngoscope.name).value_or(kUsualBlade));
}

LaryngoscopeSight StationLaryngoscope::at(const StationMoment& moment,
                                          const FollowingThroat& throat)
{
    const PersonPose* tool = laryngoscopeOf(moment);
    if (tool == nullptr)
        return {};
    if (tool->pose.validity == Validity::Lost)
        return {.state = LaryngoscopeState::Lost};
    if (isAway(moment))
        return {.state = LaryngoscopeState::Away};
    const Blade blade = bladeOf(*tool);
    if (!m_laryngoscopy)
        m_laryngoscopy = Laryngoscopy::of(*m_patient, blade);
    if (!m_laryngoscopy->has_value())
        return {.state = LaryngoscopeState::NoLarynx};
    Laryngoscopy& laryngoscopy = **m_laryngoscopy;
    laryngoscopy.takeBlade(blade);
    // As drawn: nobody sees their own tools turned.
    const RigidTransform& X_AL = tool->isOwn ? tool->pose.X_FO : tool->X_AO;
    return {.state = laryngoscopy.isInMouth(X_AL, throat) ? LaryngoscopeState::Live
                                                          : LaryngoscopeState::Outside,
            .X_AL = X_AL,
            .throat = throat,
            .tissue = laryngoscopy.tissueAt(X_AL, throat),
            .blade = blade};
}

GlotticLine StationLaryngoscope::glottisAt(const FollowingThroat& throat,
                                           const BladeField& tissue) const
{
    CARINA_EXPECTS(m_laryngoscopy && m_laryngoscopy->has_value());
    return (**m_laryngoscopy).glottisAt(throat, tissue);
}

QString laryngoscopeText(LaryngoscopeState state) { return LaryngoscopeWords::of(state); }

QString glotticViewText(const GlotticView& view) { return LaryngoscopeWords::of(view); }

} // namespace carina
