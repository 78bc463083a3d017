#include "models/station/laryngoscope_sight.h"

#include "engine/core/expects.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <optional>

namespace carina
{
namespace
{

constexpr double kFine_mm = 5.0; ///< a distance is told finer below it

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
            return tr("▲ Nothing is seen of the laryngoscope: turn its markers to the tracker, or "
                      "see whether the tracker still delivers.");
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

    static QString of(const BladeEffort& effort, UpperTeeth upper)
    {
        return tr("%1 · %2").arg(tongue(effort), epiglottis(effort.contact)) + QLatin1Char{'\n'}
               + (upper == UpperTeeth::Firm ? teeth(effort) : looseTeeth(effort, upper));
    }

    static QString gradeOf(const std::optional<GlotticView>& read)
    {
        if (!read)
            return tr("No grade yet: wait a second, and close other views if it stays away.");
        if (read->isTelling())
            return of(*read);
        return read->underTube > GlotticView::kMostUnderTube
                   ? tr("No grade: the tube hides the glottis, so look past it.")
                   : tr("No grade: the camera sees no tissue, so draw the blade back.");
    }

    static QString ungraded(const LaryngoscopeSight& sight)
    {
        if (!sight.isOfWorker)
            return tr("Only the laryngoscope of whoever is at work is graded.");
        if (sight.jaw == JawSight::Astray)
            return tr("▲ The chin probe is where no jaw can be: fix it to the manikin's chin, and "
                      "register again if it was moved.");
        return tr("▲ The chin probe is out of view: turn its markers to the tracker.");
    }

    static QString assumed(const Blade& blade)
    {
        return tr("Blade taken as %1", "Macintosh 3").arg(shownName(blade.name));
    }

private:
    static QString shownForce(Force force)
    {
        if (force >= kMostForce)
            return tr("over %1 N (estimate)").arg(std::lround(inNewtons(kMostForce)));
        return tr("about %1 N (estimate)").arg(std::lround(inNewtons(force)));
    }

    static QString tongue(const BladeEffort& effort)
    {
        const QString force = shownForce(effort.contact.tongue);
        switch (effort.handling) {
        case BladeHandling::Neither:
            break;
        case BladeHandling::Lifting:
            return tr("Lifting · tongue %1").arg(force);
        case BladeHandling::Levering:
            return tr("Levering · tongue %1").arg(force);
        }
        return tr("Not lifting · tongue %1").arg(force);
    }

    static QString epiglottis(const BladeContact& contact)
    {
        if (contact.epiglottis > Force{})
            return tr("epiglottis %1").arg(shownForce(contact.epiglottis));
        return contact.isOnEpiglottis ? tr("epiglottis touched") : tr("epiglottis not touched");
    }

    static QString teeth(const BladeEffort& effort)
    {
        const std::optional<Length>& clearance = effort.contact.teethClearance;
        if (effort.teeth > Force{})
            return tr("▲ Teeth pressed: %1").arg(shownForce(effort.teeth));
        if (effort.isOnTeeth)
            return tr("▲ Teeth touched");
        if (!clearance)
            return tr("Teeth free");
        return tr("Teeth free (%1 mm)").arg(std::lround(inMillimetres(*clearance)));
    }

    static QString looseTeeth(const BladeEffort& effort, UpperTeeth upper)
    {
        const std::optional<Length>& clearance = effort.contact.teethClearance;
        if (effort.teeth > Force{})
            return tr("▲ Loose teeth pressed: %1").arg(shownForce(effort.teeth));
        if (effort.isOnTeeth)
            return tr("▲ Loose teeth touched");
        if (!clearance)
            return tr("Loose teeth free");
        const double clearance_mm = inMillimetres(*clearance);
        const QString shown = QString::number(clearance_mm, 'f', clearance_mm < kFine_mm ? 1 : 0);
        return upper == UpperTeeth::LooseAndNear ? tr("▲ Loose teeth near (%1 mm)").arg(shown)
                                                 : tr("Loose teeth free (%1 mm)").arg(shown);
    }

    /// "Macintosh 3" of "macintosh-3": names of makers, but for one.
    static QString shownName(std::string_view name)
    {
        if (bladeFromName(name) == BladeKind::Hyperangulated)
            return tr("hyperangulated", "blade");
        QString shown = QString::fromUtf8(name.data(), qsizetype(name.size()));
        shown.replace(QLatin1Char{'-'}, QLatin1Char{' '});
        return shown.left(1).toUpper() + shown.mid(1);
    }
};

bool isOfWorker(const PersonPose& person, const StationMoment& moment)
{
    return person.owner == moment.worker;
}

} // namespace

UpperTeeth upperTeeth(const BladeContact& contact, double looseTeeth, UpperTeeth before)
{
    if (looseTeeth <= 0.0)
        return UpperTeeth::Firm;
    const double letGo = before == UpperTeeth::LooseAndNear ? kLooseTeethLetGo.si : 0.0;
    const bool isNear = contact.teethClearance
                        && contact.teethClearance->si < looseTeeth * kNearLooseTeeth.si + letGo;
    return isNear ? UpperTeeth::LooseAndNear : UpperTeeth::Loose;
}

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

std::optional<Blade> StationLaryngoscope::knownBladeOf(const PersonPose& laryngoscope) const
{
    if (laryngoscope.isOwn && m_ownBlade)
        return m_ownBlade;
    const auto told = bladeOfTool(laryngoscope.name);
    return told ? std::optional{carina::bladeOf(*told)} : std::nullopt;
}

