#include "models/registration/touch_task.h"

#include "engine/core/expects.h"
#include "models/site/site_changes.h"
#include "models/site/site_fit.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

constexpr std::size_t kFewestToRelay = 3;
constexpr double kFarWorse = 5.0; ///< times the error of the registration

class TouchWords
{
    Q_DECLARE_TR_FUNCTIONS(TouchTask)

public:
    static QString ambiguous(const QStringList& names)
    {
        return tr("This may be one of several: %1. Choose it in the list and touch it again.")
            .arg(names.join(tr(" or ")));
    }

    static QString nowhere(const QString& nearest, const std::optional<Length>& distance)
    {
        if (!distance)
            return tr("This place matches no landmark. To use it anyway, choose its landmark in "
                      "the list and touch it again.");
        return tr("This place matches no landmark: it is %1\u00a0mm from %2. To use it anyway, "
                  "choose the landmark in the list and touch it again.")
            .arg(inMillimetres(*distance), 0, 'f', 0)
            .arg(nearest);
    }

    static QString farFromThese()
    {
        return tr("These landmarks lie nearly on one line: touch one more, far from that line.");
    }

    static QString oneMore()
    {
        return tr("Left and right cannot be told apart by these landmarks: touch one more.");
    }
};

StylusTouch touchIn(const TouchedPoint& touched)
{
    StylusTouch touch{.point = {.p_FQ = touched.p_TQ, .spread = touched.spread},
                      .q_TS = touched.q_TS};
    if (touched.seenError)
        touch.seenError = metres(*touched.seenError);
    return touch;
}

/// With which the tracker saw the tip at these touches, RMS; 0 where it is not known of any.
Length seenErrorOf(const std::vector<TouchedPoint>& touches)
{
    double squares = 0.0;
    int known = 0;
    for (const TouchedPoint& touch : touches)
        if (touch.seenError) {
            squares += *touch.seenError * *touch.seenError;
            ++known;
        }
    return metres(std::sqrt(squares / std::max(1, known)));
}

} // namespace

TouchTask::TouchTask(SiteEditor& editor, StylusWatch& watch, const LandmarkTask& landmarks)
    : m_editor{editor}, m_watch{watch}, m_landmarks{landmarks}
{
}

const std::vector<Landmark>& TouchTask::landmarks() const
{
    return m_landmarks.catalogue().landmarks;
}

const TouchedPoint* TouchTask::touchOf(const Landmark& landmark) const
{
    const auto& touched = isRelaying() ? *m_editor.site().relay : m_editor.site().touched;
    const auto found = std::ranges::find(touched, landmark.name, &TouchedPoint::landmark);
    return found == touched.end() || found->stale ? nullptr : &*found;
}

/// The manikin is registered again with the landmarks of its registration.
bool TouchTask::canBeTouched(const Landmark& landmark) const
{
    if (!isRelaying())
        return true;
    const TouchedPoint* touch = carina::touchOf(m_editor.site(), landmark.name);
    return touch && !touch->stale;
}

std::optional<std::size_t> TouchTask::next() const
{
    const auto& all = landmarks();
    if (m_chosen && *m_chosen < all.size() && canBeTouched(all[*m_chosen]))
        return m_chosen;
    const std::vector<std::size_t> order = inTurn();
    const auto open = std::ranges::find_if(order, [&](std::size_t i) { return !touchOf(all[i]); });
    return open == order.end() ? std::nullopt : std::optional{*open};
}

/// As listed; to lay a manikin anew those first that tell most.
std::vector<std::size_t> TouchTask::inTurn() const
{
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < landmarks().size(); ++i)
        if (canBeTouched(landmarks()[i]))
            order.push_back(i);
    const std::vector<std::size_t> first =
        isRelaying() ? m_landmarks.bestTriangle(order) : std::vector<std::size_t>{};
    std::ranges::stable_partition(order,
                                  [&](std::size_t i) { return std::ranges::count(first, i) > 0; });
    return order;
}

void TouchTask::choose(std::optional<std::size_t> landmark)
{
    m_chosen = landmark;
    m_watch.restart();
    Q_EMIT m_editor.changed();
}

Result<TouchFinding> TouchTask::recognise(const StylusTouch& touch) const
{
    std::vector<Vec3> places;
    std::vector<std::optional<Vec3>> touched;
    for (const Landmark& landmark : landmarks()) {
        const TouchedPoint* earlier = touchOf(landmark);
        places.push_back(landmark.p_AQ);
        touched.push_back(earlier ? std::optional{earlier->p_TQ} : std::nullopt);
    }
    return recogniseTouch({places, touched}, touch.point.p_FQ, kHandFle, next());
}

void TouchTask::take(const StylusTouch& touch)
{
    if (!next())
        return;
    if (m_chosen && next() == m_chosen)
        return take(touch, *m_chosen);
    const Result<TouchFinding> finding = recognise(touch);
    if (!finding)
        return m_editor.refuse(finding.error());
    switch (finding->verdict) {
    case TouchVerdict::Landmark:
    case TouchVerdict::Again:
        return take(touch, finding->landmark);
    case TouchVerdict::Renamed:
        return rename(touch, *finding);
    case TouchVerdict::Ambiguous:
    case TouchVerdict::Nowhere:
        return refuse(*finding);
    }
}

