#include "models/registration/manikin_task.h"

#include "engine/anatomy/airway/airway_measure.h"
#include "engine/anatomy/patient/patient_name.h"
#include "engine/io/site/manikin_json.h"
#include "models/site/site_changes.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

/// A difference in tube depth that is worth another patient: markings on a tube are 10 mm apart.
constexpr Length kWorthAPatient = millimetres(5.0);
constexpr Length kSameDepth = millimetres(0.5); // less is not shown

class ManikinWords
{
    Q_DECLARE_TR_FUNCTIONS(ManikinTask)
};

QString shown(const std::string& words) { return QString::fromStdString(words); }

QString wholeMillimetres(Length length)
{
    return QString::number(std::lround(inMillimetres(length)));
}

/// The topmost point of the epiglottis.
std::optional<Vec3> epiglottisTip(const PatientModel& patient)
{
    std::optional<Vec3> tip;
    for (const PatientSurface& surface : patient.surfaces()) {
        if (surface.description.role != PartRole::Epiglottis)
            continue;
        for (const auto& p_A : surface.levels.front()->positions)
            if (!tip || double(p_A.z()) > tip->z())
                tip = p_A.cast<double>();
    }
    return tip;
}

} // namespace

QString airwayPlaceName(AirwayPlace place)
{
    switch (place) {
    case AirwayPlace::Incisors:
        return ManikinWords::tr("Edge of the upper incisors");
    case AirwayPlace::Epiglottis:
        return ManikinWords::tr("Tip of the epiglottis");
    case AirwayPlace::Glottis:
        return ManikinWords::tr("Between the vocal cords");
    case AirwayPlace::Carina:
        return ManikinWords::tr("Carina");
    }
    return {};
}

ManikinTask::ManikinTask(SiteEditor& editor, const PatientModel& patient,
                         const LandmarkTask& landmarks)
    : m_editor{editor}, m_patient{patient}, m_landmarks{landmarks}
{
}

std::vector<ManikinProfile> ManikinTask::offered() const
{
    const auto builtin = builtinManikins();
    std::vector<ManikinProfile> offered{builtin.begin(), builtin.end()};
    const auto& own = m_editor.site().manikin.profile;
    if (own && std::ranges::find(offered, *own) == offered.end())
        offered.push_back(*own);
    return offered;
}

std::optional<std::size_t> ManikinTask::chosen() const
{
    const auto& own = m_editor.site().manikin.profile;
    if (!own)
        return std::nullopt;
    const auto all = offered();
    return std::size_t(std::ranges::find(all, *own) - all.begin());
}

void ManikinTask::choose(std::optional<std::size_t> profile)
{
    if (profile == chosen())
        return;
    if (profile)
        return adopt(offered().at(*profile));
    Site next = m_editor.site();
    next.manikin.profile.reset();
    m_editor.become(std::move(next));
}

void ManikinTask::adopt(ManikinProfile profile)
{
    Site next = m_editor.site();
    if (const auto catalogue = landmarksOf(profile); catalogue && next.touched.empty())
        next = withLandmarks(std::move(next), *catalogue);
    next.manikin.profile = std::move(profile);
    m_editor.become(std::move(next));
}

/// The patient's landmarks of those names, in their order.
std::optional<LandmarkCatalogue> ManikinTask::landmarksOf(const ManikinProfile& profile) const
{
    const LandmarkCatalogue& all = m_landmarks.offered().front();
    LandmarkCatalogue catalogue{profile.name, all.anatomy, {}};
    for (const std::string& name : profile.landmarks) {
        const auto found = std::ranges::find(all.landmarks, name, &Landmark::name);
        if (found == all.landmarks.end())
            return std::nullopt;
        catalogue.landmarks.push_back(*found);
    }
    for (const LandmarkCatalogue& set : m_landmarks.offered())
        if (set.landmarks == catalogue.landmarks)
            return set;
    return checkCatalogue(catalogue) ? std::optional{catalogue} : std::nullopt;
}

void ManikinTask::importFrom(const std::filesystem::path& file)
{
    auto profile = readManikinFile(file);
    if (!profile)
        return m_editor.refuse(profile.error());
    if (!profile->patient.empty())
        if (const auto known = patientFromWords(profile->patient); !known)
            return m_editor.refuse(known.error());
    adopt(*std::move(profile));
}