LaryngoscopeSight StationLaryngoscope::at(const StationMoment& moment,
                                          const FollowingThroat& throat)
{
    LaryngoscopeSight sight = sightAt(moment, throat);
    if (sight.state == LaryngoscopeState::Live)
        handle(sight, laryngoscopeOf(moment)->object);
    else
        m_handled = {};
    return sight;
}

/// What follows from the poses before. @pre it is Live, of this object
void StationLaryngoscope::handle(LaryngoscopeSight& sight, ObjectId object)
{
    if (m_handled.object != object || m_handled.form != sight.blade.form)
        m_handled = {.object = object, .form = sight.blade.form};
    sight.effort = (**m_laryngoscopy).effortAt(sight.X_AL, sight.throat, m_handled.watch);
    m_handled.teeth = upperTeeth(sight.effort.contact, sight.looseTeeth, m_handled.teeth);
    sight.teeth = m_handled.teeth;
}

LaryngoscopeSight StationLaryngoscope::sightAt(const StationMoment& moment,
                                               const FollowingThroat& throat)
{
    const PersonPose* tool = laryngoscopeOf(moment);
    if (tool == nullptr)
        return {};
    if (tool->pose.validity == Validity::Lost)
        return {.state = LaryngoscopeState::Lost};
    if (isAway(moment))
        return {.state = LaryngoscopeState::Away};
    Laryngoscopy* laryngoscopy = changedAt(moment);
    if (laryngoscopy == nullptr)
        return {.state = LaryngoscopeState::NoLarynx};
    const Blade blade = bladeOf(*tool);
    laryngoscopy->takeBlade(blade);
    // As drawn: nobody sees their own tools turned.
    const RigidTransform& X_AL = tool->isOwn ? tool->pose.X_FO : tool->X_AO;
    return {.state = laryngoscopy->isInMouth(X_AL, throat) ? LaryngoscopeState::Live
                                                           : LaryngoscopeState::Outside,
            .X_AL = X_AL,
            .throat = throat,
            .tissue = laryngoscopy->tissueAt(X_AL, throat),
            .blade = blade,
            .isBladeKnown = knownBladeOf(*tool).has_value(),
            .isOfWorker = isOfWorker(*tool, moment),
            .jaw = jawSightAt(moment, *m_patient),
            .looseTeeth = laryngoscopy->canShow(AirwayEventKind::FragileTeeth)
                              ? severityOf(moment.airwayEvents, AirwayEventKind::FragileTeeth)
                              : 0.0};
}

/// nullptr without what a laryngoscope is to show.
Laryngoscopy* StationLaryngoscope::changedAt(const StationMoment& moment)
{
    if (!m_laryngoscopy)
        m_laryngoscopy = Laryngoscopy::of(*m_patient, carina::bladeOf(kUsualBlade));
    if (!m_laryngoscopy->has_value())
        return nullptr;
    Laryngoscopy& laryngoscopy = **m_laryngoscopy;
    laryngoscopy.changeAirway(moment.airwayEvents, inspirationAt(moment));
    return &laryngoscopy;
}

/// That of the moment, but since the one before not faster than cords go: a patient stops breathing
/// at any point of a breath.
double StationLaryngoscope::inspirationAt(const StationMoment& moment)
{
    const double aim = moment.inspiration.value_or(kInspirationAsMade);
    const double most = std::abs(toSeconds(moment.time - m_cords.time)) / toSeconds(kCordsGo);
    m_cords = {moment.time,
               std::clamp(aim, m_cords.inspiration - most, m_cords.inspiration + most)};
    return m_cords.inspiration;
}

AirwayField StationLaryngoscope::changesAt(const StationMoment& moment)
{
    const PersonPose* tool = laryngoscopeOf(moment);
    const bool isSeen = tool != nullptr && tool->pose.validity != Validity::Lost && !isAway(moment);
    if (!isSeen && moment.airwayEvents.empty())
        return {};
    const Laryngoscopy* laryngoscopy = changedAt(moment);
    return laryngoscopy ? laryngoscopy->changes() : AirwayField{};
}

GlotticLine StationLaryngoscope::glottisAt(const FollowingThroat& throat,
                                           const BladeField& tissue) const
{
    CARINA_EXPECTS(m_laryngoscopy && m_laryngoscopy->has_value());
    return (**m_laryngoscopy).glottisAt(throat, tissue);
}

std::vector<ThroatContent> StationLaryngoscope::contentsIn(const StationMoment& moment,
                                                           const FollowingThroat& throat,
                                                           const BladeField& tissue) const
{
    const bool isThere = m_laryngoscopy && m_laryngoscopy->has_value();
    if (moment.airwayEvents.empty() || !isThere)
        return {};
    return (**m_laryngoscopy).contentsAt(throat, tissue);
}

QString laryngoscopeText(LaryngoscopeState state) { return LaryngoscopeWords::of(state); }

QString bladeEffortText(const BladeEffort& effort, UpperTeeth teeth)
{
    return LaryngoscopeWords::of(effort, teeth);
}

QString laryngoscopeText(const LaryngoscopeSight& sight, const std::optional<GlotticView>& read)
{
    if (sight.state != LaryngoscopeState::Live)
        return laryngoscopeText(sight.state);
    QStringList lines;
    if (sight.isGraded())
        lines << LaryngoscopeWords::gradeOf(read) << bladeEffortText(sight.effort, sight.teeth);
    else
        lines.append(LaryngoscopeWords::ungraded(sight));
    if (!sight.isBladeKnown)
        lines.append(LaryngoscopeWords::assumed(sight.blade));
    return lines.join(QLatin1Char{'\n'});
}

} // namespace carina