void TouchTask::refuse(const TouchFinding& finding)
{
    if (finding.verdict == TouchVerdict::Nowhere)
        return m_editor.refuse(TouchWords::nowhere(
            QString::fromStdString(landmarks()[finding.landmark].name), finding.distance));
    QStringList names;
    for (const std::size_t candidate : finding.candidates)
        names << QString::fromStdString(landmarks()[candidate].name);
    m_editor.refuse(TouchWords::ambiguous(names));
}

void TouchTask::take(const StylusTouch& touch, std::size_t landmark)
{
    const std::string name = landmarks()[landmark].name;
    Site base = m_editor.site();
    if (!base.catalogue)
        base.catalogue = m_landmarks.catalogue();
    const bool kept = m_editor.become(isRelaying() ? withRelayTouch(std::move(base), name, touch)
                                                   : withTouch(std::move(base), name, touch));
    if (!kept)
        return;
    m_chosen.reset();
    m_editor.tell(QString::fromStdString(name));
    if (isRelaying())
        relayIfItTells();
    Q_EMIT m_editor.changed();
}

/// All touches by the landmarks that the geometry gives them.
void TouchTask::rename(const StylusTouch& touch, const TouchFinding& finding)
{
    Site next = m_editor.site();
    auto& touched = isRelaying() ? *next.relay : next.touched;
    std::vector<StylusTouch> all{touch};
    for (const Landmark& landmark : landmarks())
        if (const TouchedPoint* earlier = touchOf(landmark))
            all.push_back(touchIn(*earlier));
    std::erase_if(touched, [](const TouchedPoint& earlier) { return !earlier.stale; });
    for (std::size_t i = 0; i < landmarks().size(); ++i) {
        if (!finding.renamed_p_TQ[i])
            continue;
        const auto own = std::ranges::find_if(all, [&](const StylusTouch& each) {
            return each.point.p_FQ == *finding.renamed_p_TQ[i];
        });
        CARINA_EXPECTS(own != all.end());
        next = isRelaying() ? withRelayTouch(std::move(next), landmarks()[i].name, *own)
                            : withTouch(std::move(next), landmarks()[i].name, *own);
    }
    if (!m_editor.become(std::move(next)))
        return;
    m_editor.tell(TouchWords::tr("The touches were assigned to other landmarks"));
    if (isRelaying())
        relayIfItTells();
}

QString TouchTask::whyNoRelay() const
{
    const Site& site = m_editor.site();
    if (!site.registration)
        return TouchWords::tr(
            "Register the manikin first. Afterwards it can be registered again when it was moved.");
    if (site.registration->stale || freshTouches(site).size() < kFewestToRelay)
        return TouchWords::tr("A moved manikin cannot be registered again now: tracker, stylus, "
                              "landmarks or touches have changed since its registration. Touch "
                              "the landmarks again and fit them.");
    return {};
}

void TouchTask::beginRelay()
{
    if (const QString why = whyNoRelay(); !why.isEmpty())
        return m_editor.refuse(why);
    Site next = m_editor.site();
    next.relay.emplace();
    next.step = SiteStep::Touch;
    m_chosen.reset();
    m_editor.become(std::move(next));
}

void TouchTask::cancelRelay()
{
    Site next = m_editor.site();
    next.relay.reset();
    m_chosen.reset();
    m_editor.become(std::move(next));
}

/// The landmarks to be touched again, and those touched since.
std::pair<EarlierRegistration, std::vector<Retouch>> TouchTask::touchedAgain() const
{
    const Site& site = m_editor.site();
    EarlierRegistration earlier{.X_AM = site.registration->X_AM, .landmarks = {}};
    if (site.registration->swab)
        earlier.covariance_A = site.registration->covariance_A;
    const RigidTransform X_MT = site.registration->X_AM.inverse() * site.registration->X_AT;
    std::vector<Retouch> again;
    for (const Landmark& landmark : landmarks()) {
        const TouchedPoint* first = carina::touchOf(site, landmark.name);
        if (!first || first->stale)
            continue;
        if (const TouchedPoint* now = touchOf(landmark))
            again.push_back({.landmark = earlier.landmarks.size(), .p_TQ = now->p_TQ});
        earlier.landmarks.push_back({landmark.name, landmark.p_AQ, X_MT * first->p_TQ});
    }
    return {std::move(earlier), std::move(again)};
}

/// Landmarks nearly on one line let the manikin turn about it.
bool TouchTask::isLoose(const ReRegistration& alike) const
{
    const Length before = m_landmarks.worstError(m_editor.site().registration->covariance_A);
    return before.si > 0.0 && m_landmarks.worstError(alike.covariance_A).si > kFarWorse * before.si;
}

void TouchTask::relayIfItTells()
{
    const Site& site = m_editor.site();
    if (site.relay->size() < kFewestToRelay)
        return;
    const auto [earlier, again] = touchedAgain();
    const Length fle = metres(std::max(site.registration->fle, millimetres(0.1).si));
    const Length now = std::max(fle, seenErrorOf(*site.relay));
    const auto relay = reRegister(earlier, again, {.first = fle, .again = now});
    if (!relay)
        return m_editor.refuse(relay.error());
    if (relay->explanations > 1)
        return m_editor.refuse(TouchWords::oneMore());
    const auto alike = reRegister(earlier, again, {.first = fle, .again = fle});
    if (again.size() < earlier.landmarks.size() && alike && isLoose(*alike))
        return m_editor.refuse(TouchWords::farFromThese());
    if (m_editor.become(withRelay(site, *relay, fitInputs(m_watch, m_editor.now()))))
        m_editor.tell(TouchWords::tr("The manikin is registered again"));
}

} // namespace carina