void ManikinTask::setMeasured(std::optional<Length> teethToCarina)
{
    if (teethToCarina == measured())
        return;
    Site next = m_editor.site();
    next.manikin.measuredTeethToCarina = teethToCarina;
    m_editor.become(std::move(next));
}

std::optional<Length> ManikinTask::measured() const
{
    return m_editor.site().manikin.measuredTeethToCarina;
}

QString ManikinTask::whyNoTouch() const
{
    const auto& registration = m_editor.site().registration;
    if (!registration)
        return ManikinWords::tr("Fit the patient first; then the manikin's airway can be touched.");
    if (registration->stale || m_editor.site().relay)
        return ManikinWords::tr(
            "Fit the patient again first; then the manikin's airway can be touched.");
    return {};
}

void ManikinTask::beginTouch()
{
    if (const QString why = whyNoTouch(); !why.isEmpty())
        return m_editor.refuse(why);
    m_next = kAirwayPlaces.front();
    Q_EMIT m_editor.changed();
}

void ManikinTask::endTouch()
{
    if (!std::exchange(m_next, std::nullopt))
        return;
    Q_EMIT m_editor.changed();
}

std::optional<AirwayPlace> ManikinTask::next() const
{
    return m_editor.site().step == SiteStep::Overview ? m_next : std::nullopt;
}

void ManikinTask::advance()
{
    const auto after = std::size_t(*m_next) + 1;
    m_next = after < kAirwayPlaces.size() ? std::optional{kAirwayPlaces[after]} : std::nullopt;
}

void ManikinTask::skip()
{
    if (!m_next)
        return;
    advance();
    Q_EMIT m_editor.changed();
}

void ManikinTask::take(const StylusTouch& touch)
{
    Site next = m_editor.site();
    if (!next.registration || !m_next)
        return;
    const RigidTransform X_MT = next.registration->X_AM.inverse() * next.registration->X_AT;
    if (isStale())
        next.manikin.airway.clear();
    const AirwayPlace place = *m_next;
    std::erase_if(next.manikin.airway,
                  [&](const TouchedAirwayPlace& before) { return before.place == place; });
    next.manikin.airway.push_back({place, X_MT * touch.point.p_FQ});
    next.manikin.registeredAt = next.registration->madeAt;
    advance();
    if (m_editor.become(std::move(next)))
        m_editor.tell(airwayPlaceName(place));
    else
        m_next = place;
}

std::optional<Vec3> ManikinTask::placeInPatient(AirwayPlace place) const
{
    switch (place) {
    case AirwayPlace::Incisors:
        return m_patient.landmarks().p_A_incisors;
    case AirwayPlace::Epiglottis:
        return epiglottisTip(m_patient);
    case AirwayPlace::Glottis:
        return m_patient.landmarks().p_A_glottis;
    case AirwayPlace::Carina:
        return m_patient.landmarks().p_A_carina;
    }
    return std::nullopt;
}

bool ManikinTask::isStale() const
{
    const Site& site = m_editor.site();
    return !site.manikin.airway.empty()
           && (!site.registration || site.registration->madeAt != site.manikin.registeredAt);
}

std::optional<Vec3> ManikinTask::placeInManikin(AirwayPlace place) const
{
    const auto& airway = m_editor.site().manikin.airway;
    const auto found = std::ranges::find(airway, place, &TouchedAirwayPlace::place);
    if (found == airway.end() || isStale())
        return std::nullopt;
    return m_editor.site().registration->X_AM * found->p_MQ;
}

/// What was measured here counts most, then what was touched, then what is published.
std::optional<SourcedLength> ManikinTask::manikinLength() const
{
    if (const auto length = measured())
        return SourcedLength{*length, ManikinWords::tr("measured with a tube").toStdString()};
    const auto incisors = placeInManikin(AirwayPlace::Incisors);
    const auto glottis = placeInManikin(AirwayPlace::Glottis);
    const auto carina = placeInManikin(AirwayPlace::Carina);
    if (incisors && glottis && carina)
        if (const auto length = teethToCarina(*incisors, *glottis, *carina))
            return SourcedLength{*length,
                                 ManikinWords::tr("from the places touched").toStdString()};
    const auto& profile = m_editor.site().manikin.profile;
    return profile ? profile->teethToCarina : std::nullopt;
}

QString ManikinTask::lengths() const
{
    const auto manikin = manikinLength();
    const Length patient = teethToCarina(m_patient.landmarks());
    if (!manikin)
        return {};
    const QString lengths = ManikinWords::tr("Teeth to carina: manikin %1 mm (%2), patient %3 mm.")
                                .arg(wholeMillimetres(manikin->length), shown(manikin->source),
                                     wholeMillimetres(patient));
    const Length apart = metres(std::abs(patient.si - manikin->length.si));
    if (apart < kSameDepth)
        return lengths + u' ' + ManikinWords::tr("Tube depths agree.");
    const QString depth =
        patient < manikin->length
            ? ManikinWords::tr("A tube at the patient's carina ends %1 mm above the manikin's.")
            : ManikinWords::tr("A tube at the manikin's carina ends %1 mm above the patient's.");
    return lengths + u' ' + depth.arg(wholeMillimetres(apart));
}

/// Where only both ends were touched.
QString ManikinTask::straightLengths() const
{
    const auto incisors = placeInManikin(AirwayPlace::Incisors);
    const auto carina = placeInManikin(AirwayPlace::Carina);
    if (!incisors || !carina)
        return {};
    const AirwayLandmarks& airway = m_patient.landmarks();
    const Length manikin = metres((*incisors - *carina).norm());
    const Length patient = metres((airway.p_A_incisors - airway.p_A_carina).norm());
    return ManikinWords::tr("Teeth to carina in a straight line: manikin %1 mm, patient %2 mm.")
        .arg(wholeMillimetres(manikin), wholeMillimetres(patient));
}

/// The touched place that lies farthest from the patient's airway.
QString ManikinTask::farthest() const
{
    std::optional<std::pair<Length, AirwayPlace>> worst;
    for (const AirwayPlace place : kAirwayPlaces)
        if (const auto p_A = placeInManikin(place)) {
            const Length distance = distanceFrom(pathFromTeeth(m_patient.landmarks()), *p_A);
            if (!worst || distance > worst->first)
                worst = {distance, place};
        }
    if (!worst)
        return {};
    return ManikinWords::tr("Largest distance of a place touched in the manikin's airway from the "
                            "centreline of the patient's: %1, %2 mm.")
        .arg(airwayPlaceName(worst->second), wholeMillimetres(worst->first));
}

/// The patient that agrees with the manikin in tube depth.
QString ManikinTask::advice() const
{
    const auto manikin = manikinLength();
    const Length patient = teethToCarina(m_patient.landmarks());
    auto figures = parametersOfHash(m_patient.contentHash());
    if (!manikin || !figures || metres(std::abs(patient.si - manikin->length.si)) < kWorthAPatient)
        return {};
    const auto range = teethToCarinaRange(*figures);
    if (!range || manikin->length < range->least || manikin->length > range->most)
        return ManikinWords::tr("No patient of this age, height and sex has such an airway: choose "
                                "another height or age.");
    figures->teethToCarina = metres(std::round(1000.0 * manikin->length.si) / 1000.0);
    return ManikinWords::tr("A patient with an airway of that length: \"%1\".")
        .arg(shown(nameOf(*figures)));
}

/// Where the profile names a child and the patient is none, or the other way round.
QString ManikinTask::otherPatient() const
{
    constexpr double kGrownUp = 16.0; // years
    const auto& profile = m_editor.site().manikin.profile;
    const auto shownOne = parametersOfHash(m_patient.contentHash());
    const auto wanted = patientFromWords(profile ? profile->patient : std::string{});
    if (!shownOne || !wanted
        || (shownOne->ageInYears < kGrownUp) == (wanted->ageInYears < kGrownUp))
        return {};
    return ManikinWords::tr("This manikin has the size of another patient: \"%1\" (%2).")
        .arg(shown(profile->patient), shown(profile->patientSource));
}

QStringList ManikinTask::comparison() const
{
    QStringList sentences;
    const QString length = lengths();
    sentences << (length.isEmpty() ? straightLengths() : length) << advice() << farthest();
    if (isStale())
        sentences << ManikinWords::tr("The airway was touched before the present fit: touch it "
                                      "again.");
    sentences.removeAll(QString{});
    if (sentences.isEmpty())
        sentences << ManikinWords::tr("The length from teeth to carina of the manikin is not "
                                      "known: measure it with a tube, or touch its airway.");
    if (const QString other = otherPatient(); !other.isEmpty())
        sentences.prepend(other);
    return sentences;
}

} // namespace carina
